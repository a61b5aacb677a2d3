//! Paths of values in a scene file, such as `spheres[3].centre` or `materials["gold"].kr`.

use super::motion::Numbers;
use serde_json::Value;

/// The value at a path.
pub fn get<'a>(tree: &'a Value, path: &str) -> Option<&'a Value> {
    let mut names = names(path)?.into_iter();
    names.try_fold(tree, |value, name| match value {
        Value::Array(items) => items.get(name.parse::<usize>().ok()?),
        _ => value.get(name),
    })
}

/// Puts a value at a path, and the structs that it is in where they are not there. Lists have to be.
pub fn set(tree: &mut Value, path: &str, new: Value) {
    let mut value = tree;
    for name in names(path).unwrap_or_default() {
        value = match value {
            Value::Array(items) => match name.parse().ok().and_then(|i: usize| items.get_mut(i)) {
                Some(item) => item,
                None => return,
            },
            _ => &mut value[name],
        };
    }
    *value = new;
}

/// The names and numbers that a path is made of; `None` if a bracket is not closed.
fn names(path: &str) -> Option<Vec<&str>> {
    let mut names = Vec::new();
    let mut rest = path;
    while !rest.is_empty() {
        let (name, after) = if let Some(quoted) = rest.strip_prefix("[\"") {
            quoted.split_once("\"]")?
        } else if let Some(number) = rest.strip_prefix('[') {
            number.split_once(']')?
        } else {
            rest = rest.strip_prefix('.').unwrap_or(rest);
            rest.split_at(rest.find(['.', '[']).unwrap_or(rest.len()))
        };
        names.push(name);
        rest = after;
    }
    Some(names)
}

/// Calls a function with each number, vector, word and truth value of a tree below a path, and with its own path.
pub fn leaves(value: &Value, path: String, f: &mut impl FnMut(String, &Value)) {
    match value {
        Value::Object(fields) => {
            for (name, value) in fields {
                let path = match path.as_str() {
                    "" => name.clone(),
                    "materials" => format!("materials[{name:?}]"),
                    _ => format!("{path}.{name}"),
                };
                leaves(value, path, f);
            }
        }
        Value::Array(items) if Numbers::of(value).is_none() => {
            for (i, item) in items.iter().enumerate() {
                leaves(item, format!("{path}[{i}]"), f);
            }
        }
        _ => f(path, value),
    }
}
