//! What a person who wrote a wrong URDF is told: every line, word for word.

use frs_core::Model;
use frs_core::model::Severity;
use frs_core::urdf::{Options, parse};

/// A base and an arm with a joint between them; `joint` stands in the joint, `more` after the links, from line 6 on.
fn arm(kind: &str, joint: &str, more: &str) -> String {
    format!(
        r#"<robot name="arm">
<link name="base"><inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<link name="hand"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
<joint name="elbow" type="{kind}"><parent link="base"/><child link="hand"/>
{joint}</joint>
{more}</robot>"#
    )
}

/// One link whose inertial has this content, on line 2.
fn stone(inertial: &str) -> String {
    format!("<robot name=\"stone\"><link name=\"stone\">\n<inertial>{inertial}</inertial></link></robot>")
}

const UNIT_INERTIA: &str = r#"<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>"#;

#[track_caller]
fn assert_told(urdf: &str, expected: &str) {
    let error = Model::from_urdf(urdf).unwrap_err();
    assert_eq!(error.to_string(), expected);
    assert_eq!(error.problems().len(), expected.lines().count());
}

#[track_caller]
fn assert_warned(urdf: &str, options: &Options, expected: &str) {
    let model = Model::from_urdf_with(urdf, options).unwrap();
    let warnings: Vec<String> = model.warnings().iter().map(ToString::to_string).collect();
    assert_eq!(warnings.join("\n"), expected);
}

#[test]
fn the_arm_and_the_stone_are_robots() {
    assert_eq!(Model::from_urdf(&arm("revolute", "", "")).unwrap().dof(), 1);
    assert_eq!(Model::from_urdf(&stone(&format!("<mass value='1'/>{UNIT_INERTIA}"))).unwrap().dof(), 0);
}

// Text that is no URDF.

#[test]
fn empty_file() {
    for urdf in ["", " \n\t "] {
        assert_told(urdf, "robot.urdf:1:1: file: the file is empty; expected a <robot> element; is it the right file?");
    }
}

#[test]
fn not_xml() {
    assert_told(
        "solid teapot\n",
        "robot.urdf:1:1: file: unknown token; expected well-formed XML; correct the text there, or check that it is a URDF file",
    );
    assert_told(
        "<robot name=\"a\">\n  <link name=base/>\n</robot>",
        "robot.urdf:2:14: file: expected a quote not 'b'; expected well-formed XML; correct the text there, or check that it is a URDF file",
    );
    assert_told(
        "<robot>\n<link name=\"é\"></lnk>\n</robot>",
        "robot.urdf:2:16: file: expected 'link' tag, not 'lnk'; expected well-formed XML; correct the text there, or check that it is a URDF file",
    );
    assert_told(
        "<robot>\n<link>\n",
        "robot.urdf:3:1: file: the root node was opened but never closed; expected well-formed XML; correct the text there, or check that it is a URDF file",
    );
}

#[test]
fn other_formats() {
    assert_told(
        "<?xml version='1.0'?>\n<sdf version='1.6'/>",
        "robot.urdf:2:1: file: the root element is <sdf>; expected <robot>; this looks like SDF: convert it to URDF first",
    );
    assert_told(
        "<mujoco/>",
        "robot.urdf:1:1: file: the root element is <mujoco>; expected <robot>; this looks like MJCF: convert it to URDF first",
    );
    assert_told("<html/>", "robot.urdf:1:1: file: the root element is <html>; expected <robot>; is it a URDF file?");
    assert_told(
        "<robot xmlns:xacro='http://ros.org/wiki/xacro'>\n  <xacro:property name='m' value='1'/></robot>",
        "robot.urdf:2:3: file: a macro, <xacro:property>; expected plain URDF; expand the file by xacro first",
    );
    assert_told(
        "<robot>\n  <xacro:macro/></robot>",
        "robot.urdf:2:4: file: an unknown namespace prefix 'xacro'; expected plain URDF; expand the file by xacro first",
    );
    assert_told(
        &stone(&format!("<mass value=\"${{m}}\"/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass value is '${m}'; expected a finite number; expand the file by xacro first",
    );
}

#[test]
fn document_type_declarations() {
    let bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE robot [\n<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;\">]>\n<robot name=\"&b;\"/>";
    assert_told(
        bomb,
        "robot.urdf:2:1: file: a document type declaration; expected none; take it out, and replace the entities it declares by their values",
    );
}

// Links.

#[test]
fn names_of_links() {
    assert_told(
        "<robot/>",
        "robot.urdf:1:1: robot: the robot has no link; expected at least one link; describe its links",
    );
    let link = &format!("<inertial><mass value='1'/>{UNIT_INERTIA}</inertial></link>");
    assert_told(
        &format!("<robot>\n<link>{link}\n <link name=''>{link}</robot>"),
        "robot.urdf:2:1: link 0: the link has no name; expected a name; give it a name that no other link has\n\
         robot.urdf:3:14: link 1: the link has no name; expected a name; give it a name that no other link has",
    );
    assert_told(
        &format!("<robot>\n<link name='a'>{link}\n<link name='a'>{link}</robot>"),
        "robot.urdf:3:13: link 'a': an earlier link has the same name; expected names that are unique among links; rename one of them",
    );
}

#[test]
fn masses() {
    assert_told(
        &stone(UNIT_INERTIA),
        "robot.urdf:2:1: link 'stone': <inertial> has no <mass>; expected <inertial> with <mass>; add <mass>, or take <inertial> away",
    );
    assert_told(
        &stone(&format!("<mass/>{UNIT_INERTIA}")),
        "robot.urdf:2:11: link 'stone': <mass> has no attribute value; expected a number; write <mass value=\"…\">",
    );
    assert_told(
        &stone(&format!("<mass value='1 kg'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass value is '1 kg'; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone(&format!("<mass value='1,5'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass value is '1,5'; expected a finite number; separate numbers by spaces, and write decimals with a point",
    );
    assert_told(
        &stone(&format!("<mass value='NaN'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass value is 'NaN'; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone(&format!("<mass value='1e400'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass value is '1e400'; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone(&format!("<mass value='1e31'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass is 1e31; expected magnitudes up to 1e30; write plain numbers in kg, m, rad and s",
    );
    assert_told(
        &stone(&format!("<mass value='-1'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass is -1; expected a mass that is not negative; correct it, or write 0 for a link without mass",
    );
    assert_told(
        &stone(&format!("<mass value='1e-31'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': mass is 1e-31; expected 0, or at least 1e-30; correct it, or write 0 for a link without mass",
    );
    assert_told(
        &stone(&format!("<mass value='0'/>{UNIT_INERTIA}")),
        "robot.urdf:1:1: robot: no link has mass; expected a total mass that is positive; give at least one link an inertial with mass",
    );
    assert_told(
        &stone(&format!("<mass value='1'/>\n<mass value='2'/>{UNIT_INERTIA}")),
        "robot.urdf:3:1: link 'stone': a second <mass> in <inertial>; expected one; take one away",
    );
}

#[test]
fn inertias() {
    assert_told(
        &stone("<mass value='1'/>"),
        "robot.urdf:2:1: link 'stone': <inertial> has no <inertia>; expected <inertial> with <inertia>; add <inertia>, or take <inertial> away",
    );
    assert_told(
        &stone("<mass value='1'/>\n  <inertia ixx='1' iyy='x' izz='1' ixy='0' ixz='0'/>"),
        "robot.urdf:3:3: link 'stone': <inertia> has no attribute iyz; expected a number; write <inertia iyz=\"…\">\n\
         robot.urdf:3:25: link 'stone': inertia iyy is 'x'; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone("<mass value='1'/>\n  <inertia ixx='1' ixy='2' ixz='0' iyy='1' iyz='0' izz='1'/>"),
        "robot.urdf:3:3: link 'stone': inertia has the principal moments -1 1 3; expected moments that are not negative; correct the inertia: it is about the centre of mass, with the products ixy = −∫xy dm and so on",
    );
    assert_told(
        &stone("<mass value='1'/>\n  <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='3'/>"),
        "robot.urdf:3:3: link 'stone': inertia has the principal moments 1 1 3; expected the largest to be at most the sum of the other two, 2; correct the inertia, which no body can have; lenient reading makes this a warning",
    );
    assert_told(
        &stone(&format!("<origin xyz='0 0'/><mass value='1'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': origin xyz is '0 0' (2 numbers); expected three finite numbers; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone(&format!("<origin rpy='0 0 0 1'/><mass value='1'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': origin rpy is '0 0 0 1' (4 numbers); expected three finite numbers; write it like -0.25 or 1e-3",
    );
    assert_told(
        &stone(&format!("<origin xyz='0 0 1e40'/><mass value='1'/>{UNIT_INERTIA}")),
        "robot.urdf:2:24: link 'stone': centre of mass is 0 0 1e40; expected magnitudes up to 1e30; write plain numbers in kg, m, rad and s",
    );
}

#[test]
fn inertias_that_violate_the_triangle_inequality_are_warnings_if_asked() {
    let urdf = stone("<mass value='1'/>\n  <inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='3'/>");
    assert_warned(
        &urdf,
        &Options { lenient: true, ..Options::default() },
        "robot.urdf:3:3: warning: link 'stone': inertia has the principal moments 1 1 3; expected the largest to be at most the sum of the other two, 2; correct the inertia, which no body can have; lenient reading makes this a warning",
    );
    let negative = stone("<mass value='1'/><inertia ixx='1' ixy='2' ixz='0' iyy='1' iyz='0' izz='1'/>");
    let error = Model::from_urdf_with(&negative, &Options { lenient: true, ..Options::default() }).unwrap_err();
    assert_eq!(error.problems()[0].severity, Severity::Error);
}

#[test]
fn inertias_rounded_to_few_digits_are_inertias() {
    for inertia in [
        "ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='2.0009'",
        "ixx='0.5' ixy='0.5004' ixz='0' iyy='0.5' iyz='0' izz='1'",
        "ixx='1e-17' ixy='0' ixz='0' iyy='-1e-18' iyz='0' izz='0'",
    ] {
        let urdf = arm(
            "revolute",
            "",
            &format!(
                "<link name='tip'><inertial><mass value='1'/><inertia {inertia}/></inertial></link><joint name='wrist' type='fixed'><parent link='hand'/><child link='tip'/></joint>"
            ),
        );
        Model::from_urdf(&urdf).unwrap();
    }
}

#[test]
fn columns_count_characters() {
    let urdf = stone(&format!("<mass value='1'/>{UNIT_INERTIA}"))
        .replace("</robot>", "<link name='é'><inertial/></link></robot>");
    let places: Vec<_> =
        Model::from_urdf(&urdf).unwrap_err().problems().iter().map(|p| p.place.clone().unwrap().column).collect();
    let letter = urdf.lines().nth(1).unwrap().find("é").unwrap() + 1;
    assert_eq!(places, [letter, letter + 3, letter + 3]);
}

// Joints.

#[test]
fn names_of_joints() {
    assert_told(
        "<robot><link name='a'/>\n<joint type='fixed'><parent link='b'/><child/></joint>\n<joint name='j'><parent/></joint></robot>",
        "robot.urdf:2:1: joint 0: the joint has no name; expected a name; give it a name that no other joint has\n\
         robot.urdf:2:35: joint 0: parent is 'b'; expected the name of a link; add a link 'b', or correct the name\n\
         robot.urdf:2:39: joint 0: no child link; expected the name of a link; say which link is the joint's child\n\
         robot.urdf:3:1: joint 'j': <joint> has no attribute type; expected a joint type; write <joint type=\"…\">\n\
         robot.urdf:3:1: joint 'j': no child link; expected the name of a link; say which link is the joint's child\n\
         robot.urdf:3:17: joint 'j': no parent link; expected the name of a link; say which link is the joint's parent",
    );
    let again =
        "<link name='tool'/>\n<joint name='elbow' type='fixed'><parent link='hand'/><child link='tool'/></joint>";
    assert_told(
        &arm("revolute", "", again),
        "robot.urdf:7:14: joint 'elbow': an earlier joint has the same name; expected names that are unique among joints; rename one of them",
    );
}

#[test]
fn types_of_joints() {
    assert_told(
        &arm("hinge", "", ""),
        "robot.urdf:4:27: joint 'elbow': joint type is 'hinge'; expected revolute, continuous, prismatic, fixed, planar, floating; choose one of these",
    );
    assert_told(
        &arm("Revolute", "", ""),
        "robot.urdf:4:27: joint 'elbow': joint type is 'Revolute'; expected revolute, continuous, prismatic, fixed, planar, floating; choose one of these",
    );
    assert_told(
        &arm("floating", "", ""),
        "robot.urdf:4:27: joint 'elbow': floating joint out of 'base', which has mass or inertia; expected floating joints only out of a massless root link without other children, the world; take the joint away, since the base floats anyway, or describe two robots",
    );
    let deeper =
        "<link name='tool'/>\n<joint name='free' type='floating'><parent link='hand'/><child link='tool'/></joint>";
    assert_told(
        &arm("revolute", "", deeper),
        "robot.urdf:7:26: joint 'free': floating joint out of 'hand', which is not the root link; expected floating joints only out of a massless root link without other children, the world; take the joint away, since the base floats anyway, or describe two robots",
    );
    let world = "<link name='world'/>\n<joint name='free' type='floating'><parent link='world'/><child link='base'/></joint>\n<link name='rock'/><joint name='still' type='fixed'><parent link='world'/><child link='rock'/></joint>";
    assert_told(
        &arm("revolute", "", world),
        "robot.urdf:7:26: joint 'free': floating joint out of 'world', which has other children too; expected floating joints only out of a massless root link without other children, the world; take the joint away, since the base floats anyway, or describe two robots",
    );
}

#[test]
fn axes_and_origins() {
    assert_told(
        &arm("revolute", "<axis xyz='0 0 0'/>", ""),
        "robot.urdf:5:12: joint 'elbow': axis is 0 0 0; expected a direction; name the axis of motion in the child link's frame, such as 0 0 1",
    );
    assert_told(
        &arm("revolute", "<axis/>", ""),
        "robot.urdf:5:1: joint 'elbow': <axis> has no attribute xyz; expected three numbers; write <axis xyz=\"…\">",
    );
    assert_told(
        &arm("revolute", "<axis xyz='0 0 one'/>", ""),
        "robot.urdf:5:12: joint 'elbow': axis xyz is 'one'; expected three finite numbers; write it like -0.25 or 1e-3",
    );
    assert_told(
        &arm("revolute", "<axis xyz='1 0 0'/>\n<axis xyz='0 1 0'/>", ""),
        "robot.urdf:6:1: joint 'elbow': a second <axis> in <joint>; expected one; take one away",
    );
    assert_told(
        &arm("prismatic", "<origin xyz='0 0' rpy='nan 0 0'/>", ""),
        "robot.urdf:5:14: joint 'elbow': origin xyz is '0 0' (2 numbers); expected three finite numbers; write it like -0.25 or 1e-3\n\
         robot.urdf:5:24: joint 'elbow': origin rpy is 'nan'; expected three finite numbers; write it like -0.25 or 1e-3",
    );
    assert_told(
        &arm("prismatic", "<origin xyz='0 0 -1e99'/>", ""),
        "robot.urdf:5:1: joint 'elbow': origin is 0 0 -1e99; expected magnitudes up to 1e30; write plain numbers in kg, m, rad and s",
    );
    Model::from_urdf(&arm("fixed", "<axis xyz='0 0 0'/>", "")).unwrap();
}

#[test]
fn limits_and_dynamics() {
    assert_told(
        &arm("revolute", "<limit lower='-pi' upper='inf' effort='' velocity='1'/>", ""),
        "robot.urdf:5:15: joint 'elbow': limit lower is '-pi'; expected a finite number; write it like -0.25 or 1e-3\n\
         robot.urdf:5:27: joint 'elbow': limit upper is 'inf'; expected a finite number; write it like -0.25 or 1e-3\n\
         robot.urdf:5:40: joint 'elbow': limit effort is ''; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &arm("revolute", "<dynamics damping='low' friction='1e40'/>", ""),
        "robot.urdf:5:1: joint 'elbow': dynamics (damping friction rotor-inertia) is 0 1e40 0; expected magnitudes up to 1e30; write plain numbers in kg, m, rad and s\n\
         robot.urdf:5:20: joint 'elbow': dynamics damping is 'low'; expected a finite number; write it like -0.25 or 1e-3",
    );
    let model =
        Model::from_urdf(&arm("revolute", "<limit lower='-1' effort='5'/><dynamics friction='0.5'/>", "")).unwrap();
    let limits = model.coordinates()[0].limits;
    assert_eq!((limits.lower, limits.upper, limits.effort, limits.velocity), (Some(-1.0), None, Some(5.0), None));
    assert_eq!((limits.damping, limits.friction, limits.rotor_inertia), (0.0, 0.5, 0.0));
}

/// A finger on the hand, whose joint has this content on line 7.
fn finger(kind: &str, joint: &str) -> String {
    format!(
        "<link name='finger'><inertial><mass value='1'/>{UNIT_INERTIA}</inertial></link>\n<joint name='knuckle' type='{kind}'><parent link='hand'/><child link='finger'/>{joint}</joint>"
    )
}

#[test]
fn mimics() {
    assert_told(
        &arm("revolute", "", &finger("revolute", "<mimic joint='ellbow'/>")),
        "robot.urdf:7:82: joint 'knuckle': mimic of joint 'ellbow'; expected the name of another joint; correct the name, or take the mimic away to make the joint a coordinate of its own",
    );
    assert_told(
        &arm("revolute", "", &finger("revolute", "<mimic/>")),
        "robot.urdf:7:82: joint 'knuckle': mimic names no joint; expected the name of another joint; correct the name, or take the mimic away to make the joint a coordinate of its own",
    );
    assert_told(
        &arm("revolute", "", &finger("revolute", "<mimic joint='elbow' multiplier='two'/>")),
        "robot.urdf:7:115: joint 'knuckle': mimic multiplier is 'two'; expected a finite number; write it like -0.25 or 1e-3",
    );
    assert_told(
        &arm("revolute", "", &finger("revolute", "<mimic joint='elbow' offset='1e31'/>")),
        "robot.urdf:7:82: joint 'knuckle': mimic (multiplier offset) is 1 1e31; expected magnitudes up to 1e30; write plain numbers in kg, m, rad and s",
    );
    assert_told(
        &arm("revolute", "<mimic joint='knuckle'/>", &finger("revolute", "<mimic joint='elbow'/>")),
        "robot.urdf:5:1: joint 'elbow': mimic joints follow one another in a circle: 'elbow' 'knuckle' 'elbow'; expected a chain of mimics that ends at a joint without one; take the mimic of one of these joints away",
    );
    assert_told(
        &arm("revolute", "<mimic joint='elbow'/>", ""),
        "robot.urdf:5:1: joint 'elbow': mimic joints follow one another in a circle: 'elbow' 'elbow'; expected a chain of mimics that ends at a joint without one; take the mimic of one of these joints away",
    );
    assert_told(
        &arm("planar", "", &finger("revolute", "<mimic joint='elbow'/>")),
        "robot.urdf:7:82: joint 'knuckle': mimic of joint 'elbow', which is planar; expected revolute, continuous or prismatic joints to follow one another; take the mimic away, or change the leader's type",
    );
    assert_told(
        &arm("revolute", "", &finger("planar", "<mimic joint='elbow'/>")),
        "robot.urdf:7:80: joint 'knuckle': a planar joint with a mimic; expected revolute, continuous or prismatic joints to follow one another; take the mimic away, or change the joint's type",
    );
}

#[test]
fn mimics_that_do_nothing_are_warnings() {
    let options = Options { file: "hands/left.urdf", ..Options::default() };
    assert_warned(
        &arm("revolute", "", &finger("revolute", "<mimic joint='elbow' multiplier='0'/>")),
        &options,
        "hands/left.urdf:7:82: warning: joint 'knuckle': mimic multiplier is 0, which locks the joint at the offset; expected a multiplier that is not 0; make the joint fixed if it shall not move",
    );
    assert_warned(
        &arm("revolute", "", &finger("fixed", "<mimic joint='elbow'/>")),
        &options,
        "hands/left.urdf:7:79: warning: joint 'knuckle': a fixed joint with a mimic; expected revolute, continuous or prismatic joints to follow one another; take the mimic away, or change the joint's type",
    );
}

// The tree.

#[test]
fn links_that_are_not_one_tree() {
    assert_told(
        &arm("fixed", "", "<link name='loose'/>"),
        "robot.urdf:6:13: link 'loose': no joint connects the link; expected one tree with one root; connect it with a joint whose child is 'loose', or take it away",
    );
    let second = "<link name='b'/>\n<link name='c'/>\n<joint name='other' type='fixed'><parent link='b'/><child link='c'/></joint>";
    assert_told(
        &arm("fixed", "", second),
        "robot.urdf:6:13: link 'b': a second root: like 'base', it is nobody's child; expected one tree with one root; connect it with a joint whose child is 'b', or take it away",
    );
    let two_parents = "<link name='b'/>\n<joint name='b' type='fixed'><parent link='base'/><child link='b'/></joint>\n<joint name='close' type='fixed'><parent link='b'/><child link='hand'/></joint>";
    assert_told(
        &arm("fixed", "", two_parents),
        "robot.urdf:8:65: joint 'close': link 'hand' is the child of joint 'elbow' already; expected links that are the child of one joint at most; take one of the joints away: a kinematic loop must be cut open",
    );
    let ring = "<link name='b'/><link name='c'/><joint name='bc' type='fixed'><parent link='b'/><child link='c'/></joint>\n<joint name='cb' type='fixed'><parent link='c'/><child link='b'/></joint>";
    assert_told(
        &arm("fixed", "", ring),
        "robot.urdf:6:33: joint 'bc': a loop of the joints 'bc' 'cb'; expected a tree of links; take one of these joints away, or give it another parent",
    );
    assert_told(
        "<robot><link name='a'/>\n<joint name='self' type='fixed'><parent link='a'/><child link='a'/></joint></robot>",
        "robot.urdf:2:1: joint 'self': a loop of the joints 'self'; expected a tree of links; take one of these joints away, or give it another parent",
    );
}

#[test]
fn unknown_root() {
    let error = Model::from_urdf_with(&arm("fixed", "", ""), &Options { root: Some("foot"), ..Options::default() });
    assert_eq!(
        error.unwrap_err().to_string(),
        "robot.urdf:1:1: robot: root is 'foot'; expected the name of a link; choose one of the links, such as 'base'"
    );
}

// Masses that leave motions undetermined.

#[test]
fn motions_that_move_nothing() {
    let tip = |kind: &str, inertial: &str, joint: &str| {
        format!(
            "<link name='tip'>{inertial}</link>\n<joint name='wrist' type='{kind}'><parent link='hand'/><child link='tip'/>{joint}</joint>"
        )
    };
    assert_told(
        &arm("revolute", "", &tip("revolute", "", "")),
        "robot.urdf:7:1: joint 'wrist': nothing beyond the joint, from link 'tip' on, has mass or inertia; expected something to move on both sides of a moving joint, else its motion is undetermined; give 'tip' an inertial, or make the joint fixed",
    );
    let wheel = &format!("<inertial><mass value='0'/>{UNIT_INERTIA}</inertial>");
    assert_told(
        &arm("revolute", "", &tip("prismatic", wheel, "")),
        "robot.urdf:7:1: joint 'wrist': nothing beyond the joint, from link 'tip' on, has mass; expected something to move on both sides of a moving joint, else its motion is undetermined; give 'tip' an inertial, or make the joint fixed",
    );
    assert_told(
        &arm("revolute", "", &tip("planar", wheel, "")),
        "robot.urdf:7:1: joint 'wrist': nothing beyond the joint, from link 'tip' on, has mass; expected something to move on both sides of a moving joint, else its motion is undetermined; give 'tip' an inertial, or make the joint fixed",
    );
    Model::from_urdf(&arm("revolute", "", &tip("revolute", wheel, ""))).unwrap();
    Model::from_urdf(&arm("revolute", "", &tip("revolute", "", "<mimic joint='elbow'/>"))).unwrap();
    let leader = finger("revolute", "<mimic joint='wrist'/>");
    Model::from_urdf(&arm("revolute", "", &(tip("revolute", "", "") + &leader))).unwrap();
    // Seen from the tip, it is the rest of the robot that has mass.
    let from_tip = Options { root: Some("tip"), ..Options::default() };
    let error = Model::from_urdf_with(&arm("revolute", "", &tip("continuous", "", "")), &from_tip);
    assert_eq!(
        error.unwrap_err().to_string(),
        "robot.urdf:7:1: joint 'wrist': nothing on the base's side of the joint, from link 'tip' on, has mass or inertia; expected something to move on both sides of a moving joint, else its motion is undetermined; give 'tip' an inertial, or make the joint fixed"
    );
}

#[test]
fn motions_that_masses_on_one_line_do_not_resist() {
    let inertia = |ixx, iyy, izz| {
        format!("<mass value='1'/><inertia ixx='{ixx}' ixy='0' ixz='0' iyy='{iyy}' iyz='0' izz='{izz}'/>")
    };
    assert_told(
        &stone(&inertia(0, 0, 0)),
        "robot.urdf:1:1: robot: nothing resists some motion of the base: all masses lie on one line, or give way by joints; expected a base whose motion moves something; give link 'stone' mass and rotational inertia",
    );
    assert_told(
        &stone(&inertia(1, 1, 0)),
        "robot.urdf:1:1: robot: nothing resists some motion of the base: all masses lie on one line, or give way by joints; expected a base whose motion moves something; give link 'stone' mass and rotational inertia",
    );
    let point = format!("<inertial><origin xyz='2 0 0'/>{}</inertial>", inertia(0, 0, 0));
    let tip = |kind: &str, axis: &str| {
        format!(
            "<link name='tip'>{point}</link>\n<joint name='wrist' type='{kind}'><parent link='hand'/><child link='tip'/><axis xyz='{axis}'/></joint>"
        )
    };
    assert_told(
        &arm("revolute", "", &tip("revolute", "1 0 0")),
        "robot.urdf:7:1: joint 'wrist': nothing resists the joint's motion: all masses it moves lie on its axis, or give way by other joints; expected something to move, else the motion is undetermined; give the links beyond it rotational inertia, or make the joint fixed",
    );
    Model::from_urdf(&arm("revolute", "", &tip("revolute", "1 1e-3 0"))).unwrap();
    Model::from_urdf(&arm("revolute", "", &tip("prismatic", "1 0 0"))).unwrap();
    // Two joints about one axis, with nothing between them.
    let shaft =
        "<link name='shaft'/><joint name='inner' type='revolute'><parent link='hand'/><child link='shaft'/></joint>";
    let wheel = |axis: &str| {
        format!(
            "{shaft}<link name='wheel'><inertial>{}</inertial></link>\n<joint name='outer' type='revolute'><parent link='shaft'/><child link='wheel'/><axis xyz='{axis}'/></joint>",
            inertia(1, 1, 1)
        )
    };
    assert_told(
        &arm("revolute", "", &wheel("-1 0 0")),
        "robot.urdf:6:21: joint 'inner': nothing resists the joint's motion: all masses it moves lie on its axis, or give way by other joints; expected something to move, else the motion is undetermined; give the links beyond it rotational inertia, or make the joint fixed",
    );
    Model::from_urdf(&arm("revolute", "", &wheel("0 1 0"))).unwrap();
}

#[test]
fn rounding_does_not_resist_a_motion() {
    for along in ["0.1 0.2 0.3", "0.3 0.1 -0.7", "-0.9 0.3 0.1", "0.7 -0.6 0.1", "0.3 0.3 0.1"] {
        let tip = format!(
            "<link name='tip'><inertial><origin xyz='{along}'/><mass value='1'/><inertia ixx='0' ixy='0' ixz='0' iyy='0' iyz='0' izz='0'/></inertial></link>
             <joint name='wrist' type='revolute'><parent link='hand'/><child link='tip'/><axis xyz='{along}'/></joint>"
        );
        let error = Model::from_urdf(&arm("fixed", "", &tip)).unwrap_err();
        assert!(error.problems()[0].found.starts_with("nothing resists the joint's motion"), "{error}");
    }
}

#[test]
fn a_motion_that_masses_resist_in_all_but_some_shapes_is_determined() {
    // With the middle joint at 0, the axes of the outer ones are one.
    let wrist = "<link name='yoke'/><link name='cross'/>
      <joint name='roll' type='revolute'><parent link='hand'/><child link='yoke'/><axis xyz='0 0 1'/></joint>
      <joint name='pitch' type='revolute'><parent link='yoke'/><child link='cross'/><axis xyz='0 1 0'/></joint>";
    let urdf =
        arm("fixed", "", &(wrist.to_owned() + &finger("revolute", "<axis xyz='0 0 1'/>").replace("hand", "cross")));
    assert_eq!(Model::from_urdf(&urdf).unwrap().dof(), 3);
}

#[test]
fn no_mass_at_all() {
    assert_told(
        "<robot><link name='a'/><link name='b'/><joint name='ab' type='revolute'><parent link='a'/><child link='b'/></joint></robot>",
        "robot.urdf:1:1: robot: no link has mass; expected a total mass that is positive; give at least one link an inertial with mass",
    );
}

#[test]
fn all_problems_are_told_at_once_in_the_order_of_the_text() {
    let urdf = "<robot name=\"wreck\">
  <link name=\"base\"><inertial><mass value=\"-2\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"9\"/></inertial></link>
  <joint name=\"j\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/><axis xyz=\"0 0 0\"/></joint>
  <link name=\"arm\"/>
  <joint name=\"k\" type=\"screw\"><parent link=\"arm\"/><child link=\"hand\"/><origin xyz=\"1 2\"/></joint>
</robot>";
    assert_told(
        urdf,
        "robot.urdf:2:44: link 'base': mass is -2; expected a mass that is not negative; correct it, or write 0 for a link without mass\n\
         robot.urdf:2:49: link 'base': inertia has the principal moments 1 1 9; expected the largest to be at most the sum of the other two, 2; correct the inertia, which no body can have; lenient reading makes this a warning\n\
         robot.urdf:3:86: joint 'j': axis is 0 0 0; expected a direction; name the axis of motion in the child link's frame, such as 0 0 1\n\
         robot.urdf:5:25: joint 'k': joint type is 'screw'; expected revolute, continuous, prismatic, fixed, planar, floating; choose one of these\n\
         robot.urdf:5:65: joint 'k': child is 'hand'; expected the name of a link; add a link 'hand', or correct the name\n\
         robot.urdf:5:85: joint 'k': origin xyz is '1 2' (2 numbers); expected three finite numbers; write it like -0.25 or 1e-3",
    );
}

#[test]
fn what_is_not_a_link_or_joint_is_passed_over() {
    let more = "<material name='blue'/><transmission name='t'><joint name='elbow'/></transmission><gazebo reference='base'><link/></gazebo>
      <tool:link xmlns:tool='http://example.org/tool'/>";
    assert_eq!(
        Model::from_urdf(&arm("revolute", "<safety_controller k_velocity='x'/>", more)).unwrap().links().len(),
        2
    );
}

#[test]
fn robots_without_a_name_are_called_after_their_file() {
    let urdf = stone(&format!("<mass value='1'/>{UNIT_INERTIA}")).replacen("name=\"stone\"", "", 1);
    for (file, name) in [("robots/hexapod.v2.urdf", "hexapod.v2"), ("", "robot")] {
        assert_eq!(parse(&urdf, &Options { file, ..Options::default() }).unwrap().name, name);
    }
    assert_eq!(Model::from_urdf(&urdf).unwrap().name(), "robot");
}

// Texts that try a reader's patience.

#[test]
fn deep_nesting() {
    const LEVELS: usize = 100_000;
    let urdf = format!("<robot>{}{}</robot>", "<a>".repeat(LEVELS), "</a>".repeat(LEVELS));
    assert_told(&urdf, "robot.urdf:1:1: robot: the robot has no link; expected at least one link; describe its links");
    let nested = format!("<robot>{}", "<link name='a'>".repeat(LEVELS));
    assert_eq!(Model::from_urdf(&nested).unwrap_err().problems()[0].place.as_ref().unwrap().column, nested.len() + 1);
}

#[test]
fn ten_megabytes_of_junk() {
    let fill = |piece: &str| piece.repeat(10_000_000 / piece.len());
    let attributes = format!("<robot {}/>", (0..600_000).map(|i| format!("a{i}=\"\" ")).collect::<String>());
    let namespaces: String = (0..300_000).map(|i| format!("<a xmlns:n{i}=\"{i}\">")).collect();
    for junk in [
        fill("x"),
        fill("<"),
        fill("<a>"),
        fill("\n"),
        fill("\u{0}"),
        format!("<robot>{}</robot>", fill("<link name='é'><inertial><mass value='?'/></inertial></link>")),
    ] {
        assert!(Model::from_urdf(&junk).unwrap_err().problems()[0].place.is_some());
    }
    for crowd in [attributes, namespaces] {
        let told = Model::from_urdf(&crowd).unwrap_err().to_string();
        assert!(told.contains("more than 1000 attributes in one element, or namespaces in all"));
    }
}
