//! Where in the text of a scene file each of its values stands.

use super::earlier;
use ron::value::RawValue;
use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};
use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

/// The mark that some editors put in front of a text. It takes no column.
pub const BYTE_ORDER_MARK: char = '\u{feff}';

/// The values of a text in RON by their paths, such as `spheres[3].material`, `materials["gold"].kr` or `motions[0].keys[2]`.
#[derive(Debug, Default)]
pub struct Places(BTreeMap<String, Range<usize>>);

impl Places {
    /// The places of all values of a text that has been read without an error.
    pub fn of(text: &str) -> Self {
        let mut places = Self::default();
        if let Ok(whole) = ron::from_str(text.trim_start_matches(BYTE_ORDER_MARK)) {
            places.add(text, String::new(), whole);
        }
        places
    }

    /// Adds a value of a text at a path, and the values in it.
    fn add(&mut self, text: &str, path: String, value: &RawValue) {
        let written = value.trim().get_ron();
        let start = written.as_ptr().addr() - text.as_ptr().addr();
        match ron::from_str(written) {
            Ok(Parts::Named(parts)) => {
                let is_table = written.starts_with('{');
                for (name, part) in parts {
                    let path = match path.as_str() {
                        _ if is_table => format!("{path}[{name:?}]"),
                        "" => name,
                        _ => earlier::path(format!("{path}.{name}")),
                    };
                    self.add(text, path, part);
                }
            }
            Ok(Parts::Items(parts)) => {
                for (i, part) in parts.into_iter().enumerate() {
                    self.add(text, format!("{path}[{i}]"), part);
                }
            }
            // It has no parts.
            Err(_) => {}
        }
        self.0.insert(path, start..start + written.len());
    }

    /// Where a value stands, or the nearest that it is a part of.
    pub fn find(&self, path: &str) -> Option<Range<usize>> {
        let mut path = path;
        loop {
            if let Some(place) = self.0.get(path) {
                return Some(place.clone());
            }
            path = &path[..path.rfind(['.', '['])?];
        }
    }
}

/// The line and the column of a byte of a text, both counted from 1.
pub fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..text.floor_char_boundary(at)];
    let line = before.rsplit('\n').next().unwrap_or(before);
    (before.matches('\n').count() + 1, line.chars().count() + 1)
}

/// The parts of a value as they are written: the fields of a struct or the entries of a table, or the items of a list or a tuple.
enum Parts<'a> {
    Named(Vec<(String, &'a RawValue)>),
    Items(Vec<&'a RawValue>),
}

impl<'de> Deserialize<'de> for Parts<'de> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct Reader;

        impl<'de> Visitor<'de> for Reader {
            type Value = Parts<'de>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a value with parts")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Parts<'de>, A::Error> {
                let mut parts = Vec::new();
                while let Some(part) = map.next_entry()? {
                    parts.push(part);
                }
                Ok(Parts::Named(parts))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Parts<'de>, A::Error> {
                let mut parts = Vec::new();
                while let Some(part) = items.next_element()? {
                    parts.push(part);
                }
                Ok(Parts::Items(parts))
            }

            fn visit_some<D: Deserializer<'de>>(self, from: D) -> Result<Parts<'de>, D::Error> {
                from.deserialize_any(self)
            }
        }

        from.deserialize_any(Reader)
    }
}
