//! `lab report`: measures all that README.md tells, and writes it there.
//!
//! Each figure is what a command of the lab prints, and the command stands above it: what is read is what was run.

use crate::arguments::{self, BadInput, Size};
use crate::output;
use anyhow::{Context, Result, bail};
use clap::Args;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::available_parallelism;

/// Measures what README.md tells of speed, errors and size, and rewrites the marked parts of it and their pictures
///
/// A part begins at a line <!-- lab report NAME --> and ends at <!-- lab report end -->; its name is sheet, speed, show,
/// ladder, front, figures or size. What stands outside of the parts stays, and parts that are not there are not measured. Run twice on
/// the same machine, it changes timings alone.
#[derive(Args)]
pub struct Arguments {
    /// File to rewrite
    #[arg(long, value_name = "FILE", default_value = "README.md")]
    readme: PathBuf,
    /// Folder for the pictures, beside the file; it is made where it is missing
    #[arg(long, value_name = "FOLDER", default_value = "docs")]
    pictures: PathBuf,
    /// Width and height in pixels; may be given several times, and what takes one size takes the first [default: what
    /// each command takes, and for speed 1024x768 and 1920x1080]
    #[arg(long, value_name = "WxH")]
    size: Vec<Size>,
    /// Frames to measure of each, at times spread evenly [default: what each command takes]
    #[arg(long, value_name = "N", value_parser = arguments::frames)]
    frames: Option<usize>,
}

/// A part of the file.
struct Part {
    name: &'static str,
    /// The command that is run and shown.
    command: Vec<String>,
    /// The flag by which it is told where to put pictures: a folder by `--out`, the one file by any other.
    flag: &'static str,
    /// Pictures that the command makes there, and what is said of each.
    pictures: &'static [(&'static str, &'static str)],
    /// Whether what it prints is shown.
    is_printed: bool,
}

const END: &str = "<!-- lab report end -->";

/// Measures, and rewrites the file when all is done.
pub fn run(arguments: &Arguments) -> Result<()> {
    let readme = &arguments.readme;
    let mut text =
        fs::read_to_string(readme).with_context(|| format!("cannot read {}", readme.display()))?;
    let parts: Vec<Part> = parts(arguments)
        .into_iter()
        .filter(|part| text.contains(&part.begin()))
        .collect();
    if parts.is_empty() {
        let line = format!(
            "--readme: {} has no part marked <!-- lab report speed -->, sheet, show, ladder, front, figures or size",
            readme.display()
        );
        return Err(BadInput::error(line));
    }
    for part in &parts {
        if let Err(why) = replaced(&text, &part.begin(), "") {
            let line = format!("--readme: {}: {why}", readme.display());
            return Err(BadInput::error(line));
        }
    }
    output::check(readme)?;
    let folder = beside(readme, &arguments.pictures);
    for part in &parts {
        eprintln!("{}: {}", part.name, part.shown(&arguments.pictures));
        let body = part.measure(&folder, &arguments.pictures)?;
        text = replaced(&text, &part.begin(), &body).map_err(BadInput::error)?;
    }
    output::write(readme, text.as_bytes())
}

fn parts(arguments: &Arguments) -> Vec<Part> {
    let mut threads = vec![1, available_parallelism().map_or(1, usize::from)];
    threads.dedup();
    let threads: String = threads
        .iter()
        .map(|count| format!(" --threads {count}"))
        .collect();
    let frames = arguments.frames.map(|count| format!(" --frames {count}"));
    let frames = frames.unwrap_or_default();
    let sizes = arguments.size.iter().map(|size| format!(" --size {size}"));
    let sizes: Vec<String> = sizes.collect();
    let size = sizes.first().cloned().unwrap_or_default();
    let all = |usual: &str| {
        if sizes.is_empty() {
            usual.to_owned()
        } else {
            sizes.concat()
        }
    };
    let speed_sizes = all(" --size 1024x768 --size 1920x1080");
    let show_sizes = all(" --size 1280x720");
    let part = |name, command: String, pictures, is_printed| Part {
        name,
        command: command.split(' ').map(str::to_owned).collect(),
        flag: "--out",
        pictures,
        is_printed,
    };
    // Tiles that stay readable in a column of text.
    let tile = sizes.first().map_or(" --size 240x135", String::as_str);
    vec![
        Part {
            flag: "--sheet",
            ..part(
                "sheet",
                format!("capture{tile} --supersample 2{frames}"),
                &SHEET,
                false,
            )
        },
        part(
            "show",
            format!("bench --scene show{show_sizes} --quality default{frames}"),
            &[],
            true,
        ),
        part(
            "speed",
            format!("bench{threads}{speed_sizes}{frames}"),
            &[],
            true,
        ),
        part("ladder", format!("trade --ladder{size}{frames}"), &[], true),
        part(
            "front",
            format!("trade --quick{size}{frames}"),
            &FRONT,
            false,
        ),
        part("figures", format!("figures{size}"), &FIGURES, false),
        part("size", "size --functions 10".to_owned(), &[], true),
    ]
}

/// A trade's pictures that are shown, and what is said of each.
const FRONT: [(&str, &str); 2] = [
    (
        "front.svg",
        "Speed and PSNR of every setting, and the Pareto front by number",
    ),
    (
        "squares.svg",
        "PSNR by the side of the squares, 2 to 32 pixels",
    ),
];
const SHEET: [(&str, &str); 1] = [(
    "show.png",
    "Frames of the show, row by row: title, model scene, method, colonnade, machine, swarm, finale",
)];
const FIGURES: [(&str, &str); 1] = [(
    "sheet.png",
    "The points traced, the picture, the squares by size, rays of each point, the error",
)];

impl Part {
    fn begin(&self) -> String {
        format!("<!-- lab report {} -->", self.name)
    }

    /// The command as somebody would type it.
    fn shown(&self, link: &Path) -> String {
        let command = self.command.join(" ");
        match self.pictures {
            [(name, _)] if self.flag != "--out" => {
                format!(
                    "cargo lab {command} {} {}",
                    self.flag,
                    link.join(name).display()
                )
            }
            _ => format!("cargo lab {command}"),
        }
    }

    /// Runs the command; what to put between the marks.
    fn measure(&self, folder: &Path, link: &Path) -> Result<String> {
        let lab = env::current_exe().context("cannot find the lab")?;
        let mut command = Command::new(lab);
        command
            .args(&self.command)
            .env(output::QUIET, "1")
            .stderr(Stdio::inherit());
        let made = tempfile::tempdir().context("cannot make a folder for pictures")?;
        match self.pictures {
            [] => {}
            [(name, _)] if self.flag != "--out" => {
                command.arg(self.flag).arg(made.path().join(name));
            }
            _ => {
                command.arg(self.flag).arg(made.path());
            }
        }
        let output = command.output().context("cannot start the lab")?;
        if !output.status.success() {
            bail!("{} has failed", self.shown(link));
        }
        let mut body = format!("\n    {}\n", self.shown(link));
        if self.is_printed {
            let printed = String::from_utf8_lossy(&output.stdout);
            body += &format!("\n{}\n", printed.trim_end());
        }
        for (name, says) in self.pictures {
            fs::create_dir_all(folder)
                .with_context(|| format!("cannot make {}", folder.display()))?;
            output::write(&folder.join(name), &fs::read(made.path().join(name))?)?;
            body += &format!("\n![{says}]({})\n", link.join(name).display());
        }
        Ok(body + "\n")
    }
}

/// The text with another body between a mark and the end that follows it.
fn replaced(text: &str, begin: &str, body: &str) -> Result<String, String> {
    let (before, rest) = text
        .split_once(begin)
        .ok_or_else(|| format!("{begin} is missing"))?;
    let (old, after) = rest
        .split_once(END)
        .ok_or_else(|| format!("{begin} has no {END} after it"))?;
    if old.contains("<!-- lab report ") {
        return Err(format!("{begin} has no {END} of its own"));
    }
    Ok(format!("{before}{begin}\n{body}{END}{after}"))
}

/// A folder named from where a file is.
fn beside(file: &Path, folder: &Path) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).join(folder)
}
