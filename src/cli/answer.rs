//! The quantities `frs eval` knows, by key.

use clap::ValueEnum;
use frs::nalgebra::{DMatrix, Matrix6, Matrix6xX, Scalar};
use frs::spatial::Twist;
use frs::{Curvature, Moving, Real};
use serde::ser::SerializeSeq;
use serde::{Serialize, Serializer};

use super::state::State;

/// A quantity; its key is its name in snake case.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Key {
    /// Λ_b, 6×6
    LockedInertia,
    /// A_l, 6×n
    Connection,
    /// Λ_q, n×n
    ShapeInertia,
    /// P(q̇), 6×6
    P,
    /// S(μ), 6×n
    S,
    /// C_b^μ, 6×6
    #[value(name = "c_b")]
    CB,
    /// Γ'_q(q̇), n×n
    GammaQ,
    /// B_2(μ), n×n
    B2,
    /// D_μ, (6+n)×(6+n)
    DMu,
    /// D_q̇, (6+n)×(6+n)
    DQdot,
    /// 𝓑, 6×n×n
    Curvature,
    /// Coupling torque, the (μ, μ) term, n
    CouplingTorque,
    /// Body momentum Λ_b μ, 6
    Momentum,
    /// Kinetic energy
    Energy,
    /// M in [V₁; q̇], (6+n)×(6+n)
    HamelM,
    /// C in [V₁; q̇], (6+n)×(6+n)
    HamelC,
    /// C V, 6+n
    HamelBias,
    /// ξ̇ = [μ̇; q̈], 6+n
    XiDot,
}

impl Key {
    /// The key's name in the output.
    pub fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }

    /// The quantity at a state.
    pub fn answer<T: Real>(self, motion: &mut Moving<'_, '_, '_, T>, mu: Twist<T>, state: &State<T>) -> Value<T> {
        let n = state.q.len();
        let columns = || Matrix6xX::zeros(n);
        let square = |size| DMatrix::zeros(size, size);
        let vector = |fill: &mut dyn FnMut(&mut [T]), size| {
            let mut out = vec![T::zero(); size];
            fill(&mut out);
            Value::Vector(out)
        };
        let matrix = |fill: &mut dyn FnMut(&mut DMatrix<T>), size| {
            let mut out = square(size);
            fill(&mut out);
            Value::Matrix(out)
        };
        match self {
            Self::LockedInertia => Value::six(motion.locked_inertia().to_matrix()),
            Self::Connection => {
                let mut out = columns();
                motion.connection(&mut out);
                Value::Matrix(out.resize_vertically(6, T::zero()))
            }
            Self::ShapeInertia => matrix(&mut |out| motion.shape_inertia(out), n),
            Self::P => Value::six(motion.inertia_velocity(&state.qd)),
            Self::S => {
                let mut out = columns();
                motion.inertia_derivative(mu, &mut out);
                Value::Matrix(out.resize_vertically(6, T::zero()))
            }
            Self::CB => Value::six(motion.locked_coriolis(mu)),
            Self::GammaQ => matrix(&mut |out| motion.gamma_q(out), n),
            Self::B2 => matrix(&mut |out| motion.b2(mu, out), n),
            Self::DMu => matrix(&mut |out| motion.d_mu(mu, out), 6 + n),
            Self::DQdot => matrix(&mut |out| motion.d_qdot(out), 6 + n),
            Self::Curvature => {
                let mut out = Curvature::new(n);
                motion.curvature(&mut out);
                Value::Tensor(std::array::from_fn(|row| DMatrix::from_fn(n, n, |i, j| out.get(i, j).to_array()[row])))
            }
            Self::CouplingTorque => vector(&mut |out| motion.coupling_torque(mu, out), n),
            Self::Momentum => Value::Vector(motion.body_momentum(mu).to_array().to_vec()),
            Self::Energy => Value::Scalar(motion.kinetic_energy(mu)),
            Self::HamelM => matrix(&mut |out| motion.hamel_inertia(out), 6 + n),
            Self::HamelC => {
                let base_twist = motion.base_twist(mu);
                matrix(&mut |out| motion.hamel_coriolis(base_twist, out), 6 + n)
            }
            Self::HamelBias => {
                let base_twist = motion.base_twist(mu);
                vector(&mut |out| motion.hamel_bias(base_twist, out), 6 + n)
            }
            Self::XiDot => vector(&mut |out| motion.forward_dynamics(mu, state.base_wrench, &state.tau, out), 6 + n),
        }
    }
}

/// A quantity's value; matrices are written as arrays of rows.
#[derive(Clone, Debug)]
pub enum Value<T = f64> {
    Scalar(T),
    Vector(Vec<T>),
    Matrix(DMatrix<T>),
    Tensor([DMatrix<T>; 6]),
}

impl<T: Real> Value<T> {
    fn six(matrix: Matrix6<T>) -> Self {
        Self::Matrix(matrix.resize(6, 6, T::zero()))
    }
}

impl<T: Scalar> Value<T> {
    /// Every number through `change`, one after the other.
    pub fn map<U: Scalar>(self, mut change: impl FnMut(T) -> U) -> Value<U> {
        match self {
            Self::Scalar(x) => Value::Scalar(change(x)),
            Self::Vector(v) => Value::Vector(v.into_iter().map(change).collect()),
            Self::Matrix(m) => Value::Matrix(m.map(change)),
            Self::Tensor(t) => Value::Tensor(t.map(|m| m.map(&mut change))),
        }
    }
}

impl Value {
    /// Whether every number in it is finite.
    pub fn is_finite(&self) -> bool {
        let finite = |x: &f64| x.is_finite();
        match self {
            Self::Scalar(x) => finite(x),
            Self::Vector(v) => v.iter().all(finite),
            Self::Matrix(m) => m.iter().all(finite),
            Self::Tensor(t) => t.iter().all(|m| m.iter().all(finite)),
        }
    }
}

struct Rows<'a>(&'a DMatrix<f64>);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut rows = serializer.serialize_seq(Some(self.0.nrows()))?;
        for row in self.0.row_iter() {
            rows.serialize_element(&row.iter().collect::<Vec<_>>())?;
        }
        rows.end()
    }
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Scalar(x) => x.serialize(serializer),
            Self::Vector(v) => v.serialize(serializer),
            Self::Matrix(m) => Rows(m).serialize(serializer),
            Self::Tensor(t) => t.each_ref().map(Rows).serialize(serializer),
        }
    }
}
