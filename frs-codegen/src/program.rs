//! The quantities of one robot as operations: recorded, simplified, and with their names.

use std::collections::HashMap;

use frs_core::spatial::Symmetric3;
use frs_core::{Argument, Evaluator, FloatingBase, Label, Model, Pass, Quantity};
use nalgebra::Vector3;

use crate::error::GenerateError;
use crate::options::{Form, Momentum, Options};
use crate::record::{Grouped, Operation, Place, Recorded, Recording, record};
use crate::simplify::Graph;

/// All quantities of a robot over one graph.
pub struct Program {
    /// The operations.
    pub graph: Graph,
    /// The arrays that functions read; input numbers count through them.
    pub inputs: Vec<Input>,
    /// What is computed.
    pub functions: Vec<Function>,
    /// What the sweeps hold: the name of a place.
    pub sweeps: HashMap<Place, Named>,
}

/// An array of run-time numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Its name.
    pub name: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Number of its first entry.
    pub start: u32,
    /// Its length.
    pub len: usize,
}

/// A quantity to compute.
pub struct Function {
    /// Which.
    pub quantity: Quantity,
    /// What it reads, as numbers into [`Program::inputs`], in the order of the arguments.
    pub inputs: Vec<usize>,
    /// What it writes.
    pub outputs: Vec<Output>,
    /// What it leaves in scratch: names of places that only this function gives.
    pub scratch: HashMap<Place, Named>,
}

/// An output of a function.
pub struct Output {
    /// Its name.
    pub name: &'static str,
    /// Its symbol.
    pub symbol: &'static str,
    /// What it is, in which frame.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Rows and columns.
    pub shape: [usize; 2],
    /// How many such matrices.
    pub layers: usize,
    /// Where its numbers come from, column by column.
    pub places: Vec<Place>,
}

impl Output {
    /// Layer, column and row of an entry.
    pub fn index(&self, entry: usize) -> [usize; 3] {
        let [rows, columns] = self.shape;
        [entry / (rows * columns), entry / rows % columns, entry % rows]
    }

    /// The name of an entry: row and column where there are several.
    pub fn entry_name(&self, entry: usize) -> String {
        let ([layer, column, row], [_, columns]) = (self.index(entry), self.shape);
        let name = if self.layers > 1 { format!("{}_{}", self.name, ["x", "y", "z"][layer]) } else { self.name.into() };
        if columns > 1 { format!("{name}_{row}_{column}") } else { format!("{name}_{row}") }
    }
}

/// The name of a place: a component of a quantity of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// The pass that computes it.
    pub pass: Pass,
    /// Name of the quantity.
    pub symbol: &'static str,
    /// The body it belongs to.
    pub body: Option<usize>,
    /// Name of the component.
    pub component: &'static str,
    /// Whether the place is the component with the other sign.
    pub minus: bool,
}

/// The ten numbers of a payload.
const PAYLOAD: (&str, &str, &str) = (
    "payload",
    "mass, centre of mass (x, y, z), rotational inertia about it (xx, xy, xz, yy, yz, zz), in the link's frame",
    "kg, m, kg·m²",
);

impl Program {
    /// Records and simplifies what `options` ask of `model`, whose held coordinates are already held: over vectors where the form is
    /// hybrid, else number by number.
    pub fn new(model: &Model, options: &Options) -> Result<Self, GenerateError> {
        Self::of(&quantities(model, options)?, model, options)
    }

    /// [`new`](Self::new) for some of the quantities.
    pub(crate) fn of(quantities: &[Quantity], model: &Model, options: &Options) -> Result<Self, GenerateError> {
        let mut program = Self {
            graph: Graph::new(options.precision),
            inputs: Vec::new(),
            functions: Vec::new(),
            sweeps: HashMap::new(),
        };
        if options.payload.is_some() {
            program.input(PAYLOAD, 10);
        }
        for &quantity in quantities {
            program.function(model, options, quantity)?;
        }
        Ok(program)
    }

    fn function(&mut self, model: &Model, options: &Options, quantity: Quantity) -> Result<(), GenerateError> {
        match options.form {
            Form::Hybrid => self.function_over::<Grouped>(model, options, quantity),
            _ => self.function_over::<Recorded>(model, options, quantity),
        }
    }

    fn function_over<T: Recording>(
        &mut self,
        model: &Model,
        options: &Options,
        quantity: Quantity,
    ) -> Result<(), GenerateError> {
        let n = model.dof();
        let mut numbers = Vec::new();
        let arguments: Vec<(Argument, Option<Input>)> = quantity
            .inputs()
            .map(|argument| {
                let input = (!options.vanishes(argument.name)).then(|| {
                    let what = (argument.name, argument.meaning, argument.unit);
                    let number = self.input(what, argument.len(n));
                    numbers.push(number);
                    self.inputs[number]
                });
                (argument, input)
            })
            .collect();
        let payload = options.payload.as_deref().map(|link| (link, self.inputs[0]));
        let ((outputs, labels), tape) = record(|| evaluate::<T>(model, payload, quantity, &arguments));
        let map = self.graph.absorb(&tape);
        if self
            .graph
            .operations()
            .iter()
            .any(|operation| matches!(operation, Operation::Constant(bits) if !f64::from_bits(*bits).is_finite()))
        {
            return Err(GenerateError::TooLarge { element: options.precision.name() });
        }

        let mut function = Function { quantity, inputs: numbers, outputs: Vec::new(), scratch: HashMap::new() };
        if payload.is_some() {
            function.inputs.insert(0, 0);
        }
        for (argument, values) in quantity.outputs().zip(outputs?) {
            let places = values.iter().map(|value| map[value.place() as usize]).collect();
            function.outputs.push(output(argument, n, places, options));
        }
        for label in labels {
            let names = if label.pass == Pass::Question { &mut function.scratch } else { &mut self.sweeps };
            for (component, value) in label.components.iter().zip(&label.values) {
                let place = map[value.place() as usize];
                let (place, minus) = match self.graph.operation(place) {
                    Operation::Input(_) | Operation::Constant(_) => continue,
                    Operation::Neg(a) => (a, true),
                    _ => (place, false),
                };
                // A vector is called after the first of its lanes that has a name.
                let place = match self.graph.operation(place) {
                    Operation::Lane(vector, _) => vector,
                    _ => place,
                };
                let Label { pass, symbol, body, .. } = label;
                let named = Named { pass, symbol, body, component, minus };
                let known = names.entry(place).or_insert(named);
                if known.minus && !minus && known.pass >= pass {
                    *known = named;
                }
            }
        }
        self.functions.push(function);
        Ok(())
    }

    /// The number of an input array, which is new or known.
    fn input(&mut self, (name, meaning, unit): (&'static str, &'static str, &'static str), len: usize) -> usize {
        self.inputs.iter().position(|input| input.name == name).unwrap_or_else(|| {
            let start = self.inputs.last().map_or(0, |last| last.start + last.len as u32);
            self.inputs.push(Input { name, meaning, unit, start, len });
            self.inputs.len() - 1
        })
    }

    /// The array and the index of input number `number`.
    pub fn input_of(&self, number: u32) -> (usize, usize) {
        let array = self.inputs.partition_point(|input| input.start <= number) - 1;
        (array, (number - self.inputs[array].start) as usize)
    }
}

/// The quantities to generate, in the order of [`Quantity::ALL`], then links.
pub(crate) fn quantities(model: &Model, options: &Options) -> Result<Vec<Quantity>, GenerateError> {
    if let Some(asked) = &options.outputs {
        for quantity in asked {
            let excluded = |reason| GenerateError::Excluded { output: quantity.name(), reason };
            options.leaves(*quantity).map_err(excluded)?;
        }
    }
    let mut quantities: Vec<_> = Quantity::ALL.into_iter().filter(|&quantity| options.asks(quantity)).collect();
    if options.asks(Quantity::Kinematics(0)) {
        for link in links(model, options)? {
            // A link asked for twice is one function.
            if !quantities.contains(&Quantity::Kinematics(link)) {
                quantities.push(Quantity::Kinematics(link));
            }
        }
    }
    Ok(quantities)
}

/// The links whose kinematics is generated.
fn links(model: &Model, options: &Options) -> Result<Vec<usize>, GenerateError> {
    let number = |name: &String| {
        model.link(name).ok_or_else(|| GenerateError::UnknownLink {
            link: name.clone(),
            known: model.links().iter().map(|link| link.name.as_str()).collect::<Vec<_>>().join(", "),
        })
    };
    match &options.links {
        Some(names) => names.iter().map(number).collect(),
        // The last link of each body at the end of a chain: tools stand there.
        None => Ok(model
            .bodies()
            .iter()
            .enumerate()
            .filter(|(k, body)| body.end == k + 1)
            .filter_map(|(k, _)| model.links().iter().rposition(|link| link.body == k))
            .collect()),
    }
}

type Outputs<T> = Result<Vec<Vec<T>>, GenerateError>;

/// Runs the core over recorded numbers.
fn evaluate<T: Recording>(
    model: &Model,
    payload: Option<(&str, Input)>,
    quantity: Quantity,
    arguments: &[(Argument, Option<Input>)],
) -> (Outputs<T>, Vec<Label<T>>) {
    let n = model.dof();
    let entries = |input: Input| (input.start..).take(input.len).map(T::input).collect::<Vec<_>>();
    let mut model = model.map(T::from_f64);
    if let Some((link, input)) = payload {
        let numbers = entries(input);
        let inertial = frs_core::model::Inertial {
            mass: numbers[0],
            com: Vector3::new(numbers[1], numbers[2], numbers[3]),
            inertia: Symmetric3 {
                xx: numbers[4],
                xy: numbers[5],
                xz: numbers[6],
                yy: numbers[7],
                yz: numbers[8],
                zz: numbers[9],
            },
        };
        model = match model.with_inertial(link, inertial) {
            Ok(model) => model,
            Err(error) => return (Err(error.into()), Vec::new()),
        };
    }
    let inputs: Vec<Vec<T>> = arguments
        .iter()
        .map(|(argument, input)| input.map_or_else(|| vec![T::zero(); argument.len(n)], entries))
        .collect();
    let inputs: Vec<&[T]> = inputs.iter().map(Vec::as_slice).collect();
    let mut outputs: Vec<Vec<T>> = quantity.outputs().map(|argument| vec![T::zero(); argument.len(n)]).collect();
    let mut slices: Vec<&mut [T]> = outputs.iter_mut().map(Vec::as_mut_slice).collect();
    let mut evaluator = Evaluator::new(&model);
    evaluator.answer(quantity, &inputs, &mut slices);
    (Ok(outputs), evaluator.workspace().labels())
}

/// An output, cut to what the options leave of it.
fn output(argument: Argument, n: usize, mut places: Vec<Place>, options: &Options) -> Output {
    let mut output = Output {
        name: argument.name,
        symbol: argument.symbol,
        meaning: argument.meaning,
        unit: argument.unit,
        shape: argument.shape(n),
        layers: argument.layers(),
        places: Vec::new(),
    };
    if argument.name == "xi_dot" && options.momentum != Momentum::Driven {
        // The momentum is known otherwise: what is left of ξ̇ is q̈.
        places.drain(..6);
        output = Output { name: "qdd", symbol: "q̈", meaning: "shape acceleration", shape: [n, 1], ..output };
    }
    Output { places, ..output }
}
