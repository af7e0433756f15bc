//! The two joints of a map: which they are, where the others are held, how far they go.

use std::f64::consts::PI;

use frs::Model;
use frs::model::{Coordinate, Motion};
use frs_gait::ShapePlane;

use crate::cli::Failure;
use crate::cli::state::State;

/// The plane of a map and the names of its axes.
pub struct Axes<'m> {
    pub plane: ShapePlane,
    coordinates: [&'m Coordinate; 2],
    /// Whether they are angles.
    angles: [bool; 2],
}

impl<'m> Axes<'m> {
    /// Finds the joints by name; `at` holds the others, as the `q` of a state.
    pub fn new(model: &'m Model, joints: &[String], at: Option<&str>) -> Result<Self, Failure> {
        let [a, b] = joints else {
            return Err(Failure::Input(format!(
                "--joints: found {} names; expected two, separated by a comma",
                joints.len()
            )));
        };
        let found = [number(model, a)?, number(model, b)?];
        if found[0] == found[1] {
            return Err(Failure::Input(format!("--joints {a},{b}: both are the same; expected two different joints")));
        }
        let q0 = match at {
            None => vec![0.0; model.dof()],
            Some(q) => {
                State::parse(&format!("{{\"q\":{q}}}"), model)
                    .map_err(|told| {
                        // The place is one in our own line, which the user does not see.
                        let fact = told.split_once(": ").map_or(told.as_str(), |(_, fact)| fact);
                        Failure::Input(format!("--at '{q}': {fact}; write '[0.1, 0.2]' or '{{\"{a}\": 0.1}}'"))
                    })?
                    .q
            }
        };
        let coordinates = found.map(|index| &model.coordinates()[index]);
        let angles = coordinates.map(|coordinate| model.bodies()[coordinate.body].motion == Motion::Revolute);
        Ok(Self { plane: ShapePlane::new(q0, found), coordinates, angles })
    }

    /// Names of the two joints.
    pub fn names(&self) -> [&'m str; 2] {
        self.coordinates.map(|coordinate| coordinate.name.as_str())
    }

    /// Names with units, as axes are labelled.
    pub fn labels(&self) -> [String; 2] {
        let [a, b] = self.names();
        let [unit_a, unit_b] = self.units();
        [format!("{a} / {unit_a}"), format!("{b} / {unit_b}")]
    }

    fn units(&self) -> [&'static str; 2] {
        self.angles.map(|angle| if angle { "rad" } else { "m" })
    }

    /// Unit of the perimeter of a loop.
    pub fn length_unit(&self) -> &'static str {
        match self.units() {
            [a, b] if a == b => a,
            _ => "rad and m",
        }
    }

    /// Unit of a component of the curvature.
    pub fn unit(&self, length: bool) -> String {
        let over = match self.units() {
            [a, b] if a == b => format!("{a}²"),
            [a, b] => format!("({a} {b})"),
        };
        format!("{}/{over}", if length { "m" } else { "rad" })
    }

    /// The joints' limits, or ±π rad and ±1 m where there are none.
    pub fn limits(&self) -> [[f64; 2]; 2] {
        std::array::from_fn(|axis| {
            let coordinate = self.coordinates[axis];
            let reach = if self.angles[axis] { PI } else { 1.0 };
            match (coordinate.limits.lower, coordinate.limits.upper) {
                (Some(lower), Some(upper))
                    if !coordinate.continuous && lower < upper && (upper - lower).is_finite() =>
                {
                    [lower, upper]
                }
                _ => [-reach, reach],
            }
        })
    }

    /// Reads `A0:A1,B0:B1`.
    pub fn window(&self, text: &str) -> Result<[[f64; 2]; 2], Failure> {
        let range = |text: &str| {
            let (low, high) = text.split_once(':')?;
            let (low, high) = (super::gait::number(low)?, super::gait::number(high)?);
            (low < high).then_some([low, high])
        };
        text.split_once(',').and_then(|(a, b)| Some([range(a)?, range(b)?])).ok_or_else(|| {
            Failure::Input(format!(
                "--window '{text}': expected A0:A1,B0:B1, the lowest and highest value of both joints; write for example \
                 --window=-1.5:1.5,0:2"
            ))
        })
    }
}

fn number(model: &Model, name: &str) -> Result<usize, Failure> {
    let names = || model.coordinates().iter().map(|coordinate| coordinate.name.as_str());
    names().position(|known| known == name).ok_or_else(|| {
        let nearest = names().min_by_key(|known| strsim::damerau_levenshtein(name, known));
        let hint = nearest.map_or("the robot has none".into(), |nearest| format!("did you mean '{nearest}'?"));
        let known = names().collect::<Vec<_>>().join(", ");
        Failure::Input(format!("--joints: no coordinate is called '{name}'; expected one of {known}; {hint}"))
    })
}
