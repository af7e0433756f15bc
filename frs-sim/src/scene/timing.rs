//! When inputs act: always, for a while, or as a table says.

use std::ops::Range;

use super::reader::{Item, Table};
use crate::signal::Signal;

/// When the values of an input hold.
pub enum Timing {
    /// Constant within, 0 elsewhere.
    During(Range<f64>),
    /// A value for each time, straight in between.
    Points(Vec<f64>),
}

/// `start` and `end`, or `times`.
pub fn read(table: &Table<'_, '_>, duration: f64) -> Option<Timing> {
    if let Some(item) = table.get("times") {
        for key in ["start", "end"] {
            if let Some(other) = table.get(key) {
                return other.refuse(format!("times is given, too; expected times or {key}"));
            }
        }
        return item.times().map(Timing::Points);
    }
    let time = |key: &str, otherwise: f64| table.get(key).map_or(Some(otherwise), |item| item.number());
    let (start, end) = (time("start", f64::NEG_INFINITY)?, time("end", f64::INFINITY)?);
    if start < end && end > 0.0 && start < duration {
        return Some(Timing::During(start..end));
    }
    let span = format!("it acts from {} s to {end} s", start.max(0.0));
    table.refuse(format!("{span}; expected a start before the end, within the motion's {duration} s"));
    None
}

impl Timing {
    /// The columns of an item as functions of time: of one row while it holds, or of a row for each time.
    pub fn signals(&self, item: &Item<'_, '_>, row: impl Fn(&Item<'_, '_>) -> Option<Vec<f64>>) -> Option<Vec<Signal>> {
        self.columns(item, row, Signal::linear)
    }

    /// The same with another way from point to point.
    pub fn columns(
        &self,
        item: &Item<'_, '_>,
        row: impl Fn(&Item<'_, '_>) -> Option<Vec<f64>>,
        through: impl Fn(&[f64], &[f64]) -> Signal,
    ) -> Option<Vec<Signal>> {
        let times = match self {
            Self::During(during) => {
                return Some(row(item)?.into_iter().map(|value| Signal::pulse(value, during)).collect());
            }
            Self::Points(times) => times,
        };
        let items = item.items("a list with a value for each time")?;
        if items.len() != times.len() {
            return item.refuse(format!("found {} values; expected {}, one for each time", items.len(), times.len()));
        }
        let rows: Option<Vec<Vec<f64>>> = items.iter().map(&row).collect::<Vec<_>>().into_iter().collect();
        let rows = rows?;
        let column = |i: usize| rows.iter().map(|row| row[i]).collect::<Vec<_>>();
        Some((0..rows[0].len()).map(|i| through(times, &column(i))).collect())
    }
}
