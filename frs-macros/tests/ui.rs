//! What users of `frs_model!` see when they ask for what cannot be had.

use std::fs;
use std::path::Path;

#[test]
fn every_complaint_stands_on_the_word_it_is_about() {
    let here = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/ui");
    // The cases are compiled as a crate of their own, and paths to URDFs are relative to it.
    let there = Path::new(env!("CARGO_TARGET_TMPDIR")).with_file_name("tests").join("trybuild/frs-macros");
    fs::create_dir_all(&there).unwrap();
    for urdf in ["arm.urdf", "broken.urdf"] {
        fs::copy(here.join(urdf), there.join(urdf)).unwrap();
    }
    let cases = trybuild::TestCases::new();
    cases.compile_fail("tests/ui/refused/*.rs");
}
