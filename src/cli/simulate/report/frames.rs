//! Which samples a page shows, and with how many digits.

/// Frames a second and in all at most: what a screen shows, and what a browser takes in at once.
const FRAMES_PER_SECOND: f64 = 60.0;
const FRAMES: usize = 3000;

/// Numbers in all at most, so that the page of a robot with a hundred joints stays at a few megabytes.
const NUMBERS: usize = 400_000;

/// Significant digits of a number in the page.
const DIGITS: usize = 5;

/// Which of these times become frames of so many numbers each; the first and the last always do.
pub fn thinned(times: &[f64], numbers: usize) -> Vec<usize> {
    /// Of the gap, the share by which a sample may come early: rounding.
    const EARLY: f64 = 1e-9;
    let most = FRAMES.min(NUMBERS / numbers).max(2);
    let duration = times.last().copied().unwrap_or(0.0);
    let gap = (1.0 / FRAMES_PER_SECOND).max(duration / (most - 1) as f64) * (1.0 - EARLY);
    let mut shown: Vec<usize> = Vec::new();
    for (i, time) in times.iter().enumerate() {
        if shown.last().is_none_or(|last| time - times[*last] >= gap) {
            shown.push(i);
        }
    }
    if shown.last().is_some_and(|last| last + 1 < times.len()) {
        if shown.len() > 1 {
            shown.pop();
        }
        shown.push(times.len() - 1);
    }
    shown
}

/// The number in as many digits as the page shows; `None` if it is none.
pub fn rounded(number: f64) -> Option<f64> {
    format!("{number:.0$e}", DIGITS - 1).parse().ok().filter(|number: &f64| number.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_are_few_and_hold_the_first_and_the_last_sample() {
        for (samples, rate, numbers) in
            [(1, 100.0, 50), (2, 1e4, 50), (801, 200.0, 90), (60_001, 500.0, 60), (5000, 50.0, 4000)]
        {
            let times: Vec<f64> = (0..samples).map(|i| f64::from(i) / rate).collect();
            let shown = thinned(&times, numbers);
            assert_eq!((shown.first(), shown.last()), (Some(&0), Some(&(times.len() - 1))));
            assert!(shown.len() <= FRAMES && shown.len() * numbers <= NUMBERS, "{samples}: {}", shown.len());
            let gap = |pair: &[usize]| times[pair[1]] - times[pair[0]];
            let close = shown.windows(2).filter(|pair| gap(pair) < 0.999 / FRAMES_PER_SECOND).count();
            assert!(close == 0 || shown.len() == 2, "{samples}: {close}");
        }
    }
}
