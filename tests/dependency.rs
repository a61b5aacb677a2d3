//! What depends on the tracer: a crate elsewhere, which needs nothing of the intro for it, and the intro and the lab, which have the same one.

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// The folder in which it is packed, unpacked and depended on. What was compiled there stays for the next run.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("dependency")
}

/// Runs a command, which has to succeed. Returns its standard output.
fn run(command: &mut Command) -> String {
    let output = command.output().expect("it starts");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {errors}");
    String::from_utf8(output.stdout).expect("text")
}

/// A command of cargo that compiles into [`folder`], in a directory.
fn cargo(directory: &Path) -> Command {
    let mut command = Command::new(env!("CARGO"));
    command
        .current_dir(directory)
        .env("CARGO_TARGET_DIR", folder().join("target"));
    command
}

/// Packs the tracer, and unpacks it. Returns where.
fn package(root: &Path) -> PathBuf {
    run(cargo(root)
        .args(["package", "--package", "eightfold-tracer", "--offline"])
        .args(["--allow-dirty", "--no-verify"]));
    let name = concat!("eightfold-tracer-", env!("CARGO_PKG_VERSION"));
    let archive = folder().join(format!("target/package/{name}.crate"));
    run(Command::new("tar")
        .arg("-xzf")
        .arg(archive)
        .arg("-C")
        .arg(folder()));
    folder().join(name)
}

/// Draws a frame.
const PROGRAM: &str = "
use eightfold_tracer::{Error, Frame, Level, Quality, Renderer, Worker, scene::Scene};

fn main() -> Result<(), Error> {
    let mut pixels = [0; 64 * 48];
    let frame = Frame::new(64, 48, &mut pixels);
    let mut renderer = Renderer::new(Level::baseline());
    renderer.render(&Scene::default(), &Quality::DEFAULT, frame, &mut Worker::new())?;
    Ok(())
}
";

#[test]
fn its_package_compiles_elsewhere_and_needs_vectors_and_functions_of_numbers_alone() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dependent = folder().join("dependent");
    fs::create_dir_all(dependent.join("src")).expect("a folder");
    let manifest = format!(
        "[package]\nname = \"dependent\"\nedition = \"2024\"\n\n\
         [dependencies]\neightfold-tracer.path = {:?}\n\n[workspace]\n",
        package(root)
    );
    fs::write(dependent.join("Cargo.toml"), manifest).expect("it is written");
    fs::write(dependent.join("src/main.rs"), PROGRAM).expect("it is written");
    // The same versions, which are downloaded already.
    fs::copy(root.join("Cargo.lock"), dependent.join("Cargo.lock")).expect("it is copied");

    run(cargo(&dependent).args(["check", "--offline"]));
    let tree = run(cargo(&dependent).args(["tree", "--prefix", "none", "--edges", "normal"]));
    let name = |line: &str| line.split(' ').next().expect("a name").to_owned();
    let crates: Vec<String> = tree.lines().map(name).collect();
    for name in &crates {
        let known = [
            "dependent",
            "eightfold-tracer",
            "fearless_simd",
            "glam",
            "libm",
        ];
        assert!(known.contains(&name.as_str()), "{crates:?}");
    }
    assert!(crates.len() > 3, "{crates:?}");
}

#[test]
fn its_package_has_sources_a_readme_and_licences() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = run(cargo(root)
        .args(["package", "--package", "eightfold-tracer", "--list"])
        .arg("--allow-dirty"));
    let (sources, others): (Vec<&str>, Vec<&str>) =
        list.lines().partition(|file| file.ends_with(".rs"));
    assert!(sources.len() > 50, "{list}");
    // Cargo's own: where it was packed, and the manifest as it was and as it is there.
    let others: Vec<&str> = others
        .into_iter()
        .filter(|file| !file.starts_with(['.', 'C']))
        .collect();
    assert_eq!(others, ["LICENSE-APACHE", "LICENSE-MIT", "README.md"]);
}

/// The libraries that a package's programs are linked with, each with its version and its features.
fn libraries(package: &str) -> BTreeSet<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let tree = run(cargo(root)
        .args(["tree", "--package", package, "--edges", "normal"])
        .args(["--prefix", "none", "--no-dedupe", "--format", "{p} {f}"]));
    tree.lines().map(String::from).collect()
}

#[test]
fn the_lab_measures_the_libraries_that_the_intro_is_linked_with() {
    // One profile builds both, so libraries of the same features are the same file.
    let (intro, lab) = (libraries("eightfold"), libraries("eightfold-lab"));
    assert!(intro.len() >= 6, "{intro:?}");
    assert!(intro.is_subset(&lab), "{:?}", intro.difference(&lab));
}
