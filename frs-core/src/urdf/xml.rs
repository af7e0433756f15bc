//! XML, with problems told like all others.

use roxmltree::{Document, Error};

use super::UrdfError;
use super::source::Source;
use crate::model::{Part, Place, Problem, Subject};

/// Most attributes that one element, and namespace declarations that a text, can have: the time and memory that parsing
/// takes grow with the square of either.
const MOST: usize = 1000;

/// Parses the text as XML.
pub(super) fn parse<'a>(source: &Source<'a>) -> Result<Document<'a>, UrdfError> {
    let refuse = |place: Place, found: String, expected: &str, hint: &str| {
        let problem = Problem::error(Subject::File, Part::Whole, found, expected, hint);
        UrdfError::new(vec![Problem { place: Some(place), ..problem }])
    };
    if source.text.trim().is_empty() {
        return Err(refuse(
            source.place(1, 1),
            "the file is empty".into(),
            "a <robot> element",
            "is it the right file?",
        ));
    }
    if let Some(offset) = crowded(source.text) {
        let found = format!("more than {MOST} attributes in one element, or namespaces in all");
        return Err(refuse(source.place_of(offset), found, "far fewer", "is it a URDF file?"));
    }
    Document::parse(source.text).map_err(|error| {
        let place = match error {
            Error::DtdDetected => source.place_of(source.text.find("<!DOCTYPE").unwrap_or(0)),
            Error::UnclosedRootNode | Error::UnexpectedEndOfStream => source.place_of(source.text.len()),
            _ => source.place(error.pos().row as usize, error.pos().col as usize),
        };
        let (expected, hint) = match &error {
            Error::DtdDetected => ("none", "take it out, and replace the entities it declares by their values"),
            Error::UnknownNamespace(prefix, _) if prefix == "xacro" => ("plain URDF", "expand the file by xacro first"),
            _ => ("well-formed XML", "correct the text there, or check that it is a URDF file"),
        };
        let told = error.to_string();
        let found = match &error {
            Error::DtdDetected => "a document type declaration",
            _ => told.strip_suffix(&format!(" at {}", error.pos())).unwrap_or(&told),
        };
        refuse(place, found.into(), expected, hint)
    })
}

/// The tag or declaration with which the text exceeds [`MOST`].
fn crowded(text: &str) -> Option<usize> {
    if let Some((offset, _)) = text.match_indices("xmlns").nth(MOST) {
        return Some(offset);
    }
    let past = |from: usize, end: &str| text[from..].find(end).map(|at| from + at + end.len());
    let mut at = 0;
    while let Some(tag) = text[at..].find('<').map(|open| at + open) {
        let rest = &text[tag..];
        let other = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")]
            .into_iter()
            .find(|(start, _)| rest.starts_with(start));
        if let Some((start, end)) = other {
            at = past(tag + start.len(), end)?;
            continue;
        }
        // Inside a tag, up to its end; values in quotes may contain anything.
        let mut attributes = 0;
        at = tag + 1;
        loop {
            at += text[at..].find(['"', '\'', '>'])?;
            let quote = match text.as_bytes()[at] {
                b'>' => break,
                b'"' => "\"",
                _ => "'",
            };
            attributes += 1;
            if attributes > MOST {
                return Some(tag);
            }
            at = past(at + 1, quote)?;
        }
    }
    None
}
