//! A TOML text as tables that know where they stand and note every problem.

use std::cell::RefCell;
use std::io;
use std::ops::Range;
use std::sync::LazyLock;

use frs_core::Model;
use frs_core::model::Place;
use toml::de::{DeTable, DeValue};

use super::problem::{Problem, SceneError, place};

/// How files that a scene names are read, by their paths from its folder.
pub type Files<'t> = dyn Fn(&str) -> io::Result<String> + 't;

/// The text, how files that it names are read, and what was found wrong so far.
pub struct Reader<'t> {
    file: &'t str,
    text: &'t str,
    files: &'t Files<'t>,
    problems: RefCell<Vec<Problem>>,
}

impl<'t> Reader<'t> {
    pub fn new(file: &'t str, text: &'t str, files: &'t Files<'t>) -> Self {
        Self { file, text, files, problems: RefCell::default() }
    }

    /// The whole text as a table.
    pub fn parse(&self) -> Result<DeTable<'t>, SceneError> {
        DeTable::parse(self.text).map(toml::Spanned::into_inner).map_err(|error| {
            let message = error.message().replace('\n', "; ");
            self.tell(error.span().unwrap_or(0..0), "", format!("this is not TOML: {message}"));
            self.error()
        })
    }

    pub fn place(&self, span: Range<usize>) -> Place {
        place(self.file, self.text, span)
    }

    fn tell(&self, span: Range<usize>, key: &str, message: String) {
        self.tell_at(self.place(span), key, message);
    }

    fn tell_at(&self, place: Place, key: &str, message: String) {
        self.problems.borrow_mut().push(Problem { place, key: key.to_owned(), message });
    }

    /// All problems, in the order of the file; then those of files that it names.
    pub fn error(&self) -> SceneError {
        let mut problems = self.problems.take();
        problems.sort_by_key(|Problem { place: Place { file, line, column }, .. }| {
            (**file != *self.file, file.clone(), *line, *column)
        });
        SceneError { problems }
    }

    /// `value` if nothing is wrong.
    pub fn finish<V>(&self, value: Option<V>) -> Result<V, SceneError> {
        let error = self.error();
        value.filter(|_| error.problems.is_empty()).ok_or(error)
    }
}

/// A table of the text; `path` is empty for the whole.
pub struct Table<'r, 't> {
    reader: &'r Reader<'t>,
    path: String,
    span: Range<usize>,
    entries: &'r DeTable<'t>,
}

/// A value under its key.
pub struct Item<'r, 't> {
    reader: &'r Reader<'t>,
    path: String,
    span: Range<usize>,
    value: &'r DeValue<'t>,
}

impl<'r, 't> Table<'r, 't> {
    pub fn root(reader: &'r Reader<'t>, entries: &'r DeTable<'t>) -> Self {
        Self { reader, path: String::new(), span: 0..0, entries }
    }

    /// A table that is not there: empty.
    pub fn empty(&self, key: &str) -> Self {
        static NONE: LazyLock<DeTable<'static>> = LazyLock::new(DeTable::default);
        Self { reader: self.reader, path: self.path_of(key), span: 0..0, entries: &NONE }
    }

    /// Notes every key that is none of `known`.
    pub fn only(&self, known: &[&str]) {
        for key in self.entries.keys() {
            if !known.contains(&&**key.get_ref()) {
                let (span, name) = (key.span(), self.path_of(key.get_ref()));
                self.reader.tell(span, &name, format!("unknown key; {}", expected_of(key.get_ref(), known)));
            }
        }
    }

    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }

    pub fn get(&self, key: &str) -> Option<Item<'r, 't>> {
        let (_, value) = self.entries.iter().find(|(name, _)| &**name.get_ref() == key)?;
        Some(Item { reader: self.reader, path: self.path_of(key), span: value.span(), value: value.get_ref() })
    }

    /// Notes it if the key is not there.
    pub fn required(&self, key: &str, what: &str) -> Option<Item<'r, 't>> {
        let item = self.get(key);
        if item.is_none() {
            self.reader.tell(self.span.clone(), &self.path_of(key), format!("missing; expected {what}"));
        }
        item
    }

    /// The tables under a key: one, an array of them, or none.
    pub fn tables(&self, key: &str) -> Vec<Table<'r, 't>> {
        let Some(item) = self.get(key) else { return Vec::new() };
        match item.value {
            DeValue::Array(tables) => {
                let tables =
                    tables.iter().map(|table| Item { span: table.span(), value: table.get_ref(), ..item.clone() });
                tables.filter_map(|item| item.table()).collect()
            }
            _ => item.table().into_iter().collect(),
        }
    }

    /// Notes a problem of the table as a whole.
    pub fn refuse(&self, message: impl Into<String>) {
        self.reader.tell(self.span.clone(), &self.path, message.into());
    }

    pub fn line(&self) -> usize {
        self.reader.place(self.span.clone()).line
    }
}

impl Clone for Item<'_, '_> {
    fn clone(&self) -> Self {
        Self { reader: self.reader, path: self.path.clone(), span: self.span.clone(), value: self.value }
    }
}

impl<'r, 't> Item<'r, 't> {
    /// Notes a problem of this value.
    pub fn refuse<V>(&self, message: impl Into<String>) -> Option<V> {
        self.reader.tell(self.span.clone(), &self.path, message.into());
        None
    }

    /// Notes a problem of what this value names, elsewhere.
    pub fn refuse_at(&self, place: Place, message: String) {
        self.reader.tell_at(place, &self.path, message);
    }

    pub fn place(&self) -> Place {
        self.reader.place(self.span.clone())
    }

    /// The name of the scene's file.
    pub fn scene(&self) -> &'r str {
        self.reader.file
    }

    /// The text of a file that the scene names.
    pub fn file(&self, path: &str) -> io::Result<String> {
        (self.reader.files)(path)
    }

    fn expected<V>(&self, what: &str) -> Option<V> {
        self.refuse(format!("found {}; expected {what}", self.value.type_str()))
    }

    pub fn table(&self) -> Option<Table<'r, 't>> {
        match self.value {
            DeValue::Table(entries) => {
                Some(Table { reader: self.reader, path: self.path.clone(), span: self.span.clone(), entries })
            }
            _ => self.expected("a table"),
        }
    }

    pub fn text(&self, what: &str) -> Option<&'r str> {
        match self.value {
            DeValue::String(text) => Some(text),
            _ => self.expected(what),
        }
    }

    /// One of `choices`, by its name.
    pub fn choice<C: Copy>(&self, choices: &[(&str, C)]) -> Option<C> {
        let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let text = self.text(&format!("one of {}", names.join(", ")))?;
        match choices.iter().find(|(name, _)| *name == text) {
            Some((_, choice)) => Some(*choice),
            None => self.refuse(format!("found '{text}'; {}", expected_of(text, &names))),
        }
    }

    /// A finite number.
    pub fn number(&self) -> Option<f64> {
        let number = match self.value {
            DeValue::Float(number) => number.as_str().parse().ok(),
            DeValue::Integer(number) => i64::from_str_radix(number.as_str(), number.radix()).ok().map(|n| n as f64),
            _ => return self.expected("a number"),
        };
        match number {
            Some(number) if f64::is_finite(number) => Some(number),
            _ => self.refuse(format!("found {}; expected a finite number", &self.reader.text[self.span.clone()])),
        }
    }

    pub fn positive(&self) -> Option<f64> {
        let number = self.number()?;
        if number > 0.0 { Some(number) } else { self.refuse(format!("found {number}; expected a number above 0")) }
    }

    pub fn not_negative(&self) -> Option<f64> {
        let number = self.number()?;
        if number >= 0.0 { Some(number) } else { self.refuse(format!("found {number}; expected no negative number")) }
    }

    /// Increasing times, one at least.
    pub fn times(&self) -> Option<Vec<f64>> {
        let times = self.list("increasing times, s")?;
        if times.is_empty() || times.windows(2).any(|pair| pair[0] >= pair[1]) {
            return self.refuse(format!("found {times:?}; expected times that increase, one at least"));
        }
        Some(times)
    }

    /// The number of the link with this name.
    pub fn link(&self, model: &Model) -> Option<usize> {
        let names = model.links().iter().map(|link| link.name.as_str());
        self.name(&names.collect::<Vec<_>>(), "the name of a link")
    }

    /// The number of the coordinate with this name.
    pub fn coordinate(&self, model: &Model) -> Option<usize> {
        let names = model.coordinates().iter().map(|coordinate| coordinate.name.as_str());
        self.name(&names.collect::<Vec<_>>(), "the name of a coordinate")
    }

    /// The place of this text among `names`.
    fn name(&self, names: &[&str], what: &str) -> Option<usize> {
        let text = self.text(what)?;
        let place = names.iter().position(|name| *name == text);
        place.or_else(|| self.refuse(format!("found '{text}'; {}", expected_of(text, names))))
    }

    /// A list of `N` finite numbers.
    pub fn numbers<const N: usize>(&self, what: &str) -> Option<[f64; N]> {
        let list = self.list(what)?;
        let count = list.len();
        <[f64; N]>::try_from(list).ok().or_else(|| self.refuse(format!("found {count} numbers; expected {N}: {what}")))
    }

    /// Whether this is a list of lists.
    pub fn is_nested(&self) -> bool {
        matches!(self.value, DeValue::Array(entries) if entries.iter().any(|entry| matches!(entry.get_ref(), DeValue::Array(_))))
    }

    /// The entries of a list.
    pub fn items(&self, what: &str) -> Option<Vec<Self>> {
        let DeValue::Array(entries) = self.value else { return self.expected(what) };
        Some(entries.iter().map(|entry| Item { span: entry.span(), value: entry.get_ref(), ..self.clone() }).collect())
    }

    /// Finite numbers.
    pub fn list(&self, what: &str) -> Option<Vec<f64>> {
        // Every entry is read, so that all problems are told.
        self.items(what)?.iter().map(Item::number).collect::<Vec<_>>().into_iter().collect()
    }

    /// One number per coordinate: a list, or a table by name in which what is not named is 0.
    pub fn coordinates(&self, model: &Model) -> Option<Vec<f64>> {
        let names: Vec<&str> = model.coordinates().iter().map(|coordinate| coordinate.name.as_str()).collect();
        let DeValue::Table(_) = self.value else {
            let list = self.list("a list of numbers, or a table of coordinates and numbers")?;
            let count = list.len();
            return Some(list).filter(|_| count == names.len()).or_else(|| {
                self.refuse(format!(
                    "found {count} numbers; expected {}, one for each of {}",
                    names.len(),
                    names.join(", ")
                ))
            });
        };
        let table = self.table()?;
        table.only(&names);
        let each = names.iter().map(|name| table.get(name).map_or(Some(0.0), |item| item.number()));
        each.collect::<Vec<_>>().into_iter().collect()
    }

    /// [`coordinates`](Self::coordinates), or one number for all; none of them negative.
    pub fn gains(&self, model: &Model) -> Option<Vec<f64>> {
        let gains = match self.value {
            DeValue::Float(_) | DeValue::Integer(_) => vec![self.number()?; model.dof()],
            _ => self.coordinates(model)?,
        };
        match gains.iter().find(|gain| **gain < 0.0) {
            Some(gain) => self.refuse(format!("found {gain}; expected no negative number")),
            None => Some(gains),
        }
    }
}

/// What would have been right, and which of it is nearest.
fn expected_of(word: &str, known: &[&str]) -> String {
    /// Words that differ by more than this share of their letters are different words.
    const NEAR: f64 = 0.5;
    let nearest = known
        .iter()
        .map(|known| (strsim::normalized_damerau_levenshtein(word, known), known))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(near, _)| *near > NEAR);
    let list = known.join(", ");
    match nearest {
        Some((_, near)) => format!("did you mean '{near}'? expected one of {list}"),
        None => format!("expected one of {list}"),
    }
}
