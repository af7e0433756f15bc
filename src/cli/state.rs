//! States as JSON lines: `{"q":[…]|{name:value}, "qd":…, "mu":[6] or "base_twist":[6], "base_wrench":[6], "tau":…}`.

use std::collections::BTreeMap;

use frs::spatial::{Twist, Wrench};
use frs::{Model, Real};
use serde::Deserialize;

/// What a robot does at one moment, and what pushes it.
pub struct State<T: Real = f64> {
    pub q: Vec<T>,
    pub qd: Vec<T>,
    pub base: BaseMotion<T>,
    pub base_wrench: Wrench<T>,
    pub tau: Vec<T>,
}

/// The base's motion, given either way.
#[derive(Clone, Copy)]
pub enum BaseMotion<T: Real = f64> {
    /// The locked velocity μ.
    Locked(Twist<T>),
    /// The base's body twist V₁.
    Base(Twist<T>),
}

impl State {
    /// Everything at rest at q = 0.
    pub fn zero(model: &Model) -> Self {
        let zeros = vec![0.0; model.dof()];
        Self {
            q: zeros.clone(),
            qd: zeros.clone(),
            base: BaseMotion::Locked(Twist::zero()),
            base_wrench: Wrench::zero(),
            tau: zeros,
        }
    }

    /// Reads one line; the message names the field and says what was expected.
    pub fn parse(line: &str, model: &Model) -> Result<Self, String> {
        let line: StateLine = serde_json::from_str(line).map_err(|error| {
            let at = error.column();
            let text = error.to_string();
            let fact = text.split(" at line ").next().unwrap_or(&text);
            format!("{at}: {fact}")
        })?;
        let numbers = |field: &str, values: Option<Values>| {
            values.map_or_else(|| Ok(vec![0.0; model.dof()]), |values| values.resolve(field, model))
        };
        let six = |field: &str, values: Option<Vec<f64>>| match values {
            None => Ok([0.0; 6]),
            Some(values) => <[f64; 6]>::try_from(values).map_err(|values| {
                format!("1: {field}: found {} numbers; expected 6, angular part first", values.len())
            }),
        };
        let base = match (line.mu, line.base_twist) {
            (Some(_), Some(_)) => {
                return Err("1: both mu and base_twist are given; expected one of them (mu = V₁ + A_l q̇)".into());
            }
            (None, Some(twist)) => BaseMotion::Base(Twist::from_array(six("base_twist", Some(twist))?)),
            (mu, None) => BaseMotion::Locked(Twist::from_array(six("mu", mu)?)),
        };
        Ok(Self {
            q: numbers("q", line.q)?,
            qd: numbers("qd", line.qd)?,
            base,
            base_wrench: Wrench::from_array(six("base_wrench", line.base_wrench)?),
            tau: numbers("tau", line.tau)?,
        })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StateLine {
    q: Option<Values>,
    qd: Option<Values>,
    mu: Option<Vec<f64>>,
    base_twist: Option<Vec<f64>>,
    base_wrench: Option<Vec<f64>>,
    tau: Option<Values>,
}

#[derive(Deserialize)]
#[serde(untagged, expecting = "expected a list of numbers or an object of joint names and numbers")]
enum Values {
    List(Vec<f64>),
    Named(BTreeMap<String, f64>),
}

impl Values {
    /// One number per coordinate; coordinates not named are 0.
    fn resolve(self, field: &str, model: &Model) -> Result<Vec<f64>, String> {
        let names = || model.coordinates().iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(", ");
        match self {
            Self::List(values) if values.len() == model.dof() => Ok(values),
            Self::List(values) => Err(format!(
                "1: {field}: found {} numbers; expected {}, one per coordinate: {}",
                values.len(),
                model.dof(),
                names()
            )),
            Self::Named(values) => {
                let mut resolved = vec![0.0; model.dof()];
                for (name, value) in values {
                    let index = model.coordinates().iter().position(|c| c.name == name).ok_or_else(|| {
                        format!("1: {field}: no coordinate is called '{name}'; the coordinates are: {}", names())
                    })?;
                    resolved[index] = value;
                }
                Ok(resolved)
            }
        }
    }
}
