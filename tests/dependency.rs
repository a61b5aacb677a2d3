//! The tracer compiles as a dependency of a crate in another workspace, and needs nothing of the intro.

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// A crate that depends on the tracer by its path.
struct Dependent {
    folder: tempfile::TempDir,
}

impl Dependent {
    /// Makes the crate.
    fn new() -> Dependent {
        let folder = tempfile::tempdir().expect("a folder");
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let manifest = format!(
            "[package]\nname = \"dependent\"\nedition = \"2024\"\n\n\
             [dependencies]\neightfold-tracer.path = {:?}\n\n[workspace]\n",
            root.join("src/tracer")
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
use eightfold_tracer::{Error, Frame, Level, Quality, Renderer, Worker, scene::Scene};

fn main() -> Result<(), Error> {
    let mut pixels = [0; 64 * 48];
    let frame = Frame { width: 64, height: 48, pixels: &mut pixels };
    let mut renderer = Renderer::new(Level::baseline());
    renderer.render(&Scene::default(), &Quality::DEFAULT, frame, &mut Worker::new())?;
    Ok(())
}
";

#[test]
fn it_needs_vectors_and_functions_of_numbers_alone() {
    let dependent = Dependent::new();
    dependent.cargo(&["check", "--offline"]);
    let crates = dependent.crates();
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
