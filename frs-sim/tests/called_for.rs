//! Only what a scene calls for is computed: counted, recorded, and replayed.

use std::ops::ControlFlow;

use frs_codegen::record::{Operation, Recorded, record, replay};
use frs_codegen::{Counts, Graph, Precision};
use frs_core::spatial::{Pose, Twist, Wrench};
use frs_core::{Model, Real, urdf};
use frs_sim::effects::{AddedMass, Drag, Spring, Water};
use frs_sim::integrate::{State, System, Tangent};
use frs_sim::motion::{Conserved, Driven, Motion, Zero};
use frs_sim::run::{End, equations, run};
use frs_sim::scene::{EFFECTS, Scene};
use nalgebra::{Matrix3, Vector3};

const HEAD: &str = "robot = 'lwr_satellite.urdf'\nduration = 0.5\n";

/// μ is integrated, whatever acts: what an effect costs is then what it adds.
const INTEGRATED: &str = "[solver]\nequations = 'integrated'\n";

/// Every effect, and what one evaluation costs more with it, in operations on the satellite of seven joints. Contact and stops cost nothing until they are met.
const EACH: [(&str, &str, isize); 19] = [
    ("gravity", "[gravity]\nacceleration = [0, 0, -9.81]\n", 33),
    ("wrench", "[wrench]\nforce = [1, 2, 3]\nmoment = [1, 2, 3]\n", 6),
    ("wrench", "[wrench]\nlink = 'link_7'\nforce = [1, 2, 3]\naxes = 'world'\n", 598),
    ("drag", "[drag]\nlink = 'link_7'\nrotational = [1, 2, 3]\ntranslational = [1, 2, 3]\n", 499),
    ("contact", "[contact]\nlink = 'link_7'\npoint = [0, 0, 1]\nstiffness = 1e4\nfriction = 0.1\n", 0),
    ("joint_torque", "[joint_torque]\ntau = [1, 1, 1, 1, 1, 1, 1]\n", 7),
    ("friction", "[friction]\nviscous = 1\n", 14),
    ("friction", "[friction]\ncoulomb = 1\n", 42),
    ("spring", "[spring]\nstiffness = 1\n", 21),
    ("stops", "[stops]\nstiffness = 1e4\n", 0),
    ("rotors", "[rotors]\ninertia = 0.1\n", 7),
    ("prescribed", "[prescribed]\njoint = 'joint_2'\nsinusoid = { amplitude = 0.1, rate = 2 }\n", 1946),
    ("payload", "[payload]\nlink = 'link_7'\nmass = 1\ninertia = [0.1, 0.1, 0.1, 0, 0, 0]\n", 0),
    ("regulator", "[regulator]\nset_point = {}\nstiffness = 1\ndamping = 1\n", 35),
    ("regulator", "[regulator]\nset_point = {}\nstiffness = 1\ndamping = 1\ndecoupling = 'coupling'\n", 1225),
    ("regulator", "[regulator]\nset_point = {}\nstiffness = 1\ndamping = 1\ndecoupling = 'tau_bar'\n", 4120),
    ("computed_torque", "[computed_torque]\nbandwidth = 3\nset_point = {}\n", 2030),
    ("end_effector", "[end_effector]\nlink = 'link_7'\nposition = [0, 0, 1]\nstiffness = 1\ndamping = 1\n", 2227),
    ("added_mass", "[added_mass]\nlink = 'link_7'\ninertia = [1, 1, 1, 1, 1, 1]\n", 10805),
];

fn satellite() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn scene(text: &str) -> Scene {
    Scene::parse("scene.toml", &format!("{HEAD}{text}"), &satellite()).unwrap_or_else(|error| panic!("{error}"))
}

/// The operations of one evaluation: those that prepare it, then from `start` on its own. What is read: rotation by rows, translation,
/// the numbers of the state, time. `outputs` are where the rates of the pose and of the numbers are.
struct Tape {
    operations: Vec<Operation>,
    start: usize,
    outputs: Vec<u32>,
}

impl Tape {
    fn of(
        model: &Model,
        numbers: usize,
        make: impl for<'m> FnOnce(&'m Model<Recorded>) -> Box<dyn System<Recorded> + 'm>,
    ) -> Self {
        let ((start, outputs), operations) = record(|| {
            let model: Model<Recorded> = model.cast();
            let inputs: Vec<Recorded> = (0..13 + numbers as u32).map(Recorded::input).collect();
            let rotation = Matrix3::from_row_slice(&inputs[..9]);
            let pose = Pose::new(rotation, Vector3::from_column_slice(&inputs[9..12]));
            let state = State { pose, flat: inputs[12..12 + numbers].to_vec() };
            let mut rate = Tangent::zero(numbers);
            let mut system = make(&model);
            let mark = Recorded::input(12 + numbers as u32);
            system.rate(mark, &state, &mut rate);
            let outputs = rate.twist.to_array().into_iter().chain(rate.flat);
            (mark.0 as usize + 1, outputs.map(|number| number.0).collect())
        });
        Self { operations, start, outputs }
    }

    fn of_scene(scene: &Scene, model: &Model) -> Self {
        let laden = scene.laden(model, 0.0);
        Self::of(&laden, 2 * model.dof() + scene.case().numbers(), |model| equations(scene, model, 0.0))
    }

    fn cost(&self) -> isize {
        let mut counts = Counts::default();
        self.operations[self.start..].iter().for_each(|operation| counts.count(*operation));
        counts.flops() as isize
    }
}

fn cost(text: &str) -> isize {
    Tape::of_scene(&scene(text), &satellite()).cost()
}

/// What each effect costs is in the table of docs/scenes.md.
#[test]
fn every_effect_costs_what_it_adds() {
    let none = cost(INTEGRATED);
    let mut named: Vec<&str> = EACH.map(|(key, ..)| key).into();
    named.dedup();
    let mut all = EFFECTS.to_vec();
    all.sort_unstable();
    named.sort_unstable();
    assert_eq!(named, all, "every effect is here");
    let found = EACH.map(|(key, text, _)| (key, text, cost(&format!("{INTEGRATED}{text}")) - none));
    assert_eq!(found, EACH, "none: {none}");
}

/// Together, effects cost the sum of what each costs: none computes more or less because another is there.
#[test]
fn effects_cost_the_sum_of_their_costs() {
    let none = cost(INTEGRATED);
    let loads = EACH.into_iter().filter(|(key, ..)| !["rotors", "prescribed", "payload"].contains(key));
    let (mut text, mut sum) = (INTEGRATED.to_owned(), none);
    for (key, one, more) in loads {
        // As often as there are ways to name it.
        text += &one.replacen(&format!("[{key}]"), &format!("[[{key}]]"), 1);
        sum += more;
    }
    assert_eq!(cost(&text), sum);
}

/// A scene's equations are as many operations, and the same terms, as those of a motion that was put together by hand from what the scene names.
#[test]
fn a_scene_holds_no_operation_of_an_absent_effect() {
    let model = satellite();
    let route = scene("").solver.route;
    let spring = Spring { stiffness: vec![1.0; 7], rest: vec![0.0; 7] };
    let drag = Drag { link: 3, rotational: [1.0, 2.0, 3.0], translational: [4.0, 5.0, 6.0], current: [0.0; 3] };
    let mut inertia = [[0.0; 6]; 6];
    (0..6).for_each(|i| inertia[i][i] = 1.0);
    let added = [AddedMass { link: 3, inertia }];
    let (springs, drags, water) = (
        "[spring]\nstiffness = 1\n",
        "[drag]\nlink = 'link_3'\nrotational = [1, 2, 3]\ntranslational = [4, 5, 6]\n",
        "[added_mass]\nlink = 'link_3'\ninertia = [1, 1, 1, 1, 1, 1]\n",
    );
    let start = "[start]\nmomentum = [1, 2, 3, 0, 0, 0]\n";
    let numbers = scene(start).start.centroidal.to_array();
    let momentum = || Wrench::from_array(numbers.map(Recorded::from_f64));
    let by_hand = [
        (String::new(), Tape::of(&model, 14, |model| Box::new(Motion::new(model, Zero, ()).by(route)))),
        (
            springs.to_owned(),
            Tape::of(&model, 14, |model| Box::new(Motion::new(model, Zero, spring.clone()).by(route))),
        ),
        (
            format!("{start}{springs}"),
            Tape::of(&model, 14, |model| {
                Box::new(Motion::new(model, Conserved { momentum: momentum() }, spring.clone()).by(route))
            }),
        ),
        (INTEGRATED.to_owned(), Tape::of(&model, 20, |model| Box::new(Motion::new(model, Driven, ()).by(route)))),
        (
            format!("{drags}{springs}"),
            Tape::of(&model, 20, |model| {
                Box::new(Motion::new(model, Driven, (drag.clone(), spring.clone())).by(route))
            }),
        ),
        (
            format!("{springs}{water}"),
            Tape::of(&model, 20, |model| {
                let water = Water::new(&added, [0.0; 3], None, 7);
                Box::new(Motion::new(model, Driven, (spring.clone(), water)).by(route))
            }),
        ),
    ];
    for (text, by_hand) in by_hand {
        let found = Tape::of_scene(&scene(&text), &model);
        assert_eq!(found.cost(), by_hand.cost(), "{text}");
        assert!(by_hand.cost() > 1000);
        // Equal terms have one place in a graph.
        let mut graph = Graph::new(Precision::Double);
        let [found, by_hand] = [found, by_hand].map(|tape| {
            let places = graph.absorb(&tape.operations);
            tape.outputs.iter().map(|output| places[*output as usize]).collect::<Vec<_>>()
        });
        assert_eq!(found, by_hand, "{text}");
    }
}

/// Effects that add nothing to a momentum that is integrated anyhow change no bit: zeros are added. Contact and stops are not met.
#[test]
fn effects_of_size_zero_change_no_bit_of_a_driven_motion() {
    let model = satellite();
    let swing = format!(
        "{INTEGRATED}[start]\nq = {{ joint_2 = 0.5 }}\nqd = {{ joint_3 = 1 }}\nmomentum = [0.3, 0.2, 0.1, 1, 0, 0]\n"
    );
    let flown = |text: &str| {
        let record = run(&scene(&format!("{swing}{text}")), &model, |_| ControlFlow::Continue(()));
        assert_eq!(record.end, End::Whole);
        record
    };
    let without = flown("");
    for zero in [
        "[gravity]\nacceleration = [0, 0, 0]",
        "[wrench]\nforce = [0, 0, 0]",
        "[wrench]\nlink = 'link_7'\nforce = [0, 0, 0]\naxes = 'world'",
        "[drag]\nlink = 'link_7'\ncurrent = [1, 2, 3]",
        "[contact]\nlink = 'link_7'\nstiffness = 1e4\noffset = -100",
        "[friction]\nviscous = 0\ncoulomb = 0",
        "[spring]\nstiffness = 0",
        "[joint_torque]\ntau = {}",
        "[stops]\nstiffness = 1e4",
        "[rotors]\ninertia = 0",
        "[regulator]\nset_point = {}\nstiffness = 0\ndamping = 0",
        "[added_mass]\nlink = 'link_7'\ninertia = [0, 0, 0, 0, 0, 0]",
    ] {
        let mut with = flown(zero);
        assert_eq!(with.steps, without.steps, "{zero}");
        for sample in &mut with.samples {
            assert!(std::mem::take(&mut sample.works).iter().all(|work| *work == 0.0), "{zero}");
        }
        assert_eq!(with.samples, without.samples, "{zero}");
    }
}

/// What was recorded of a scene's equations at no state at all has, at any state, the bits of the core: code made of it is the same motion.
#[test]
fn recorded_equations_have_the_bits_of_the_core_in_every_scene_of_the_project() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes");
    let mut seen = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|extension| extension != "toml") {
            continue;
        }
        let (name, text) = (path.display().to_string(), std::fs::read_to_string(&path).unwrap());
        let (robot, _) = Scene::robot(&name, &text).unwrap();
        let model = Model::from_urdf(&std::fs::read_to_string(path.with_file_name(robot)).unwrap()).unwrap();
        let scene = Scene::parse(&name, &text, &model).unwrap();
        let tape = Tape::of_scene(&scene, &model);
        let laden = scene.laden(&model, 0.0);
        let mut equations = equations::<f64>(&scene, &laden, 0.0);
        let mut state = equations.start(&scene.start);
        for (i, number) in state.flat.iter_mut().enumerate() {
            *number += 0.3 * (1.7 * i as f64).sin();
        }
        state.pose = state.pose * Pose::exp(Twist::from_array([0.3, -0.2, 0.4, 0.1, 0.2, -0.3]));
        let (time, mut rate) = (1e-3, Tangent::zero(state.flat.len()));
        equations.rate(time, &state, &mut rate);
        let inputs: Vec<f64> = state
            .pose
            .rotation
            .transpose()
            .iter()
            .chain(&state.pose.translation)
            .chain(&state.flat)
            .chain([&time])
            .copied()
            .collect();
        let values = replay(&tape.operations, &inputs);
        let found: Vec<f64> = tape.outputs.iter().map(|output| values[*output as usize]).collect();
        let expected: Vec<f64> = rate.twist.to_array().into_iter().chain(rate.flat).collect();
        assert_eq!(found, expected, "{name}");
        assert!(found.iter().all(|number| number.is_finite()), "{name}");
        seen += 1;
    }
    assert!(seen > 15, "{seen} scenes");
}
