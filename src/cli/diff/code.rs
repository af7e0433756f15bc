//! What changed between the generated codes of two robots.

use std::collections::{BTreeMap, HashMap};
use std::time::Duration;

use frs::{Model, Quantity};
use frs_codegen::{Counts, GenerateError, Options, generate, generate_on};
use proc_macro2::{TokenStream, TokenTree};
use serde::Serialize;
use similar::{ChangeTag, TextDiff};

/// After this long the line diff of a text is approximate: it may count more lines than have changed.
const PATIENCE: Duration = Duration::from_secs(5);

/// The generated code of a robot.
pub struct Code {
    text: String,
    functions: Vec<Function>,
}

/// A function with all that it stands on.
struct Function {
    name: String,
    /// The link, of those that belong to one.
    link: Option<String>,
    counts: Counts,
    tokens: Vec<Token>,
}

/// A word of code.
#[derive(PartialEq)]
enum Token {
    Name(String),
    Constant(String),
    Other(String),
}

/// What changed in the code.
pub struct CodeChanges {
    /// Each function that there was or is.
    pub functions: Vec<FunctionChange>,
    /// Lines that went and came in the text as a whole.
    pub lines: [usize; 2],
    /// Lines of the text, before and after.
    pub total_lines: [usize; 2],
}

/// What changed in a function and in what it stands on.
pub struct FunctionChange {
    /// Its name, the new one if it has two.
    pub name: String,
    /// What changed.
    pub change: Change,
    /// Operations before and after.
    pub counts: [Option<Counts>; 2],
}

/// How deep a change goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Nothing changed.
    Unchanged,
    /// The same operations on the same numbers under other names.
    Names,
    /// The same operations on other constants.
    Constants,
    /// Other operations.
    Structure,
    /// There was no such function.
    Added,
    /// There is no such function any more.
    Removed,
}

impl Change {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Unchanged => "unchanged",
            Self::Names => "only names",
            Self::Constants => "only constants",
            Self::Structure => "structure",
            Self::Added => "added",
            Self::Removed => "removed",
        }
    }
}

/// The code of a robot, as a whole and function by function.
pub fn functions(model: &Model, options: &Options) -> Result<Code, GenerateError> {
    let generated = generate(model, options)?;
    let functions = generated.functions.iter().map(|report| {
        let link = match report.quantity {
            Quantity::Kinematics(link) => Some(model.links()[link].name.clone()),
            _ => None,
        };
        let links = link.clone().map(|link| vec![link]).or_else(|| options.links.clone());
        let alone = Options { outputs: Some(vec![report.quantity]), links, ..options.clone() };
        let mut tokens = Vec::new();
        flatten(generate_on(model, &alone, &TokenStream::new(), false)?.items().clone(), &mut tokens);
        Ok(Function { name: report.name.clone(), link, counts: report.counts, tokens })
    });
    Ok(Code { functions: functions.collect::<Result<_, GenerateError>>()?, text: generated.text() })
}

/// Words in their order, without documentation.
fn flatten(stream: TokenStream, words: &mut Vec<Token>) {
    let mut trees = stream.into_iter().peekable();
    while let Some(tree) = trees.next() {
        match tree {
            TokenTree::Punct(punct) if punct.as_char() == '#' => {
                let documents =
                    |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.to_string().starts_with("[doc"));
                if trees.next_if(documents).is_none() {
                    words.push(Token::Other("#".into()));
                }
            }
            TokenTree::Punct(punct) => words.push(Token::Other(punct.as_char().into())),
            TokenTree::Ident(name) => words.push(Token::Name(name.to_string())),
            TokenTree::Literal(literal) => {
                let text = literal.to_string();
                // Whole numbers are indices and lengths.
                let constant = text.contains(['.', 'e']) && !text.starts_with('"');
                words.push(if constant { Token::Constant(text) } else { Token::Other(text) });
            }
            TokenTree::Group(group) => {
                words.push(Token::Other(format!("{:?}", group.delimiter())));
                flatten(group.stream(), words);
                words.push(Token::Other("end".into()));
            }
        }
    }
}

/// How far two functions differ.
fn change(old: &[Token], new: &[Token]) -> Change {
    if old == new {
        return Change::Unchanged;
    }
    let (mut forth, mut back) = (HashMap::new(), HashMap::new());
    let (mut names, mut constants) = (false, false);
    for pair in old.iter().zip(new) {
        match pair {
            (Token::Name(old), Token::Name(new)) => {
                names |= old != new;
                if *forth.entry(old).or_insert(new) != new || *back.entry(new).or_insert(old) != old {
                    return Change::Structure;
                }
            }
            (Token::Constant(old), Token::Constant(new)) => constants |= old != new,
            (Token::Other(old), Token::Other(new)) if old == new => {}
            // The names of coordinates are texts.
            (Token::Other(old), Token::Other(new)) if old.starts_with('"') && new.starts_with('"') => names = true,
            _ => return Change::Structure,
        }
    }
    match (old.len() == new.len(), constants, names) {
        (false, ..) => Change::Structure,
        (true, true, _) => Change::Constants,
        (true, false, _) => Change::Names,
    }
}

impl CodeChanges {
    /// What changed from `old` to `new`; functions of links that have got another name stay themselves.
    pub fn new(old: Code, new: Code, links: &BTreeMap<String, String>) -> Self {
        let stays = |before: &Function, after: &Function| match (&before.link, &after.link) {
            (Some(before), Some(after)) => links.get(before) == Some(after),
            (None, None) => before.name == after.name,
            _ => false,
        };
        let mut functions = Vec::new();
        for after in &new.functions {
            let before = old.functions.iter().find(|before| stays(before, after));
            functions.push(FunctionChange {
                name: after.name.clone(),
                change: before.map_or(Change::Added, |before| change(&before.tokens, &after.tokens)),
                counts: [before.map(|before| before.counts), Some(after.counts)],
            });
        }
        let gone = old.functions.iter().filter(|before| !new.functions.iter().any(|after| stays(before, after)));
        functions.extend(gone.map(|before| FunctionChange {
            name: before.name.clone(),
            change: Change::Removed,
            counts: [Some(before.counts), None],
        }));
        Self {
            functions,
            lines: lines(&old.text, &new.text),
            total_lines: [&old, &new].map(|code| code.text.lines().count()),
        }
    }

    /// How many functions changed so.
    pub fn count(&self, change: Change) -> usize {
        self.functions.iter().filter(|function| function.change == change).count()
    }
}

/// Lines that went and came.
fn lines(old: &str, new: &str) -> [usize; 2] {
    let diff = TextDiff::configure().timeout(PATIENCE).diff_lines(old, new);
    let count = |tag| diff.iter_all_changes().filter(|change| change.tag() == tag).count();
    [count(ChangeTag::Delete), count(ChangeTag::Insert)]
}
