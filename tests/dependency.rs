//! Dependents of the tracer: a crate elsewhere, which needs nothing of the intro for it, and the intro and the lab, which have the
//! same one.

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

/// Draws the frame of a scene that has been text.
const PROGRAM: &str = r##"
use eightfold_tracer::{Frame, Level, Quality, Renderer, Worker, scene::Scene};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut scene = Scene::default();
    let letters = "ABC".as_bytes().try_into()?;
    scene.captions.push(eightfold_tracer::scene::Caption { letters, ..Default::default() });
    scene.blocks.push(Default::default());
    scene.lights.push(eightfold_tracer::scene::Light { spot: Some(Default::default()), ..Default::default() });
    let text = ron::to_string(&scene)?;
    assert!(text.contains(r#"letters:"ABC""#), "{text}");
    assert_eq!(ron::from_str::<Scene>(&text)?, scene);
    assert_eq!(ron::from_str::<Scene>("()")?, Scene::default());
    let refused = |text: &str| ron::from_str::<Scene>(text).unwrap_err().to_string();
    assert!(refused("(sphere: [])").contains("sphere"));
    let captions = format!("(captions: [{}])", ["()"; 11].join(","));
    assert!(refused(&captions).contains("at most 10 items"));
    let long = format!(r#"(captions: [(letters: "{}")])"#, "A".repeat(33));
    assert!(refused(&long).contains("at most 32 letters"));
    let quality = ron::to_string(&Quality::DEFAULT)?;
    assert_eq!(ron::from_str::<Quality>(&quality)?, Quality::DEFAULT);

    let mut pixels = [0; 64 * 48];
    let frame = Frame::new(64, 48, &mut pixels);
    let mut renderer = Renderer::new(Level::baseline());
    renderer.render(&Scene::default(), &Quality::DEFAULT, frame, &mut Worker::new())?;
    Ok(())
}
"##;

/// The documentation in a file of the package, as that of a module: of code its comments alone, line by line.
fn documentation(file: &Path) -> String {
    let text = fs::read_to_string(file).expect("text");
    if file.extension().is_some_and(|end| end == "md") {
        return text.lines().map(|line| format!("//! {line}\n")).collect();
    }
    let words = |line: &str| {
        let line = line.trim_start();
        let words = line.strip_prefix("//!").or(line.strip_prefix("///"));
        words.map_or("\n".into(), |words| format!("//!{words}\n"))
    };
    text.lines().map(words).collect()
}

/// The files of the package with examples in their documentation.
fn files_with_examples(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let mut files = Vec::new();
    for entry in entries {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(files_with_examples(&path));
        } else if path
            .extension()
            .is_some_and(|end| end == "rs" || end == "md")
            && documentation(&path).contains("```")
        {
            files.push(path);
        }
    }
    files
}

#[test]
#[ignore = "libraries are compiled elsewhere"]
fn its_package_and_its_examples_compile_elsewhere_and_need_vectors_and_functions_of_numbers_alone()
{
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dependent = folder().join("dependent");
    fs::create_dir_all(dependent.join("src")).expect("a folder");
    let package = package(root);
    // Optimised as little as it may be, which compiles fast.
    let manifest = format!(
        "[package]\nname = \"dependent\"\nedition = \"2024\"\n\n\
         [features]\nserde = [\"dep:ron\", \"eightfold-tracer/serde\"]\n\n\
         [dependencies]\neightfold-tracer.path = {package:?}\n\
         ron = {{ version = \"0.12\", optional = true }}\n\n[workspace]\n\n\
         [profile.dev]\nopt-level = 1\ndebug = false\n",
    );
    fs::write(dependent.join("Cargo.toml"), manifest).expect("it is written");
    fs::write(dependent.join("src/main.rs"), PROGRAM).expect("it is written");
    // The same versions, which are downloaded already.
    fs::copy(root.join("Cargo.lock"), dependent.join("Cargo.lock")).expect("it is copied");

    let mut modules = String::new();
    for (number, file) in files_with_examples(&package).iter().enumerate() {
        let module = format!("from_{number}");
        fs::write(
            dependent.join(format!("src/{module}.rs")),
            documentation(file),
        )
        .expect("it is written");
        modules += &format!("pub mod {module};\n");
    }
    fs::write(dependent.join("src/lib.rs"), modules).expect("it is written");

    let serde = ["--offline", "--features", "serde"];
    run(cargo(&dependent).arg("run").args(serde));
    let said = run(cargo(&dependent).args(["test", "--doc"]).args(serde));
    assert!(said.matches("... ok").count() > 5, "{said}");
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
