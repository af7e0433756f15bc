//! Numbers and names as messages write them.

/// Numbers as a person writes them.
pub(super) fn plain(numbers: &[f64]) -> String {
    let plain = |number: &f64| format!("{number:?}").trim_end_matches(".0").to_owned();
    numbers.iter().map(plain).collect::<Vec<_>>().join(" ")
}

/// The number with four digits.
pub(super) fn rounded(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// Names in quotes; the middle of long lists is left out.
pub(super) fn abridged(names: &[String]) -> String {
    match names {
        [first, second, .., last] if names.len() > 8 => format!("{first} {second} … {last} ({} in all)", names.len()),
        _ => names.join(" "),
    }
}
