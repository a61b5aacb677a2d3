//! System tools that some tests need. A test without its tools prints a line and passes, or fails
//! if `EIGHTFOLD_TOOLS` is `required`, as in `tests/run`.

use std::io::{Write, stderr};
use std::path::PathBuf;
use std::process::Command;
use std::{env, thread};

/// Tools and their Debian packages. A tool is a command, or a shared library if its name contains
/// `.so`.
const PACKAGES: &str = include_str!("tools.txt");

pub const DISPLAY: &[&str] =
    &["Xvfb", "openbox", "xdotool", "xprop", "xwininfo", "wmctrl", "import"];

const LIBRARIES: [&str; 5] =
    ["/usr/lib/x86_64-linux-gnu", "/usr/lib64", "/usr/lib", "/usr/local/lib", "/lib"];

/// Returns whether one of the tools is missing, and prints that the test is skipped.
///
/// # Panics
/// If a tool is missing and all are required.
#[must_use]
pub fn lacks(tools: &[&str]) -> bool {
    let Some(missing) = tools.iter().find(|tool| !is_there(tool)) else { return false };
    let needs = format!("needs {missing}: apt-get install {}", package(missing));
    let required = env::var_os("EIGHTFOLD_TOOLS").is_some_and(|value| value == "required");
    assert!(!required, "this test {needs}");
    // `eprintln!` prints nothing for passing tests. A test's thread has its name.
    let name = thread::current().name().unwrap_or_default().to_owned();
    writeln!(stderr(), "{name}: not run, {needs}").expect("standard error is open");
    true
}

#[macro_export]
macro_rules! needs {
    ($($tools:expr),+) => {
        if $($crate::lacks($tools))||+ {
            return;
        }
    };
}

/// # Panics
/// If the tool is missing.
pub fn tool(name: &str) -> Command {
    let package = package(name);
    assert!(is_there(name), "{name} is missing: apt-get install {package}");
    Command::new(name)
}

fn package(tool: &str) -> &'static str {
    let mut packages = PACKAGES.lines().filter_map(|line| line.split_once(' '));
    let found = packages.find(|(name, _)| *name == tool);
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
