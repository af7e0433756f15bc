//! `accuracy.html`: a study as one page that needs nothing beside itself.

use std::fmt::Write;

use frs_sim::study::Errors;

use super::advice::ASKED;
use super::search::{Search, words};
use crate::cli::svg::escaped;

/// The page's text.
pub fn page(search: &Search, scene: &str, about: &str, duration: f64, yardstick: Errors, picture: &str) -> String {
    let mut rows = String::new();
    for want in ASKED {
        let _ = match search.cheapest(want, |_| true) {
            Some(point) => writeln!(
                rows,
                "<tr><td>{want:.0e}<td>{}<td>{:.1e}<td>{}<td>{}",
                escaped(&words(&point.variant)),
                point.errors.of_state(),
                search.price(point, duration),
                search.tenfold(want).map_or("–".to_owned(), |factor| format!("{factor:.2}×"))
            ),
            None => writeln!(rows, "<tr><td>{want:.0e}<td>nothing that was tried<td><td><td>"),
        };
    }
    let limits: String =
        search.limits(yardstick.of_state()).iter().map(|limit| format!("<li>{}\n", escaped(limit))).collect();
    let mut filters = String::new();
    for (key, of) in ["method", "pace", "equations", "route", "scalar", "evaluation"].iter().zip(0..) {
        let mut names: Vec<&str> = search.points.iter().map(|point| point.variant.names()[of]).collect();
        names.sort_unstable();
        names.dedup();
        let _ = write!(filters, "<fieldset><legend>{key}</legend>");
        for name in names {
            let _ = write!(
                filters,
                "<label><input type=\"checkbox\" checked data-key=\"{key}\" value=\"{name}\"> {}</label>",
                name.replace('_', " ")
            );
        }
        filters += "</fieldset>\n";
    }
    format!(
        include_str!("page.html"),
        scene = escaped(scene),
        about = escaped(about),
        yardstick = format!("{:.0e}", yardstick.of_state()),
        points = search.points.len(),
        rows = rows,
        limits = limits,
        filters = filters,
        picture = picture,
        style = include_str!("page.css"),
        script = include_str!("page.js"),
    )
}
