//! What to generate, as arguments.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use frs::Quantity;
use frs_codegen::{Lanes, Options, Precision};

use super::Failure;

/// Where the help lists these arguments.
const HEADING: &str = "What to generate";

/// What to generate.
#[derive(Args)]
pub struct GenerateArgs {
    /// Generate only these quantities instead of all.
    #[arg(long, help_heading = HEADING, value_name = "QUANTITY,…", value_delimiter = ',', value_parser = quantity())]
    outputs: Option<Vec<Quantity>>,
    /// Generate the kinematics of these links instead of those at the ends of the chains.
    #[arg(long, help_heading = HEADING, value_name = "LINK,…", value_delimiter = ',')]
    links: Option<Vec<String>>,
    /// What is known about the momentum.
    #[arg(long, help_heading = HEADING, value_enum, default_value = "driven")]
    momentum: Momentum,
    /// Leave gravity out: the robot falls freely, or is far from everything.
    #[arg(long, help_heading = HEADING)]
    no_gravity: bool,
    /// Hold this coordinate at this value, in radians or metres; may be given several times.
    #[arg(long, help_heading = HEADING, value_name = "NAME=VALUE")]
    lock: Vec<String>,
    /// Keep the ten inertial parameters of this link an input.
    #[arg(long, help_heading = HEADING, value_name = "LINK")]
    payload: Option<String>,
    /// Compute in single precision.
    #[arg(long, help_heading = HEADING)]
    f32: bool,
    /// Evaluate so many states at once, side by side in one instruction; 4 goes without --f32, 16 with it.
    #[arg(long, help_heading = HEADING, value_name = "N", default_value = "1", value_parser = lanes())]
    lanes: Lanes,
    /// In what form the code is written.
    #[arg(long, help_heading = HEADING, value_enum, default_value = "unrolled")]
    form: Form,
}

/// How the code is written.
#[derive(Clone, Copy, ValueEnum)]
enum Form {
    /// number by number
    Unrolled,
    /// what is the same for four bodies by vectors: half the machine code where a register holds four numbers
    Hybrid,
    /// tables of the robot's constants, and the core's loops over them
    Tabled,
    /// for each quantity the first of these whose code is short: 32 KiB unrolled, 48 hybrid
    Auto,
}

/// What is known about the momentum.
#[derive(Clone, Copy, ValueEnum)]
enum Momentum {
    /// it is zero and stays so: mu is no input
    Zero,
    /// no wrench acts: of the accelerations only those of the joints are computed
    Conserved,
    /// anything may act
    Driven,
}

impl GenerateArgs {
    /// The same for the generator, which checks them against the robot.
    pub fn options(&self) -> Result<Options, Failure> {
        let locked = self.lock.iter().map(|text| held(text)).collect::<Result<_, _>>().map_err(Failure::Input)?;
        Ok(Options {
            outputs: self.outputs.clone(),
            links: self.links.clone(),
            momentum: match self.momentum {
                Momentum::Zero => frs_codegen::Momentum::Zero,
                Momentum::Conserved => frs_codegen::Momentum::Conserved,
                Momentum::Driven => frs_codegen::Momentum::Driven,
            },
            without_gravity: self.no_gravity,
            locked,
            payload: self.payload.clone(),
            precision: if self.f32 { Precision::Single } else { Precision::Double },
            lanes: self.lanes,
            form: match self.form {
                Form::Unrolled => frs_codegen::Form::Unrolled,
                Form::Hybrid => frs_codegen::Form::Hybrid,
                Form::Tabled => frs_codegen::Form::Tabled,
                Form::Auto => frs_codegen::Form::Auto,
            },
            standalone: false,
        })
    }
}

/// A coordinate and its value.
fn held(text: &str) -> Result<(String, f64), String> {
    let parts = text.rsplit_once('=').and_then(|(name, value)| Some((name, value.trim().parse::<f64>().ok()?)));
    match parts {
        Some((name, value)) if value.is_finite() => Ok((name.trim().to_owned(), value)),
        _ => Err(format!(
            "--lock '{text}': this is no coordinate with a value; expected NAME=VALUE; write for example --lock elbow=1.2"
        )),
    }
}

/// Reads the name of a quantity.
pub fn quantity() -> impl TypedValueParser<Value = Quantity> {
    let all = || Quantity::ALL.into_iter().chain([Quantity::Kinematics(0)]);
    let names = all().map(|quantity| PossibleValue::new(quantity.name()).help(quantity.meaning()));
    PossibleValuesParser::new(names)
        .map(move |name| all().find(|quantity| quantity.name() == name).unwrap_or(Quantity::Inertia))
}

/// Reads a number of lanes.
fn lanes() -> impl TypedValueParser<Value = Lanes> {
    PossibleValuesParser::new(["1", "4", "8", "16"]).map(|number| match number.as_str() {
        "4" => Lanes::Four,
        "8" => Lanes::Eight,
        "16" => Lanes::Sixteen,
        _ => Lanes::One,
    })
}
