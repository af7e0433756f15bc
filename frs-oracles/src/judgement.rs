//! What a case's formulas say of the core and of generated code.

use frs_core::extended::DoubleDouble;
use frs_core::{Evaluator, Model};

use crate::{Case, Comparison, Values, compare, points, shapes};

/// Largest relative difference of two computations in doubles: rounding of some hundred operations, and what solving with
/// locked inertias whose axes differ by a factor of a hundred makes of it. A wrong sign gives 1e-2 or more.
pub const ROUNDING: f64 = 1e-13;

/// The same in double-double, whose rounding is 1e-31 or smaller.
pub const EXTENDED: f64 = 1e-28;

/// The same where an axis of the robot was rounded to doubles, and the formula's was not.
const ROUNDED_AXIS: f64 = 1e-15;

/// Random shapes at which a case is judged, besides q = 0 and those whose numbers are known.
const SHAPES: usize = 100;

/// A case's robot by four ways, and by the yardstick: its formulas in double-double.
#[derive(Debug)]
pub struct Robots {
    case: Case,
    model: Model,
    extended: Model<DoubleDouble>,
}

/// What four ways answer at one shape.
#[derive(Clone, Debug)]
pub struct Answers {
    /// The formulas in double-double: the yardstick.
    pub exact: Values<DoubleDouble>,
    /// The formulas in doubles.
    pub formula: Values<f64>,
    /// The core in doubles.
    pub core: Values<f64>,
    /// The generated code.
    pub generated: Values<f64>,
    /// The core in double-double.
    pub extended: Values<DoubleDouble>,
}

/// How far four ways are from the formulas in double-double.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// The formulas in doubles.
    pub formula: Comparison,
    /// The core in doubles.
    pub core: Comparison,
    /// The generated code.
    pub generated: Comparison,
    /// The core in double-double.
    pub extended: Comparison,
}

impl Case {
    /// The robot, read from its URDF.
    pub fn model(self) -> Model {
        Model::from_urdf(self.urdf()).expect("the crate's own robot")
    }

    /// Largest differences from the formulas in double-double that the four ways of a [`Judgement`] may have.
    pub fn tolerances(self) -> [f64; 4] {
        [ROUNDING, ROUNDING, ROUNDING, if self.exception().is_some() { ROUNDED_AXIS } else { EXTENDED }]
    }

    /// Why the core in double-double cannot come closer to the formulas than doubles do, where it cannot.
    pub fn exception(self) -> Option<&'static str> {
        (self == Self::G2).then_some(
            "the axis (1, 2, 2)/3 is no double: a model holds it rounded to 53 bits, the formulas to as many as they are evaluated with",
        )
    }
}

impl Robots {
    /// The robots of a case.
    pub fn new(case: Case) -> Self {
        let model = case.model();
        let extended = model.cast::<DoubleDouble>().orthonormalised();
        Self { case, model, extended }
    }

    /// The robot over doubles.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// What each way answers at shape `q`.
    ///
    /// # Panics
    /// If `q` does not have one entry per coordinate.
    pub fn answers(&self, q: &[f64]) -> Answers {
        let wide: Vec<_> = q.iter().map(|&q| DoubleDouble::from(q)).collect();
        Answers {
            exact: self.case.values(&wide),
            formula: self.case.values(q),
            core: Values::of(&mut Evaluator::new(&self.model), q),
            generated: Values::of(self.case.generated().as_mut(), q),
            extended: Values::of(&mut Evaluator::new(&self.extended), &wide),
        }
    }
}

impl Answers {
    /// How far each way is from the yardstick.
    pub fn judgement(&self) -> Judgement {
        let of = |values: &Values<f64>| compare(&values.widened(), &self.exact);
        Judgement {
            formula: of(&self.formula),
            core: of(&self.core),
            generated: of(&self.generated),
            extended: compare(&self.extended, &self.exact),
        }
    }
}

impl Judgement {
    /// Whether every difference is within its tolerance.
    pub fn holds(&self, case: Case) -> bool {
        let ways = [&self.formula, &self.core, &self.generated, &self.extended];
        ways.into_iter().zip(case.tolerances()).all(|(way, tolerance)| way.within(tolerance))
    }

    fn or(self, other: Self) -> Self {
        Self {
            formula: self.formula.or(other.formula),
            core: self.core.or(other.core),
            generated: self.generated.or(other.generated),
            extended: self.extended.or(other.extended),
        }
    }
}

/// The shapes at which a case is judged: q = 0, those whose numbers are known, and random ones.
pub fn judged_shapes(case: Case) -> Vec<Vec<f64>> {
    let mut all = vec![vec![0.0; case.generated().dof()]];
    all.extend(points(case).into_iter().map(|point| point.q));
    all.extend(shapes(case, SHAPES, 1));
    all
}

/// The worst over all [`judged_shapes`].
pub fn judge(case: Case) -> Judgement {
    let robots = Robots::new(case);
    let at_zero = robots.answers(&vec![0.0; robots.model().dof()]).judgement();
    judged_shapes(case).iter().map(|q| robots.answers(q).judgement()).fold(at_zero, Judgement::or)
}
