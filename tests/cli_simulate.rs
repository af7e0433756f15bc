//! `frs simulate` and `frs explain`, as a person or a program meets them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use frs::model::Inertial;
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::{Pose, Symmetric3, Twist};
use frs::{Model, Workspace};
use parquet::column::reader::get_typed_column_reader;
use parquet::data_type::DoubleType;
use parquet::file::reader::{FileReader, SerializedFileReader};
use serde_json::Value;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// An empty folder of its own.
fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("simulate").join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).unwrap();
    path
}

fn frs(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_frs")).current_dir(ROOT).args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// A scene in a folder of its own, beside a copy of the robot.
fn scene(name: &str, rest: &str) -> PathBuf {
    let folder = folder(name);
    std::fs::copy(Path::new(ROOT).join("robots/lwr_satellite.urdf"), folder.join("robot.urdf")).unwrap();
    let path = folder.join("scene.toml");
    std::fs::write(&path, format!("robot = 'robot.urdf'\nduration = 0.5\n{rest}")).unwrap();
    path
}

/// Names of columns, and rows.
fn trajectory(folder: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let table = std::fs::read_to_string(folder.join("trajectory.csv")).unwrap();
    let mut lines = table.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned).collect();
    (names, lines.map(|line| line.split(',').map(|number| number.parse().unwrap()).collect()).collect())
}

/// The page of a scene, which ended with this exit code.
fn report(scene: &Path, code: i32) -> String {
    let out = scene.with_file_name("out");
    let output = frs(&["simulate", scene.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(code), "{}", text(&output.stderr));
    std::fs::read_to_string(out.join("report.html")).unwrap()
}

/// What moves in a page.
fn motion(report: &str) -> Value {
    let (_, data) = report.split_once("<script type=\"application/json\" id=\"motion\">").unwrap();
    serde_json::from_str(data.split_once("</script>").unwrap().0).unwrap()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn a_table_and_pictures_are_written_and_told() {
    let out = folder("written").join("made");
    let output = frs(&["simulate", "scenes/paper.toml", "--out", out.to_str().unwrap()]);
    let told = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(told.contains("momentum") && told.contains("driven") && told.contains("trajectory.csv"), "{told}");
    let pictures = ["decoupling", "energy", "locked_velocity", "momentum", "shape", "shape_rates", "torques"];
    for picture in pictures {
        let drawn = std::fs::read_to_string(out.join(picture).with_extension("svg")).unwrap();
        assert!(drawn.starts_with("<svg") && drawn.ends_with("</svg>\n") && !drawn.contains("NaN"), "{picture}");
    }
    assert!(told.contains("report.html") && std::fs::exists(out.join("report.html")).unwrap());
    assert_eq!(std::fs::read_dir(&out).unwrap().count(), pictures.len() + 3, "and nothing beside");

    let (names, rows) = trajectory(&out);
    let column = |name: &str| names.iter().position(|n| n == name).unwrap_or_else(|| panic!("{name} in {names:?}"));
    assert_eq!(rows.len(), 801);
    assert!(rows.iter().all(|row| row.len() == names.len()));
    assert_eq!((rows[0][column("time")], rows[800][column("time")]), (0.0, 4.0));
    assert_eq!(rows[0][column("mu.omega_y")], 0.20943951023931953);
    assert_eq!(rows[0][column("q.joint_4")], 1.0);
    // The base turns about its y axis: −sin of the angle stands in row z, column x.
    assert!(rows[100][column("pose.r_zx")] < -0.09 && rows[100][column("pose.r_xz")] > 0.09);
}

#[test]
fn parquet_has_the_columns_of_the_table_bit_for_bit() {
    let rest = "samples_per_second = 3000\n[start]\nqd = { joint_2 = 0.5 }\nmu = [0, 0.3, 0, 0, 0, 0]\n[spring]\nstiffness = 2\n[observer]\ngain = 3\n";
    let path = scene("parquet", rest);
    report(&path, 0);
    let out = path.with_file_name("out");
    let (names, rows) = trajectory(&out);
    let reader = SerializedFileReader::new(std::fs::File::open(out.join("trajectory.parquet")).unwrap()).unwrap();
    let columns = reader.metadata().file_metadata().schema_descr().columns();
    assert_eq!(columns.iter().map(|column| column.name()).collect::<Vec<_>>(), names);
    assert_eq!((reader.num_row_groups(), rows.len()), (1, 1501));
    let group = reader.get_row_group(0).unwrap();
    for (i, name) in names.iter().enumerate() {
        let mut column = get_typed_column_reader::<DoubleType>(group.get_column_reader(i).unwrap());
        let mut found = Vec::new();
        assert_eq!(column.read_records(rows.len(), None, None, &mut found).unwrap().0, rows.len());
        let same = found.iter().zip(&rows).all(|(found, row)| found.to_bits() == row[i].to_bits());
        assert!(same, "{name}");
    }
}

#[test]
fn a_report_needs_nothing_beside_itself() {
    let page = report(&scene("alone", "[start]\nqd = { joint_2 = 0.5 }"), 0);
    assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>\n"));
    let outside = page.replace("http://www.w3.org/2000/svg", "");
    for word in ["http:", "https:", "//www", "src=", "href=", "@import", "url(", "fetch(", "import("] {
        assert!(!outside.contains(word), "{word}");
    }
    assert_eq!(page.matches("<figure><svg").count(), 6);
    let told = ["the whole motion was computed", "energy and work differ by", "rotation is one to"];
    assert!(told.iter().all(|part| page.contains(part)), "the summary");
    let motion = motion(&page);
    let lines = page.matches("class=\"name\"").count();
    assert!(
        motion["values"].as_array().unwrap().iter().all(|row| numbers(row).len() == lines),
        "a value for each name"
    );
}

#[test]
fn names_cannot_break_a_report() {
    const NAME: &str = "</script><img>&{style}";
    let path = scene("names", "");
    let robot = path.with_file_name("robot.urdf");
    let urdf = std::fs::read_to_string(&robot).unwrap();
    let written = "&lt;/script>&lt;img>&amp;{style}";
    std::fs::write(&robot, urdf.replace("joint_1", written).replace("lwr_satellite", written)).unwrap();
    let page = report(&path, 0);
    assert_eq!((page.matches("</script").count(), page.matches("<img").count()), (2, 0));
    assert!(page.contains("<h1>&lt;/script&gt;&lt;img&gt;&amp;{style} "));
    assert_eq!(motion(&page)["joints"][0]["name"].as_str(), Some(NAME));
}

#[test]
fn a_report_has_few_frames_however_many_samples() {
    for (name, rest, most) in
        [("often", "samples_per_second = 2000", 31), ("once", "[start]\nqd = { joint_2 = 1e200 }", 1)]
    {
        let path = scene(name, rest);
        let motion = motion(&report(&path, i32::from(most == 1)));
        let times = numbers(&motion["times"]);
        let (_, rows) = trajectory(&path.with_file_name("out"));
        assert!(times.len() <= most && times.len() * 3 >= most * 2, "{name}: {}", times.len());
        assert_eq!((times[0], times[times.len() - 1]), (0.0, rows[rows.len() - 1][0]), "{name}");
        assert_eq!(motion["points"].as_array().unwrap().len(), times.len());
    }
}

/// Units by which a point of a page differs from where it is: half a unit by rounding, and the last digits of doubles.
const ROUNDING: f64 = 0.51;

#[test]
fn joints_of_a_report_are_where_the_core_puts_them() {
    let path = scene("places", "[start]\nmu = [0, 0.5, 0, 1, 0, 0]\nq = { joint_2 = 0.7 }\nqd = { joint_4 = 2 }");
    let motion = motion(&report(&path, 0));
    let (names, rows) = trajectory(&path.with_file_name("out"));
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let mut work = Workspace::new(&model);
    let unit = motion["unit"].as_f64().unwrap();
    let (times, joints) = (numbers(&motion["times"]), motion["joints"].as_array().unwrap());
    assert_eq!((joints.len(), names[13].as_str()), (7, "q.joint_1"));
    for (time, points) in times.iter().zip(motion["points"].as_array().unwrap()) {
        let row = rows.iter().find(|row| row[0] == *time).unwrap();
        let pose = Pose::new(Matrix3::from_row_slice(&row[4..13]), Vector3::from_row_slice(&row[1..4]));
        let shape = work.shape(&row[13..20]);
        let points = numbers(points);
        let seen = |point: usize| Vector3::from_row_slice(&points[3 * point..3 * point + 3]);
        for joint in joints {
            let link = model.link(&joint["name"].as_str().unwrap().replace("joint", "link")).unwrap();
            let expected = (pose * shape.link_pose(link)).translation / unit;
            let difference = seen(joint["point"].as_u64().unwrap() as usize) - expected;
            assert!(difference.amax() < ROUNDING, "{joint} at {time} s: {difference}");
        }
        let com = pose.transform(shape.com()) / unit;
        assert!((seen(points.len() / 3 - 1) - com).amax() < ROUNDING, "centre of mass at {time} s");
    }
}

/// The middle of a box whose corners begin with a point, m.
fn middle(motion: &Value, frame: usize, first: usize) -> Vector3<f64> {
    let points = numbers(&motion["points"][frame]);
    let corner = |i: usize| Vector3::from_row_slice(&points[3 * i..3 * i + 3]);
    (first..first + 8).map(corner).sum::<Vector3<f64>>() * (0.125 * motion["unit"].as_f64().unwrap())
}

/// A target comes with its velocity, is held, and leaves with what it then has; a goal stands still.
#[test]
fn a_target_flies_as_long_as_nobody_holds_it() {
    const VELOCITY: [f64; 3] = [-0.02, 0.3, 0.1];
    /// Units are 0.1 mm; eight corners are rounded, and so is the middle.
    const ROUNDED: f64 = 2e-4;
    let payload = "[payload]\nlink = 'link_7'\nmass = 8\ncom = [0, 0, 0.25]\ninertia = [0.12, 0.12, 0.1, 0, 0, 0]\n";
    let times = "grasp = 0.15\nrelease = 0.3\ntwist = [0.5, 1, -3, -0.02, 0.3, 0.1]\n";
    let hand = "[end_effector]\nlink = 'link_7'\nposition = [0.1, 0.2, 0.9]\nstiffness = 10\ndamping = 1\n";
    let path = scene("target", &format!("[start]\nq = {{ joint_2 = 0.5 }}\n{payload}{times}{hand}"));
    let page = report(&path, 0);
    assert!(page.contains("bodies that it takes or lets go") && page.contains("where hands are to be"));
    let motion = motion(&page);
    let (_, rows) = trajectory(&path.with_file_name("out"));
    let times = numbers(&motion["times"]);
    let (taken, mark) = (&motion["boxes"][0], motion["marks"][0]["point"].as_u64().unwrap() as usize);
    let first = taken["first"].as_u64().unwrap() as usize;
    assert_eq!((first, mark), (motion["robot"].as_u64().unwrap() as usize, first + 8));
    assert_eq!((taken["grasp"].as_f64(), taken["release"].as_f64()), (Some(0.15), Some(0.3)));
    let model = Model::from_urdf(frs::urdf::LWR_SATELLITE).unwrap();
    let mut work = Workspace::new(&model);
    let mut held = |time: f64| {
        let row = rows.iter().find(|row| row[0] == time).unwrap();
        let pose = Pose::new(Matrix3::from_row_slice(&row[4..13]), Vector3::from_row_slice(&row[1..4]));
        let link = work.shape(&row[13..20]).link_pose(model.link("link_7").unwrap());
        (pose * link).transform(Vector3::new(0.0, 0.0, 0.25))
    };
    let (taken_at, left_at) = (held(0.15), held(0.3));
    let last = middle(&motion, times.len() - 1, first);
    for (frame, &time) in times.iter().enumerate() {
        let expected = match time {
            time if time < 0.15 => taken_at + Vector3::from(VELOCITY) * (time - 0.15),
            time if time < 0.3 => held(time),
            _ => left_at + (last - left_at) * ((time - 0.3) / 0.2),
        };
        let error = (middle(&motion, frame, first) - expected).norm();
        assert!(error < ROUNDED, "{time}: {error}");
        let goal = numbers(&motion["points"][frame])[3 * mark..3 * mark + 3].to_vec();
        let goal = Vector3::from_row_slice(&goal) * motion["unit"].as_f64().unwrap();
        assert!((goal - Vector3::new(0.1, 0.2, 0.9)).norm() < ROUNDED);
    }
    // It leaves as fast as the hand was.
    let row = rows.iter().find(|row| row[0] == 0.3).unwrap();
    let own = model.links()[model.link("link_7").unwrap()].inertial;
    let inertia = Symmetric3::diagonal(Vector3::new(0.12, 0.12, 0.1));
    let both = own.joined(Inertial { mass: 8.0, com: Vector3::new(0.0, 0.0, 0.25), inertia });
    let laden = model.with_inertial("link_7", both).unwrap();
    let mut work = Workspace::new(&laden);
    let mut shape = work.shape(&row[13..20]);
    let hand = shape.link_pose(model.link("link_7").unwrap()).rotation;
    let mu = Twist::from_array(std::array::from_fn(|i| row[27 + i]));
    let twist = shape.moving(&row[20..27]).link_twist(model.link("link_7").unwrap(), mu);
    let velocity = Matrix3::from_row_slice(&row[4..13]) * hand * twist.at(Vector3::new(0.0, 0.0, 0.25)).linear;
    assert!((last - left_at - velocity * 0.2).norm() < ROUNDED, "{velocity}");
    assert!((last - left_at).norm() > 0.01 && (taken_at - middle(&motion, 0, first)).norm() > 0.04);
}

/// The picture of the documentation is the one that is drawn, but for the last digit of a pixel.
#[test]
fn the_papers_figure_is_the_one_that_is_drawn() {
    const PIXELS: f64 = 0.15;
    let out = folder("figure");
    let output = frs(&["simulate", "scenes/paper_tau_bar.toml", "--out", out.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let [drawn, kept] = [out.join("decoupling.svg"), Path::new(ROOT).join("docs/scenes/decoupling.svg")].map(|path| {
        let text = std::fs::read_to_string(path).unwrap();
        let pieces = text.split([' ', '"', 'M', 'L', '<', '>']).filter(|piece| !piece.is_empty());
        pieces.map(str::to_owned).collect::<Vec<_>>()
    });
    assert!(drawn.len() == kept.len() && drawn.len() > 5000, "{} and {} pieces", drawn.len(), kept.len());
    for (one, other) in drawn.iter().zip(&kept) {
        let near = match (one.parse::<f64>(), other.parse::<f64>()) {
            (Ok(one), Ok(other)) => (one - other).abs() < PIXELS,
            _ => one == other,
        };
        assert!(near, "{one} {other}");
    }
}

#[test]
fn json_tells_the_invariants() {
    let path = scene("json", "[start]\nmomentum = [0.5, 0, 0.2, 0, 0, 0]");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap(), "--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((told["momentum"].as_str(), told["end"].as_str()), (Some("conserved"), Some("whole")));
    assert_eq!((told["time"].as_f64(), told["samples"].as_u64()), (Some(0.5), Some(51)));
    assert!(told["momentum_change"].as_f64().unwrap() < 1e-13 && told["energy_difference"].as_f64().unwrap() < 1e-7);
}

#[test]
fn the_work_of_each_force_is_told_by_its_name() {
    /// Five digits are told to people.
    const DIGITS: f64 = 1e-4;
    let path = scene("work", "[start]\nqd = { joint_2 = 0.5 }\n[spring]\nstiffness = 2\n[friction]\nviscous = 0.1\n");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap(), "--json"]);
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    let (names, rows) = trajectory(&out);
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    let (first, last) = (&rows[0], rows.last().unwrap());
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    let mut sum = 0.0;
    for name in ["spring", "viscous_friction"] {
        let work = last[column(&format!("work.{name}"))];
        assert!(work < -1e-3, "{name}: {work}");
        assert_eq!((told["work"][name].as_f64(), first[column(&format!("work.{name}"))]), (Some(work), 0.0));
        let row = page.split_once(&format!("<th scope=\"row\">work of {name}<td>")).unwrap().1;
        let shown: f64 = row.split_once(" J").unwrap().0.parse().unwrap();
        assert!((shown / work - 1.0).abs() < DIGITS && page.contains(&format!(">{name}</text>")), "{name}: {shown}");
        sum += work;
    }
    let energy = column("kinetic_energy");
    assert!((last[energy] - first[energy] - sum).abs() < 1e-7);
}

#[test]
fn an_observer_tells_how_it_converges() {
    let path = scene("observer", "[start]\nmomentum = [0.5, 0, 0.2, 1, 0, 0]\n[observer]\ngain = 10\n");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap(), "--json"]);
    let told: Value = serde_json::from_slice(&output.stdout).unwrap();
    let (names, rows) = trajectory(&out);
    let energy = names.iter().position(|name| name == "observer_energy").unwrap();
    assert_eq!((energy + 1, names[energy - 1].as_str()), (names.len(), "mu_error.v_z"));
    let factor = rows[0][energy].sqrt() / rows.last().unwrap()[energy].sqrt();
    assert_eq!(told["observer"]["factor"].as_f64(), Some(factor));
    // e⁵ in half a second, and 1/e after a tenth, but for the turning inertia and the time between samples.
    assert!(
        (100.0..220.0).contains(&factor) && (0.09..0.13).contains(&told["observer"]["time_constant"].as_f64().unwrap())
    );
    let page = std::fs::read_to_string(out.join("report.html")).unwrap();
    assert!(
        page.contains("error of the observer") && page.contains(">Error of the observed locked velocity, base frame<")
    );
    let explained = text(&frs(&["explain", path.to_str().unwrap()]).stdout);
    assert!(explained.contains("Observer of μ, k = 10 1/s"), "{explained}");
}

#[test]
fn a_course_is_read_from_the_folder_of_the_scene() {
    let path = scene("course", "[prescribed]\njoint = 'joint_2'\ncsv = 'course.csv'\n");
    let (course, out) = (path.with_file_name("course.csv"), path.with_file_name("out"));
    std::fs::write(&course, "time,angle\n0,0\n0.5,0.25\n").unwrap();
    let arguments = ["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()];
    let output = frs(&arguments);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let (names, rows) = trajectory(&out);
    let q = names.iter().position(|name| name == "q.joint_2").unwrap();
    assert!((rows.last().unwrap()[q] - 0.25).abs() < 1e-15);
    std::fs::write(&course, "0,0\n0.5,?\n").unwrap();
    let output = frs(&arguments);
    let expected = format!("{}:2:5: prescribed.csv: found '?'; expected a finite number", course.display());
    assert_eq!((output.status.code(), text(&output.stderr).contains(&expected)), (Some(2), true));
}

#[test]
fn a_motion_that_cannot_go_on_is_kept_and_is_exit_code_1() {
    let path = scene("wild", "[start]\nqd = { joint_2 = 1e200 }");
    let out = path.with_file_name("out");
    let output = frs(&["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()]);
    let told = text(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{told}");
    assert!(told.contains("t = 0 s: the motion is not finite") && told.contains("is written"), "{told}");
    assert_eq!(std::fs::read_to_string(out.join("trajectory.csv")).unwrap().lines().count(), 2);
}

#[test]
fn bad_scenes_are_exit_code_2_with_their_place() {
    let unknown = scene("unknown", "[start]\nq = { joint_0 = 1 }");
    let missing = scene("missing", "");
    std::fs::remove_file(missing.with_file_name("robot.urdf")).unwrap();
    for (path, expected) in [
        (unknown.as_path(), "scene.toml:4:7: start.q.joint_0: unknown key; did you mean 'joint_"),
        (missing.as_path(), "scene.toml:1:9: robot: "),
        (Path::new("scenes/none.toml"), "scenes/none.toml: cannot be read"),
    ] {
        let out = folder("refused");
        for arguments in [
            &["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()][..],
            &["explain", path.to_str().unwrap()],
        ] {
            let output = frs(arguments);
            let told = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{told}");
            assert!(told.contains(expected), "{told}");
        }
        assert_eq!(std::fs::read_dir(out).unwrap().count(), 0);
    }
}

#[test]
fn explain_tells_what_is_computed_and_what_is_not() {
    for (name, expected) in [
        (
            "paper",
            &[
                "[wrench], line",
                "Momentum: driven",
                "the steps meet 0.51, 0.55 s exactly",
                "20 numbers",
                "the work of wrench, regulator",
                "Λ_b μ̇ = F₁",
                "gravity, drag, contact, joint_torque, friction, spring",
            ][..],
        ),
        (
            "tumbling",
            &["[spring], line 14", "Momentum: conserved", "14 numbers", "Λ_c μ_c = R₁ᵀ h", "the equation of μ"],
        ),
        ("reach", &["[regulator], line", "Momentum: zero", "Λ_q q̈ = τ − Γ'_q(q̇) q̇\n", "all terms with μ"]),
    ] {
        let output = frs(&["explain", &format!("scenes/{name}.toml")]);
        let told = text(&output.stdout);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        for part in expected {
            assert!(told.contains(part), "{name}: '{part}' in\n{told}");
        }
    }
}

#[test]
fn explain_explains_every_scene_of_the_project() {
    let scenes = std::fs::read_dir(Path::new(ROOT).join("scenes")).unwrap().map(|entry| entry.unwrap().path());
    let scenes: Vec<PathBuf> = scenes.filter(|path| path.extension().is_some_and(|kind| kind == "toml")).collect();
    assert!(scenes.len() > 10, "{scenes:?}");
    for path in scenes {
        let output = frs(&["explain", path.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(0), "{}: {}", path.display(), text(&output.stderr));
        assert!(text(&output.stdout).contains("One evaluation of them"), "{}", path.display());
    }
}

/// A long motion of its own, and the arguments that compute it into `out` beside it.
fn long(name: &str) -> (PathBuf, Vec<String>) {
    let rest = "samples_per_second = 1\naccuracy = 1e-10\n[start]\nqd = { joint_2 = 0.5 }\nmu = [0.1, 0.2, 0, 0, 0, 0]\n[spring]\nstiffness = 2\n[observer]\ngain = 1\n";
    let path = scene(name, rest);
    let text = std::fs::read_to_string(&path).unwrap().replace("duration = 0.5", "duration = 600");
    std::fs::write(&path, text).unwrap();
    let out = path.with_file_name("out");
    let arguments = ["simulate", path.to_str().unwrap(), "--out", out.to_str().unwrap()].map(str::to_owned).to_vec();
    (out, arguments)
}

/// Ctrl-C in the middle, then `--resume`: the table is the one of a run that was left alone, to the last byte.
#[cfg(unix)]
#[test]
fn a_run_that_was_stopped_goes_on_with_the_same_bits() {
    let (out, arguments) = long("stopped");
    let mut child = Command::new(env!("CARGO_BIN_EXE_frs"))
        .args(&arguments)
        .args(["--save-every", "0.02"])
        .stderr(std::process::Stdio::null())
        .stdout(std::process::Stdio::null())
        .spawn()
        .unwrap();
    while !out.join("checkpoint.json").exists() {
        assert_eq!(child.try_wait().unwrap(), None, "it is still on its way");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let interrupted = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    assert!(interrupted.success());
    assert_eq!(child.wait().unwrap().code(), Some(1));
    let (_, part) = trajectory(&out);
    assert!(part.len() > 1 && part.len() < 601, "{} samples", part.len());

    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let resumed = frs(&[&arguments[..], &["--resume"]].concat());
    assert_eq!(resumed.status.code(), Some(0), "{}", text(&resumed.stderr));
    assert!(!out.join("checkpoint.json").exists());
    let found = std::fs::read(out.join("trajectory.csv")).unwrap();
    assert_eq!(frs(&arguments).status.code(), Some(0));
    assert!(found == std::fs::read(out.join("trajectory.csv")).unwrap(), "not a byte differs");
}

#[test]
fn what_cannot_be_resumed_is_told() {
    let (out, arguments) = long("not_resumed");
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).chain(["--resume"]).collect();
    std::fs::create_dir_all(&out).unwrap();
    for (checkpoint, expected) in [
        (None, "checkpoint.json: there is nothing to resume; expected what a run leaves that was stopped"),
        (Some("{"), "checkpoint.json: EOF while parsing"),
        (Some("{\"scene\": \"robot = 'x'\"}"), "checkpoint.json: the scene or its robot has changed since"),
    ] {
        if let Some(text) = checkpoint {
            std::fs::write(out.join("checkpoint.json"), text).unwrap();
        }
        let output = frs(&arguments);
        assert_eq!(output.status.code(), Some(2));
        let told = text(&output.stderr);
        assert!(told.contains(expected) && told.contains("run without --resume"), "{told}");
    }
}
