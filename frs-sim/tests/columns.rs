//! Courses and forces from files of comma-separated values.

use std::io;
use std::ops::ControlFlow;

use frs_core::{Model, urdf};
use frs_sim::run::{Sample, run};
use frs_sim::scene::{Scene, SceneError};

const HEAD: &str = "robot = 'x.urdf'\nduration = 1\n";

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

/// A scene that names the file `data/table.csv`.
fn parsed(text: &str, table: &str) -> Result<Scene, SceneError> {
    let files = |path: &str| match path {
        "data/table.csv" => Ok(table.to_owned()),
        _ => Err(io::Error::new(io::ErrorKind::NotFound, "no such file")),
    };
    Scene::parse_with("scenes/scene.toml", &format!("{HEAD}{text}"), &model(), &files)
}

fn samples(text: &str, table: &str) -> Vec<Sample> {
    let scene = parsed(text, table).unwrap_or_else(|error| panic!("{error}"));
    run(&scene, &model(), |_| ControlFlow::Continue(())).samples
}

#[test]
fn a_table_in_a_file_is_the_table_in_the_scene() {
    let cases = [
        (
            "[prescribed]\njoint = 'joint_3'\n",
            "times = [0.1, 0.4, 0.9]\nvalues = [0, 1.5, -0.5]",
            "time,angle\n0.1,0\n0.4,1.5\n0.9,-0.5\n",
        ),
        ("[prescribed]\njoint = 'joint_3'\n", "times = [0.1, 0.9]\nvalues = [0, 1.5]", "0.1, 0\n\n0.9, 15e-1"),
        (
            "[joint_torque]\n",
            "times = [0, 0.5]\ntau = [{ joint_2 = 1 }, { joint_7 = -0.01 }]",
            "# N·m\n0,0,1,0,0,0,0,0\n0.5,0,0,0,0,0,0,-0.01\n",
        ),
        (
            "[wrench]\nlink = 'link_7'\n",
            "times = [0, 0.5]\nmoment = [[1, 2, 3], [0, 0, 0]]\nforce = [[0, 0, 0], [4, 5, 6]]",
            "\"t / s\",mx,my,mz,fx,fy,fz\r\n0,1,2,3,0,0,0\r\n0.5,0,0,0,4,5,6\r\n",
        ),
        (
            "[computed_torque]\nbandwidth = 5\n",
            "times = [0.2, 0.8]\nset_point = [{}, { joint_4 = 1 }]",
            "0.2,0,0,0,0,0,0,0\n0.8,0,0,0,1,0,0,0",
        ),
    ];
    for (head, within, file) in cases {
        let found = samples(&format!("{head}csv = 'data/table.csv'"), file);
        assert_eq!(found, samples(&format!("{head}{within}"), ""), "{file}");
        assert!(found.last().unwrap().q != found[0].q, "{file}: something moves");
    }
}

#[test]
fn what_is_wrong_with_a_file_is_told_in_place() {
    let course = "[prescribed]\njoint = 'joint_3'\ncsv = 'data/table.csv'";
    let cases = [
        (
            course,
            "time,q\n0,0\n0.1,fast\n",
            "scenes/data/table.csv:3:5: prescribed.csv: found 'fast'; expected a finite number",
        ),
        (course, "0,0\n0.1,nan", "scenes/data/table.csv:2:5: prescribed.csv: found 'nan'; expected a finite number"),
        (
            course,
            "0,0\n0.2,1\n0.2,2",
            "scenes/data/table.csv:3:1: prescribed.csv: found 0.2 s after 0.2 s; expected times that increase",
        ),
        (
            course,
            "0,0\n1,2,3",
            "scenes/data/table.csv:2:1: prescribed.csv: found 3 numbers; expected 2: a time (s) and a value",
        ),
        (
            course,
            "time,q\n",
            "scenes/data/table.csv:1:1: prescribed.csv: there are no numbers; expected lines of a time",
        ),
        (
            "[prescribed]\njoint = 'joint_3'\ncsv = 'q.csv'",
            "",
            "scenes/scene.toml:5:7: prescribed.csv: q.csv cannot be read: no such file; expected the path",
        ),
        (
            "[prescribed]\njoint = 'joint_3'\ncsv = 'data/table.csv'\nhold = 1",
            "0,0",
            "scenes/scene.toml:3:1: prescribed: found 2 courses; expected one of",
        ),
        (
            "[joint_torque]\ncsv = 'data/table.csv'\nstart = 0.1",
            "0,0",
            "scenes/scene.toml:5:9: joint_torque.start: csv is given, too; expected csv or start",
        ),
        (
            "[joint_torque]\ncsv = 'data/table.csv'",
            "0,0",
            "scenes/data/table.csv:1:1: joint_torque.csv: found 2 numbers; expected 8",
        ),
    ];
    for (text, table, expected) in cases {
        let error = parsed(text, table).expect_err(text).to_string();
        assert!(error.starts_with(expected), "expected {expected}\nfound {error}");
    }
    // All of them, those of the scene first.
    let error = parsed(&format!("{course}\n[spring]\nstiffness = -1"), "0,0\n1\n0.5,x\n").unwrap_err();
    let places: Vec<_> = error.problems.iter().map(|p| (p.place.file.ends_with("toml"), p.place.line)).collect();
    assert_eq!(places, [(true, 7), (false, 2), (false, 3)], "{error}");
    let alone = Scene::parse("scene.toml", &format!("{HEAD}{course}"), &model()).unwrap_err().to_string();
    assert!(alone.contains("data/table.csv cannot be read: the scene was read without its files"), "{alone}");
}
