//! `frs accuracy`, as a person or a program meets it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use serde_json::{Value, json};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn frs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_frs")).current_dir(ROOT).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The beginning of a scene of the project, in a folder of its own.
fn beginning(name: &str, duration: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy").join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let whole = std::fs::read_to_string(Path::new(ROOT).join("scenes").join(name).with_extension("toml")).unwrap();
    let lines = whole.lines().map(|line| match line.split_once(" = ") {
        Some(("duration", _)) => format!("duration = {duration}"),
        Some(("robot", path)) => {
            let urdf = Path::new(ROOT).join("scenes").join(path.trim_matches('"'));
            std::fs::copy(urdf, folder.join("robot.urdf")).unwrap();
            "robot = 'robot.urdf'".to_owned()
        }
        _ => line.to_owned(),
    });
    let path = folder.join("scene.toml");
    std::fs::write(&path, lines.collect::<Vec<_>>().join("\n")).unwrap();
    path
}

/// The last line of the motion that a scene has: pose and shape.
fn end(scene: &Path) -> Vec<f64> {
    let out = scene.with_file_name("out");
    let output = frs(&["simulate", scene.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let table = std::fs::read_to_string(out.join("trajectory.csv")).unwrap();
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let last = table.lines().last().unwrap().split(',').map(|number| number.parse::<f64>().unwrap());
    names
        .iter()
        .zip(last)
        .filter(|(name, _)| name.starts_with("pose.") || name.starts_with("q."))
        .map(|(_, x)| x)
        .collect()
}

/// What is recommended for an error has it when it is simulated, and nothing that was tried and is cheaper has.
#[test]
fn what_is_recommended_is_accurate_enough_and_nothing_cheaper_is() {
    const WANT: f64 = 1e-6;
    let mut cheaper = 0;
    for (name, duration) in [
        ("paper", "0.6"),
        ("tumbling", "0.3"),
        ("falling_cat", "0.2"),
        ("underwater", "0.2"),
        ("computed_torque", "0.3"),
    ] {
        let scene = beginning(name, duration);
        let (path, folder) = (scene.to_str().unwrap(), scene.with_file_name("study"));
        let before = std::fs::read_to_string(&scene).unwrap();
        let exact = before
            .lines()
            .filter(|line| !line.starts_with("accuracy"))
            .fold("accuracy = 1e-13\n".to_owned(), |text, line| text + line + "\n");
        std::fs::write(&scene, exact).unwrap();
        let expected = end(&scene);
        std::fs::write(&scene, &before).unwrap();

        let output = frs(&[
            "accuracy",
            path,
            "--counts",
            "--want",
            "1e-6",
            "--write",
            "--seconds",
            "2",
            "--json",
            "--out",
            folder.to_str().unwrap(),
        ]);
        assert!(output.status.success(), "{name}: {}", text(&output.stderr));
        let told: Value = serde_json::from_slice(&output.stdout).unwrap();
        let choice = &told["wanted"]["choice"];
        assert_eq!(choice["scalar"], "f64", "{name}: {told}");
        let cost = |evaluations: f64, operations: f64| evaluations * operations;
        let price = cost(choice["evaluations"].as_f64().unwrap(), choice["operations"].as_f64().unwrap());

        let after = std::fs::read_to_string(&scene).unwrap();
        assert!(after.contains(&format!("method = {}", choice["method"])), "{name}: {after}");
        let found = end(&scene);
        let error = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        assert!(error <= WANT && found.len() == expected.len(), "{name}: {error:e} with {choice}");

        let points = std::fs::read_to_string(folder.join("accuracy.csv")).unwrap();
        let column = |name: &str| points.lines().next().unwrap().split(',').position(|own| own == name).unwrap();
        let [pose, shape, evaluations, operations, scalar, evaluation] =
            ["error_pose", "error_shape", "evaluations", "operations", "scalar", "evaluation"].map(column);
        for line in points.lines().skip(1) {
            let cells: Vec<&str> = line.split(',').collect();
            let number = |i: usize| cells[i].parse::<f64>().unwrap();
            // What a scene can ask for.
            let own = cells[scalar] == "f64" && cells[evaluation] == "core";
            if own && cost(number(evaluations), number(operations)) < price {
                cheaper += 1;
                assert!(number(pose).max(number(shape)) > WANT, "{name}: {line}");
            }
        }
    }
    assert!(cheaper > 10, "{cheaper} ways that are cheaper");
}

/// Where operations are counted, two runs give the same, to the last letter of every file.
#[test]
fn counted_studies_are_the_same_every_time() {
    let scene = beginning("arm_gait", "0.1");
    let folder = scene.with_file_name("study");
    let arguments =
        ["accuracy", scene.to_str().unwrap(), "--counts", "--seconds", "0.2", "--out", folder.to_str().unwrap()];
    let study = || {
        let output = frs(&arguments);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let picture = std::fs::read_to_string(folder.join("accuracy.svg")).unwrap();
        (text(&output.stdout), picture)
    };
    let first = study();
    assert!(first.0.contains("1e-6") && first.1.contains("class=\"curve\""), "{}", first.0);
    assert_eq!(study(), first);
    let page = std::fs::read_to_string(folder.join("accuracy.html")).unwrap();
    assert!(page.contains("What to choose") && page.ends_with("</html>\n"));

    let table = std::fs::read_to_string(folder.join("accuracy.csv")).unwrap();
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let reader = SerializedFileReader::new(std::fs::File::open(folder.join("accuracy.parquet")).unwrap()).unwrap();
    let mut count = 0;
    for (row, found) in rows.iter().zip(reader.get_row_iter(None).unwrap()) {
        for ((name, cell), (own, field)) in names.iter().zip(row).zip(found.unwrap().get_column_iter()) {
            assert_eq!(name, own);
            let same = match field {
                Field::Double(x) => cell.parse().unwrap_or(f64::NAN).to_bits() == x.to_bits(),
                Field::Long(x) => cell.parse() == Ok(*x),
                Field::Str(text) => cell == text,
                other => panic!("{other:?}"),
            };
            assert!(same, "{name}: {cell}, {field}");
        }
        count += 1;
    }
    assert_eq!(count, rows.len());
}

#[test]
fn settings_are_written_and_everything_else_of_a_scene_stays() {
    let scene = beginning("computed_torque", "0.1");
    let before = std::fs::read_to_string(&scene).unwrap();
    let path = scene.to_str().unwrap();
    let output = frs(&["accuracy", path, "--counts", "--seconds", "0.2", "--want", "1e-4", "--write"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let after = std::fs::read_to_string(&scene).unwrap();
    let own = |line: &&str| {
        !["accuracy", "[solver]", "method", "equations", "route", "step"].iter().any(|key| line.starts_with(key))
    };
    let kept: Vec<&str> = after.lines().filter(own).filter(|line| !line.is_empty()).collect();
    assert_eq!(kept, before.lines().filter(own).filter(|line| !line.is_empty()).collect::<Vec<_>>());
    assert!(after.contains("[solver]"), "{after}");
}

/// Motions of other programs are judged as our own: one that is as exact as the yardstick, one that is a hundredth off, one that ends early.
#[cfg(unix)]
#[test]
fn other_programs_are_judged_and_drawn() {
    use std::os::unix::fs::PermissionsExt;

    let scene = beginning("tumbling", "0.1");
    let (path, folder) = (scene.to_str().unwrap(), scene.with_file_name("study"));
    let whole = std::fs::read_to_string(&scene).unwrap();
    let exact = whole.lines().filter(|line| !line.starts_with("accuracy") && !line.starts_with("samples_per_second"));
    let exact = exact.fold("accuracy = 1e-13\nsamples_per_second = 100\n".to_owned(), |text, line| text + line + "\n");
    std::fs::write(scene.with_file_name("exact.toml"), exact).unwrap();
    let out = scene.with_file_name("exact");
    let run = frs(&["simulate", scene.with_file_name("exact.toml").to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    let table = std::fs::read_to_string(out.join("trajectory.csv")).unwrap();
    let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let states = |off: f64| -> Vec<Value> {
        // The first line is the start.
        let rows =
            table.lines().skip(2).map(|line| line.split(',').map(|x| x.parse::<f64>().unwrap()).collect::<Vec<_>>());
        let take = |row: &[f64], start: &str| -> Vec<f64> {
            names.iter().zip(row).filter(|(name, _)| name.starts_with(start)).map(|(_, x)| *x).collect()
        };
        rows.map(|row| {
            let q: Vec<f64> = take(&row, "q.").iter().map(|x| x + off).collect();
            let rotation: Vec<Vec<f64>> = take(&row, "pose.r_").chunks(3).map(<[f64]>::to_vec).collect();
            json!({ "position": take(&row, "pose.")[..3], "rotation": rotation, "q": q })
        })
        .collect()
    };
    let motion = |method: &str, states: &[Value]| {
        json!({ "program": "Other", "method": method, "step": 0.01, "evaluations": 40, "seconds": 1e-3, "states": states }).to_string()
    };
    let lines = [
        motion("exact", &states(0.0)),
        motion("late", &states(0.01)),
        motion("short", &states(0.0)[..4]),
        json!({ "left_out": "Another is not installed" }).to_string(),
    ];
    std::fs::write(folder.with_file_name("answer"), lines.join("\n") + "\n").unwrap();
    let other = scene.with_file_name("python");
    let heard = scene.with_file_name("heard");
    let answer =
        format!("#!/bin/sh\ncat > '{}'\ncat '{}'\n", heard.display(), scene.with_file_name("answer").display());
    std::fs::write(&other, answer).unwrap();
    std::fs::set_permissions(&other, std::fs::Permissions::from_mode(0o755)).unwrap();

    let peers = format!("--peers={}", other.display());
    let study = frs(&["accuracy", path, "--seconds", "0.5", "--json", &peers, "--out", folder.to_str().unwrap()]);
    assert!(study.status.success(), "{}", text(&study.stderr));
    assert!(text(&study.stderr).contains("Another is not installed"), "{}", text(&study.stderr));
    let told: Value = serde_json::from_slice(&study.stdout).unwrap();
    let error = |i: usize| told["peers"]["motions"][i]["error"].as_f64();
    assert!(error(0).unwrap() < 1e-10 && (error(1).unwrap() - 0.01).abs() < 1e-9, "{}", told["peers"]);
    // null is infinite.
    assert_eq!((error(2), told["peers"]["motions"][2]["method"].as_str()), (None, Some("short")));
    let picture = std::fs::read_to_string(folder.join("accuracy.svg")).unwrap();
    assert!(picture.contains("Other exact") && picture.contains("Other late") && !picture.contains("Other short"));
    assert!(std::fs::read_to_string(folder.join("peers.csv")).unwrap().lines().count() == 4);
    let request: Value = serde_json::from_str(&std::fs::read_to_string(&heard).unwrap()).unwrap();
    assert_eq!(request["times"].as_array().unwrap().len(), 10);
    assert!(request["stiffness"].as_array().unwrap().iter().any(|k| k.as_f64() > Some(0.0)), "the scene has springs");

    let absent = frs(&["accuracy", path, "--seconds", "0.1", "--peers=/no/such/python"]);
    assert_eq!(absent.status.code(), Some(2));
    assert!(text(&absent.stderr).contains("--peers: /no/such/python cannot be started"), "{}", text(&absent.stderr));
    let gibberish = frs(&["accuracy", path, "--seconds", "0.1", "--peers=/bin/echo"]);
    assert_eq!(gibberish.status.code(), Some(2));
    assert!(text(&gibberish.stderr).contains("says what is no answer"), "{}", text(&gibberish.stderr));
    let unknown = frs(&["accuracy", "scenes/underwater.toml", "--seconds", "0.1", &peers]);
    assert!(
        text(&unknown.stderr).contains("they do not know a wrench elsewhere than in the base's origin (line 14)"),
        "{}",
        text(&unknown.stderr)
    );
}

#[test]
fn what_cannot_be_studied_or_had_is_told() {
    let contact = frs(&["accuracy", "scenes/landing.toml"]);
    assert_eq!(contact.status.code(), Some(2));
    assert!(
        text(&contact.stderr).contains("scenes/landing.toml: it has contact or stops"),
        "{}",
        text(&contact.stderr)
    );

    let scene = beginning("falling_cat", "0.02");
    let unreachable = frs(&["accuracy", scene.to_str().unwrap(), "--counts", "--seconds", "0.2", "--want", "1e-30"]);
    assert_eq!(unreachable.status.code(), Some(1));
    assert!(text(&unreachable.stderr).contains("no setting that was tried"), "{}", text(&unreachable.stderr));

    let wrong = frs(&["accuracy", "scenes/paper.toml", "--want", "0"]);
    assert_eq!(
        (wrong.status.code(), text(&wrong.stderr)),
        (Some(2), "error: --want: found 0; expected a number above 0\n".into())
    );
}

/// Over a base of a third of a gram, accelerations by the textbook form of Λ_q lose digits that the complement form keeps, in both
/// precisions.
#[test]
fn single_evaluations_show_what_a_light_base_costs_the_textbook_form() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("accuracy").join("light");
    std::fs::create_dir_all(&folder).unwrap();
    let robot = std::fs::read_to_string(Path::new(ROOT).join("robots/lwr_satellite.urdf")).unwrap();
    let light = robot.replace("value=\"3.5\"", "value=\"3.5e-4\"");
    let light = light.replace("ixx=\"0.12\"", "ixx=\"12e-6\"").replace("iyy=\"0.14\"", "iyy=\"14e-6\"");
    let light = light.replace("izz=\"0.12\"", "izz=\"12e-6\"");
    let path = folder.join("light.urdf");
    std::fs::write(&path, light).unwrap();
    let output = frs(&["accuracy", "--eval", path.to_str().unwrap(), "--states", "10", "--json"]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    let error = |name: &str, scalar: &str| {
        let rows = told["errors_in_resolutions"].as_array().unwrap();
        rows.iter().find(|row| row["name"] == name).unwrap_or_else(|| panic!("{name}"))[scalar].as_f64().unwrap()
    };
    for row in told["errors_in_resolutions"].as_array().unwrap() {
        let [found, proven] = ["f64", "f64_proven"].map(|key| row[key].as_f64());
        // null is infinite: nothing is proven.
        assert!(proven.is_none_or(|proven| found.unwrap() <= proven), "{row}");
    }
    let [found, proven] = ["f64", "f64_proven"].map(|key| error("inertia: Λ_q", key));
    assert!(proven > found && proven < 1e6, "{found}, {proven}");
    for scalar in ["f64", "f32"] {
        let [ours, textbook] =
            ["complement", "textbook"].map(|form| error(&format!("q̈, Λ_q by the {form} form"), scalar));
        assert!(ours < 1000.0 && textbook > 100.0 * ours, "{scalar}: {ours}, {textbook}");
    }
}
