//! A motion as a table, and as comma-separated values.

use frs::Model;
use frs::nalgebra::{Matrix3, Vector3};
use frs::spatial::{Pose, Twist, Wrench};
use frs_sim::observer::Observation;
use frs_sim::run::Sample;
use frs_sim::scene::Scene;

const SIX: [&str; 6] = ["omega_x", "omega_y", "omega_z", "v_x", "v_y", "v_z"];
const MOMENTUM: [&str; 6] = ["moment_x", "moment_y", "moment_z", "force_x", "force_y", "force_z"];

/// Names of the columns.
pub fn names(scene: &Scene, model: &Model) -> Vec<String> {
    let joints = |of: &str| model.coordinates().iter().map(|c| format!("{of}.{}", c.name)).collect::<Vec<_>>();
    let axes = ["x", "y", "z"];
    let rotation = axes.iter().flat_map(|row| axes.map(|column| format!("pose.r_{row}{column}")));
    let error = SIX.map(|name| format!("mu_error.{name}")).into_iter().chain(["observer_energy".to_owned()]);
    std::iter::once("time".to_owned())
        .chain(axes.iter().map(|axis| format!("pose.{axis}")))
        .chain(rotation)
        .chain(joints("q"))
        .chain(joints("qd"))
        .chain(SIX.map(|name| format!("mu.{name}")))
        .chain(axes.iter().map(|axis| format!("com.{axis}")))
        .chain(["kinetic_energy".to_owned()])
        .chain(scene.works().into_iter().map(|work| format!("work.{}", work.name)))
        .chain(MOMENTUM.map(|name| format!("spatial_momentum.{name}")))
        .chain(joints("tau"))
        .chain(scene.observer.into_iter().flat_map(|_| error.clone()))
        .collect()
}

/// A number for each name.
pub fn row(sample: &Sample) -> Vec<f64> {
    let rows = sample.pose.rotation.transpose();
    let observed = sample.observation.iter();
    std::iter::once(sample.time)
        .chain(sample.pose.translation.iter().copied())
        .chain(rows.iter().copied())
        .chain(sample.q.iter().copied())
        .chain(sample.qd.iter().copied())
        .chain(sample.mu.to_array())
        .chain(sample.com.iter().copied())
        .chain([sample.kinetic_energy])
        .chain(sample.works.iter().copied())
        .chain(sample.momentum.to_array())
        .chain(sample.tau.iter().copied())
        .chain(observed.flat_map(|seen| seen.error.to_array().into_iter().chain([seen.lyapunov])))
        .collect()
}

/// A line a row; every number reads back as it was.
pub fn table(names: &[String], rows: &[Vec<f64>]) -> String {
    let lines = rows.iter().map(|row| row.iter().map(f64::to_string).collect::<Vec<_>>().join(","));
    std::iter::once(names.join(",")).chain(lines).map(|line| line + "\n").collect()
}

/// The samples of a table; none if it is not one of this scene and robot.
pub fn samples(scene: &Scene, model: &Model, table: &str) -> Option<Vec<Sample>> {
    let (n, works) = (model.dof(), scene.works().len());
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
        let (kinetic_energy, works) = (take(1)?[0], take(works)?.to_vec());
        let momentum = Wrench::from_array(take(6)?.try_into().ok()?);
        let tau = take(n)?.to_vec();
        let observation = match scene.observer {
            None => None,
            Some(_) => {
                let (error, lyapunov) = (take(6)?, take(1)?[0]);
                Some(Observation { error: Twist::from_array(error.try_into().ok()?), lyapunov })
            }
        };
        rest.is_empty().then_some(Sample {
            time,
            pose,
            q,
            qd,
            mu,
            kinetic_energy,
            com,
            works,
            momentum,
            tau,
            observation,
        })
    };
    table.lines().skip(1).map(sample).collect()
}
