//! What is measured is what ships. That the tests' own build of the library, which unwinds, draws the same as well is held
//! by `tests/image/shipped.rs`.

use eightfold_lab::cargo::Build;
use std::path::PathBuf;

/// The compiled library that a package's programs are linked with.
fn library(package: &str) -> PathBuf {
    let build = Build::release(package).expect("it can be built");
    build.library("eightfold").expect("it has the library")
}

#[test]
fn the_lab_and_the_intro_link_the_same_compiled_library() {
    assert_eq!(library("eightfold"), library("eightfold-lab"));
}
