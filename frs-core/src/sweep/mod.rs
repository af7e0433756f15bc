//! The recursion's passes over the bodies of a robot.
//!
//! Everything is expressed in the *centroidal frame*: the axes of the base, the origin at the total centre of mass. There
//! the locked inertia is block diagonal and lever arms are as short as they can be. Quantities that a user sees are moved
//! to the base frame at the edge, in [`rel`](crate::rel) and [`hamel`](crate::hamel).
//!
//! Joint j of the tree drives body j + 1; vectors over joints are stored component by component ([`Columns`]).

mod articulated;
mod columns;
mod composite;
mod coordinates;
mod factors;
mod frames;
mod labels;
mod newton_euler;
mod parts;
mod position;
mod square;
mod tables;
mod velocity;

pub(crate) use articulated::articulated_accelerations;
pub(crate) use columns::{Columns, Row, groups};
pub(crate) use composite::{outside_sums, subtree_sums};
pub(crate) use factors::factors;
pub(crate) use frames::base_matrix;
pub use labels::{Label, Pass};
use nalgebra::{DMatrix, Matrix3, Vector3};
pub(crate) use newton_euler::{newton_euler, project};
pub(crate) use parts::{gather, joined, scatter, splat};
pub(crate) use square::{Square, Symmetry, multiple_of_block};
pub(crate) use velocity::free_velocities;

use crate::Real;
use crate::model::Model;
use crate::spatial::{ArticulatedInertia, CoriolisFactor, Inertia, LdlFactor3, Symmetric3, Twist, Wrench};
use columns::room;
use tables::Tables;

/// All the memory the recursion needs for one robot; made once, reused for every state.
///
/// ```
/// use frs_core::{Model, Workspace};
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// let mut work = Workspace::new(&model);
/// let shape = work.shape(&[0.0; 7]);
/// assert!((shape.locked_inertia().mass - 17.5).abs() < 1e-14);
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Workspace<'m, T: Real = f64> {
    pub(crate) model: &'m Model<T>,
    pub(crate) data: Data<T>,
}

/// What the sweeps write: one entry per body, or per joint where it says so ([`Columns`], [`Row`]).
///
/// Vectors over bodies have room for whole groups of lanes behind the base.
#[derive(Clone, Debug)]
pub(crate) struct Data<T: Real> {
    /// What the sweeps read.
    pub tables: Tables<T>,

    // Position sweep.
    /// Sine and cosine of each revolute joint's angle.
    pub sin: Row<T>,
    pub cos: Row<T>,
    /// Orientation of each body in base axes.
    pub rotation: Vec<Matrix3<T>>,
    /// Origin of each body's frame, from the centre of mass.
    pub origin: Vec<Vector3<T>>,
    /// Orientation and origin of the body that joint j drives, by joints.
    pub rotation_columns: Columns<T, 9>,
    pub origin_columns: Columns<T, 3>,
    /// Total centre of mass, from the base body's origin.
    pub com: Vector3<T>,
    /// Reciprocal of the total mass.
    pub inverse_mass: T,
    /// Factors of the locked rotational inertia about the centre of mass.
    pub locked: LdlFactor3<T>,
    /// I_k, inertia of each body.
    pub inertia: Vec<Inertia<T>>,
    /// Iᶜ_k, inertia of each body's subtree.
    pub composite: Vec<Inertia<T>>,
    /// Iᵒ_k, inertia of everything outside each body's subtree.
    pub complement: Vec<Inertia<T>>,
    /// Iᶜ and Iᵒ of the body that joint j drives, by joints.
    pub composite_columns: Columns<T, 10>,
    pub complement_columns: Columns<T, 10>,
    /// s_j, screw axis of each joint.
    pub screw: Columns<T, 6>,
    /// h_j = Iᶜ_j s_j.
    pub inside: Columns<T, 6>,
    /// k_j = Iᵒ_j s_j.
    pub outside: Columns<T, 6>,
    /// A_j = Λ_c⁻¹ h_j, the connection in the centroidal frame.
    pub connection: Columns<T, 6>,
    /// ŝ_j = Λ_c⁻¹ k_j = s_j − A_j.
    pub reaction: Columns<T, 6>,

    // Velocity sweep.
    /// Rate of each joint; `rate_more`: of another motion.
    pub rate: Row<T>,
    pub rate_more: Row<T>,
    /// w_k, velocity of each body at zero momentum.
    pub velocity: Vec<Twist<T>>,

    // Scratch: written and read within one question.
    /// Per joint.
    pub row: Row<T>,
    pub inverse_pivot: Vec<T>,
    pub three_rows: Columns<T, 3>,
    pub three_rows_more: Columns<T, 3>,
    pub six_rows: Columns<T, 6>,
    pub six_rows_more: Columns<T, 6>,
    pub nine_rows: [Columns<T, 9>; 3],
    pub twelve_rows: Columns<T, 12>,
    /// Per coordinate.
    pub vector: Vec<T>,
    pub vector_more: Vec<T>,
    pub matrix: DMatrix<T>,
    /// Per body.
    pub twist: Vec<Twist<T>>,
    pub twist_more: Vec<Twist<T>>,
    pub wrench: Vec<Wrench<T>>,
    pub wrench_outside: Vec<Wrench<T>>,
    pub wrench_before: Vec<Wrench<T>>,
    pub factor: Vec<CoriolisFactor<T>>,
    pub factor_outside: Vec<CoriolisFactor<T>>,
    pub factor_before: Vec<CoriolisFactor<T>>,
    pub inertia_before: Vec<Inertia<T>>,
    pub articulated: Vec<ArticulatedInertia<T>>,
}

impl<'m, T: Real> Workspace<'m, T> {
    /// Memory for `model`.
    pub fn new(model: &'m Model<T>) -> Self {
        let joints = model.joints();
        let bodies = 1 + room::<T>(joints);
        let inertia = vec![Inertia::zero(); bodies];
        let twist = vec![Twist::zero(); bodies];
        let wrench = vec![Wrench::zero(); bodies];
        let factor = vec![CoriolisFactor::zero(); bodies];
        let (six, nine, ten) = (Columns::new(joints), Columns::new(joints), Columns::new(joints));
        let data = Data {
            tables: Tables::new(model),
            sin: Row::new(joints),
            cos: Row::new(joints),
            rotation: vec![Matrix3::identity(); bodies],
            origin: vec![Vector3::zeros(); bodies],
            rotation_columns: nine.clone(),
            origin_columns: Columns::new(joints),
            com: Vector3::zeros(),
            inverse_mass: T::one(),
            locked: Symmetric3::diagonal(Vector3::repeat(T::one())).factor(),
            inertia: inertia.clone(),
            composite: inertia.clone(),
            complement: inertia.clone(),
            composite_columns: ten.clone(),
            complement_columns: ten,
            screw: six.clone(),
            inside: six.clone(),
            outside: six.clone(),
            connection: six.clone(),
            reaction: six.clone(),
            rate: Row::new(joints),
            rate_more: Row::new(joints),
            velocity: twist.clone(),
            row: Row::new(joints),
            inverse_pivot: vec![T::zero(); joints],
            three_rows: Columns::new(joints),
            three_rows_more: Columns::new(joints),
            six_rows: six.clone(),
            six_rows_more: six,
            nine_rows: [nine.clone(), nine.clone(), nine],
            twelve_rows: Columns::new(joints),
            vector: vec![T::zero(); model.dof()],
            vector_more: vec![T::zero(); model.dof()],
            matrix: DMatrix::zeros(model.dof(), model.dof()),
            twist: twist.clone(),
            twist_more: twist,
            wrench: wrench.clone(),
            wrench_outside: wrench.clone(),
            wrench_before: wrench,
            factor: factor.clone(),
            factor_outside: factor.clone(),
            factor_before: factor,
            inertia_before: inertia,
            articulated: vec![ArticulatedInertia::zero(); bodies],
        };
        Self { model, data }
    }

    /// The model this is memory for.
    pub fn model(&self) -> &'m Model<T> {
        self.model
    }

    /// The robot at shape `q` (length n; rad for revolute, m for prismatic coordinates): runs the position sweep.
    ///
    /// # Panics
    /// If `q` does not have one entry per coordinate.
    pub fn shape(&mut self, q: &[T]) -> Shape<'_, 'm, T> {
        assert_eq!(q.len(), self.model.dof(), "q must have one entry per coordinate");
        position::position(self.model, q, &mut self.data);
        Shape { model: self.model, data: &mut self.data }
    }
}

/// A robot at a shape: everything that depends on `q`, and on momenta or directions given with the question.
#[derive(Debug)]
pub struct Shape<'w, 'm, T: Real = f64> {
    pub(crate) model: &'m Model<T>,
    pub(crate) data: &'w mut Data<T>,
}

/// A robot at a shape that changes at a rate: everything that depends on `(q, q̇)`.
///
/// Derefs to [`Shape`], so that one value answers every question about a state.
#[derive(Debug)]
pub struct Moving<'s, 'w, 'm, T: Real = f64> {
    shape: &'s mut Shape<'w, 'm, T>,
}

impl<'w, 'm, T: Real> Shape<'w, 'm, T> {
    /// The robot with shape velocity `q̇` (length n): runs the velocity sweep.
    ///
    /// # Panics
    /// If `qd` does not have one entry per coordinate.
    pub fn moving(&mut self, qd: &[T]) -> Moving<'_, 'w, 'm, T> {
        assert_eq!(qd.len(), self.model.dof(), "q̇ must have one entry per coordinate");
        velocity::velocity(self.model, qd, self.data);
        Moving { shape: self }
    }

    /// The model this is a shape of.
    pub fn model(&self) -> &'m Model<T> {
        self.model
    }

    /// The total centre of mass c, in the base frame.
    pub fn com(&self) -> Vector3<T> {
        self.data.com - self.model.root_offset()
    }

    /// Λ_c⁻¹ of a momentum in the centroidal frame.
    pub(crate) fn locked_solve(&self, momentum: Wrench<T>) -> Twist<T> {
        self.data.locked_solve(momentum)
    }
}

impl<'w, 'm, T: Real> std::ops::Deref for Moving<'_, 'w, 'm, T> {
    type Target = Shape<'w, 'm, T>;
    fn deref(&self) -> &Self::Target {
        self.shape
    }
}

impl<T: Real> std::ops::DerefMut for Moving<'_, '_, '_, T> {
    fn deref_mut(&mut self) -> &mut Self::Target {
        self.shape
    }
}

impl<T: Real> Data<T> {
    /// Λ_c⁻¹ of a momentum in the centroidal frame.
    #[inline(always)]
    pub fn locked_solve(&self, momentum: Wrench<T>) -> Twist<T> {
        locked_solve(&self.locked, self.inverse_mass, momentum)
    }
}

/// Λ_c⁻¹ of a momentum, from the factors of its rotational block and the reciprocal of the mass.
#[inline(always)]
fn locked_solve<T: Real>(locked: &LdlFactor3<T>, inverse_mass: T, momentum: Wrench<T>) -> Twist<T> {
    Twist::new(locked.solve(momentum.moment), momentum.force * inverse_mass)
}
