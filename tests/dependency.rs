//! The library compiles as a dependency of a crate in another workspace.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// A crate that depends on the library by its path.
struct Dependent {
    folder: tempfile::TempDir,
}

impl Dependent {
    /// Makes the crate. `features` is the part of its manifest about the dependency's features.
    fn new(features: &str) -> Dependent {
        let folder = tempfile::tempdir().expect("a folder");
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let manifest = format!(
            "[package]\nname = \"dependent\"\nedition = \"2024\"\n\n\
             [dependencies]\neightfold = {{ path = {root:?}, {features} }}\n\n[workspace]\n"
        );
        let files = [
            ("Cargo.toml", manifest.as_bytes()),
            ("src/main.rs", PROGRAM.as_bytes()),
            // The same versions, which are downloaded already.
            (
                "Cargo.lock",
                &fs::read(root.join("Cargo.lock")).expect("it is read"),
            ),
        ];
        fs::create_dir(folder.path().join("src")).expect("a folder");
        for (name, text) in files {
            fs::write(folder.path().join(name), text).expect("it is written");
        }
        Dependent { folder }
    }

    /// Runs cargo in the crate, which has to succeed. Returns its standard output.
    fn cargo(&self, arguments: &[&str]) -> String {
        // The folder is kept, so that only the first run compiles everything.
        let target = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("dependent");
        let output = Command::new(env!("CARGO"))
            .args(arguments)
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", target)
            .output()
            .expect("cargo runs");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "cargo {arguments:?}: {errors}");
        String::from_utf8(output.stdout).expect("text")
    }

    /// The names of the crates that are compiled for it, without the dependencies of build scripts.
    fn crates(&self) -> Vec<String> {
        let tree = self.cargo(&["tree", "--prefix", "none", "--edges", "normal"]);
        let name = |line: &str| line.split(' ').next().expect("a name").to_owned();
        tree.lines().map(name).collect()
    }
}

/// Draws a frame.
const PROGRAM: &str = "
use eightfold::{Error, Frame, Level, Quality, Renderer, Worker, show};

fn main() -> Result<(), Error> {
    let mut pixels = [0; 64 * 48];
    let frame = Frame { width: 64, height: 48, pixels: &mut pixels };
    let mut renderer = Renderer::new(Level::baseline());
    renderer.render(&show::scene(2.0), &Quality::DEFAULT, frame, &mut Worker::new())?;
    Ok(())
}
";

#[test]
fn without_the_intro_it_needs_no_crate_of_a_window() {
    let dependent = Dependent::new("default-features = false");
    dependent.cargo(&["check", "--offline"]);
    let crates = dependent.crates();
    assert!(crates.iter().any(|name| name == "eightfold"), "{crates:?}");
    for name in ["eightfold-window", "minifb", "libc"] {
        assert!(!crates.iter().any(|other| other == name), "{crates:?}");
    }
}

#[test]
fn with_default_features_it_has_the_crate_of_the_window() {
    let dependent = Dependent::new("features = []");
    dependent.cargo(&["check", "--offline"]);
    let crates = dependent.crates();
    let has = |wanted: &str| crates.iter().any(|name| name == wanted);
    assert!(has("eightfold-window"), "{crates:?}");
}
