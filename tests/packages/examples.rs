use eightfold_harness::cargo::Build;
use eightfold_stage::{DISPLAY, Server, ended, needs, reader::read_png, succeed, wait_for};
use std::{collections::BTreeSet, fs, path::Path, process::Command, sync::LazyLock};
use tempfile::TempDir;

fn example(name: &str) -> Command {
    static BUILD: LazyLock<Build> =
        LazyLock::new(|| Build::release("eightfold-examples").expect("they can be built"));
    Command::new(BUILD.program(name).expect("there is one"))
}

/// Returns the folder and the output. All files are inside `target`, which git ignores.
fn output(name: &str, arguments: &[&str]) -> (TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let text = succeed(example(name).args(arguments).current_dir(&folder));
    let written = fs::read_dir(&folder).expect("a folder");
    let names: Vec<_> = written.map(|entry| entry.expect("an entry").file_name()).collect();
    assert_eq!(names, ["target"]);
    (folder, text)
}

fn pixels(folder: &TempDir, name: &str) -> Vec<u32> {
    let (width, pixels) = read_png(&fs::read(folder.path().join(name)).expect("a file"));
    assert_eq!((width, pixels.len()), (640, 640 * 360));
    pixels
}

#[test]
#[ignore = "examples are compiled"]
fn turntable_turns_objects_under_a_blue_sky() {
    let (other, _) = output("turntable", &["target/a/b"]);
    let (folder, _) = output("turntable", &[]);
    let [first, last] = [0, 35].map(|number| {
        let name = format!("turntable-{number:02}.png");
        pixels(&other, &format!("target/a/b/{name}"));
        pixels(&folder, &format!("target/turntable/{name}"))
    });
    let [_, red, _, blue] = first[20 * 640 + 320].to_be_bytes();
    assert!(blue > red + 20, "the sky");
    let changed = first.iter().zip(&last).filter(|(first, last)| first != last);
    let count = changed.count();
    assert!((1000..100_000).contains(&count), "{count} pixels changed");
}

#[test]
#[ignore = "examples are compiled"]
fn squares_marks_less_than_half_of_the_picture() {
    let (folder, text) = output("squares", &[]);
    let count = text.trim_end_matches(" squares\n").parse::<usize>();
    let count = count.expect("a number");
    assert!((3600..20_000).contains(&count), "{count} squares");
    let pixels = pixels(&folder, "target/squares.png");
    let at = |[x, y]: [usize; 2]| pixels[y * 640 + x];
    let is_line = |place| at(place) > at([1, 1]);
    assert!([[8, 1], [1, 8], [8, 8], [16, 3]].into_iter().all(is_line));
    assert!(![[7, 1], [9, 9], [15, 7]].into_iter().any(is_line));
}

fn assert_shows(program: &mut Command, name: &str) {
    let server = Server::start(1280, 800);
    let program = server.open(program, || server.geometry(&["-name", name]));
    let place = server.geometry(&["-name", name]).expect("a window");
    wait_for("a picture", || {
        let colours: BTreeSet<u32> = server.screenshot(place).into_iter().collect();
        (colours.len() > 500).then_some(())
    });
    let [x, y, ..] = place;
    server.xdotool(&format!("mousemove {} {}", x + 20, y + 20));
    // minifb misses a key that is released before the program polls its keys.
    wait_for("the end", || {
        server.xdotool("keydown Escape sleep 0.1 keyup Escape");
        server.geometry(&["-name", name]).is_none().then_some(())
    });
    let (_, code, _, errors) = program.end();
    assert_eq!(code, Some(0), "{errors}");
}

#[test]
#[ignore = "examples are compiled"]
fn intro_shows_a_picture_until_esc() {
    needs!(DISPLAY);
    assert_shows(&mut example("intro"), "Ten seconds");
    let (code, _, errors) = ended(example("intro").env_remove("DISPLAY"));
    assert_eq!((code, &*errors), (Some(1), "intro: X display is missing\n"));
}

#[test]
#[ignore = "the libraries of minifb are compiled"]
fn window_shows_a_picture_until_esc() {
    needs!(DISPLAY);
    let mut git = Command::new("git");
    let git = git.current_dir(env!("CARGO_MANIFEST_DIR"));
    succeed(git.args(["check-ignore", "examples/window/target"]));
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("window");
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["build", "--release", "--locked"]);
    cargo.current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/window"));
    succeed(cargo.env("CARGO_TARGET_DIR", &target));
    assert_shows(&mut Command::new(target.join("release/window")), "Ring");
}
