//! Pictures that are drawn in parts, by separate processes and on several machines, have the same bytes as those drawn in one go.

use super::capture::{self, files, write_program};
use super::{assert_one_line, command, printed, said};
use eightfold_stage::needs;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Output, Stdio};

/// A picture that takes long enough to be killed before it is drawn.
const TRUTH: &str = "truth --scene model --size 24x18 --samples 2048 --without caustics";

/// The lab in a folder.
fn lab_in(folder: &Path, line: &str) -> Command {
    let mut lab = command(line);
    lab.current_dir(folder);
    lab
}

#[track_caller]
fn run_in(folder: &Path, line: &str) -> Output {
    lab_in(folder, line).output().expect("the lab starts")
}

#[track_caller]
fn draw_in(folder: &Path, line: &str) {
    let output = run_in(folder, line);
    assert!(output.status.success(), "{line}: {}", said(&output));
}

#[test]
fn three_parts_of_a_truth_one_of_them_killed_and_run_again_are_the_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let read = |name: &str| fs::read(folder.join(name)).expect("a file");
    let part = |number| format!("{TRUTH} --out parts.png --part {number}/3");
    draw_in(folder, &part(3));
    let merge = "truth --merge parts.png.part-1-of-3 parts.png.part-2-of-3 parts.png.part-3-of-3";
    let merge = format!("{merge} --out parts.png --exr parts.exr --interval parts-interval.png");
    let early = run_in(folder, &merge);
    assert_one_line(&early, 1, &["cannot read parts.png.part-1-of-3"]);
    // Killed a little later each time, until it comes to its end before that.
    for pause in (0..).map(|run| 20 * run * run) {
        let mut killed = lab_in(folder, &part(2));
        let mut killed = killed
            .stderr(Stdio::null())
            .spawn()
            .expect("the lab starts");
        std::thread::sleep(std::time::Duration::from_millis(pause));
        // It may have ended.
        let _ = killed.kill();
        if killed.wait().expect("it ends").success() {
            break;
        }
    }
    draw_in(folder, &part(1));
    draw_in(folder, &merge);
    draw_in(
        folder,
        &format!("{TRUTH} --out whole.png --exr whole.exr --interval whole-interval.png"),
    );
    for name in [".png", ".exr", "-interval.png"] {
        let [parts, whole] = ["parts", "whole"].map(|of| read(&format!("{of}{name}")));
        assert!(parts == whole, "{name}");
    }
}

#[test]
fn parts_that_are_not_those_of_one_picture_are_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let draw = |more: &str| {
        let line = "truth --size 8x6 --without caustics --without indirect";
        draw_in(folder, &format!("{line} {more}"));
    };
    draw("--samples 8 --out a.png --part 1/2");
    draw("--samples 8 --out a.png --part 2/2");
    draw("--samples 8 --out a.png --part 2/3");
    draw("--samples 16 --out finer.png --part 2/2");
    draw("--samples 8 --seed 1 --out other.png --part 2/2");
    for (parts, words) in [
        ("a.png.part-1-of-2", "3 of 6 rows are in no part"),
        ("a.png.part-1-of-2 a.png.part-2-of-3", "the same rows"),
        ("a.png.part-1-of-2 a.png.part-1-of-2", "the same rows"),
        ("a.png.part-1-of-2 other.png.part-2-of-2", "another picture"),
        ("a.png.part-1-of-2 finer.png.part-2-of-2", "16 samples"),
    ] {
        let output = run_in(folder, &format!("truth --merge {parts} --out merged.png"));
        assert_one_line(&output, 1, &[words]);
    }
    assert!(!folder.join("merged.png").exists());
}

#[test]
fn the_recipes_for_many_machines_draw_the_whole() {
    needs!(&["parallel", "rsync"]);
    let page = include_str!("../../../../docs/lab.md");
    let (_, section) = page.split_once("\n## Many machines").expect("a section");
    let lines = section.lines().take_while(|line| !line.starts_with("## "));
    let recipes: Vec<&str> = lines.filter_map(|line| line.strip_prefix("    ")).collect();
    let recipes = recipes.join("\n").replace("\\\n", "");
    assert_eq!(recipes.lines().count(), 5, "{recipes}");
    let slurm = recipes.lines().find(|line| line.starts_with("sbatch"));
    assert!(printed("capture --help").contains(slurm.expect("a line")));
    // Little is drawn.
    let truth = "truth --scene examples/scenes/room.ron --samples 1024";
    assert_eq!(recipes.matches(truth).count(), 2, "{recipes}");
    let few = "truth --scene examples/scenes/room.ron --samples 8 --size 16x32 --without caustics";
    let capture = capture::line("--fps 1 --size 16x12 --scene show");
    let recipes = recipes.replace(truth, few).replace("capture", &capture);

    let folder = tempfile::tempdir().expect("a folder");
    let programs = folder.path().join("programs");
    fs::create_dir(&programs).expect("a folder");
    // Where a machine is a folder.
    let ssh = "case $1 in -*) exit 1;; esac; machine=$MACHINES/$1; shift; [ \"$1\" != -- ] || shift; \
               mkdir -p \"$machine\"; cd \"$machine\"; HOME=$machine exec sh -c \"$*\"";
    write_program(&programs, "ssh", ssh);
    let sbatch = "for task in $(seq \"${1#--array=1-}\"); do SLURM_ARRAY_TASK_ID=$task sh -c \"$3\" || exit; done";
    write_program(&programs, "sbatch", sbatch);
    let own = format!(
        "{}:{}",
        programs.display(),
        std::env::var("PATH").expect("a path")
    );
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut places = Vec::new();
    for engine in ["seq ", "sbatch "] {
        let place = folder.path().join(engine.trim());
        for needed in ["target/release", "examples"] {
            fs::create_dir_all(place.join(needed)).expect("a folder");
        }
        symlink(env!("CARGO_BIN_EXE_lab"), place.join("target/release/lab")).expect("a link");
        symlink(root.join("examples/scenes"), place.join("examples/scenes")).expect("a link");
        let lines = recipes.lines();
        let lines = lines.filter(|line| line.starts_with(engine) || line.contains(" --merge "));
        // The merge follows what is to be merged.
        let mut lines: Vec<&str> = lines.collect();
        lines.sort_by_key(|line| line.contains(" --merge "));
        for line in lines {
            let mut shell = Command::new("sh");
            shell
                .args(["-c", line])
                .current_dir(&place)
                .stdin(Stdio::null());
            let shell = shell
                .env("PATH", &own)
                // Parallel keeps files there, and tells by SHELL how it quotes.
                .env("HOME", folder.path())
                .env("SHELL", "/bin/sh")
                .env("MACHINES", folder.path().join("machines"));
            let output = shell.output().expect("a shell");
            assert!(output.status.success(), "{line}: {}", said(&output));
        }
        places.push(place);
    }
    let whole = folder.path().join("whole");
    printed(&format!("{capture} --png {}", whole.display()));
    let scene = root.join("examples/scenes/room.ron");
    let picture = folder.path().join("whole.png");
    let few = few.replace(
        "examples/scenes/room.ron",
        scene.to_str().expect("a plain name"),
    );
    printed(&format!("{few} --out {}", picture.display()));
    let frames = files(&whole);
    assert_eq!(frames.len(), eightfold::show::LENGTH as usize);
    for place in places {
        assert!(
            files(&place.join("frames")) == frames,
            "{}",
            place.display()
        );
        let merged = fs::read(place.join("room.png")).expect("a picture");
        assert!(
            merged == fs::read(&picture).expect("a picture"),
            "{}",
            place.display()
        );
    }
    // Both machines had a share of it.
    let machines = folder.path().join("machines");
    for machine in ["one", "two"] {
        let frames = fs::read_dir(machines.join(machine).join("eightfold/frames"));
        assert!(frames.expect("a folder").count() > 0, "{machine}");
    }
}
