//! Single evaluations: how far each quantity is from itself with 31 digits, and how far it provably is at most.

use std::f64::consts::{FRAC_PI_2, PI};
use std::io::Write;

use comfy_table::{CellAlignment, Table, presets};
use frs::enclosure::Interval;
use frs::extended::DoubleDouble;
use frs::nalgebra::DMatrix;
use frs::spatial::{Twist, Wrench};
use frs::{Evaluator, FloatingBase, Model, Quantity, Real, Route, Workspace};
use frs_codegen::Counts;
use frs_codegen::record::{Recorded, record};
use indicatif::ProgressBar;
use serde_json::json;

use crate::cli::table;

/// One thing that is computed.
pub struct Row {
    pub name: String,
    /// Operations of an evaluation, as the core performs them.
    pub operations: usize,
    /// Worst errors in `f64` and `f32`, in units of the resolution and of the largest entry.
    pub errors: [f64; 2],
    /// What the error in `f64` is at most by interval arithmetic, in the same units; infinite where that bounds nothing.
    pub proven: f64,
}

/// All of a robot.
pub struct Study {
    pub rows: Vec<Row>,
    pub states: usize,
    /// The largest condition number of Λ_q.
    pub condition: f64,
}

/// What a robot is asked, over any scalar.
enum Question {
    Quantity(Quantity),
    ShapeAcceleration(Route),
    TextbookInertia,
    HamelAcceleration,
}

/// Joint angles at which states are drawn.
const SHAPES: [fn(&mut fastrand::Rng) -> f64; 3] =
    [|rng| PI * number(rng), |rng| FRAC_PI_2 * rng.i32(-4..=4) as f64, |rng| 1e6 * number(rng)];

/// In (−1, 1), and exact in single precision, so that all scalars are asked the same.
fn number(rng: &mut fastrand::Rng) -> f64 {
    f64::from(2.0 * rng.f32() - 1.0)
}

/// Eigenvalues below this share of the largest are rounding.
const SINGULAR: f64 = 1e-300;

impl Question {
    fn all(model: &Model) -> Vec<(Self, Vec<String>)> {
        let tool = Quantity::Kinematics(model.links().len() - 1);
        let named = |quantity: Quantity| {
            let outputs = quantity.outputs().map(|output| format!("{}: {}", quantity.name(), output.symbol)).collect();
            (Self::Quantity(quantity), outputs)
        };
        // What `matrices` gives is asked for by itself, too.
        let quantities = Quantity::ALL.into_iter().filter(|quantity| *quantity != Quantity::Matrices);
        let mut all: Vec<_> = quantities.chain([tool]).map(named).collect();
        all.push((Self::TextbookInertia, vec!["Λ_q, textbook form".into()]));
        for (route, name) in [
            (Route::Articulated, "q̈, articulated sweep"),
            (Route::Complement, "q̈, Λ_q by the complement form"),
            (Route::Textbook, "q̈, Λ_q by the textbook form"),
        ] {
            all.push((Self::ShapeAcceleration(route), vec![name.into()]));
        }
        all.push((Self::HamelAcceleration, vec!["[V̇₁; q̈], M factored whole".into()]));
        all
    }

    /// What a robot answers in a state: q, q̇, then numbers for whatever else is asked for.
    fn answers<T: Real>(&self, model: &Model<T>, state: &[T]) -> Vec<Vec<T>> {
        let n = model.dof();
        let (q, rest) = state.split_at(n);
        let (qd, rest) = rest.split_at(n);
        let six = |from: usize| -> [T; 6] { std::array::from_fn(|i| rest[from + i]) };
        let (mu, wrench, tau) = (Twist::from_array(six(0)), Wrench::from_array(six(6)), &rest[12..12 + n]);
        let mut work = Workspace::new(model);
        match *self {
            Self::Quantity(quantity) => {
                let inputs: Vec<&[T]> = quantity
                    .inputs()
                    .map(|input| match input.name {
                        "q" => q,
                        "qd" => qd,
                        _ => &rest[..input.len(n)],
                    })
                    .collect();
                let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|out| vec![T::zero(); out.len(n)]).collect();
                let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
                Evaluator::new(model).answer(quantity, &inputs, &mut slices);
                outputs
            }
            Self::TextbookInertia => {
                let mut out = DMatrix::zeros(n, n);
                work.shape(q).shape_inertia_textbook(&mut out);
                vec![out.as_slice().to_vec()]
            }
            Self::ShapeAcceleration(route) => {
                let mut out = vec![T::zero(); n];
                work.shape(q).moving(qd).shape_acceleration_by(route, mu, wrench, tau, &mut out);
                vec![out]
            }
            Self::HamelAcceleration => {
                let (mut memory, mut out) = (DMatrix::zeros(6 + n, 6 + n), vec![T::zero(); 6 + n]);
                let mut shape = work.shape(q);
                let mut robot = shape.moving(qd);
                robot.hamel_acceleration(robot.base_twist(mu), wrench, tau, &mut memory, &mut out);
                vec![out]
            }
        }
    }
}

impl Study {
    /// Asks for everything in `count` states of each kind of shape.
    pub fn of(model: &Model, count: usize, bar: &ProgressBar) -> Self {
        let single = model.cast::<f32>().orthonormalised();
        let precise = model.cast::<DoubleDouble>().orthonormalised();
        let enclosing = model.cast::<Interval>().orthonormalised();
        // f32 parameters are others: what they are is exact for the yardstick of f32.
        let single_precise = single.map(DoubleDouble::from).orthonormalised();
        let n = model.dof();
        let questions = Question::all(model);
        let numbers = 3 * n + 18;
        let mut rows: Vec<Row> = Vec::new();
        for (question, names) in &questions {
            let operations = operations(question, model, 2 * n + numbers);
            rows.extend(names.iter().map(|name| Row { name: name.clone(), operations, errors: [0.0; 2], proven: 0.0 }));
        }
        let mut rng = fastrand::Rng::with_seed(7);
        let mut condition = 0.0_f64;
        bar.set_length((count * SHAPES.len()) as u64);
        for shape in SHAPES {
            for _ in 0..count {
                let mut state: Vec<f64> = (0..n).map(|_| f64::from(shape(&mut rng) as f32)).collect();
                state.extend((0..n + numbers).map(|_| number(&mut rng)));
                let short: Vec<f32> = state.iter().map(|x| *x as f32).collect();
                let long: Vec<DoubleDouble> = state.iter().map(|x| DoubleDouble::from(*x)).collect();
                let points: Vec<Interval> = state.iter().map(|x| Interval::from(*x)).collect();
                let mut row = rows.iter_mut();
                for (question, _) in &questions {
                    let (doubles, exact) = (question.answers(model, &state), question.answers(&precise, &long));
                    let proven = farthest(&doubles, &question.answers(&enclosing, &points), &exact);
                    let found = [
                        worst(&doubles, &exact, f64::EPSILON),
                        worst(
                            &question.answers(&single, &short),
                            &question.answers(&single_precise, &long),
                            f32::EPSILON.into(),
                        ),
                    ];
                    for (output, row) in (0..found[0].len()).zip(&mut row) {
                        row.errors = std::array::from_fn(|scalar| row.errors[scalar].max(found[scalar][output]));
                        row.proven = row.proven.max(proven[output]);
                    }
                }
                condition = condition.max(shape_condition(model, &state[..n]));
                bar.inc(1);
            }
        }
        Self { rows, states: count * SHAPES.len(), condition }
    }

    /// A table for people.
    pub fn print(&self, out: &mut impl Write, model: &Model) -> std::io::Result<()> {
        table::robot(out, model)?;
        writeln!(
            out,
            "{} states: random ones, quarter turns, and angles of 10⁶ rad; Λ_q has a condition number of {:.0e} at most\n\
             worst error in units of the resolution (2⁻⁵², 2⁻²³) of the largest entry; f64 at most: proven by interval arithmetic\n",
            self.states, self.condition
        )?;
        let mut rows = Table::new();
        rows.load_preset(presets::NOTHING);
        rows.add_row(["", "operations", "f64", "f64 at most", "f32"]);
        for row in &self.rows {
            let [double, single] = row.errors.map(units);
            rows.add_row([row.name.clone(), row.operations.to_string(), double, units(row.proven), single]);
        }
        for column in rows.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        writeln!(out, "{rows}")
    }

    /// The same for programs.
    pub fn json(&self, model: &Model) -> serde_json::Value {
        let row = |row: &Row| json!({ "name": row.name, "operations": row.operations, "f64": row.errors[0], "f64_proven": row.proven, "f32": row.errors[1] });
        json!({
            "robot": model.name(),
            "states": self.states,
            "shape_condition": self.condition,
            "errors_in_resolutions": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }
}

fn units(error: f64) -> String {
    if error.is_infinite() {
        "–".into()
    } else if error < 1e4 {
        format!("{error:.1}")
    } else {
        format!("{error:.1e}")
    }
}

/// For each output the largest error, in units of its largest entry and of `resolution`.
fn worst<T: Real + Into<DoubleDouble>>(found: &[Vec<T>], exact: &[Vec<DoubleDouble>], resolution: f64) -> Vec<f64> {
    let each = found.iter().zip(exact).map(|(found, exact)| {
        in_units(found.iter().zip(exact).map(|(&a, &b)| (a.into() - b).high().abs()), exact, resolution)
    });
    each.collect()
}

/// For each output the largest way from a double to the farther end of its interval, in units of its largest entry and of 2⁻⁵².
fn farthest(found: &[Vec<f64>], enclosed: &[Vec<Interval>], exact: &[Vec<DoubleDouble>]) -> Vec<f64> {
    let each = found.iter().zip(enclosed).zip(exact).map(|((found, enclosed), exact)| {
        let ways = found.iter().zip(enclosed).map(|(x, within)| (within.upper() - x).max(x - within.lower()));
        in_units(ways, exact, f64::EPSILON)
    });
    each.collect()
}

/// The largest error, in units of the largest entry and of `resolution`.
fn in_units(errors: impl Iterator<Item = f64>, exact: &[DoubleDouble], resolution: f64) -> f64 {
    let largest = exact.iter().fold(0.0_f64, |largest, x| largest.max(x.high().abs()));
    // NaN must win: it is the worst of all.
    let error = errors.fold(0.0, |worst: f64, error| if error > worst || error.is_nan() { error } else { worst });
    if error == 0.0 { 0.0 } else { error / (resolution * largest) }
}

fn operations(question: &Question, model: &Model, numbers: usize) -> usize {
    let (start, tape) = record(|| {
        let model: Model<Recorded> = model.cast();
        let state: Vec<Recorded> = (0..numbers as u32).map(Recorded::input).collect();
        let start = state.last().map_or(0, |last| last.0);
        question.answers(&model, &state);
        start
    });
    let mut counts = Counts::default();
    tape[start as usize..].iter().for_each(|operation| counts.count(*operation));
    counts.flops()
}

fn shape_condition(model: &Model, q: &[f64]) -> f64 {
    let n = model.dof();
    let mut inertia = DMatrix::zeros(n, n);
    Workspace::new(model).shape(q).shape_inertia(&mut inertia);
    let values = inertia.symmetric_eigenvalues();
    if n == 0 { 1.0 } else { values.max() / values.min().max(SINGULAR) }
}
