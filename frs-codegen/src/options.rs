//! What to generate: every choice changes what is emitted, never the bits of what remains.

use frs_core::{Model, Quantity};

use crate::error::GenerateError;
use crate::simplify::Precision;

/// What to generate for a robot. The default is everything, over `f64`, standing on `frs-core`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Options {
    /// The quantities; `None` for all that the other options leave.
    pub outputs: Option<Vec<Quantity>>,
    /// Links whose [`Quantity::Kinematics`] is generated; `None` for the links at the ends of the chains.
    pub links: Option<Vec<String>>,
    /// What is known about the momentum.
    pub momentum: Momentum,
    /// Whether the robot is out of gravity: `gravity` is then no input, and no operation deals with it.
    pub without_gravity: bool,
    /// Coordinates that are held, and their values (rad, m).
    pub locked: Vec<(String, f64)>,
    /// A link whose mass, centre of mass and rotational inertia stay inputs.
    pub payload: Option<String>,
    /// `f64` or `f32`.
    pub precision: Precision,
    /// How many states are evaluated at once: 1, or the lanes of a SIMD type.
    pub lanes: Lanes,
    /// In what form the operations are written.
    pub form: Form,
    /// Whether the text stands alone, without `frs-core`.
    pub standalone: bool,
}

/// How the operations are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Form {
    /// Number by number.
    #[default]
    Unrolled,
    /// What the core does to four bodies or joints at once, by vectors of four; number by number what goes from body to body. Half the
    /// machine code where a register holds four numbers. It needs [`F64x4`](frs_core::lanes::F64x4).
    Hybrid,
    /// Tables of the robot's constants, and the core's loops over them: as much code for a hundred joints as for one. It needs `frs-core`, and a
    /// little memory in each thread that calls it.
    Tabled,
    /// For each quantity the first of these whose predicted code is short enough for a processor's first cache.
    Auto,
}

/// What is known about the momentum of a robot.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Momentum {
    /// It is zero and stays so: μ is no input, only the shape has dynamics.
    Zero,
    /// It is conserved: no wrench acts, and of the accelerations only those of the shape are computed.
    Conserved,
    /// Anything may drive it.
    #[default]
    Driven,
}

/// States evaluated at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lanes {
    /// One state, plain numbers.
    #[default]
    One,
    /// Four states.
    Four,
    /// Eight states.
    Eight,
    /// Sixteen states, in single precision.
    Sixteen,
}

impl Lanes {
    /// How many.
    pub fn count(self) -> usize {
        match self {
            Self::One => 1,
            Self::Four => 4,
            Self::Eight => 8,
            Self::Sixteen => 16,
        }
    }
}

impl Options {
    /// Whether `quantity` still says something under these options; else, why not.
    pub(crate) fn leaves(&self, quantity: Quantity) -> Result<(), &'static str> {
        match (self.momentum, quantity) {
            (
                Momentum::Zero,
                Quantity::DMu
                | Quantity::B2
                | Quantity::Matrices
                | Quantity::CouplingTorque
                | Quantity::DMuXi
                | Quantity::Momentum
                | Quantity::VelocityOfMomentum,
            ) => Err("it vanishes with the momentum"),
            (Momentum::Zero | Momentum::Conserved, Quantity::InverseDynamics) => {
                Err("it asks for the wrench that changes the momentum")
            }
            (Momentum::Zero, Quantity::HamelBias) => Err("it depends on a base twist that the momentum determines"),
            _ => Ok(()),
        }
    }

    /// Whether `quantity` is asked for and left.
    pub(crate) fn asks(&self, quantity: Quantity) -> bool {
        match &self.outputs {
            Some(asked) => asked.iter().any(|one| one.name() == quantity.name()),
            None => self.leaves(quantity).is_ok(),
        }
    }

    /// The functions that every robot gets by these options, whatever its joints and links: name, and number of arguments.
    pub fn functions(&self) -> impl Iterator<Item = (&'static str, usize)> {
        Quantity::ALL.into_iter().filter(|quantity| self.asks(*quantity)).map(|quantity| {
            let inputs = quantity.inputs().filter(|argument| !self.vanishes(argument.name)).count();
            let payload = usize::from(self.payload.is_some());
            (quantity.name(), payload + inputs + quantity.outputs().count())
        })
    }

    /// Whether the input called `name` is zero under these options.
    pub(crate) fn vanishes(&self, name: &str) -> bool {
        match name {
            "mu" => self.momentum == Momentum::Zero,
            "base_wrench" => self.momentum != Momentum::Driven,
            "gravity" => self.without_gravity || self.momentum != Momentum::Driven,
            _ => false,
        }
    }

    /// Whether the options fit together, whatever the robot.
    pub(crate) fn check(&self) -> Result<(), GenerateError> {
        match (self.precision, self.lanes) {
            (Precision::Single, Lanes::Four) => Err(GenerateError::Lanes { lanes: 4, element: "f32" }),
            (Precision::Double, Lanes::Sixteen) => Err(GenerateError::Lanes { lanes: 16, element: "f64" }),
            _ => Ok(()),
        }
    }

    /// Whether `quantity` can be had in a form; else, what stands against it.
    pub(crate) fn allows(&self, form: Form, quantity: Quantity) -> Result<(), GenerateError> {
        let vanishes = || quantity.inputs().any(|argument| self.vanishes(argument.name));
        let (name, other) = match form {
            Form::Hybrid if self.precision == Precision::Single => ("hybrid", "f32"),
            Form::Hybrid if self.lanes != Lanes::One => ("hybrid", "lanes"),
            Form::Tabled if self.standalone => ("tabled", "standalone"),
            Form::Tabled if self.payload.is_some() => ("tabled", "a payload"),
            Form::Tabled if vanishes() && self.momentum != Momentum::Driven => ("tabled", "a known momentum"),
            Form::Tabled if vanishes() => ("tabled", "no gravity"),
            _ => return Ok(()),
        };
        Err(GenerateError::Form { form: name, other })
    }

    /// `model` with the held coordinates held.
    ///
    /// # Errors
    /// If a coordinate is unknown, held twice, or the last free one.
    pub fn specialise(&self, model: &Model) -> Result<Model, GenerateError> {
        if self.locked.is_empty() {
            return Ok(model.clone());
        }
        let held: Vec<(&str, f64)> = self.locked.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Ok(model.lock(&held)?)
    }
}
