//! Every quantity of docs/mathematics.md §2 as the direct sum over links that defines it, dense, from the description.

use frs_core::model::RobotDescription;
use nalgebra::{DMatrix, DVector, Matrix6, Matrix6xX, MatrixXx6, Vector6};

use crate::algebra::{ad, ad_tilde, adjoint_inverse, coriolis, inertia};
use crate::kinematics::{LinkMotion, kinematics};

/// A link as the sums see it.
pub struct Link {
    /// X_k = Ad_{1k}⁻¹.
    pub x: Matrix6<f64>,
    pub x_rate: Matrix6<f64>,
    /// J_k.
    pub j: Matrix6xX<f64>,
    pub j_rate: Matrix6xX<f64>,
    /// J̃_k = J_k − X_k A_l.
    pub jt: Matrix6xX<f64>,
    pub jt_rate: Matrix6xX<f64>,
    /// M_k.
    pub m: Matrix6<f64>,
    pub motion: LinkMotion,
}

/// A robot at `(q, q̇)`.
pub struct Specification {
    pub links: Vec<Link>,
    pub qd: DVector<f64>,
    /// Λ_b.
    pub lambda_b: Matrix6<f64>,
    /// M_bq.
    pub m_bq: Matrix6xX<f64>,
    /// A_l.
    pub a: Matrix6xX<f64>,
    /// dA_l/dt.
    pub a_rate: Matrix6xX<f64>,
}

impl Specification {
    /// Coordinates are ordered as in `coordinates`.
    pub fn new(robot: &RobotDescription, coordinates: &[String], q: &DVector<f64>, qd: &DVector<f64>) -> Self {
        let n = q.len();
        let motions = kinematics(robot, coordinates, q, qd);
        let mut links: Vec<Link> = motions
            .into_iter()
            .zip(&robot.links)
            .map(|(motion, link)| {
                let x = adjoint_inverse(&motion.rotation, &motion.translation);
                let (j, j_rate) = (motion.jacobian.clone(), motion.jacobian_rate.clone());
                // d/dt Ad_g⁻¹ = −ad_V Ad_g⁻¹ with the body velocity V of g.
                let x_rate = -ad(&(&j * qd)) * x;
                let body = link.inertial;
                let m = inertia(body.mass, body.com, body.inertia.to_matrix());
                Link { x, x_rate, jt: j.clone(), jt_rate: j_rate.clone(), j, j_rate, m, motion }
            })
            .collect();

        let lambda_b: Matrix6<f64> = links.iter().map(|k| k.x.transpose() * k.m * k.x).sum();
        let lambda_b_rate: Matrix6<f64> =
            links.iter().map(|k| k.x_rate.transpose() * k.m * k.x + k.x.transpose() * k.m * k.x_rate).sum();
        let still = || Matrix6xX::zeros(n);
        let m_bq = links.iter().fold(still(), |sum, k| sum + k.x.transpose() * k.m * &k.j);
        let m_bq_rate = links
            .iter()
            .fold(still(), |sum, k| sum + k.x_rate.transpose() * k.m * &k.j + k.x.transpose() * k.m * &k.j_rate);
        let inverse = lambda_b.cholesky().expect("Λ_b is positive definite").inverse();
        let a = inverse * &m_bq;
        let a_rate = inverse * (m_bq_rate - lambda_b_rate * &a);
        for k in &mut links {
            k.jt -= k.x * &a;
            k.jt_rate -= k.x_rate * &a + k.x * &a_rate;
        }
        Self { links, qd: qd.clone(), lambda_b, m_bq, a, a_rate }
    }

    /// n.
    pub fn dof(&self) -> usize {
        self.qd.len()
    }

    /// Λ_q.
    pub fn lambda_q(&self) -> DMatrix<f64> {
        self.shape_sum(|k| k.jt.transpose() * k.m * &k.jt)
    }

    /// M_q, the joints' block of the Hamel form.
    pub fn m_q(&self) -> DMatrix<f64> {
        self.shape_sum(|k| k.j.transpose() * k.m * &k.j)
    }

    /// P(x).
    pub fn p(&self, x: &DVector<f64>) -> Matrix6<f64> {
        let moving = |k: &Link| {
            let ad = ad(&(&k.j * x));
            k.x.transpose() * (ad.transpose() * k.m + k.m * ad) * k.x
        };
        -self.links.iter().map(moving).sum::<Matrix6<f64>>()
    }

    /// S(x).
    pub fn s(&self, x: &Vector6<f64>) -> Matrix6xX<f64> {
        let n = self.dof();
        let columns: Vec<_> = (0..n).map(|j| self.p(&unit(n, j)) * x * 0.5).collect();
        Matrix6xX::from_fn(n, |row, column| columns[column][row])
    }

    /// C_b^μ.
    pub fn c_b(&self, mu: &Vector6<f64>) -> Matrix6<f64> {
        coriolis(&self.lambda_b, mu)
    }

    /// Γ'_q(q̇).
    pub fn gamma_q(&self) -> DMatrix<f64> {
        self.shape_sum(|k| k.jt.transpose() * (coriolis(&k.m, &(&k.jt * &self.qd)) * &k.jt + k.m * &k.jt_rate))
    }

    /// B_2(μ).
    pub fn b2(&self, mu: &Vector6<f64>) -> DMatrix<f64> {
        self.shape_sum(|k| k.jt.transpose() * coriolis(&k.m, &(k.x * mu)) * &k.jt)
    }

    /// D_q̇.
    pub fn d_qdot(&self) -> DMatrix<f64> {
        let zero = Matrix6xX::zeros(self.dof());
        blocks(&(self.p(&self.qd) * 0.5), &zero, &zero.transpose(), &self.gamma_q())
    }

    /// D_μ.
    pub fn d_mu(&self, mu: &Vector6<f64>) -> DMatrix<f64> {
        let turning = ad_tilde(&(self.lambda_b * mu));
        let s = self.s(mu);
        let upper_right = -&s - turning * &self.a;
        let lower_left = s.transpose() - self.a.transpose() * turning;
        blocks(&-self.c_b(mu), &upper_right, &lower_left, &(self.b2(mu) * -2.0))
    }

    /// diag(Λ_b, Λ_q).
    pub fn lambda(&self) -> DMatrix<f64> {
        let zero = Matrix6xX::zeros(self.dof());
        blocks(&self.lambda_b, &zero, &zero.transpose(), &self.lambda_q())
    }

    /// 𝓑(x, y) by the formula without derivatives.
    pub fn curvature(&self, x: &DVector<f64>, y: &DVector<f64>) -> Vector6<f64> {
        let of_link = |k: &Link| {
            let (x, y) = (&k.jt * x, &k.jt * y);
            k.x.transpose() * (ad(&y).transpose() * k.m * x - ad(&x).transpose() * k.m * y - k.m * ad(&x) * y)
        };
        let momentum: Vector6<f64> = self.links.iter().map(of_link).sum();
        self.lambda_b.cholesky().expect("Λ_b is positive definite").solve(&momentum)
    }

    /// The torque S(μ)ᵀμ − A_lᵀ ad~_{Λ_bμ} μ of the locked motion on the joints.
    pub fn coupling_torque(&self, mu: &Vector6<f64>) -> DVector<f64> {
        self.s(mu).transpose() * mu - self.a.transpose() * (ad_tilde(&(self.lambda_b * mu)) * mu)
    }

    /// M of the Hamel form, in (V₁, q̇).
    pub fn hamel_inertia(&self) -> DMatrix<f64> {
        blocks(&self.lambda_b, &self.m_bq, &self.m_bq.transpose(), &self.m_q())
    }

    /// C = Σ [X_k J_k]ᵀ( C(M_k; V_k) [X_k J_k] + M_k d/dt[X_k J_k] ).
    pub fn hamel_coriolis(&self, v1: &Vector6<f64>) -> DMatrix<f64> {
        let size = 6 + self.dof();
        sum(
            size,
            size,
            self.links.iter().map(|k| {
                let (full, rate) = (beside(&k.x, &k.j), beside(&k.x_rate, &k.j_rate));
                let velocity = k.x * v1 + &k.j * &self.qd;
                full.transpose() * (coriolis(&k.m, &velocity) * &full + k.m * rate)
            }),
        )
    }

    /// [F₁; τ − A_lᵀ F₁].
    pub fn force(&self, wrench: &Vector6<f64>, tau: &DVector<f64>) -> DVector<f64> {
        stack(wrench, &(tau - self.a.transpose() * wrench))
    }

    /// ξ = [μ; q̇].
    pub fn xi(&self, mu: &Vector6<f64>) -> DVector<f64> {
        stack(mu, &self.qd)
    }

    /// ξ̇ of Theorem 1.
    pub fn forward_dynamics(&self, mu: &Vector6<f64>, wrench: &Vector6<f64>, tau: &DVector<f64>) -> DVector<f64> {
        let driving_force = self.driving_force(mu, wrench, tau);
        self.lambda().cholesky().expect("Λ is positive definite").solve(&driving_force)
    }

    /// Λ ξ̇ of Theorem 1.
    pub fn driving_force(&self, mu: &Vector6<f64>, wrench: &Vector6<f64>, tau: &DVector<f64>) -> DVector<f64> {
        (self.d_mu(mu) - self.d_qdot()) * self.xi(mu) + self.force(wrench, tau)
    }

    /// The condition number of Λ_q, by which forward dynamics multiplies errors.
    pub fn shape_condition(&self) -> f64 {
        if self.dof() == 0 {
            return 1.0;
        }
        let eigenvalues = self.lambda_q().symmetric_eigenvalues();
        eigenvalues.max() / eigenvalues.min()
    }

    fn shape_sum(&self, of_link: impl Fn(&Link) -> DMatrix<f64>) -> DMatrix<f64> {
        sum(self.dof(), self.dof(), self.links.iter().map(of_link))
    }
}

/// e_j.
pub fn unit(n: usize, j: usize) -> DVector<f64> {
    DVector::from_fn(n, |i, _| f64::from(u8::from(i == j)))
}

/// [upper; lower].
pub fn stack(upper: &Vector6<f64>, lower: &DVector<f64>) -> DVector<f64> {
    DVector::from_iterator(6 + lower.len(), upper.iter().chain(lower.iter()).copied())
}

/// The matrix of four blocks, over base and joints.
pub fn blocks(
    base: &Matrix6<f64>,
    upper_right: &Matrix6xX<f64>,
    lower_left: &MatrixXx6<f64>,
    joints: &DMatrix<f64>,
) -> DMatrix<f64> {
    let n = joints.nrows();
    let mut matrix = DMatrix::zeros(6 + n, 6 + n);
    matrix.view_mut((0, 0), (6, 6)).copy_from(base);
    matrix.view_mut((0, 6), (6, n)).copy_from(upper_right);
    matrix.view_mut((6, 0), (n, 6)).copy_from(lower_left);
    matrix.view_mut((6, 6), (n, n)).copy_from(joints);
    matrix
}

/// A 6×6 matrix among matrices of any size.
pub fn dense(matrix: &Matrix6<f64>) -> DMatrix<f64> {
    DMatrix::from_column_slice(6, 6, matrix.as_slice())
}

/// [left right], 6×(6+n).
fn beside(left: &Matrix6<f64>, right: &Matrix6xX<f64>) -> Matrix6xX<f64> {
    Matrix6xX::from_iterator(6 + right.ncols(), left.iter().chain(right.iter()).copied())
}

fn sum(rows: usize, columns: usize, terms: impl Iterator<Item = DMatrix<f64>>) -> DMatrix<f64> {
    terms.fold(DMatrix::zeros(rows, columns), |sum, term| sum + term)
}
