//! `frs verify`: generated code against the core, bit for bit.

mod compare;
mod element;
mod harness;
mod reference;
mod report;
mod run;
mod states;
mod time;

use std::time::{Duration, Instant};

use clap::{Args, value_parser};
use frs_codegen::{Form, Options, Precision, generate};
use indicatif::ProgressBar;

use self::element::Element;
use self::harness::Harness;
use self::report::Report;
use self::run::Run;
use self::states::Layout;
use super::options::GenerateArgs;
use super::{Failure, RobotArgs};

/// Check that generated code gives the core's numbers, bit for bit.
///
/// Generates the robot, compiles the code with rustc into a temporary program, and asks it for every output of every
/// function. The recursive core, which knows nothing of generated code, answers the same states. Each pair of numbers
/// must have the same bits; numbers that are not finite on both sides count as equal, and are counted.
///
/// The states are random: angles within half a turn, everything else within one unit. Before them come hard ones: zeros of
/// both signs, exact quarter turns, angles and velocities of 1e12 and 1e-12, denormals, and mixtures of all these. (In
/// single precision 1e6 and 1e-6.) Sliding joints go out to 1e6 m, or to 1e3 m in single precision: farther out, the
/// robot's inertia is singular to rounding, and the core has no numbers to compare with.
///
/// What the options take away is zero for the core. With a payload, each state has a random one.
///
/// Times are medians in nanoseconds for one state, of the compiled program and of the core.
///
/// The compiler is the one named by the variable RUSTC, or rustc on the path. With lanes and of the
/// hybrid form cargo builds the program, for this processor, and needs the crate wide.
#[derive(Args)]
#[command(
    after_help = "Exit codes: 0 all bits are the same, 1 some differ or the code does not compile, 2 bad input or no compiler."
)]
pub struct Verify {
    #[command(flatten)]
    robot: RobotArgs,
    #[command(flatten)]
    options: GenerateArgs,
    /// How many random states.
    #[arg(long, value_name = "COUNT", default_value_t = 100_000)]
    states: usize,
    /// The same seed gives the same states.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// How far the compiler optimises the code.
    #[arg(long, value_name = "0…3", default_value_t = 2, value_parser = value_parser!(u8).range(0..=3))]
    opt_level: u8,
    /// Write the result as JSON instead of a table.
    #[arg(long)]
    json: bool,
}

impl Verify {
    pub fn run(self) -> Result<(), Failure> {
        let options = Options { standalone: true, ..self.options.options()? };
        if options.form == Form::Tabled {
            let message = "--form tabled: such code asks the core itself, and what is verified stands alone; \
                           expected unrolled, hybrid or auto; choose one of these";
            return Err(Failure::Input(message.into()));
        }
        match options.precision {
            Precision::Double => self.run_over::<f64>(&options),
            Precision::Single => self.run_over::<f32>(&options),
        }
    }

    fn run_over<E: Element>(&self, options: &Options) -> Result<(), Failure> {
        let model = self.robot.model()?;
        let invalid = |error: frs_codegen::GenerateError| Failure::Input(error.to_string());
        let generated = generate(&model, options).map_err(invalid)?;
        let text = generated.included_text();
        let layout = Layout::new(&generated.functions);
        let harness = Harness::write::<E>(&text, &generated.functions, &layout, options).map_err(Failure::Input)?;

        let started = Instant::now();
        let spinner = ProgressBar::new_spinner().with_message(format!("compiling {} lines", text.lines().count()));
        spinner.enable_steady_tick(Duration::from_millis(100));
        let compiled = harness.compile(self.opt_level);
        spinner.finish_and_clear();
        compiled?;
        let compile_seconds = started.elapsed().as_secs_f64();

        let run = Run {
            model: options.specialise(&model).map_err(invalid)?.cast::<E>(),
            payload: options.payload.as_deref(),
            functions: &generated.functions,
            layout,
            lanes: options.lanes.count(),
            seed: self.seed,
        };
        let outcome = run.all(&harness, self.states).map_err(Failure::Check)?;
        let report = Report {
            robot: model.name(),
            scalar: E::NAME,
            lanes: options.lanes.count(),
            seed: self.seed,
            source: &text,
            compile_seconds,
            functions: &generated.functions,
            outcome: &outcome,
        };
        report.write(self.json)?;
        match &outcome.comparison.first {
            None => Ok(()),
            Some(first) => Err(Failure::Check(format!(
                "{} numbers differ; the first is {}",
                outcome.comparison.differences(),
                first.text()
            ))),
        }
    }
}
