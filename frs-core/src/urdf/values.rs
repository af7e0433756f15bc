//! Children, attributes and numbers of an element.

use roxmltree::Node;

use crate::model::{Part, Problem, Subject};

/// Reads the elements of one link or joint, and notes what is wrong with the byte where it is wrong.
pub(super) struct Values<'f> {
    pub subject: Subject,
    pub findings: &'f mut Vec<(usize, Problem)>,
}

impl<'f> Values<'f> {
    /// The child element called `name`; a second one is a problem.
    pub fn child<'d, 'i>(&mut self, node: Node<'d, 'i>, name: &str, part: Part) -> Option<Node<'d, 'i>> {
        let mut children = children(node, name);
        let first = children.next();
        if let Some(second) = children.next() {
            let parent = node.tag_name().name();
            self.note(second.range().start, part, format!("a second <{name}> in <{parent}>"), "one", "take one away");
        }
        first
    }

    /// The child element called `name`, which must be there.
    pub fn required_child<'d, 'i>(&mut self, node: Node<'d, 'i>, name: &str, part: Part) -> Option<Node<'d, 'i>> {
        let child = self.child(node, name, part);
        if child.is_none() {
            let parent = node.tag_name().name();
            self.note(
                node.range().start,
                part,
                format!("<{parent}> has no <{name}>"),
                format!("<{parent}> with <{name}>"),
                format!("add <{name}>, or take <{parent}> away"),
            );
        }
        child
    }

    /// The attribute `name`, as a number, if it is there.
    pub fn number(&mut self, node: Node<'_, '_>, name: &str, part: Part) -> Option<f64> {
        let attribute = node.attribute_node(name)?;
        let number = number(attribute.value());
        if let Err(found) = &number {
            self.note(
                attribute.range_value().start,
                part,
                format!("{} {name} is {found}", node.tag_name().name()),
                "a finite number",
                number_hint(attribute.value()),
            );
        }
        number.ok()
    }

    /// The attribute `name`, as a number; `placeholder` where it is missing or wrong, which is a problem.
    pub fn required_number(&mut self, node: Node<'_, '_>, name: &str, part: Part, placeholder: f64) -> f64 {
        if node.has_attribute(name) {
            return self.number(node, name, part).unwrap_or(placeholder);
        }
        self.missing_attribute(node, name, part, "a number");
        placeholder
    }

    /// The attribute `name`, as three numbers, if it is there.
    pub fn vector(&mut self, node: Node<'_, '_>, name: &str, part: Part) -> Option<[f64; 3]> {
        let attribute = node.attribute_node(name)?;
        let value = attribute.value();
        let words: Vec<&str> = value.split_whitespace().collect();
        let found = match words[..] {
            [x, y, z] => match [number(x), number(y), number(z)] {
                [Ok(x), Ok(y), Ok(z)] => return Some([x, y, z]),
                numbers => numbers.into_iter().find_map(Result::err).unwrap_or_default(),
            },
            _ => format!("{} ({})", quoted(value), count(words.len())),
        };
        self.note(
            attribute.range_value().start,
            part,
            format!("{} {name} is {found}", node.tag_name().name()),
            "three finite numbers",
            number_hint(value),
        );
        None
    }

    /// Notes an attribute that must be there.
    pub fn missing_attribute(&mut self, node: Node<'_, '_>, name: &str, part: Part, expected: &str) {
        let element = node.tag_name().name();
        let hint = format!("write <{element} {name}=\"…\">");
        self.note(node.range().start, part, format!("<{element}> has no attribute {name}"), expected, hint);
    }

    /// Notes a problem at a byte.
    pub fn note(
        &mut self,
        offset: usize,
        part: Part,
        found: impl Into<String>,
        expected: impl Into<String>,
        hint: impl Into<String>,
    ) {
        self.findings.push((offset, Problem::error(self.subject.clone(), part, found, expected, hint)));
    }
}

/// The child elements called `name`, in the parent's own namespace.
pub(super) fn children<'d, 'i>(node: Node<'d, 'i>, name: &str) -> impl Iterator<Item = Node<'d, 'i>> {
    let namespace = node.tag_name().namespace();
    node.children().filter(move |child| {
        child.is_element() && child.tag_name().name() == name && child.tag_name().namespace() == namespace
    })
}

/// A finite number, or what was found instead.
fn number(text: &str) -> Result<f64, String> {
    text.trim().parse::<f64>().ok().filter(|number| number.is_finite()).ok_or_else(|| quoted(text))
}

/// The text in quotes, cut where it is long.
pub(super) fn quoted(text: &str) -> String {
    const LONGEST: usize = 60;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("'{}…'", &text[..end]),
        None => format!("'{text}'"),
    }
}

fn count(numbers: usize) -> String {
    match numbers {
        1 => "1 number".into(),
        n => format!("{n} numbers"),
    }
}

fn number_hint(text: &str) -> &'static str {
    if text.contains("${") || text.contains("$(") {
        "expand the file by xacro first"
    } else if text.contains(',') {
        "separate numbers by spaces, and write decimals with a point"
    } else {
        "write it like -0.25 or 1e-3"
    }
}
