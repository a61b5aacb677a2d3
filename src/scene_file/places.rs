//! Where in the text of a scene file each of its values stands.

use std::collections::BTreeMap;
use std::ops::Range;

/// The mark that some editors put in front of a text. It takes no column.
pub const BYTE_ORDER_MARK: char = '\u{feff}';

/// The values of a text in RON by their paths, such as `spheres[3].material`, `materials["gold"].kr` or `motions[0].keys[2]`.
#[derive(Debug, Default)]
pub struct Places(BTreeMap<String, Range<usize>>);

impl Places {
    /// The places of all values of a text that has been read without an error.
    pub fn of(text: &str) -> Self {
        let mut reader = Reader {
            text,
            at: 0,
            places: Self::default(),
        };
        reader.skip(|c| c == BYTE_ORDER_MARK);
        reader.value("");
        reader.places
    }

    /// Where a value stands, if it does.
    pub fn get(&self, path: &str) -> Option<Range<usize>> {
        self.0.get(path).cloned()
    }

    /// How many items a list has.
    pub fn count(&self, list: &str) -> usize {
        (0..)
            .take_while(|i| self.0.contains_key(&format!("{list}[{i}]")))
            .count()
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

/// The length of a comment in `/*` and `*/` at the beginning of a text, which may have others in it.
fn comment(text: &str) -> usize {
    let (mut at, mut depth) = (0, 0);
    while at < text.len() {
        if text[at..].starts_with("/*") {
            (at, depth) = (at + 2, depth + 1);
        } else if text[at..].starts_with("*/") {
            (at, depth) = (at + 2, depth - 1);
            if depth == 0 {
                return at;
            }
        } else {
            at = text.ceil_char_boundary(at + 1);
        }
    }
    text.len()
}

/// The length of a text in quotes with nothing escaped, as in `r#"..."#`, at the beginning of a text; `None` if there is none.
fn raw_string(text: &str) -> Option<usize> {
    let rest = text.strip_prefix('r')?;
    let hashes = rest.len() - rest.trim_start_matches('#').len();
    let inside = rest[hashes..].strip_prefix('"')?;
    let end = format!("\"{}", &rest[..hashes]);
    let length = inside.find(&end).map_or(inside.len(), |at| at + end.len());
    Some(1 + hashes + 1 + length)
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    places: Places,
}

impl Reader<'_> {
    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn next(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn skip(&mut self, is_skipped: impl Fn(char) -> bool) {
        let rest = self.rest();
        self.at += rest.find(|c| !is_skipped(c)).unwrap_or(rest.len());
    }

    /// Skips white space and comments.
    fn skip_blank(&mut self) {
        loop {
            self.skip(char::is_whitespace);
            if self.rest().starts_with("//") {
                self.skip(|c| c != '\n');
            } else if self.rest().starts_with("/*") {
                let rest = self.rest();
                self.at += comment(rest);
            } else {
                return;
            }
        }
    }

    /// Reads one value, and the values in it.
    fn value(&mut self, path: &str) {
        self.skip_blank();
        let start = self.at;
        match self.next() {
            Some('"') => self.string(),
            Some('(' | '[' | '{') => self.items(path),
            Some('r') if raw_string(self.rest()).is_some() => {
                self.at += raw_string(self.rest()).unwrap_or_default();
            }
            _ => {
                self.skip(|c| !c.is_whitespace() && !"()[]{},:/\"".contains(c));
                let end = self.at;
                self.skip_blank();
                // The name of a struct or of a variant stands before its fields.
                if self.next() == Some('(') {
                    self.items(path);
                } else {
                    self.at = end;
                }
            }
        }
        self.places.0.insert(path.to_owned(), start..self.at);
    }

    fn string(&mut self) {
        self.at += 1;
        let mut is_escaped = false;
        while let Some(c) = self.next() {
            self.at += c.len_utf8();
            match c {
                _ if is_escaped => is_escaped = false,
                '\\' => is_escaped = true,
                '"' => return,
                _ => {}
            }
        }
    }

    /// Reads what is in brackets: items, fields with names, or keys with values.
    fn items(&mut self, path: &str) {
        self.at += 1;
        for number in 0.. {
            self.skip_blank();
            if self.next().is_none_or(|c| ")]}".contains(c)) {
                self.at = self.text.len().min(self.at + 1);
                return;
            }
            let start = self.at;
            let name = self.name();
            self.skip_blank();
            let path = if self.next() == Some(':') {
                self.at += 1;
                match name.strip_prefix('"') {
                    Some(_) => format!("{path}[{name}]"),
                    None if path.is_empty() => name,
                    None => format!("{path}.{name}"),
                }
            } else {
                self.at = start;
                format!("{path}[{number}]")
            };
            self.value(&path);
            self.skip_blank();
            if self.next() == Some(',') {
                self.at += 1;
            }
            // A text that is no RON must not hold it forever.
            if self.at == start {
                self.at += self.next().map_or(0, char::len_utf8);
            }
        }
    }

    /// A name or a quoted key, if one comes next.
    fn name(&mut self) -> String {
        let start = self.at;
        if self.next() == Some('"') {
            self.string();
        } else {
            self.skip(|c| c.is_alphanumeric() || c == '_');
        }
        self.text[start..self.at].to_owned()
    }
}
