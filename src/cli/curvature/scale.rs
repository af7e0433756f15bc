//! A field's values as colours.

use frs::nalgebra::DMatrix;

use crate::cli::svg::{number, round_step};

/// Borders on the way from 0 to the largest value, about.
const BANDS: f64 = 10.0;

/// Blue, white, red: equally dark at both ends.
const COLOURS: [[f64; 3]; 5] =
    [[31.0, 73.0, 138.0], [124.0, 170.0, 214.0], [248.0, 248.0, 246.0], [232.0, 152.0, 126.0], [158.0, 30.0, 42.0]];

/// The largest finite magnitude.
pub fn largest(values: &DMatrix<f64>) -> f64 {
    values.iter().copied().filter(|value| value.is_finite()).map(f64::abs).fold(0.0, f64::max)
}

/// Values as colours: 2·count bands of a round width, symmetric about 0.
pub struct Scale {
    pub step: f64,
    pub count: i32,
}

impl Scale {
    /// The scale of a field.
    pub fn of(values: &DMatrix<f64>, vanishes: bool) -> Self {
        let largest = largest(values);
        if vanishes || largest == 0.0 {
            return Self { step: 1.0, count: 0 };
        }
        let step = round_step(largest / BANDS);
        Self { step, count: ((largest / step).ceil() as i32).max(1) }
    }

    /// The colour of the band above a border.
    pub fn colour(&self, border: i32) -> String {
        let share = if self.count == 0 { 0.0 } else { (f64::from(border) + 0.5) / f64::from(self.count) };
        let place = (share.clamp(-1.0, 1.0) + 1.0) * 0.5 * (COLOURS.len() - 1) as f64;
        let below = (place as usize).min(COLOURS.len() - 2);
        let part = place - below as f64;
        let [r, g, b] =
            std::array::from_fn(|c| (COLOURS[below][c] * (1.0 - part) + COLOURS[below + 1][c] * part).round() as u8);
        format!("#{r:02x}{g:02x}{b:02x}")
    }

    /// The value of a border, in words.
    pub fn label(&self, border: i32) -> String {
        number(f64::from(border) * self.step, self.step)
    }
}
