//! Changes of values in a scene file, with the motions of that value.

use super::edit::Changes;
use super::motion::Numbers;
use super::{SceneFile, path};
use serde_json::{Value, json};

impl SceneFile {
    /// The value of a file at a path, motions aside, even if the file leaves it out.
    pub fn value(&self, path: &str) -> Option<&Value> {
        path::get(&self.tree, path)
    }

    /// The names of the materials, in their order.
    pub fn materials(&self) -> Vec<&str> {
        let materials = self.tree.get("materials").and_then(Value::as_object);
        let names = materials.into_iter().flatten();
        names.map(|(name, _)| name.as_str()).collect()
    }

    /// Whether a value, or a part of it, changes with time.
    pub fn is_moved(&self, path: &str) -> bool {
        self.motions.iter().any(|motion| {
            let rest = motion.of.strip_prefix(path);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        })
    }

    /// Returns what has to change so that a number or a vector is another one, at all times: the value, and the keys of its motions. The
    /// function is given the index of a number in the vector, 0 for a single one, and the number.
    pub fn changed(&self, path: &str, f: impl Fn(usize, f64) -> f64) -> Changes {
        let mut changes = Changes::new();
        let Some(value) = self.value(path).and_then(Numbers::of) else {
            return changes;
        };
        changes.push((path.to_owned(), each(value, &f)));
        let first_index = |rest: &str| match rest {
            "" => Some(0),
            _ => rest.strip_prefix('[')?.strip_suffix(']')?.parse().ok(),
        };
        for (m, motion) in self.motions.iter().enumerate() {
            let rest = motion.of.strip_prefix(path);
            let Some(first): Option<usize> = rest.and_then(first_index) else {
                continue;
            };
            for (k, (_, numbers)) in motion.keys.iter().enumerate() {
                let value = each(*numbers, |i, number| f(first + i, number));
                changes.push((format!("motions[{m}].keys[{k}][1]"), value));
            }
        }
        changes
    }
}

/// Applies a function to each number of a vector, or of a single one. The results are those of `f32`.
fn each(numbers: Numbers, f: impl Fn(usize, f64) -> f64) -> Value {
    let new = |i: usize, number: f32| f(i, f64::from(number)) as f32;
    match numbers {
        Numbers::One(number) => json!(new(0, number)),
        Numbers::Three(numbers) => json!([0, 1, 2].map(|i| new(i, numbers[i]))),
        Numbers::Nine(axes) => json!(axes),
    }
}
