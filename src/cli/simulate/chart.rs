//! Lines over time, in panels below each other.

use std::fmt::Write;

use crate::cli::svg::{escaped, text, ticks};

/// A picture. `report.html` finds panels and names of lines by their classes.
pub struct Chart {
    pub title: &'static str,
    pub caption: String,
    pub times: Vec<f64>,
    pub panels: Vec<Panel>,
}

/// Lines with one unit.
pub struct Panel {
    /// What is drawn, with its unit.
    pub label: String,
    /// Each with its name.
    pub lines: Vec<(String, Vec<f64>)>,
}

/// Colours of lines that can be told apart, also by those who do not see red and green apart (after Okabe and Ito).
const COLOURS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#222222"];

/// Dashes of the lines beyond the colours.
const DASHES: [&str; 4] = ["none", "7 3", "2 3", "9 3 2 3"];

/// A panel in pixels.
const WIDTH: f64 = 620.0;
const HEIGHT: f64 = 210.0;

/// Where the first panel begins, from the left and from above, and the room below each.
const ORIGIN: [f64; 2] = [84.0, 72.0];
const GAP: f64 = 46.0;

/// Width of the picture at least; the names of the lines stand on the right, a letter as wide as this.
const PAGE: f64 = 860.0;
const LETTER: f64 = 7.5;

/// Height of a line's name, and where it begins right of the panel.
const ROW: f64 = 17.0;
const NAME: f64 = 43.0;

/// Points that are nearer to each other than this in time are one (pixels).
const DETAIL: f64 = 0.5;

impl Chart {
    /// The picture.
    pub fn svg(&self) -> String {
        let x = ORIGIN[0];
        let heights: Vec<f64> = self.panels.iter().map(|panel| (panel.lines.len() as f64 * ROW).max(HEIGHT)).collect();
        let names = self.panels.iter().flat_map(|panel| &panel.lines).map(|(name, _)| name.chars().count());
        let across = PAGE.max(x + WIDTH + NAME + LETTER * names.max().unwrap_or(0) as f64);
        let page = ORIGIN[1] + heights.iter().map(|height| height + GAP).sum::<f64>() + 14.0;
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {across} {page}\" width=\"{across}\" height=\"{page}\" \
             font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\" fill=\"#222\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
             <text x=\"{x}\" y=\"28\" font-size=\"17\">{}</text>\n<text x=\"{x}\" y=\"49\" fill=\"#555\">{}</text>\n",
            escaped(self.title),
            escaped(&self.caption)
        );
        let mut top = ORIGIN[1];
        for (panel, height) in self.panels.iter().zip(&heights) {
            self.panel(&mut out, panel, top, *height);
            top += height + GAP;
        }
        text(&mut out, [x + 0.5 * WIDTH, top - 4.0], "middle", "time / s");
        out + "</svg>\n"
    }

    fn panel(&self, out: &mut String, panel: &Panel, top: f64, height: f64) {
        let (left, bottom) = (ORIGIN[0], top + height);
        let end = self.times.last().copied().filter(|end| *end > 0.0);
        let across = [0.0, end.unwrap_or(1.0)];
        let up = range(panel);
        let place = |time: f64, value: f64| {
            [left + WIDTH * time / across[1], bottom - height * (value - up[0]) / (up[1] - up[0])]
        };
        for (time, label) in ticks(across) {
            let [x, _] = place(time, up[0]);
            let _ = writeln!(out, "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#e4e4e4\"/>");
            text(out, [x, bottom + 18.0], "middle", &label);
        }
        for (value, label) in ticks(up) {
            let [_, y] = place(0.0, value);
            let shade = if value == 0.0 { "#999" } else { "#e4e4e4" };
            let _ = writeln!(out, "<path d=\"M{left} {y:.1}h{WIDTH}\" stroke=\"{shade}\"/>");
            text(out, [left - 8.0, y + 4.5], "end", &label);
        }
        let _ = writeln!(
            out,
            "<rect class=\"panel\" x=\"{left}\" y=\"{top}\" width=\"{WIDTH}\" height=\"{height}\" fill=\"none\" stroke=\"#222\"/>\n\
             <text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>",
            0.5 * (top + bottom),
            escaped(&panel.label)
        );
        for (i, (name, values)) in panel.lines.iter().enumerate() {
            let (colour, dash) = (COLOURS[i % COLOURS.len()], DASHES[i / COLOURS.len() % DASHES.len()]);
            let pen = format!("fill=\"none\" stroke=\"{colour}\" stroke-width=\"1.6\" stroke-dasharray=\"{dash}\"");
            let path = self.path(values, place);
            let (right, y) = (left + WIDTH, top + 9.0 + ROW * i as f64);
            let _ = writeln!(
                out,
                "<path d=\"{path}\" stroke-linejoin=\"round\" {pen}/>\n<path d=\"M{} {y}h22\" {pen}/>\n\
                 <text class=\"name\" x=\"{}\" y=\"{}\">{}</text>",
                right + 14.0,
                right + NAME,
                y + 4.5,
                escaped(name)
            );
        }
    }

    /// The points of a line, but for those that no eye tells from their neighbours.
    fn path(&self, values: &[f64], place: impl Fn(f64, f64) -> [f64; 2]) -> String {
        let mut path = String::new();
        let mut last = f64::NEG_INFINITY;
        for (i, (&time, &value)) in self.times.iter().zip(values).enumerate() {
            let [x, y] = place(time, value);
            if value.is_finite() && (x - last >= DETAIL || i + 1 == values.len()) {
                let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
                last = x;
            }
        }
        path
    }
}

/// From the lowest to the highest value and a little beyond, with 0 among them.
fn range(panel: &Panel) -> [f64; 2] {
    /// Of what is drawn, the share that is left free above and below.
    const MARGIN: f64 = 0.06;
    let values = || panel.lines.iter().flat_map(|(_, values)| values.iter().copied()).filter(|value| value.is_finite());
    let (low, high) = (values().fold(0.0, f64::min), values().fold(0.0, f64::max));
    let margin = if high > low { MARGIN * (high - low) } else { 1.0 };
    [low - margin, high + margin]
}
