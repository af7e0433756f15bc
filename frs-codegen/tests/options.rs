//! Every option changes what is computed, never the bits of what remains.

mod side_by_side;

use std::path::Path;

use frs_codegen::record::{Operation, replay};
use frs_codegen::{Counts, Form, Lanes, Momentum, Options, Precision, Program, generate};
use frs_core::lanes::F64x8;
use frs_core::{Evaluator, FloatingBase, Model, Quantity, Real};

const STATES: usize = 200;

fn urdf(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robots").join(name).with_extension("urdf");
    std::fs::read_to_string(path).unwrap()
}

fn robot(name: &str) -> Model {
    Model::from_urdf(&urdf(name)).unwrap()
}

fn robots() -> Vec<Model> {
    ["chaser", "dual_arm_satellite", "lwr_satellite", "planar_three_link", "quadruped"].map(robot).into()
}

/// The outputs of `quantity` by the program, given each input by name; inputs that the program has not are not asked for.
fn interpret<T: Real>(program: &Program, quantity: Quantity, input: &dyn Fn(&str) -> Vec<T>) -> Vec<Vec<T>> {
    let function = program.functions.iter().find(|function| function.quantity == quantity).expect("it was asked for");
    let mut numbers = vec![T::from_f64(f64::NAN); program.inputs.iter().map(|input| input.len).sum()];
    for one in function.inputs.iter().map(|&array| program.inputs[array]) {
        numbers[one.start as usize..][..one.len].copy_from_slice(&input(one.name));
    }
    let values = replay(program.graph.operations(), &numbers);
    let zero = T::zero();
    let output = |places: &Vec<u32>| places.iter().map(|&place| values[place as usize] + zero).collect();
    function.outputs.iter().map(|one| output(&one.places)).collect()
}

/// What the core answers, given each input by name.
fn core<T: Real>(model: &Model<T>, quantity: Quantity, input: &dyn Fn(&str) -> Vec<T>) -> Vec<Vec<T>> {
    let inputs: Vec<Vec<T>> = quantity.inputs().map(|one| input(one.name)).collect();
    let inputs: Vec<&[T]> = inputs.iter().map(Vec::as_slice).collect();
    let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|one| vec![T::zero(); one.len(model.dof())]).collect();
    let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    Evaluator::new(model).answer(quantity, &inputs, &mut slices);
    outputs
}

/// Random inputs by name; those in `zero` are zero.
fn state(random: &mut fastrand::Rng, n: usize, zero: &[&str]) -> impl Fn(&str) -> Vec<f64> + use<> {
    let mut entries = |name: &str, len: usize| -> Vec<f64> {
        (0..len).map(|_| if zero.contains(&name) { 0.0 } else { random.f64() * 6.0 - 3.0 }).collect()
    };
    let values: Vec<(&str, Vec<f64>)> = [
        ("q", n),
        ("qd", n),
        ("mu", 6),
        ("base_twist", 6),
        ("body_momentum", 6),
        ("gravity", 3),
        ("base_wrench", 6),
        ("tau", n),
        ("xi_dot", 6 + n),
    ]
    .map(|(name, len)| (name, entries(name, len)))
    .into();
    move |name| values.iter().find(|(known, _)| *known == name).expect("a known input").1.clone()
}

fn bits<T: Real>(outputs: &[Vec<T>], bits: impl Fn(T) -> u64) -> Vec<Vec<u64>> {
    outputs.iter().map(|output| output.iter().map(|&number| bits(number)).collect()).collect()
}

/// The same of a program in the hybrid form.
fn interpret_hybrid(program: &Program, quantity: Quantity, input: &dyn Fn(&str) -> Vec<f64>) -> Vec<Vec<f64>> {
    let function = program.functions.iter().find(|function| function.quantity == quantity).expect("it was asked for");
    let mut numbers = vec![f64::NAN; program.inputs.iter().map(|input| input.len).sum()];
    for one in function.inputs.iter().map(|&array| program.inputs[array]) {
        numbers[one.start as usize..][..one.len].copy_from_slice(&input(one.name));
    }
    let values = side_by_side::replay(program.graph.operations(), &numbers);
    let output = |places: &Vec<u32>| places.iter().map(|&place| values[place as usize].as_array()[0] + 0.0).collect();
    function.outputs.iter().map(|one| output(&one.places)).collect()
}

/// Under `options` every function that remains equals the core with the inputs in `zero` at zero; ξ̇ may be cut to q̈.
fn remains_the_same(options: &Options, zero: &[&str]) {
    for model in robots() {
        let program = Program::new(&model, options).unwrap();
        let mut random = fastrand::Rng::with_seed(3);
        for function in &program.functions {
            for _ in 0..STATES {
                let state = state(&mut random, model.dof(), zero);
                let mut expected = core(&model, function.quantity, &state);
                if let Some(place) = function.outputs.iter().position(|output| output.name == "qdd") {
                    expected[place].drain(..6);
                }
                let actual = interpret(&program, function.quantity, &state);
                let name = function.quantity.name();
                assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits), "{} {name}", model.name());
            }
        }
    }
}

fn counts(model: &Model, options: &Options, name: &str) -> Counts {
    let generated = generate(model, options).unwrap();
    generated.functions.into_iter().find(|function| function.name == name).expect("it was asked for").counts
}

#[test]
fn zero_momentum_is_the_full_code_at_mu_zero() {
    let options = Options { momentum: Momentum::Zero, ..Options::default() };
    remains_the_same(&options, &["mu", "base_wrench", "gravity"]);
}

#[test]
fn conserved_momentum_is_the_full_code_without_wrenches() {
    let options = Options { momentum: Momentum::Conserved, ..Options::default() };
    remains_the_same(&options, &["base_wrench", "gravity"]);
}

#[test]
fn without_gravity_is_the_full_code_at_gravity_zero() {
    remains_the_same(&Options { without_gravity: true, ..Options::default() }, &["gravity"]);
}

#[test]
fn any_choice_of_outputs_leaves_each_the_same() {
    for quantity in Quantity::ALL {
        remains_the_same(&Options { outputs: Some(vec![quantity]), ..Options::default() }, &[]);
    }
}

/// What is not called for is not computed: the operations of an absent effect are gone.
#[test]
fn what_is_known_costs_nothing() {
    let model = robot("lwr_satellite");
    let cost = |options: &Options| counts(&model, options, "forward_dynamics").flops();
    let driven = cost(&Options::default());
    let without_gravity = cost(&Options { without_gravity: true, ..Options::default() });
    let conserved = cost(&Options { momentum: Momentum::Conserved, ..Options::default() });
    let zero = cost(&Options { momentum: Momentum::Zero, ..Options::default() });
    assert_eq!(driven - without_gravity, 3, "gravity is three additions");
    assert!(zero < conserved && conserved < without_gravity, "{zero} {conserved} {without_gravity}");
}

#[test]
fn a_held_joint_is_the_full_code_at_that_value_with_zero_rate() {
    let model = robot("lwr_satellite");
    let (held, value, n) = (3, 0.7, model.dof());
    let options = Options { locked: vec![(model.coordinates()[held].name.clone(), value)], ..Options::default() };
    let locked = options.specialise(&model).unwrap();
    let program = Program::new(&locked, &options).unwrap();
    let mut random = fastrand::Rng::with_seed(4);
    let without = |values: Vec<f64>| values.iter().enumerate().filter(|(i, _)| *i != held).map(|(_, &x)| x).collect();
    for _ in 0..STATES {
        let state = state(&mut random, n, &[]);
        let full = |name: &str| {
            let mut values = state(name);
            match name {
                "q" => values[held] = value,
                "qd" => values[held] = 0.0,
                _ => {}
            }
            values
        };
        let reduced = |name: &str| if ["q", "qd", "tau"].contains(&name) { without(full(name)) } else { full(name) };
        // Matrices by columns: what is left is the full code without the held row and column.
        let expected = core(&model, Quantity::Inertia, &full);
        let actual = interpret(&program, Quantity::Inertia, &reduced);
        let kept = || (0..n).filter(|&i| i != held);
        let shape: Vec<f64> =
            kept().flat_map(|j| kept().map(move |i| j * n + i)).map(|entry| expected[2][entry]).collect();
        let connection: Vec<f64> = kept().flat_map(|j| expected[1][6 * j..6 * j + 6].to_vec()).collect();
        let expected = [expected[0].clone(), connection, shape];
        assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits));
        for quantity in [Quantity::BaseTwist, Quantity::KineticEnergy, Quantity::Momentum] {
            let expected = core(&model, quantity, &full);
            let actual = interpret(&program, quantity, &reduced);
            assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits), "{}", quantity.name());
        }
        // All of it is the core of the robot with that joint held.
        for function in &program.functions {
            let expected = core(&locked, function.quantity, &|name| match name {
                "xi_dot" => state(name)[..5 + n].to_vec(),
                _ => reduced(name),
            });
            let actual = interpret(&program, function.quantity, &|name| match name {
                "xi_dot" => state(name)[..5 + n].to_vec(),
                _ => reduced(name),
            });
            assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits), "{}", function.quantity.name());
        }
    }
}

#[test]
fn a_payload_given_at_run_time_is_the_core_of_the_robot_that_carries_it() {
    let model = robot("lwr_satellite");
    let tool = model.links().last().unwrap();
    let nominal = tool.inertial;
    let options = Options { payload: Some(tool.name.clone()), ..Options::default() };
    let program = Program::new(&model, &options).unwrap();
    let mut random = fastrand::Rng::with_seed(5);
    for number in 0..STATES {
        let mut inertial = nominal;
        if number > 0 {
            inertial.mass *= 1.0 + random.f64();
            inertial.com.x += random.f64();
            inertial.inertia.xx *= 1.5;
            inertial.inertia.yy *= 1.5;
        }
        let carrying = model.with_inertial(&tool.name, inertial).unwrap();
        let state = state(&mut random, model.dof(), &[]);
        let given = |name: &str| match name {
            "payload" => {
                let (c, i) = (inertial.com, inertial.inertia);
                vec![inertial.mass, c.x, c.y, c.z, i.xx, i.xy, i.xz, i.yy, i.yz, i.zz]
            }
            _ => state(name),
        };
        for function in &program.functions {
            let expected = core(&carrying, function.quantity, &state);
            let actual = interpret(&program, function.quantity, &given);
            assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits), "{}", function.quantity.name());
            if number == 0 {
                let nominal = core(&model, function.quantity, &state);
                assert_eq!(bits(&actual, f64::to_bits), bits(&nominal, f64::to_bits), "the payload it has anyway");
            }
        }
    }
}

#[test]
fn single_precision_has_the_bits_of_the_core_in_single_precision() {
    for model in robots() {
        let program = Program::new(&model, &Options { precision: Precision::Single, ..Options::default() }).unwrap();
        let single = model.cast::<f32>();
        let mut random = fastrand::Rng::with_seed(6);
        for function in &program.functions {
            for _ in 0..STATES {
                let state = state(&mut random, model.dof(), &[]);
                let state = |name: &str| state(name).into_iter().map(|number| number as f32).collect::<Vec<f32>>();
                let expected = core(&single, function.quantity, &state);
                let actual = interpret(&program, function.quantity, &state);
                let to_bits = |number: f32| u64::from(number.to_bits());
                let name = function.quantity.name();
                assert_eq!(bits(&actual, to_bits), bits(&expected, to_bits), "{} {name}", model.name());
            }
        }
    }
}

#[test]
fn eight_lanes_are_eight_states() {
    for model in robots() {
        let program = Program::new(&model, &Options::default()).unwrap();
        let mut random = fastrand::Rng::with_seed(7);
        for function in &program.functions {
            for _ in 0..STATES / 8 {
                let states: Vec<_> = (0..8).map(|_| state(&mut random, model.dof(), &[])).collect();
                let together = |name: &str| {
                    let lanes: Vec<Vec<f64>> = states.iter().map(|state| state(name)).collect();
                    (0..lanes[0].len()).map(|i| F64x8::from_array(std::array::from_fn(|l| lanes[l][i]))).collect()
                };
                let together = interpret(&program, function.quantity, &together);
                for (lane, state) in states.iter().enumerate() {
                    let one = core(&model, function.quantity, state);
                    let actual = bits(&together, |number: F64x8| number.to_array()[lane].to_bits());
                    assert_eq!(actual, bits(&one, f64::to_bits), "{} {}", model.name(), function.quantity.name());
                }
            }
        }
    }
}

/// Each type of lanes: the code computes with it, and a robot that is called like it is called otherwise.
#[test]
fn lanes_are_of_a_type_that_exists() {
    let urdf = urdf("planar_three_link");
    let code = |precision, lanes, name: &str| {
        let model = Model::from_urdf(&urdf.replace("planar_three_link", name)).unwrap();
        let outputs = Some(vec![Quantity::Momentum]);
        generate(&model, &Options { precision, lanes, outputs, ..Options::default() }).map(|code| code.text())
    };
    let types = [
        (Precision::Double, Lanes::Four, "F64x4"),
        (Precision::Double, Lanes::Eight, "F64x8"),
        (Precision::Single, Lanes::Eight, "F32x8"),
        (Precision::Single, Lanes::Sixteen, "F32x16"),
    ];
    for (precision, lanes, number) in types {
        let text = code(precision, lanes, number).unwrap();
        assert!(text.contains(&format!("use ::frs_core::lanes::{number};")), "{number}");
        assert!(text.contains(&format!("impl FloatingBase<{number}> for Robot{number}")), "{number}");
    }
    for (precision, lanes, number) in
        [(Precision::Single, Lanes::Four, "4 lanes of f32"), (Precision::Double, Lanes::Sixteen, "16 lanes of f64")]
    {
        let words = code(precision, lanes, "arm").unwrap_err().to_string();
        assert!(words.starts_with(&format!("lanes: there is no type of {number}; expected ")), "{words}");
    }
}

#[test]
fn the_hybrid_form_is_the_core() {
    let hybrid = Options { form: Form::Hybrid, ..Options::default() };
    for model in robots() {
        let program = Program::new(&model, &hybrid).unwrap();
        assert!(program.graph.operations().iter().any(|operation| matches!(operation, Operation::Gather(_))));
        let mut random = fastrand::Rng::with_seed(8);
        for function in &program.functions {
            for _ in 0..STATES / 4 {
                let state = state(&mut random, model.dof(), &[]);
                let expected = core(&model, function.quantity, &state);
                let actual = interpret_hybrid(&program, function.quantity, &state);
                let name = function.quantity.name();
                assert_eq!(bits(&actual, f64::to_bits), bits(&expected, f64::to_bits), "{} {name}", model.name());
            }
        }
    }
}

/// A vector operation is one.
#[test]
fn the_hybrid_form_takes_half_the_operations() {
    let model = robot("humanoid");
    for quantity in [Quantity::Inertia, Quantity::Matrices] {
        let [unrolled, hybrid] = [Form::Unrolled, Form::Hybrid].map(|form| {
            let options = Options { form, outputs: Some(vec![quantity]), ..Options::default() };
            counts(&model, &options, quantity.name()).flops()
        });
        assert!(2 * hybrid < unrolled, "{}: {hybrid} of {unrolled}", quantity.name());
    }
}

#[test]
fn the_hybrid_form_is_one_state_of_doubles() {
    let model = robot("planar_three_link");
    let error = |options: Options| generate(&model, &options).err().map(|error| error.to_string()).unwrap_or_default();
    let hybrid = Options { form: Form::Hybrid, ..Options::default() };
    assert_eq!(error(hybrid.clone()), "");
    for lanes in [Lanes::Four, Lanes::Eight] {
        let words = error(Options { lanes, ..hybrid.clone() });
        assert!(words.starts_with("form: hybrid and lanes exclude each other"), "{words}");
    }
    let words = error(Options { precision: Precision::Single, ..hybrid });
    assert!(words.starts_with("form: hybrid and f32 exclude each other"), "{words}");
}

#[test]
fn loops_know_nothing_of_payloads_momenta_and_gravity_and_stand_on_the_core() {
    let model = robot("lwr_satellite");
    let forces = Some(vec![Quantity::ForwardDynamics]);
    let tabled = Options { form: Form::Tabled, outputs: forces, ..Options::default() };
    let excluded = [
        (Options { standalone: true, ..tabled.clone() }, "standalone"),
        (Options { payload: Some("link_7".into()), ..tabled.clone() }, "a payload"),
        (Options { momentum: Momentum::Conserved, ..tabled.clone() }, "a known momentum"),
        (Options { without_gravity: true, ..tabled.clone() }, "no gravity"),
    ];
    for (options, other) in excluded {
        let words = generate(&model, &options).err().expect(other).to_string();
        assert!(words.starts_with(&format!("form: tabled and {other} exclude each other")), "{words}");
        // What is chosen is never what is excluded.
        let chosen = generate(&model, &Options { form: Form::Auto, ..options }).unwrap();
        assert!(chosen.functions.iter().all(|function| function.form != Form::Tabled), "{other}");
    }
    // What reads neither is the same with and without.
    let outputs = Some(vec![Quantity::Inertia]);
    assert!(generate(&model, &Options { outputs, without_gravity: true, ..tabled }).is_ok());
}

/// The form of each function, where the generator chooses.
fn chosen(model: &Model, options: Options) -> Vec<(String, Form, usize)> {
    let generated = generate(model, &Options { form: Form::Auto, ..options }).unwrap();
    generated.functions.into_iter().map(|function| (function.name, function.form, function.code_bytes)).collect()
}

#[test]
fn the_form_is_chosen_by_the_length_of_the_code() {
    let forms = |robot_name: &str| chosen(&robot(robot_name), Options::default());
    assert!(forms("planar_three_link").iter().all(|(_, form, _)| *form == Form::Unrolled));
    let expected = [("momentum", Form::Unrolled), ("inertia", Form::Hybrid), ("forward_dynamics", Form::Tabled)];
    let legs = forms("quadruped");
    for (name, expected) in expected {
        assert_eq!(legs.iter().find(|(found, ..)| found == name).map(|(_, form, _)| *form), Some(expected), "{name}");
    }
    for (name, form, bytes) in legs {
        // A pass of its own computes for all bodies what one function needs of some: up to a fifth more.
        let room = match form {
            Form::Unrolled => 32 * 1024,
            Form::Hybrid => 48 * 1024,
            _ => 0,
        };
        assert!(bytes <= room + room / 5, "{name}: {bytes}");
    }
    let whole = forms("humanoid");
    assert!(whole.iter().filter(|(_, form, _)| *form == Form::Tabled).count() > 10, "{whole:?}");
}

/// A robot may be called as the types are that its tables are made of.
#[test]
fn a_tabled_robot_has_a_name_of_its_own() {
    let text = |form| {
        let model = Model::from_urdf(&urdf("planar_three_link").replace("planar_three_link", "motion")).unwrap();
        generate(&model, &Options { form, ..Options::default() }).unwrap().text()
    };
    assert!(text(Form::Tabled).contains("pub struct RobotMotion;"));
    assert!(text(Form::Unrolled).contains("pub struct Motion;"));
}

/// As much text for a hundred joints as their constants take: each body adds the same.
#[test]
fn tables_grow_with_the_robot() {
    let lines = |name: &str| {
        let model = robot(name);
        let options = Options { form: Form::Tabled, ..Options::default() };
        (generate(&model, &options).unwrap().text().lines().count(), model.joints() + 1)
    };
    let [(short, few), (long, many)] = ["lwr_satellite", "humanoid"].map(lines);
    assert!(long < short * many / few, "{short} lines for {few} bodies, {long} for {many}");
}

#[test]
fn a_value_that_the_scalar_cannot_hold_is_refused() {
    let model = robot("lwr_satellite");
    let held = |value, precision| Options { locked: vec![("joint_4".into(), value)], precision, ..Options::default() };
    let error = |options: &Options| generate(&model, options).err().map(|error| error.to_string());
    assert!(error(&held(1e300, Precision::Single)).is_some_and(|words| words.starts_with("f32: ")));
    assert!(error(&held(f64::INFINITY, Precision::Double)).is_some_and(|words| words.starts_with("f64: ")));
    assert_eq!(error(&held(1e300, Precision::Double)), None);
}

#[test]
fn a_link_asked_for_twice_is_one_function() {
    let links = Some(vec!["link_7".into(), "link_7".into()]);
    let options = Options { outputs: Some(vec![Quantity::Kinematics(0)]), links, ..Options::default() };
    assert_eq!(generate(&robot("lwr_satellite"), &options).unwrap().functions.len(), 1);
}

/// What is known of the functions before the robot is, is what they turn out to be.
#[test]
fn functions_are_known_before_the_robot_is() {
    let model = robot("lwr_satellite");
    let zero = Options { momentum: Momentum::Zero, ..Options::default() };
    let payload = Options { payload: Some("link_7".into()), without_gravity: true, ..Options::default() };
    for options in [Options::default(), zero, payload] {
        let generated = generate(&model, &options).unwrap();
        let text = generated.included_text();
        let mut functions = 0;
        for (name, arguments) in options.functions() {
            let (_, rest) = text.split_once(&format!("pub fn {name}(")).expect(name);
            let (list, _) = rest.split_once(')').unwrap();
            assert_eq!(list.matches(": &").count(), arguments, "{name}({list})");
            functions += 1;
        }
        assert!(functions > 6, "{functions}");
    }
}
