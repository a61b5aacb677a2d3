//! `lab report`: measures all that README.md and the pages in `docs` tell, and writes it there.
//!
//! Each figure is what a command of the lab prints, and the command stands above it: what is read is what was run.

use crate::arguments::{self, BadInput, Size};
use crate::subcommand::{FIGURES, FRONT, Picture, RESOLUTION, SQUARES, Step};
use crate::{interrupt, output};
use anyhow::{Context, Result, bail};
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};

/// Measures what README.md and docs/*.md tell of speed, errors, size and sound, and rewrites their marked parts and pictures
///
/// A part begins at a line <!-- lab report NAME --> and ends at <!-- lab report end -->; its name is moving, sheet, speed, show,
/// ladder, missed, trade, figures, size, windows or sound. It may stand on several pages. What stands outside of the parts stays, and parts that
/// are on no page are not measured. Run twice on the same machine, it changes timings alone.
#[derive(Args)]
pub struct Arguments {
    /// Folder with README.md and docs, in which the other pages are, and the pictures
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    folder: PathBuf,
    /// Width and height in pixels; may be given several times, and what takes one size takes the first [default: what
    /// each command takes, and for speed 1024x768 and 1920x1080]
    #[arg(long, value_name = "WxH")]
    size: Vec<Size>,
    /// Frames to measure or to draw of each, at times spread evenly [default: what each command takes]
    #[arg(long, value_name = "N", value_parser = arguments::frames)]
    frames: Option<usize>,
}

/// The folder of the pages and the pictures, inside of the one that is reported on.
const DOCS: &str = "docs";
/// The prefix of the name of a picture there in a link or a command.
const DOCS_LINK: &str = "docs/";

/// A file with marked parts.
struct Page {
    path: PathBuf,
    text: String,
    /// The path that goes before the name of a picture in a link from it.
    link: &'static str,
}

/// The part of a page that one command measures.
struct Part {
    name: &'static str,
    step: Step,
    /// Whether what it prints is shown.
    is_printed: bool,
}

const END: &str = "<!-- lab report end -->";

/// Measures, and rewrites the pages when all is done.
pub fn run(arguments: &Arguments) -> Result<()> {
    let mut pages = pages(&arguments.folder)?;
    let mut parts = parts(arguments);
    parts.retain(|part| pages.iter().any(|page| page.has(part)));
    pages.retain(|page| parts.iter().any(|part| page.has(part)));
    if parts.is_empty() {
        let line = format!(
            "--folder: no page in {} has a part marked <!-- lab report speed -->, moving, sheet, show, ladder, missed, trade, \
             figures, size, windows or sound",
            arguments.folder.display()
        );
        bail!(BadInput(line));
    }
    for page in &pages {
        for part in parts.iter().filter(|part| page.has(part)) {
            if let Err(why) = replaced(&page.text, &part.begin(), "") {
                let line = format!("--folder: {}: {why}", page.path.display());
                bail!(BadInput(line));
            }
        }
        output::check(&page.path)?;
    }
    interrupt::listen();
    let docs = arguments.folder.join(DOCS);
    for part in &parts {
        eprintln!("{}: {}", part.name, part.step.shown(DOCS_LINK));
        let printed = part.measure(&docs)?;
        for page in pages.iter_mut().filter(|page| page.has(part)) {
            let body = part.body(&printed, page.link);
            page.text = replaced(&page.text, &part.begin(), &body).map_err(BadInput)?;
        }
    }
    for page in &pages {
        output::write(&page.path, page.text.as_bytes())?;
    }
    Ok(())
}

/// README.md, and the pages in `docs` by their names.
fn pages(folder: &Path) -> Result<Vec<Page>> {
    let docs = folder.join(DOCS);
    let files = fs::read_dir(&docs).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = files.map(|file| file.path()).collect();
    files.retain(|path| path.extension().is_some_and(|end| end == "md"));
    files.sort();
    let readme = [(folder.join("README.md"), DOCS_LINK)];
    let files = files.into_iter().map(|path| (path, ""));
    let page = |(path, link): (PathBuf, _)| {
        let text = fs::read_to_string(&path);
        let text = text.with_context(|| format!("cannot read {}", path.display()))?;
        Ok(Page { path, text, link })
    };
    readme.into_iter().chain(files).map(page).collect()
}

impl Page {
    fn has(&self, part: &Part) -> bool {
        self.text.contains(&part.begin())
    }
}

fn parts(arguments: &Arguments) -> Vec<Part> {
    let mut threads = vec![1, arguments::processors()];
    threads.dedup();
    let threads: String = threads
        .iter()
        .map(|count| format!(" --threads {count}"))
        .collect();
    let frames = arguments.frames.map(|count| format!(" --frames {count}"));
    let frames = frames.unwrap_or_default();
    let seeds = arguments
        .frames
        .map(|count| format!(" --frames {count} --seeds {count}"));
    let seeds = seeds.unwrap_or_default();
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
    let part = |name, command: String, flag, pictures: &'static [_]| Part {
        name,
        step: Step::new(&command, flag, pictures),
        is_printed: pictures.is_empty(),
    };
    let printed = |name, command| part(name, command, "", &[]);
    // Enough frames for the front to be the same one next time, in some minutes. Where few are asked for, all is to be quick.
    let plan = if arguments.frames.is_some() {
        " --quick"
    } else {
        " --frames 9"
    };
    // Tiles that stay readable in a column of text.
    let tile = sizes.first().map_or(" --size 240x135", String::as_str);
    // Twelve seconds about the cut from the model scene to the method's.
    let still = sizes.first().map_or(" --size 416x234", String::as_str);
    let end = 252 + arguments.frames.unwrap_or(144);
    let moving = format!("capture --from 252 --to {end} --fps 12{still} --supersample 2");
    let sheet = format!("capture{tile} --supersample 2{frames}");
    let show = format!("bench --scene show{show_sizes} --quality default{frames}");
    let speed = format!("bench{threads}{speed_sizes}{frames}");
    let ladder = format!("trade --ladder{size}{frames}");
    let trade = format!("trade{plan}{size}{frames}");
    vec![
        part("moving", moving, "--video", &MOVING),
        part("sheet", sheet, "--sheet", &SHEET),
        printed("show", show),
        printed("speed", speed),
        printed("ladder", ladder),
        printed("missed", format!("missed{size}{seeds}")),
        part("trade", trade, "--out", &TRADE),
        part("figures", format!("figures{size}"), "--out", &[FIGURES]),
        printed("size", "size --functions 10".to_owned()),
        printed("windows", "size --windows --functions 5".to_owned()),
        Part {
            is_printed: true,
            ..part("sound", "sound".to_owned(), "--waveform", &WAVEFORM)
        },
    ]
}

const MOVING: [Picture; 1] = [(
    "show.webp",
    "The model scene turns, and then the points that are traced and the squares that are filled are shown on it",
)];
const SHEET: [Picture; 1] = [(
    "show.png",
    "Frames of the show, row by row: title, model scene, method, colonnade, machine, flake, mirrors, swarm, finale",
)];
const TRADE: [Picture; 4] = [
    FRONT,
    RESOLUTION,
    SQUARES,
    ("objects.svg", "Time of a frame by the number of spheres"),
];
const WAVEFORM: [Picture; 1] = [(
    "waveform.png",
    "The soundtrack, left above right, with a line where each bar begins",
)];

impl Part {
    fn begin(&self) -> String {
        format!("<!-- lab report {} -->", self.name)
    }

    /// Runs the command, puts its pictures into a folder, and returns what it prints.
    fn measure(&self, docs: &Path) -> Result<String> {
        let (printed, pictures) = self.step.run()?;
        for ((name, _), bytes) in self.step.pictures.iter().zip(pictures) {
            fs::create_dir_all(docs).with_context(|| format!("cannot make {}", docs.display()))?;
            output::write(&docs.join(name), &bytes)?;
        }
        Ok(printed)
    }

    /// The text to put between the marks on a page: the command and what it prints, or pictures and the command that draws them.
    fn body(&self, printed: &str, link: &str) -> String {
        let command = format!("\n    {}\n", self.step.shown(DOCS_LINK));
        let pictures = self.step.pictures.iter();
        let pictures = pictures.map(|(name, says)| format!("\n![{says}]({link}{name})\n"));
        let pictures: String = pictures.collect();
        if self.is_printed {
            format!("{command}\n{printed}\n{pictures}\n")
        } else {
            format!("{pictures}{command}\n")
        }
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
