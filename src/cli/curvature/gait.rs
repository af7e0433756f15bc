//! Gaits as people write them.

use frs_gait::{Gait, Path as _};

use super::plane::Axes;
use crate::cli::{Failure, read as read_file};

/// Points of a written or drawn gait that is one smooth piece.
const SAMPLES: usize = 240;

/// Reads `ellipse:…`, `polygon:…` or a CSV file.
pub fn read(text: &str, axes: &Axes<'_>) -> Result<Gait, Failure> {
    let told = |fact: String, expected: &str| Failure::Input(format!("--gait '{text}': {fact}; expected {expected}"));
    if let Some(numbers) = text.strip_prefix("ellipse:") {
        let expected = "ellipse:CA,CB,RA,RB, centre and half-axes, these not 0";
        return match numbers.split(',').map(number).collect::<Option<Vec<_>>>().as_deref() {
            Some(&[ca, cb, ra, rb]) if ra != 0.0 && rb != 0.0 => {
                Gait::ellipse(&axes.plane, [ca, cb], [ra, rb]).map_err(|error| told(error.to_string(), expected))
            }
            _ => Err(told("these are not four numbers of an ellipse".into(), expected)),
        };
    }
    if let Some(corners) = text.strip_prefix("polygon:") {
        let expected = "polygon:A,B;A,B;A,B, three corners or more";
        let points = corners.split(';').map(pair).collect::<Option<Vec<_>>>();
        let points = points.ok_or_else(|| told("these are not pairs of numbers".into(), expected))?;
        if points.len() < 3 {
            return Err(told(format!("found {} corners", points.len()), expected));
        }
        return Gait::polygon(&shapes(axes, &points)).map_err(|error| told(error.to_string(), expected));
    }
    if !std::path::Path::new(text).exists() {
        return Err(told("there is no such file".into(), "ellipse:CA,CB,RA,RB, polygon:A,B;A,B;… or a CSV file"));
    }
    let points = lines(text, &read_file(std::path::Path::new(text))?, axes)?;
    Gait::spline(&shapes(axes, &points)).map_err(|error| Failure::Input(format!("{text}: {error}")))
}

/// Reads a point a line; a first line may name the joints, in either order.
fn lines(file: &str, text: &str, axes: &Axes<'_>) -> Result<Vec<[f64; 2]>, Failure> {
    let [a, b] = axes.names();
    let mut points = Vec::new();
    let mut swapped = false;
    let written = (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    for (index, (line_number, line)) in written.enumerate() {
        match pair(line) {
            Some([x, y]) => points.push(if swapped { [y, x] } else { [x, y] }),
            None => match line.split_once(',').map(|(first, second)| [first.trim(), second.trim()]) {
                Some([first, second]) if index == 0 && [first, second] == [a, b] => {}
                Some([first, second]) if index == 0 && [first, second] == [b, a] => swapped = true,
                _ => {
                    return Err(Failure::Input(format!(
                        "{file}:{line_number}: '{line}' is not a point; expected two finite numbers, {a},{b}; the first \
                         line may name the joints"
                    )));
                }
            },
        }
    }
    Ok(points)
}

/// A gait as the points to draw.
pub fn drawn(gait: &Gait, axes: &Axes<'_>) -> Vec<[f64; 2]> {
    let (mut q, mut dq) = (vec![0.0; gait.dof()], vec![0.0; gait.dof()]);
    let each = SAMPLES.div_ceil(gait.pieces());
    let places = (0..gait.pieces()).flat_map(|piece| (0..each).map(move |k| (piece, k as f64 / each as f64)));
    places
        .map(|(piece, t)| {
            gait.at(piece, t, &mut q, &mut dq);
            axes.plane.point(&q)
        })
        .collect()
}

/// A gait as a CSV file that [`read`] takes.
pub fn table(gait: &Gait, axes: &Axes<'_>) -> String {
    let points = drawn(gait, axes).into_iter().map(|[x, y]| format!("{x},{y}\n"));
    format!("{}\n", axes.names().join(",")) + &points.collect::<String>()
}

/// A finite number.
pub fn number(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|number: &f64| number.is_finite())
}

fn pair(text: &str) -> Option<[f64; 2]> {
    let (x, y) = text.split_once(',')?;
    Some([number(x)?, number(y)?])
}

fn shapes(axes: &Axes<'_>, points: &[[f64; 2]]) -> Vec<Vec<f64>> {
    points.iter().map(|&point| axes.plane.shape(point)).collect()
}
