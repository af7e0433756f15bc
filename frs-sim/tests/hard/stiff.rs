//! Stiffness and damping of 10⁸: an implicit step a thousand times as long as what an explicit one bears.

use frs_core::Workspace;
use nalgebra::DMatrix;

use super::{robot, scene};
use frs_sim::integrate::IntegrationError;
use frs_sim::run::{End, Record, run};
use std::ops::ControlFlow;

/// N·m/rad, and N·m·s/rad.
const STIFF: f64 = 1e8;

/// |hλ| up to which RKMK4 is stable, on the imaginary axis and on the real one (Hairer and Wanner, Solving ODEs II, IV.2).
const SWINGING: f64 = 2.828;
const CREEPING: f64 = 2.785;

const STEPS: f64 = 300.0;

/// The largest eigenvalue of Λ_q⁻¹ at rest, 1/(kg·m²).
fn lightest() -> f64 {
    let model = robot("planar_three_link");
    let mut inertia = DMatrix::zeros(2, 2);
    Workspace::new(&model).shape(&[0.0; 2]).shape_inertia(&mut inertia);
    1.0 / inertia.symmetric_eigenvalues().min()
}

/// A milliradian to one side, where Λ_q is the same to as much.
fn moved(method: &str, step: f64, force: &str, side: f64) -> Record {
    let model = robot("planar_three_link");
    let text = format!(
        "robot = 'planar_three_link.urdf'\nduration = {:e}\nsamples_per_second = {:e}\n[start]\nq = [{:e}, {:e}]\nqd = [1e-3, 0]\n[solver]\nmethod = '{method}'\nstep = {step:e}\n{force}",
        STEPS * step,
        1.0 / step,
        1e-3 * side.cos(),
        1e-3 * side.sin()
    );
    run(&scene(&text, &model), &model, |_| ControlFlow::Continue(()))
}

/// Kinetic and elastic energy, J, the largest of the motion over that at its start; infinite if the motion broke off.
fn growth(record: &Record, stiffness: f64) -> f64 {
    let energy = record
        .samples
        .iter()
        .map(|sample| sample.kinetic_energy + 0.5 * stiffness * sample.q.iter().map(|q| q * q).sum::<f64>());
    let energies: Vec<f64> = energy.collect();
    if record.end != End::Whole {
        assert!(matches!(record.end, End::Failed(IntegrationError::NotFinite { .. })), "{:?}", record.end);
        return f64::INFINITY;
    }
    energies.iter().fold(0.0, |most: f64, x| most.max(*x)) / energies[0]
}

#[test]
fn stiff_springs_bear_implicit_steps_a_thousand_times_the_explicit_limit() {
    let limit = SWINGING / (STIFF * lightest()).sqrt();
    let spring = format!("[spring]\nstiffness = {STIFF:e}\n");
    let [stable, beyond] = [0.9, 1.2].map(|share| growth(&moved("rkmk4", share * limit, &spring, 0.0), STIFF));
    let implicit = (0..16).map(|k| growth(&moved("implicit_midpoint", 1e3 * limit, &spring, f64::from(k)), STIFF));
    let implicit = implicit.fold(0.0, f64::max);
    println!(
        "springs, limit {limit:.1e} s: rkmk4 {stable:.3} below it and {beyond:.1e} above; implicit midpoint at 1000 × {implicit:.3}"
    );
    assert!(stable <= 1.0 + 1e-3 && beyond > 1e6);
    // Λ_q changes by some 1e-3 of itself within these angles, and with it what is kept.
    assert!(implicit <= 1.0 + 1e-2, "{implicit}");
}

#[test]
fn stiff_dampers_bear_implicit_steps_a_thousand_times_the_explicit_limit() {
    let limit = CREEPING / (STIFF * lightest());
    let damper = format!("[friction]\nviscous = {STIFF:e}\n");
    let [stable, beyond] = [0.9, 1.2].map(|share| growth(&moved("rkmk4", share * limit, &damper, 0.0), 0.0));
    let record = moved("implicit_midpoint", 1e3 * limit, &damper, 0.0);
    let implicit = growth(&record, 0.0);
    println!(
        "dampers, limit {limit:.1e} s: rkmk4 {stable:.3} below it and {beyond:.1e} above; implicit midpoint at 1000 × {implicit:.3}"
    );
    assert!(stable <= 1.0 + 1e-12 && beyond > 1e6);
    assert!(implicit <= 1.0 + 1e-9, "{implicit}");
    // Of a fast decay the midpoint rule keeps (1 − hλ/2)/(1 + hλ/2) a step, nearly all: it is stable, and does not damp what it cannot resolve.
    let last = record.samples.last().expect("samples are there");
    assert!(last.kinetic_energy < 0.5 * record.samples[0].kinetic_energy, "{}", last.kinetic_energy);
}
