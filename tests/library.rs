//! Measurements are of what ships: the lab and the intro link the same compiled libraries. `tests/image/shipped.rs` checks that the
//! tests' own build of them, which unwinds, draws the same bits.

use eightfold_lab::cargo::Build;
use std::fs;

/// The bytes of the compiled tracer, and of the compiled show, that a package's programs are linked with.
fn libraries(package: &str) -> [Vec<u8>; 2] {
    let build = Build::release(package).expect("it can be built");
    ["eightfold_tracer", "eightfold"].map(|name| {
        let path = build.library(name).expect("it has the library");
        fs::read(path).expect("the library can be read")
    })
}

#[test]
fn the_lab_and_the_intro_link_the_same_compiled_libraries() {
    assert!(
        libraries("eightfold") == libraries("eightfold-lab"),
        "there are two builds of a library"
    );
}
