//! Dependents of the tracer: a crate elsewhere, which needs nothing of the intro for it, and the intro and the lab, which have the
//! same one.

use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// The workspace.
const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// The folder in which the tracer is packed, unpacked and depended on. Compiled files stay there for the next run.
fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("dependency")
}

/// Runs a command, which has to succeed. Returns its standard output.
fn run(command: &mut Command) -> String {
    let output = command.output().expect("it starts");
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}: {text}{errors}");
    text
}

/// Runs cargo in a directory. It compiles into [`folder`].
fn cargo(directory: impl AsRef<Path>, arguments: &[&str]) -> String {
    let mut command = Command::new(env!("CARGO"));
    let command = command.current_dir(directory).args(arguments);
    run(command.env("CARGO_TARGET_DIR", folder().join("target")))
}

/// Packs the tracer, and unpacks it. Returns where.
fn package() -> PathBuf {
    let package = ["package", "--package", "eightfold-tracer", "--offline"];
    cargo(
        ROOT,
        &[&package[..], &["--allow-dirty", "--no-verify"]].concat(),
    );
    let name = concat!("eightfold-tracer-", env!("CARGO_PKG_VERSION"));
    let archive = folder().join(format!("target/package/{name}.crate"));
    run(Command::new("tar")
        .arg("-xzf")
        .arg(archive)
        .arg("-C")
        .arg(folder()));
    folder().join(name)
}

/// A crate with the README's example. Its tests run on threads of 2 MiB.
const DEPENDENT: &str = r##"
#![doc = include_str!("README.md")]

#[cfg(test)]
mod tests {
    use eightfold_tracer::scene::{Block, Caption, Light, Scene};
    use eightfold_tracer::{Frame, Quality, Renderer, ScopedThreads};

    fn scene() -> Scene {
        let mut scene = Scene::default();
        let letters = "ABC".as_bytes().try_into().unwrap();
        scene.captions.push(Caption { letters, ..Caption::default() });
        scene.blocks.push(Block::default());
        scene.lights.push(Light { spot: Some(Default::default()), ..Light::default() });
        scene
    }

    #[test]
    fn a_frame_is_drawn() {
        let mut drawer = Some((Renderer::detect(), ScopedThreads::new()));
        let (renderer, threads) = drawer.as_mut().unwrap();
        let mut scene = scene();
        scene.blocks.clear();
        scene.lights.clear();
        let mut pixels = [0; 64 * 48];
        let frame = Frame::new(64, 48, &mut pixels);
        renderer.render(&scene, &Quality::DEFAULT, frame, threads).unwrap();
        assert_ne!(pixels, [0; 64 * 48]);
    }

    #[test]
    fn a_scene_is_written_and_read() {
        let thread = std::thread::Builder::new().stack_size(8 << 20);
        thread.spawn(check_text).unwrap().join().unwrap();
    }

    fn check_text() {
        let text = ron::to_string(&scene()).unwrap();
        assert!(text.contains(r#"letters:"ABC""#), "{text}");
        assert_eq!(ron::from_str::<Scene>(&text).unwrap(), scene());
        assert_eq!(ron::from_str::<Scene>("()").unwrap(), Scene::default());
        let refused = |text: &str| ron::from_str::<Scene>(text).unwrap_err().to_string();
        assert!(refused("(sphere: [])").contains("sphere"));
        let captions = format!("(captions: [{}])", ["()"; 11].join(","));
        assert!(refused(&captions).contains("at most 10 items"));
        let long = format!(r#"(captions: [(letters: "{}")])"#, "A".repeat(33));
        assert!(refused(&long).contains("at most 32 letters"));
        let quality = ron::to_string(&Quality::DEFAULT).unwrap();
        assert_eq!(ron::from_str::<Quality>(&quality).unwrap(), Quality::DEFAULT);
    }
}
"##;

/// By the default profile, without optimisation: large values would overflow the stack.
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
         [dependencies]\neightfold-tracer.path = {package:?}\n\n\
         [features]\nserde = [\"dep:ron\", \"eightfold-tracer/serde\"]\n\n\
         [dependencies.ron]\nversion = \"0.12\"\noptional = true\n",
    );
    fs::write(dependent.join("Cargo.toml"), manifest).expect("it is written");
    fs::write(dependent.join("src/lib.rs"), DEPENDENT).expect("it is written");
    let copy = |from: PathBuf, to: &str| fs::copy(from, dependent.join(to)).expect("it is copied");
    copy(package.join("README.md"), "src/README.md");
    // The same versions, which are downloaded already.
    copy(Path::new(ROOT).join("Cargo.lock"), "Cargo.lock");

    let said = cargo(&dependent, &["test", "--offline", "--features", "serde"]);
    assert_eq!(said.matches("... ok").count(), 3, "{said}");
    let tree = [
        "tree", "--prefix", "none", "--edges", "normal", "--format", "{lib}",
    ];
    let crates: BTreeSet<String> = cargo(&dependent, &tree).lines().map(String::from).collect();
    let expected = [
        "dependent",
        "eightfold_tracer",
        "fearless_simd",
        "glam",
        "libm",
    ];
    assert!(crates.iter().eq(&expected), "{crates:?}");
}

/// The libraries that a package's programs are linked with, each with its version and its features.
fn libraries(package: &str) -> BTreeSet<String> {
    let tree = [
        "tree",
        "--package",
        package,
        "--edges",
        "normal,no-proc-macro",
        "--prefix",
        "none",
    ];
    let all = cargo(
        ROOT,
        &[&tree[..], &["--no-dedupe", "--format", "{p} {f}"]].concat(),
    );
    all.lines().map(String::from).collect()
}

/// One profile builds both, so libraries of the same features are the same file.
#[test]
fn lab_is_linked_with_the_libraries_of_the_intro() {
    let (intro, lab) = (libraries("eightfold"), libraries("eightfold-lab"));
    assert!(intro.len() >= 6, "{intro:?}");
    assert!(intro.is_subset(&lab), "{:?}", intro.difference(&lab));
}
