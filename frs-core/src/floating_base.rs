//! One interface for every robot, whether read at run time or generated.

use nalgebra::{DMatrix, Matrix6xX};

use crate::spatial::{Twist, Wrench};
use crate::{Curvature, Model, Moving, Quantity, Real, Shape, Workspace};

/// A floating-base robot that answers [quantities](Quantity), over the scalar `T`.
///
/// [`Evaluator`] answers all of them for any robot. A generated robot answers those it was generated with, with the same
/// bits and faster. Code that takes `&mut impl FloatingBase` sees no difference:
///
/// ```
/// use frs_core::{Evaluator, FloatingBase, Model, Quantity};
///
/// fn largest_shape_inertia(robot: &mut impl FloatingBase, q: &[f64]) -> f64 {
///     let n = robot.dof();
///     let (mut locked, mut connection, mut shape) = (vec![0.0; 36], vec![0.0; 6 * n], vec![0.0; n * n]);
///     robot.answer(Quantity::Inertia, &[q], &mut [&mut locked, &mut connection, &mut shape]);
///     (0..n).map(|i| shape[i * n + i]).fold(0.0, f64::max)
/// }
///
/// let model = Model::from_urdf(frs_core::urdf::LWR_SATELLITE)?;
/// assert!(largest_shape_inertia(&mut Evaluator::new(&model), &[0.0; 7]) > 0.1);
/// # Ok::<(), frs_core::urdf::UrdfError>(())
/// ```
pub trait FloatingBase<T = f64> {
    /// Number n of coordinates.
    fn dof(&self) -> usize;

    /// Whether [`answer`](Self::answer) knows `quantity`.
    fn answers(&self, quantity: Quantity) -> bool;

    /// Computes `quantity`: `inputs` and `outputs` are those that it lists, in its order, as flat slices.
    ///
    /// Matrices are column by column. Every output is written completely and holds no −0.
    ///
    /// # Panics
    /// If [`answers`](Self::answers) says no, or if a slice is missing or has not [`Argument::len`](crate::Argument::len)
    /// numbers.
    fn answer(&mut self, quantity: Quantity, inputs: &[&[T]], outputs: &mut [&mut [T]]);
}

/// Any robot as a [`FloatingBase`]: the recursion over a [`Model`], with room for the answers.
///
/// Like [`Workspace`], on which it stands, it allocates when it is made and never again.
#[derive(Clone, Debug)]
pub struct Evaluator<'m, T: Real = f64> {
    work: Workspace<'m, T>,
    six_rows: Matrix6xX<T>,
    square: DMatrix<T>,
    full: DMatrix<T>,
    curvature: Curvature<T>,
    vector: Vec<T>,
    torque: Vec<T>,
}

impl<'m, T: Real> Evaluator<'m, T> {
    /// Memory for `model`.
    pub fn new(model: &'m Model<T>) -> Self {
        let n = model.dof();
        Self {
            work: Workspace::new(model),
            six_rows: Matrix6xX::zeros(n),
            square: DMatrix::zeros(n, n),
            full: DMatrix::zeros(6 + n, 6 + n),
            curvature: Curvature::new(n),
            vector: vec![T::zero(); 6 + n],
            torque: vec![T::zero(); n],
        }
    }

    /// The memory of the sweeps, as the last answer left it.
    pub fn workspace(&self) -> &Workspace<'m, T> {
        &self.work
    }
}

impl<T: Real> FloatingBase<T> for Evaluator<'_, T> {
    fn dof(&self) -> usize {
        self.torque.len()
    }

    fn answers(&self, quantity: Quantity) -> bool {
        !matches!(quantity, Quantity::Kinematics(link) if link >= self.work.model().links().len())
    }

    fn answer(&mut self, quantity: Quantity, inputs: &[&[T]], outputs: &mut [&mut [T]]) {
        let n = self.dof();
        assert!(inputs.iter().map(|input| input.len()).eq(quantity.inputs().map(|input| input.len(n))), "{SIZES}");
        let mut out = Outputs { slices: outputs.iter_mut() };
        let Self { work, six_rows, square, full, curvature, vector, torque } = self;
        let mut shape = work.shape(inputs[0]);
        match quantity {
            Quantity::Inertia => put_inertia(&mut shape, six_rows, square, &mut out),
            Quantity::DMu => {
                shape.d_mu(twist(inputs[1]), full);
                out.put(full.as_slice());
            }
            Quantity::B2 => {
                shape.b2(twist(inputs[1]), square);
                out.put(square.as_slice());
            }
            Quantity::Matrices => {
                put_inertia(&mut shape, six_rows, square, &mut out);
                shape.d_mu_with_b2(twist(inputs[1]), full, square);
                out.put(full.as_slice());
                out.put(square.as_slice());
            }
            Quantity::DQdot => {
                shape.moving(inputs[1]).d_qdot(full);
                out.put(full.as_slice());
            }
            Quantity::CouplingTorque => {
                shape.coupling_torque(twist(inputs[1]), torque);
                out.put(torque);
            }
            Quantity::DMuXi => {
                shape.moving(inputs[1]).d_mu_xi(twist(inputs[2]), vector);
                out.put(vector);
            }
            Quantity::DQdotXi => {
                shape.moving(inputs[1]).d_qdot_xi(twist(inputs[2]), vector);
                out.put(vector);
            }
            Quantity::HamelBias => {
                shape.moving(inputs[1]).hamel_bias(twist(inputs[2]), vector);
                out.put(vector);
            }
            Quantity::Curvature => {
                shape.curvature(curvature);
                out.put_all(curvature.angular.each_ref().map(|layer| layer.as_slice()));
                out.put(curvature.com.as_slice());
            }
            Quantity::Momentum => {
                out.put(&shape.body_momentum(twist(inputs[1])).to_array());
                out.put(&shape.centroidal_momentum(twist(inputs[1])).to_array());
            }
            Quantity::VelocityOfMomentum => out.put(&shape.velocity_of_momentum(wrench(inputs[1])).to_array()),
            Quantity::BaseTwist => out.put(&shape.moving(inputs[1]).base_twist(twist(inputs[2])).to_array()),
            Quantity::KineticEnergy => out.put(&[shape.moving(inputs[1]).kinetic_energy(twist(inputs[2]))]),
            Quantity::ForwardDynamics => {
                put_xi_dot(&mut shape.moving(inputs[1]), &inputs[2..], vector, &mut out);
            }
            Quantity::StateRate => {
                let mut moving = shape.moving(inputs[1]);
                out.put(&moving.base_twist(twist(inputs[2])).to_array());
                put_xi_dot(&mut moving, &inputs[2..], vector, &mut out);
            }
            Quantity::InverseDynamics => {
                let (mu, gravity) = (twist(inputs[2]), inputs[3]);
                vector.copy_from_slice(inputs[4]);
                (0..3).for_each(|i| vector[3 + i] -= gravity[i]);
                out.put(&shape.moving(inputs[1]).inverse_dynamics(mu, vector, torque).to_array());
                out.put(torque);
            }
            Quantity::Kinematics(link) => {
                let pose = shape.link_pose(link);
                out.put_all([pose.rotation.as_slice(), pose.translation.as_slice()]);
                shape.generalized_jacobian(link, six_rows);
                out.put(six_rows.as_slice());
            }
        }
        assert!(out.slices.next().is_none(), "{SIZES}");
    }
}

const SIZES: &str = "inputs and outputs must be those that the quantity lists, each of its length";

fn twist<T: Real>(numbers: &[T]) -> Twist<T> {
    Twist::from_array(std::array::from_fn(|i| numbers[i]))
}

fn wrench<T: Real>(numbers: &[T]) -> Wrench<T> {
    Wrench::from_array(std::array::from_fn(|i| numbers[i]))
}

fn put_inertia<T: Real>(
    shape: &mut Shape<'_, '_, T>,
    six_rows: &mut Matrix6xX<T>,
    square: &mut DMatrix<T>,
    out: &mut Outputs<'_, '_, T>,
) {
    out.put(shape.locked_inertia().to_matrix().as_slice());
    shape.connection(six_rows);
    out.put(six_rows.as_slice());
    shape.shape_inertia(square);
    out.put(square.as_slice());
}

/// ξ̇ of `[μ, γ, F₁, τ]`.
fn put_xi_dot<T: Real>(
    moving: &mut Moving<'_, '_, '_, T>,
    inputs: &[&[T]],
    vector: &mut [T],
    out: &mut Outputs<'_, '_, T>,
) {
    let (mu, gravity, base_wrench, tau) = (twist(inputs[0]), inputs[1], wrench(inputs[2]), inputs[3]);
    moving.forward_dynamics_articulated(mu, base_wrench, tau, vector);
    (0..3).for_each(|i| vector[3 + i] += gravity[i]);
    out.put(vector);
}

/// The outputs that have not been written yet.
struct Outputs<'o, 's, T> {
    slices: std::slice::IterMut<'o, &'s mut [T]>,
}

impl<T: Real> Outputs<'_, '_, T> {
    /// Writes the next output.
    fn put(&mut self, numbers: &[T]) {
        self.put_all([numbers]);
    }

    /// Writes the next output from its parts, one after the other. Adding 0 makes 0 of −0.
    fn put_all<const N: usize>(&mut self, parts: [&[T]; N]) {
        let slice = self.slices.next().expect(SIZES);
        assert_eq!(slice.len(), parts.iter().map(|part| part.len()).sum::<usize>(), "{SIZES}");
        let mut rest: &mut [T] = slice;
        for part in parts {
            let (written, after) = rest.split_at_mut(part.len());
            written.iter_mut().zip(part).for_each(|(entry, &number)| *entry = number + T::zero());
            rest = after;
        }
    }
}
