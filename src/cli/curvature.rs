//! `frs curvature`: which loops of two joints turn a floating base, as maps, and what a gait does.

mod gait;
mod map;
mod plane;
mod report;
mod scale;

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use frs::nalgebra::{DMatrix, Vector3};
use frs::{Evaluator, Model};
use frs_gait::{CurvatureField, Gait, Grid, MinimumPerturbation, Target, best_gait};
use indicatif::ProgressBar;

use self::map::Map;
use self::plane::Axes;
use self::report::{Outcome, Report};
use self::scale::largest;
use super::{Failure, RobotArgs};

/// Map the curvature of a robot over two joints, and tell what a closed gait does to its base at zero momentum.
///
/// Writes a map (SVG) of each component of 𝓑(e_a, e_b) in the base frame and in minimum-perturbation coordinates, and all
/// values as fields.csv. A small counter-clockwise loop displaces the base by minus the value times its area.
///
/// A gait is one of
///   ellipse:CA,CB,RA,RB     centre and half-axes; a negative half-axis turns it round
///   polygon:A,B;A,B;…       straight edges, closed to the first corner
///   FILE.csv                a point A,B per line, joined by a periodic cubic spline; a first line may name the joints
#[derive(Args)]
#[command(verbatim_doc_comment)]
pub struct Curvature {
    #[command(flatten)]
    robot: RobotArgs,
    /// The two joints (coordinates) that move.
    #[arg(long, value_name = "A,B", value_delimiter = ',', required = true)]
    joints: Vec<String>,
    /// Where the other joints are held: the "q" of a state of `frs eval`, '[…]' or '{"name": value}'. Without it: 0.
    #[arg(long, value_name = "Q", allow_hyphen_values = true)]
    at: Option<String>,
    /// Points along each side of the map.
    #[arg(long, value_name = "N", default_value = "101")]
    grid: usize,
    /// The range of both joints. Without it: their limits, or ±π rad, ±1 m where there are none.
    #[arg(long, value_name = "A0:A1,B0:B1", allow_hyphen_values = true)]
    window: Option<String>,
    /// A closed gait to draw and to judge.
    #[arg(long, value_name = "GAIT", conflicts_with = "optimise")]
    gait: Option<String>,
    /// Find the closed gait of given perimeter that turns the base most about this axis of its own.
    #[arg(long, value_name = "AXIS", requires = "perimeter")]
    optimise: Option<Turn>,
    /// Euclidean length of the best gait in the two joints, rad or m.
    #[arg(long, value_name = "LENGTH", requires = "optimise", allow_hyphen_values = true)]
    perimeter: Option<f64>,
    /// Folder for the files; made if need be.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Print one JSON object instead of tables.
    #[arg(long)]
    json: bool,
}

/// What a gait shall do.
#[derive(Clone, Copy, ValueEnum)]
enum Turn {
    RotationX,
    RotationY,
    RotationZ,
}

impl Turn {
    fn axis(self) -> Vector3<f64> {
        match self {
            Self::RotationX => Vector3::x(),
            Self::RotationY => Vector3::y(),
            Self::RotationZ => Vector3::z(),
        }
    }
}

/// A component of a field in a file: its name there, what it is, its symbol, and whether it is a length.
const COMPONENTS: [(&str, &str, bool); 9] = [
    ("omega_x", "ω_x", false),
    ("omega_y", "ω_y", false),
    ("omega_z", "ω_z", false),
    ("v_x", "v_x", true),
    ("v_y", "v_y", true),
    ("v_z", "v_z", true),
    ("minimum_omega_x", "ω_x", false),
    ("minimum_omega_y", "ω_y", false),
    ("minimum_omega_z", "ω_z", false),
];

/// Of a field whose largest component is 1, a component below this is zero and rounding.
const VANISHES: f64 = 1e-11;

impl Curvature {
    pub fn run(self) -> Result<(), Failure> {
        let model = self.robot.model()?;
        let axes = Axes::new(&model, &self.joints, self.at.as_deref())?;
        let window = self.window.as_deref().map_or_else(|| Ok(axes.limits()), |text| axes.window(text))?;
        if self.grid < 2 {
            return Err(Failure::Input(format!("--grid {}: expected at least 2 points along each side", self.grid)));
        }
        let target =
            self.optimise.zip(self.perimeter).map(|(turn, length)| target(turn, length, window)).transpose()?;
        let given = self.gait.as_deref().map(|text| gait::read(text, &axes)).transpose()?;
        let grid = Grid::new(window, self.grid);
        let (field, minimum) = sample(&model, &axes, grid);
        let (gait, best) = match target {
            None => (given, None),
            Some(target) => {
                let progress = ProgressBar::new_spinner().with_message("looking for the best gait");
                progress.tick();
                let best = best_gait(&mut Evaluator::new(&model), &axes.plane, target, || progress.tick());
                progress.finish_and_clear();
                let best = best.map_err(|error| Failure::Check(format!("the best gait: {error}")))?;
                (Some(best.gait.clone()), Some(best))
            }
        };
        let outcome = gait.as_ref().map(|gait| Outcome::of(&model, &axes, gait, minimum.as_ref())).transpose()?;
        let files = self.write(&model, &axes, &field, minimum.as_ref(), gait.as_ref(), best.is_some())?;
        let report = Report { model: &model, axes: &axes, grid, files, minimum, outcome, best };
        if self.json { report.json() } else { report.print() }
    }

    /// Writes all files and returns their names.
    fn write(
        &self,
        model: &Model,
        axes: &Axes<'_>,
        field: &CurvatureField,
        minimum: Option<&MinimumPerturbation>,
        gait: Option<&Gait>,
        found: bool,
    ) -> Result<Vec<String>, Failure> {
        let mut layers = field.components.to_vec();
        layers.extend(minimum.map(|minimum| minimum.curvature(field)).into_iter().flatten());
        let drawn = gait.map(|gait| gait::drawn(gait, axes)).unwrap_or_default();
        let overall = layers.iter().map(largest).fold(0.0, f64::max);
        let mut files = Vec::new();
        let mut write = |name: String, text: &str| {
            super::write(&self.out.join(&name), text)?;
            files.push(name);
            Ok::<(), Failure>(())
        };
        for ((name, symbol, length), values) in COMPONENTS.into_iter().zip(&layers) {
            let frame = if name.starts_with("minimum") { "minimum-perturbation coordinates" } else { "base frame" };
            let map = Map {
                component: symbol,
                caption: &format!("{}, {frame}", model.name()),
                unit: &axes.unit(length),
                axes: axes.labels(),
                grid: field.grid,
                values,
                vanishes: largest(values) <= VANISHES * overall,
                gait: &drawn,
            };
            write(format!("{name}.svg"), &map.svg())?;
        }
        write("fields.csv".into(), &table(axes, field.grid, &layers))?;
        if let Some(gait) = gait.filter(|_| found) {
            write("best_gait.csv".into(), &gait::table(gait, axes))?;
        }
        Ok(files)
    }
}

/// 𝓑 on the grid and, unless the robot is singular there, minimum-perturbation coordinates.
fn sample(model: &Model, axes: &Axes<'_>, grid: Grid) -> (CurvatureField, Option<MinimumPerturbation>) {
    let mut robot = Evaluator::new(model);
    let progress = ProgressBar::new(grid.points() as u64).with_message("curvature");
    let field = CurvatureField::sample(&mut robot, &axes.plane, grid, || progress.inc(1));
    progress.finish_and_clear();
    let singular = field.components[0].iter().filter(|value| !value.is_finite()).count();
    if singular > 0 {
        eprintln!(
            "warning: the robot is singular at {singular} points of the map; they are crossed out, and NaN in fields.csv"
        );
    }
    let progress = ProgressBar::new_spinner().with_message("minimum-perturbation coordinates");
    progress.tick();
    let minimum = MinimumPerturbation::find(&mut robot, &axes.plane, grid, || progress.tick());
    progress.finish_and_clear();
    if minimum.is_err() {
        eprintln!("warning: the robot is singular in the window; there are no minimum-perturbation coordinates");
    }
    (field, minimum.ok())
}

fn target(turn: Turn, perimeter: f64, window: [[f64; 2]; 2]) -> Result<Target, Failure> {
    let around = 2.0 * window.iter().map(|[low, high]| high - low).sum::<f64>();
    if !(perimeter > 0.0 && perimeter <= around) {
        return Err(Failure::Input(format!(
            "--perimeter {perimeter}: expected a length above 0 and up to {around}, the perimeter of the window"
        )));
    }
    Ok(Target { axis: turn.axis(), perimeter, window })
}

/// All components at all points, a line each.
fn table(axes: &Axes<'_>, grid: Grid, layers: &[DMatrix<f64>]) -> String {
    let names = COMPONENTS.iter().take(layers.len()).map(|(name, ..)| *name);
    let mut text = axes.names().into_iter().chain(names).collect::<Vec<_>>().join(",") + "\n";
    for (i, j) in (0..grid.points()).flat_map(|j| (0..grid.points()).map(move |i| (i, j))) {
        let numbers = grid.point(i, j).into_iter().chain(layers.iter().map(|layer| layer[(i, j)]));
        text += &(numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(",") + "\n");
    }
    text
}
