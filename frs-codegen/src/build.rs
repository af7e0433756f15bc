//! For build scripts: a URDF becomes a module in `OUT_DIR`.

use std::env;
use std::path::{Path, PathBuf};

use frs_core::{Model, urdf};
use proc_macro2::TokenStream;

use crate::{Form, Options, fresh, generate_on, module_name};

/// Why a build script could not generate a robot.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// A file cannot be read or written.
    #[error("{}: {error}; the path is relative to the package's folder", path.display())]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// The URDF is no robot.
    #[error(transparent)]
    Urdf(#[from] urdf::UrdfError),
    /// The robot cannot be generated as asked.
    #[error(transparent)]
    Generate(#[from] crate::GenerateError),
    /// It was not called from a build script.
    #[error("OUT_DIR is not set; call this from build.rs")]
    NoBuildScript,
}

/// Generates the robot of a URDF, everything, standing on the façade crate `frs`, into `OUT_DIR/<file stem>.rs`.
///
/// In build.rs: `frs_codegen::build::generate("robots/arm.urdf")?;`, in the crate:
/// `pub mod arm { include!(concat!(env!("OUT_DIR"), "/arm.rs")); }`. Returns the path of the file.
///
/// # Errors
/// All that is wrong with the file, with line and column.
pub fn generate(path: impl AsRef<Path>) -> Result<PathBuf, BuildError> {
    generate_with(path, &urdf::Options::default(), &Options { form: Form::Auto, ..Options::default() })
}

/// [`generate`], with options; the file's name in `reading` is replaced by `path`.
///
/// # Errors
/// As [`generate`].
pub fn generate_with(
    path: impl AsRef<Path>,
    reading: &urdf::Options<'_>,
    options: &Options,
) -> Result<PathBuf, BuildError> {
    let path = path.as_ref();
    println!("cargo::rerun-if-changed={}", path.display());
    let at = |path: &Path, error| BuildError::File { path: path.to_owned(), error };
    let text = std::fs::read_to_string(path).map_err(|error| at(path, error))?;
    let file = path.display().to_string();
    let model = Model::from_urdf_with(&text, &urdf::Options { file: &file, ..*reading })?;
    for warning in model.warnings() {
        println!("cargo::warning={warning}");
    }
    let core: TokenStream = quote::quote!(::frs);
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let folder = PathBuf::from(env::var_os("OUT_DIR").ok_or(BuildError::NoBuildScript)?);
    let target = folder.join(module_name(&stem)).with_extension("rs");
    let generated = generate_on(&model, options, &core, true)?;
    fresh::write(&target, &generated.included_text()).map_err(|error| at(&target, error))?;
    Ok(target)
}
