//! Tools of the system that some tests need, and what becomes of a test without them.
//!
//! `cargo test` passes without any of them: a test that lacks one says so in a line and is not run. Where the variable
//! `EIGHTFOLD_TOOLS` is `required`, as `tests/run` sets it, a missing tool is a failure.

#![allow(dead_code, reason = "each test uses a part of it")]

use std::{
    env,
    io::{Write, stderr},
    path::PathBuf,
    process::Command,
    thread,
};

/// The Debian package of each tool, a line each. A tool is a command, or a shared library (with `.so.` in its name).
const PACKAGES: &str = include_str!("tools.txt");

/// What tests on a display need: an X server, a window manager, and what presses keys and looks.
pub const DISPLAY: &[&str] = &[
    "Xvfb", "openbox", "xdotool", "xprop", "xwininfo", "wmctrl", "import",
];

/// Folders of shared libraries, as Debian and others have them.
const LIBRARIES: [&str; 5] = [
    "/usr/lib/x86_64-linux-gnu",
    "/usr/lib64",
    "/usr/lib",
    "/usr/local/lib",
    "/lib",
];

/// Whether the machine lacks one of the tools. If so, one line says which and that the test is not run.
///
/// # Panics
/// If one is missing where all are required.
#[must_use]
pub fn lacks(tools: &[&str]) -> bool {
    let Some(missing) = tools.iter().find(|tool| !is_there(tool)) else {
        return false;
    };
    let needs = format!("needs {missing}: apt-get install {}", package(missing));
    let required = env::var_os("EIGHTFOLD_TOOLS").is_some_and(|value| value == "required");
    assert!(!required, "this test {needs}");
    // Not by `eprintln!`, of which nothing is seen when a test passes.
    writeln!(stderr(), "{}: not run, {needs}", test()).expect("standard error is open");
    true
}

/// Starts a tool of `tools.txt`.
///
/// # Panics
/// If it is missing, which a test finds out by [`lacks`].
pub fn tool(name: &str) -> Command {
    let package = package(name);
    assert!(
        is_there(name),
        "{name} is missing: apt-get install {package}"
    );
    Command::new(name)
}

/// The name of the test that runs: its thread's, or its program's where that is the one test.
fn test() -> String {
    match thread::current().name() {
        Some("main") | None => env!("CARGO_CRATE_NAME").to_owned(),
        Some(name) => name.to_owned(),
    }
}

/// The package that a tool is in.
fn package(tool: &str) -> &'static str {
    let lines = PACKAGES.lines().filter_map(|line| line.split_once(' '));
    let mut packages = lines.filter(|(name, _)| *name == tool);
    let (_, package) = packages
        .next()
        .unwrap_or_else(|| panic!("tools.txt lacks {tool}"));
    package
}

fn is_there(tool: &str) -> bool {
    let folders: Vec<PathBuf> = if tool.contains(".so.") {
        LIBRARIES.iter().map(PathBuf::from).collect()
    } else {
        let path = env::var_os("PATH").unwrap_or_default();
        env::split_paths(&path).collect()
    };
    folders.iter().any(|folder| folder.join(tool).exists())
}
