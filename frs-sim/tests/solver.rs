//! However a scene is computed, it is the same motion.

use std::ops::ControlFlow;

use frs_core::{Model, urdf};
use frs_sim::integrate::{Method, Steps};
use frs_sim::run::{End, Record, resume, run};
use frs_sim::scene::{EQUATIONS, ROUTES, Scene, Solver};

/// A tumbling satellite whose arm is pulled, pushed and held: momentum changes during the pulse.
const PUSHED: &str = "robot = 'lwr_satellite.urdf'
duration = 0.4
samples_per_second = 10
[start]
q = { joint_4 = 1 }
qd = { joint_3 = 1 }
momentum = [0.3, 0.2, 0.1, 1, 0, 0]
[gravity]
acceleration = [0, 0, -9.81]
[spring]
stiffness = 0.3
";

const PULSE: &str = "[wrench]\nforce = [3, 0, 4]\nmoment = [1, 2, 0]\naxes = 'world'\nstart = 0.12\nend = 0.32\n";

/// Joints that follow a course and joints that turn rotors.
const DRIVEN: &str = "[rotors]\ninertia = 0.05\n[[prescribed]]\njoint = 'joint_2'\nsinusoid = { offset = 0.5, amplitude = 0.3, rate = 4 }\n";

/// What the hand and the base set in motion.
const WATER: &str = "[[added_mass]]\nlink = 'link_7'\ninertia = [0.1, 0.1, 0.1, 1, 2, 3]\n[[added_mass]]\nlink = 'base'\ninertia = [0.1, 0.2, 0.3, 2, 3, 4]\n";

/// A body is taken, and let go.
const PAYLOAD: &str = "[payload]\nlink = 'link_7'\nmass = 3\ninertia = [0.1, 0.1, 0.1, 0, 0, 0]\ngrasp = 0.1\nrelease = 0.3\ntwist = [0.1, 0, 0, 0, 0.2, 0]\n";

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn computed(text: &str, solver: Solver) -> Record {
    let model = model();
    let scene = Scene::parse("scene.toml", text, &model).unwrap_or_else(|error| panic!("{error}"));
    let record = run(&Scene { solver, ..scene }, &model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole, "{solver:?}");
    record
}

/// The largest difference of shapes, positions and orientations.
fn apart(one: &Record, other: &Record) -> f64 {
    assert_eq!(one.samples.len(), other.samples.len());
    let mut largest = 0.0_f64;
    for (one, other) in one.samples.iter().zip(&other.samples) {
        assert_eq!(one.time, other.time);
        let turn = one.pose.rotation - other.pose.rotation;
        let move_ = one.pose.translation - other.pose.translation;
        let shape = one.q.iter().zip(&other.q).map(|(a, b)| a - b);
        let all = turn.iter().chain(&move_).copied().chain(shape);
        largest = all.fold(largest, |largest, x| largest.max(x.abs()));
    }
    largest
}

fn accurate(text: &str) -> Record {
    computed(text, Solver { steps: Steps::Accuracy(1e-13), ..Solver::default() })
}

#[test]
fn every_set_of_equations_and_every_route_gives_one_motion() {
    /// A few hundred steps, each off by 1e-13 of a state of order one.
    const ACCUMULATED: f64 = 1e-10;
    for text in [
        PUSHED.to_owned(),
        format!("{PUSHED}{PULSE}"),
        format!("{PUSHED}{DRIVEN}"),
        format!("{PUSHED}{PULSE}{DRIVEN}"),
        format!("{PUSHED}{PAYLOAD}"),
        format!("{PUSHED}{WATER}"),
        format!("{PUSHED}{PULSE}{DRIVEN}{WATER}"),
    ] {
        let expected = accurate(&text);
        for (name, equations) in EQUATIONS {
            for (way, route) in ROUTES {
                let steps = Steps::Accuracy(1e-13);
                let found = computed(&text, Solver { steps, equations, route, ..Solver::default() });
                let error = apart(&found, &expected);
                assert!(error < ACCUMULATED, "{name}, {way}: {error:e}\n{text}");
            }
        }
    }
}

/// With half the step, the error of a method of order p is 2ᵖ times smaller, across events that cut no step short.
#[test]
fn errors_fall_with_the_step_as_the_order_says() {
    /// What the next power of the step still contributes.
    const ORDER_TOLERANCE: f64 = 0.35;
    let text = format!("{PUSHED}{PULSE}");
    let expected = accurate(&text);
    for method in Method::ALL {
        // Long enough for the error to stand above rounding, short enough for its leading power to stand out.
        let step = [2e-4, 2e-4, 4e-3, 4e-3, 0.01, 0.01, 0.04][Method::ALL.iter().position(|m| *m == method).unwrap()];
        let errors = [step, step / 2.0].map(|step| {
            apart(&computed(&text, Solver { method, steps: Steps::Length(step), ..Solver::default() }), &expected)
        });
        let order = (errors[0] / errors[1]).log2();
        assert!(order > method.order() as f64 - ORDER_TOLERANCE, "{}: {errors:?}, order {order}", method.name());
    }
}

#[test]
fn a_run_of_uniform_steps_that_goes_on_is_the_one_that_was_not_stopped() {
    let text = format!("{PUSHED}{PULSE}");
    let model = model();
    let scene = Scene::parse("scene.toml", &text, &model).unwrap();
    for method in Method::ALL {
        let scene = Scene { solver: Solver { method, steps: Steps::Length(7e-3), ..scene.solver }, ..scene.clone() };
        let whole = run(&scene, &model, |_| ControlFlow::Continue(()));
        let mut left = 20;
        let stopped = run(&scene, &model, |_| {
            left -= 1;
            if left > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert_eq!(stopped.end, End::Stopped);
        assert_eq!(resume(&scene, &model, stopped, |_| ControlFlow::Continue(())), whole, "{}", method.name());
    }
}
