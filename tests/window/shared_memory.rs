//! Shared memory with the X server, which fails in containers.

use eightfold_stage::{DISPLAY, Process, Server, intro, needs, succeed, wait_for};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// A system that creates shared memory but maps none.
const NO_ADDRESSES: &str = "
    #[unsafe(no_mangle)] extern \"C\" fn shmat() -> isize { -1 }";

fn build(folder: &Path) -> PathBuf {
    let (source, library) = (folder.join("library.rs"), folder.join("no_addresses.so"));
    fs::write(&source, NO_ADDRESSES).expect("a file");
    let mut rustc = Command::new(env::var_os("RUSTC").unwrap_or("rustc".into()));
    rustc.args(["--edition", "2024", "--crate-type", "cdylib", "-o"]);
    succeed(rustc.arg(&library).arg(source));
    library
}

/// Plays until the window shows a frame without black pixels.
fn play(server: &Server, command: &mut Command) -> Process {
    let command = command.args(["--silent", "--size", "200x150"]);
    let intro = server.open(command, || server.window());
    wait_for("a frame", || {
        let shot = server.screenshot(server.window().expect("a window"));
        shot.iter().all(|&pixel| pixel != 0).then_some(())
    });
    intro
}

fn segments(process: &Process) -> usize {
    let id = process.0.id().to_string();
    let table = fs::read_to_string("/proc/sysvipc/shm").expect("the system tells");
    let makers = table.lines().filter_map(|line| line.split_whitespace().nth(4));
    makers.filter(|&maker| maker == id).count()
}

#[test]
fn shared_memory_is_released() {
    needs!(DISPLAY);
    let folder = tempfile::tempdir().expect("a folder");
    let library = build(folder.path());
    let server = Server::start(320, 240);
    let mut command = Command::new(intro());
    let playing = play(&server, command.env("LD_PRELOAD", library));
    assert_eq!(segments(&playing), 0, "none while it plays");
    drop(playing);

    let mut command = Command::new(intro());
    let mut playing = play(&server, &mut command);
    assert_eq!(segments(&playing), 1, "the server shares it");
    playing.0.kill().expect("it runs");
    playing.0.wait().expect("it has ended");
    wait_for("the server to let go", || (segments(&playing) == 0).then_some(()));
}
