//! A scene file as Rust source: a function of the time, for an intro of one's own.

use super::motion::Motion;
use super::tree::{self, TURN};
use super::{SceneFile, path, ron_text};
use anyhow::{Result, bail};
use eightfold_tracer::scene::{Fields, Items, Material, Scene, Value as Place};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fmt::Write;

/// Source text of a module with a function that gives the file's scene at a time. What the file moves is moved by functions that
/// stand below it.
///
/// # Errors
/// If two materials have the same name but for what variables can't have, or two motions move the same number.
pub fn rust(file: &SceneFile) -> Result<String> {
    for (i, motion) in file.motions.iter().enumerate() {
        let mut others = file.motions[..i].iter();
        if let Some(other) = others.find(|other| overlap(other, motion)) {
            bail!("{} and {} move the same", other.of, motion.of);
        }
    }
    let printer = Printer {
        motions: &file.motions,
    };
    let mut tree = file.tree.clone();
    ron_text::prune(&mut tree);
    // What moves is told, even from where it would be without a word.
    for motion in &file.motions {
        let field = field(&motion.of);
        let value = path::get(&file.tree, field).cloned();
        path::set(&mut tree, field, value.unwrap_or_default());
    }
    let mut body = String::new();
    let mut variables = BTreeSet::new();
    for (name, material) in tree["materials"].as_object().into_iter().flatten() {
        let path = format!("materials[{name:?}]");
        let material = printer.record(&path, &mut Material::default(), material);
        if !variables.insert(variable(name)) {
            bail!("the name of material {name:?} is too much like that of another");
        }
        let _ = writeln!(body, "let {} = {material};", variable(name));
    }
    body += &printer.record("", &mut Scene::default(), &tree);
    let (time, keys) = if file.motions.is_empty() {
        ("_time", "")
    } else {
        ("time", "use keys::*;")
    };
    let mut text = format!(
        "//! Made of {} by `cargo lab scene --rust`.\n\n{UNUSED}\nuse eightfold_tracer::{{glam::*, scene::*}};\n{keys}\n\n\
         /// How long the scene plays, in seconds.\npub const LENGTH: f32 = {:?};\n\n/// The scene at a time in seconds.\n\
         pub fn scene({time}: f32) -> Scene {{\n{body}}}\n",
        file.name, file.length,
    );
    if !file.motions.is_empty() {
        let _ = write!(
            text,
            "\n{UNUSED}\nmod keys {{\n{}}}\n",
            include_str!("keys.rs")
        );
    }
    Ok(prettyplease::unparse(&syn::parse_file(&text)?))
}

/// The text before imports and before the functions that interpolate.
const UNUSED: &str = "#[allow(unused, reason = \"not every scene needs all of it\")]";

/// Whether two motions move a number that is the same, or a part of the other's.
fn overlap(a: &Motion, b: &Motion) -> bool {
    let rest = a.of.strip_prefix(&b.of).or(b.of.strip_prefix(&a.of));
    rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('['))
}

/// The path of the field that a path is in: of `spheres[0].centre[1]` it is `spheres[0].centre`.
fn field(path: &str) -> &str {
    let name = path.rfind('.').map_or(0, |dot| dot + 1);
    let part = path[name..].find('[');
    &path[..part.map_or(path.len(), |part| name + part)]
}

/// Prints values as Rust expressions.
struct Printer<'a> {
    motions: &'a [Motion],
}

impl Printer<'_> {
    /// A struct with its fields, and where the others come from.
    fn record(&self, path: &str, fields: &mut dyn Fields, value: &Value) -> String {
        let kind = fields.name();
        let mut said = Vec::new();
        let more = format!("..{kind}::default()");
        let mut are_all_said = !fields.grows();
        fields.visit(&mut |field| {
            let name = field.name;
            let path = match path {
                "" => name.to_owned(),
                _ => format!("{path}.{name}"),
            };
            let turn = value
                .get(TURN)
                .filter(|_| matches!(field.value, Place::Axes(_)));
            let own = value
                .get(name)
                .map(|value| self.value(&path, field.value, value));
            let text = match (own, turn) {
                (own, Some(turn)) => self.turned(&path, own, turn),
                (Some(own), None) => own,
                (None, None) => {
                    are_all_said = false;
                    return;
                }
            };
            said.push(format!("{name}: {text}, "));
        });
        let others = if are_all_said { "" } else { &more };
        format!("{kind} {{ {}{others} }}", said.concat())
    }

    /// A value of a file that the library has at a place.
    fn value(&self, path: &str, place: Place<'_>, value: &Value) -> String {
        let word = value.as_str().unwrap_or_default();
        match place {
            Place::Number(_) | Place::Vector(_) | Place::Axes(_) => self.numbers(path, value),
            Place::Flag(_) => value.to_string(),
            Place::Letters(_) => format!("List::of(b\"{}\")", word.as_bytes().escape_ascii()),
            Place::Shape(_) => format!("Shape::{word}"),
            Place::Material(_) => variable(word),
            Place::Struct(fields) => self.record(path, fields, value),
            Place::Optional(items) => format!("Some({})", self.item(path, items, value)),
            Place::List(items) => {
                let values = value.as_array().into_iter().flatten().enumerate();
                let texts =
                    values.map(|(i, value)| self.item(&format!("{path}[{i}]"), items, value));
                format!("List::of(&[{}])", texts.collect::<Vec<_>>().join(", "))
            }
        }
    }

    /// An item of others.
    fn item(&self, path: &str, items: &mut dyn Items, value: &Value) -> String {
        let mut text = String::new();
        items.reset(1);
        items.each(&mut |item| text = self.record(path, item, value));
        text
    }

    /// A number, a vector or axes, which may move in whole or in part.
    fn numbers(&self, path: &str, value: &Value) -> String {
        if let Some(motion) = self.motions.iter().find(|motion| motion.of == path) {
            return moved(motion);
        }
        let Some(parts) = value.as_array() else {
            return format!("{:?}", tree::number(value));
        };
        let texts = parts.iter().enumerate();
        let texts = texts.map(|(i, part)| self.numbers(&format!("{path}[{i}]"), part));
        let texts = texts.collect::<Vec<_>>().join(", ");
        if parts.iter().any(Value::is_array) {
            format!("Mat3A::from_cols({texts})")
        } else {
            format!("vec3a({texts})")
        }
    }

    /// The axes at a path after their turn.
    fn turned(&self, path: &str, axes: Option<String>, turn: &Value) -> String {
        let parent = path.rsplit_once('.').map_or("", |(parent, _)| parent);
        let turn = self.numbers(&format!("{parent}.{TURN}"), turn);
        let axes = axes.map(|axes| format!("{axes} * ")).unwrap_or_default();
        format!(
            "{{ let turn = {turn}; {axes}Mat3A::from_euler(EulerRot::YXZ, turn.y, turn.x, turn.z) }}"
        )
    }
}

/// A motion as a call of the function that interpolates it.
fn moved(motion: &Motion) -> String {
    let still = Printer { motions: &[] };
    let keys = motion.keys.iter();
    let keys =
        keys.map(|(time, value)| format!("({time:?}, {})", still.numbers("", &json!(value))));
    let keys = keys.collect::<Vec<_>>().join(", ");
    let time = match motion.period() {
        Some(period) => format!("time.rem_euclid({period:?})"),
        None => "time".to_owned(),
    };
    // The functions have the names of the ways.
    let function = format!("{:?}", motion.between).to_lowercase();
    format!("{function}(&[{keys}], {time})")
}

/// A material's name as that of a variable.
fn variable(name: &str) -> String {
    let words: String = name
        .chars()
        .map(|c| {
            if c.is_ascii_alphanumeric() {
                c.to_ascii_lowercase()
            } else {
                '_'
            }
        })
        .collect();
    format!("material_{words}")
}
