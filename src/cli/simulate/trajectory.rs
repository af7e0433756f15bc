//! A motion as comma-separated values.

use frs::Model;
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::{Pose, Twist, Wrench};
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

/// The samples of a table; none if it is not one of this robot.
pub fn samples(model: &Model, table: &str) -> Option<Vec<Sample>> {
    let n = model.dof();
    let sample = |line: &str| {
        let numbers = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>().ok()?;
        let mut rest = numbers.as_slice();
        let mut take = |count: usize| {
            let (taken, left) = rest.split_at_checked(count)?;
            rest = left;
            Some(taken)
        };
        let time = take(1)?[0];
        let (translation, rows) = (take(3)?, take(9)?);
        let pose = Pose::new(Matrix3::from_row_slice(rows), Vector3::from_column_slice(translation));
        let (q, qd) = (take(n)?.to_vec(), take(n)?.to_vec());
        let mu = Twist::from_array(take(6)?.try_into().ok()?);
        let com = Vector3::from_column_slice(take(3)?);
        let &[kinetic_energy, work] = take(2)? else { return None };
        let momentum = Wrench::from_array(take(6)?.try_into().ok()?);
        let tau = take(n)?.to_vec();
        rest.is_empty().then_some(Sample { time, pose, q, qd, mu, kinetic_energy, com, work, momentum, tau })
    };
    table.lines().skip(1).map(sample).collect()
}
