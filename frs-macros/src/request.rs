//! What a user asks of `frs_model!`, with the place of every word.

use frs_codegen::{Form, GenerateError, Lanes, Momentum, Options, Precision, module_name};
use frs_core::Quantity;
use frs_core::model::SpecialiseError;
use proc_macro2::{Span, TokenStream};
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Ident, LitStr, Token, Visibility, bracketed, parse_quote};

use crate::setting::{Setting, settings};

/// Each key, what it expects, and how it is written.
const KEYS: [(&str, &str, &str); 11] = [
    ("root", "the name of a link in quotes", r#"root = "base""#),
    ("outputs", "names of quantities", "outputs(inertia, d_mu, b2)"),
    ("links", "names of links", r#"links("tool0", "camera")"#),
    ("momentum", "zero, conserved or driven", "momentum = conserved"),
    ("gravity", "on or off", "gravity = off"),
    ("lock", "coordinates, each with a number (rad, m)", r#"lock(elbow = 1.2, "joint 3" = -0.5)"#),
    ("payload", "the name of a link in quotes", r#"payload = "gripper""#),
    ("lanes", "1, 4, 8 or 16", "lanes = 8"),
    ("form", "auto, unrolled, hybrid or tabled", "form = hybrid"),
    ("scalar", "f64 or f32", "scalar = f32"),
    ("lenient", "true or false", "lenient = true"),
];

/// A robot to generate.
pub struct Request {
    /// The path of `frs`.
    pub core: TokenStream,
    /// Attributes of the module.
    pub attributes: Vec<Attribute>,
    /// Visibility of the module.
    pub visibility: Visibility,
    /// Name of the module.
    pub name: Ident,
    /// The URDF, relative to the directory of `Cargo.toml`.
    pub path: LitStr,
    /// The link to take as base.
    pub root: Option<LitStr>,
    /// Whether rotational inertias that violate the triangle inequality are forgiven.
    pub lenient: bool,
    /// What to generate.
    pub options: Options,
    /// What is wrong so far.
    pub errors: Vec<syn::Error>,
    /// Where each key has its value, and each name in its list.
    places: Vec<(String, Option<String>, Span)>,
}

impl Parse for Request {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let core;
        bracketed!(core in input);
        let core = core.parse()?;
        if input.is_empty() {
            return Err(syn::Error::new(
                Span::call_site(),
                r#"frs_model!: nothing is given; expected a URDF; write frs_model!("robot.urdf")"#,
            ));
        }
        let (attributes, visibility, name, path) = module(input)?;
        let mut request = Self {
            core,
            attributes,
            visibility,
            name,
            path,
            root: None,
            lenient: false,
            options: Options { form: Form::Auto, ..Options::default() },
            errors: Vec::new(),
            places: Vec::new(),
        };
        if !input.is_empty() && input.parse::<Token![,]>().is_err() {
            request
                .error(input.span(), "settings: they follow the file at once; expected a comma; put one before this");
        }
        for setting in settings(input, &mut request.errors) {
            request.set(&setting);
        }
        Ok(request)
    }
}

/// The module and its file: `"arm.urdf"` or `pub mod arm = "arm.urdf"`.
fn module(input: ParseStream<'_>) -> syn::Result<(Vec<Attribute>, Visibility, Ident, LitStr)> {
    if input.peek(LitStr) {
        let path: LitStr = input.parse()?;
        let name = Ident::new(&module_name(&stem(&path.value())), path.span());
        return Ok((Vec::new(), parse_quote!(pub), name, path));
    }
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility = input.parse()?;
    let named = input.parse::<Token![mod]>().and_then(|_| input.parse::<Ident>());
    let name = named.map_err(|error| {
        let message =
            r#"frs_model!: no module is named; expected a URDF in quotes or a module; write mod arm = "arm.urdf""#;
        syn::Error::new(error.span(), message)
    })?;
    let path = input.parse::<Token![=]>().and_then(|_| input.parse::<LitStr>());
    let path = path.map_err(|error| {
        let span = if input.is_empty() { name.span() } else { error.span() };
        let message =
            format!(r#"module '{name}': no file is given; expected a URDF; write mod {name} = "{name}.urdf""#);
        syn::Error::new(span, message)
    })?;
    Ok((attributes, visibility, name, path))
}

impl Request {
    /// Notes that something is wrong.
    pub fn error(&mut self, span: Span, message: impl std::fmt::Display) {
        self.errors.push(syn::Error::new(span, message));
    }

    fn set(&mut self, setting: &Setting) {
        let key = setting.key.as_str();
        let Some(&(_, expected, written)) = KEYS.iter().find(|(known, ..)| *known == key) else {
            let (known, nearest) = nearest(key, KEYS.map(|(known, ..)| known));
            let hint = nearest.map_or_else(|| "correct it".into(), |nearest| format!("did you mean {nearest}?"));
            return self
                .error(setting.span, format!("key '{key}': there is no such key; expected one of {known}; {hint}"));
        };
        if self.span(key, None).is_some() {
            return self
                .error(setting.span, format!("key '{key}': given twice; expected once; take one of the two away"));
        }
        self.places.push((key.into(), None, setting.value_span()));
        let options = &mut self.options;
        let understood = match key {
            "root" => setting.text().map(|link| self.root = Some(link)),
            "lenient" => setting.word(&[("true", true), ("false", false)]).map(|lenient| self.lenient = lenient),
            "momentum" => setting
                .word(&[("zero", Momentum::Zero), ("conserved", Momentum::Conserved), ("driven", Momentum::Driven)])
                .map(|momentum| options.momentum = momentum),
            "gravity" => setting.word(&[("off", true), ("on", false)]).map(|without| options.without_gravity = without),
            "payload" => setting.text().map(|link| options.payload = Some(link.value())),
            "lanes" => setting
                .word(&[("1", Lanes::One), ("4", Lanes::Four), ("8", Lanes::Eight), ("16", Lanes::Sixteen)])
                .map(|lanes| options.lanes = lanes),
            "form" => {
                let forms = [
                    ("auto", Form::Auto),
                    ("unrolled", Form::Unrolled),
                    ("hybrid", Form::Hybrid),
                    ("tabled", Form::Tabled),
                ];
                setting.word(&forms).map(|form| options.form = form)
            }
            "scalar" => setting
                .word(&[("f64", Precision::Double), ("f32", Precision::Single)])
                .map(|precision| options.precision = precision),
            _ => setting.list().map(|items| self.set_list(key, items, expected, written)),
        };
        if understood.is_none() {
            let found = setting.found();
            self.error(setting.value_span(), format!("key '{key}': {found}; expected {expected}; write {written}"));
        }
    }

    fn set_list(&mut self, key: &str, items: &[Setting], expected: &str, written: &str) {
        let (mut outputs, mut links) = (Vec::new(), Vec::new());
        for item in items {
            let name = item.key.as_str();
            if self.span(key, Some(name)).is_some() {
                let message = format!("key '{key}': '{name}' is given twice; expected once; take one of the two away");
                self.error(item.span, message);
                continue;
            }
            self.places.push((key.into(), Some(name.into()), item.span));
            match (key, item.is_bare(), item.number()) {
                ("lock", _, Some(value)) => self.options.locked.push((name.into(), value)),
                ("links", true, _) => links.push(name.into()),
                ("outputs", true, _) => outputs.extend(self.output(name, item.span)),
                _ => {
                    let (found, span) = (item.found(), item.value_span());
                    self.error(span, format!("key '{key}': '{name}': {found}; expected {expected}; write {written}"));
                }
            }
        }
        match key {
            "outputs" => self.options.outputs = Some(outputs),
            "links" => self.options.links = Some(links),
            _ => {}
        }
    }

    /// The quantity of a name; of an unknown one, that which was meant.
    fn output(&mut self, name: &str, span: Span) -> Option<Quantity> {
        let quantities = || Quantity::ALL.into_iter().chain([Quantity::Kinematics(0)]);
        let named = |name: &str| quantities().find(|quantity| quantity.name() == name);
        let exact = named(name);
        if exact.is_some() {
            return exact;
        }
        let (known, nearest) = nearest(name, quantities().map(Quantity::name));
        let hint = nearest.map_or_else(|| "correct it".into(), |nearest| format!("did you mean {nearest}?"));
        self.error(span, format!("output '{name}': there is no such quantity; expected one of {known}; {hint}"));
        nearest.and_then(named)
    }

    /// Where a key's value stands, or `name` in its list.
    fn span(&self, key: &str, name: Option<&str>) -> Option<Span> {
        self.places.iter().find(|place| place.0 == key && place.1.as_deref() == name).map(|place| place.2)
    }

    /// Notes why the robot cannot be generated, and takes away what stands against it.
    pub fn take_away(&mut self, error: &GenerateError) {
        let options = &mut self.options;
        let (key, name) = match error {
            GenerateError::Excluded { output, .. } => {
                options.outputs.iter_mut().for_each(|outputs| outputs.retain(|quantity| quantity.name() != *output));
                ("outputs", Some(*output))
            }
            GenerateError::UnknownLink { link, .. } => {
                options.links.iter_mut().for_each(|links| links.retain(|known| known != link));
                ("links", Some(link.as_str()))
            }
            GenerateError::Lanes { .. } => {
                options.lanes = Lanes::One;
                ("lanes", None)
            }
            GenerateError::Form { .. } => {
                options.form = Form::Auto;
                ("form", None)
            }
            GenerateError::TooLarge { .. } => {
                // Held values may be it, and the numbers of a robot fit into doubles.
                options.locked.clear();
                options.precision = Precision::Double;
                ("scalar", None)
            }
            GenerateError::Specialise(SpecialiseError::UnknownLink { .. }) => {
                options.payload = None;
                ("payload", None)
            }
            GenerateError::Specialise(SpecialiseError::NothingFree) => {
                options.locked.clear();
                ("lock", None)
            }
            GenerateError::Specialise(
                SpecialiseError::UnknownCoordinate { name, .. } | SpecialiseError::HeldTwice { name },
            ) => {
                options.locked.retain(|(known, _)| known != name);
                ("lock", Some(name.as_str()))
            }
        };
        let span = self.span(key, name).unwrap_or_else(|| self.path.span());
        self.error(span, error);
    }
}

/// All `known` words, and the one that `word` may have been meant to be.
fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> (String, Option<&'k str>) {
    let known: Vec<&str> = known.into_iter().collect();
    let distance = |known: &str| strsim::damerau_levenshtein(word, known);
    let nearest = known.iter().copied().min_by_key(|known| distance(known));
    // At most a third of the letters wrong, or it is another word.
    (known.join(", "), nearest.filter(|known| 3 * distance(known) <= word.chars().count().max(3)))
}

/// A path's last part without its ending.
pub fn stem(path: &str) -> String {
    std::path::Path::new(path).file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned())
}
