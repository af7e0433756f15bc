//! `report.html`: a motion as one page that needs nothing beside itself.

mod cuboid;
mod frames;
mod scenery;
mod skeleton;

use std::path::Path;

use frs::Model;
use frs_sim::run::Sample;
use frs_sim::scene::Scene;
use serde_json::json;

use self::scenery::Scenery;
use self::skeleton::Skeleton;
use super::chart::Chart;
use super::summary::Summary;
use crate::cli::Failure;
use crate::cli::svg::escaped;
use crate::cli::table;

/// The page's text.
pub fn page(
    path: &Path,
    scene: &Scene,
    model: &Model,
    samples: &[Sample],
    summary: &Summary,
    charts: &[(&str, Chart)],
) -> Result<String, Failure> {
    let mut told = Vec::new();
    table::robot(&mut told, model)?;
    let told = String::from_utf8_lossy(&told);
    let about = told.lines().next().unwrap_or_default().trim_start_matches(model.name()).trim_start_matches(": ");
    let (state, result) = match summary.ending() {
        None => ("whole", "the whole motion was computed".to_owned()),
        Some(ending) => ("broken", ending),
    };
    let rows = summary.rows().into_iter();
    let rows: String =
        rows.map(|(what, amount)| format!("<tr><th scope=\"row\">{what}<td>{}\n", escaped(&amount))).collect();
    let pictures: String = charts.iter().map(|(_, chart)| format!("<figure>{}</figure>\n", chart.svg())).collect();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (motion, beside) = motion(scene, model, samples, charts);
    Ok(format!(
        include_str!("report/page.html"),
        robot = escaped(model.name()),
        scene = escaped(&name),
        about = escaped(about),
        style = include_str!("report/page.css"),
        state = state,
        result = escaped(&result),
        rows = rows,
        pictures = pictures,
        motion = motion,
        beside = beside,
        view = include_str!("report/view.js"),
        player = include_str!("report/player.js"),
    ))
}

/// What moves, as JSON that may stand in a page: `<` is written by its number, so that no name ends the script. And what the page tells of what is
/// beside the robot.
fn motion(scene: &Scene, model: &Model, samples: &[Sample], charts: &[(&str, Chart)]) -> (String, String) {
    let skeleton = Skeleton::new(model);
    let lines: Vec<&[f64]> = charts
        .iter()
        .flat_map(|(_, chart)| &chart.panels)
        .flat_map(|panel| &panel.lines)
        .map(|(_, values)| values.as_slice())
        .collect();
    let times: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
    let shown = frames::thinned(&times, 3 * (skeleton.len() + Scenery::len(scene) + 1) + lines.len());
    let scenery = Scenery::new(scene, model, samples, &shown, skeleton.len());
    let (unit, points) = skeleton.frames(model, shown.iter().map(|i| &samples[*i]), &scenery.points);
    let motion = json!({
        "times": shown.iter().map(|i| frames::rounded(times[*i])).collect::<Vec<_>>(),
        "unit": unit,
        "points": points,
        "robot": skeleton.len(),
        "joints": skeleton.joints,
        "segments": skeleton.segments,
        "boxes": scenery.boxes,
        "marks": scenery.marks,
        "values": shown.iter().map(|i| lines.iter().map(|line| frames::rounded(line[*i])).collect()).collect::<Vec<Vec<_>>>(),
    });
    (motion.to_string().replace('<', "\\u003c"), scenery.legend())
}
