//! A scene file as Rust source: a function of the time, for an intro of one's own.

use super::motion::{Between, Motion, Numbers};
use super::{SceneFile, path, ron_text};
use anyhow::{Result, bail};
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::Write;

/// A struct of the library as scene files have it.
struct Struct {
    /// The field of a scene file that has one, several in a list, or several by name.
    field: &'static str,
    name: &'static str,
    /// The number of its fields in the library.
    fields: usize,
    /// Where the fields come from that a file leaves out.
    others: &'static str,
}

const fn library(
    field: &'static str,
    name: &'static str,
    fields: usize,
    others: &'static str,
) -> Struct {
    Struct {
        field,
        name,
        fields,
        others,
    }
}

const STRUCTS: [Struct; 12] = [
    library("camera", "Camera", 4, "Camera::default()"),
    library("film", "Film", 2, "Film::default()"),
    library("method", "Method", 3, "Method::default()"),
    library("materials", "Material", 10, "Material::BLACK"),
    library("pattern", "Pattern", 5, "Pattern::NONE"),
    library("spheres", "Sphere", 3, "Sphere::default()"),
    library("planes", "Plane", 4, "Plane::default()"),
    library("water", "Waves", 3, "Waves::default()"),
    library("blocks", "Block", 5, "Block::default()"),
    library("lights", "Light", 7, "Light::DARK"),
    library("spot", "Spot", 3, "Spot::default()"),
    library("captions", "Caption", 4, "Caption::default()"),
];

/// Source text of a module with a function that gives the file's scene at a time. What the file moves is moved by functions that
/// stand below it.
///
/// # Errors
/// If two materials have the same name but for what variables can't have.
pub fn rust(file: &SceneFile) -> Result<String> {
    let printer = Printer {
        motions: &file.motions,
    };
    let description = file.description();
    let mut tree = ron_text::tree(&description);
    // What moves is told, even from where it would be without a word.
    for motion in &file.motions {
        let value = path::get(&file.tree, &motion.of).cloned();
        path::set(&mut tree, &motion.of, value.unwrap_or_default());
    }
    let mut body = String::new();
    let mut variables = BTreeSet::new();
    for (name, material) in tree["materials"].as_object().into_iter().flatten() {
        let path = format!("materials[{name:?}]");
        let material = printer.value(&path, "materials", material);
        if !variables.insert(variable(name)) {
            bail!("the name of material {name:?} is too much like that of another");
        }
        let _ = writeln!(body, "let {} = {material};", variable(name));
    }
    let mut fields = String::new();
    for (name, value) in tree.as_object().into_iter().flatten() {
        if !["length", "materials"].contains(&name.as_str()) {
            let _ = writeln!(fields, "{name}: {},", printer.value(name, name, value));
        }
    }
    let time = if file.motions.is_empty() {
        "_time"
    } else {
        "time"
    };
    let _ = writeln!(body, "Scene {{ {fields} ..Scene::default() }}");
    let mut text = format!(
        "//! Made of {} by `cargo lab scene --rust`.\n\n{}\n\n/// How long the scene plays, in seconds.\n\
         pub const LENGTH: f32 = {:?};\n\n/// The scene at a time in seconds.\n\
         pub fn scene({time}: f32) -> Scene {{\n{body}}}\n",
        file.name,
        imports(&body, &file.motions),
        file.length,
    );
    if !file.motions.is_empty() {
        let _ = write!(
            text,
            "\n#[allow(dead_code, reason = \"not every scene needs all of it\")]\nmod keys {{\n{}}}\n",
            include_str!("keys.rs")
        );
    }
    Ok(prettyplease::unparse(&syn::parse_file(&text)?))
}

/// What the function needs of the library and of the module below it.
fn imports(body: &str, motions: &[Motion]) -> String {
    let words: BTreeSet<&str> = body
        .split(|c: char| !c.is_alphanumeric() && c != '_')
        .collect();
    let used = |names: &[&str]| -> Vec<&str> {
        let words = words.iter().copied();
        words.filter(|word| names.contains(word)).collect()
    };
    let mut text = String::new();
    let glam = used(&["EulerRot", "Mat3A", "vec3a"]);
    if !glam.is_empty() {
        let _ = writeln!(text, "use eightfold::glam::{{{}}};", glam.join(", "));
    }
    let structs = STRUCTS.iter().map(|kind| kind.name);
    let scene: Vec<&str> = structs.chain(["List", "Scene", "Shape"]).collect();
    let scene = used(&scene);
    let _ = write!(text, "use eightfold::scene::{{{}}};", scene.join(", "));
    let functions: BTreeSet<&str> = motions.iter().map(function).collect();
    if !functions.is_empty() {
        let functions: Vec<&str> = functions.into_iter().collect();
        let _ = write!(text, "\nuse keys::{{{}}};", functions.join(", "));
    }
    text
}

/// The function that interpolates a motion.
fn function(motion: &Motion) -> &'static str {
    match motion.between {
        Between::Linear => "linear",
        Between::Smooth => "smooth",
        Between::Spline => "spline",
        Between::Hold => "hold",
    }
}

/// Prints values as Rust expressions.
struct Printer<'a> {
    motions: &'a [Motion],
}

impl Printer<'_> {
    /// The value of a field.
    fn value(&self, path: &str, name: &str, value: &Value) -> String {
        if let Some(motion) = self.motions.iter().find(|motion| motion.of == path) {
            return moved(motion);
        }
        if let Some(kind) = STRUCTS.iter().find(|kind| kind.field == name) {
            return match value {
                Value::Array(items) => self.list(path, items, kind),
                _ if name == "spot" => format!("Some({})", self.record(path, value, kind)),
                _ => self.record(path, value, kind),
            };
        }
        match (name, value) {
            ("shape", Value::String(shape)) => format!("Shape::{shape}"),
            ("letters", Value::String(letters)) => format!("List::of(b{letters:?})"),
            ("material", Value::String(name)) => variable(name),
            ("parallel", Value::Bool(is_so)) => is_so.to_string(),
            _ => Numbers::of(value).map(numbers).unwrap_or_default(),
        }
    }

    /// Items of a list.
    fn list(&self, path: &str, items: &[Value], kind: &Struct) -> String {
        let items = items.iter().enumerate();
        let items = items.map(|(i, item)| self.record(&format!("{path}[{i}]"), item, kind));
        format!("List::of(&[{}])", items.collect::<Vec<_>>().join(", "))
    }

    /// A struct with its fields, and where the others come from.
    fn record(&self, path: &str, value: &Value, kind: &Struct) -> String {
        let mut fields: Vec<(String, String)> = Vec::new();
        for (name, value) in value.as_object().into_iter().flatten() {
            fields.push((
                name.clone(),
                self.value(&format!("{path}.{name}"), name, value),
            ));
        }
        let taken = |fields: &mut Vec<(String, String)>, name: &str| {
            let i = fields.iter().position(|(known, _)| known == name)?;
            Some(fields.remove(i).1)
        };
        if let Some(turn) = taken(&mut fields, "turn") {
            let axes = taken(&mut fields, "axes")
                .map(|axes| format!("{axes} * "))
                .unwrap_or_default();
            let turned = format!(
                "{{ let turn = {turn}; {axes}Mat3A::from_euler(EulerRot::YXZ, turn.y, turn.x, turn.z) }}"
            );
            fields.push(("axes".to_owned(), turned));
        }
        let others = if fields.len() == kind.fields {
            String::new()
        } else {
            format!(", ..{}", kind.others)
        };
        let fields: Vec<String> = fields
            .into_iter()
            .map(|(name, value)| format!("{name}: {value}"))
            .collect();
        format!("{} {{ {}{others} }}", kind.name, fields.join(", "))
    }
}

/// A motion as a call of the function that interpolates it.
fn moved(motion: &Motion) -> String {
    let keys = motion
        .keys
        .iter()
        .map(|&(time, value)| format!("({time:?}, {})", numbers(value)));
    let keys = keys.collect::<Vec<_>>().join(", ");
    let time = match motion.period() {
        Some(period) => format!("time.rem_euclid({period:?})"),
        None => "time".to_owned(),
    };
    format!("{}(&[{keys}], {time})", function(motion))
}

fn numbers(numbers: Numbers) -> String {
    let vector = |[x, y, z]: [f32; 3]| format!("vec3a({x:?}, {y:?}, {z:?})");
    match numbers {
        Numbers::One(number) => format!("{number:?}"),
        Numbers::Three(numbers) => vector(numbers),
        Numbers::Nine(axes) => format!("Mat3A::from_cols({})", axes.map(vector).join(", ")),
    }
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
