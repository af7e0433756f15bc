//! Each effect does what its formula says, judged by motions that are known otherwise.

use std::ops::ControlFlow;

use frs_core::{Model, Workspace, urdf};
use frs_sim::run::{End, Record, Sample, run};
use frs_sim::scene::{Case, Scene};
use nalgebra::Vector3;

/// Errors of steps at the accuracy of these scenes add up over a second.
const ACCUMULATED: f64 = 1e-9;

/// Rounding of numbers of size 10.
const ROUNDING: f64 = 1e-13;

const HEAD: &str = "robot = 'x.urdf'\nduration = 1\naccuracy = 1e-11\n";

const GRAVITY: &str = "[gravity]\nacceleration = [0, 0, -10]\n";

const SWING: &str = "[start]\npose = { position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }\nq = { joint_2 = 0.5, joint_4 = 1 }\n\
                     qd = { joint_3 = 1, joint_5 = -0.5 }\nbase_twist = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

/// One body of 2 kg, its centre of mass at the origin of its frame.
fn ball() -> Model {
    let inertia = "<mass value='2'/><inertia ixx='0.1' iyy='0.2' izz='0.3' ixy='0' ixz='0' iyz='0'/>";
    Model::from_urdf(&format!("<robot name='ball'><link name='ball'><inertial>{inertia}</inertial></link></robot>"))
        .unwrap()
}

fn flown(model: &Model, text: &str) -> Record {
    let text = format!("{HEAD}{text}");
    let scene = Scene::parse("scene.toml", &text, model).unwrap_or_else(|error| panic!("{error}"));
    let record = run(&scene, model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole, "{text}");
    record
}

fn last(record: &Record) -> &Sample {
    record.samples.last().unwrap()
}

/// Where a point of a link is in the world.
fn place(model: &Model, sample: &Sample, link: &str, point: [f64; 3]) -> Vector3<f64> {
    let mut work = Workspace::new(model);
    let pose = work.shape(&sample.q).link_pose(model.link(link).unwrap());
    sample.pose.transform(pose.transform(point.into()))
}

#[test]
fn a_force_on_a_point_works_along_its_way_and_gives_its_impulse() {
    let (model, force, point) = (satellite(), Vector3::new(3.0, -1.0, 2.0), [0.1, 0.2, 0.3]);
    let text = format!("{SWING}[wrench]\nlink = 'link_6'\npoint = [0.1, 0.2, 0.3]\nforce = [3, -1, 2]\naxes = 'world'");
    let record = flown(&model, &text);
    let (first, last) = (&record.samples[0], last(&record));
    let way = place(&model, last, "link_6", point) - place(&model, first, "link_6", point);
    assert!((last.work() - force.dot(&way)).abs() < ACCUMULATED && way.norm() > 0.1);
    assert!((last.kinetic_energy - first.kinetic_energy - last.work()).abs() < ACCUMULATED);
    assert!(((last.momentum - first.momentum).force - force).norm() < ACCUMULATED);
}

/// A moment in the axes of a link and a force at its origin are what the same wrench is on the base, if the link is the base.
#[test]
fn a_wrench_on_the_base_by_name_is_one_on_the_base() {
    let model = satellite();
    let text = format!("{SWING}[wrench]\nmoment = [1, 2, 3]\nforce = [3, -1, 2]\nend = 0.5\n");
    let [by_name, plain] = ["link = 'base'\n", ""].map(|link| flown(&model, &format!("{text}{link}")));
    for (one, other) in by_name.samples.iter().zip(&plain.samples) {
        assert!((one.pose.translation - other.pose.translation).norm() < ACCUMULATED, "{}", one.time);
    }
}

#[test]
fn a_tabulated_torque_is_straight_from_point_to_point() {
    let text =
        "[joint_torque]\ntimes = [0.2, 0.6, 0.7]\ntau = [{ joint_2 = 0 }, { joint_2 = 0.4 }, { joint_2 = -0.1 }]";
    for sample in &flown(&satellite(), text).samples {
        let t = sample.time;
        let expected = match t {
            t if t < 0.2 => 0.0,
            t if t < 0.6 => t - 0.2,
            t if t < 0.7 => 0.4 - 5.0 * (t - 0.6),
            _ => -0.1,
        };
        assert!((sample.tau[1] - expected).abs() < ROUNDING, "{t}: {} {expected}", sample.tau[1]);
    }
}

#[test]
fn coulomb_friction_has_its_size_and_opposes() {
    let record = flown(&satellite(), &format!("{SWING}[friction]\ncoulomb = 0.05\nsmooth_below = 0.02\n"));
    for sample in &record.samples {
        for (tau, qd) in sample.tau.iter().zip(&sample.qd) {
            assert!((tau + 0.05 * qd / qd.hypot(0.02)).abs() < ROUNDING);
        }
    }
    let works: Vec<f64> = record.samples.iter().map(|sample| sample.work()).collect();
    assert!(works.windows(2).all(|pair| pair[1] < pair[0]));
}

/// `m v̇ = −d (v − u)`: the velocity approaches the fluid's.
#[test]
fn drag_slows_a_body_as_an_exponential() {
    let text = "[start]\nbase_twist = [0, 0, 0, 3, 0, 0]\n\
                [drag]\nlink = 'ball'\ntranslational = [4, 4, 4]\ncurrent = [1, 0, 0]";
    for sample in &flown(&ball(), text).samples {
        let expected = 1.0 + 2.0 * (-2.0 * sample.time).exp();
        assert!((sample.mu.linear.x - expected).abs() < ACCUMULATED, "{}: {}", sample.time, sample.mu.linear.x);
    }
}

/// Drops a ball from 0.2 m: what it has of its energy after the bounce. It is dropped at 0, touches the plane at 0.2 s, and leaves.
fn bounce(stiffness: f64, contact: &str) -> (Record, f64) {
    let start = "[start]\npose = { position = [0, 0, 0.7], rpy = [0, 0, 0] }\n";
    let contact = format!("[contact]\nlink = 'ball'\npoint = [0, 0, -0.5]\nstiffness = {stiffness}\n{contact}");
    let record = flown(&ball(), &format!("{start}{GRAVITY}{contact}"));
    let fast = record.samples.iter().filter(|sample| (0.3..0.35).contains(&sample.time));
    let energies: Vec<f64> = fast.map(|s| s.kinetic_energy + 2.0 * 10.0 * (s.pose.translation.z - 0.5)).collect();
    assert!(energies.len() > 3 && energies.iter().all(|energy| (energy - energies[0]).abs() < 1e-8));
    (record, energies[0] / (2.0 * 10.0 * 0.2))
}

#[test]
fn a_ball_bounces_without_loss_if_nothing_dissipates() {
    let (record, kept) = bounce(1e6, "");
    assert!((kept - 1.0).abs() < 1e-8, "{kept}");
    let z = |time: f64| record.samples.iter().find(|s| (s.time - time).abs() < 1e-9).unwrap().pose.translation.z;
    assert!((z(0.1) - (0.7 - 0.05)).abs() < ACCUMULATED);
    assert!(record.samples.iter().all(|sample| sample.pose.translation.z > 0.5 - 0.01), "it does not fall through");
}

/// Hunt and Crossley: the coefficient of restitution is `1 − ⅔ c v` to first order in `c v`; the ball's weight is nothing beside the
/// force of the bounce.
#[test]
fn dissipation_takes_what_the_coefficient_of_restitution_says() {
    const SPEED: f64 = 2.0;
    for c in [0.005, 0.01] {
        let (_, kept) = bounce(1e9, &format!("dissipation = {c}"));
        let restitution = kept.sqrt();
        let first_order = 1.0 - 2.0 / 3.0 * c * SPEED;
        assert!((restitution - first_order).abs() < (c * SPEED).powi(2), "{restitution} {first_order}");
        assert!(restitution < 1.0 - 0.5 * c * SPEED);
    }
}

/// A body that slides on a plane slows down by `f g`, once it has settled.
#[test]
fn friction_slows_a_sliding_body() {
    let depth = (2.0_f64 * 10.0 / 1e5).powf(2.0 / 3.0);
    let z = 0.5 - depth;
    // Three feet, so that it does not tip; each carries a third.
    let feet: String = [[0.3, 0.0], [-0.3, 0.3], [-0.3, -0.3]]
        .map(|[x, y]| {
            format!("[[contact]]\nlink = 'ball'\npoint = [{x}, {y}, -0.5]\nstiffness = 1e5\ndissipation = 1\nfriction = 0.1\nsmooth_below = 1e-3\n")
        })
        .concat();
    let text = format!(
        "[start]\npose = {{ position = [0, 0, {z}], rpy = [0, 0, 0] }}\nbase_twist = [0, 0, 0, 3, 0, 0]\n{GRAVITY}{feet}"
    );
    let record = flown(&ball(), &text);
    let velocity = |sample: &Sample| sample.pose.rotation * sample.mu.linear;
    let slowed = (velocity(&record.samples[50]) - velocity(last(&record))).x;
    assert!((slowed - 0.1 * 10.0 * 0.5).abs() < 0.02, "{slowed}");
}

#[test]
fn a_stop_gives_back_what_it_stores() {
    let model = satellite();
    let start = "[start]\nq = { joint_2 = 1.9 }\nqd = { joint_2 = 2 }\n";
    let record = flown(&model, &format!("{start}[stops]\nstiffness = 1e4\n"));
    let limit = model.coordinates()[1].limits.upper.unwrap();
    let beyond = |sample: &Sample| sample.q[1] > limit;
    let energy = |sample: &Sample| {
        sample.kinetic_energy
            + 0.5
                * 1e4
                * (0..7)
                    .map(|j| {
                        let limits = &model.coordinates()[j].limits;
                        let depth = (sample.q[j] - limits.upper.unwrap()).max(limits.lower.unwrap() - sample.q[j]);
                        depth.max(0.0).powi(2)
                    })
                    .sum::<f64>()
    };
    assert!(record.samples.iter().any(beyond) && !beyond(last(&record)), "it hits the stop and comes back");
    for sample in &record.samples {
        let off = (energy(sample) / energy(&record.samples[0]) - 1.0).abs();
        assert!(off < 1e-8, "{}: {off:e}", sample.time);
    }
}

#[test]
fn prescribed_joints_are_on_their_course_and_tell_its_torque() {
    let model = satellite();
    let mut text = "[start]\nmomentum = [0.3, 0.2, 0.1, 1, 2, 3]\n".to_owned();
    for joint in 1..=7 {
        text += &format!(
            "[[prescribed]]\njoint = 'joint_{joint}'\nsinusoid = {{ amplitude = 0.{joint}, rate = {joint}, phase = 0.2 }}\n"
        );
    }
    let mut work = Workspace::new(&model);
    for sample in &flown(&model, &text).samples {
        let at = |i: usize| (0.1 * (i + 1) as f64, (i + 1) as f64, (i + 1) as f64 * sample.time + 0.2);
        let qdd: Vec<f64> = (0..7).map(at).map(|(a, w, x)| -a * w * w * x.sin()).collect();
        for (i, (a, w, x)) in (0..7).map(at).enumerate() {
            assert!((sample.q[i] - a * x.sin()).abs() < ROUNDING && (sample.qd[i] - a * w * x.cos()).abs() < ROUNDING);
        }
        let mut tau = [0.0; 7];
        work.shape(&sample.q).moving(&sample.qd).shape_torque(sample.mu, &qdd, &mut tau);
        for (tau, found) in tau.iter().zip(&sample.tau) {
            assert!((tau - found).abs() < 1e-11, "{}: {tau} {found}", sample.time);
        }
    }
}

/// A joint that follows the course which it has taken without one needs no torque.
#[test]
fn a_joint_on_a_spline_passes_its_points() {
    let text =
        "[prescribed]\njoint = 'joint_3'\ntimes = [0.1, 0.4, 0.9]\nvalues = [0, 1.5, -0.5]\n[friction]\nviscous = 0.1";
    let record = flown(&satellite(), text);
    for (time, value) in [(0.05, 0.0), (0.1, 0.0), (0.4, 1.5), (0.9, -0.5), (1.0, -0.5)] {
        let sample = record.samples.iter().find(|sample| (sample.time - time).abs() < 1e-9).unwrap();
        assert!((sample.q[2] - value).abs() < ROUNDING, "{time}: {}", sample.q[2]);
    }
    assert!(last(&record).q.iter().all(|q| *q != 0.0), "the others are moved by it");
}

/// A rotor is energy and inertia: a spring swings slower with it, and keeps its energy.
#[test]
fn rotors_swing_slower_and_keep_the_energy() {
    let model = satellite();
    let text = "[start]\nq = { joint_7 = 0.5 }\n[spring]\nstiffness = 0.5\n";
    let [light, heavy] =
        ["", "[rotors]\ninertia = { joint_7 = 1.0 }\n"].map(|rotors| flown(&model, &format!("{text}{rotors}")));
    let energy = |sample: &Sample| sample.kinetic_energy + 0.25 * sample.q.iter().map(|q| q * q).sum::<f64>();
    for sample in &heavy.samples {
        assert!((energy(sample) - energy(&heavy.samples[0])).abs() < ACCUMULATED);
    }
    // A rotor that is much heavier than the hand swings as if it were alone.
    let alone = 0.5 * (0.5_f64).sqrt().cos();
    assert!((last(&heavy).q[6] - alone).abs() < 1e-3 && (last(&light).q[6] - alone).abs() > 0.02);
}

/// The error obeys `ë + 2 ω ė + ω² e = 0`, whatever the momentum: from rest it is `e₀ (1 + ω t) exp(−ω t)`.
#[test]
fn computed_torque_makes_oscillators_of_the_joints() {
    let text = "[start]\nq = { joint_2 = 0.5, joint_4 = -0.3 }\nmomentum = [0.5, 0.4, 0.3, 0, 0, 0]\n\
                [computed_torque]\nbandwidth = 4\nset_point = { joint_3 = 0.2 }";
    for sample in &flown(&satellite(), text).samples {
        let decay = (1.0 + 4.0 * sample.time) * (-4.0 * sample.time).exp();
        for (q, [start, goal]) in sample.q.iter().zip([[0.0; 2], [0.5, 0.0], [0.0, 0.2], [-0.3, 0.0]]) {
            let expected = goal + (start - goal) * decay;
            assert!((q - expected).abs() < ACCUMULATED, "{}: {q} {expected}", sample.time);
        }
    }
}

#[test]
fn a_hand_is_pulled_to_its_place_on_a_floating_base() {
    let model = satellite();
    let start = "[start]\nq = { joint_2 = 0.6, joint_4 = 1.2, joint_6 = -0.5 }\n";
    let rest = flown(&model, start);
    let from = place(&model, &rest.samples[0], "link_7", [0.0; 3]);
    let goal = from + Vector3::new(-0.05, 0.03, -0.05);
    let [x, y, z] = goal.into();
    let text = format!(
        "{start}[end_effector]\nlink = 'link_7'\nposition = [{x}, {y}, {z}]\nstiffness = 100\ndamping = 20\njoint_damping = 0.05\n"
    );
    let record = flown(&model, &text);
    // The hand's velocity is J̃ q̇: what damping takes is all that the energy of motion and pull loses.
    let away = |sample: &Sample| (place(&model, sample, "link_7", [0.0; 3]) - goal).norm();
    let energies: Vec<f64> = record.samples.iter().map(|s| s.kinetic_energy + 50.0 * away(s).powi(2)).collect();
    assert!(energies.windows(2).all(|pair| pair[1] < pair[0]));
    assert!(away(last(&record)) < 0.3 * away(&record.samples[0]), "{}", away(last(&record)));
    assert!((last(&record).pose.translation - record.samples[0].pose.translation).norm() > 1e-3, "the base gives way");
}

const TARGET: &str =
    "[payload]\nlink = 'link_7'\nmass = 8\ncom = [0.02, -0.03, 0.2]\ninertia = [0.1, 0.2, 0.15, 0.01, 0, -0.02]\n";

/// What is the same before and after: the momentum of robot and target about the world's origin, and the shape's.
#[test]
fn a_tumbling_target_brings_its_momentum() {
    let model = satellite();
    let twist = [0.3, -0.2, 0.4, 0.1, 0.2, -0.1];
    let text = format!("{SWING}[friction]\nviscous = 0.1\n{TARGET}grasp = 0.5\ntwist = {twist:?}\n");
    let record = flown(&model, &text);
    let (before, after) = (&record.samples[50], last(&record));
    assert!(before.time == 0.5 && record.samples.len() == 101);
    // The target about the world's origin, as it is taken.
    let link = model.link("link_7").unwrap();
    let mut work = Workspace::new(&model);
    let pose = before.pose * work.shape(&before.q).link_pose(link);
    let place = pose.transform(Vector3::new(0.02, -0.03, 0.2));
    let [turn, velocity] = [Vector3::from_column_slice(&twist[..3]), Vector3::from_column_slice(&twist[3..])];
    let inertia = nalgebra::Matrix3::new(0.1, 0.01, 0.0, 0.01, 0.2, -0.02, 0.0, -0.02, 0.15);
    let spin = pose.rotation * inertia * pose.rotation.transpose() * turn;
    let moment = spin + place.cross(&(velocity * 8.0));
    let gained = after.momentum - before.momentum;
    assert!((gained.force - velocity * 8.0).norm() < 1e-9, "{gained:?}");
    assert!((gained.moment - moment).norm() < 1e-9, "{gained:?} {moment:?}");
    // Energy that the target brings, less what is lost when both become one.
    let brought = 0.5 * (turn.dot(&spin) + 8.0 * velocity.norm_squared());
    let jump = record.samples[51].work() - before.work();
    assert!(jump < brought && jump > brought - 5.0, "{jump} of {brought}");
    let balance = after.kinetic_energy - record.samples[0].kinetic_energy - after.work();
    assert!(balance.abs() < ACCUMULATED * 10.0, "{balance:e}");
}

/// A body that moves with the hand is taken without a jump; let go at once, it leaves no trace but rounding.
#[test]
fn a_body_that_moves_along_is_taken_and_let_go_without_a_jump() {
    let model = satellite();
    let [alone, held] = ["".to_owned(), format!("{TARGET}grasp = 0.5\nrelease = 0.500001\n")]
        .map(|payload| flown(&model, &format!("{SWING}{payload}")));
    for (one, other) in alone.samples.iter().zip(&held.samples) {
        let apart = one.qd.iter().zip(&other.qd).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-4, "{}: {apart:e}", one.time);
    }
    let differ = last(&alone).qd != last(&held).qd;
    assert!(differ, "the hand carried it for a microsecond");
}

/// Held from the start it is part of the robot.
#[test]
fn a_payload_from_the_start_is_a_heavier_link() {
    let model = satellite();
    let link = &model.links()[model.link("link_7").unwrap()];
    let text = format!("{HEAD}{SWING}{TARGET}");
    let scene = Scene::parse("scene.toml", &text, &model).unwrap();
    let inertial = link.inertial.joined(scene.payloads().next().unwrap().inertial);
    let laden = model.with_inertial("link_7", inertial).unwrap();
    assert!(scene.handovers().is_empty() && (inertial.mass - link.inertial.mass - 8.0).abs() < ROUNDING);
    let [held, part] = [flown(&model, &format!("{SWING}{TARGET}")), flown(&laden, SWING)];
    assert_eq!(held.samples, part.samples);
}

#[test]
fn a_centre_of_mass_in_free_fall_is_on_a_parabola_and_the_shape_does_not_notice() {
    let model = satellite();
    let joints = "[spring]\nstiffness = 1\n[friction]\nviscous = 0.1\n";
    let [falling, free] = [GRAVITY, ""].map(|gravity| {
        let text = format!("{HEAD}{SWING}{joints}{gravity}");
        let scene = Scene::parse("scene.toml", &text, &model).unwrap();
        assert_eq!(scene.case(), if gravity.is_empty() { Case::Conserved } else { Case::Ballistic });
        (run(&scene, &model, |_| ControlFlow::Continue(())), scene.start)
    });
    let mut work = Workspace::new(&model);
    for (sample, other) in falling.0.samples.iter().zip(&free.0.samples) {
        let t = sample.time;
        let com = sample.pose.transform(work.shape(&sample.q).com());
        let start = &falling.1;
        let expected = start.com + start.centroidal.force * (t / start.mass) + Vector3::new(0.0, 0.0, -5.0 * t * t);
        assert!((com - expected).norm() < ROUNDING, "{t}");
        let about_com = sample.momentum.at(com) - other.momentum.at(other.pose.transform(work.shape(&other.q).com()));
        assert!(about_com.moment.norm() < ROUNDING * 10.0, "{t}: {about_com:?}");
        for (a, b) in sample.q.iter().zip(&other.q) {
            assert!((a - b).abs() < ACCUMULATED, "{t}");
        }
        assert!(
            (sample.kinetic_energy - falling.0.samples[0].kinetic_energy - sample.work()).abs() < ACCUMULATED * 100.0
        );
    }
}
