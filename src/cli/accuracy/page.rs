//! `accuracy.html`: a study as one page that needs nothing beside itself.

use std::fmt::Write;

use frs_sim::study::Errors;

use super::advice::ASKED;
use super::peers::Peers;
use super::search::{Search, words};
use crate::cli::svg::escaped;

/// The page's text.
pub fn page(
    search: &Search,
    peers: &Peers,
    scene: &str,
    about: &str,
    duration: f64,
    yardstick: Errors,
    picture: &str,
) -> String {
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
        filters += &boxes(key, &names);
    }
    let mut programs: Vec<&str> = peers.motions.iter().map(|motion| motion.program.as_str()).collect();
    programs.dedup();
    let mut others = String::new();
    if !programs.is_empty() {
        filters += &boxes("program", &programs);
        others = "Squares are other programs: MuJoCo's time is that of its steps, Pinocchio's that of its articulated bodies alone; \
                  neither has Python in it, nor what computes the torques."
            .into();
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
        others = others,
        picture = picture,
        style = include_str!("page.css"),
        script = include_str!("page.js"),
    )
}

/// A box for each name of a kind.
fn boxes(key: &str, names: &[&str]) -> String {
    let each = names.iter().map(|name| {
        let words = name.replace('_', " ");
        format!("<label><input type=\"checkbox\" checked data-key=\"{key}\" value=\"{name}\"> {words}</label>")
    });
    format!("<fieldset><legend>{key}</legend>{}</fieldset>\n", each.collect::<String>())
}
