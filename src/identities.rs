//! The identities that tie the quantities of the REL equations together, measured on random states.
//!
//! Each is a relation between quantities that are computed by different formulas, so a residual at rounding level says
//! that all of them are right. Derivatives along q̇ are exact (dual numbers), not differences.

use frs_core::derivatives::Dual;
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Curvature, Model, Workspace};
use nalgebra::{DMatrix, DVector, Matrix6, Matrix6xX, Vector6};

/// An identity and how far it was off.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// The identity, as an equation.
    pub identity: &'static str,
    /// Largest difference of the two sides over all states, relative to the size of their terms.
    pub worst: f64,
}

/// Residual above which an identity is broken: rounding of some hundred operations at condition numbers up to 1e5, which
/// the robots at hand reach. A wrong sign gives 0.1 or more.
pub const ROUNDING: f64 = 1e-10;

/// Checks every identity on `states` random states; the same `seed` gives the same states.
///
/// Angles lie in ±π, translations and all rates in ±1 (SI units).
///
/// ```
/// let model = frs::Model::from_urdf(frs::urdf::LWR_SATELLITE)?;
/// for residual in frs::identities::check(&model, 10, 1) {
///     assert!(residual.worst < frs::identities::ROUNDING, "{residual:?}");
/// }
/// # Ok::<(), frs::urdf::UrdfError>(())
/// ```
pub fn check(model: &Model, states: usize, seed: u64) -> Vec<Residual> {
    let mut rng = fastrand::Rng::with_seed(seed);
    let dual_model = model.cast::<Dual>();
    let mut work = Workspace::new(model);
    let mut dual_work = Workspace::new(&dual_model);
    let mut worst = Worst::default();
    for _ in 0..states {
        let state = State::random(model, &mut rng);
        check_state(&mut work, &mut dual_work, &state, &mut worst);
    }
    worst.0
}

struct State {
    q: Vec<f64>,
    qd: Vec<f64>,
    other: Vec<f64>,
    mu: Twist<f64>,
    nu: Twist<f64>,
    wrench: Wrench<f64>,
    tau: Vec<f64>,
    pose: Pose<f64>,
}

impl State {
    fn random(model: &Model, rng: &mut fastrand::Rng) -> Self {
        let unit = |rng: &mut fastrand::Rng| 2.0 * rng.f64() - 1.0;
        let six = |rng: &mut fastrand::Rng| std::array::from_fn(|_| unit(rng));
        let vector = |rng: &mut fastrand::Rng| (0..model.dof()).map(|_| unit(rng)).collect::<Vec<_>>();
        let angle = |rng: &mut fastrand::Rng| std::f64::consts::PI * unit(rng);
        Self {
            q: vector(rng).into_iter().map(|x| std::f64::consts::PI * x).collect(),
            qd: vector(rng),
            other: vector(rng),
            mu: Twist::from_array(six(rng)),
            nu: Twist::from_array(six(rng)),
            wrench: Wrench::from_array(six(rng)),
            tau: vector(rng),
            pose: Pose::from_rpy(Twist::from_array(six(rng)).linear, std::array::from_fn(|_| angle(rng))),
        }
    }
}

/// The worst residual of each identity, in the order of first appearance.
#[derive(Default)]
struct Worst(Vec<Residual>);

impl Worst {
    /// Records `difference` relative to `scale`.
    fn see(&mut self, identity: &'static str, difference: f64, scale: f64) {
        let worst = if scale > 0.0 { difference / scale } else { difference }.abs();
        match self.0.iter_mut().find(|residual| residual.identity == identity) {
            // NaN must win: it is the worst of all, and `total_cmp` places it last.
            Some(residual) => residual.worst = std::cmp::max_by(residual.worst, worst, f64::total_cmp),
            None => self.0.push(Residual { identity, worst }),
        }
    }

    /// Records how far two matrices are apart, relative to the larger one.
    fn equal(&mut self, identity: &'static str, left: &DMatrix<f64>, right: &DMatrix<f64>) {
        self.balance(identity, left, right, 0.0);
    }

    /// The same where the two sides may vanish as sums of terms of size `terms`.
    fn balance(&mut self, identity: &'static str, left: &DMatrix<f64>, right: &DMatrix<f64>, terms: f64) {
        self.see(identity, (left - right).amax(), left.amax().max(right.amax()).max(terms));
    }
}

fn check_state(work: &mut Workspace, dual_work: &mut Workspace<Dual>, state: &State, worst: &mut Worst) {
    let n = state.q.len();
    let (mu, qd) = (state.mu, &state.qd[..]);
    let square = |size| DMatrix::<f64>::zeros(size, size);
    let (mut connection, mut coupling) = (Matrix6xX::zeros(n), Matrix6xX::zeros(n));
    let (mut s_mu, mut s_nu) = (Matrix6xX::zeros(n), Matrix6xX::zeros(n));
    let (mut lambda_q, mut gamma, mut b2) = (square(n), square(n), square(n));
    let (mut d_mu, mut d_qdot) = (square(6 + n), square(6 + n));
    let (mut hamel_m, mut hamel_c) = (square(6 + n), square(6 + n));
    let mut curvature = Curvature::new(n);

    let mut shape = work.shape(&state.q);
    let lambda_b = shape.locked_inertia().to_matrix();
    shape.connection(&mut connection);
    shape.base_joint_inertia(&mut coupling);
    shape.shape_inertia(&mut lambda_q);
    shape.inertia_derivative(mu, &mut s_mu);
    shape.inertia_derivative(state.nu, &mut s_nu);
    shape.b2(mu, &mut b2);
    shape.d_mu(mu, &mut d_mu);
    shape.curvature(&mut curvature);
    shape.hamel_inertia(&mut hamel_m);
    let (c_b, p) = (shape.locked_coriolis(mu), shape.inertia_velocity(qd));
    let momentum = shape.body_momentum(mu);
    let curvature_on = shape.curvature_on(qd, &state.other);
    let mut coupling_torque = vec![0.0; n];
    shape.coupling_torque(mu, &mut coupling_torque);

    let (rates, others) = (DVector::from_row_slice(qd), DVector::from_row_slice(&state.other));
    let mut gamma_other = square(n);
    shape.moving(&state.other).gamma_q(&mut gamma_other);

    let mut motion = shape.moving(qd);
    motion.gamma_q(&mut gamma);
    motion.d_qdot(&mut d_qdot);
    let base_twist = motion.base_twist(mu);
    motion.hamel_coriolis(base_twist, &mut hamel_c);
    let energy = motion.kinetic_energy(mu);
    let mut vectors = [(); 5].map(|()| DVector::zeros(6 + n));
    let [d_mu_xi, d_qdot_xi, bias, xi_dot, xi_dot_sweep] = &mut vectors;
    motion.d_mu_xi(mu, d_mu_xi.as_mut_slice());
    motion.d_qdot_xi(mu, d_qdot_xi.as_mut_slice());
    motion.hamel_bias(base_twist, bias.as_mut_slice());
    motion.forward_dynamics(mu, state.wrench, &state.tau, xi_dot.as_mut_slice());
    motion.forward_dynamics_articulated(mu, state.wrench, &state.tau, xi_dot_sweep.as_mut_slice());
    let mut tau = DVector::zeros(n);
    let wrench = motion.inverse_dynamics(mu, xi_dot.as_slice(), tau.as_mut_slice());

    // Exact rates along q̇ and, for the curvature, along a second direction.
    let along = |work: &mut Workspace<Dual>, direction: &[f64]| Rates::along(work, &state.q, direction);
    let rate = along(dual_work, qd);
    let rate_other = along(dual_work, &state.other);

    let dense = |m: &Matrix6xX<f64>| m.clone().resize_vertically(6, 0.0);
    let six = |m: &Matrix6<f64>| m.resize(6, 6, 0.0);
    let column = |v: Vector6<f64>| DMatrix::from_column_slice(6, 1, v.as_slice());
    let (a, lambda_b) = (dense(&connection), six(&lambda_b));
    let xi = stacked(mu.to_vector(), &rates);
    let velocity = stacked(base_twist.to_vector(), &rates);

    worst.equal("M_bq = Λ_b A_l", &dense(&coupling), &(&lambda_b * &a));
    let joint_block = hamel_m.view_range(6.., 6..).into_owned();
    worst.equal("Λ_q = M_q − A_lᵀ Λ_b A_l", &lambda_q, &(joint_block - a.transpose() * &lambda_b * &a));
    let definite = lambda_b.clone().cholesky().is_some() && (n == 0 || lambda_q.clone().cholesky().is_some());
    worst.see("Λ_b and Λ_q are positive definite", if definite { 0.0 } else { f64::NAN }, 1.0);
    let definition = coriolis_by_definition(&lambda_b, mu);
    worst.equal("C_b = ½(Λ_b ad_μ − ad_μᵀ Λ_b − ad~_{Λ_b μ})", &six(&c_b), &definition);
    worst.see("D_μ is skew", (&d_mu + d_mu.transpose()).amax(), d_mu.amax());
    worst.equal("dΛ_b/dt = P(q̇)", &six(&rate.locked_inertia), &six(&p));
    worst.equal("dΛ_q/dt = Γ'_q + Γ'_qᵀ", &rate.shape_inertia, &(&gamma + gamma.transpose()));
    worst.equal("Γ'_q(x) y = Γ'_q(y) x", &into_matrix(&gamma * &others), &into_matrix(&gamma_other * &rates));
    let (s_mu, s_nu) = (dense(&s_mu), dense(&s_nu));
    let (x, y) = (column(mu.to_vector()), column(state.nu.to_vector()));
    worst.equal("S(x)ᵀ y = S(y)ᵀ x", &(s_mu.transpose() * &y), &(s_nu.transpose() * &x));
    worst.equal("½ P(q̇) x = S(x) q̇", &(six(&p) * &x * 0.5), &into_matrix(&s_mu * &rates));
    let pairing = DMatrix::from_fn(n, n, |i, j| -0.5 * curvature.get(i, j).dot(momentum));
    worst.balance("B_2(μ)_ij = −½ ⟨Λ_b μ, 𝓑(e_i, e_j)⟩", &b2, &pairing, d_mu.amax());
    let [turn_x, turn_y] = [&rates, &others].map(|x| (&connection * x).fixed_rows::<6>(0).into_owned());
    let [turn_x, turn_y] = [turn_x, turn_y].map(|x| Twist::from_array(x.into()));
    let (across, back) = (&rate.connection * &others, &rate_other.connection * &rates);
    // A curvature is what is left of these terms, in the plane or with one joint perhaps nothing.
    let terms = across.amax() + back.amax() + turn_x.to_vector().amax() * turn_y.to_vector().amax();
    let direct = column(curvature_on.to_vector());
    let contracted = column(contract(&curvature, &rates, &others).to_vector());
    worst.balance("𝓑(x, y) = Σ x_i y_j 𝓑(e_i, e_j)", &direct, &contracted, terms);
    let definition = column(across - back - turn_x.ad(turn_y).to_vector());
    worst.balance("𝓑(x, y) = ∂_x A y − ∂_y A x − ad_{A x} A y", &direct, &definition, terms);
    let torque = s_mu.transpose() * &x - a.transpose() * column(mu.ad_transpose(momentum).to_vector());
    let coupling_torque = DMatrix::from_column_slice(n, 1, &coupling_torque);
    worst.balance("coupling torque = S(μ)ᵀ μ − A_lᵀ ad~_{Λ_b μ} μ", &coupling_torque, &torque, d_mu.amax());
    worst.equal("D_μ ξ without the matrix", &into_matrix(d_mu_xi.clone()), &into_matrix(&d_mu * &xi));
    worst.equal("D_q̇ ξ without the matrix", &into_matrix(d_qdot_xi.clone()), &into_matrix(&d_qdot * &xi));
    worst.equal("dM/dt = C + Cᵀ", &rate.hamel_inertia, &(&hamel_c + hamel_c.transpose()));
    worst.equal("C V without the matrix", &into_matrix(bias.clone()), &into_matrix(&hamel_c * &velocity));

    // ξ = Θ V with Θ = [[1, A_l], [0, 1]].
    let mut transform = DMatrix::identity(6 + n, 6 + n);
    transform.view_range_mut(..6, 6..).copy_from(&a);
    let mut lambda = square(6 + n);
    lambda.view_range_mut(..6, ..6).copy_from(&lambda_b);
    lambda.view_range_mut(6.., 6..).copy_from(&lambda_q);
    worst.equal("M = Θᵀ Λ Θ", &hamel_m, &(transform.transpose() * &lambda * &transform));
    let turning = stacked(&rate.connection * &rates, &DVector::zeros(n));
    let rel_bias = transform.transpose() * (&lambda * turning + (&d_qdot - &d_mu) * &xi);
    worst.equal("C V = Θᵀ(Λ Θ̇ V + (D_q̇ − D_μ) ξ)", &into_matrix(bias.clone()), &into_matrix(rel_bias));
    let [by_xi, by_v] = [(&lambda, &xi), (&hamel_m, &velocity)].map(|(m, v)| 0.5 * v.dot(&(m * v)));
    worst.see("½ ξᵀΛξ = ½ VᵀMV = energy", (by_xi - energy).abs().max((by_v - energy).abs()), energy);

    // ξ̇ is judged by the forces it leaves unbalanced: accelerations magnify rounding by the condition number of Λ.
    let force = |xi_dot: &DVector<f64>| into_matrix(&lambda * xi_dot);
    worst.equal("ξ̇ by factoring Λ_q = ξ̇ by the articulated sweep", &force(xi_dot), &force(xi_dot_sweep));
    let applied = stacked(state.wrench.to_vector(), &DVector::from_row_slice(&state.tau));
    worst.equal(
        "inverse dynamics of ξ̇ = [F₁; τ]",
        &into_matrix(stacked(wrench.to_vector(), &tau)),
        &into_matrix(applied.clone()),
    );
    let power = velocity.dot(&applied);
    let energy_rate = xi.dot(&(&lambda * &*xi_dot))
        + 0.5 * mu.to_vector().dot(&(rate.locked_inertia * mu.to_vector()))
        + 0.5 * rates.dot(&(&rate.shape_inertia * &rates));
    worst.see("dE/dt = ⟨F₁, V₁⟩ + ⟨τ, q̇⟩", (energy_rate - power).abs(), force(xi_dot).amax() + power.abs());
    let drift = momentum_drift(dual_work, state, base_twist, xi_dot);
    worst.see("dJ/dt = Ad_{g₁}⁻ᵀ F₁", drift.amax(), momentum.to_vector().amax() + state.wrench.to_vector().amax());
}

/// Derivatives along a shape direction.
struct Rates {
    locked_inertia: Matrix6<f64>,
    connection: Matrix6xX<f64>,
    shape_inertia: DMatrix<f64>,
    hamel_inertia: DMatrix<f64>,
}

impl Rates {
    fn along(work: &mut Workspace<Dual>, q: &[f64], direction: &[f64]) -> Self {
        let n = q.len();
        let q: Vec<Dual> = q.iter().zip(direction).map(|(&x, &rate)| Dual::new(x, rate)).collect();
        let mut shape = work.shape(&q);
        let mut connection = Matrix6xX::from_element(n, Dual::from(0.0));
        let mut shape_inertia = DMatrix::from_element(n, n, Dual::from(0.0));
        let mut hamel_inertia = DMatrix::from_element(6 + n, 6 + n, Dual::from(0.0));
        shape.connection(&mut connection);
        shape.shape_inertia(&mut shape_inertia);
        shape.hamel_inertia(&mut hamel_inertia);
        Self {
            locked_inertia: shape.locked_inertia().to_matrix().map(|x| x.derivative),
            connection: connection.map(|x| x.derivative),
            shape_inertia: shape_inertia.map(|x| x.derivative),
            hamel_inertia: hamel_inertia.map(|x| x.derivative),
        }
    }
}

/// `dJ/dt − Ad_{g₁}⁻ᵀ F₁` along the motion: the spatial momentum changes by what is applied, and by nothing else.
fn momentum_drift(
    work: &mut Workspace<Dual>,
    state: &State,
    base_twist: Twist<f64>,
    xi_dot: &DVector<f64>,
) -> Vector6<f64> {
    let q: Vec<Dual> = state.q.iter().zip(&state.qd).map(|(&x, &rate)| Dual::new(x, rate)).collect();
    let mu = state.mu.to_array();
    let mu = Twist::from_array(std::array::from_fn(|i| Dual::new(mu[i], xi_dot[i])));
    // ġ₁ = g₁ V₁^
    let pose = &state.pose;
    let turn = pose.rotation * base_twist.angular.cross_matrix();
    let slide = pose.rotation * base_twist.linear;
    let pose = Pose::new(pose.rotation.zip_map(&turn, Dual::new), pose.translation.zip_map(&slide, Dual::new));
    let rate = work.shape(&q).spatial_momentum(&pose, mu).to_vector().map(|x| x.derivative);
    rate - state.pose.act_wrench(state.wrench).to_vector()
}

/// `½(I ad_X − ad_Xᵀ I − ad~_{I X})`.
fn coriolis_by_definition(inertia: &DMatrix<f64>, twist: Twist<f64>) -> DMatrix<f64> {
    let inertia = Matrix6::from_iterator(inertia.iter().copied());
    let momentum: [f64; 6] = (inertia * twist.to_vector()).into();
    let ad = twist.ad_matrix();
    let matrix = (inertia * ad - ad.transpose() * inertia - Wrench::from_array(momentum).ad_tilde()) * 0.5;
    matrix.resize(6, 6, 0.0)
}

/// `Σ x_i y_j 𝓑(e_i, e_j)`.
fn contract(curvature: &Curvature, x: &DVector<f64>, y: &DVector<f64>) -> Twist<f64> {
    let mut sum = Twist::zero();
    for (i, &x) in x.iter().enumerate() {
        for (j, &y) in y.iter().enumerate() {
            sum += curvature.get(i, j) * (x * y);
        }
    }
    sum
}

/// `[six; n]`.
fn stacked(upper: Vector6<f64>, lower: &DVector<f64>) -> DVector<f64> {
    DVector::from_iterator(6 + lower.len(), upper.iter().chain(lower.iter()).copied())
}

fn into_matrix<R: nalgebra::Dim, S: nalgebra::Storage<f64, R>>(
    vector: nalgebra::Matrix<f64, R, nalgebra::U1, S>,
) -> DMatrix<f64> {
    DMatrix::from_iterator(vector.nrows(), 1, vector.iter().copied())
}
