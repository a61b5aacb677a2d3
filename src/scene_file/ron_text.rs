//! The text of a scene file: one object on a line, and nothing that is as it would be without a word.

use super::motion::Motion;
use super::tree::{self, TURN};
use eightfold_tracer::scene::{Fields, Material, Scene, Value as Place};
use serde_json::{Value, json};
use std::fmt::Write;

/// The text of a file with a tree and motions.
pub fn text(mut tree: Value, motions: &[Motion]) -> String {
    prune(&mut tree);
    let mut text = "Scene(\n".to_owned();
    let mut line = |indent: usize, line: &str| {
        let _ = writeln!(text, "{:1$}{line}", "", 4 * indent);
    };
    for (name, value) in tree.as_object().into_iter().flatten() {
        match value {
            Value::Object(entries) if name == "materials" => {
                line(1, "materials: {");
                for (name, material) in entries {
                    line(2, &format!("{name:?}: {},", inline(material)));
                }
                line(1, "},");
            }
            Value::Array(items) if items.iter().any(Value::is_object) => {
                line(1, &format!("{name}: ["));
                for item in items {
                    line(2, &format!("{},", inline(item)));
                }
                line(1, "],");
            }
            _ => line(1, &format!("{name}: {},", inline(value))),
        }
    }
    if !motions.is_empty() {
        line(1, "motions: [");
        for motion in motions {
            write_motion(&mut line, motion);
        }
        line(1, "],");
    }
    text + ")\n"
}

/// A motion by [`Between::Linear`](super::motion::Between), as all are that are recorded.
fn write_motion(line: &mut impl FnMut(usize, &str), motion: &Motion) {
    line(2, &format!("(of: {:?}, keys: [", motion.of));
    for (time, numbers) in &motion.keys {
        let numbers = serde_json::to_value(numbers).unwrap_or_default();
        line(3, &format!("({time:?}, {}),", inline(&numbers)));
    }
    line(2, "]),");
}

/// Takes away from the tree of a file what is as it would be without a word.
pub fn prune(tree: &mut Value) {
    let standard = tree::standard();
    for material in tree["materials"].as_object_mut().into_iter().flatten() {
        prune_struct(&mut Material::default(), material.1);
    }
    prune_struct(&mut Scene::default(), tree);
    for field in ["length", "materials"] {
        prune_field(tree, field, &standard[field]);
    }
}

/// Takes away a field that is the same as in the standard, to the bit: 0 is not -0.
fn prune_field(tree: &mut Value, name: &str, standard: &Value) {
    if let Some(fields) = tree.as_object_mut()
        && fields.get(name).map(Value::to_string) == Some(standard.to_string())
    {
        fields.shift_remove(name);
    }
}

/// Takes away the fields of a struct that are as in the standard.
fn prune_struct(standard: &mut dyn Fields, tree: &mut Value) {
    standard.visit(&mut |field| {
        let name = field.name;
        let value = tree.get_mut(name);
        let standard = match field.value {
            _ if field.is_needed => return,
            Place::Struct(standard) => {
                value
                    .into_iter()
                    .for_each(|value| prune_struct(standard, value));
                json!({})
            }
            Place::List(items) => {
                let values = value.and_then(Value::as_array_mut);
                for value in values.into_iter().flatten() {
                    items.reset(1);
                    items.each(&mut |standard| prune_struct(standard, value));
                }
                json!([])
            }
            Place::Axes(axes) => {
                prune_field(tree, TURN, &json!([0.0, 0.0, 0.0]));
                tree::value(Place::Axes(axes))
            }
            place => tree::value(place),
        };
        prune_field(tree, name, &standard);
    });
}

/// A value on one line. Numbers are those of `f32`, by as few digits as tell them from others.
pub fn inline(value: &Value) -> String {
    match value {
        Value::Null => "None".to_owned(),
        Value::Bool(is_so) => is_so.to_string(),
        Value::Number(number) => format!("{:?}", number.as_f64().unwrap_or_default() as f32),
        Value::String(text) => format!("{text:?}"),
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(inline).collect();
            format!("({})", items.join(", "))
        }
        Value::Object(fields) => {
            let fields = fields
                .iter()
                .map(|(name, value)| match (name.as_str(), value) {
                    // The one that is a name and no text.
                    ("shape", Value::String(shape)) => format!("shape: {shape}"),
                    _ => format!("{name}: {}", inline(value)),
                });
            format!("({})", fields.collect::<Vec<_>>().join(", "))
        }
    }
}
