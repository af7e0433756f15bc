//! `frs check`, as a person or a program meets it, and what it knows about bodies.

use std::path::Path;
use std::process::{Command, Output};

use frs::Model;
use frs::conditioning::{Bounded, Conditioning};
use frs::plausibility::{Oddity, findings};
use serde_json::Value;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const DEFAULT: &str = "robots/lwr_satellite.urdf";

fn frs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_frs")).current_dir(ROOT).arg("check").args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A robot of one link.
fn link(mass: f64, [ixx, iyy, izz]: [f64; 3]) -> String {
    format!(
        r#"<robot name="one"><link name="hull"><inertial><mass value="{mass}"/>
        <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#
    )
}

fn oddity(mass: f64, inertia: [f64; 3]) -> Option<Oddity> {
    let model = Model::from_urdf(&link(mass, inertia)).unwrap();
    findings(&model).pop().map(|finding| finding.oddity)
}

/// A ball's inertia is 2/5 m r², and its density is its own.
#[test]
fn a_ball_is_as_dense_as_it_is() {
    let ball = |density: f64, radius: f64| {
        let mass = density * 4.0 / 3.0 * std::f64::consts::PI * radius.powi(3);
        oddity(mass, [0.4 * mass * radius * radius; 3])
    };
    for possible in [1.3, 1000.0, 7870.0, 22_500.0] {
        assert_eq!(ball(possible, 0.1), None, "{possible} kg/m³");
    }
    let Some(Oddity::TooDense(found)) = ball(30_000.0, 0.1) else { panic!("not noticed") };
    assert!((found - 30_000.0).abs() < 1e-6 * found, "{found}");
    let Some(Oddity::TooThin(found)) = ball(1.0, 3.0) else { panic!("not noticed") };
    assert!((found - 1.0).abs() < 1e-6, "{found}");
}

#[test]
fn what_has_no_thickness_is_called_a_plate_a_rod_or_a_point() {
    assert_eq!(oddity(1.0, [1.0, 1.0, 2.0]), Some(Oddity::Flat(1)));
    // A base needs more: these hang on one.
    for (sides, [ixx, iyy, izz]) in [(2, [0.0, 1.0, 1.0]), (3, [0.0, 0.0, 0.0])] {
        let lamp = format!(
            r#"<joint name="f" type="fixed"><parent link="hull"/><child link="lamp"/></joint>
            <link name="lamp"><inertial><origin xyz="1 0 0"/><mass value="2"/>
            <inertia ixx="{ixx}" iyy="{iyy}" izz="{izz}" ixy="0" ixz="0" iyz="0"/></inertial></link></robot>"#
        );
        let found = findings(&Model::from_urdf(&link(1.0, [0.1; 3]).replace("</robot>", &lamp)).unwrap());
        let lamp = found.iter().find(|finding| finding.link == "lamp").map(|finding| &finding.oddity);
        assert_eq!(lamp, Some(&Oddity::Flat(sides)));
    }
}

#[test]
fn ratios_and_digits_of_the_default_robot_are_told() {
    let output = frs(&[DEFAULT]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let shown = text(&output.stdout);
    for part in
        ["bodies from 2.0000 kg ('link_1') to 3.5000 kg ('base')", "digits to trust", "No inertia is suspicious."]
    {
        assert!(shown.contains(part), "no '{part}' in {shown}");
    }
    let told: Value = serde_json::from_slice(&frs(&[DEFAULT, "--json"]).stdout).unwrap();
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let conditioning = Conditioning::sampled(&model, 200, 1);
    assert_eq!(told["ratios"]["condition"]["value"].as_f64(), Some(conditioning.condition.value));
    assert_eq!(told["digits"]["accelerations_complement"].as_f64(), Some(conditioning.digits(Bounded::Factored)));
}

/// The check fails: once because no body is like that, once because too little can be trusted.
#[test]
fn what_fails_is_said() {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mistaken_units.urdf");
    std::fs::write(&path, link(1.0, [1e-9; 3])).unwrap();
    let output = frs(&[path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stdout).contains("impossible: link 'hull': its mass is packed to"), "{output:?}");
    assert!(text(&output.stderr).contains("1 link has an inertia that no body can have"), "{output:?}");

    let output = frs(&[DEFAULT, "--digits", "15"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text(&output.stderr).contains("digits of the accelerations can be trusted, asked for are 15"),
        "{output:?}"
    );
    assert_eq!(frs(&["nowhere.urdf"]).status.code(), Some(2));
}

/// Over a light base every way but the complement form loses digits, and a robot knows it.
#[test]
fn a_light_base_is_seen_in_the_digits_of_other_ways() {
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let mut base = model.links()[0].inertial;
    (base.mass, base.inertia) = (base.mass * 1e-6, base.inertia * 1e-6);
    let light = Conditioning::sampled(&model.with_inertial("base", base).unwrap(), 20, 1);
    assert!(light.lightness.value > 1e4 && light.lightness.coordinate == Some(0), "{light:?}");
    assert!(light.digits(Bounded::Quantities) > light.digits(Bounded::TextbookInertia) + 4.0);
    assert!(light.digits(Bounded::Factored) > light.digits(Bounded::Articulated) + 4.0);
}
