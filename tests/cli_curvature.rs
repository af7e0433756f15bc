//! `frs curvature`, as a person or a program meets it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use frs::{Evaluator, Model};
use frs_gait::{Gait, PlaneCurvature, ShapePlane, area_integral, displacement};
use serde_json::Value;

const LWR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/lwr_satellite.urdf");
const PLANAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/planar_three_link.urdf");

/// Two runs of the same functions at the tolerances of the command line (rad, m).
const AGREEMENT: f64 = 1e-7;

/// An empty folder of its own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("curvature").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn curvature(arguments: &[&str], out: &Path) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_frs"));
    command.arg("curvature").args(arguments).arg("--out").arg(out).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn json(output: &Output) -> Value {
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn maps_tables_and_fields_are_written() {
    let out = folder("maps").join("made");
    let arguments = [LWR, "--joints", "joint_2,joint_4", "--grid", "11", "--gait", "ellipse:0.3,0.5,0.8,0.8"];
    let output = curvature(&arguments, &out);
    let told = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(told.contains("area rule") && told.contains("rotation y / rad") && told.contains("fields.csv"), "{told}");
    let mut written: Vec<_> =
        std::fs::read_dir(&out).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    written.sort();
    let mut expected: Vec<String> = ["omega", "v", "minimum_omega"]
        .iter()
        .flat_map(|field| ["x", "y", "z"].map(|axis| format!("{field}_{axis}.svg")))
        .chain(["fields.csv".to_owned()])
        .collect();
    expected.sort();
    assert_eq!(written, expected);
    let picture = std::fs::read_to_string(out.join("omega_y.svg")).unwrap();
    assert!(picture.contains("joint_2 / rad") && picture.contains("rad/rad²") && picture.contains("lwr_satellite"));
    assert!(picture.trim_end().ends_with("</svg>") && picture.len() < 500_000);
}

#[test]
fn components_that_are_zero_everywhere_are_told_so() {
    let out = folder("planar");
    json(&curvature(&[PLANAR, "--joints", "joint_1,joint_2", "--grid", "11", "--json"], &out));
    for (name, zero) in
        [("omega_x", true), ("omega_z", false), ("v_x", false), ("v_z", true), ("minimum_omega_z", false)]
    {
        let picture = std::fs::read_to_string(out.join(name).with_extension("svg")).unwrap();
        assert_eq!(picture.contains("zero everywhere"), zero, "{name}");
    }
}

#[test]
fn fields_are_those_of_the_library() {
    let out = folder("fields");
    let window = "--window=-1:0.5,0.25:2";
    let at = "{\"joint_3\":1,\"joint_6\":-0.5}";
    curvature(&[LWR, "--joints", "joint_4,joint_2", "--at", at, window, "--grid", "3"], &out);
    let table = std::fs::read_to_string(out.join("fields.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        table.lines().skip(1).map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect();
    assert!(table.starts_with("joint_4,joint_2,omega_x,") && rows.len() == 9);
    assert_eq!((&rows[0][..2], &rows[1][..2], &rows[8][..2]), (&[-1.0, 0.25][..], &[-0.25, 0.25][..], &[0.5, 2.0][..]));
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let plane = ShapePlane::new(vec![0.0, 0.0, 1.0, 0.0, 0.0, -0.5, 0.0], [3, 1]);
    let mut robot = Evaluator::new(&model);
    let mut field = PlaneCurvature::new(&mut robot, &plane);
    for row in &rows {
        assert_eq!(row[2..8], field.at([row[0], row[1]]).to_array());
        let size = |row: &[f64]| row.iter().map(|x| x * x).sum::<f64>();
        assert!((size(&row[2..5]) - size(&row[8..11])).abs() < 1e-12, "minimum perturbation only turns");
    }
}

#[test]
fn a_gait_is_judged_as_the_library_judges_it() {
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let plane = ShapePlane::new(vec![0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0], [1, 3]);
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]].map(|corner| plane.shape(corner));
    let gaits = [
        ("ellipse:0.3,0.5,0.8,-0.6", Gait::ellipse(&plane, [0.3, 0.5], [0.8, -0.6]).unwrap()),
        ("polygon:0,0;1,0;1,1", Gait::polygon(&corners).unwrap()),
    ];
    for (written, gait) in gaits {
        let out = folder("judged");
        let at = "[0,0,1,0,0,0,0]";
        let told = json(&curvature(
            &[LWR, "--joints", "joint_2,joint_4", "--at", at, "--grid", "21", "--gait", written, "--json"],
            &out,
        ));
        let mut robot = Evaluator::new(&model);
        let exact = displacement(&mut robot, &gait, 1e-11).unwrap().pose.log().to_array();
        let area = area_integral(&mut robot, &plane, &gait, 1e-9).body.to_array();
        let found = numbers(&told["gait"]["displacement"]);
        assert!(
            apart(&found, &exact) < AGREEMENT && apart(&numbers(&told["gait"]["area_integral"]), &area) < AGREEMENT
        );
        let gap: Vec<f64> = area.iter().zip(exact).map(|(area, exact)| area - exact).collect();
        assert!(apart(&numbers(&told["gait"]["gap"]), &gap) < AGREEMENT);
        assert_eq!(numbers(&told["gait"]["minimum_perturbation"]["rotation"]).len(), 3);
    }
}

#[test]
fn the_best_gait_can_be_read_back() {
    let out = folder("best");
    let joints = [PLANAR, "--joints", "joint_1,joint_2", "--grid", "11", "--json"];
    let best = json(&curvature(&[&joints[..], &["--optimise", "rotation-z", "--perimeter", "3"]].concat(), &out));
    let turn = best["best"]["turn"].as_f64().unwrap();
    assert!(
        turn > 0.1
            && (best["gait"]["perimeter"].as_f64().unwrap() - 3.0).abs() < 1e-6
            && best["best"]["outside"] == 0.0
    );
    let gait = out.join("best_gait.csv");
    let back = json(&curvature(&[&joints[..], &["--gait", gait.to_str().unwrap()]].concat(), &folder("back")));
    // 240 points of a spline.
    assert!((numbers(&back["gait"]["displacement"])[2] - turn).abs() < 1e-6);
    assert!((numbers(&back["gait"]["gap"])[2]).abs() < AGREEMENT, "planar: the area rule is exact");
}

#[test]
fn a_csv_gait_may_name_its_columns_in_either_order() {
    let out = folder("columns");
    let displaced = |name: &str, content: &str| {
        let file = out.join(name);
        std::fs::write(&file, content).unwrap();
        let gait = file.to_str().unwrap();
        let told = curvature(&[PLANAR, "--joints", "joint_1,joint_2", "--grid", "3", "--gait", gait, "--json"], &out);
        numbers(&json(&told)["gait"]["displacement"])
    };
    let plain = displaced("plain.csv", "0,0\n1,0\n1,1\n0,1.5\n");
    assert_eq!(plain, displaced("named.csv", "# a loop\njoint_1, joint_2\n0,0\n1,0\n\n1,1\n0,1.5\n0,0\n"));
    assert_eq!(plain, displaced("swapped.csv", "joint_2,joint_1\n0,0\n0,1\n1,1\n1.5,0\n"));
    assert!(plain[2].abs() > 1e-3);
}

#[test]
fn bad_input_is_refused_with_its_place_and_what_was_expected() {
    let out = folder("bad");
    let csv = |name: &str, content: &str| {
        let file = out.join(name);
        std::fs::write(&file, content).unwrap();
        file.display().to_string()
    };
    let (words, short) = (csv("words.csv", "0,0\n1,0\nhello,1\n"), csv("short.csv", "0,0\n0,0\n1,1\n"));
    let words_gait = format!("--gait={words}");
    let short_gait = format!("--gait={short}");
    let pair = "--joints=joint_2,joint_4";
    let cases: [(&[&str], &[&str]); 20] = [
        (&["--joints=joint_2,jiont_4"], &["no coordinate is called 'jiont_4'", "did you mean 'joint_4'?"]),
        (&["--joints=joint_2,joint_2"], &["joint_2,joint_2", "two different"]),
        (&["--joints=joint_2"], &["found 1 names", "two"]),
        (&[pair, "--grid=1"], &["--grid 1", "at least 2"]),
        (&[pair, "--at=[0,1]"], &["--at '[0,1]'", "found 2 numbers; expected 7"]),
        (&[pair, "--at={\"elbow\":1}"], &["--at", "no coordinate is called 'elbow'"]),
        (&[pair, "--at=nonsense"], &["--at 'nonsense'", "write"]),
        (&[pair, "--window=1:0,0:1"], &["--window '1:0,0:1'", "A0:A1,B0:B1"]),
        (&[pair, "--window=0:inf,0:1"], &["--window", "lowest and highest"]),
        (&[pair, "--gait=ellipse:0,0,1"], &["ellipse:0,0,1", "four numbers", "CA,CB,RA,RB"]),
        (&[pair, "--gait=ellipse:0,0,1,NaN"], &["ellipse:0,0,1,NaN", "four numbers"]),
        (&[pair, "--gait=ellipse:0,0,1,0"], &["half-axes, these not 0"]),
        (&[pair, "--gait=polygon:0,0;1"], &["polygon:0,0;1", "pairs of numbers"]),
        (&[pair, "--gait=polygon:0,0;1,1"], &["found 2 corners", "three corners or more"]),
        (&[pair, "--gait=circle"], &["--gait 'circle'", "no such file", "ellipse:"]),
        (&[pair, &words_gait], &["words.csv:3: 'hello,1' is not a point", "two finite numbers"]),
        (&[pair, &short_gait], &["short.csv: the gait has 2 distinct points; expected at least 3"]),
        (&[pair, "--optimise=rotation-z", "--perimeter=-1"], &["--perimeter -1", "above 0"]),
        (&[pair, "--optimise=rotation-z", "--perimeter=1000"], &["--perimeter 1000", "perimeter of the window"]),
        (&[pair, "--optimise=rotation-z"], &["--perimeter"]),
    ];
    for (arguments, expected) in cases {
        let output = curvature(&[&[LWR], arguments].concat(), &out.join("none"));
        let told = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {told}");
        for words in expected {
            assert!(told.contains(words), "{arguments:?}: '{words}' is not in: {told}");
        }
    }
    assert!(!out.join("none").exists(), "nothing is written when the input is refused");
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let file = folder("file").join("plain");
    std::fs::write(&file, "").unwrap();
    let output = curvature(&[PLANAR, "--joints", "joint_1,joint_2", "--grid", "3"], &file.join("below"));
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("cannot be written") && text(&output.stderr).contains("below"));
}

#[test]
fn shapes_in_which_the_robot_is_singular_are_crossed_out() {
    // Point masses along a straight arm where both joints are 0.
    let link = |name: &str, mass: u32, x: u32, inertia: f64| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"{x} 0 0\"/><mass value=\"{mass}\"/><inertia ixx=\"0\" \
             ixy=\"0\" ixz=\"0\" iyy=\"{inertia}\" iyz=\"0\" izz=\"{inertia}\"/></inertial></link>"
        )
    };
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"1 0 0\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    };
    let links = [link("base", 2, 0, 0.0), link("arm", 1, 1, 0.1), link("tip", 1, 1, 0.0)].concat();
    let joints = [joint("elbow", "base", "arm"), joint("wrist", "arm", "tip")].concat();
    let out = folder("singular");
    let robot = out.join("rod.urdf");
    std::fs::write(&robot, format!("<robot name=\"rod\">{links}{joints}</robot>")).unwrap();
    let arguments = [robot.to_str().unwrap(), "--joints", "elbow,wrist", "--grid", "5"];
    let output = curvature(&arguments, &out);
    let told = text(&output.stderr);
    assert!(output.status.code() == Some(0) && told.contains("singular at 1 points"), "{told}");
    let table = std::fs::read_to_string(out.join("fields.csv")).unwrap();
    assert_eq!(table.lines().filter(|line| line.starts_with("0,0,NaN")).count(), 1);
    let picture = std::fs::read_to_string(out.join("omega_z.svg")).unwrap();
    assert!(!picture.contains("NaN") && picture.contains("l8 8"));
}
