//! What pictures share: round numbers along axes, and words.

use std::fmt::Write;

/// 1, 2 or 5 times a power of ten, at least `least`.
pub fn round_step(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= least * 0.999).unwrap_or(least)
}

/// Round values within a range, with their labels.
pub fn ticks([low, high]: [f64; 2]) -> Vec<(f64, String)> {
    let step = round_step((high - low) / 7.0);
    let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
    (first..=last).map(|k| k as f64 * step).map(|value| (value, number(value, step))).collect()
}

/// A multiple of a step, with no digit that the step has not; with a true minus sign.
pub fn number(value: f64, step: f64) -> String {
    let text = match step {
        _ if value == 0.0 => "0".into(),
        step if !(1e-4..1e5).contains(&step) => {
            let digits = (value.abs() * (1.0 + f64::EPSILON)).log10().floor() - step.log10().floor();
            format!("{value:.0$e}", digits.max(0.0) as usize)
        }
        step => format!("{value:.0$}", (-step.log10().floor()).max(0.0) as usize),
    };
    text.replace('-', "−")
}

/// Words at a point; `anchor` is which end of them is there.
pub fn text(out: &mut String, [x, y]: [f64; 2], anchor: &str, words: &str) {
    let _ = writeln!(out, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{}</text>", escaped(words));
}

/// Text as XML takes it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_neighbouring_ticks_differ_at_every_size() {
        for size in [1e-15, 3e-12, 1e-5, 0.02, 1.0, 700.0, 2e8] {
            let labels: Vec<String> = ticks([-1.3 * size, 1.7 * size]).into_iter().map(|(_, label)| label).collect();
            let mut told = labels.clone();
            told.dedup();
            assert!(labels.len() >= 4 && told == labels, "{labels:?}");
        }
    }
}
