//! Which pictures are drawn of a motion.

use frs::Model;
use frs::model::Motion;
use frs_sim::observer::Observation;
use frs_sim::run::Sample;
use frs_sim::scene::Scene;

use super::chart::{Chart, Panel};
use super::decoupling;

const AXES: [&str; 3] = ["x", "y", "z"];

/// Names of files and what is drawn in them.
pub fn all(scene: &Scene, model: &Model, samples: &[Sample]) -> Vec<(&'static str, Chart)> {
    let chart = |title, panels| {
        let times = samples.iter().map(|sample| sample.time).collect();
        Chart { title, caption: model.name().to_owned(), times, panels }
    };
    let three = |label: &str, of: &dyn Fn(&Sample) -> [f64; 3]| Panel {
        label: label.to_owned(),
        lines: AXES.iter().enumerate().map(|(i, axis)| ((*axis).to_owned(), each(samples, |s| of(s)[i]))).collect(),
    };
    let joints = |symbol: &str, units: [&str; 2], of: &dyn Fn(&Sample) -> &[f64]| -> Vec<Panel> {
        let kinds = [(false, units[0]), (true, units[1])];
        let panel = |(slides, unit): (bool, &str)| {
            let own = model.coordinates().iter().enumerate();
            let own = own.filter(|(_, c)| matches!(model.bodies()[c.body].motion, Motion::Prismatic) == slides);
            let lines = own.map(|(j, c)| (c.name.clone(), each(samples, |s| of(s)[j]))).collect();
            Panel { label: format!("{symbol} / {unit}"), lines }
        };
        kinds.map(panel).into()
    };
    let Some(first) = samples.first() else { return Vec::new() };
    let energy = Panel {
        label: "energy / J".into(),
        lines: vec![
            ("kinetic energy".into(), each(samples, |s| s.kinetic_energy)),
            ("work of all".into(), each(samples, Sample::work)),
        ],
    };
    let works = scene.works().into_iter().enumerate();
    let works = works.map(|(i, work)| (work.name, each(samples, |s| s.works[i]))).collect();
    let balance = Panel {
        label: "difference / J".into(),
        lines: vec![("E − E(0) − W".into(), each(samples, |s| s.kinetic_energy - first.kinetic_energy - s.work()))],
    };
    let seen = |of: &dyn Fn(&Observation) -> f64| each(samples, |s| s.observation.as_ref().map_or(f64::NAN, of));
    let errors = |label: &str, of: &dyn Fn(&Observation) -> [f64; 3]| Panel {
        label: label.to_owned(),
        lines: AXES.iter().enumerate().map(|(i, axis)| ((*axis).to_owned(), seen(&|s| of(s)[i]))).collect(),
    };
    let observed = scene.observer.map(|_| {
        vec![
            errors("angular error / rad/s", &|s| s.error.angular.into()),
            errors("linear error / m/s", &|s| s.error.linear.into()),
            Panel {
                label: "log₁₀(V / J)".into(),
                lines: vec![("V = ½ eᵀ Λ_b e".into(), seen(&|s| s.lyapunov.log10()))],
            },
        ]
    });
    let pictures = [
        ("shape.svg", "Shape", joints("q", ["rad", "m"], &|s| &s.q)),
        ("shape_rates.svg", "Shape velocity", joints("dq/dt", ["rad/s", "m/s"], &|s| &s.qd)),
        (
            "locked_velocity.svg",
            "Locked velocity, base frame",
            vec![three("angular / rad/s", &|s| s.mu.angular.into()), three("linear / m/s", &|s| s.mu.linear.into())],
        ),
        ("torques.svg", "Joint torques", joints("τ", ["N·m", "N"], &|s| &s.tau)),
        (
            "energy.svg",
            "Kinetic energy and the work of all forces",
            vec![energy, Panel { label: "work / J".into(), lines: works }, balance],
        ),
        (
            "momentum.svg",
            "Change of the momentum about the world's origin",
            vec![
                three("angular / kg·m²/s", &|s| (s.momentum - first.momentum).moment.into()),
                three("linear / kg·m/s", &|s| (s.momentum - first.momentum).force.into()),
            ],
        ),
    ];
    let observer = observed.map(|panels| ("observer.svg", "Error of the observed locked velocity, base frame", panels));
    let decoupling = decoupling::panels(scene, model, samples);
    let decoupling = decoupling.map(|panels| ("decoupling.svg", "Decoupling torques along this motion", panels));
    let drawn = pictures.into_iter().chain(decoupling).chain(observer).map(|(name, title, panels)| {
        (name, title, panels.into_iter().filter(|panel| !panel.lines.is_empty()).collect::<Vec<_>>())
    });
    let drawn = drawn.filter(|(_, _, panels)| !panels.is_empty());
    drawn.map(|(name, title, panels)| (name, chart(title, panels))).collect()
}

fn each(samples: &[Sample], of: impl Fn(&Sample) -> f64) -> Vec<f64> {
    samples.iter().map(of).collect()
}
