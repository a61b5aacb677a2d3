//! Messages of one short line.

use ron::Error as E;
use ron::error::{Position, SpannedError};

/// The most letters of a message, of its file's name, and of a word or a quotation in a longer
/// message.
const MAX_MESSAGE: usize = 200;
const MAX_NAME: usize = 100;
const MAX_WORD: usize = 60;

/// The nesting that `ron` reads; each level takes two of its 128.
const MAX_NESTING: usize = 64;

/// Returns a line of at most 200 printable letters. Cuts long words and quotations first, then the
/// end.
#[must_use]
pub fn one_line(message: &str) -> String {
    shortened(message, MAX_MESSAGE)
}

pub fn located(name: &str, text: &str, at: usize, message: &str) -> String {
    let before = &text[..at];
    let line = before.rsplit('\n').next().unwrap_or(before);
    let (lines, column) = (before.matches('\n').count(), line.chars().count());
    let mut name = visible(name);
    if let Some(cut) = name.chars().count().checked_sub(MAX_NAME) {
        name = format!("...{}", name.chars().skip(cut).collect::<String>());
    }
    let place = format!("{name}:{}:{}: ", lines + 1, column + 1);
    let max = MAX_MESSAGE - place.chars().count();
    place + &shortened(message, max)
}

/// Replaces white space by spaces, and escapes control characters and marks that could rearrange a
/// terminal's text.
fn visible(text: &str) -> String {
    let letter = |letter: char| match letter {
        _ if letter.is_whitespace() => " ".to_owned(),
        '"' | '\'' | '\\' => letter.to_string(),
        _ => letter.escape_debug().to_string(),
    };
    text.chars().map(letter).collect()
}

fn shortened(message: &str, max: usize) -> String {
    let line = visible(message.trim());
    if line.chars().count() <= max {
        return line;
    }
    let parts = line.split('"').enumerate().map(|(i, part)| match i % 2 {
        0 => part.split(' ').map(quoted).collect::<Vec<_>>().join(" "),
        _ => quoted(part),
    });
    cut(&parts.collect::<Vec<_>>().join("\""), max - 5)
}

/// Cuts a text after `max` letters, except for the last two punctuation marks.
fn cut(text: &str, max: usize) -> String {
    let Some((end, _)) = text.char_indices().nth(max) else {
        return text.to_owned();
    };
    let signs = text[end..].rsplit(char::is_alphanumeric).next();
    let signs: String = signs.unwrap_or_default().chars().take(2).collect();
    format!("{}...{signs}", &text[..end])
}

/// Returns the start of a text that a message quotes.
pub fn quoted(text: &str) -> String {
    cut(&text.split_whitespace().collect::<Vec<_>>().join(" "), MAX_WORD)
}

pub fn syntax(text: &str, error: &SpannedError) -> (usize, String) {
    let at = match error.code {
        E::TrailingCharacters => error.span.end,
        _ => error.span.start,
    };
    let at = text.len() - after_space(&text[offset(text, at)..]).len();
    let rest = &text[at..];
    let is_digit = |letter: char| letter.is_ascii_digit();
    let lacks_name = matches!(
        error.code,
        E::ExpectedIdentifier | E::InvalidIdentifier(_) | E::SuggestRawIdentifier(_)
    );
    if lacks_name
        && let Some(whole) = text[..at].strip_suffix(',')
        && whole.ends_with(is_digit)
        && rest.starts_with(is_digit)
    {
        let start = whole.trim_end_matches(|letter| is_digit(letter) || letter == '-').len();
        let (whole, part) = (&whole[start..], rest.split(|letter| !is_digit(letter)).next());
        let part = part.unwrap_or_default();
        let message = format!("number is {whole},{part}; must be {whole}.{part}");
        return (start, message);
    }
    let incomplete = (text.len(), "file is incomplete".to_owned());
    let is_over = after_space(&text[offset(text, error.span.end)..]).is_empty();
    let is_other = matches!(error.code, E::InvalidValueForType { .. });
    let expected = error.code.to_string();
    let expected = match error.code {
        E::TrailingCharacters => "the end of the file",
        E::UnclosedBlockComment => {
            let at = text[..at].rfind("/*").unwrap_or(at);
            return (at, "comment is open; must end with */".to_owned());
        }
        E::ExceededRecursionLimit => {
            let message = format!("brackets are nested too deep; must be at most {MAX_NESTING}");
            return (at, message);
        }
        E::Eof | E::UnclosedLineComment => return incomplete,
        _ if is_over && !is_other => return incomplete,
        _ if lacks_name => "a name",
        E::ExpectedComma => "a comma",
        E::ExpectedMapColon => "a colon",
        E::ExpectedFloat => "a number",
        E::InvalidEscape(_) => "text with known escapes",
        _ => {
            let expected = expected.split(" but found").next().unwrap_or_default();
            expected.strip_prefix("Expected ").unwrap_or("a value")
        }
    };
    let found = rest.split_whitespace().next().unwrap_or_default();
    (at, format!("text is '{found}'; must be {expected}"))
}

fn offset(text: &str, Position { line, col }: Position) -> usize {
    let lines = text.split_inclusive('\n');
    let before: usize = lines.take(line - 1).map(str::len).sum();
    let letters = text[before..].char_indices().nth(col - 1);
    letters.map_or(text.len(), |(at, _)| before + at)
}

fn after_space(mut text: &str) -> &str {
    loop {
        text = text.trim_start();
        let end = match text.get(..2) {
            Some("//") => "\n",
            Some("/*") => "*/",
            _ => return text,
        };
        let Some((_, rest)) = text.split_once(end) else {
            return text;
        };
        text = rest;
    }
}
