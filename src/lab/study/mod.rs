//! `lab study`: all measurements of one scene, as a page for a browser.

mod page;

use crate::arguments::{self, BadInput, Size};
use crate::interrupt;
use crate::output;
use crate::scenes::{self, SceneName};
use crate::subcommand::{FIGURES, FRONT, RESOLUTION, SQUARES, Step};
use crate::timing::machine;
use anyhow::{Result, bail};
use clap::Args;
use page::{escaped, figure, page, table};
use std::path::PathBuf;

/// Measures a scene in every way, and writes what comes of it as a page for a browser
///
/// The page is one file, with its plots, pictures and tables inside, and with the command above each by which it was made:
/// frames of the scene, how one of them comes about, speed and error of the named qualities, and what every dial of the quality
/// gains and costs. It takes some minutes, and less for smaller and fewer frames.
#[derive(Args)]
pub struct Arguments {
    #[arg(value_name = "SCENE", help = scenes::takes())]
    scene: SceneName,
    /// The moment that is looked at closely, in seconds since the scene's start [default: the middle of the scene]
    #[arg(long, value_name = "SECONDS", value_parser = arguments::seconds, allow_negative_numbers = true)]
    time: Option<f32>,
    /// Width and height in pixels of the frames that are measured
    #[arg(long, value_name = "WxH", default_value = "640x480")]
    size: Size,
    /// Frames to measure of each quality, at times spread evenly over the scene
    #[arg(long, value_name = "N", default_value = "17", value_parser = arguments::frames)]
    frames: usize,
    /// File to write the page to, or - for standard output
    #[arg(long, value_name = "FILE", default_value = "target/study.html", value_parser = html_file)]
    out: PathBuf,
}

/// The width of a frame on the contact sheet, on which three stand side by side.
const TILE_WIDTH: usize = 320;

/// Parses the name of a page, or `-` for standard output.
fn html_file(name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    let is_page = path.extension().is_some_and(|end| end == "html");
    if is_page || name == "-" {
        Ok(path)
    } else {
        Err("takes a name that ends in .html, or -".to_owned())
    }
}

/// A part of the page.
struct Section {
    title: &'static str,
    says: &'static str,
    step: Step,
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    if arguments.scene == SceneName::Show {
        let line = "the show is no single scene: takes one of its scenes, such as show:machine";
        bail!(BadInput(line.to_owned()));
    }
    output::check(&arguments.out)?;
    interrupt::listen();
    let mut body = format!(
        "<p>{}. What trades accuracy for speed is measured on this scene: how fast each setting is, and how far its pictures are \
         from those in which every pixel is traced.</p>\n",
        escaped(&machine())
    );
    for section in sections(arguments) {
        body += &section.html()?;
    }
    let page = page(&format!("Study of {}", arguments.scene), &body);
    output::write(&arguments.out, page.as_bytes())
}

fn sections(arguments: &Arguments) -> Vec<Section> {
    let Arguments {
        scene,
        size,
        frames,
        ..
    } = arguments;
    let time = arguments.time.unwrap_or(scene.length() / 2.0);
    let tile = Size::new(TILE_WIDTH, (TILE_WIDTH * size.height / size.width).max(1));
    let end = scene.length();
    let section = |title, says, command: String, flag, pictures| {
        let mut step = Step::new(&command, flag, pictures);
        let shown = ["--scene".to_owned(), scene.to_string()];
        step.words.splice(1..1, shown);
        Section { title, says, step }
    };
    vec![
        section(
            "The scene",
            "Frames spread evenly over the scene, row by row, each with its time.",
            format!("capture --size {tile} --supersample 2 --frames 9"),
            "--sheet",
            &[("scene.png", "Nine frames of the scene")],
        ),
        section(
            "One frame",
            "Which points of a frame are traced, which squares are filled, how many rays each point takes, and where the picture \
             is off.",
            format!("figures --time {time} --size {size}"),
            "--out",
            &[FIGURES],
        ),
        section(
            "Speed and error",
            "One thread. The speed-up is over frames in which every pixel is traced; PSNR, pixels that are more than 8 of 255 \
             off, pixels that pop, and FLIP are against the same frames, the last columns against 64 samples a pixel.",
            format!("bench --size {size} --threads 1 --frames {frames} --time-to {end}"),
            "",
            &[],
        ),
        section(
            "The named qualities",
            "The rungs that a player climbs to hold its frame rate, and their dials, which cargo lab trade --help explains.",
            format!("trade --ladder --size {size} --frames {frames} --time-to {end}"),
            "",
            &[],
        ),
        section(
            "What speed costs",
            "Every dial is turned. In the table nothing is faster, closer by FLIP to the picture that it should be, and with \
             fewer pixels that pop at once.",
            format!("trade --quick --size {size} --frames {frames} --time-to {end}"),
            "--out",
            &[FRONT, SQUARES, RESOLUTION],
        ),
    ]
}

impl Section {
    /// Runs the command. Returns what it shows, the command itself, and what comes of it.
    fn html(&self) -> Result<String> {
        let shown = self.step.shown("");
        eprintln!("{shown}");
        let (printed, pictures) = self.step.run()?;
        let [title, says, shown] = [self.title, self.says, &*shown].map(escaped);
        let mut html =
            format!("<h2>{title}</h2>\n<p>{says}</p>\n<pre><code>{shown}</code></pre>\n");
        if !printed.is_empty() {
            html += &table(&printed);
        }
        for ((name, says), bytes) in self.step.pictures.iter().zip(pictures) {
            html += &figure(name, &bytes, says);
        }
        Ok(html)
    }
}
