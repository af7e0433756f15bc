//! A field over two joints as a picture: bands of colour, their borders, the zero line, a gait.

use std::fmt::Write;

use contour::ContourBuilder;
use frs::nalgebra::DMatrix;
use frs_gait::Grid;

use super::scale::Scale;
use crate::cli::svg::{escaped, text, ticks};

/// What a picture shows.
pub struct Map<'a> {
    /// `ω_x` and the like: a letter, and its index after an underscore.
    pub component: &'a str,
    /// Robot and frame.
    pub caption: &'a str,
    pub unit: &'a str,
    /// Labels of the two axes.
    pub axes: [String; 2],
    pub grid: Grid,
    pub values: &'a DMatrix<f64>,
    /// The field is zero, and what is left is rounding.
    pub vanishes: bool,
    /// A closed gait; none if empty.
    pub gait: &'a [[f64; 2]],
}

/// Width of the field in pixels; its height follows the window's proportions within [`HEIGHTS`].
const WIDTH: f64 = 430.0;

/// Least and greatest height of the field in pixels.
const HEIGHTS: [f64; 2] = [230.0, 560.0];

/// Where the field begins, from the left and from above.
const ORIGIN: [f64; 2] = [78.0, 66.0];

/// Width of the whole picture.
const PAGE: f64 = 640.0;

/// Points of a border that are nearer to each other than this are one (pixels).
const DETAIL: f64 = 0.8;

impl Map<'_> {
    /// The picture.
    pub fn svg(&self) -> String {
        let height = self.height();
        let page = ORIGIN[1] + height + 84.0;
        let [x, y] = ORIGIN;
        let (letter, index) = self.component.split_once('_').unwrap_or((self.component, ""));
        let mut out = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {PAGE} {page}\" width=\"{PAGE}\" height=\"{page}\" \
             font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\" font-size=\"13\" fill=\"#222\">\n\
             <rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n\
             <text x=\"{x}\" y=\"28\" font-size=\"17\">Curvature <tspan font-style=\"italic\">B</tspan>, component \
             <tspan font-style=\"italic\">{letter}</tspan><tspan font-size=\"12\" dy=\"4\">{index}</tspan></text>\n\
             <text x=\"{x}\" y=\"49\" fill=\"#555\">{}</text>\n\
             <clipPath id=\"field\"><rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{height}\"/></clipPath>\n",
            escaped(self.caption)
        );
        out += "<g clip-path=\"url(#field)\" stroke-linejoin=\"round\">\n";
        let scale = Scale::of(self.values, self.vanishes);
        self.bands(&mut out, &scale);
        self.singular(&mut out);
        self.gait(&mut out);
        out += "</g>\n";
        self.frame(&mut out);
        if self.vanishes {
            let middle = [x + 0.5 * WIDTH, y + 0.5 * height];
            text(&mut out, [middle[0], middle[1] - 10.0], "middle", "zero everywhere");
        } else {
            self.bar(&mut out, &scale);
        }
        out + "</svg>\n"
    }

    fn height(&self) -> f64 {
        let [[a0, a1], [b0, b1]] = self.grid.window();
        (WIDTH * (b1 - b0) / (a1 - a0)).clamp(HEIGHTS[0], HEIGHTS[1])
    }

    /// Where a point of the window is drawn.
    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [[a0, a1], [b0, b1]] = self.grid.window();
        let (share_x, share_y) = ((point[0] - a0) / (a1 - a0), (point[1] - b0) / (b1 - b0));
        [ORIGIN[0] + WIDTH * share_x, ORIGIN[1] + self.height() * (1.0 - share_y)]
    }

    /// All that is above the lowest border over the lowest colour, all above the next over that, and so on.
    fn bands(&self, out: &mut String, scale: &Scale) {
        let ([x, y], height) = (ORIGIN, self.height());
        let lowest = scale.colour(-scale.count);
        let _ = writeln!(out, "<rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{height}\" fill=\"{lowest}\"/>");
        if self.vanishes {
            return;
        }
        let borders: Vec<i32> = (1 - scale.count..scale.count).collect();
        for &border in &borders {
            let path = self.border(f64::from(border) * scale.step);
            let fill = scale.colour(border);
            let _ = writeln!(
                out,
                "<path d=\"{path}\" fill=\"{fill}\" fill-rule=\"evenodd\" stroke=\"#000\" stroke-opacity=\"0.22\" \
                 stroke-width=\"0.7\"/>"
            );
        }
        let zero = self.border(0.0);
        let _ = writeln!(out, "<path d=\"{zero}\" fill=\"none\" stroke=\"#222\" stroke-width=\"2\"/>");
    }

    /// The rings around all that is above `level`; where they follow the window's sides they lie outside of it.
    fn border(&self, level: f64) -> String {
        let (points, [step_x, step_y]) = (self.grid.points(), self.grid.spacing());
        let [[left, _], [low, _]] = self.grid.window();
        // The builder's cells have their values in their middles.
        let builder = ContourBuilder::new(points, points, true)
            .x_origin(left - 0.5 * step_x)
            .y_origin(low - 0.5 * step_y)
            .x_step(step_x)
            .y_step(step_y);
        // Column-major storage is row after row of the second coordinate. A grid of its own size cannot be refused.
        let finite = self.values.map(|value| if value.is_finite() { value } else { 0.0 });
        let contours = builder.contours(finite.as_slice(), &[level]).unwrap_or_default();
        let mut path = String::new();
        for polygon in contours.iter().flat_map(|contour| contour.geometry()) {
            for ring in std::iter::once(polygon.exterior()).chain(polygon.interiors()) {
                let mut last = [f64::INFINITY; 2];
                for point in ring.points() {
                    let [x, y] = self.place([point.x(), point.y()]);
                    if (x - last[0]).hypot(y - last[1]) < DETAIL {
                        continue;
                    }
                    let _ = write!(path, "{}{x:.1} {y:.1}", if last[0].is_infinite() { 'M' } else { 'L' });
                    last = [x, y];
                }
                path += "Z";
            }
        }
        path
    }

    /// A cross where there is no value: the robot is singular.
    fn singular(&self, out: &mut String) {
        let points = self.grid.points();
        for (i, j) in (0..points).flat_map(|j| (0..points).map(move |i| (i, j))) {
            if !self.values[(i, j)].is_finite() {
                let [x, y] = self.place(self.grid.point(i, j));
                let _ = writeln!(
                    out,
                    "<path d=\"M{x:.1} {y:.1}m-4 -4l8 8m0 -8l-8 8\" stroke=\"#111\" stroke-width=\"1.5\"/>"
                );
            }
        }
    }

    fn gait(&self, out: &mut String) {
        let [first, .., last] = self.gait else { return };
        let path: Vec<String> =
            self.gait.iter().map(|&p| self.place(p)).map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
        let path = path.join("L");
        let _ = writeln!(
            out,
            "<path d=\"M{path}Z\" fill=\"none\" stroke=\"#fff\" stroke-width=\"5\" stroke-opacity=\"0.8\"/>"
        );
        let _ = writeln!(out, "<path d=\"M{path}Z\" fill=\"none\" stroke=\"#111\" stroke-width=\"2.4\"/>");
        // The start, and an arrow a third of the way.
        let [x, y] = self.place(*first);
        let _ = writeln!(
            out,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\" fill=\"#fff\" stroke=\"#111\" stroke-width=\"2\"/>"
        );
        let at = self.gait.len() / 3;
        let next = self.gait.get(at + 1).unwrap_or(last);
        let ([x, y], [to_x, to_y]) = (self.place(self.gait[at]), self.place(*next));
        let angle = (to_y - y).atan2(to_x - x).to_degrees();
        let _ = writeln!(
            out,
            "<path d=\"M10 0L-7 -7L-3 0L-7 7Z\" transform=\"translate({x:.1} {y:.1}) rotate({angle:.1})\" fill=\"#111\" \
             stroke=\"#fff\" stroke-width=\"1\"/>"
        );
    }

    /// The border of the field, its ticks and the names of the axes.
    fn frame(&self, out: &mut String) {
        let ([x, y], height) = (ORIGIN, self.height());
        let bottom = y + height;
        let _ = writeln!(
            out,
            "<rect x=\"{x}\" y=\"{y}\" width=\"{WIDTH}\" height=\"{height}\" fill=\"none\" stroke=\"#222\"/>"
        );
        let [across, up] = self.grid.window();
        for (value, label) in ticks(across) {
            let [at, _] = self.place([value, up[0]]);
            let _ = writeln!(out, "<path d=\"M{at:.1} {bottom}v5\" stroke=\"#222\"/>");
            text(out, [at, bottom + 20.0], "middle", &label);
        }
        for (value, label) in ticks(up) {
            let [_, at] = self.place([across[0], value]);
            let _ = writeln!(out, "<path d=\"M{x} {at:.1}h-5\" stroke=\"#222\"/>");
            text(out, [x - 9.0, at + 4.5], "end", &label);
        }
        text(out, [x + 0.5 * WIDTH, bottom + 44.0], "middle", &self.axes[0]);
        let hint = "A small counter-clockwise loop moves the base by −value × area. Thick line: zero.";
        let _ = writeln!(out, "<text x=\"{x}\" y=\"{}\" font-size=\"11.5\" fill=\"#555\">{hint}</text>", bottom + 70.0);
        let middle = y + 0.5 * height;
        let label = escaped(&self.axes[1]);
        let _ = writeln!(
            out,
            "<text transform=\"translate(22 {middle}) rotate(-90)\" text-anchor=\"middle\">{label}</text>"
        );
    }

    /// The colours and what they mean.
    fn bar(&self, out: &mut String, scale: &Scale) {
        let (x, height) = (ORIGIN[0] + WIDTH + 26.0, self.height());
        let each = height / f64::from(2 * scale.count);
        let at = |border: i32| ORIGIN[1] + height - each * f64::from(border + scale.count);
        for band in -scale.count..scale.count {
            let (top, fill) = (at(band + 1), scale.colour(band));
            let _ = writeln!(
                out,
                "<rect x=\"{x}\" y=\"{top:.1}\" width=\"20\" height=\"{:.1}\" fill=\"{fill}\"/>",
                each + 0.5
            );
        }
        let top = ORIGIN[1];
        let _ = writeln!(
            out,
            "<rect x=\"{x}\" y=\"{top}\" width=\"20\" height=\"{height}\" fill=\"none\" stroke=\"#222\"/>"
        );
        let every = if each * 2.0 < 18.0 { 4 } else { 2 };
        for border in (-scale.count..=scale.count).filter(|border| border % every == 0) {
            let y = at(border);
            let width = if border == 0 { 2.0 } else { 1.0 };
            let _ = writeln!(out, "<path d=\"M{x} {y:.1}h25\" stroke=\"#222\" stroke-width=\"{width}\"/>");
            text(out, [x + 30.0, y + 4.5], "start", &scale.label(border));
        }
        text(out, [x - 2.0, ORIGIN[1] - 12.0], "start", self.unit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coordinates are written with one digit after the point.
    const PIXEL: f64 = 0.051;

    #[test]
    fn the_border_of_a_slope_is_where_it_has_the_value() {
        let grid = Grid::new([[-1.0, 1.0], [2.0, 5.0]], 5);
        let values = DMatrix::from_fn(5, 5, |i, j| grid.point(i, j)[1] - 2.0 * grid.point(i, j)[0]);
        let axes = ["a".to_owned(), "b".to_owned()];
        let map =
            Map { component: "ω_x", caption: "", unit: "", axes, grid, values: &values, vanishes: false, gait: &[] };
        let path = map.border(3.3);
        let inside = |[x, y]: [f64; 2]| {
            (x - ORIGIN[0]).clamp(0.0, WIDTH) == x - ORIGIN[0]
                && (y - ORIGIN[1]).clamp(0.0, map.height()) == y - ORIGIN[1]
        };
        let mut on_the_line = 0;
        for point in path.trim_end_matches('Z').split(['M', 'L']).filter(|point| !point.is_empty()) {
            let (x, y) = point.split_once(' ').unwrap();
            let at: [f64; 2] = [x.parse().unwrap(), y.parse().unwrap()];
            if inside(at) {
                let [_, expected] = map.place([0.0, 3.3 + 2.0 * ((at[0] - ORIGIN[0]) / WIDTH * 2.0 - 1.0)]);
                // The line rises by less than two pixels a pixel.
                assert!((at[1] - expected).abs() < 3.0 * PIXEL, "{at:?}: {expected}");
                on_the_line += 1;
            }
        }
        assert!(on_the_line >= 5, "{path}");
    }
}
