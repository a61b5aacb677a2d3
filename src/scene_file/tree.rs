//! Scenes as scene files have them: trees of values by the names of the library's fields, with the materials in a table of their own,
//! and with a turn beside the axes of a block.

use eightfold::show;
use eightfold_tracer::glam::{EulerRot, Mat3A};
use eightfold_tracer::scene::{Fields, Material, Scene, Shape, Value as Place};
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// The name of what is beside a struct's axes in a file: the angles by which it is turned, in radians, about its own z axis first,
/// then x, then y.
pub const TURN: &str = "turn";

/// How [`Shape`] is written.
#[derive(Serialize, Deserialize)]
#[serde(remote = "Shape")]
pub enum NamedShape {
    Box,
    Cylinder,
    Capsule,
}

/// A struct with all its fields.
pub fn of(fields: &mut dyn Fields) -> Value {
    let mut tree = Map::new();
    fields.visit(&mut |field| {
        let is_turned = matches!(field.value, Place::Axes(_));
        tree.insert(field.name.to_owned(), value(field.value));
        if is_turned {
            tree.insert(TURN.to_owned(), json!([0.0, 0.0, 0.0]));
        }
    });
    Value::Object(tree)
}

/// The value of a field.
pub fn value(place: Place<'_>) -> Value {
    match place {
        Place::Number(number) => json!(number),
        Place::Vector(vector) => json!(vector.to_array()),
        Place::Axes(axes) => json!(axes.to_cols_array_2d()),
        Place::Flag(flag) => json!(flag),
        Place::Shape(shape) => {
            let name = NamedShape::serialize(shape, serde_json::value::Serializer);
            name.unwrap_or_default()
        }
        Place::Letters(letters) => json!(String::from_utf8_lossy(letters)),
        Place::Material(material) => of(material),
        Place::Struct(fields) => of(fields),
        Place::Optional(items) => {
            let mut tree = Value::Null;
            items.each(&mut |item| tree = of(item));
            tree
        }
        Place::List(items) => {
            let mut list = Vec::new();
            items.each(&mut |item| list.push(of(item)));
            Value::Array(list)
        }
    }
}

/// The contents of an empty file: no objects, and the length of the model scene.
pub fn standard() -> Value {
    named(&Scene::default(), show::MODEL_LENGTH, &[])
}

/// A scene that plays for some time, and whose objects have materials of these names.
pub fn named(scene: &Scene, length: f32, names: &[String]) -> Value {
    let mut fields = of(&mut scene.clone());
    let mut materials = Map::new();
    for (material, name) in object_materials(&mut fields).into_iter().zip(names) {
        materials.insert(name.clone(), std::mem::replace(material, json!(name)));
    }
    let mut tree = Map::new();
    tree.insert("length".to_owned(), json!(length));
    if let Value::Object(fields) = fields {
        for (name, value) in fields {
            // The table stands before the first list of objects.
            if value.is_array() && !value[0].is_number() {
                let table = || std::mem::take(&mut materials).into();
                tree.entry("materials").or_insert_with(table);
            }
            tree.insert(name, value);
        }
    }
    Value::Object(tree)
}

/// The materials of all objects, or their names.
fn object_materials(tree: &mut Value) -> Vec<&mut Value> {
    let fields = tree.as_object_mut().into_iter().flatten();
    let items = fields.filter_map(|(_, value)| value.as_array_mut());
    let materials = items.flatten().map(|item| item.get_mut("material"));
    materials.flatten().collect()
}

/// The name of each object's material in scenes that have the same objects. Objects share a material if it is the same in all scenes,
/// to the bit; materials are numbered in the order in which objects first have them.
pub fn material_names<'a>(scenes: impl Iterator<Item = &'a Scene>) -> Vec<String> {
    let series: Vec<Vec<Material>> = scenes.map(|scene| materials(&mut scene.clone())).collect();
    let objects = series.first().map_or(0, Vec::len);
    let mut known: Vec<usize> = Vec::new();
    let is_same = |a: Option<&Material>, b: Option<&Material>| {
        // 0 and -0 are equal, but not the same.
        a == b && format!("{a:?}") == format!("{b:?}")
    };
    let names = (0..objects).map(|object| {
        let is_shared = |&other: &usize| {
            let mut all = series.iter();
            all.all(|materials| is_same(materials.get(object), materials.get(other)))
        };
        let number = known.iter().position(is_shared).unwrap_or_else(|| {
            known.push(object);
            known.len() - 1
        });
        // As many digits for all, so that they are in order.
        format!("material {:03}", number + 1)
    });
    names.collect()
}

/// The materials of a scene's objects.
fn materials(fields: &mut dyn Fields) -> Vec<Material> {
    let mut all = Vec::new();
    fields.visit(&mut |field| match field.value {
        Place::Material(material) => all.push(*material),
        Place::List(items) => items.each(&mut |item| all.extend(materials(item))),
        _ => {}
    });
    all
}

/// The scene that a tree has in it.
pub fn scene(tree: &Value) -> Scene {
    let mut scene = Scene::default();
    put(&mut scene, tree, &tree["materials"]);
    scene
}

/// Gives a struct what a tree says. Where that says nothing, the struct stays as it is.
fn put(fields: &mut dyn Fields, tree: &Value, materials: &Value) {
    fields.visit(&mut |field| {
        let Some(value) = tree.get(field.name) else {
            return;
        };
        let word = value.as_str().unwrap_or_default();
        match field.value {
            Place::Number(place) => *place = number(value),
            Place::Vector(place) => *place = vector(value).into(),
            Place::Axes(place) => *place = turned(value, &tree[TURN]),
            Place::Flag(place) => *place = value == &Value::Bool(true),
            Place::Shape(place) => *place = NamedShape::deserialize(value).unwrap_or(*place),
            Place::Letters(letters) => *letters = word.bytes().collect(),
            Place::Material(material) => put(material, &materials[word], materials),
            Place::Struct(fields) => put(fields, value, materials),
            Place::Optional(items) => {
                items.reset(usize::from(value.is_object()));
                items.each(&mut |item| put(item, value, materials));
            }
            Place::List(items) => {
                let values = value.as_array().map_or(&[][..], Vec::as_slice);
                items.reset(values.len());
                let mut values = values.iter();
                items.each(&mut |item| {
                    if let Some(value) = values.next() {
                        put(item, value, materials);
                    }
                });
            }
        }
    });
}

/// Axes after their turn. Without one they are as they are written, to the bit.
fn turned(axes: &Value, turn: &Value) -> Mat3A {
    let axes = Mat3A::from_cols_array_2d(&[0, 1, 2].map(|i| vector(&axes[i])));
    let [x, y, z] = vector(turn);
    if [x, y, z] == [0.0; 3] {
        return axes;
    }
    let turn = Mat3A::from_euler(EulerRot::YXZ, y, x, z);
    // A product with the identity would lose the signs of zeros.
    if axes == Mat3A::IDENTITY {
        turn
    } else {
        axes * turn
    }
}

/// A vector's numbers.
fn vector(value: &Value) -> [f32; 3] {
    [0, 1, 2].map(|i| number(&value[i]))
}

/// A number as the library has it.
pub fn number(value: &Value) -> f32 {
    value.as_f64().unwrap_or_default() as f32
}
