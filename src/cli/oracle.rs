//! `frs oracle`: the core and generated code against robots that are known in closed form.

mod list;
mod one;

use clap::Args;
use frs_oracles::{Case, Comparison, Judgement, judge};

use super::Failure;

/// Compare the core and generated code with robots whose connection is known in closed form.
///
/// Each case is a small robot with formulas for its local connection A_l and the curvature 𝓑 of that connection. The
/// formulas are evaluated in double-double, with some 31 digits; compared with that are the formulas in doubles, the core
/// in doubles, generated code, and the core in double-double, at q = 0 and at some hundred shapes.
///
/// Differences are relative: of A_l to its largest entry, of 𝓑 to its own or to the square of A_l's, whichever is larger.
#[derive(Args)]
#[command(after_help = "Exit codes: 0 all agree, 1 some difference is too large, 2 there is no such case.")]
pub struct Oracle {
    /// The case, as P5: its formulas, and their values beside what was computed. Without it: all cases.
    case: Option<String>,
    /// Write the result as JSON instead of a table.
    #[arg(long)]
    json: bool,
}

impl Oracle {
    pub fn run(self) -> Result<(), Failure> {
        let Some(id) = &self.case else {
            let cases: Vec<_> = Case::ALL.iter().map(|&case| (case, judge(case))).collect();
            list::write(&cases, self.json)?;
            return verdict(&cases);
        };
        let case = Case::named(id).ok_or_else(|| unknown(id))?;
        let judgement = judge(case);
        one::write(case, &judgement, self.json)?;
        verdict(&[(case, judgement)])
    }
}

/// The ways that are compared with the formulas in double-double.
const WAYS: [&str; 4] = ["formula", "core", "generated", "double-double"];

fn comparisons(judgement: &Judgement) -> [&Comparison; 4] {
    let Judgement { formula, core, generated, extended } = judgement;
    [formula, core, generated, extended]
}

fn verdict(cases: &[(Case, Judgement)]) -> Result<(), Failure> {
    let beyond: Vec<_> = cases.iter().filter(|(case, judgement)| !judgement.holds(*case)).collect();
    let Some((case, judgement)) = beyond.first() else { return Ok(()) };
    let worst = WAYS
        .into_iter()
        .zip(comparisons(judgement))
        .zip(case.tolerances())
        .find(|((_, comparison), tolerance)| !comparison.within(*tolerance));
    let first = worst.map_or_else(String::new, |((way, comparison), tolerance)| {
        let worst = comparison.larger();
        format!("; the first is {case:?}, {way} and formula: {worst}, allowed {tolerance:e}")
    });
    Err(Failure::Check(format!("{} of {} cases do not agree with their formulas{first}", beyond.len(), cases.len())))
}

fn unknown(id: &str) -> Failure {
    let known = || Case::ALL.iter().map(|case| case.id());
    let distance = |known: &&str| strsim::damerau_levenshtein(&id.to_uppercase(), known);
    let nearest = known().min_by_key(distance).unwrap_or_default();
    let known: Vec<_> = known().collect();
    Failure::Input(format!(
        "case '{id}': there is no such case; expected one of {}; did you mean {nearest}?",
        known.join(", ")
    ))
}
