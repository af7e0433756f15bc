//! Scenes: those of `scenes/` run, and what a scene does not name costs nothing.

use std::ops::ControlFlow;

use frs_codegen::Counts;
use frs_codegen::record::{Recorded, record};
use frs_core::spatial::Wrench;
use frs_core::{Model, Workspace, urdf};
use frs_sim::integrate::{State, Steps, Tangent};
use frs_sim::run::{End, Record, Sample, equations, resume, run};
use frs_sim::scene::{Case, Scene};
use nalgebra::Vector3;

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

const HEAD: &str = "robot = 'lwr_satellite.urdf'\nduration = 0.5\n";

fn scene(rest: &str) -> Scene {
    Scene::parse("scene.toml", &format!("{HEAD}{rest}"), &model()).unwrap_or_else(|error| panic!("{error}"))
}

fn flown(scene: &Scene) -> Record {
    run(scene, &model(), |_| ControlFlow::Continue(()))
}

#[test]
fn every_scene_of_the_project_keeps_its_invariants() {
    /// Errors of steps add up over a motion of seconds.
    const ACCUMULATION: f64 = 1e3;
    /// Rounding of the momentum of an evaluation, relative.
    const ROUNDING: f64 = 1e-13;
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
    let mut cases = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let (name, text) = (path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (robot, _) = Scene::robot(&name, &text).unwrap();
        let urdf = std::fs::read_to_string(path.parent().unwrap().join(robot)).unwrap();
        let model = Model::from_urdf(&urdf).unwrap();
        let scene = Scene::parse(&name, &text, &model).unwrap_or_else(|error| panic!("{error}"));
        let record = run(&scene, &model, |_| ControlFlow::Continue(()));
        assert_eq!(record.end, End::Whole, "{name}");
        let (first, last) = (&record.samples[0], record.samples.last().unwrap());
        assert_eq!(last.time, scene.duration, "{name}");
        assert!(record.samples.iter().any(|sample| sample.q != first.q), "{name}: something happens");
        let Steps::Accuracy(accuracy) = scene.solver.steps else {
            panic!("{name}: steps as long as the accuracy allows")
        };
        for sample in &record.samples {
            let gained = sample.kinetic_energy - first.kinetic_energy;
            let size = sample.kinetic_energy.max(1.0);
            assert!((gained - sample.work()).abs() < ACCUMULATION * accuracy * size, "{name} at {}", sample.time);
            if scene.case() != Case::Driven && scene.handovers().is_empty() {
                // About the centre of mass; gravity changes the linear half in a way that is known.
                let fallen = match scene.case() {
                    Case::Ballistic => scene.gravity() * (scene.start.mass * sample.time),
                    _ => Vector3::zeros(),
                };
                let kept = sample.momentum.at(sample.com) - Wrench::new(Vector3::zeros(), fallen);
                let drift = (kept - scene.start.centroidal).to_array();
                let size = sample.momentum.to_array().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
                assert!(
                    drift.iter().all(|drift| drift.abs() <= ROUNDING * size),
                    "{name} at {}: {drift:?}",
                    sample.time
                );
            }
        }
        cases.push(scene.case());
    }
    assert!([Case::Zero, Case::Conserved, Case::Ballistic, Case::Driven].iter().all(|case| cases.contains(case)));
}

/// How a scene of the project ends.
fn end(name: &str) -> (Model, Record) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/");
    let text = std::fs::read_to_string(format!("{folder}{name}.toml")).unwrap();
    let (robot, _) = Scene::robot(name, &text).unwrap();
    let model = Model::from_urdf(&std::fs::read_to_string(format!("{folder}{robot}")).unwrap()).unwrap();
    let record = run(&Scene::parse(name, &text, &model).unwrap(), &model, |_| ControlFlow::Continue(()));
    (model, record)
}

/// The axis-angle vector from one sample's base to another's, degrees.
fn turn(from: &Sample, to: &Sample) -> Vector3<f64> {
    (from.pose.inverse() * to.pose).log().angular.map(f64::to_degrees)
}

#[test]
fn a_cat_lands_on_its_feet() {
    let (_, record) = end("falling_cat");
    let (first, last) = (&record.samples[0], record.samples.last().unwrap());
    let up = last.pose.rotation.column(2).z;
    assert!(first.pose.rotation.column(2).z < -0.999999 && up > 0.999999, "{up}");
    assert!((last.q[1] - first.q[1]).abs() < 1e-12 && (last.q[0] + last.q[2]).abs() < 1e-12);
    assert!((first.com.z - last.com.z - 0.5 * 9.81 * 0.36).abs() < 1e-12);
}

/// The turn of the base in one period of the gait, whatever the speed; each period adds another.
#[test]
fn an_arm_turns_its_base_by_the_same_angle_every_period() {
    /// What the springs of the joints that are held let them move: most in the first period, which begins at rest; degrees.
    const YIELDING: f64 = 0.6;
    let (_, record) = end("arm_gait");
    let at = |time: f64| record.samples.iter().find(|sample| sample.time >= time).unwrap();
    let period = std::f64::consts::TAU / 1.6;
    let turns = [0.0, period, 2.0 * period].map(|start| turn(at(start), at(start + period)));
    assert!(turns.iter().all(|turn| (turn.norm() - 45.7).abs() < YIELDING), "{turns:?}");
}

#[test]
fn a_hand_reaches_its_target() {
    let (model, record) = end("reach_target");
    let last = record.samples.last().unwrap();
    let hand = Workspace::new(&model).shape(&last.q).link_pose(model.link("link_7").unwrap());
    let target = Vector3::new(0.1, 0.05, 0.94);
    let left = |place: Vector3<f64>| (place - target).norm();
    let start = Workspace::new(&model).shape(&record.samples[0].q).link_pose(model.link("link_7").unwrap());
    let share = left((last.pose * hand).translation) / left(start.translation);
    assert!(share < 0.02, "{share}");
}

#[test]
fn a_quadruped_stands_after_its_landing() {
    let (_, record) = end("landing");
    let last = record.samples.last().unwrap();
    assert!(last.pose.rotation.column(2).z > 0.999 && (0.3..0.4).contains(&last.pose.translation.z));
    assert!(last.kinetic_energy < 0.05, "{}", last.kinetic_energy);
}

/// What the momentum does follows from what acts and from the start.
#[test]
fn the_momentum_case_is_derived() {
    let cases = [
        ("", Case::Zero),
        ("[start]\nq = { joint_2 = 1 }\nqd = { joint_1 = 1 }", Case::Zero),
        ("[start]\nmomentum = [0, 0, 0, 0, 0, 0]", Case::Zero),
        ("[spring]\nstiffness = 1\n[friction]\nviscous = 1", Case::Zero),
        ("[start]\nmu = [0, 0.1, 0, 0, 0, 0]", Case::Conserved),
        ("[start]\nbase_twist = [0, 0, 0, 0, 0, 0]\nqd = { joint_2 = 1 }", Case::Conserved),
        ("[gravity]\nacceleration = [0, 0, -9.81]", Case::Ballistic),
        ("[gravity]\nacceleration = [0, 0, -9.81]\n[wrench]\nforce = [1, 0, 0]", Case::Driven),
        ("[drag]\nlink = 'base'\ntranslational = [1, 1, 1]", Case::Driven),
        ("[[wrench]]\nforce = [1, 0, 0]\nstart = 0.1\nend = 0.2", Case::Driven),
    ];
    for (text, case) in cases {
        assert_eq!(scene(text).case(), case, "{text}");
    }
}

#[test]
fn three_ways_to_give_the_start_are_one_motion() {
    /// Rounding of a locked velocity of size 1.
    const ROUNDING: f64 = 1e-13;
    let shape = "[start]\npose = { position = [1, 2, 3], rpy = [0.1, 0.2, 0.3] }\nq = { joint_2 = 1 }\nqd = { joint_1 = 0.5 }\n";
    let start = scene(&format!("{shape}mu = [0.1, -0.2, 0.3, 0.4, 0.5, -0.6]")).start;
    let mut work = frs_core::Workspace::new(&model()).shape(&start.q).moving(&start.qd).base_twist(start.mu).to_array();
    for (way, six) in [("base_twist", work), ("momentum", start.momentum.to_array())] {
        let mu = scene(&format!("{shape}{way} = {six:?}")).start.mu;
        let apart = (mu - start.mu).to_array();
        assert!(apart.iter().all(|apart| apart.abs() < ROUNDING), "{way}: {apart:?}");
    }
    work[0] += 1.0;
    assert_ne!(scene(&format!("{shape}base_twist = {work:?}")).start.mu, start.mu);
}

/// Operations of one evaluation of a scene's equations.
fn operations(scene: &Scene) -> usize {
    let model = model();
    let (start, tape) = record(|| {
        let model: Model<Recorded> = model.cast();
        let mut state = State::origin(2 * model.dof() + scene.case().numbers());
        state.flat.iter_mut().zip(0..).for_each(|(number, i)| *number = Recorded::input(i));
        let mut out = Tangent::zero(state.flat.len());
        let mut equations = equations(scene, &model, 0.0);
        let time = Recorded::input(100);
        equations.rate(time, &state, &mut out);
        time.0
    });
    let mut counts = Counts::default();
    tape[start as usize..].iter().for_each(|operation| counts.count(*operation));
    counts.flops()
}

#[test]
fn an_effect_costs_its_own_operations_and_an_absent_one_none() {
    let n = 7;
    let none = operations(&scene(""));
    for (text, cost) in [
        ("[friction]\nviscous = 1", 2 * n),
        ("[spring]\nstiffness = 1", 3 * n),
        ("[joint_torque]\ntau = [1, 1, 1, 1, 1, 1, 1]", n),
        ("[joint_torque]\ntau = { joint_2 = 1 }", 1),
        ("[friction]\ncoulomb = 1", 6 * n),
        ("[stops]\nstiffness = 1", 0),
        // h_v + (m a)(t − 0), and μ that follows: what a conserved momentum costs.
        ("[gravity]\nacceleration = [0, 0, -9.81]", operations(&scene("[start]\nmu = [1, 0, 0, 0, 0, 0]")) - none + 8),
        ("[regulator]\nset_point = {}\nstiffness = 1\ndamping = 1", 5 * n),
    ] {
        assert_eq!(operations(&scene(text)), none + cost, "{text}");
    }
    let pulse = "[wrench]\nforce = [1, 0, 0]\nstart = 0.2\nend = 0.3";
    let always = "[wrench]\nforce = [1, 0, 0]";
    assert_eq!(operations(&scene(always)), operations(&scene(pulse)) + 6, "a pulse costs nothing before it begins");
    // On the whole robot a wrench is six additions; on a link it is carried to the base and past each joint on the way.
    let on_link = |link: usize| operations(&scene(&format!("[wrench]\nforce = [1, 0, 0]\nlink = 'link_{link}'")));
    let joint = on_link(3) - on_link(2);
    assert_eq!((on_link(7) - on_link(2), joint > 0), (5 * joint, true));
    // With joints on a course there is less to solve, and none of it if all are.
    let held = |joints: usize| {
        let each = (1..=joints).map(|j| format!("[[prescribed]]\njoint = 'joint_{j}'\nhold = 0.1\n"));
        operations(&scene(&each.collect::<String>()))
    };
    assert!(held(7) < none && held(7) < held(6), "{} {} {none}", held(7), held(6));
    // Momentum that is conserved is one solve more than momentum that is zero.
    let conserved = operations(&scene("[start]\nmomentum = [1, 0, 0, 0, 0, 0]"));
    assert!(conserved > none, "{conserved} > {none}");
}

const SWING: &str = "[start]\nq = { joint_2 = 0.5 }\nqd = { joint_3 = 1 }\nmomentum = [0.3, 0.2, 0.1, 0, 0, 0]\n";

#[test]
fn joint_effects_of_size_zero_change_no_bit() {
    let without = flown(&scene(SWING));
    assert!(without.samples.last().unwrap().q.iter().all(|q| *q != 0.0));
    for zero in [
        "[friction]\nviscous = 0",
        "[spring]\nstiffness = 0",
        "[joint_torque]\ntau = {}",
        "[regulator]\nset_point = {}\nstiffness = 0\ndamping = 0",
    ] {
        let mut with = flown(&scene(&format!("{SWING}{zero}")));
        with.checkpoint.state.flat.truncate(without.checkpoint.state.flat.len());
        for sample in &mut with.samples {
            assert_eq!(std::mem::take(&mut sample.works), [0.0], "{zero}");
        }
        assert_eq!(with, without, "{zero}");
    }
}

/// Here μ is integrated instead of computed, with steps of other lengths: equal to the accuracy.
#[test]
fn effects_on_the_momentum_of_size_zero_change_the_motion_by_its_accuracy() {
    const ACCURACY: f64 = 1e-6;
    let without = flown(&scene(SWING));
    for zero in ["[gravity]\nacceleration = [0, 0, 0]", "[wrench]\nforce = [0, 0, 0]\nstart = 0.1\nend = 0.3"] {
        let with = flown(&scene(&format!("{SWING}{zero}")));
        for (one, other) in with.samples.iter().zip(&without.samples) {
            let apart = one.q.iter().zip(&other.q).fold(0.0, |apart: f64, (a, b)| apart.max((a - b).abs()));
            assert!(apart < ACCURACY, "{zero} at {}: {apart:e}", one.time);
        }
    }
}

/// A wrench of the world and the same in base axes are one at the start; a pulse acts between its times and nowhere else.
#[test]
fn a_pulse_changes_the_momentum_by_force_times_time() {
    /// Sums of a few hundred rounded steps.
    const ROUNDING: f64 = 1e-9;
    let record =
        flown(&scene(&format!("{SWING}[wrench]\nforce = [3, 0, 4]\naxes = 'world'\nstart = 0.123\nend = 0.321")));
    let change = |time: f64| {
        let sample = record.samples.iter().rfind(|sample| sample.time <= time).unwrap();
        (sample.momentum - record.samples[0].momentum).force
    };
    assert!(change(0.123).norm() < ROUNDING);
    for (time, expected) in [(0.2, 0.2 - 0.123), (0.4, 0.321 - 0.123), (0.5, 0.321 - 0.123)] {
        let error = (change(time) - nalgebra::Vector3::new(3.0, 0.0, 4.0) * expected).norm();
        assert!(error < ROUNDING, "{time}: {error:e}");
    }
}

#[test]
fn a_run_that_fails_or_is_stopped_keeps_what_it_has() {
    // The square of such a rate is no number.
    let wild = flown(&scene("[start]\nqd = { joint_2 = 1e200 }"));
    assert!(matches!(wild.end, End::Failed(_)), "{:?}", wild.end);
    assert_eq!(wild.samples[0].time, 0.0);

    let mut left = 2;
    let stopped = run(&scene(SWING), &model(), |_| {
        left -= 1;
        if left == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let whole = flown(&scene(SWING));
    let (last, kept) = stopped.samples.split_last().unwrap();
    assert_eq!((stopped.end, stopped.steps), (End::Stopped, 2));
    assert!(last.time < 0.5 && !kept.is_empty(), "{} samples until {} s", kept.len() + 1, last.time);
    assert_eq!(kept, &whole.samples[..kept.len()]);
}

/// Stopped again and again, and going on each time: the same samples and the same steps, bit for bit.
#[test]
fn a_run_that_goes_on_is_the_one_that_was_not_stopped() {
    for (name, every) in
        [("paper", 7), ("grasp", 23), ("landing", 311), ("falling_cat", 3), ("computed_torque", 29), ("observer", 9)]
    {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/");
        let text = std::fs::read_to_string(format!("{folder}{name}.toml")).unwrap();
        let (robot, _) = Scene::robot(name, &text).unwrap();
        let model = Model::from_urdf(&std::fs::read_to_string(format!("{folder}{robot}")).unwrap()).unwrap();
        let scene = Scene::parse(name, &text, &model).unwrap();
        let whole = run(&scene, &model, |_| ControlFlow::Continue(()));

        let stops = std::cell::Cell::new(0);
        let stopping = || {
            let mut left = every;
            let stops = &stops;
            move |_| {
                left -= 1;
                if left > 0 {
                    return ControlFlow::Continue(());
                }
                stops.set(stops.get() + 1);
                ControlFlow::Break(())
            }
        };
        let mut record = run(&scene, &model, stopping());
        while record.end == End::Stopped && record.checkpoint.time < scene.duration {
            record = resume(&scene, &model, record, stopping());
        }
        assert!(stops.get() > 4, "{name}: {}", stops.get());
        assert_eq!(record.samples, whole.samples, "{name}");
        assert_eq!((record.steps, record.checkpoint), (whole.steps, whole.checkpoint), "{name}");
    }
}
