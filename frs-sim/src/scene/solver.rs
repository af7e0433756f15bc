//! `accuracy` and `[solver]`: how the motion is computed.

use frs_core::Route;

use super::reader::Table;
use crate::integrate::{Method, Steps};

/// Which equations of motion are integrated. All have the same solution.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Equations {
    /// The REL equations; a momentum that is known is not integrated.
    #[default]
    Reduced,
    /// The REL equations, the locked velocity μ always integrated.
    Integrated,
    /// `M V̇ + C V = F`, the base velocity V₁ integrated; for comparison.
    Hamel,
}

/// How a motion is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solver {
    /// The method of integration.
    pub method: Method,
    /// How long its steps are.
    pub steps: Steps,
    /// What is integrated.
    pub equations: Equations,
    /// How the shape acceleration is found.
    pub route: Route,
}

/// Accuracy of a scene that does not say.
const ACCURACY: f64 = 1e-8;

/// Equations by their names in scenes.
pub const EQUATIONS: [(&str, Equations); 3] =
    [("reduced", Equations::Reduced), ("integrated", Equations::Integrated), ("hamel", Equations::Hamel)];

/// Routes by their names in scenes.
pub const ROUTES: [(&str, Route); 3] =
    [("articulated", Route::Articulated), ("complement", Route::Complement), ("textbook", Route::Textbook)];

impl Default for Solver {
    fn default() -> Self {
        let (equations, route) = Default::default();
        Self { method: Method::Dop853, steps: Steps::Accuracy(ACCURACY), equations, route }
    }
}

/// Joints up to which factoring Λ_q is about as cheap as the articulated sweep, which loses digits over a light base.
const FACTORED: usize = 10;

impl Solver {
    /// The accuracy of its steps; of what goes along beside uniform ones, the one of a scene that does not say.
    pub fn accuracy(&self) -> f64 {
        match self.steps {
            Steps::Accuracy(accuracy) => accuracy,
            Steps::Length(_) => ACCURACY,
        }
    }
}

pub fn read(root: &Table<'_, '_>, joints: usize) -> Option<Solver> {
    let accuracy = root.get("accuracy").map_or(Some(ACCURACY), |item| {
        let accuracy = item.positive()?;
        match (1e-14..=1e-1).contains(&accuracy) {
            true => Some(accuracy),
            false => item.refuse(format!("found {accuracy:e}; expected a number from 1e-14 to 1e-1")),
        }
    });
    let table = match root.get("solver") {
        Some(item) => item.table()?,
        None => root.empty("solver"),
    };
    table.only(&["method", "step", "equations", "route"]);
    let methods = Method::ALL.map(|method| (method.name(), method));
    let default = Solver::default();
    let method = table.get("method").map_or(Some(default.method), |item| item.choice(&methods));
    let equations = table.get("equations").map_or(Some(default.equations), |item| item.choice(&EQUATIONS));
    let usual = if joints <= FACTORED { Route::Complement } else { Route::Articulated };
    let route = table.get("route").map_or(Some(usual), |item| item.choice(&ROUTES));
    let steps = match table.get("step") {
        Some(step) => match root.get("accuracy") {
            Some(item) => item.refuse("solver.step is given, too; expected one of the two"),
            None => step.positive().map(Steps::Length),
        },
        None if method.is_some_and(|method| !method.estimates_its_error()) => {
            let name = method?.name();
            table.refuse(format!(
                "{name} does not estimate its error; expected solver.step, the length of its steps, s"
            ));
            None
        }
        None => accuracy.map(Steps::Accuracy),
    };
    Some(Solver { method: method?, steps: steps?, equations: equations?, route: route? })
}
