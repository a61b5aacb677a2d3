//! Replacements in the text of a scene file that leave all other text as it is: comments, commas, line ends and indents.

use super::places::Places;
use std::ops::Range;

/// Parts of a text to be replaced, which do not overlap.
#[derive(Default)]
pub struct Patches(Vec<(Range<usize>, String)>);

impl Patches {
    pub fn replace(&mut self, place: Range<usize>, by: String) {
        self.0.push((place, by));
    }

    pub fn apply(mut self, text: &str) -> String {
        self.0.sort_by_key(|(place, _)| (place.start, place.end));
        let mut new = String::with_capacity(text.len());
        let mut end = 0;
        for (place, by) in &self.0 {
            new.push_str(&text[end..place.start]);
            new.push_str(by);
            end = place.end;
        }
        new + &text[end..]
    }

    /// Puts items at the end of a list that has one at least: on lines of their own if the last one ends its line, and after a
    /// comment that follows there.
    pub fn append(
        &mut self,
        text: &str,
        places: &Places,
        list: &str,
        items: &[String],
    ) -> Option<()> {
        let last = places.get(&format!("{list}[{}]", places.count(list).checked_sub(1)?))?;
        let tail = Tail::of(text, last.end);
        if tail.comma_end.is_none() {
            self.replace(last.end..last.end, ",".to_owned());
        }
        let indent = indent(text, last.start);
        for item in items {
            if tail.ends_line {
                let line_break = &text[tail.line_end..tail.next_line];
                let line = format!("{line_break}{indent}{item},");
                self.replace(tail.line_end..tail.line_end, line);
            } else {
                let end = tail.comma_end.unwrap_or(last.end);
                self.replace(end..end, format!(" {item},"));
            }
        }
        Some(())
    }

    /// Takes an item out of a list, with its comma, and with its line if nothing else but a comment is on that.
    pub fn remove(&mut self, text: &str, item: Range<usize>) {
        let tail = Tail::of(text, item.end);
        let line = item.start - indent_length(text, item.start);
        let begins_line = line == 0 || text[..line].ends_with('\n');
        let place = if begins_line && tail.ends_line {
            line..tail.next_line
        } else {
            item.start..tail.comma_end.unwrap_or(item.end)
        };
        self.replace(place, String::new());
    }
}

/// The rest of the line behind an item of a list.
struct Tail {
    /// Behind the comma and the blanks after it, if there is one.
    comma_end: Option<usize>,
    /// Whether there is nothing else but a comment.
    ends_line: bool,
    /// Where the line ends, before its `\n` or `\r\n`, and where the next one begins.
    line_end: usize,
    next_line: usize,
}

impl Tail {
    fn of(text: &str, end: usize) -> Self {
        let line = text[end..].split_inclusive('\n').next().unwrap_or_default();
        let rest = line.strip_suffix('\n').unwrap_or(line);
        let rest = rest.strip_suffix('\r').unwrap_or(rest);
        let line_end = end + rest.len();
        let comma = rest.trim_start().strip_prefix(',');
        let after = comma.unwrap_or(rest).trim_start();
        Self {
            comma_end: comma.map(|_| line_end - after.len()),
            ends_line: after.is_empty() || after.starts_with("//"),
            line_end,
            next_line: end + line.len(),
        }
    }
}

/// The number of bytes of white space before a byte of a text on its line.
fn indent_length(text: &str, at: usize) -> usize {
    let before = &text[..at];
    before.len() - before.trim_end_matches([' ', '\t']).len()
}

/// The white space that begins the line of a byte of a text.
fn indent(text: &str, at: usize) -> &str {
    let start = text[..at].rfind('\n').map_or(0, |end| end + 1);
    let line = &text[start..];
    &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
}
