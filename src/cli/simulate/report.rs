//! `report.html`: a motion as one page that needs nothing beside itself.

mod frames;
mod skeleton;

use std::path::Path;

use frs::Model;
use frs_sim::run::Sample;
use serde_json::json;

use self::skeleton::Skeleton;
use super::chart::Chart;
use super::summary::Summary;
use crate::cli::Failure;
use crate::cli::svg::escaped;
use crate::cli::table;

/// The page's text.
pub fn page(
    scene: &Path,
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
    let name = scene.file_name().unwrap_or_default().to_string_lossy();
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
        motion = motion(model, samples, charts),
        view = include_str!("report/view.js"),
        player = include_str!("report/player.js"),
    ))
}

/// What moves, as JSON that may stand in a page: `<` is written by its number, so that no name ends the script.
fn motion(model: &Model, samples: &[Sample], charts: &[(&str, Chart)]) -> String {
    let skeleton = Skeleton::new(model);
    let lines: Vec<&[f64]> = charts
        .iter()
        .flat_map(|(_, chart)| &chart.panels)
        .flat_map(|panel| &panel.lines)
        .map(|(_, values)| values.as_slice())
        .collect();
    let times: Vec<f64> = samples.iter().map(|sample| sample.time).collect();
    let shown = frames::thinned(&times, skeleton.numbers() + lines.len());
    let (unit, points) = skeleton.frames(model, shown.iter().map(|i| &samples[*i]));
    json!({
        "times": shown.iter().map(|i| frames::rounded(times[*i])).collect::<Vec<_>>(),
        "unit": unit,
        "points": points,
        "joints": skeleton.joints,
        "segments": skeleton.segments,
        "values": shown.iter().map(|i| lines.iter().map(|line| frames::rounded(line[*i])).collect()).collect::<Vec<Vec<_>>>(),
    })
    .to_string()
    .replace('<', "\\u003c")
}
