//! Changes to the text of a scene file that leave all other text as it is: comments, order, white space and the digits of numbers.
//!
//! `Places` tells which bytes of the text a value takes; these alone are replaced, a vector's number by number. What the text does
//! not have yet is put at the beginning of the struct that it belongs to, and copies of objects at the end of their list.

use super::patches::Patches;
use super::places::Places;
use super::ron_text::inline;
use serde_json::Value;
use std::ops::Range;

/// Values, each with its path.
pub type Changes = Vec<(String, Value)>;

/// The text with other values. `None` if one of them can't be put into it.
pub fn set(text: &str, changes: &[(String, Value)]) -> Option<String> {
    let places = Places::of(text);
    let mut patches = Patches::default();
    let mut missing = Vec::new();
    for (path, value) in changes {
        if !replace(&places, text, &mut patches, path, value) {
            missing.push((path, inline(value)));
        }
    }
    let text = patches.apply(text);
    missing
        .iter()
        .try_fold(text, |text, (path, value)| insert(&text, path, value))
}

/// Replaces a value, or the numbers in it that change. Returns false if it is not in the text.
fn replace(places: &Places, text: &str, patches: &mut Patches, path: &str, value: &Value) -> bool {
    let Some(place) = places.get(path) else {
        return false;
    };
    let items = value.as_array().map_or(&[][..], Vec::as_slice);
    let item_path = |i: usize| format!("{path}[{i}]");
    if !items.is_empty() && (0..items.len()).all(|i| places.get(&item_path(i)).is_some()) {
        for (i, item) in items.iter().enumerate() {
            replace(places, text, patches, &item_path(i), item);
        }
        return true;
    }
    let new = inline(value);
    // A number stays as it is written if it is the same.
    let is_same = match (text[place.clone()].parse::<f32>(), new.parse::<f32>()) {
        (Ok(before), Ok(after)) => before == after,
        _ => text[place.clone()] == new,
    };
    if !is_same {
        patches.replace(place, new);
    }
    true
}

/// Puts a field that is not there at the beginning of its struct.
fn insert(text: &str, path: &str, value: &str) -> Option<String> {
    let (parent, name) = path.rsplit_once('.').unwrap_or(("", path));
    let Some(place) = Places::of(text).get(parent) else {
        return insert(text, parent, &format!("({name}: {value})"));
    };
    let start = place.start + text[place].find('(')? + 1;
    let after = &text[start..];
    let blank = after.len() - after.trim_start().len();
    let field = if after[..blank].contains('\n') {
        format!("{}{name}: {value},", &after[..blank])
    } else {
        format!("{name}: {value}, ")
    };
    let mut patches = Patches::default();
    patches.replace(start..start, field);
    Some(patches.apply(text))
}

/// The text with a copy of an object at the end of its list, and with copies of the motions of its numbers. `None` if there is no
/// such object.
pub fn duplicate(text: &str, list: &str, index: usize) -> Option<String> {
    let places = Places::of(text);
    let mut patches = Patches::default();
    let object = places.get(&format!("{list}[{index}]"))?;
    let count = places.count(list);
    patches.append(text, &places, list, &[text[object].to_owned()])?;
    let copies: Vec<String> = motions(&places, text)
        .filter(|motion| motion.object() == Some((list, index)))
        .map(|motion| motion.with_object(text, list, count))
        .collect();
    if !copies.is_empty() {
        patches.append(text, &places, MOTIONS, &copies)?;
    }
    Some(patches.apply(text))
}

/// The text without an object, without the motions of its numbers, and without a comment that follows either on its line. `None` if
/// there is no such object.
pub fn remove(text: &str, list: &str, index: usize) -> Option<String> {
    let places = Places::of(text);
    let mut patches = Patches::default();
    patches.remove(text, places.get(&format!("{list}[{index}]"))?);
    for motion in motions(&places, text) {
        match motion.object() {
            Some((of, i)) if of == list && i == index => {
                patches.remove(text, motion.place.clone());
            }
            // What comes after it in the list has another number now.
            Some((of, i)) if of == list && i > index => {
                patches.replace(motion.of_place.clone(), motion.of_object(list, i - 1));
            }
            _ => {}
        }
    }
    Some(patches.apply(text))
}

/// The list of motions.
const MOTIONS: &str = "motions";

/// A motion as it is written.
struct WrittenMotion<'a> {
    place: Range<usize>,
    /// The path of what it moves, and where that is written, with its quotes.
    of: &'a str,
    of_place: Range<usize>,
}

/// The motions of a text.
fn motions<'a>(places: &Places, text: &'a str) -> impl Iterator<Item = WrittenMotion<'a>> {
    (0..places.count(MOTIONS)).filter_map(|i| {
        let path = format!("{MOTIONS}[{i}]");
        let of_place = places.get(&format!("{path}.of"))?;
        Some(WrittenMotion {
            place: places.get(&path)?,
            of: text[of_place.clone()].trim_matches('"'),
            of_place,
        })
    })
}

impl WrittenMotion<'_> {
    /// The list and the number of the object that it moves, if it is in a list.
    fn object(&self) -> Option<(&str, usize)> {
        let (list, rest) = self.of.split_once('[')?;
        let (index, _) = rest.split_once(']')?;
        Some((list, index.parse().ok()?))
    }

    /// The path of the same value of another object, with quotes.
    fn of_object(&self, list: &str, index: usize) -> String {
        let (_, field) = self.of.split_once(']').unwrap_or(("", ""));
        format!("\"{list}[{index}]{field}\"")
    }

    /// Its text for another object.
    fn with_object(&self, text: &str, list: &str, index: usize) -> String {
        let before = &text[self.place.start..self.of_place.start];
        let after = &text[self.of_place.end..self.place.end];
        format!("{before}{}{after}", self.of_object(list, index))
    }
}

#[cfg(test)]
mod tests {
    use super::{duplicate, remove, set};
    use crate::SceneFile;
    use serde_json::{Value, json};

    const TEXT: &str = r#"Scene(
    // Two balls.
    materials: {"a": (kd: 0.5), r"b": (kd: 0.5 /* half */)},
    spheres: [
        (centre: (0.50, 1, -2e0), radius: 1.0 /* unit */, material: "a"), // the first
        (centre: (3.0, 1.0, 0.0), radius: 1.0, material: r"b") // no comma
    ],
    lights: [(position: (0.0, 9.0, 0.0), drawn_radius: 0.5), (position: (1.0, 9.0, 0.0))],
    motions: [
        (of: "spheres[0].centre", keys: [(0.0, (0.5, 1.0, -2.0)), (1.0, (0.5, 2.0, -2.0))]),
        (of: "spheres[1].centre[1]", keys: [(0.0, 1.0), (1.0, 1.5)]), // up
    ],
)
"#;

    /// The value of a text at a path.
    #[track_caller]
    fn value(text: &str, path: &str) -> Value {
        let file = SceneFile::parse("scene.ron", text).expect(text);
        file.value(path).cloned().unwrap_or_default()
    }

    #[track_caller]
    fn changed(changes: &[(&str, Value)]) -> String {
        let changes: Vec<(String, Value)> = changes
            .iter()
            .map(|(path, value)| ((*path).to_owned(), value.clone()))
            .collect();
        let text = set(TEXT, &changes).expect("it is there");
        for (path, new) in &changes {
            assert_eq!(value(&text, path), *new, "{text}");
        }
        text
    }

    #[test]
    fn numbers_that_are_the_same_stay_as_they_are_written() {
        let text = changed(&[
            ("spheres[0].centre", json!([0.5, 1.5, -2.0])),
            ("spheres[0].radius", json!(2.0)),
            ("spheres[1].material", json!("a")),
        ]);
        let expected = TEXT
            .replace(
                "(0.50, 1, -2e0), radius: 1.0 /*",
                "(0.50, 1.5, -2e0), radius: 2.0 /*",
            )
            .replace("1.0, material: r\"b\"", "1.0, material: \"a\"");
        assert_eq!(text, expected);
        assert_eq!(set(TEXT, &[]).expect("nothing"), TEXT);
    }

    #[test]
    fn what_is_not_there_is_put_where_it_belongs() {
        let text = changed(&[
            ("camera.eye", json!([1.0, 2.0, 3.0])),
            ("camera.look_at", json!([0.0, 1.0, 0.0])),
            ("lights[1].drawn_radius", json!(0.25)),
        ]);
        let expected = TEXT
            .replace(
                "Scene(\n",
                "Scene(\n    camera: (look_at: (0.0, 1.0, 0.0), eye: (1.0, 2.0, 3.0)),\n",
            )
            .replace("(position: (1.0", "(drawn_radius: 0.25, position: (1.0");
        assert_eq!(text, expected);
        // In a text of one line, too.
        let changes = [("camera.eye".to_owned(), json!([1.0, 2.0, 3.0]))];
        let text = set("(length: 2.0)", &changes).expect("it can be put there");
        assert_eq!(text, "(camera: (eye: (1.0, 2.0, 3.0)), length: 2.0)");
    }

    #[test]
    fn a_copy_comes_last_and_has_motions_of_its_own() {
        let text = duplicate(TEXT, "spheres", 0).expect("it is there");
        let line = "(centre: (0.50, 1, -2e0), radius: 1.0 /* unit */, material: \"a\"),";
        let motion = "(of: \"spheres[2].centre\", keys: [(0.0, (0.5, 1.0, -2.0)), (1.0, (0.5, 2.0, -2.0))]),";
        let expected = TEXT
            .replace(
                "r\"b\") // no comma\n",
                &format!("r\"b\"), // no comma\n        {line}\n"),
            )
            .replace("// up\n", &format!("// up\n        {motion}\n"));
        assert_eq!(text, expected);
        assert_eq!(value(&text, "spheres[2]"), value(TEXT, "spheres[0]"));
        let text = duplicate(TEXT, "lights", 0).expect("it is there");
        assert_eq!(value(&text, "lights[2]"), value(TEXT, "lights[0]"));
        assert_eq!(
            text.lines().count(),
            TEXT.lines().count(),
            "on the same line"
        );
        assert_eq!(duplicate(TEXT, "spheres", 2), None);
        assert_eq!(duplicate(TEXT, "blocks", 0), None);
    }

    #[test]
    fn lines_end_as_those_beside_them_and_a_byte_order_mark_stays() {
        let other = |text: &str| format!("\u{feff}{}", text.replace('\n', "\r\n"));
        let edits: [fn(&str) -> Option<String>; 3] = [
            |text| duplicate(text, "spheres", 0),
            |text| remove(text, "spheres", 1),
            |text| {
                let eye = ("camera.eye".to_owned(), json!([1.0, 2.0, 3.0]));
                let radius = ("spheres[0].radius".to_owned(), json!(2.0));
                set(text, &[eye, radius])
            },
        ];
        for edit in edits {
            let text = edit(TEXT).expect("it can be put there");
            assert_eq!(edit(&other(TEXT)), Some(other(&text)));
            assert_eq!(value(&other(&text), "spheres"), value(&text, "spheres"));
        }
    }

    #[test]
    fn what_comes_after_a_deleted_object_keeps_its_motions() {
        let text = remove(TEXT, "spheres", 0).expect("it is there");
        assert!(text.contains("// Two balls.") && !text.contains("the first"));
        assert_eq!(value(&text, "spheres"), json!([value(TEXT, "spheres[1]")]));
        assert!(!text.contains("spheres[0].centre\""), "{text}");
        assert!(
            text.contains("(of: \"spheres[0].centre[1]\", keys: [(0.0, 1.0)"),
            "{text}"
        );
        let text = remove(TEXT, "spheres", 1).expect("it is there");
        assert_eq!(value(&text, "spheres"), json!([value(TEXT, "spheres[0]")]));
        assert!(
            text.contains("// the first") && !text.contains("// up"),
            "{text}"
        );
        for (index, left) in [(0, 1), (1, 0)] {
            let text = remove(TEXT, "lights", index).expect("it is there");
            assert_eq!(
                value(&text, "lights[0]"),
                value(TEXT, &format!("lights[{left}]"))
            );
            assert_eq!(value(&text, "lights[1]"), Value::Null);
        }
        assert_eq!(remove(TEXT, "spheres", 2), None);
    }
}
