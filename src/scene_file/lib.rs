//! The crate of scene files in RON, see docs/lab.md: the fields of [`Scene`] and [`Presentation`],
//! named materials, and motions.

mod check;
mod message;
mod motion;
mod moving;
mod node;

pub use message::one_line;

use eightfold_tracer::presentation::Moment;
use eightfold_tracer::scene::{Camera, Material};
#[cfg(doc)]
use eightfold_tracer::{presentation::Presentation, scene::Scene};
use message::{located, syntax};
use motion::Motion;
use moving::Moving;
use node::{Kind, Mistake, Node, UNKNOWN};
use serde::Deserialize;
use std::collections::BTreeMap;

const LENGTH: f32 = 8.0 * std::f32::consts::PI;

/// Some editors begin a text with it, without a column.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// A scene file. An error of its functions is one line: file, line and column, then the value and
/// its range.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneFile {
    pub name: String,
    pub length: f32,
    text: String,
    moving: Moving,
}

impl SceneFile {
    /// Decodes a file's bytes, which must be UTF-8.
    pub fn decode(name: &str, bytes: Vec<u8>) -> Result<String, String> {
        String::from_utf8(bytes).map_err(|error| {
            let (bytes, at) = (error.as_bytes(), error.utf8_error().valid_up_to());
            let text = String::from_utf8_lossy(&bytes[..at]);
            let message = format!("byte is 0x{:02x}; must be UTF-8", bytes[at]);
            located(name, &text, at, &message)
        })
    }

    /// Parses a text, and checks the scene at all times up to its length and to the last key.
    pub fn parse(name: &str, text: &str) -> Result<Self, String> {
        let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
        let tree = Node::read(text).map_err(|error| {
            let (at, message) = syntax(text, &error);
            located(name, text, at, &message)
        })?;
        let file = Self::of(name, text, tree);
        file.map_err(|mistake| place(name, text, &mistake))
    }

    fn of(name: &str, text: &str, mut tree: Node) -> Result<Self, Mistake> {
        let mut length = LENGTH;
        if let Some(node) = tree.take("length") {
            length = f32::deserialize(&node)?;
            if !(length > 0.0 && length <= 3600.0) {
                let message = format!("length is {length}; must be above 0, at most 3600");
                return Err(Mistake::new(node.at, message));
            }
        }
        let motions = tree.take("motions").unwrap_or_default();
        if let Kind::Number(_) | Kind::Word(_) = motions.kind {
            return Err(Mistake::new(motions.at, "motions must be a list"));
        }
        let motions = motions.parts.into_iter().enumerate().map(Motion::read);
        let motions: Vec<Motion> = motions.collect::<Result<_, _>>()?;
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
        let moving = Moving { tree, motions, ..Moving::default() };
        moving.check(length)?;
        let (name, text) = (name.to_owned(), text.to_owned());
        Ok(Self { name, length, text, moving })
    }

    pub fn at(&self, time: f32) -> Moment {
        let moment = self.moving.moment(time);
        moment.expect("a file that was read is a scene at all times")
    }

    /// Checks the scene at a time, which may be before the start or after the end.
    pub fn check(&self, time: f32) -> Result<(), String> {
        let scene = self.moving.valid(time);
        scene.map_or_else(|mistake| Err(place(&self.name, &self.text, &mistake)), |_| Ok(()))
    }
}

fn place(name: &str, text: &str, mistake: &Mistake) -> String {
    let mut at = mistake.at.unwrap_or(0);
    let message = mistake.message.trim_start_matches('.');
    if let Some((path, _)) = message.split_once(UNKNOWN) {
        let name = path.rsplit('.').next().unwrap_or(path);
        at = text[..at].rfind(name).unwrap_or(at);
    }
    let thing = ["", "value"][usize::from(message.starts_with(['[', ' ']))];
    located(name, text, at, &format!("{thing}{message}"))
}
