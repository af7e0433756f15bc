//! What both ways of decoupling the momentum ask of the joints, along one motion.

use frs::model::Motion;
use frs::{Model, Workspace};
use frs_sim::effects::{Decoupling, Gains, Regulator};
use frs_sim::run::Sample;
use frs_sim::scene::{Force, Scene};

use super::chart::Panel;

/// The older torque, the newer one, by what they differ, and the size of the shape velocity; for a scene with a regulator that decouples.
pub fn panels(scene: &Scene, model: &Model, samples: &[Sample]) -> Option<Vec<Panel>> {
    let mut regulators = scene.forces.iter().filter_map(|named| match &named.force {
        Force::Regulator(gains) if gains.decoupling != Decoupling::None => Some(gains),
        _ => None,
    });
    let gains = regulators.next()?;
    let mut work = Workspace::new(model);
    let mut torques = |decoupling| -> Vec<Vec<f64>> {
        let mut regulator = Regulator::new(Gains { decoupling, ..gains.clone() });
        let torque = |sample: &Sample| {
            let mut shape = work.shape(&sample.q);
            regulator.decoupling_torque(&mut shape.moving(&sample.qd), sample.mu).to_vec()
        };
        samples.iter().map(torque).collect()
    };
    let [older, newer] = [Decoupling::TauBar, Decoupling::Coupling].map(&mut torques);
    let apart = |(one, other): (&Vec<f64>, &Vec<f64>)| one.iter().zip(other).map(|(a, b)| a - b).collect();
    let apart: Vec<Vec<f64>> = older.iter().zip(&newer).map(apart).collect();
    let slides = model.bodies().iter().skip(1).any(|body| body.motion == Motion::Prismatic);
    let [torque, rate] = if slides { ["N·m, N", "rad/s, m/s"] } else { ["N·m", "rad/s"] };
    let panel = |label: &str, of: &[Vec<f64>]| Panel {
        label: format!("{label} / {torque}"),
        lines: model.coordinates().iter().enumerate().map(|(j, c)| (c.name.clone(), each(of, |row| row[j]))).collect(),
    };
    let rates: Vec<Vec<f64>> = samples.iter().map(|sample| sample.qd.clone()).collect();
    let size = each(&rates, |row| row.iter().map(|x| x * x).sum::<f64>().sqrt());
    Some(vec![
        panel("tau_bar: −c + B₂ dq/dt", &older),
        panel("coupling: −c", &newer),
        panel("difference: B₂ dq/dt", &apart),
        Panel { label: format!("|dq/dt| / {rate}"), lines: vec![("|dq/dt|".to_owned(), size)] },
    ])
}

fn each(rows: &[Vec<f64>], of: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    rows.iter().map(|row| of(row)).collect()
}
