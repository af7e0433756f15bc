//! `[observer]`: who observes the locked velocity.

use frs_core::spatial::Twist;

use super::reader::Table;
use crate::observer::Observer;

/// `Some(None)` if there is none.
pub fn read(root: &Table<'_, '_>) -> Option<Option<Observer>> {
    let Some(item) = root.get("observer") else { return Some(None) };
    let table = item.table()?;
    table.only(&["gain", "guess"]);
    let gain = table.required("gain", "how fast the error falls, 1/s").and_then(|item| item.positive());
    let what = "six numbers, the locked velocity that it begins with, angular part first";
    let guess = table.get("guess").map_or(Some([0.0; 6]), |item| item.numbers(what));
    Some(Some(Observer { gain: gain?, guess: Twist::from_array(guess?) }))
}
