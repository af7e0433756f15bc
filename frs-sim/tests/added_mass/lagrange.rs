//! The accelerations are those of Lagrange's equations for robot and water, written densely.

use frs_core::derivatives::Dual;
use frs_core::spatial::{Twist, Wrench};
use frs_core::{Model, Real, Workspace};
use frs_sim::effects::AddedMass;
use frs_sim::integrate::Tangent;
use frs_sim::run::equations;
use nalgebra::Matrix6xX;

use super::{ROUNDING, SWING, WATER, added, momentum, satellite, scene};

/// What moves.
pub struct Moved<T: Real> {
    pub base_twist: Twist<T>,
    pub q: Vec<T>,
    pub qd: Vec<T>,
}

/// The gradient of the energy of robot and water in `[V₁; q̇]` or, where `of_shape`, in q.
///
/// Dense: link by link from plain Jacobians; gradients by a dual number for each direction.
pub fn gradient<T: Real>(
    model: &Model<Dual<T>>,
    added: &[AddedMass],
    rotors: f64,
    at: &Moved<T>,
    of_shape: bool,
) -> Vec<T> {
    let n = at.q.len();
    let directions = if of_shape { n } else { 6 + n };
    let along = |direction: usize| {
        let rate = |of: usize| if of == direction { T::one() } else { T::zero() };
        let base = at.base_twist.to_array();
        let dual = |values: &[T], from: Option<usize>| -> Vec<Dual<T>> {
            let each = values.iter().enumerate();
            each.map(|(i, x)| Dual::new(*x, from.map_or(T::zero(), |from| rate(from + i)))).collect()
        };
        let (of_base, of_q, of_qd) = if of_shape { (None, Some(0), None) } else { (Some(0), None, Some(6)) };
        let (base, q, qd) = (dual(&base, of_base), dual(&at.q, of_q), dual(&at.qd, of_qd));
        let base = Twist::from_array(std::array::from_fn(|i| base[i]));
        let mut work = Workspace::new(model);
        let shape = work.shape(&q);
        let mut jacobian = Matrix6xX::zeros(n);
        let mut twice = Dual::from(T::zero());
        let mut twist_of = |link: usize| {
            shape.link_jacobian(link, &mut jacobian);
            let columns = jacobian.column_iter().zip(&qd);
            let own = columns.map(|(column, &qd)| Twist::from_array(std::array::from_fn(|i| column[i])) * qd);
            own.fold(shape.link_pose(link).act_inverse(base), |sum, column| sum + column)
        };
        for (number, link) in model.links().iter().enumerate() {
            let twist = twist_of(number);
            twice += twist.dot(link.inertial.momentum(twist));
        }
        for added in added {
            let twist = twist_of(added.link);
            twice += twist.dot(momentum(added, twist));
        }
        qd.iter().for_each(|&qd| twice += qd * qd * Dual::from_f64(rotors));
        (twice * Dual::from_f64(0.5)).derivative
    };
    (0..directions).map(along).collect()
}

/// `d/dt ∂T/∂V₁ = ad_{V₁}ᵀ ∂T/∂V₁ + F₁` and `d/dt ∂T/∂q̇ − ∂T/∂q = τ` with the energy T of robot and water.
#[test]
fn accelerations_obey_lagranges_equations_of_the_whole() {
    let model = satellite();
    let dual: Model<Dual<f64>> = model.cast();
    let twice_dual: Model<Dual<Dual<f64>>> = model.cast();
    let joints = "[joint_torque]\ntau = [1, -2, 0.5, 0.3, -0.4, 0.2, 0.1]\n";
    let force = "[wrench]\nmoment = [1, 2, 3]\nforce = [4, -5, 6]\n";
    for (rotors, text) in [
        (0.0, format!("{SWING}{force}{joints}{WATER}")),
        (0.2, format!("{SWING}{force}{joints}[rotors]\ninertia = 0.2\n{WATER}")),
    ] {
        let scene = scene(&model, &text);
        let added = added(&model, &text);
        let mut equations = equations::<f64>(&scene, &model, 0.0);
        let state = equations.start(&scene.start);
        let mut rate = Tangent::zero(state.flat.len());
        equations.rate(0.0, &state, &mut rate);

        // Along the motion: each number with its rate.
        let numbers: Vec<Dual> = state.flat.iter().zip(&rate.flat).map(|(x, rate)| Dual::new(*x, *rate)).collect();
        let mut work = Workspace::new(&dual);
        let mu = Twist::from_array(std::array::from_fn(|i| numbers[14 + i]));
        let base_twist = work.shape(&numbers[..7]).moving(&numbers[7..14]).base_twist(mu);
        let along = Moved { base_twist, q: numbers[..7].to_vec(), qd: numbers[7..14].to_vec() };
        let momenta = gradient(&twice_dual, &added, rotors, &along, false);
        let values = |all: &[Dual]| all.iter().map(|x| x.value).collect::<Vec<_>>();
        let twist = Twist::from_array(base_twist.to_array().map(|x| x.value));
        let here = Moved { base_twist: twist, q: values(&along.q), qd: values(&along.qd) };
        let pushed = gradient(&dual, &added, rotors, &here, true);

        let base = Wrench::from_array(std::array::from_fn(|i| momenta[i].value));
        let turned = twist.ad_transpose(base) + Wrench::from_array([1.0, 2.0, 3.0, 4.0, -5.0, 6.0]);
        let torques = [1.0, -2.0, 0.5, 0.3, -0.4, 0.2, 0.1];
        let shape = pushed.iter().zip(torques).map(|(pushed, tau)| pushed + tau);
        for (i, (momentum, expected)) in momenta.iter().zip(turned.to_array().into_iter().chain(shape)).enumerate() {
            let error = (momentum.derivative - expected).abs();
            assert!(error < 10.0 * ROUNDING, "{i}: {} {expected}, {error:e}", momentum.derivative);
        }
    }
}
