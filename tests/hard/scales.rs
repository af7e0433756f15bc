//! The natural scale of every output: what its entries cannot exceed, up to a small factor, whatever the robot.
//!
//! A coordinate i of ξ moves each mass point at some velocity `v_i`, and `Λ_ij = Σ m v_i·v_j`, so `|Λ_ij| ≤ s_i s_j` with
//! `s_i = √Λ_ii`; `D_μ` is `Σ m v_i·(ω × v_j)`, at most `|ω| s_i s_j`; and so on. An error of some ε of such a scale is what
//! rounding every mass, length and angle once would cause. Where the equations of the momentum bring in the connection, as in the mixed
//! blocks of D_μ, the scale is that of a joint that moves while the base is held, `√M_jj`.

use frs::conditioning::{Conditioning, levers};
use frs::extended::DoubleDouble;
use frs::nalgebra::{DMatrix, Matrix3, Matrix6xX};
use frs::{Model, Workspace};

use crate::state::State;

/// Sizes at a state, from which the scales are made.
pub struct Scales {
    n: usize,
    /// √Λ_ii, of μ and of q̇.
    motion: Vec<f64>,
    /// √(Λ⁻¹)_ii.
    force: Vec<f64>,
    /// √M_jj: the joint moves, the base is held.
    held: Vec<f64>,
    /// Rows of the inverse of the rotational inertia about the centre of mass, and the root of its trace.
    turning_rows: [f64; 3],
    turning: f64,
    /// √ of the inertia about the centre of mass: three of rotation, three of the mass.
    centroidal: [f64; 6],
    /// Root of the mean square distance of the masses from the base frame's origin.
    reach: f64,
    /// By how much the terms of Λ_ii exceed it.
    pub levers: Vec<f64>,
    pub conditioning: Conditioning,
    /// The condition number of Λ_q as it is.
    pub plain_condition: f64,
}

impl Scales {
    pub fn new(model: &Model<DoubleDouble>, state: &State) -> Self {
        let n = model.dof();
        let mut work = Workspace::new(model);
        let mut shape = work.shape(&state.wide("q", n));
        let high = |x: DoubleDouble| x.high();
        let locked = shape.locked_inertia().to_matrix().map(high);
        let about_com = shape.locked_rotational_inertia().to_matrix().map(high);
        let (com, mass) = (shape.com().map(high), locked[(3, 3)]);
        let (mut inertia, mut connection) = (DMatrix::zeros(n, n), Matrix6xX::zeros(n));
        shape.shape_inertia(&mut inertia);
        shape.connection(&mut connection);
        let (inertia, connection) = (inertia.map(high), connection.map(high));

        let values = inertia.symmetric_eigenvalues();
        let shape_motion: Vec<f64> = (0..n).map(|j| inertia[(j, j)].sqrt()).collect();
        let correlation = DMatrix::from_fn(n, n, |i, j| inertia[(i, j)] / (shape_motion[i] * shape_motion[j]));
        let inverse = correlation.try_inverse().expect("Λ_q is positive definite");
        let turning: Matrix3<f64> = about_com.try_inverse().expect("Λ_b is positive definite");
        let arm = com.cross_matrix();
        let sliding = Matrix3::identity() / mass - arm * turning * arm;
        let locked_force = (0..6).map(|i| if i < 3 { turning[(i, i)] } else { sliding[(i - 3, i - 3)] }.sqrt());
        let shape_force = (0..n).map(|j| inverse[(j, j)].abs().sqrt() / shape_motion[j]);
        let held: Vec<f64> = (0..n)
            .map(|j| (inertia[(j, j)] + connection.column(j).dot(&(locked * connection.column(j)))).sqrt())
            .collect();
        Self {
            n,
            plain_condition: values.max() / values.min(),
            levers: levers(model, &mut shape),
            conditioning: Conditioning::at(model, &state.wide("q", n)),
            held,
            force: locked_force.chain(shape_force).collect(),
            motion: (0..6).map(|i| locked[(i, i)].sqrt()).chain(shape_motion).collect(),
            turning_rows: std::array::from_fn(|i| turning.row(i).norm()),
            turning: turning.trace().sqrt(),
            centroidal: std::array::from_fn(|i| if i < 3 { about_com[(i, i)] } else { mass }.sqrt()),
            reach: (locked.fixed_view::<3, 3>(0, 0).trace() / (2.0 * mass)).sqrt(),
        }
    }

    /// The scales of the entries of `output`, column by column.
    pub fn of(&self, output: &str, state: &State) -> Vec<f64> {
        let (n, six_and_n) = (self.n, 6 + self.n);
        let Self { motion, force, held, .. } = self;
        let input = |name, length| state.numbers(name, length);
        let weighed = |x: &[f64], by: &[f64]| x.iter().zip(by).map(|(x, by)| (x * by).abs()).sum::<f64>();
        let size = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (mu, qd) = (input("mu", 6), input("qd", n));
        // Rates of turning, and square roots of twice the energy, of each half of the motion.
        let (turn, rate) = (size(&mu[..3]), weighed(&qd, &vec![1.0; n]));
        let (locked, shape, moved) = (weighed(&mu, motion), weighed(&qd, &motion[6..]), weighed(&qd, held));
        let square = |size: usize, entry: &dyn Fn(usize, usize) -> f64| -> Vec<f64> {
            (0..size * size).map(|k| entry(k % size, k / size)).collect()
        };
        let product = |i: usize, j: usize| motion[i] * motion[j];
        let is_turn = |i: usize| f64::from(u8::from(i < 3));
        match output {
            "locked_inertia" => square(6, &product),
            "shape_inertia" => square(n, &|i, j| product(6 + i, 6 + j)),
            "connection" => (0..6 * n).map(|k| force[k % 6] * held[k / 6]).collect(),
            "d_mu" => square(six_and_n, &|i, j| match (i < 6, j < 6) {
                (true, false) => motion[i] * held[j - 6] * (turn + self.turning * locked),
                (false, true) => motion[j] * held[i - 6] * (turn + self.turning * locked),
                _ => turn * product(i, j),
            }),
            "b2" => square(n, &|i, j| turn * product(6 + i, 6 + j)),
            "d_qdot" => square(six_and_n, &|i, j| match (i < 6, j < 6) {
                (true, true) => moved * (is_turn(i) * motion[j] + is_turn(j) * motion[i]),
                (false, false) => motion[i] * (motion[j] * rate + shape),
                _ => 0.0,
            }),
            "coupling_torque" => motion[6..].iter().map(|s| s * turn * locked).collect(),
            "d_mu_xi" => {
                (0..six_and_n).map(|i| motion[i] * turn * (locked + if i < 6 { moved } else { shape })).collect()
            }
            "d_qdot_xi" => (0..six_and_n)
                .map(|i| match i < 6 {
                    true => moved * (is_turn(i) * locked + turn * motion[i]),
                    false => motion[i] * rate * shape,
                })
                .collect(),
            "hamel_bias" => {
                let base = input("base_twist", 6);
                let all = (size(&base[..3]) + rate) * (weighed(&base, motion) + moved);
                motion[..6].iter().chain(held).map(|s| s * all).collect()
            }
            "curvature" => self
                .turning_rows
                .iter()
                .flat_map(|&turning| square(n, &|i, j| 2.0 * turning * product(6 + i, 6 + j)))
                .collect(),
            "com" => vec![self.reach; 3],
            "body_momentum" => motion[..6].iter().map(|s| s * locked).collect(),
            "centroidal_momentum" => self.centroidal.iter().map(|s| s * locked).collect(),
            "mu" => {
                let energy = weighed(&input("body_momentum", 6), force);
                force[..6].iter().map(|f| f * energy).collect()
            }
            "base_twist" => force[..6].iter().map(|f| f * (locked + moved)).collect(),
            "kinetic_energy" => vec![0.5 * (locked + shape).powi(2)],
            "xi_dot" => {
                let bias = (turn + rate) * (locked + shape + moved);
                let (gravity, wrench, tau) = (input("gravity", 3), input("base_wrench", 6), input("tau", n));
                let base = bias + size(&gravity) * self.centroidal[3] + weighed(&wrench, force);
                let joints = bias + weighed(&tau, &force[6..]) + weighed(&wrench, force);
                (0..six_and_n).map(|i| force[i] * if i < 6 { base } else { joints }).collect()
            }
            "base_wrench" | "tau" => {
                let bias = (turn + rate) * (locked + shape + moved);
                let gravity = size(&input("gravity", 3)) * self.centroidal[3];
                let xi_dot = input("xi_dot", six_and_n);
                let all = bias + gravity + weighed(&xi_dot[..6], motion) + weighed(&xi_dot[6..], held);
                if output == "tau" { held } else { &motion[..6] }.iter().map(|s| s * all).collect()
            }
            other => panic!("{other} has no scale"),
        }
    }
}
