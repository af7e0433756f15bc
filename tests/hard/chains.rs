//! Chains of 10 to 200 links.
//!
//! Errors grow with the walk from the base, which is a random walk of rounding, and with the lever arms about the total centre of
//! mass. A coiled or random chain is about as wide as the root of its number of links: there they grow no more than linearly. The
//! last link of a straight chain is n/2 links away, and its own inertia of 1/3 is the difference of terms n²/4: there the bound is quadratic.

use crate::judge::{Judged, judge_all};
use crate::robots::chain;
use crate::state::State;

const LENGTHS: [usize; 4] = [10, 50, 100, 200];

/// What a chain that does not stretch out may lose, in units of ε times its number of links: `roundings(n) · lever / n`, with a
/// lever ratio of at most 1.5 n.
const PER_LINK: f64 = 5.0;

/// What the straight chain may lose, in units of ε times the square of its number of links: a lever ratio of `(n/2)²/(1/3)`.
const PER_LINK_SQUARED: f64 = 1.5;

fn judged(name: &str, shape: impl Fn(usize) -> Vec<f64>) -> Vec<(f64, Judged)> {
    let judge = |n| judge_all(&format!("{name}, {n} links"), &chain(n), [State::random(1).with("q", shape(n))]);
    LENGTHS.map(|n| (n as f64, judge(n))).into()
}

#[test]
fn errors_of_a_coiled_chain_grow_at_most_linearly() {
    for (n, worst) in judged("coiled", |n| (0..n).map(|k| if k % 2 == 0 { 0.9 } else { 0.05 }).collect()) {
        assert!(worst.worst() <= PER_LINK * n, "{n} links: {worst}");
    }
}

#[test]
fn errors_of_a_random_chain_grow_at_most_linearly() {
    for (n, worst) in judged("random", |n| State::random(7).numbers("q", n).iter().map(|x| 3.0 * x).collect()) {
        assert!(worst.worst() <= PER_LINK * n, "{n} links: {worst}");
    }
}

#[test]
fn errors_of_a_straight_chain_grow_at_most_with_the_square() {
    for (n, worst) in judged("straight", |n| vec![0.0; n]) {
        assert!(worst.worst() <= PER_LINK_SQUARED * n * n, "{n} links: {worst}");
    }
}
