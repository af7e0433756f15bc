//! Work and precision: cost over error, both by powers of ten.

use std::fmt::Write;
use std::ops::Range;

use super::advice::time;
use super::peers::{Motion, Peers};
use super::search::{Cost, Point, Search, words};
use crate::cli::svg::{escaped, text};

/// The area that is drawn into, in pixels: left, top, width, height; and the whole picture.
const AREA: [f64; 4] = [92.0, 72.0, 640.0, 470.0];
const PAGE: [f64; 2] = [960.0, 606.0];

/// Colours of the methods, by falling order; they can be told apart by those who do not see red and green apart (after Okabe and Ito).
const COLOURS: [(&str, &str); 7] = [
    ("dop853", "#0072b2"),
    ("dopri5", "#d55e00"),
    ("rkmk4", "#009e73"),
    ("implicit_midpoint", "#cc79a7"),
    ("rkmk2", "#e69f00"),
    ("semi_implicit", "#56b4e9"),
    ("euler", "#777777"),
];

/// The colour of other programs.
const PEER: &str = "#555";

/// Width and height of the names of their methods, at most, in pixels.
const LABEL: [f64; 2] = [110.0, 12.0];

/// Errors that are drawn.
pub const SEEN: Range<f64> = 1e-17..1.0;

/// Dashes of the numbers.
const DASHES: [(&str, &str); 3] = [("f64", "none"), ("f32", "3 3"), ("double-double", "9 4")];

/// The picture; curves say in `data-…` what they are, points in their titles what they cost.
pub fn svg(search: &Search, peers: &Peers, title: &str, duration: f64) -> String {
    let [width, height] = PAGE;
    let [left, top, across, down] = AREA;
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\" fill=\"#222\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
         <text x=\"{left}\" y=\"28\" font-size=\"17\">{}</text>\n\
         <text x=\"{left}\" y=\"49\" fill=\"#555\">each point is one motion: {} ways; black: what no other way beats</text>\n",
        escaped(title),
        search.curves
    );
    let cost = |point: &Point| point.cost(search.cost) / duration;
    let shown = |point: &Point| SEEN.contains(&point.errors.of_state());
    let points = || search.points.iter().filter(|point| shown(point));
    let decades = |values: &mut dyn Iterator<Item = f64>| {
        let [low, high] = values.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], x| [low.min(x), high.max(x)]);
        [low.log10().floor(), high.log10().ceil().max(low.log10().floor() + 1.0)]
    };
    let others = || peers.motions.iter().filter(Motion::is_seen);
    let errors = decades(&mut points().map(|point| point.errors.of_state()).chain(others().map(|other| other.error)));
    let costs = decades(&mut points().map(cost).chain(others().map(|other| other.seconds / duration)));
    let place = |error: f64, cost: f64| {
        let x = left + across * (errors[1] - error.log10()) / (errors[1] - errors[0]);
        [x, top + down * (costs[1] - cost.log10()) / (costs[1] - costs[0])]
    };
    for power in errors[0] as i32..=errors[1] as i32 {
        let [x, _] = place(10.0_f64.powi(power), 1.0);
        let _ = writeln!(out, "<path d=\"M{x:.1} {top}v{down}\" stroke=\"#e4e4e4\"/>");
        if power % 2 == 0 {
            power_of_ten(&mut out, [x, top + down + 19.0], "middle", power);
        }
    }
    for power in costs[0] as i32..=costs[1] as i32 {
        let [_, y] = place(1.0, 10.0_f64.powi(power));
        let _ = writeln!(out, "<path d=\"M{left} {y:.1}h{across}\" stroke=\"#e4e4e4\"/>");
        match search.cost {
            Cost::Time => text(&mut out, [left - 8.0, y + 4.5], "end", &decade_of_time(power)),
            Cost::Operations => power_of_ten(&mut out, [left - 8.0, y + 4.5], "end", power),
        }
    }
    let what = match search.cost {
        Cost::Time => "time a simulated second",
        Cost::Operations => "operations a simulated second",
    };
    let _ = writeln!(
        out,
        "<rect x=\"{left}\" y=\"{top}\" width=\"{across}\" height=\"{down}\" fill=\"none\" stroke=\"#222\"/>\n\
         <text transform=\"translate(24 {}) rotate(-90)\" text-anchor=\"middle\">{what}</text>",
        top + 0.5 * down
    );
    text(
        &mut out,
        [left + 0.5 * across, top + down + 44.0],
        "middle",
        "error of pose and shape (rad, m); more accurate →",
    );

    let mut rest = search.points.iter().enumerate().peekable();
    while let Some((first, point)) = rest.next() {
        let names = point.variant.names();
        let mut curve = vec![(first, point)];
        while let Some(next) = rest.next_if(|(_, next)| next.variant.names() == names) {
            curve.push(next);
        }
        let best = curve.iter().any(|(i, _)| search.front.contains(i));
        let colour = named(&COLOURS, names[0]);
        let keys = ["method", "pace", "equations", "route", "scalar", "evaluation"];
        let data: String = keys.iter().zip(names).map(|(key, name)| format!(" data-{key}=\"{name}\"")).collect();
        let opacity = if best { 1.0 } else { 0.18 };
        let _ = write!(out, "<g class=\"curve\"{data} stroke=\"{colour}\" fill=\"{colour}\" opacity=\"{opacity}\">");
        let mut path = String::new();
        let mut dots = String::new();
        for (_, point) in curve.iter().filter(|(_, point)| shown(point)) {
            let [x, y] = place(point.errors.of_state(), cost(point));
            let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
            let _ = write!(
                dots,
                "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.6\"><title>{}\nerror: pose {:.1e}, shape {:.1e}, momentum {:.1e}, energy {:.1e}\n{}, {} evaluations</title></circle>",
                escaped(&words(&point.variant)),
                point.errors.pose,
                point.errors.shape,
                point.errors.momentum,
                point.errors.energy,
                search.price(point, duration),
                point.evaluations
            );
        }
        let _ = writeln!(
            out,
            "<path d=\"{path}\" fill=\"none\" stroke-dasharray=\"{}\"/>{dots}</g>",
            named(&DASHES, names[4])
        );
    }
    draw_peers(&mut out, peers, duration, |motion| place(motion.error, motion.seconds / duration));
    let front: Vec<String> = search
        .front
        .iter()
        .map(|&i| place(search.points[i].errors.of_state(), cost(&search.points[i])))
        .map(|[x, y]| format!("{x:.1} {y:.1}"))
        .collect();
    let _ = writeln!(
        out,
        "<path class=\"front\" d=\"M{}\" fill=\"none\" stroke=\"#000\" stroke-width=\"1.6\" pointer-events=\"none\"/>",
        front.join("L")
    );
    legend(&mut out, left + across + 22.0, top + 8.0);
    out + "</svg>\n"
}

/// Squares and lines, with the names of their methods at their last motions.
fn draw_peers(out: &mut String, peers: &Peers, duration: f64, place: impl Fn(&Motion) -> [f64; 2]) {
    let mut labels: Vec<[f64; 2]> = Vec::new();
    for curve in peers.curves() {
        let motions: Vec<_> = curve.iter().filter(Motion::is_seen).collect();
        let Some(last) = motions.last() else { continue };
        let (name, program) = (escaped(&last.name()), escaped(&last.program));
        let path: Vec<String> =
            motions.iter().map(|motion| place(motion)).map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        let _ = write!(
            out,
            "<g class=\"curve\" data-program=\"{program}\" stroke=\"{PEER}\" fill=\"{PEER}\"><path d=\"M{}\" fill=\"none\"/>",
            path.join("L")
        );
        for motion in &motions {
            let [x, y] = place(motion).map(|at| at - 2.5);
            let (step, cost) = (time(motion.step), time(motion.seconds / duration));
            let _ = write!(
                out,
                "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"5\" height=\"5\"><title>{name}, steps of {step}\nerror of pose and shape: {:.1e}\n{cost} a simulated second, {} evaluations</title></rect>",
                motion.error, motion.evaluations
            );
        }
        let [x, mut y] = place(last);
        while labels.iter().any(|[left, line]| (x - left).abs() < LABEL[0] && (y - line).abs() < LABEL[1]) {
            y -= 1.0;
        }
        labels.push([x, y]);
        let _ = writeln!(
            out,
            "<text x=\"{:.1}\" y=\"{:.1}\" stroke=\"none\" font-size=\"11\">{name}</text></g>",
            x + 5.0,
            y - 5.0
        );
    }
}

fn legend(out: &mut String, x: f64, top: f64) {
    let colours = COLOURS.iter().map(|(name, colour)| (name, *colour, "none"));
    let dashes = DASHES.iter().map(|(name, dash)| (name, "#222", *dash));
    for (row, (name, colour, dash)) in colours.chain(dashes).enumerate() {
        let y = top + 19.0 * row as f64 + if row < COLOURS.len() { 0.0 } else { 14.0 };
        let pen = format!("stroke=\"{colour}\" stroke-width=\"1.8\" stroke-dasharray=\"{dash}\"");
        let _ = writeln!(out, "<path d=\"M{x} {y}h24\" {pen}/>");
        text(out, [x + 32.0, y + 4.5], "start", &name.replace('_', " "));
    }
}

fn named<'n>(names: &[(&str, &'n str)], name: &str) -> &'n str {
    names.iter().find(|(known, _)| *known == name).map_or("#222", |(_, value)| *value)
}

/// 10 with an exponent.
fn power_of_ten(out: &mut String, [x, y]: [f64; 2], anchor: &str, power: i32) {
    let power = power.to_string().replace('-', "−");
    let _ = writeln!(
        out,
        "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">10<tspan dy=\"-5\" font-size=\"10\">{power}</tspan></text>"
    );
}

/// A power of ten seconds.
fn decade_of_time(power: i32) -> String {
    time(10.0_f64.powi(power) * (1.0 + f64::EPSILON)).replace(".00", "").replace(".0", "")
}
