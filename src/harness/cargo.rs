use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::collections::HashMap;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::{env, fs};

pub struct Build {
    programs: HashMap<String, PathBuf>,
}

impl Build {
    pub fn release(package: &str) -> Result<Self> {
        Self::of(&["build", "--release", "--package", package])
    }

    /// Uses an alias in `.cargo/config.toml`.
    pub fn windows() -> Result<Self> {
        Self::of(&["exe"])
    }

    fn of(arguments: &[&str]) -> Result<Self> {
        let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
        let mut command = Command::new(cargo);
        command
            .args(arguments)
            .args(["--message-format", "json-render-diagnostics"])
            .stderr(Stdio::inherit());
        // Set by `cargo run`; otherwise the current folder must be in the workspace.
        if let Some(folder) = env::var_os("CARGO_MANIFEST_DIR") {
            command.current_dir(folder);
        }
        let output = command.output().context("cargo cannot be started")?;
        if !output.status.success() {
            bail!("cargo {} failed", arguments.join(" "));
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let program = |line| {
            let message: Value = serde_json::from_str(line).ok()?;
            let path = message["executable"].as_str()?.into();
            Some((message["target"]["name"].as_str()?.to_owned(), path))
        };
        Ok(Self { programs: text.lines().filter_map(program).collect() })
    }

    pub fn program(&self, name: &str) -> Result<PathBuf> {
        let path = self.programs.get(name).cloned();
        path.with_context(|| format!("{name} is missing from cargo's output"))
    }

    /// Returns the path of an unpacked program, see `src/pack/build/mod.rs`. Cargo reports the
    /// packed one.
    pub fn linked(&self, program: &str) -> Result<PathBuf> {
        let copy = self.program(program)?;
        let bytes = fs::read(&copy).with_context(|| copy.display().to_string())?;
        let folder = copy.with_file_name("deps");
        let entries = fs::read_dir(&folder).with_context(|| folder.display().to_string())?;
        for entry in entries {
            let path = entry?.path();
            if path.extension().is_some_and(|end| end == "unpacked")
                && fs::read(path.with_extension("")).is_ok_and(|original| original == bytes)
            {
                return Ok(path);
            }
        }
        bail!("{}: {program}.unpacked is missing", folder.display())
    }
}
