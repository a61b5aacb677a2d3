//! The text of a scene file: one object on a line, and nothing that is as it would be without a word.

use super::description::{Caption, Description, Light, Material};
use super::motion::Motion;
use serde_json::Value;
use std::fmt::Write;

/// The text of a file that describes a scene.
pub fn text(description: &Description) -> String {
    let Value::Object(tree) = tree(description) else {
        return String::new();
    };
    let mut text = "Scene(\n".to_owned();
    let mut line = |indent: usize, line: &str| {
        let _ = writeln!(text, "{:1$}{line}", "", 4 * indent);
    };
    for (name, value) in &tree {
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
    if !description.motions.is_empty() {
        line(1, "motions: [");
        for motion in &description.motions {
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

/// What a description says beyond what would be there without a word; its motions excepted.
pub fn tree(description: &Description) -> Value {
    let value = |value: serde_json::Result<Value>| value.unwrap_or_default();
    let standard = value(serde_json::to_value(Description::default()));
    let mut tree = value(serde_json::to_value(description));
    prune(&mut tree, &standard);
    let kinds = [
        (
            "materials",
            value(serde_json::to_value(Material::default())),
        ),
        ("lights", value(serde_json::to_value(Light::default()))),
        ("captions", value(serde_json::to_value(Caption::default()))),
        (
            "blocks",
            serde_json::json!({
                "shape": "Box",
                "axes": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                "turn": [0.0, 0.0, 0.0],
            }),
        ),
    ];
    for (list, standard) in kinds {
        match tree.get_mut(list) {
            Some(Value::Array(items)) => items.iter_mut().for_each(|item| prune(item, &standard)),
            Some(Value::Object(items)) => {
                items.values_mut().for_each(|item| prune(item, &standard));
            }
            _ => {}
        }
    }
    if let Value::Object(tree) = &mut tree {
        tree.remove("motions");
    }
    tree
}

/// Takes away the fields that are as in the standard.
fn prune(value: &mut Value, standard: &Value) {
    let (Value::Object(fields), Value::Object(standard)) = (value, standard) else {
        return;
    };
    fields.retain(|name, field| standard.get(name) != Some(field));
    for (name, field) in fields {
        if let Some(standard) = standard.get(name) {
            prune(field, standard);
        }
    }
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
