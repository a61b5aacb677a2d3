//! Tools of the system that some tests need.
//!
//! `cargo test` passes without them: a test that lacks a tool prints a line and does nothing. If the variable `EIGHTFOLD_TOOLS`
//! is `required`, as `tests/run` sets it, a missing tool is a failure.

use std::{
    env,
    io::{Write, stderr},
    path::PathBuf,
    process::Command,
    thread,
};

/// The tools with their Debian packages, one per line. A tool is a command, or a shared library if its name contains `.so`.
const PACKAGES: &str = include_str!("tools.txt");

/// The tools for tests on a display: an X server, a window manager, and programs that press keys and inspect windows.
pub const DISPLAY: &[&str] = &[
    "Xvfb", "openbox", "xdotool", "xprop", "xwininfo", "wmctrl", "import",
];

/// The folders of shared libraries on Debian and other systems.
const LIBRARIES: [&str; 5] = [
    "/usr/lib/x86_64-linux-gnu",
    "/usr/lib64",
    "/usr/lib",
    "/usr/local/lib",
    "/lib",
];

/// Whether one of the tools is missing. If so, a line says which, and that the test is not run.
///
/// # Panics
/// If a tool is missing and all are required.
#[must_use]
pub fn lacks(tools: &[&str]) -> bool {
    let Some(missing) = tools.iter().find(|tool| !is_there(tool)) else {
        return false;
    };
    let needs = format!("needs {missing}: apt-get install {}", package(missing));
    let required = env::var_os("EIGHTFOLD_TOOLS").is_some_and(|value| value == "required");
    assert!(!required, "this test {needs}");
    // The output of `eprintln!` is hidden if the test passes. A test's thread has its name.
    let name = thread::current().name().unwrap_or_default().to_owned();
    writeln!(stderr(), "{name}: not run, {needs}").expect("standard error is open");
    true
}

/// Ends a test, which returns nothing, that [lacks] a tool.
#[macro_export]
macro_rules! needs {
    ($($tools:expr),+) => {
        if $($crate::lacks($tools))||+ {
            return;
        }
    };
}

/// The tools, each with its Debian package.
fn packages() -> impl Iterator<Item = (&'static str, &'static str)> {
    PACKAGES.lines().filter_map(|line| line.split_once(' '))
}

/// The tools that are missing, each with its Debian package.
pub fn missing() -> impl Iterator<Item = (&'static str, &'static str)> {
    packages().filter(|(tool, _)| !is_there(tool))
}

/// A command that runs a tool of `tools.txt`.
///
/// # Panics
/// If the tool is missing. Tests say by [`needs!`] which they need.
pub fn tool(name: &str) -> Command {
    let package = package(name);
    assert!(
        is_there(name),
        "{name} is missing: apt-get install {package}"
    );
    Command::new(name)
}

/// The Debian package of a tool.
fn package(tool: &str) -> &'static str {
    let found = packages().find(|(name, _)| *name == tool);
    found.unwrap_or_else(|| panic!("tools.txt lacks {tool}")).1
}

fn is_there(tool: &str) -> bool {
    let folders: Vec<PathBuf> = if tool.contains(".so") {
        LIBRARIES.iter().map(PathBuf::from).collect()
    } else {
        let path = env::var_os("PATH").unwrap_or_default();
        env::split_paths(&path).collect()
    };
    folders.iter().any(|folder| folder.join(tool).exists())
}
