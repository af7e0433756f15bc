//! The ways to compute a scene.

use frs_core::Route;

use crate::integrate::{Method, Steps};
use crate::scene::{Case, EQUATIONS, Equations, ROUTES, Scene, Solver};

/// The numbers that a motion is computed with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scalar {
    /// `f32`, 7 digits.
    Single,
    /// `f64`, 16 digits.
    #[default]
    Double,
    /// [`DoubleDouble`](frs_core::extended::DoubleDouble), 31 digits.
    DoubleDouble,
}

/// What evaluates the equations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Evaluation {
    /// The recursive core.
    #[default]
    Core,
    /// Code made for the scene.
    Compiled,
}

/// One way to compute a scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Variant {
    /// Method, steps, equations, route.
    pub solver: Solver,
    /// Numbers.
    pub scalar: Scalar,
    /// Evaluation.
    pub evaluation: Evaluation,
}

/// Variants that differ in the length or the accuracy of their steps alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// What they share.
    pub shared: Variant,
}

impl Scalar {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
            Self::DoubleDouble => "double-double",
        }
    }

    /// What one operation is off by, relatively.
    pub fn resolution(self) -> f64 {
        match self {
            Self::Single => f32::EPSILON.into(),
            Self::Double => f64::EPSILON,
            Self::DoubleDouble => f64::EPSILON * f64::EPSILON,
        }
    }
}

impl Evaluation {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Core => "core",
            Self::Compiled => "compiled",
        }
    }
}

impl Variant {
    /// Its words but for the steps.
    pub fn names(&self) -> [&'static str; 6] {
        let Solver { method, steps, equations, route } = self.solver;
        let of = |pairs: &[(&'static str, bool)]| pairs.iter().find(|(_, own)| *own).map_or("", |(name, _)| *name);
        let pace = if matches!(steps, Steps::Accuracy(_)) { "error control" } else { "uniform steps" };
        [
            method.name(),
            pace,
            of(&EQUATIONS.map(|(name, other)| (name, other == equations))),
            of(&ROUTES.map(|(name, other)| (name, other == route))),
            self.scalar.name(),
            self.evaluation.name(),
        ]
    }
}

/// Steps of the coarsest motion with uniform steps.
const FEWEST: f64 = 16.0;

/// Of the accuracies, and of the lengths of uniform steps, each is this share of the one before it.
const FINER: f64 = 0.316_227_766_016_837_94; // 1/√10
const SHORTER: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The most variants of a curve: steps get shorter by a factor of 2¹⁸.
const MOST: i32 = 36;

impl Curve {
    /// Its variants for motions of `duration` (s).
    pub fn variants(self, duration: f64) -> impl Iterator<Item = Variant> {
        let Variant { solver, scalar, .. } = self.shared;
        let with = move |steps| Variant { solver: Solver { steps, ..solver }, ..self.shared };
        let accuracies = match scalar {
            Scalar::Single => [1e-2, 1e-7],
            Scalar::Double => [1e-2, 1e-14],
            // A double has to be not enough for more digits to be worth their time.
            Scalar::DoubleDouble => [1e-14, 1e-16],
        };
        (0..=MOST).map_while(move |k| match solver.steps {
            Steps::Accuracy(_) => {
                let accuracy = accuracies[0] * FINER.powi(k);
                // Rounding of the powers must not leave out the last.
                (accuracy > 0.99 * accuracies[1]).then(|| with(Steps::Accuracy(accuracy)))
            }
            Steps::Length(_) => Some(with(Steps::Length(duration / FEWEST * SHORTER.powi(k)))),
        })
    }
}

/// All curves of a scene, those first that are likely to be good; `compiled` if there is code made for the scene.
pub fn curves(scene: &Scene, compiled: bool) -> Vec<Curve> {
    let mut methods: Vec<(Method, bool)> = Vec::new();
    for method in Method::ALL.into_iter().rev() {
        if method.estimates_its_error() {
            methods.push((method, true));
        }
    }
    methods.extend(Method::ALL.into_iter().rev().map(|method| (method, false)));
    let mut evaluations = vec![Evaluation::Core];
    if compiled {
        evaluations.push(Evaluation::Compiled);
    }
    let mut curves = Vec::new();
    for scalar in [Scalar::Double, Scalar::Single, Scalar::DoubleDouble] {
        for (_, equations) in EQUATIONS {
            for (_, route) in ROUTES {
                for &evaluation in &evaluations {
                    for &(method, controlled) in &methods {
                        let steps = if controlled { Steps::Accuracy(1.0) } else { Steps::Length(scene.duration) };
                        let solver = Solver { method, steps, equations, route };
                        let shared = Variant { solver, scalar, evaluation };
                        if differs(scene, &shared) {
                            curves.push(Curve { shared });
                        }
                    }
                }
            }
        }
    }
    curves
}

/// Whether a variant is another than those before it, and one that is worth its time.
fn differs(scene: &Scene, variant: &Variant) -> bool {
    let Variant { solver: Solver { method, steps, equations, route }, scalar, evaluation } = *variant;
    let controlled = matches!(steps, Steps::Accuracy(_));
    let other_equations = match equations {
        Equations::Reduced => true,
        Equations::Integrated => scene.known_case() != Case::Driven,
        // Λ_q is not formed.
        Equations::Hamel => route == Route::Articulated,
    };
    // Where there are drives, Λ_q is factored whatever the route.
    let other_route = route == Route::Articulated || scene.drives::<f64>().is_none();
    let other_scalar = match scalar {
        Scalar::Double => true,
        // Newton's method of the implicit step ends where doubles do.
        Scalar::Single => evaluation == Evaluation::Core && method != Method::ImplicitMidpoint,
        // It is for the last digits alone.
        Scalar::DoubleDouble => {
            let usual = Solver { steps, ..Solver::default() };
            evaluation == Evaluation::Core && controlled && variant.solver == usual
        }
    };
    other_equations && other_route && other_scalar
}
