//! Wrong scenes are refused, all problems at once, each in its place.

use frs_core::{Model, urdf};
use frs_sim::scene::Scene;

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

const HEAD: &str = "robot = 'lwr_satellite.urdf'\nduration = 0.5\n";

/// Wrong scenes, and the beginning of what is said about them; line 3 is the first after the head.
#[test]
fn what_is_wrong_is_told_in_place() {
    let cases = [
        (
            "[regulator]\nset_point = {}\nstifness = 1\ndamping = 1",
            "scene.toml:3:1: regulator.stiffness: missing; expected",
        ),
        (
            "[regulator]\nset_point = {}\nstifness = 1\ndamping = 1",
            "scene.toml:5:1: regulator.stifness: unknown key; did you mean 'stiffness'? expected one of set_point",
        ),
        ("gravty = 1", "scene.toml:3:1: gravty: unknown key; did you mean 'gravity'?"),
        ("samples_per_second = 'many'", "scene.toml:3:22: samples_per_second: found string; expected a number"),
        ("samples_per_second = 1e9", "scene.toml:3:22: samples_per_second: found 1000000000; expected at most"),
        ("accuracy = 0", "scene.toml:3:12: accuracy: found 0; expected a number above 0"),
        ("accuracy = 1", "scene.toml:3:12: accuracy: found 1e0; expected a number from 1e-14"),
        (
            "accuracy = 1e-6\nsolver = { step = 0.1 }",
            "scene.toml:3:12: accuracy: solver.step is given, too; expected one of the two",
        ),
        ("solver = { method = 'rkmk4' }", "scene.toml:3:10: solver: rkmk4 does not estimate its error; expected"),
        ("solver = { method = 'rk4' }", "scene.toml:3:21: solver.method: found 'rk4'; did you mean 'rkmk4'?"),
        ("solver = { step = 0 }", "scene.toml:3:19: solver.step: found 0; expected a number above 0"),
        ("solver = { route = 3 }", "scene.toml:3:20: solver.route: found integer; expected one of articulated"),
        ("start = 3", "scene.toml:3:9: start: found integer; expected a table"),
        ("[start]\nq = { joint_9 = 1 }", "scene.toml:4:7: start.q.joint_9: unknown key; did you mean 'joint_"),
        (
            "[start]\nq = [1, 2]",
            "scene.toml:4:5: start.q: found 2 numbers; expected 7, one for each of joint_1, joint_2",
        ),
        ("[start]\nq = { joint_1 = nan }", "scene.toml:4:17: start.q.joint_1: found nan; expected a finite number"),
        ("[start]\nqd = [0, 0, 0, inf, 0, 0, 0]", "scene.toml:4:16: start.qd: found inf; expected a finite number"),
        ("[start]\nmu = [1, 2]", "scene.toml:4:6: start.mu: found 2 numbers; expected 6"),
        (
            "[start]\nmu = [0,0,0,0,0,0]\nmomentum = [0,0,0,0,0,0]",
            "scene.toml:5:12: start.momentum: mu is given, too; expected mu or momentum",
        ),
        ("[gravity]", "scene.toml:3:1: gravity.acceleration: missing; expected three numbers"),
        ("[friction]\nviscous = -1", "scene.toml:4:11: friction.viscous: found -1; expected no negative number"),
        ("[wrench]", "scene.toml:3:1: wrench: no wrench; expected moment, force, or both"),
        (
            "[[wrench]]\nforce = [1, 0, 0]\nend = 0.1\n[[wrench]]\nforce = [1, 0, 0]\nstart = 0.2\nend = 0.1",
            "scene.toml:6:1: wrench: it acts from 0.2 s to 0.1 s; expected a start before the end",
        ),
        ("[wrench]\nforce = [1, 0, 0]\nstart = 0.5", "scene.toml:3:1: wrench: it acts from 0.5 s to inf s; expected"),
        (
            "[wrench]\nforce = [1, 0, 0]\naxes = 'wrld'",
            "scene.toml:5:8: wrench.axes: found 'wrld'; did you mean 'world'?",
        ),
        (
            "[joint_torque]\ntau = { joint_1 = 'a' }",
            "scene.toml:4:19: joint_torque.tau.joint_1: found string; expected a number",
        ),
        (
            "[spring]\nstiffness = 1\nrest = 2",
            "scene.toml:5:8: spring.rest: found integer; expected a list of numbers, or a table",
        ),
        ("[drag]\nlink = 'hand'", "scene.toml:4:8: drag.link: found 'hand'; expected one of base, link_1"),
        (
            "[drag]\nlink = 'base'\nrotational = [1, -1, 0]",
            "scene.toml:5:14: drag.rotational: found -1; expected no negative",
        ),
        ("[contact]\nlink = 'base'", "scene.toml:3:1: contact.stiffness: missing; expected N/m^1.5"),
        (
            "[contact]\nlink = 'base'\nstiffness = 1\nnormal = [0, 0, 0]",
            "scene.toml:6:10: contact.normal: the plane has no normal; expected a direction",
        ),
        ("[friction]", "scene.toml:3:1: friction: no friction; expected viscous"),
        (
            "[friction]\nviscous = 1\nsmooth_below = 1",
            "scene.toml:5:16: friction.smooth_below: nothing is made smooth; expected coulomb",
        ),
        (
            "[wrench]\nforce = [[1, 0, 0]]\ntimes = [0, 1]",
            "scene.toml:4:9: wrench.force: found 1 values; expected 2, one for each time",
        ),
        ("[wrench]\nforce = [1, 0, 0]\ntimes = [0, 1]\nend = 1", "scene.toml:6:7: wrench.end: times is given, too;"),
        (
            "[joint_torque]\ntau = []\ntimes = [1, 0]",
            "scene.toml:5:9: joint_torque.times: found [1.0, 0.0]; expected times that",
        ),
        (
            "[[prescribed]]\njoint = 'joint_1'\nhold = 1\nsinusoid = { amplitude = 1, rate = 1 }",
            "scene.toml:3:1: prescribed: found 2 courses; expected one of hold, sinusoid, times with values",
        ),
        (
            "[[prescribed]]\njoint = 'joint_1'\ntimes = [0, 1]\nvalues = [1]",
            "scene.toml:6:10: prescribed.values: found 1 numbers; expected 2, one for each time",
        ),
        (
            "[[prescribed]]\njoint = 'joint_1'\nhold = 1\n[joint_torque]\ntau = { joint_1 = 1 }",
            "scene.toml:1:1: joint_1 is prescribed in line 3 and has a torque in line 6; expected one of the two",
        ),
        (
            "[[prescribed]]\njoint = 'joint_1'\nhold = 1\n[[prescribed]]\njoint = 'joint_1'\nhold = 2",
            "scene.toml:1:1: joint_1 is prescribed in line 3 and in line 6; expected one course",
        ),
        (
            "[start]\nq = { joint_1 = 2 }\n[[prescribed]]\njoint = 'joint_1'\nhold = 1",
            "scene.toml:4:5: start.q: found 2 for joint_1; expected 1, where its course of line 5 begins, or nothing",
        ),
        (
            "[payload]\nlink = 'link_7'\nmass = 1\ninertia = [1, 1, 3, 0, 0, 0]",
            "scene.toml:6:11: payload.inertia: principal moments ",
        ),
        (
            "[payload]\nlink = 'link_7'\nmass = 1\ninertia = [1, 1, 1, 0, 0, 0]\ngrasp = 0.3\nrelease = 0.2",
            "scene.toml:3:1: payload: it is let go at 0.2 s and taken at 0.3 s; expected a release after the grasp",
        ),
        (
            "[payload]\nlink = 'link_7'\nmass = 1\ninertia = [1, 1, 1, 0, 0, 0]\ntwist = [0, 0, 0, 0, 0, 0]",
            "scene.toml:3:1: payload: it has a twist and is there from the start; expected a time of grasp",
        ),
        (
            "[computed_torque]\nbandwidth = 1\ntimes = [0, 1]\nset_point = [{ joint_1 = 1 }]",
            "scene.toml:6:13: computed_torque.set_point: found 1 values; expected 2, one for each time",
        ),
        ("[end_effector]\nlink = 'link_7'", "scene.toml:3:1: end_effector.position: missing; expected x, y, z"),
        (
            "[added_mass]\nlink = 'base'",
            "scene.toml:3:1: added_mass.inertia: missing; expected six numbers, of turning",
        ),
        (
            "[added_mass]\nlink = 'base'\ninertia = [1, 1, 1, -1, 1, 1]",
            "scene.toml:5:11: added_mass.inertia: found an eigenvalue of -1; expected none below 0",
        ),
        (
            "[added_mass]\nlink = 'base'\ninertia = [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 2, 1, 0, 0, 0], \
             [0, 0, 0, 1, 0, 0], [0, 0, 0, 0, 1, 0], [0, 0, 0, 0, 0, 1]]",
            "scene.toml:5:11: added_mass.inertia: found 2 in row 3, column 2 and 0 across the diagonal; expected",
        ),
        (
            "[added_mass]\nlink = 'base'\ninertia = [[1, 0, 0, 0, 0, 0], [0, 1]]",
            "scene.toml:5:11: added_mass.inertia: found 2 rows; expected 6",
        ),
        (
            "[added_mass]\nlink = 'base'\ninertia = [[1, 0, 0, 0, 0, 0], [0, 1], 1, 1, 1, 1]",
            "scene.toml:5:32: added_mass.inertia: found 2 numbers; expected 6: a row",
        ),
        (
            "[[added_mass]]\nlink = 'base'\ninertia = [1, 1, 1, 1, 1, 1]\n[[added_mass]]\nlink = 'link_7'\n\
             inertia = [1, 1, 1, 1, 1, 1]\ncurrent = [1, 0, 0]",
            "scene.toml:6:1: added_mass: the water moves with [0.0, 0.0, 0.0] in line 3 and with [1.0, 0.0, 0.0] in line 6",
        ),
        (
            "[[added_mass]]\nlink = 'base'\ninertia = [1, 1, 1, 1, 1, 1]\n[drag]\nlink = 'base'\ncurrent = [1, 0, 0]",
            "scene.toml:1:1: the water moves with [0.0, 0.0, 0.0] in line 3 ([added_mass]) and with [1.0, 0.0, 0.0] in line 6",
        ),
        ("duration = 1", "scene.toml:3:1: this is not TOML: duplicate key"),
        ("x = [1", "scene.toml:3:7: this is not TOML: "),
    ];
    for (text, expected) in cases {
        let error = Scene::parse("scene.toml", &format!("{HEAD}{text}"), &model()).expect_err(text).to_string();
        assert!(error.lines().any(|line| line.starts_with(expected)), "expected {expected}\nfound {error}");
    }
    for (text, expected) in [
        ("robot = 'x'", "scene.toml:1:1: duration: missing; expected how long"),
        ("robot = 'x'\nduration = -1", "scene.toml:2:12: duration: found -1; expected a number above 0"),
        ("robot = 'x'\nduration = nan", "scene.toml:2:12: duration: found nan; expected a finite number"),
    ] {
        assert!(
            Scene::parse("scene.toml", text, &model()).expect_err(text).to_string().starts_with(expected),
            "{text}"
        );
    }
    assert!(
        Scene::robot("scene.toml", "duration = 1")
            .unwrap_err()
            .to_string()
            .starts_with("scene.toml:1:1: robot: missing")
    );
}

#[test]
fn all_problems_are_told_at_once_in_the_order_of_the_file() {
    let text = "robot = 'x'\nduration = 0\nacuracy = 1\n[start]\nq = { a = 1, b = 2 }\n[friction]\nviscous = true";
    let error = Scene::parse("scene.toml", text, &model()).unwrap_err();
    let lines: Vec<usize> = error.problems.iter().map(|problem| problem.place.line).collect();
    assert_eq!(lines, [2, 3, 5, 5, 7], "{error}");
}
