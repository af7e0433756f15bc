//! A motion as comma-separated values.

use frs::Model;
use frs_sim::run::Sample;

const SIX: [&str; 6] = ["omega_x", "omega_y", "omega_z", "v_x", "v_y", "v_z"];
const MOMENTUM: [&str; 6] = ["moment_x", "moment_y", "moment_z", "force_x", "force_y", "force_z"];

/// A line a sample; every number reads back as it was.
pub fn table(model: &Model, samples: &[Sample]) -> String {
    let joints = |of: &str| model.coordinates().iter().map(|c| format!("{of}.{}", c.name)).collect::<Vec<_>>();
    let axes = ["x", "y", "z"];
    let rotation = axes.iter().flat_map(|row| axes.map(|column| format!("pose.r_{row}{column}")));
    let names: Vec<String> = std::iter::once("time".to_owned())
        .chain(axes.iter().map(|axis| format!("pose.{axis}")))
        .chain(rotation)
        .chain(joints("q"))
        .chain(joints("qd"))
        .chain(SIX.map(|name| format!("mu.{name}")))
        .chain(axes.iter().map(|axis| format!("com.{axis}")))
        .chain(["kinetic_energy".to_owned(), "work".to_owned()])
        .chain(MOMENTUM.map(|name| format!("spatial_momentum.{name}")))
        .chain(joints("tau"))
        .collect();
    let mut text = names.join(",") + "\n";
    for sample in samples {
        let rows = sample.pose.rotation.transpose();
        let numbers = std::iter::once(sample.time)
            .chain(sample.pose.translation.iter().copied())
            .chain(rows.iter().copied())
            .chain(sample.q.iter().copied())
            .chain(sample.qd.iter().copied())
            .chain(sample.mu.to_array())
            .chain(sample.com.iter().copied())
            .chain([sample.kinetic_energy, sample.work])
            .chain(sample.momentum.to_array())
            .chain(sample.tau.iter().copied());
        text += &(numbers.map(|number| number.to_string()).collect::<Vec<_>>().join(",") + "\n");
    }
    text
}
