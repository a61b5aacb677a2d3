use crate::arguments::Exit;
use crate::output;
use anyhow::{Context, Result, ensure};
use clap::Args;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

/// Runs the commands in marked parts of README.md and docs/*.md, and replaces their output
///
/// A part begins with <!-- lab report NAME --> and ends with <!-- lab report end -->. Its indented lines are commands for sh. A part
/// with pictures keeps its text: its commands draw the pictures. Pages are written at the end.
#[derive(Args)]
pub struct Arguments {
    /// Parts to update [default: all]
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Folder of README.md and docs, in which the commands run
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    folder: PathBuf,
}

const BEGIN: &str = "\n<!-- lab report ";
const END: &str = "\n<!-- lab report end -->";

pub fn run(arguments: &Arguments) -> Result<()> {
    let mut pages = Vec::new();
    for path in paths(&arguments.folder) {
        let text = fs::read_to_string(&path).with_context(|| output::cannot("read", &path))?;
        pages.push((path, text));
    }
    let text: String = pages.iter().map(|(_, text)| &**text).collect();
    let marks = text.split(BEGIN).skip(1);
    let names = marks.filter_map(|mark| mark.split(" -->").next());
    let known: Vec<&str> = names.filter(|&name| name != "end").collect();
    for name in &arguments.names {
        let message = format!("part is {name}; must be one of {}", known.join(", "));
        ensure!(known.contains(&name.as_str()), Exit::bad_input(message));
    }
    let mut changed = Vec::new();
    for (path, text) in pages {
        let new = rewritten(&text, arguments);
        let new = new.with_context(|| path.display().to_string())?;
        if new != text {
            changed.push((path, new));
        }
    }
    for (path, text) in changed {
        output::write(&path, text.as_bytes())?;
    }
    Ok(())
}

fn paths(folder: &Path) -> Vec<PathBuf> {
    let docs = fs::read_dir(folder.join("docs")).into_iter().flatten();
    let docs = docs.flatten().map(|file| file.path());
    let mut paths: Vec<PathBuf> = docs
        .filter(|path| path.extension() == Some("md".as_ref()))
        .collect();
    paths.sort();
    paths.insert(0, folder.join("README.md"));
    paths
}

fn rewritten(text: &str, arguments: &Arguments) -> Result<String> {
    let mut parts = text.split(BEGIN);
    let mut new = parts.next().unwrap_or_default().to_owned();
    while let Some(part) = parts.next() {
        let (name, body) = part.split_once(" -->").context("mark has no -->")?;
        let after = parts.next().and_then(|after| after.strip_prefix("end -->"));
        let after = after.with_context(|| format!("part {name}: {} is missing", END.trim()))?;
        let is_asked_for =
            arguments.names.is_empty() || arguments.names.iter().any(|asked| asked == name);
        let body = if is_asked_for {
            measured(body, &arguments.folder).with_context(|| format!("part {name}"))?
        } else {
            body.to_owned()
        };
        new += &format!("{BEGIN}{name} -->{body}{END}{after}");
    }
    Ok(new)
}

fn measured(body: &str, folder: &Path) -> Result<String> {
    let commands = body.lines().filter(|line| line.starts_with("    "));
    let commands = commands.collect::<Vec<_>>().join("\n");
    eprintln!("{commands}");
    let lab = env::current_exe().context("path of the lab is unknown")?;
    let output = Command::new("sh")
        .args(["-ec", &commands.replace("cargo lab", "\"$LAB\"")])
        .env("LAB", lab)
        .current_dir(folder)
        .stderr(Stdio::inherit())
        .output()
        .context("sh cannot be started")?;
    ensure!(output.status.success(), "command failed: {}", output.status);
    if body.contains("![") {
        return Ok(body.to_owned());
    }
    let printed = String::from_utf8(output.stdout).context("output is not UTF-8")?;
    Ok(format!("\n\n{commands}\n\n{}\n", printed.trim_end()))
}
