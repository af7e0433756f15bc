//! What the paper says of its example, as far as it holds: docs/scenes.md has the numbers.

use std::ops::ControlFlow;

use frs_core::{Evaluator, FloatingBase, Model, Quantity, Workspace, urdf};
use frs_sim::effects::{Decoupling, Gains, Regulator};
use frs_sim::run::{End, Sample, run};
use frs_sim::scene::{Force, Scene};
use nalgebra::{DMatrix, DVector};

/// The blow of the scenes, s.
const BLOW: [f64; 2] = [0.51, 0.55];

/// Rounding of a torque, relative to the terms that it is made of.
const ROUNDING: f64 = 1e-12;

fn model() -> Model {
    Model::from_urdf(urdf::LWR_SATELLITE).unwrap()
}

fn scene(name: &str, model: &Model) -> Scene {
    let path = format!("{}/../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    Scene::parse(name, &std::fs::read_to_string(path).unwrap(), model).unwrap()
}

fn gains(scene: &Scene) -> Gains {
    let mut regulators = scene.forces.iter().filter_map(|named| match &named.force {
        Force::Regulator(gains) => Some(gains.clone()),
        _ => None,
    });
    regulators.next_back().unwrap()
}

/// Both scenes: their gains, and what happens.
fn both(model: &Model) -> [(Gains, Vec<Sample>); 2] {
    ["paper", "paper_tau_bar"].map(|name| {
        let scene = scene(name, model);
        let record = run(&scene, model, |_| ControlFlow::Continue(()));
        assert_eq!(record.end, End::Whole);
        assert_eq!(record.samples.len(), 801);
        (gains(&scene), record.samples)
    })
}

/// The decoupling torque of a regulator at the state of a sample, but with the shape velocity `qd`.
fn decoupling(model: &Model, gains: &Gains, decoupling: Decoupling, sample: &Sample, qd: &[f64]) -> DVector<f64> {
    let gains = Gains { decoupling, ..gains.clone() };
    let mut work = Workspace::new(model);
    let mut shape = work.shape(&sample.q);
    DVector::from_column_slice(Regulator::new(gains).decoupling_torque(&mut shape.moving(qd), sample.mu))
}

fn norm(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn largest<'a>(samples: impl IntoIterator<Item = &'a Sample>, of: impl Fn(&Sample) -> f64) -> f64 {
    samples.into_iter().map(of).fold(0.0, f64::max)
}

#[test]
fn the_scenes_differ_in_the_decoupling_alone() {
    let model = model();
    let [coupling, mut tau_bar] = ["paper", "paper_tau_bar"].map(|name| scene(name, &model));
    assert_ne!(coupling, tau_bar);
    assert_eq!((gains(&coupling).decoupling, gains(&tau_bar).decoupling), (Decoupling::Coupling, Decoupling::TauBar));
    for (named, other) in tau_bar.forces.iter_mut().zip(&coupling.forces) {
        named.line = other.line;
        if let Force::Regulator(gains) = &mut named.force {
            gains.decoupling = Decoupling::Coupling;
        }
    }
    assert_eq!(coupling, tau_bar);
}

/// After the blow the shape's energy `½ q̇ᵀ Λ_q q̇ + ½ (q − q_d)ᵀ K (q − q_d)` falls from sample to sample, to nearly nothing.
#[test]
fn both_decouplings_are_asymptotically_stable() {
    /// Share of the energy after the blow that is left at the end: 3.5 s at some 6 rad/s and less for slower modes.
    const LEFT: f64 = 1e-6;
    let model = model();
    for (gains, samples) in both(&model) {
        let mut robot = Evaluator::new(&model);
        let energies: Vec<f64> = samples
            .iter()
            .filter(|sample| sample.time >= BLOW[1])
            .map(|sample| {
                let mut energy = [0.0];
                robot.answer(Quantity::KineticEnergy, &[&sample.q, &sample.qd, &[0.0; 6]], &mut [&mut energy]);
                let springs = sample.q.iter().zip(&gains.set_point).zip(&gains.stiffness);
                energy[0] + springs.map(|((q, rest), stiffness)| 0.5 * stiffness * (q - rest).powi(2)).sum::<f64>()
            })
            .collect();
        assert!(energies.windows(2).all(|pair| pair[1] < pair[0]), "{:?}", gains.decoupling);
        let left = energies.last().unwrap() / energies[0];
        assert!(left < LEFT, "{:?}: {left:e}", gains.decoupling);
    }
}

#[test]
fn the_torques_differ_by_b2_on_the_shape_velocity_which_does_no_work() {
    let model = model();
    let mut work = Workspace::new(&model);
    let mut b2 = DMatrix::zeros(7, 7);
    let (mut seen, mut largest_difference): (usize, f64) = (0, 0.0);
    for (gains, samples) in both(&model) {
        for sample in &samples {
            let [tau_bar, coupling] = [Decoupling::TauBar, Decoupling::Coupling]
                .map(|way| decoupling(&model, &gains, way, sample, &sample.qd));
            work.shape(&sample.q).b2(sample.mu, &mut b2);
            let qd = DVector::from_column_slice(&sample.qd);
            let expected = &b2 * &qd;
            let size = coupling.norm() + expected.norm();
            let error = (&tau_bar - &coupling - &expected).norm();
            assert!(error <= ROUNDING * size, "t = {}: {error:e} of {size:e}", sample.time);
            let power = qd.dot(&(&tau_bar - &coupling)).abs();
            assert!(power <= ROUNDING * size * qd.norm(), "t = {}: {power:e}", sample.time);
            largest_difference = largest_difference.max(expected.norm());
            seen += 1;
        }
    }
    assert!(seen == 1602 && largest_difference > 1e-2, "{largest_difference:e}: there is a difference to be seen");
}

/// The older torque follows the shape velocity, and so does what the blow did to it; the new one does not see it.
#[test]
fn only_tau_bar_carries_a_transient_of_the_shape_velocity() {
    /// Before the blow the shape velocity is what the integrator leaves of 0; long after it, what has not faded.
    const QUIET: f64 = 1e-2;
    let model = model();
    let [(gains, new), (_, old)] = both(&model);
    let transient = |way, sample: &Sample| {
        let [moving, held] = [&sample.qd[..], &[0.0; 7]].map(|qd| decoupling(&model, &gains, way, sample, qd));
        (moving - held).norm()
    };
    assert_eq!(largest(&new, |sample| transient(Decoupling::Coupling, sample)), 0.0);

    let part = |from: f64, to: f64| {
        let within = old.iter().filter(move |sample| (from..to).contains(&sample.time));
        largest(within, |sample| transient(Decoupling::TauBar, sample))
    };
    let [before, during, late] = [part(0.0, 0.5), part(0.5, 1.5), part(2.5, 5.0)];
    let decoupling_before = norm(&old[100].tau);
    assert!(during > decoupling_before, "the transient {during:e} exceeds the steady torque {decoupling_before:e}");
    assert!(before < QUIET * during && late < QUIET * during, "{before:e}, {during:e}, {late:e}");
}

#[test]
fn tau_bar_peaks_on_impact() {
    let model = model();
    let [(new_gains, new), (old_gains, old)] = both(&model);
    let peak = |gains: &Gains, samples: &[Sample]| {
        let size = |sample: &Sample| decoupling(&model, gains, gains.decoupling, sample, &sample.qd).norm();
        let highest = samples.iter().max_by(|a, b| size(a).total_cmp(&size(b))).unwrap();
        (highest.time, size(highest), size(&samples[0]))
    };
    let [(_, highest, start), (time, highest_old, start_old)] = [peak(&new_gains, &new), peak(&old_gains, &old)];
    assert!(start_old == start && (BLOW[0]..=BLOW[1]).contains(&time), "{time}");
    assert!(highest_old > 2.0 * start && highest < 1.2 * start, "{highest_old:e}, {highest:e}, {start:e}");
}

/// Where the shape rests both hold it with −c(μ), so that they are equal where the momentum is.
#[test]
fn steady_torques_are_equal() {
    /// Relative; the integrators' accuracy before the blow, and what has not faded four seconds later than in the scenes.
    const STEADY: f64 = 1e-5;
    /// The blow turns with the base, which the two move a little differently: how far apart torques and momenta are afterwards.
    const AFTER: [f64; 2] = [1e-4, 1e-5];
    let model = model();
    let flights = ["paper", "paper_tau_bar"].map(|name| {
        let scene = Scene { duration: 8.0, ..scene(name, &model) };
        (gains(&scene), run(&scene, &model, |_| ControlFlow::Continue(())).samples)
    });
    for (gains, samples) in &flights {
        for k in [0, 100, 1600] {
            let steady = decoupling(&model, gains, Decoupling::Coupling, &samples[k], &[0.0; 7]);
            let error = (DVector::from_column_slice(&samples[k].tau) - &steady).norm() / steady.norm();
            assert!(error < STEADY, "t = {}: {error:e}", samples[k].time);
        }
    }
    let [new, old] = flights.map(|(_, samples)| [100, 1600].map(|k| samples[k].clone()));
    let apart = |k: usize| {
        let torque: Vec<f64> = new[k].tau.iter().zip(&old[k].tau).map(|(a, b)| a - b).collect();
        let momentum = (new[k].momentum - old[k].momentum).to_array();
        [norm(&torque) / norm(&new[k].tau), norm(&momentum) / norm(&new[k].momentum.to_array())]
    };
    assert!(apart(0).iter().all(|apart| *apart < STEADY), "{:?}", apart(0));
    assert!(apart(1)[0] < AFTER[0] && apart(1)[1] < AFTER[1], "{:?}", apart(1));
}
