//! The intro's program, built.

use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::env;
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// What a build has made.
pub struct Intro {
    pub program: PathBuf,
    /// What the linker has put where; there is none where the intro is not put on its diet.
    pub map: PathBuf,
}

/// The intro, as `cargo run --release` builds it.
pub fn build() -> Result<Intro> {
    let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
    let mut command = Command::new(cargo);
    command
        .args([
            "build",
            "--release",
            "--package",
            "eightfold",
            "--bin",
            "eightfold",
        ])
        .args(["--message-format", "json-render-diagnostics"])
        .stderr(Stdio::inherit());
    // Where the lab itself is built, unless it is started by hand.
    if let Some(folder) = env::var_os("CARGO_MANIFEST_DIR") {
        command.current_dir(folder);
    }
    let output = command.output().context("cannot start cargo")?;
    if !output.status.success() {
        bail!("cargo cannot build the intro");
    }
    let messages = String::from_utf8_lossy(&output.stdout);
    let messages = messages.lines().map(serde_json::from_str);
    let messages: Vec<Value> = messages.filter_map(Result::ok).collect();
    told(&messages).context("cargo does not say what it has built")
}

/// What cargo's messages tell of the intro.
fn told(messages: &[Value]) -> Option<Intro> {
    let mut programs = messages
        .iter()
        .filter(|message| message["executable"].is_string());
    let program = programs.next_back()?;
    // Every package has a script's folder of its own, for each choice of features.
    let mut scripts = messages.iter().filter(|message| {
        message["reason"] == "build-script-executed"
            && message["package_id"] == program["package_id"]
    });
    let folder = scripts.next_back()?["out_dir"].as_str()?;
    Some(Intro {
        program: program["executable"].as_str()?.into(),
        map: PathBuf::from(folder).join("eightfold.map"),
    })
}
