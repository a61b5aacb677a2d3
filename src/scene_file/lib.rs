//! Scene files in RON: the fields of [`Scene`], named materials, and motions. `examples/scenes` has a file for each feature.

mod motion;
mod node;

use eightfold_tracer::glam::{EulerRot, Mat3};
use eightfold_tracer::scene::{Camera, Material, Scene};
use motion::Motion;
use node::{Kind, Mistake, Node, UNKNOWN};
use ron::error::SpannedError;
use serde::Deserialize;
use std::collections::BTreeMap;

/// The default `length` in seconds.
const LENGTH: f32 = 8.0 * std::f32::consts::PI;

/// The most letters of a word or a quotation in a message, and of the message.
const MAX_WORD: usize = 60;
const MAX_MESSAGE: usize = 600;

/// Some editors begin a text with it. It has no column.
const BYTE_ORDER_MARK: char = '\u{feff}';

#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    pub name: String,
    /// Seconds.
    pub length: f32,
    /// The contents without the length and the motions.
    tree: Node,
    motions: Vec<Motion>,
}

impl SceneFile {
    /// Parses the text of a file.
    ///
    /// # Errors
    /// One line: file, line, column, value, range.
    pub fn parse(name: &str, text: &str) -> Result<Self, String> {
        let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        let located =
            |line, column, message: &str| format!("{name}:{line}:{column}: {}", shortened(message));
        let tree = Node::read(text).map_err(|error| {
            let start = error.span.start;
            located(start.line, start.col, &syntax_message(text, &error))
        })?;
        Self::of(name, tree).map_err(|mistake| {
            let mut before = &text[..mistake.at.unwrap_or(0)];
            let message = mistake.message.trim_start_matches('.');
            if let Some((path, _)) = message.split_once(UNKNOWN) {
                let name = path.rsplit('.').next().unwrap_or(path);
                before = &before[..before.rfind(name).unwrap_or(before.len())];
            }
            let thing = ["", "value"][usize::from(message.starts_with(['[', ' ']))];
            let line = before.rsplit('\n').next().unwrap_or(before);
            let (lines, column) = (before.matches('\n').count(), line.chars().count());
            located(lines + 1, column + 1, &format!("{thing}{message}"))
        })
    }

    fn of(name: &str, mut tree: Node) -> Result<Self, Mistake> {
        let name = name.to_owned();
        let mut length = LENGTH;
        if let Some(node) = tree.take("length") {
            length = f32::deserialize(&node)?;
            if !(length > 0.0 && length <= 3600.0) {
                let message = format!("length is {length}; must be above 0, at most 3600");
                return Err(Mistake::new(node.at, message));
            }
        }
        let motions = tree.take("motions").unwrap_or_default().parts.into_iter();
        let motions: Vec<Motion> = motions.map(Motion::read).collect::<Result<_, _>>()?;
        // A motion can set a part of an omitted vector.
        if let Some(camera) = tree.get_mut("camera")
            && camera.get("up").is_none()
            && let Some(up) = camera.place("up", camera.at)
        {
            up.set(&Camera::default().up.to_array());
        }
        if let Some(materials) = tree.get("materials") {
            BTreeMap::<String, Material>::deserialize(materials)?;
        }
        let file = Self {
            name,
            length,
            tree,
            motions,
        };
        let keys = file.motions.iter().flat_map(|motion| &motion.keys);
        for time in keys.map(|key| key.time).chain([0.0]) {
            let tree = file.tree_at(time)?;
            if let Err(error) = Scene::deserialize(&tree)?.validate() {
                let message = error.to_string();
                let path = message.split(' ').next().unwrap_or_default();
                return Err(Mistake::new(tree.nearest(path).at, message));
            }
        }
        Ok(file)
    }

    pub fn at(&self, time: f32) -> Scene {
        let tree = self.tree_at(time);
        let scene = tree.and_then(|tree| Scene::deserialize(&tree));
        scene.expect("a file that is valid at its keys is a scene at all times")
    }

    /// Returns the tree at a time, with materials in place of their names.
    fn tree_at(&self, time: f32) -> Result<Node, Mistake> {
        let mut tree = self.tree.clone();
        for motion in &self.motions {
            let of = &motion.of;
            let message = format!("path is {of:?}; must lead to a value in the file");
            let (at, numbers) = motion.at(time);
            let place = tree.place(of, at);
            place.ok_or(Mistake::new(at, message))?.set(&numbers);
        }
        let materials = tree.take("materials").unwrap_or_default();
        for list in ["spheres", "planes", "blocks"] {
            let objects = tree.get_mut(list).map(|list| &mut list.parts);
            for object in objects.into_iter().flatten() {
                if let Some(material) = object.get_mut("material")
                    && let Kind::Word(_) = material.kind
                {
                    let name = String::deserialize(&*material)?;
                    let message = format!("material is {name:?}; must be in materials");
                    let mistake = Mistake::new(material.at, message);
                    material.copy(materials.get(&name).ok_or(mistake)?);
                }
                if list == "blocks" {
                    turn(object)?;
                }
            }
        }
        Ok(tree)
    }
}

fn syntax_message(text: &str, error: &SpannedError) -> String {
    let why = error.code.to_string();
    let expected = match &error.code {
        ron::Error::Eof => return "file is incomplete".to_owned(),
        ron::Error::TrailingCharacters => Some("the end of the file"),
        _ => why.strip_prefix("Expected "),
    };
    let Some(expected) = expected.and_then(|words| words.split(" but found").next()) else {
        return why;
    };
    let line = text.lines().nth(error.span.start.line.saturating_sub(1));
    let rest = line.unwrap_or_default().chars();
    let rest: String = rest.skip(error.span.start.col.saturating_sub(1)).collect();
    let found = rest.split_whitespace().next().unwrap_or_default();
    format!("text is '{found}'; must be {expected}")
}

/// Joins lines, and cuts long words and quotations.
fn shortened(message: &str) -> String {
    let line = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let parts = line.split('"').enumerate().map(|(i, part)| match i % 2 {
        0 => part
            .split(' ')
            .map(|word| cut(word, MAX_WORD))
            .collect::<Vec<_>>()
            .join(" "),
        _ => cut(part, MAX_WORD),
    });
    cut(&parts.collect::<Vec<_>>().join("\""), MAX_MESSAGE)
}

/// Cuts a text after `most` letters, except for the punctuation at its end.
fn cut(text: &str, most: usize) -> String {
    let Some((end, _)) = text.char_indices().nth(most) else {
        return text.to_owned();
    };
    let signs = text[end..].rsplit(char::is_alphanumeric).next();
    let signs: String = signs.unwrap_or_default().chars().take(2).collect();
    format!("{}...{signs}", &text[..end])
}

/// Rotates the axes of a block by its `turn`: radians about its z axis first, then x, then y.
fn turn(block: &mut Node) -> Result<(), Mistake> {
    if let Some(axes) = block.get_mut("axes")
        && axes.parts.len() == 3
    {
        // A file has a list per axis, serde one for all.
        let numbers = axes.parts.iter().flat_map(|axis| axis.parts.clone());
        axes.parts = numbers.collect();
    }
    if let Some(turn) = block.take("turn") {
        let [x, y, z] = <[f32; 3]>::deserialize(&turn)?;
        let mut axes = Mat3::from_euler(EulerRot::YXZ, y, x, z);
        // A product with the identity loses the signs of zeros.
        if let Some(before) = block.get("axes") {
            axes = Mat3::deserialize(before)? * axes;
        }
        if let Some(place) = block.place("axes", turn.at) {
            place.set(&axes.to_cols_array());
        }
    }
    Ok(())
}
