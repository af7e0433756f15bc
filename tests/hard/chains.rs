//! Chains of 10 to 200 links.
//!
//! Errors grow with the walk from the base, which is a random walk of rounding, and with the lever arms about the total centre of
//! mass. Relative to the largest entry of Λ_q they grow as the root of the number of links. Relative to its own joints, an entry has
//! the lever arms of its links, too. A coiled or random chain is about as wide as the root of its number of links: there they grow no
//! more than linearly. The last link of a straight chain is n/2 links away, and its own inertia of 1/3 is the difference of terms n²/4:
//! there the growth is quadratic.

use frs::conditioning::roundings;

use crate::judge::{Judged, judge_all};
use crate::robots::chain;
use crate::state::State;

const LENGTHS: [usize; 4] = [10, 50, 100, 200];

/// The lever ratio of the last link of a chain that does not stretch out, per link: it is n/3 bars² from the centre of mass in the
/// mean, and its own inertia is 1/3.
const COILED: f64 = 1.0;

/// The same of a straight chain, per link squared: `(n/2)²/(1/3)`.
const STRAIGHT: f64 = 0.75;

fn judged(name: &str, shape: impl Fn(usize) -> Vec<f64>) -> Vec<(f64, Judged)> {
    let judge = |n| {
        let judged = judge_all(&format!("{name}, {n} links"), &chain(n), [State::random(1).with("q", shape(n))]);
        assert!(judged.of_largest <= roundings(n), "{name}, {n} links: {judged}");
        assert!(judged.leverless <= roundings(n), "{name}, {n} links: {judged}");
        (n as f64, judged)
    };
    LENGTHS.map(judge).into()
}

#[test]
fn errors_of_a_coiled_chain_grow_at_most_linearly() {
    for (n, worst) in judged("coiled", |n| (0..n).map(|k| if k % 2 == 0 { 0.9 } else { 0.05 }).collect()) {
        assert!(worst.worst() <= roundings(0) * COILED * n, "{n} links: {worst}");
    }
}

#[test]
fn errors_of_a_random_chain_grow_at_most_linearly() {
    for (n, worst) in judged("random", |n| State::random(7).numbers("q", n).iter().map(|x| 3.0 * x).collect()) {
        assert!(worst.worst() <= roundings(0) * COILED * n, "{n} links: {worst}");
    }
}

#[test]
fn errors_of_a_straight_chain_grow_at_most_with_the_square() {
    for (n, worst) in judged("straight", |n| vec![0.0; n]) {
        assert!(worst.worst() <= roundings(0) * STRAIGHT * n * n, "{n} links: {worst}");
    }
}
