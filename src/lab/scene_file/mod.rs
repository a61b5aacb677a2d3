//! Scenes as files in RON: every field of [`Scene`] by its name, materials by names of one's own, and numbers that change with time.
//!
//! `examples/scenes` has a file for each of its features.

mod changes;
mod conversion;
mod description;
pub mod edit;
mod keys;
mod motion;
mod path;
mod places;
mod record;
mod ron_text;
mod rust_text;

pub use record::record;
pub use rust_text::rust;

use description::Description;
use eightfold::Flaw;
use eightfold::scene::{
    MAX_BLOCKS, MAX_CAPTIONS, MAX_LETTERS, MAX_LIGHTS, MAX_PLANES, MAX_SPHERES, Scene,
};
use motion::{Motion, Numbers};
use places::{Places, line_and_column};
use ron::extensions::Extensions;
use serde_json::Value;
use std::fs;

/// The suffix of scene files.
pub const SUFFIX: &str = ".ron";

/// A scene that has been read from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    /// The name of the file.
    pub name: String,
    /// How long it plays, in seconds.
    pub length: f32,
    /// What the file says, without the motions.
    tree: Value,
    motions: Vec<Motion>,
}

/// What is wrong with a file: where, by its path, and what.
struct Fault {
    path: String,
    what: String,
}

fn fault(path: impl Into<String>, what: impl Into<String>) -> Fault {
    Fault {
        path: path.into(),
        what: what.into(),
    }
}

impl SceneFile {
    /// Reads a scene file.
    ///
    /// # Errors
    /// One line: the file, the line, the column, the field, and what it takes.
    pub fn read(name: &str) -> Result<Self, String> {
        let text =
            fs::read_to_string(name).map_err(|error| format!("cannot read {name}: {error}"))?;
        Self::parse(name, &text)
    }

    /// Reads a scene from the text of a file.
    ///
    /// # Errors
    /// As [`SceneFile::read`].
    pub fn parse(name: &str, text: &str) -> Result<Self, String> {
        let options = ron::Options::default().with_default_extension(Extensions::IMPLICIT_SOME);
        let description: Description = options.from_str(text).map_err(|error| {
            let start = error.span.start;
            format!("{name}:{}:{}: {}", start.line, start.col, error.code)
        })?;
        Self::of(name, description).map_err(|Fault { path, what }| {
            let place = Places::of(text).find(&path).unwrap_or_default();
            let (line, column) = line_and_column(text, place.start);
            let subject = if path.is_empty() { "the scene" } else { &path };
            format!("{name}:{line}:{column}: {subject} {what}")
        })
    }

    fn of(name: &str, mut description: Description) -> Result<Self, Fault> {
        check_counts(&description)?;
        check_materials(&description)?;
        if !(description.length > 0.0 && description.length <= 3600.0) {
            let what = format!("is {}, and takes seconds up to 3600", description.length);
            return Err(fault("length", what));
        }
        let motions = std::mem::take(&mut description.motions);
        let file = Self {
            name: name.to_owned(),
            length: description.length,
            tree: tree(description)?,
            motions,
        };
        for (i, motion) in file.motions.iter().enumerate() {
            file.check_motion(i, motion)?;
        }
        let times = file.motions.iter().flat_map(|motion| &motion.keys);
        let mut times: Vec<f32> = times.map(|(time, _)| *time).chain([0.0]).collect();
        times.sort_by(f32::total_cmp);
        times.dedup();
        for time in times {
            let valid = file.at(time).validate();
            valid.map_err(|flaw| file.fault(&flaw, time))?;
        }
        Ok(file)
    }

    fn check_motion(&self, i: usize, motion: &Motion) -> Result<(), Fault> {
        let value = path::get(&self.tree, &motion.of).and_then(Numbers::of);
        let Some(value) = value else {
            let what = format!(
                "is {:?}, and takes the path of a number or a vector",
                motion.of
            );
            return Err(fault(format!("motions[{i}].of"), what));
        };
        if motion.keys.is_empty() {
            return Err(fault(
                format!("motions[{i}].keys"),
                "has no key, and takes one at least",
            ));
        }
        let mut last = f32::NEG_INFINITY;
        for (k, &(time, numbers)) in motion.keys.iter().enumerate() {
            let path = format!("motions[{i}].keys[{k}]");
            if !(time > last && time.is_finite()) {
                return Err(fault(path, "has a time that is not after the last one's"));
            }
            if !numbers.fits(value) {
                let what = format!("takes as many numbers as {} has", motion.of);
                return Err(fault(path, what));
            }
            if !numbers.are_finite() {
                return Err(fault(path, "takes finite numbers"));
            }
            last = time;
        }
        Ok(())
    }

    /// The fault in the file that makes a scene invalid at a time.
    fn fault(&self, flaw: &Flaw, time: f32) -> Fault {
        let index = flaw.index.map(|i| format!("[{i}]")).unwrap_or_default();
        let object = format!("{}{index}", flaw.object);
        let material = path::get(&self.tree, &format!("{object}.material")).and_then(Value::as_str);
        let path = match (material, flaw.field.strip_prefix("material.")) {
            (Some(name), Some(field)) => format!("materials[{name:?}].{field}"),
            _ if flaw.field.is_empty() => object,
            _ => format!("{object}.{}", flaw.field),
        };
        let what = format!("is {}, and takes {}", flaw.found, flaw.takes);
        match self.motions.iter().position(|motion| motion.of == path) {
            Some(i) => fault(
                format!("motions[{i}]"),
                format!("is wrong at {time} s: {path} {what}"),
            ),
            None => fault(path, what),
        }
    }

    /// What the file says, without the motions.
    fn description(&self) -> Description {
        serde_json::from_value(self.tree.clone()).expect("it is a description's")
    }

    /// The scene at a time in seconds.
    pub fn at(&self, time: f32) -> Scene {
        let mut tree = self.tree.clone();
        for motion in &self.motions {
            let value = serde_json::to_value(motion.at(time)).unwrap_or_default();
            path::set(&mut tree, &motion.of, value);
        }
        let description: Description =
            serde_json::from_value(tree).expect("numbers have taken the place of numbers");
        description.scene()
    }
}

/// What a description says, by names.
fn tree(description: Description) -> Result<Value, Fault> {
    let tree = serde_json::to_value(description)
        .map_err(|error| fault("", format!("cannot be kept: {error}")))?;
    let mut none = None;
    path::leaves(&tree, String::new(), &mut |path, value| {
        // Only a light without a cone may have nothing for it.
        if value.is_null() && !path.ends_with(".spot") && none.is_none() {
            none = Some(path);
        }
    });
    match none {
        None => Ok(tree),
        Some(path) => Err(fault(path, "is no number, and takes a finite one")),
    }
}

/// Checks that the library has room for everything.
fn check_counts(description: &Description) -> Result<(), Fault> {
    let lists = [
        ("spheres", description.spheres.len(), MAX_SPHERES),
        ("planes", description.planes.len(), MAX_PLANES),
        ("blocks", description.blocks.len(), MAX_BLOCKS),
        ("lights", description.lights.len(), MAX_LIGHTS),
        ("captions", description.captions.len(), MAX_CAPTIONS),
    ];
    for (list, count, most) in lists {
        if count > most {
            let what = format!("has {count}, and takes up to {most}");
            return Err(fault(list, what));
        }
    }
    for (i, caption) in description.captions.iter().enumerate() {
        let letters = &caption.letters;
        if letters.len() > MAX_LETTERS || !letters.is_ascii() {
            let what = format!("is {letters:?}, and takes up to {MAX_LETTERS} letters of ASCII");
            return Err(fault(format!("captions[{i}].letters"), what));
        }
    }
    Ok(())
}

/// Checks that every object's material is in the table.
fn check_materials(description: &Description) -> Result<(), Fault> {
    let spheres = description.spheres.iter().map(|sphere| &sphere.material);
    let planes = description.planes.iter().map(|plane| &plane.material);
    let blocks = description.blocks.iter().map(|block| &block.material);
    let named = spheres.enumerate().map(|(i, name)| ("spheres", i, name));
    let named = named.chain(planes.enumerate().map(|(i, name)| ("planes", i, name)));
    let mut named = named.chain(blocks.enumerate().map(|(i, name)| ("blocks", i, name)));
    let materials = &description.materials;
    match named.find(|(.., name)| !materials.contains_key(*name)) {
        None => Ok(()),
        Some((list, i, name)) => {
            let names: Vec<String> = materials.keys().map(|name| format!("{name:?}")).collect();
            let what = format!(
                "is {name:?}, and takes one of materials: {}",
                names.join(", ")
            );
            Err(fault(format!("{list}[{i}].material"), what))
        }
    }
}
