//! Added mass, judged by Kirchhoff's invariants, by Lagrange's equations of the whole, and by motions that are known otherwise.

use std::ops::ControlFlow;

use frs_core::derivatives::Dual;
use frs_core::extended::DoubleDouble;
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Real, Workspace, urdf};
use frs_sim::effects::AddedMass;
use frs_sim::integrate::{State, Tangent};
use frs_sim::run::{End, Record, Sample, equations, run};
use frs_sim::scene::{Case, Force, Scene};
use nalgebra::{Matrix6xX, Vector3};

/// Errors of steps at the accuracy of these scenes add up over a second.
const ACCUMULATED: f64 = 1e-9;

/// Rounding of one evaluation, relative.
const ROUNDING: f64 = 1e-12;

const HEAD: &str = "robot = 'x.urdf'\nduration = 1\naccuracy = 1e-11\n";

const SWING: &str = "[start]\npose = { position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }\nq = { joint_2 = 0.5, joint_4 = 1 }\n\
                     qd = { joint_3 = 1, joint_5 = -0.5 }\nbase_twist = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";

/// On three links: diagonal, about a point, and full.
const WATER: &str = "[[added_mass]]\nlink = 'base'\ninertia = [0.1, 0.2, 0.3, 4, 5, 6]\n\
                     [[added_mass]]\nlink = 'link_3'\ninertia = [0.01, 0.02, 0.03, 1, 2, 3]\npoint = [0.1, -0.2, 0.15]\n\
                     [[added_mass]]\nlink = 'link_7'\ninertia = [[0.3, 0.1, 0, 0.2, 0, 0.1], [0.1, 0.4, 0.1, 0, 0.1, 0], \
                     [0, 0.1, 0.2, 0, 0, 0.1], [0.2, 0, 0, 2, 0.3, 0.1], [0, 0.1, 0, 0.3, 3, 0.2], [0.1, 0, 0.1, 0.1, 0.2, 1]]\n";

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

/// One body of 2 kg, its centre of mass off the origin of its frame.
fn body() -> Model {
    let inertia = "<origin xyz='0.1 0.05 -0.1'/><mass value='2'/><inertia ixx='0.1' iyy='0.2' izz='0.25' ixy='0' ixz='0.02' iyz='0'/>";
    Model::from_urdf(&format!("<robot name='body'><link name='body'><inertial>{inertia}</inertial></link></robot>"))
        .unwrap()
}

const AROUND_BODY: &str =
    "[added_mass]\nlink = 'body'\ninertia = [0.05, 0.1, 0.02, 1, 3, 5]\npoint = [-0.1, 0.2, 0.1]\n";

fn scene(model: &Model, text: &str) -> Scene {
    Scene::parse("scene.toml", &format!("{HEAD}{text}"), model).unwrap_or_else(|error| panic!("{error}"))
}

fn flown(model: &Model, text: &str) -> Record {
    let record = run(&scene(model, text), model, |_| ControlFlow::Continue(()));
    assert_eq!(record.end, End::Whole, "{text}");
    record
}

fn added(model: &Model, text: &str) -> Vec<AddedMass> {
    let force = scene(model, text).forces.pop().unwrap().force;
    let Force::AddedMass(added, _) = force else { panic!("{text}") };
    added
}

/// `M_A V`, by its rows.
fn momentum<T: Real>(added: &AddedMass, twist: Twist<T>) -> Wrench<T> {
    let twist = twist.to_array();
    Wrench::from_array(
        added.inertia.map(|row| row.into_iter().zip(twist).fold(T::zero(), |sum, (m, v)| sum + T::from_f64(m) * v)),
    )
}

/// Energy of the water (J) and its momentum about the world's origin.
fn water(model: &Model, added: &[AddedMass], sample: &Sample) -> (f64, Wrench<f64>) {
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&sample.q);
    let robot = shape.moving(&sample.qd);
    added.iter().fold((0.0, Wrench::zero()), |(energy, sum), added| {
        let twist = robot.link_twist(added.link, sample.mu);
        let momentum = momentum(added, twist);
        let place = sample.pose * robot.link_pose(added.link);
        (energy + 0.5 * twist.dot(momentum), sum + place.act_wrench(momentum))
    })
}

/// In still water nothing changes the energy nor the momentum of robot and water, if nothing else acts: Kirchhoff's equations for one body,
/// the same for a robot whose arm swings.
#[test]
fn energy_and_momentum_of_robot_and_water_are_constant() {
    let turning =
        "[start]\npose = { position = [1, 2, 3], rpy = [0.3, -0.2, 0.5] }\nbase_twist = [2, 1, -1.5, 1, -2, 0.5]\n";
    for (model, text) in [(body(), format!("{turning}{AROUND_BODY}")), (satellite(), format!("{SWING}{WATER}"))] {
        let added = added(&model, &text);
        let record = flown(&model, &text);
        let whole = |sample: &Sample| {
            let (energy, momentum) = water(&model, &added, sample);
            (sample.kinetic_energy + energy, sample.momentum + momentum)
        };
        let (energy, momentum) = whole(&record.samples[0]);
        for sample in &record.samples {
            let now = whole(sample);
            assert!((now.0 / energy - 1.0).abs() < ACCUMULATED, "{}: {} {energy}", sample.time, now.0);
            let drift = (now.1 - momentum).to_array();
            assert!(drift.iter().all(|drift| drift.abs() < 10.0 * ACCUMULATED), "{}: {drift:?}", sample.time);
        }
        let last = record.samples.last().unwrap();
        let exchanged = (last.momentum - record.samples[0].momentum).to_array();
        assert!(exchanged.iter().all(|change| change.abs() > 0.01), "the robot's own changes: {exchanged:?}");
    }
}

/// The water's work is what its energy lost.
#[test]
fn the_work_of_the_water_is_its_energy() {
    let model = satellite();
    let text = format!("{SWING}[spring]\nstiffness = 2\n[rotors]\ninertia = 0.1\n{WATER}");
    let added = added(&model, &text);
    let names: Vec<String> = scene(&model, &text).works().into_iter().map(|work| work.name).collect();
    assert_eq!(names, ["spring", "added_mass"]);
    let record = flown(&model, &text);
    let start = water(&model, &added, &record.samples[0]).0;
    let mut most = 0.0_f64;
    for sample in &record.samples {
        let gained = water(&model, &added, sample).0 - start;
        assert!((sample.works[1] + gained).abs() < 10.0 * ACCUMULATED, "{}: {} {gained}", sample.time, sample.works[1]);
        let balance = sample.kinetic_energy - record.samples[0].kinetic_energy - sample.work();
        assert!(balance.abs() < 10.0 * ACCUMULATED, "{}: {balance:e}", sample.time);
        most = most.max(gained.abs());
    }
    assert!(most > 0.05, "{most}");
}

/// What moves.
struct Moved<T: Real> {
    base_twist: Twist<T>,
    q: Vec<T>,
    qd: Vec<T>,
}

/// The gradient of the energy of robot and water in `[V₁; q̇]` or, where `of_shape`, in q.
///
/// Dense: link by link from plain Jacobians; gradients by a dual number for each direction.
fn gradient<T: Real>(
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

/// A light sphere (½ ρ V, the water that it displaces is ρ V) rises with `(ρ V − m) g / (m + ½ ρ V)`.
#[test]
fn a_light_sphere_rises_as_half_the_displaced_water_lets_it() {
    let model = body();
    let (displaced, gravity) = (8.0, 10.0);
    // Both act at the centre of mass, about which the sphere is round.
    let text = format!(
        "[gravity]\nacceleration = [0, 0, -{gravity}]\n[wrench]\nforce = [0, 0, {}]\naxes = 'world'\npoint = [0.1, 0.05, -0.1]\n\
         [added_mass]\nlink = 'body'\ninertia = [0, 0, 0, {m}, {m}, {m}]\npoint = [0.1, 0.05, -0.1]\n",
        displaced * gravity,
        m = 0.5 * displaced
    );
    assert_eq!(scene(&model, &text).case(), Case::Driven);
    let acceleration = (displaced - 2.0) * gravity / (2.0 + 0.5 * displaced);
    for sample in &flown(&model, &text).samples {
        let risen = sample.com.z - -0.1;
        assert!((risen - 0.5 * acceleration * sample.time.powi(2)).abs() < ACCUMULATED, "{}: {risen}", sample.time);
    }
}

/// In a frame that moves with the water, the water is still.
#[test]
fn a_current_carries_the_motion_of_still_water() {
    let (model, current) = (satellite(), Vector3::new(0.5, -0.3, 0.2));
    let still = flown(&model, &format!("{SWING}{WATER}"));
    let rotation = Pose::from_rpy(Vector3::zeros(), [0.3, -0.2, 0.5]).rotation;
    let [x, y, z]: [f64; 3] = (Vector3::new(0.4, -0.2, 0.1) + rotation.transpose() * current).into();
    let carried = SWING.replace("0.4, -0.2, 0.1]", &format!("{x}, {y}, {z}]"));
    let moving = WATER.replace("\ninertia", "\ncurrent = [0.5, -0.3, 0.2]\ninertia");
    assert!(carried != SWING && moving != WATER);
    let carried = flown(&model, &format!("{carried}{moving}"));
    for (one, other) in carried.samples.iter().zip(&still.samples) {
        let way = one.pose.translation - other.pose.translation - current * one.time;
        let turned = (one.pose.rotation - other.pose.rotation).amax();
        let apart = one.q.iter().zip(&other.q).fold(turned.max(way.amax()), |most, (a, b)| most.max((a - b).abs()));
        assert!(apart < ACCUMULATED, "{}: {apart:e}", one.time);
    }
}

/// Wrenches of 0 are added: what is driven anyhow does not change by a bit.
#[test]
fn added_mass_of_size_zero_changes_no_bit() {
    let model = satellite();
    let nothing = "[added_mass]\nlink = 'link_3'\ninertia = [0, 0, 0, 0, 0, 0]\n";
    for rest in [
        "[gravity]\nacceleration = [0, 0, -9.81]\n[wrench]\nforce = [1, 2, 3]\n",
        "[drag]\nlink = 'link_5'\ntranslational = [1, 2, 3]\n[rotors]\ninertia = 0.1\n[prescribed]\njoint = 'joint_2'\nhold = 0.5\n",
        "[solver]\nequations = 'hamel'\n[spring]\nstiffness = 1\n",
        "[solver]\nequations = 'integrated'\nroute = 'articulated'\n[spring]\nstiffness = 1\n",
    ] {
        let [without, mut with] = ["", nothing].map(|water| flown(&model, &format!("{SWING}{rest}{water}")));
        assert_eq!((with.steps, with.samples.len()), (without.steps, without.samples.len()));
        for (sample, other) in with.samples.iter_mut().zip(&without.samples) {
            assert_eq!(sample.works.pop(), Some(0.0));
            assert_eq!(sample, other, "{rest}");
        }
    }
}

/// Two halves are a whole.
#[test]
fn added_masses_of_one_link_add_up() {
    let model = satellite();
    let once = "[[added_mass]]\nlink = 'link_3'\ninertia = [0.1, 0.2, 0.3, 1, 2, 3]\n";
    let half = "[[added_mass]]\nlink = 'link_3'\ninertia = [0.05, 0.1, 0.15, 0.5, 1, 1.5]\n";
    let [whole, halves] = [once.to_owned(), half.repeat(2)].map(|water| flown(&model, &format!("{SWING}{water}")));
    for (one, other) in whole.samples.iter().zip(&halves.samples) {
        let apart = one.q.iter().zip(&other.q).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
        assert!(apart < ACCUMULATED, "{}: {apart:e}", one.time);
    }
}

/// Joints on a course move as it says; what they take beyond what the water does is the work of their drives.
#[test]
fn a_joint_on_a_course_takes_what_the_water_asks() {
    let model = satellite();
    let course = "[[prescribed]]\njoint = 'joint_2'\nsinusoid = { offset = 0.5, amplitude = 0.4, rate = 5 }\n\
                  [[prescribed]]\njoint = 'joint_6'\ntimes = [0.1, 0.6]\nvalues = [0, 1]\n[rotors]\ninertia = 0.05\n";
    let start = "[start]\nbase_twist = [0.3, 0.2, 0.1, 0.4, -0.2, 0.1]\n";
    let text = format!("{start}{course}{WATER}");
    let added = added(&model, &text);
    let [with, without] = [text, format!("{start}{course}")].map(|text| flown(&model, &text));
    let energy = water(&model, &added, &with.samples[0]).0;
    let mut drives = 0.0_f64;
    for sample in &with.samples {
        assert!((sample.q[1] - 0.5 - 0.4 * (5.0 * sample.time).sin()).abs() < ROUNDING);
        let (gained, work) = (sample.kinetic_energy - with.samples[0].kinetic_energy, sample.work());
        assert!((gained - work).abs() < 10.0 * ACCUMULATED, "{}: {gained} {work}", sample.time);
        let [one, other, by_water] = sample.works[..] else { panic!("{:?}", sample.works) };
        let lost = energy - water(&model, &added, sample).0;
        assert!((by_water - lost).abs() < 10.0 * ACCUMULATED, "{}: {by_water} {lost}", sample.time);
        drives = drives.max(one.abs()).max(other.abs());
    }
    let more = |i: usize| (with.samples[i].tau[1] - without.samples[i].tau[1]).abs();
    assert!(drives > 0.1 && more(50) > 0.1, "{drives} {}", more(50));
}

/// The robot's own momentum is zero at the start and does not stay so.
#[test]
fn water_drives_the_momentum() {
    let model = satellite();
    let text = "[start]\nqd = { joint_2 = 1 }\n[added_mass]\nlink = 'link_7'\ninertia = [0, 0, 0, 5, 5, 5]\n";
    let scene = scene(&model, text);
    assert_eq!((scene.case(), scene.start.mu), (Case::Driven, Twist::zero()));
    let record = flown(&model, text);
    let last = record.samples.last().unwrap();
    assert!(last.momentum.force.norm() > 0.05, "{:?}", last.momentum);
}

/// A target brings its momenta, which are then those of robot, target and water: of the base, and of the shape.
#[test]
fn a_target_brings_its_momentum_to_robot_and_water() {
    /// Forces act for a hundredth of a millisecond between the grasp and the sample after it.
    const SOON: f64 = 1e-3;
    let model = satellite();
    let (mass, com, twist) = (8.0, Vector3::new(0.02, -0.03, 0.2), [0.3, -0.2, 0.4, 0.1, 0.2, -0.1]);
    let target = format!(
        "[payload]\nlink = 'link_7'\nmass = {mass}\ncom = [0.02, -0.03, 0.2]\ninertia = [0.1, 0.2, 0.15, 0, 0, 0]\n\
         twist = {twist:?}\ngrasp = 0.005\n[rotors]\ninertia = 0.1\n"
    );
    let course = "[prescribed]\njoint = 'joint_3'\nsinusoid = { amplitude = 0.5, rate = 2 }\n";
    for (swing, current) in
        [(SWING.to_owned(), ""), (format!("{}{course}", SWING.replace("joint_3 = 1, ", "")), "\ncurrent = [0.5, 0, 0]")]
    {
        let flows = WATER.replace("\ninertia", &format!("{current}\ninertia"));
        let text = format!("samples_per_second = 1e5\n{swing}{target}{flows}");
        let scene = Scene { duration: 0.006, ..scene(&model, &text) };
        let added = added(&model, &text);
        let record = run(&scene, &model, |_| ControlFlow::Continue(()));
        assert_eq!((record.end, record.samples.len()), (End::Whole, 601));
        let (before, after) = (&record.samples[500], &record.samples[501]);
        let last = record.samples.last().unwrap();
        assert!((last.kinetic_energy - record.samples[0].kinetic_energy - last.work()).abs() < ACCUMULATED);

        let momenta = |sample: &Sample, time: f64| {
            let laden = scene.laden(&model, time);
            let mut work = Workspace::new(&laden);
            let base_twist = work.shape(&sample.q).moving(&sample.qd).base_twist(sample.mu);
            let here = Moved { base_twist, q: sample.q.clone(), qd: sample.qd.clone() };
            gradient(&laden.cast(), &added, 0.1, &here, false)
        };
        let (had, has) = (momenta(before, 0.0), momenta(after, 0.005));
        let mut work = Workspace::new(&model);
        let shape = work.shape(&before.q);
        let link = model.link("link_7").unwrap();
        let turn = (before.pose.rotation * shape.link_pose(link).rotation).transpose();
        let [omega, v] = [0, 3].map(|i| turn * Vector3::from_column_slice(&twist[i..i + 3]));
        let brought = Wrench::new(Vector3::new(0.1, 0.2, 0.15).component_mul(&omega), v * mass).at(-com);
        let mut of_shape = [0.0; 7];
        let of_base = shape.add_link_wrench(link, brought, &mut of_shape);
        let expected = of_base.to_array().into_iter().chain(of_shape);
        for (i, ((had, has), brought)) in had.iter().zip(&has).zip(expected).enumerate() {
            // What drives a joint on its course gives it an impulse.
            let driven = swing.contains(course) && i == 6 + 2;
            assert!(driven || (has - had - brought).abs() < SOON, "{i}: {had} {has} {brought}");
        }
        assert!(of_base.to_array().iter().all(|brought| brought.abs() > 10.0 * SOON) && before.qd != after.qd);
        let jump = |name: &str| {
            let work = scene.works().iter().position(|work| work.name == name).unwrap();
            after.works[work] - before.works[work]
        };
        assert!(jump("added_mass").abs() > 0.01 && jump("payloads").abs() > 0.01);
        // μ is that of the robot with what it holds.
        let lost = water(&model, &added, before).0 - water(&scene.laden(&model, 0.005), &added, after).0;
        assert!(
            !current.is_empty() || (jump("added_mass") - lost).abs() < ACCUMULATED,
            "{} {lost}",
            jump("added_mass")
        );
    }
}

/// μ̂ follows μ though the water takes momentum: F₁ tells of it.
#[test]
fn an_observer_is_told_what_the_water_does() {
    let model = satellite();
    let record = flown(&model, &format!("{SWING}[observer]\ngain = 10\n{WATER}"));
    let energy = |sample: &Sample| sample.observation.as_ref().unwrap().lyapunov;
    let fallen = energy(record.samples.last().unwrap()) / energy(&record.samples[0]);
    // e^(−2 k t), but for what the turning inertia adds.
    assert!(fallen < 1e-7, "{fallen:e}");
}

/// The wrenches of heavy water are large and nearly cancel what else there is: so many digits are lost. 31 digits tell.
#[test]
fn heavy_water_costs_as_many_digits_as_it_exceeds_the_robot() {
    let model = satellite();
    let wide: Model<DoubleDouble> = model.cast().orthonormalised();
    for heavier in [1e-3_f64, 1.0, 1e3, 1e6] {
        let inertia = [0.1, 0.2, 0.3, 4.0, 5.0, 6.0].map(|x| x * heavier);
        let text = format!("{SWING}[added_mass]\nlink = 'base'\ninertia = {inertia:?}\n[spring]\nstiffness = 1\n");
        let scene = scene(&model, &text);
        let mut equations = equations::<f64>(&scene, &model, 0.0);
        let state = equations.start(&scene.start);
        let mut rate = Tangent::zero(state.flat.len());
        equations.rate(0.0, &state, &mut rate);
        let mut exact = frs_sim::run::equations::<DoubleDouble>(&scene, &wide, 0.0);
        let number = DoubleDouble::from;
        let pose = Pose::new(state.pose.rotation.map(number), state.pose.translation.map(number)).orthonormalised();
        let wide_state = State { pose, flat: state.flat.iter().map(|x| number(*x)).collect() };
        let mut wide_rate = Tangent::zero(state.flat.len());
        exact.rate(number(0.0), &wide_state, &mut wide_rate);
        let expected: Vec<f64> = wide_rate.flat.iter().map(|x| x.high()).collect();
        let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let error = rate.flat.iter().zip(&expected).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs())) / size;
        assert!(error < 1e-13 * heavier.max(1.0), "{heavier:e}: {error:e}");
    }
}
