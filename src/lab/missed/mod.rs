pub mod effects;

use crate::arguments::{self, NamedQuality, Size, within};
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
/// Prints a Markdown table. Removes each sphere and block from the scene: pixels of the exhaustive frame that change by more than 8/255
/// show the object, its shadow or its image. Effects in at most 16 pixels are small, and missed if all these pixels are wrong.
/// `unguarded` is without the guard.
#[derive(Args)]
pub struct Arguments {
    #[arg(long, value_name = "NAME", help = format!("{} [default: random scenes, model, show]", scenes::names()))]
    scene: Option<SceneName>,
    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "320x240")]
    size: Size,
    #[arg(long, value_name = "NAME", default_value = "default", help = arguments::QUALITY)]
    quality: NamedQuality,
    /// Random scenes of each of nine kinds
    #[arg(long, value_name = "N", default_value = "20", value_parser = within(arguments::FRAMES))]
    seeds: usize,
    /// Frames of a scene, at even intervals
    #[arg(long, value_name = "N", default_value = "2", value_parser = within(arguments::FRAMES))]
    frames: usize,
}

/// A pixel is changed or wrong if a channel differs by more than this, in 255ths.
const MAX_ERROR: u32 = 8;

struct Group {
    name: String,
    scenes: Vec<Scene>,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let groups = groups(arguments);
    let mut counter = EffectCounter::new(arguments::processors(), arguments.size);
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

fn groups(arguments: &Arguments) -> Vec<Group> {
    if let Some(scene) = arguments.scene {
        return vec![frames_of(scene, arguments.frames)];
    }
    let kinds = Hidden::ALL.into_iter();
    let scenes = kinds.flat_map(|kind| {
        let seeds = 0..arguments.seeds as u64;
        seeds.map(move |seed| kind.scene(&mut Random::new(seed)))
    });
    let random = Group {
        name: "random scenes".to_owned(),
        scenes: scenes.collect(),
    };
    let others = [SceneName::Model, SceneName::Show].map(|name| frames_of(name, arguments.frames));
    [random].into_iter().chain(others).collect()
}

/// Returns the middle frames of equal parts of each scene.
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

fn table(columns: &[(&str, Counts)]) -> String {
    let mut text = "| small effects |".to_owned();
    for (name, _) in columns {
        text += &format!(" {name} | missed | unguarded |");
    }
    text += "\n| --- |";
    text += &" ---: | ---: | ---: |".repeat(columns.len());
    for (kind, title) in Kind::ALL {
        text += &format!("\n| {title} |");
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

fn visible_objects(scene: &Scene, Size { width, height }: Size) -> Vec<Object> {
    let oracle = Oracle::new(scene, &Quality::EXHAUSTIVE, width, height);
    let at = |i: usize| oracle.object_at((i % width) as isize, (i / width) as isize);
    (0..width * height).into_par_iter().map(at).collect()
}

/// Pixels by object, without the background.
pub struct Visible(BTreeMap<Object, Vec<u32>>);

impl Visible {
    pub fn new(scene: &Scene, width: usize, height: usize) -> Self {
        let mut pixels: BTreeMap<Object, Vec<u32>> = BTreeMap::new();
        let objects = visible_objects(scene, Size::new(width, height));
        for (i, object) in objects.into_iter().enumerate() {
            if object != Object::Background {
                pixels.entry(object).or_default().push(i as u32);
            }
        }
        Self(pixels)
    }

    /// Counts objects with over three quarters of their pixels wrong: wrong lighting or reflections should not count.
    pub fn missed(&self, exhaustive: &[u32], picture: &[u32]) -> usize {
        let is_wrong =
            |&&i: &&u32| worst_channel(exhaustive[i as usize], picture[i as usize]) > MAX_ERROR;
        let is_missed =
            |pixels: &&Vec<u32>| 4 * pixels.iter().filter(is_wrong).count() > 3 * pixels.len();
        self.0.values().filter(is_missed).count()
    }
}
