use anyhow::{Context, Result, bail};
use serde_json::Value;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::{env, fs};

pub struct Build {
    /// Cargo's JSON output.
    messages: Vec<Value>,
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
        let messages = text.lines().map(serde_json::from_str);
        let messages = messages.filter_map(Result::ok).collect();
        Ok(Self { messages })
    }

    pub fn program(&self, name: &str) -> Result<PathBuf> {
        let path = self.artifact("bin", name).and_then(|artifact| artifact["executable"].as_str());
        path.map(PathBuf::from).with_context(|| format!("{name} is missing from cargo's output"))
    }

    /// Returns the path of an unpacked program, see `src/pack/build/mod.rs`. Equal bytes identify the packed program in `deps`,
    /// since cargo reports only a copy.
    pub fn linked(&self, program: &str) -> Result<PathBuf> {
        let copy = self.program(program)?;
        let bytes = fs::read(&copy).with_context(|| copy.display().to_string())?;
        let folder = self.script_folder(program)?;
        let entries = fs::read_dir(&folder).with_context(|| folder.display().to_string())?;
        for entry in entries {
            let path = entry?.path();
            let name = path.file_stem().unwrap_or_default();
            let original = copy.with_file_name("deps").join(name);
            if path.extension().is_some_and(|end| end == "unpacked")
                && fs::read(original).is_ok_and(|original| original == bytes)
            {
                return Ok(path);
            }
        }
        bail!("{}: {program}.unpacked is missing", folder.display())
    }

    fn script_folder(&self, program: &str) -> Result<PathBuf> {
        let package = self.artifact("bin", program).map(|artifact| &artifact["package_id"]);
        let mut scripts = self.of_reason("build-script-executed");
        scripts
            .find(|message| Some(&message["package_id"]) == package)
            .and_then(|message| message["out_dir"].as_str())
            .map(PathBuf::from)
            .with_context(|| format!("build script of {program} is missing from cargo's output"))
    }

    fn artifact(&self, kind: &str, name: &str) -> Option<&Value> {
        self.of_reason("compiler-artifact").find(|message| {
            let target = &message["target"];
            target["name"] == name && target["kind"][0] == kind
        })
    }

    fn of_reason(&self, reason: &str) -> impl Iterator<Item = &Value> {
        self.messages.iter().filter(move |message| message["reason"] == reason)
    }
}
