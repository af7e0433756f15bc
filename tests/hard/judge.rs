//! How far every quantity at a state is from the same with 31 digits, in units of ε of its natural scale.

use std::collections::BTreeMap;
use std::fmt;

use frs::conditioning::roundings;
use frs::extended::DoubleDouble;
use frs::nalgebra::DMatrix;
use frs::spatial::{Twist, Wrench};
use frs::{Evaluator, FloatingBase, Model, Quantity, Real, Workspace};

use crate::scales::Scales;
use crate::state::State;

/// The errors of a robot at a state, or the worst of several, and what they may grow with.
#[derive(Clone, Debug, Default)]
pub struct Judged {
    /// By output; `xi_dot` is that of the articulated sweep, `xi_dot, factored` that of the factored Λ_q.
    pub errors: BTreeMap<&'static str, f64>,
    /// The error of Λ_q as it is usually formed, `M_q − A_lᵀ Λ_b A_l`.
    pub textbook: f64,
    /// The error of Λ_q where the lever arms of both joints of an entry are divided out.
    pub leverless: f64,
    /// The error of Λ_q in the scale of its largest entry.
    pub of_largest: f64,
    /// See [`frs::conditioning::Conditioning`].
    pub lever: f64,
    pub lightness: f64,
    pub condition: f64,
    /// The condition number of Λ_q as it is.
    pub plain_condition: f64,
}

impl Judged {
    /// The worst error, but of accelerations: what these lose depends on the condition of Λ_q.
    pub fn worst(&self) -> f64 {
        self.errors
            .iter()
            .filter(|(output, _)| !output.starts_with("xi_dot"))
            .map(|(_, &error)| error)
            .fold(0.0, nan_max)
    }

    pub fn join(&mut self, other: &Self) {
        for (output, &error) in &other.errors {
            let worst = self.errors.entry(output).or_insert(0.0);
            *worst = nan_max(*worst, error);
        }
        for (worst, number) in [
            (&mut self.textbook, other.textbook),
            (&mut self.leverless, other.leverless),
            (&mut self.of_largest, other.of_largest),
            (&mut self.lever, other.lever),
            (&mut self.lightness, other.lightness),
            (&mut self.condition, other.condition),
            (&mut self.plain_condition, other.plain_condition),
        ] {
            *worst = nan_max(*worst, number);
        }
    }
}

impl fmt::Display for Judged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { errors, textbook, leverless, of_largest, lever, lightness, condition, plain_condition } = self;
        write!(f, "worst {:.3e}; Λ_q: leverless {leverless:.2}, of largest {of_largest:.2}, ", self.worst())?;
        write!(f, "textbook {textbook:.3e}; lever {lever:.1e}, lightness {lightness:.1e}, ")?;
        write!(f, "condition {condition:.1e} ({plain_condition:.1e});")?;
        errors.iter().try_for_each(|(output, error)| write!(f, " {output} {error:.3}"))
    }
}

/// NaN must win: it is the worst of all.
fn nan_max(a: f64, b: f64) -> f64 {
    if b.is_nan() || b > a { b } else { a }
}

/// All outputs of `quantity`.
pub fn answer<T: Real>(robot: &mut Evaluator<T>, quantity: Quantity, state: &State) -> Vec<Vec<T>> {
    let n = robot.dof();
    let inputs: Vec<Vec<T>> = quantity
        .inputs()
        .map(|input| state.numbers(input.name, input.len(n)).into_iter().map(T::from_f64).collect())
        .collect();
    let inputs: Vec<&[T]> = inputs.iter().map(Vec::as_slice).collect();
    let mut outputs: Vec<Vec<T>> =
        quantity.outputs().map(|output| vec![T::from_f64(f64::NAN); output.len(n)]).collect();
    let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    robot.answer(quantity, &inputs, &mut slices);
    outputs
}

/// The errors of all quantities of `model` at `state`.
pub fn judge(model: &Model, state: &State) -> Judged {
    let n = model.dof();
    let precise = model.cast();
    let scales = Scales::new(&precise, state);
    let (mut robot, mut truth) = (Evaluator::new(model), Evaluator::<DoubleDouble>::new(&precise));
    let mut judged = Judged {
        lever: scales.conditioning.lever.value,
        lightness: scales.conditioning.lightness.value,
        condition: scales.conditioning.condition.value,
        plain_condition: scales.plain_condition,
        ..Judged::default()
    };
    for quantity in Quantity::ALL {
        let (got, exact) = (answer(&mut robot, quantity, state), answer(&mut truth, quantity, state));
        for ((output, got), exact) in quantity.outputs().zip(&got).zip(&exact) {
            let error = error(got, exact, &scales.of(output.name, state));
            let worst = judged.errors.entry(output.name).or_insert(0.0);
            *worst = nan_max(*worst, error);
        }
    }
    let exact = answer(&mut truth, Quantity::ForwardDynamics, state);
    judged.errors.insert("xi_dot, factored", error(&factored(model, state), &exact[0], &scales.of("xi_dot", state)));

    let (got, exact) = (answer(&mut robot, Quantity::Inertia, state), answer(&mut truth, Quantity::Inertia, state));
    let scale = scales.of("shape_inertia", state);
    let by_levers = |(k, scale): (usize, &f64)| scale * (scales.levers[k % n] * scales.levers[k / n]).sqrt();
    judged.leverless = error(&got[2], &exact[2], &scale.iter().enumerate().map(by_levers).collect::<Vec<_>>());
    let largest = exact[2].iter().map(|x| x.high().abs()).fold(0.0, f64::max);
    judged.of_largest = error(&got[2], &exact[2], &vec![largest; n * n]);
    let mut textbook = DMatrix::zeros(n, n);
    Workspace::new(model).shape(&state.numbers("q", n)).shape_inertia_textbook(&mut textbook);
    judged.textbook = error(textbook.as_slice(), &exact[2], &scale);
    judged
}

/// ξ̇ by factoring Λ_q.
fn factored(model: &Model, state: &State) -> Vec<f64> {
    let n = model.dof();
    let six = |name| -> [f64; 6] { state.numbers(name, 6).try_into().expect("six numbers") };
    let (mu, wrench) = (Twist::from_array(six("mu")), Wrench::from_array(six("base_wrench")));
    let mut xi_dot = vec![f64::NAN; 6 + n];
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&state.numbers("q", n));
    shape.moving(&state.numbers("qd", n)).forward_dynamics(mu, wrench, &state.numbers("tau", n), &mut xi_dot);
    state.numbers("gravity", 3).iter().zip(&mut xi_dot[3..6]).for_each(|(gravity, entry)| *entry += gravity);
    xi_dot
}

fn error(got: &[f64], exact: &[DoubleDouble], scales: &[f64]) -> f64 {
    let off = |(&got, &exact): (&f64, &DoubleDouble)| (DoubleDouble::from(got) - exact).high().abs();
    // What is exactly zero has scale 0.
    let units = |(off, scale): (f64, &f64)| if off == 0.0 { 0.0 } else { off / (scale * f64::EPSILON) };
    got.iter().zip(exact).map(off).zip(scales).map(units).fold(0.0, nan_max)
}

/// The worst of `states`; no error exceeds what its lever arms and its condition explain.
#[track_caller]
pub fn judge_all(name: &str, model: &Model, states: impl IntoIterator<Item = State>) -> Judged {
    let (mut all, allowed) = (Judged::default(), roundings(model.joints()));
    for state in states {
        let judged = judge(model, &state);
        let Judged { lever, condition, lightness, .. } = judged;
        assert!(judged.worst() <= allowed * lever, "{name}: {judged}");
        assert!(judged.errors["xi_dot, factored"] <= allowed * lever * condition, "{name}: {judged}");
        assert!(judged.errors["xi_dot"] <= allowed * lever * condition * lightness, "{name}: {judged}");
        all.join(&judged);
    }
    println!("{name}: {all}");
    all
}
