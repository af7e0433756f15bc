//! Nothing moves: zero is exactly zero. And hardly: velocities below 10⁻³⁰⁸, of which doubles keep fewer digits.

use frs::spatial::{Twist, Wrench};
use frs::{Evaluator, Model, Quantity, Workspace, urdf};

use crate::judge::answer;
use crate::random_robots::robot;
use crate::state::State;

const ROBOTS: u64 = 100;

/// Takes numbers of size 1 to where 2³⁴ steps of the last digit are left of 2⁵³.
const SMALL: f64 = 1e-313;

/// Steps of the last digit by which a result may be off: as many as operations that make an entry, each weighed by masses and lengths
/// of at most a hundred.
const STEPS: f64 = 1e5;

/// Inputs that are velocities, with their lengths.
fn velocities(n: usize) -> [(&'static str, usize); 4] {
    [("qd", n), ("mu", 6), ("base_twist", 6), ("body_momentum", 6)]
}

fn at_rest(state: State, n: usize) -> State {
    velocities(n).into_iter().fold(state, |state, (name, length)| state.with(name, vec![0.0; length]))
}

/// Quantities that vanish with the velocities.
const OF_MOTION: [Quantity; 11] = [
    Quantity::DMu,
    Quantity::B2,
    Quantity::DQdot,
    Quantity::CouplingTorque,
    Quantity::DMuXi,
    Quantity::DQdotXi,
    Quantity::HamelBias,
    Quantity::Momentum,
    Quantity::VelocityOfMomentum,
    Quantity::BaseTwist,
    Quantity::KineticEnergy,
];

#[test]
fn without_velocity_all_that_depends_on_it_is_zero() {
    for seed in 0..ROBOTS {
        let model = robot(seed);
        let state = at_rest(State::random(seed), model.dof());
        let mut robot = Evaluator::new(&model);
        for quantity in OF_MOTION {
            let answers = answer(&mut robot, quantity, &state);
            assert!(answers.iter().flatten().all(|&x| x == 0.0), "robot {seed}, {quantity:?}: {answers:?}");
        }
    }
}

/// A robot at rest on which nothing acts does not accelerate, by neither way: a motion from rest stays where it is, bit for bit.
#[test]
fn without_velocity_and_forces_nothing_accelerates() {
    for seed in 0..ROBOTS {
        let model = robot(seed);
        let n = model.dof();
        let rest = at_rest(State::random(seed), n).with("gravity", vec![0.0; 3]);
        let state = rest.with("base_wrench", vec![0.0; 6]).with("tau", vec![0.0; n]).with("xi_dot", vec![0.0; 6 + n]);
        let mut robot = Evaluator::new(&model);
        for quantity in [Quantity::ForwardDynamics, Quantity::InverseDynamics] {
            let answers = answer(&mut robot, quantity, &state);
            assert!(answers.iter().flatten().all(|&x| x == 0.0), "robot {seed}, {quantity:?}: {answers:?}");
        }
        let mut xi_dot = vec![f64::NAN; 6 + n];
        let mut work = Workspace::new(&model);
        let mut shape = work.shape(&state.numbers("q", n));
        shape.moving(&vec![0.0; n]).forward_dynamics(Twist::zero(), Wrench::zero(), &vec![0.0; n], &mut xi_dot);
        assert!(xi_dot.iter().all(|&x| x == 0.0), "robot {seed}: {xi_dot:?}");
    }
}

/// Quantities that are linear in velocities: of `s v` they are s times what they are of v.
const LINEAR: [Quantity; 6] = [
    Quantity::DMu,
    Quantity::B2,
    Quantity::DQdot,
    Quantity::Momentum,
    Quantity::VelocityOfMomentum,
    Quantity::BaseTwist,
];

/// Quantities that are quadratic in velocities.
const QUADRATIC: [Quantity; 5] =
    [Quantity::CouplingTorque, Quantity::DMuXi, Quantity::DQdotXi, Quantity::HamelBias, Quantity::KineticEnergy];

#[test]
fn denormal_velocities_give_what_they_should() {
    let default = Model::from_urdf(urdf::LWR_SATELLITE).expect("the robot is well formed");
    for seed in 0..ROBOTS {
        let model = if seed == 0 { default.clone() } else { robot(seed) };
        let n = model.dof();
        let state = State::random(seed);
        let slow = velocities(n).into_iter().fold(state.clone(), |slow, (name, length)| {
            slow.with(name, state.numbers(name, length).iter().map(|x| SMALL * x).collect())
        });
        let mut robot = Evaluator::new(&model);
        let step = f64::from_bits(1);
        for quantity in LINEAR {
            let (fast, slow) =
                (answer(&mut robot, quantity, &state).concat(), answer(&mut robot, quantity, &slow).concat());
            // Not of the size of an entry but of the size of what makes it.
            let size = fast.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
            for (fast, slow) in fast.iter().zip(&slow) {
                let off = (slow - SMALL * fast).abs();
                let allowed = STEPS * step.max(SMALL * size * f64::EPSILON);
                assert!(off <= allowed, "robot {seed}, {quantity:?}: {slow:e} and {fast:e}");
            }
        }
        for quantity in QUADRATIC {
            let answers = answer(&mut robot, quantity, &slow).concat();
            assert!(answers.iter().all(|x| x.abs() <= STEPS * step), "robot {seed}, {quantity:?}: {answers:?}");
        }
    }
}
