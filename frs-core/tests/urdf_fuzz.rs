//! Whatever bytes come in, the answer is a robot made of finite numbers, or problems with their places.

use frs_core::Model;
use frs_core::model::Severity;
use frs_core::urdf::{LWR_SATELLITE, Options};
use proptest::prelude::*;

const GRIPPER: &str = r#"<?xml version="1.0"?>
<robot name="gripper" xmlns:xacro="http://wiki.ros.org/xacro">
  <!-- a world, a free base, two fingers that mimic one another -->
  <link name="world"/>
  <joint name="free" type="floating"><parent link="world"/><child link="palm"/></joint>
  <link name="palm">
    <inertial><origin xyz="0.1 0 0" rpy="0 0.5 0"/><mass value="2"/>
      <inertia ixx="0.01" ixy="0" ixz="0.001" iyy="0.02" iyz="0" izz="0.02"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry></visual>
  </link>
  <link name="left"><inertial><mass value="0.5"/><inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial></link>
  <link name="right"><inertial><mass value="0.5"/><inertia ixx="1e-3" ixy="0" ixz="0" iyy="1e-3" iyz="0" izz="1e-3"/></inertial></link>
  <joint name="close" type="prismatic"><parent link="palm"/><child link="left"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.05" effort="10" velocity="0.1"/><dynamics damping="0.5" friction="0.1"/></joint>
  <joint name="follow" type="prismatic"><parent link="palm"/><child link="right"/><axis xyz="0 -1 0"/>
    <mimic joint="close" multiplier="1" offset="0"/></joint>
</robot>
"#;

const PUCK: &str = r#"<robot name="puck"><link name="table"><inertial><mass value="9"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="puck"/><link name="rim"><inertial>
<mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="glide" type="planar"><origin rpy="0 1.5707963 0"/><parent link="table"/><child link="puck"/><axis xyz="1 1 0"/></joint>
<joint name="turn" type="continuous"><parent link="puck"/><child link="rim"/></joint></robot>"#;

/// One change to a text; places are parts of its length.
#[derive(Clone, Debug)]
enum Change {
    Byte(f64, u8),
    Delete(f64, f64),
    Double(f64, f64, f64),
    Value(f64, &'static str),
    Number(f64, f64),
    SwapValues(f64, f64),
}

fn change() -> impl Strategy<Value = Change> {
    let place = || 0.0..1.0_f64;
    let short = || 0.0..0.1_f64;
    let value = prop::sample::select(vec![
        "NaN", "inf", "-inf", "1e400", "-1", "", "0", "1e30", "-1e30", "1e-300", "1e-320", "1e-30", "0 0 0", "1 2",
        "x", "world", "palm", "fixed", "planar", "floating", "revolute",
    ]);
    prop_oneof![
        1 => (place(), any::<u8>()).prop_map(|(at, byte)| Change::Byte(at, byte)),
        1 => (place(), short()).prop_map(|(at, length)| Change::Delete(at, length)),
        1 => (place(), short(), place()).prop_map(|(at, length, to)| Change::Double(at, length, to)),
        4 => (place(), value).prop_map(|(at, value)| Change::Value(at, value)),
        4 => (place(), -2.0..2.0_f64).prop_map(|(at, number)| Change::Number(at, number)),
        2 => (place(), place()).prop_map(|(a, b)| Change::SwapValues(a, b)),
    ]
}

/// Where the attribute values of a text stand, as far as double quotes tell.
fn values(bytes: &[u8]) -> Vec<std::ops::Range<usize>> {
    let quotes: Vec<usize> = bytes.iter().enumerate().filter_map(|(i, &byte)| (byte == b'"').then_some(i)).collect();
    quotes.chunks_exact(2).map(|pair| pair[0] + 1..pair[1]).collect()
}

fn apply(mut bytes: Vec<u8>, change: &Change) -> Vec<u8> {
    let place = |part: f64, length: usize| (part * length as f64) as usize;
    let length = bytes.len();
    if length == 0 {
        return bytes;
    }
    let piece = |at: f64, part: f64| place(at, length)..(place(at, length) + place(part, length)).min(length);
    let values = values(&bytes);
    let value = |part: f64| values.get(place(part, values.len())).cloned();
    match *change {
        Change::Byte(at, byte) => bytes[place(at, length)] = byte,
        Change::Delete(at, part) => drop(bytes.drain(piece(at, part))),
        Change::Double(at, part, to) => {
            let copy = bytes[piece(at, part)].to_vec();
            let to = place(to, length);
            bytes.splice(to..to, copy);
        }
        Change::Value(at, new) => {
            if let Some(old) = value(at) {
                bytes.splice(old, new.bytes());
            }
        }
        Change::Number(at, new) => {
            let is_number = |value: &&std::ops::Range<usize>| {
                std::str::from_utf8(&bytes[(*value).clone()]).is_ok_and(|text| text.parse::<f64>().is_ok())
            };
            let numbers: Vec<_> = values.iter().filter(is_number).collect();
            if let Some(&old) = numbers.get(place(at, numbers.len())) {
                bytes.splice(old.clone(), new.to_string().bytes());
            }
        }
        Change::SwapValues(a, b) => {
            if let (Some(a), Some(b)) = (value(a), value(b)) {
                let (first, second) = if a.start < b.start { (a, b) } else { (b, a) };
                if first.end < second.start {
                    let copies = (bytes[first.clone()].to_vec(), bytes[second.clone()].to_vec());
                    bytes.splice(second, copies.0);
                    bytes.splice(first, copies.1);
                }
            }
        }
    }
    bytes
}

fn assert_finite(model: &Model) {
    let finite = |number: f64| {
        assert!(number.is_finite());
        number
    };
    model.map(finite);
    let mass: f64 = model.bodies().iter().map(|body| body.mass).sum();
    assert!(mass > 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn changed_urdfs_are_robots_or_told_problems(
        text in prop::sample::select(vec![LWR_SATELLITE, GRIPPER, PUCK]),
        changes in prop::collection::vec(change(), 1..6),
        lenient in any::<bool>(),
        root in prop::option::of(prop::sample::select(vec!["world", "palm", "link_3", "rim"])),
    ) {
        let bytes = changes.iter().fold(text.as_bytes().to_vec(), apply);
        let text = String::from_utf8_lossy(&bytes);
        match Model::from_urdf_with(&text, &Options { lenient, root, ..Options::default() }) {
            Ok(model) => assert_finite(&model),
            Err(error) => {
                prop_assert!(error.problems().iter().any(|problem| problem.severity == Severity::Error));
                let lines = text.matches('\n').count() + 1;
                for problem in error.problems() {
                    let place = problem.place.as_ref().expect("a place");
                    prop_assert!((1..=lines).contains(&place.line) && place.column >= 1, "{}", problem);
                }
            }
        }
    }
}

#[test]
fn the_unchanged_texts_are_robots() {
    for (text, dof) in [(LWR_SATELLITE, 7), (GRIPPER, 1), (PUCK, 4)] {
        let model = Model::from_urdf(text).unwrap();
        assert_eq!(model.dof(), dof);
        assert_finite(&model);
    }
}
