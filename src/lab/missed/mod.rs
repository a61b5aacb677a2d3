//! `lab missed`: what adaptive frames do not show of what exhaustive frames do, by kind.
//!
//! A thing is taken out of a scene, and what of the picture that changes is what shows the thing: itself, a shadow, an image.

pub mod effects;

use crate::arguments::{self, NamedQuality, Size};
use crate::error::worst_channel;
use crate::scenes::{self, SceneName};
use crate::{output, progress};
use anyhow::Result;
use clap::Args;
use effects::{Counts, EffectCounter, Kind};
use eightfold_oracle::{Object, Oracle};
use eightfold_scenes::{Hidden, Random};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;

/// Counts the small objects, shadows and images that a quality misses
///
/// Prints a Markdown table. A sphere, box or cylinder is taken out of the scene, and the pixels of an exhaustive frame that change
/// by more than 8/255 are what shows it, beside its own: its shadows, its images. What has 16 pixels of a kind at most is small. It is
/// missed if none of its pixels is right; `unguarded` is what the quality would miss without the guard. Without --scene it counts
/// in random scenes, in the model scene and in the show.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", help = scenes::takes())]
    scene: Option<SceneName>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "320x240")]
    size: Size,
    /// How frames are refined: exhaustive, thesis, or one of the ladder, from finest to fastest
    #[arg(long, value_name = "NAME", default_value = "default")]
    quality: NamedQuality,
    /// Random scenes of each of nine sorts
    #[arg(long, value_name = "N", default_value = "20", value_parser = arguments::frames)]
    seeds: usize,
    /// Frames of a scene, at times spread evenly over it
    #[arg(long, value_name = "N", default_value = "2", value_parser = arguments::frames)]
    frames: usize,
    /// Threads that share the work
    #[arg(long, value_name = "N", default_value_t = arguments::processors(), value_parser = arguments::threads)]
    threads: usize,
}

/// A pixel is changed, or wrong, if a channel differs by more than this, in steps of 1/255.
const MAX_ERROR: u32 = 8;

/// Scenes that are counted together.
struct Group {
    name: String,
    scenes: Vec<Scene>,
}

/// Counts, and prints the table.
pub fn run(arguments: &Arguments) -> Result<()> {
    let groups = groups(arguments);
    for scene in groups.iter().flat_map(|group| &group.scenes) {
        scene.validate()?;
    }
    let Size { width, height } = arguments.size;
    let mut counter = EffectCounter::new(arguments.threads, width, height);
    let bar = progress::bar(groups.iter().map(|group| group.scenes.len()).sum());
    let mut columns = Vec::new();
    for group in &groups {
        let mut counts = Counts::new();
        for scene in &group.scenes {
            counter.count(scene, arguments.quality.quality, &mut counts);
            bar.inc(1);
        }
        columns.push((group.name.as_str(), counts));
    }
    bar.finish_and_clear();
    let text = format!(
        "{} quality, {}, frames without antialiasing\n\n{}",
        arguments.quality,
        arguments.size,
        table(&columns)
    );
    output::write(Path::new("-"), text.as_bytes())
}

/// The scenes that are asked for, or all.
fn groups(arguments: &Arguments) -> Vec<Group> {
    if let Some(scene) = arguments.scene {
        return vec![frames_of(scene, arguments.frames)];
    }
    let kinds = Hidden::ALL.into_iter();
    let scenes = kinds.flat_map(|kind| {
        let seeds = 0..arguments.seeds as u64;
        seeds.map(move |seed| kind.scene(&mut Random::new(seed)))
    });
    let chance = Group {
        name: "random scenes".to_owned(),
        scenes: scenes.collect(),
    };
    let others = [SceneName::Model, SceneName::Show].map(|name| frames_of(name, arguments.frames));
    [chance].into_iter().chain(others).collect()
}

/// Frames in the middle of equal parts of a scene, or of each of the show's scenes.
fn frames_of(name: SceneName, frames: usize) -> Group {
    let at = |part: SceneName| {
        let each = part.length() / frames as f32;
        (0..frames).map(move |frame| part.without_overlay(each * (frame as f32 + 0.5)))
    };
    Group {
        name: name.to_string(),
        scenes: name.split().into_iter().flat_map(at).collect(),
    }
}

/// A table with three columns for each group: how many small ones there are, and how many of these are missed.
pub fn table(columns: &[(&str, Counts)]) -> String {
    let mut text = "| what is small |".to_owned();
    for (name, _) in columns {
        text += &format!(" {name} | missed | unguarded |");
    }
    text += "\n| --- |";
    text += &" ---: | ---: | ---: |".repeat(columns.len());
    for (kind, what) in Kind::ALL {
        text += &format!("\n| {what} |");
        for (_, counts) in columns {
            let count = counts.get(&kind).copied().unwrap_or_default();
            let share = |missed: usize| match (missed, count.small) {
                (0, 0) => "-".to_owned(),
                (0, _) => "0".to_owned(),
                (missed, small) => format!("{:.1} %", 100.0 * missed as f64 / small as f64),
            };
            let [missed, unguarded] = count.missed.map(share);
            text += &format!(" {} | {missed} | {unguarded} |", count.small);
        }
    }
    text + "\n"
}

/// The objects of a scene that are visible in a frame.
pub struct Visible {
    /// For each visible object, the pixels that show it.
    pixels: BTreeMap<Object, Vec<u32>>,
}

impl Visible {
    /// Finds out what the centre of each pixel of a frame shows. The background does not count as an object.
    pub fn new(scene: &Scene, width: usize, height: usize) -> Self {
        let oracle = Oracle::new(scene, &Quality::EXHAUSTIVE, width, height);
        let at = |i: usize| oracle.object_at((i % width) as isize, (i / width) as isize);
        let objects: Vec<Object> = (0..width * height).into_par_iter().map(at).collect();
        let mut pixels: BTreeMap<Object, Vec<u32>> = BTreeMap::new();
        for (i, object) in objects.into_iter().enumerate() {
            if object != Object::Background {
                pixels.entry(object).or_default().push(i as u32);
            }
        }
        Self { pixels }
    }

    /// The number of objects that a picture misses: more than three quarters of the pixels that show them are wrong. An object in
    /// wrong light or with wrong reflections is not missed.
    pub fn missed(&self, exhaustive: &[u32], picture: &[u32]) -> usize {
        let is_wrong =
            |&&i: &&u32| worst_channel(exhaustive[i as usize], picture[i as usize]) > MAX_ERROR;
        let objects = self.pixels.values();
        objects
            .filter(|pixels| 4 * pixels.iter().filter(is_wrong).count() > 3 * pixels.len())
            .count()
    }
}
