//! How long something takes.

use std::time::{Duration, Instant};

/// Long enough for the clock to resolve.
const SAMPLE: Duration = Duration::from_millis(2);

/// Samples of which the median is taken.
const SAMPLES: usize = 11;

/// Median of the nanoseconds that `run` takes.
pub fn nanoseconds(mut run: impl FnMut()) -> f64 {
    let mut sample = |repeats: u32| {
        let start = Instant::now();
        (0..repeats).for_each(|_| run());
        start.elapsed()
    };
    sample(1);
    let once = sample(1).max(Duration::from_nanos(1));
    let repeats = (SAMPLE.as_nanos() / once.as_nanos()).clamp(1, 1_000_000) as u32;
    let mut samples: Vec<Duration> = (0..SAMPLES).map(|_| sample(repeats)).collect();
    samples.sort_unstable();
    samples[SAMPLES / 2].as_nanos() as f64 / f64::from(repeats)
}
