//! What is measured is what ships: the lab and the intro link the same compiled library. `tests/image/shipped.rs` checks that the
//! tests' own build of the library, which unwinds, draws the same bits.

use eightfold_lab::cargo::Build;
use std::fs;

/// The bytes of the compiled library that a package's programs are linked with.
fn library(package: &str) -> Vec<u8> {
    let build = Build::release(package).expect("it can be built");
    let path = build.library("eightfold").expect("it has the library");
    fs::read(path).expect("the library can be read")
}

#[test]
fn the_lab_and_the_intro_link_the_same_compiled_library() {
    assert!(
        library("eightfold") == library("eightfold-lab"),
        "there are two libraries"
    );
}
