//! Scenes as files in RON: every field of [`Scene`] by its name, materials by names of one's own, and numbers that change with time.
//!
//! `examples/scenes` has a file for each of its features.

mod earlier;
mod keys;
mod motion;
mod path;
mod places;
mod reading;
mod record;
mod ron_text;
mod rust_text;
mod tree;

pub use record::text_of;
pub use rust_text::rust;

use eightfold_tracer::Flaw;
use eightfold_tracer::scene::{Fields, MAX_LETTERS, Scene, Value as Place};
use motion::{Motion, Numbers};
use places::{BYTE_ORDER_MARK, Places, line_and_column};
use serde_json::Value;
use std::borrow::Cow;
use std::fs;
use std::path::Path;

/// The suffix of scene files.
pub const SUFFIX: &str = ".ron";

/// The message about a pipe or a device: it may have no end, and can't be read again.
pub const NO_FILE: &str = "it is not a regular file";

/// Reads the text of a scene file.
///
/// # Errors
/// One line: the file, and why it can't be read.
pub fn text(path: &Path) -> Result<String, String> {
    let cannot = |why: &str| format!("cannot read {}: {why}", path.display());
    let bytes = match fs::metadata(path) {
        Ok(there) if !there.is_file() => return Err(cannot(NO_FILE)),
        _ => fs::read(path).map_err(|error| cannot(&error.to_string()))?,
    };
    String::from_utf8(bytes).map_err(|_| cannot("it is not UTF-8"))
}

/// A scene that has been read from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    /// The name of the file.
    pub name: String,
    /// How long it plays, in seconds.
    pub length: f32,
    /// The contents of the file, without the motions.
    tree: Value,
    motions: Vec<Motion>,
}

/// A mistake in a file: where it is, by its path, and what.
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
        Self::parse(name, &text(Path::new(name))?)
    }

    /// Reads a scene from the text of a file.
    ///
    /// # Errors
    /// As [`SceneFile::read`].
    pub fn parse(name: &str, text: &str) -> Result<Self, String> {
        let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        let (tree, motions) = reading::read(text).map_err(|error| {
            let start = error.span.start;
            format!("{name}:{}:{}: {}", start.line, start.col, error.code)
        })?;
        Self::of(name, tree, motions).map_err(|Fault { path, what }| {
            let place = Places::of(text).find(&path).unwrap_or_default();
            let (line, column) = line_and_column(text, place.start);
            let subject = if path.is_empty() { "the scene" } else { &path };
            format!("{name}:{line}:{column}: {subject} {what}")
        })
    }

    fn of(name: &str, tree: Value, motions: Vec<Motion>) -> Result<Self, Fault> {
        check_numbers(&tree)?;
        check_lists(&tree)?;
        let length = tree::number(&tree["length"]);
        if !(length > 0.0 && length <= 3600.0) {
            let what = format!("is {length}, and takes seconds up to 3600");
            return Err(fault("length", what));
        }
        let file = Self {
            name: name.to_owned(),
            length,
            tree,
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

    /// The scene at a time in seconds.
    pub fn at(&self, time: f32) -> Scene {
        let mut tree = Cow::Borrowed(&self.tree);
        for motion in &self.motions {
            let value = serde_json::to_value(motion.at(time)).unwrap_or_default();
            path::set(tree.to_mut(), &motion.of, value);
        }
        tree::scene(&tree)
    }
}

/// Checks that all numbers are finite.
fn check_numbers(tree: &Value) -> Result<(), Fault> {
    let mut none = None;
    path::leaves(tree, String::new(), &mut |path, value| {
        // Only a light without a cone may have nothing for it.
        if value.is_null() && !path.ends_with(".spot") && none.is_none() {
            none = Some(path);
        }
    });
    match none {
        None => Ok(()),
        Some(path) => Err(fault(path, "is no number, and takes a finite one")),
    }
}

/// Checks that the library has room for everything, and that every object's material is in the table.
fn check_lists(tree: &Value) -> Result<(), Fault> {
    let mut capacities = Vec::new();
    Scene::default().visit(&mut |field| {
        if let Place::List(items) = field.value {
            capacities.push((field.name, items.capacity()));
        }
    });
    for (list, most) in capacities {
        let items = tree[list].as_array().map_or(&[][..], Vec::as_slice);
        if items.len() > most {
            let what = format!("has {}, and takes up to {most}", items.len());
            return Err(fault(list, what));
        }
        for (i, item) in items.iter().enumerate() {
            let word = |field: &str| item.get(field).and_then(Value::as_str);
            if let Some(letters) = word("letters")
                && (letters.len() > MAX_LETTERS || !letters.is_ascii())
            {
                let what =
                    format!("is {letters:?}, and takes up to {MAX_LETTERS} letters of ASCII");
                return Err(fault(format!("{list}[{i}].letters"), what));
            }
            if let Some(name) = word("material")
                && tree["materials"].get(name).is_none()
            {
                let materials = tree["materials"].as_object().into_iter().flatten();
                let names: Vec<String> = materials.map(|(name, _)| format!("{name:?}")).collect();
                let what = format!(
                    "is {name:?}, and takes one of materials: {}",
                    names.join(", ")
                );
                return Err(fault(format!("{list}[{i}].material"), what));
            }
        }
    }
    Ok(())
}
