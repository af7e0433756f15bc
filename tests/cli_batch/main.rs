//! `frs eval --batch`, as a person or a program meets it.

mod files;

use std::fs::File;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use frs::{Evaluator, FloatingBase, Model, Quantity};
use npyz::{Order, WriteOptions, WriterBuilder};
use serde_json::Value;

use files::{folder, read, read_columns, states, write, write_columns};

const CHASER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/chaser.urdf");
const HUMANOID: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/humanoid.urdf");
const PLANAR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/planar_three_link.urdf");

fn model(path: &str) -> Model {
    Model::from_urdf(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// `frs eval ROBOT --batch FROM --quantity QUANTITY --out TO` within `folder`.
fn eval(folder: &Path, robot: &str, quantity: &str, from: &str, to: &str, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_frs"));
    command.current_dir(folder).args(["eval", robot, "--quantity", quantity, "--batch", from, "--out", to]);
    command.args(more).output().unwrap()
}

/// The core, state by state.
fn expected(model: &Model, quantity: Quantity, numbers: &[f64]) -> Vec<u64> {
    let n = model.dof();
    let mut robot = Evaluator::new(model);
    let lengths: Vec<usize> = quantity.inputs().map(|input| input.len(n)).collect();
    let mut all = Vec::new();
    for state in numbers.chunks(lengths.iter().sum()) {
        let mut rest = state;
        let mut inputs = Vec::new();
        for &len in &lengths {
            let (input, left) = rest.split_at(len);
            inputs.push(input);
            rest = left;
        }
        let mut outputs: Vec<Vec<f64>> = quantity.outputs().map(|output| vec![f64::NAN; output.len(n)]).collect();
        robot.answer(quantity, &inputs, &mut outputs.iter_mut().map(Vec::as_mut_slice).collect::<Vec<_>>());
        all.extend(outputs.iter().flatten().map(|number| number.to_bits()));
    }
    all
}

#[test]
fn a_file_of_states_gives_the_cores_bits_in_either_order_and_in_any_portions() {
    let (folder, model) = (folder("npy"), model(CHASER));
    // q, mu.
    let numbers = states(1001, 3 + 6);
    write(&folder, "rows.npy", Order::C, 9, &numbers);
    write(&folder, "columns.npy", Order::Fortran, 9, &numbers);
    let expected = expected(&model, Quantity::Matrices, &numbers);
    for (from, more) in
        [("rows.npy", ["--threads", "1"]), ("columns.npy", ["--threads", "3"]), ("rows.npy", ["--memory", "1"])]
    {
        let output = eval(&folder, CHASER, "matrices", from, "out.npy", &more);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let (shape, found) = read(&folder, "out.npy");
        assert_eq!(shape, [1001, 36 + 18 + 9 + 81 + 9]);
        assert!(found == expected, "{from} {more:?}");
    }
}

#[test]
fn columns_are_found_by_name_in_any_order_and_any_groups() {
    let (folder, model) = (folder("parquet"), model(PLANAR));
    let numbers = states(1000, 2 + 6);
    write(&folder, "states.npy", Order::C, 8, &numbers);
    let coordinates: Vec<String> = model.coordinates().iter().map(|c| format!("q.{}", c.name)).collect();
    let names = [
        "mu.v_z",
        "time",
        &coordinates[1],
        "mu.omega_x",
        "mu.omega_y",
        &format!("?{}", coordinates[0]),
        "mu.omega_z",
        "mu.v_x",
        "mu.v_y",
    ];
    let order = [7, usize::MAX, 1, 2, 3, 0, 4, 5, 6];
    let rows = numbers.chunks(8).map(|row| order.iter().map(|&i| row.get(i).copied().unwrap_or(0.5)).collect());
    let mut rows: Vec<Vec<f64>> = rows.collect();
    write_columns(&folder.join("states.parquet"), &names, &rows, 77);
    for (from, to) in [("states.npy", "direct.npy"), ("states.parquet", "out.npy"), ("states.parquet", "out.parquet")] {
        let output = eval(&folder, PLANAR, "momentum", from, to, &[]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    }
    let direct = read(&folder, "direct.npy").1;
    assert!(direct == expected(&model, Quantity::Momentum, &numbers) && direct == read(&folder, "out.npy").1);
    let (columns, found) = read_columns(&folder.join("out.parquet"));
    assert!(found == direct);
    assert_eq!(
        columns[..2].join(" ") + " " + &columns[11],
        "body_momentum.moment_x body_momentum.moment_y centroidal_momentum.force_z"
    );

    // A row without a number, and a file without a column.
    rows[500][5] = f64::NAN;
    write_columns(&folder.join("gap.parquet"), &names, &rows, 1000);
    write_columns(&folder.join("without.parquet"), &names[..8], &rows, 1000);
    let missing = "without.parquet: these columns are missing: mu.v_y; the file has: mu.v_z, time, ";
    for (from, part) in [
        ("gap.parquet", &*format!("column {} has rows without a number", coordinates[0])),
        ("without.parquet", missing),
    ] {
        let output = eval(&folder, PLANAR, "momentum", from, "no.npy", &[]);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains(part), "{said}");
        assert!(!folder.join("no.npy").exists() && !folder.join("no.npy.new").exists());
    }
}

#[test]
fn the_summary_for_programs_names_every_column() {
    let folder = folder("json");
    write(&folder, "states.npy", Order::C, 2, &states(9, 2));
    let output = eval(&folder, PLANAR, "inertia", "states.npy", "out.npy", &["--json", "--threads", "2"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let summary: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&summary["states"], &summary["not_finite"], &summary["threads"]), (&9.into(), &0.into(), &2.into()));
    assert_eq!(summary["outputs"].as_array().unwrap().len(), 36 + 12 + 4);
    assert_eq!(summary["outputs"][36], "connection.omega_x.".to_owned() + &model(PLANAR).coordinates()[0].name);
}

#[test]
fn what_is_wrong_with_a_file_is_told_in_place_and_nothing_is_written() {
    let folder = folder("wrong");
    write(&folder, "narrow.npy", Order::C, 8, &states(5, 8));
    let mut numbers = states(70_000, 9);
    (numbers[9 * 69_999 + 3], numbers[9 * 69_999 + 5]) = (f64::INFINITY, f64::NAN);
    write(&folder, "infinite.npy", Order::C, 9, &numbers);
    let whole = WriteOptions::new().default_dtype().shape(&[3, 9]);
    let mut whole = whole.writer(File::create(folder.join("integers.npy")).unwrap()).begin_nd().unwrap();
    whole.extend(0..27_i32).unwrap();
    whole.finish().unwrap();
    let bytes = std::fs::read(folder.join("narrow.npy")).unwrap();
    std::fs::write(folder.join("short.npy"), &bytes[..bytes.len() - 1]).unwrap();
    std::fs::write(folder.join("text.npy"), "1 2 3").unwrap();
    std::fs::write(folder.join("text.parquet"), "1 2 3").unwrap();
    for (from, to, part) in [
        ("narrow.npy", "out.npy", "narrow.npy: rows have 8 numbers; expected 9: q (3), mu (6)"),
        ("infinite.npy", "out.npy", "infinite.npy: row 69999 (from 0): mu.omega_x is inf; expected a finite number"),
        ("integers.npy", "out.npy", "integers.npy: numbers are of type <i4; expected <f8 or <f4"),
        ("short.npy", "out.npy", "short.npy: "),
        ("text.npy", "out.npy", "text.npy: this is no .npy file"),
        ("text.parquet", "out.npy", "text.parquet: this is no Parquet file"),
        ("nowhere.npy", "out.npy", "nowhere.npy: cannot be opened"),
        (
            "narrow.csv",
            "out.npy",
            "narrow.csv: this is no file of states; expected a name that ends in .npy or .parquet",
        ),
        ("infinite.npy", "nowhere/out.npy", "nowhere/out.npy: cannot be written"),
    ] {
        let before = std::fs::read_dir(&folder).unwrap().count();
        let output = eval(&folder, CHASER, "b2", from, to, &["--memory", "1"]);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains(part), "{from}: {said}");
        assert_eq!(std::fs::read_dir(&folder).unwrap().count(), before, "{from}: something was left");
    }
    let output = eval(&folder, CHASER, "kinematics", "narrow.npy", "out.npy", &["--link", "nothing"]);
    assert!(
        output.status.code() == Some(2)
            && text(&output.stderr).contains("--link 'nothing': the robot has no such link")
    );
}

#[test]
fn answers_that_are_not_finite_are_counted_and_written() {
    let folder = folder("overflow");
    // q, qd, mu: the energy of the second and the fourth state is beyond all doubles.
    let mut numbers = vec![0.5; 4 * 10];
    (numbers[10 + 5], numbers[30 + 2]) = (1e200, -1e300);
    write(&folder, "states.npy", Order::C, 10, &numbers);
    let output = eval(&folder, PLANAR, "kinetic_energy", "states.npy", "out.npy", &[]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("2 states, row 1 (from 0) first, have answers that are not finite"), "{said}");
    let (_, found) = read(&folder, "out.npy");
    assert_eq!(
        found.iter().map(|bits| f64::from_bits(*bits).is_finite()).collect::<Vec<_>>(),
        [true, false, true, false]
    );
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_no_half_of_a_file() {
    let folder = folder("interrupted");
    write(&folder, "states.npy", Order::C, 30, &states(50_000, 30));
    let child = Command::new(env!("CARGO_BIN_EXE_frs"))
        .current_dir(&folder)
        .args(["eval", HUMANOID, "--quantity", "inertia", "--batch", "states.npy", "--out", "out.npy", "--memory", "1"])
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    while !folder.join("out.npy.new").metadata().is_ok_and(|about| about.len() > 1 << 20) {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    let said = text(&output.stderr);
    assert!(output.status.code() == Some(1) && said.contains(" of 50000 states; out.npy was not written"), "{said}");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "only the states are there");
}

/// A million states of 80 MB pass through a program that never holds half as much.
#[cfg(target_os = "linux")]
#[test]
fn a_million_states_pass_through_little_memory() {
    let folder = folder("million");
    write(&folder, "states.npy", Order::C, 10, &states(1_000_000, 10));
    let mut child = Command::new(env!("CARGO_BIN_EXE_frs"))
        .current_dir(&folder)
        .args([
            "eval",
            PLANAR,
            "--quantity",
            "kinetic_energy",
            "--batch",
            "states.npy",
            "--out",
            "out.npy",
            "--memory",
            "4",
        ])
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    while child.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let high = text.lines().find_map(|line| line.strip_prefix("VmHWM:")?.trim().strip_suffix(" kB")?.parse().ok());
        peak = peak.max(high.unwrap_or(0));
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert!(child.wait().unwrap().success());
    assert_eq!(read(&folder, "out.npy").0, [1_000_000, 1]);
    std::fs::remove_dir_all(&folder).unwrap();
    // The program itself and 4 MiB of states, in kB.
    assert!((1_000..40_000).contains(&peak), "{peak} kB");
}
