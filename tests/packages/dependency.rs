//! Dependencies between the packages, and a dependent of the tracer outside the workspace.

use eightfold_stage::succeed;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Returns the folder of the packed crate and its dependent. Compiled files stay for the next run.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("dependency")
}

fn cargo(directory: impl AsRef<Path>, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO"));
    let command = command.current_dir(directory).args(arguments);
    succeed(command.env("CARGO_TARGET_DIR", folder().join("target")))
}

fn package() -> PathBuf {
    let package = ["package", "--package", "eightfold-tracer", "--offline"];
    cargo(ROOT, &[&package[..], &["--allow-dirty", "--no-verify"]].concat());
    let name = concat!("eightfold-tracer-", env!("CARGO_PKG_VERSION"));
    let archive = folder().join(format!("target/package/{name}.crate"));
    succeed(Command::new("tar").arg("-xzf").arg(archive).arg("-C").arg(folder()));
    folder().join(name)
}

/// A crate with the README's example, whose test runs on a thread of 2 MiB.
const DEPENDENT: &str = r##"
#![doc = include_str!("README.md")]

#[cfg(test)]
mod tests {
    use eightfold_tracer::scene::Scene;
    use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};

    #[test]
    fn a_frame_is_drawn() {
        let mut drawer = Some((Renderer::detect(), ScopedThreads::new()));
        let (renderer, threads) = drawer.as_mut().unwrap();
        let mut pixels = [0; 64 * 48];
        let frame = Frame::new(64, 48, &mut pixels);
        let scene = Scene { background: [1.0; 3].into(), ..Scene::default() };
        renderer.render(&scene, &Quality::DEFAULT, frame, threads).unwrap();
        assert_ne!(pixels, [0; 64 * 48]);
    }
}
"##;

/// The default profile is unoptimised: large values would overflow the stack.
#[test]
#[ignore = "libraries are compiled elsewhere"]
fn dependent_without_optimisation_draws() {
    let package = package();
    for file in ["README.md", "LICENSE-APACHE", "LICENSE-MIT"] {
        assert!(package.join(file).exists(), "{file}");
    }
    let dependent = folder().join("dependent");
    fs::create_dir_all(dependent.join("src")).expect("a folder");
    let manifest = format!(
        "[package]\nname = \"dependent\"\nedition = \"2024\"\n\n[workspace]\n\n\
         [dependencies]\neightfold-tracer.path = {package:?}\n",
    );
    fs::write(dependent.join("Cargo.toml"), manifest).expect("it is written");
    fs::write(dependent.join("src/lib.rs"), DEPENDENT).expect("it is written");
    let copy = |from: PathBuf, to: &str| fs::copy(from, dependent.join(to)).expect("it is copied");
    copy(package.join("README.md"), "src/README.md");
    copy(Path::new(ROOT).join("Cargo.lock"), "Cargo.lock");

    let said = cargo(&dependent, &["test", "--offline"]);
    assert_eq!(said.matches("... ok").count(), 2, "{said}");
    let tree = "tree --edges normal --prefix none --no-dedupe --format {lib}";
    let tree = cargo(&dependent, &tree.split(' ').collect::<Vec<_>>());
    let crates: BTreeSet<&str> = tree.lines().collect();
    let expected = "dependent eightfold_tracer fearless_simd glam libm";
    assert!(crates.into_iter().eq(expected.split(' ')), "{tree}");
}

/// No package depends on the lab, so tests of pictures compile without its dependencies.
#[test]
fn products_depend_on_neither_tests_nor_the_lab() {
    let metadata = cargo(ROOT, &["metadata", "--no-deps", "--offline", "--format-version", "1"]);
    let metadata: Value = serde_json::from_str(&metadata).expect("JSON");
    let is_in_tests = |path: &Value| {
        path.as_str().is_some_and(|path| Path::new(path).starts_with(Path::new(ROOT).join("tests")))
    };
    let mut count = 0;
    for package in metadata["packages"].as_array().expect("a list") {
        let is_test = is_in_tests(&package["manifest_path"]);
        for needed in package["dependencies"].as_array().expect("a list") {
            let (from, to) = (&package["name"], &needed["name"]);
            let is_allowed = is_test || needed["kind"] == "dev" || !is_in_tests(&needed["path"]);
            assert!(is_allowed && to != "eightfold-lab", "{from} depends on {to}");
            count += usize::from(needed["path"].is_string());
        }
    }
    assert!(count > 30, "{count} dependencies between packages");
}
