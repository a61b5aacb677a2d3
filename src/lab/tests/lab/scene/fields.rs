//! Every field of a scene is in its file, in the Rust made of that, and in what tells scenes from each other.

use super::{assert_is_compiled, contents, every_field};
use eightfold_scene_file::{SceneFile, text_of};
use eightfold_tracer::glam::{EulerRot, Mat3A};
use eightfold_tracer::scene::{Fields, List, Scene, Shape, Value, numbers};
use std::fs;

/// Fills all fields of a struct, and one of each list: numbers by a low-discrepancy sequence over their ranges, as far as these
/// are within 10 of 0, and what is no number with something else than without a word.
fn fill(fields: &mut dyn Fields, count: &mut u32) {
    fields.visit(&mut |field| match field.value {
        Value::Flag(flag) => *flag = true,
        Value::Shape(shape) => *shape = Shape::Cylinder,
        Value::Letters(letters) => *letters = List::of(b"\"8\\\x7f\n#"),
        Value::Optional(items) | Value::List(items) => {
            items.reset(1);
            items.each(&mut |item| fill(item, count));
        }
        Value::Material(material) => fill(material, count),
        Value::Struct(fields) => fill(fields, count),
        Value::Number(_) | Value::Vector(_) | Value::Axes(_) => {}
    });
    numbers(fields, &mut |_, range, number| {
        *count += 1;
        let least = range
            .least
            .max(if range.takes.is_empty() { 0.5 } else { -10.0 });
        let share = f64::from(*count) * 0.618_034 % 1.0;
        *number = least + (range.most.min(10.0) - least) * (0.1 + 0.8 * share as f32);
    });
}

/// A valid scene of which every field is another one than without a word.
fn every() -> Scene {
    let mut scene = Scene::default();
    fill(&mut scene, &mut 0);
    // All objects have the same one, which a file tells once.
    let material = scene.spheres[0].material;
    scene.planes[0].material = material;
    let block = &mut scene.blocks[0];
    block.material = material;
    block.half.z = block.half.x;
    block.axes = Mat3A::from_euler(EulerRot::XYZ, 0.3, 0.5, 0.7);
    let spot = scene.lights[0].spot.as_mut().expect("it is filled");
    spot.aim = spot.aim.normalize();
    (spot.cos_outer, spot.cos_inner) = (0.25, 0.75);
    assert_eq!(scene.validate(), Ok(()));
    scene
}

/// The text of its file.
fn ron() -> String {
    text_of("every_field", 9.0, vec![(0.0, every())]).expect("it can be told")
}

/// Motions of each kind: of a vector, a part of one, a material's, and a block's turn.
const MOTIONS: &str = r#"    motions: [
        (of: "camera.eye", between: Spline, keys: [(0, (4, -2, -8)), (3, (5, 2, 6)), (6, (2, 4, 7))]),
        (of: "camera.up[1]", keys: [(0, 1), (4, 2)]),
        (of: "spheres[0].centre", between: Smooth, repeat: true, keys: [(0, (0, 0, 1)), (0.5, (0, 2, 0)), (1, (0, 0, 1))]),
        (of: "materials[\"material 001\"].colour", between: Hold, repeat: true, keys: [(0, (2, 5, 9)), (1, (9, 8, 2))]),
        (of: "blocks[0].turn", keys: [(0, (0, 0.5, 0)), (8, (0, 13, 0))]),
    ],
)
"#;

/// The text of its file with motions.
fn moving() -> String {
    let text = ron();
    format!("{}{MOTIONS}", text.strip_suffix(")\n").expect("the end"))
}

/// The fields that are visited in a struct and in all in it.
fn visited(fields: &mut dyn Fields) -> usize {
    let mut count = 0;
    fields.visit(&mut |field| {
        count += 1;
        match field.value {
            Value::Optional(items) | Value::List(items) => {
                items.each(&mut |item| count += visited(item));
            }
            Value::Material(material) => count += visited(material),
            Value::Struct(fields) => count += visited(fields),
            _ => {}
        }
    });
    count
}

/// How often a text says the value of a name.
fn named(text: &str) -> usize {
    let before = text.match_indices(": ").map(|(at, _)| &text[..at]);
    before
        .filter(|before| before.ends_with(|c: char| c.is_alphanumeric()))
        .count()
}

#[test]
fn a_scene_with_every_field_is_the_same_as_a_file_and_as_rust() {
    let (scene, text) = (every(), ron());
    let file = SceneFile::parse("every_field.ron", &text).expect(&text);
    assert_eq!(contents(&file.at(0.0)), contents(&scene), "{text}");
    let text = moving();
    let file = SceneFile::parse("every_field.ron", &text).expect(&text);
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("every_field.ron");
    fs::write(&path, &text).expect("it can be written");
    assert_is_compiled("every_field", &path);
    assert_eq!(every_field::LENGTH, file.length);
    for step in 0..200 {
        let time = step as f32 * 0.05;
        let (compiled, read) = (every_field::scene(time), file.at(time));
        assert_eq!(contents(&compiled), contents(&read), "at {time} s");
    }
}

#[test]
fn descriptions_files_and_rust_have_as_many_fields() {
    let (mut scene, text) = (every(), ron());
    let all = visited(&mut scene);
    assert!(all > 100, "{all}");
    // Axes tell their three parts, and structs that grow the field for that.
    let contents = contents(&scene);
    let grown = contents.matches("_more: ()").count();
    assert_eq!(named(&contents), all + 3 * scene.blocks.len() + grown);
    // A file tells the material of all three objects once. Besides, it tells its length, and has a table of materials.
    let all = all - 2 * visited(&mut scene.spheres[0].material);
    assert_eq!(named(&text), all + 2, "{text}");
    let rust = include_str!("every_field.rs");
    let (_, body) = rust.split_once("pub fn scene(").expect("a function");
    let (body, _) = body.split_once("#[allow(").expect("what interpolates");
    assert_eq!(named(body), all + named("(time: f32)"), "{body}");
}

#[test]
fn every_number_tells_scenes_from_each_other_and_so_do_zeros_and_nan() {
    let mut count = 0;
    numbers(&mut every(), &mut |_, _, _| count += 1);
    for i in 0..count {
        let with = |new: f32| {
            let (mut scene, mut at) = (every(), 0);
            numbers(&mut scene, &mut |_, _, number| {
                if at == i {
                    *number = new;
                }
                at += 1;
            });
            contents(&scene)
        };
        let all = [with(0.0), with(-0.0), with(f32::NAN), contents(&every())];
        for (j, one) in all.iter().enumerate() {
            assert!(!all[..j].contains(one), "number {i}");
        }
        assert_eq!(with(f32::NAN), with(f32::NAN));
    }
}

#[test]
fn every_number_of_a_file_can_move() {
    let (from, mut to) = (every(), every());
    numbers(&mut to, &mut |name, range, number| {
        // Axes and directions keep their lengths.
        if !["axes", "aim"].contains(&name) {
            *number += 1e-3 * (range.most.min(10.0) - *number);
        }
    });
    to.blocks[0].half.z = to.blocks[0].half.x;
    let text = text_of("moved", 9.0, vec![(0.0, from), (1.0, to)]).expect("it can be told");
    let file = SceneFile::parse("moved.ron", &text).expect(&text);
    assert_eq!(contents(&file.at(0.0)), contents(&from));
    assert_eq!(contents(&file.at(1.0)), contents(&to));
}
