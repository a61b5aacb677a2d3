//! Explanations of keys, the mouse, and the colours of overlays.

use super::controls::{MOST_ERROR, MOST_RAYS, Overlay};
use super::panel::{Mark, Row};
use crate::overlay::{heat, square_colour};

/// The effects of keys, whatever scene is shown.
pub const KEYS: [(&str, &str); 14] = [
    ("Space", "pauses and plays on"),
    ("Left, Right", "a frame back or on, and pauses"),
    ("Home", "back to the beginning"),
    (
        "1 to 9",
        "the quality: exhaustive, thesis, then the ladder from the finest to the fastest",
    ),
    ("P", "the points traced, in white"),
    ("S", "the squares: the smaller, the brighter"),
    (
        "H",
        "the heat map: rays for each point traced, from black for none to white for 24 and more",
    ),
    (
        "E",
        "the error against exhaustive, from black for none to white for 32 of 255 and more",
    ),
    ("", "P, S, H, E again: the picture"),
    ("L", "hides and shows what the colours of those stand for"),
    ("V", "the scene's own camera again"),
    ("F, W", "fullscreen, window"),
    ("?, F1", "shows and hides these keys"),
    ("Esc", "the end"),
];

/// The effects of the mouse, whatever scene is shown.
const MOUSE: [(&str, &str); 3] = [
    (
        "Right drag",
        "turns the camera; so does a left drag beside objects",
    ),
    ("Middle drag", "moves the camera"),
    ("Wheel", "nearer and farther"),
];

/// The effects of keys and the mouse on a scene file.
const EDITING: [(&str, &str); 11] = [
    (
        "Click",
        "picks an object; its name in the file and its numbers are shown",
    ),
    (
        "Drag",
        "moves it on its level; a plane has to be picked before",
    ),
    ("Shift-drag", "moves it up and down"),
    ("Wheel on it", "resizes it"),
    ("M", "the next material"),
    ("Delete", "deletes it"),
    ("Ctrl-D", "duplicates it"),
    ("C", "puts the camera as it is into the file"),
    ("Ctrl-Z", "undoes"),
    ("Ctrl-Y", "redoes"),
    ("Ctrl-S", "saves the file"),
];

/// The keys and the mouse, for a terminal.
pub fn text() -> String {
    let lines = |rows: &[(&str, &str)]| {
        let lines = rows.iter().map(|(key, words)| format!("{key:<14}{words}"));
        lines.collect::<Vec<_>>().join("\n")
    };
    let [keys, mouse, editing] = [&KEYS[..], &MOUSE, &EDITING].map(lines);
    format!("{keys}\n\nMouse:\n{mouse}\n\nWith a scene file:\n{editing}")
}

/// The keys and the mouse, for a panel.
pub fn keys(is_editing: bool) -> Vec<Row> {
    let editing = if is_editing { &EDITING[..] } else { &[] };
    let rows = editing.iter().chain(&MOUSE).chain(&KEYS);
    rows.map(|(key, words)| Row {
        mark: Mark::Key(key),
        words: (*words).to_owned(),
    })
    .collect()
}

/// The meaning of an overlay's colours.
pub fn colours(overlay: Overlay) -> Vec<Row> {
    let row = |colour, words: String| Row {
        mark: Mark::Colour(colour),
        words,
    };
    let scale = |most: u32, unit: &str| -> Vec<Row> {
        let steps = [0, most / 4, most / 2, most * 3 / 4, most];
        let rows = steps.map(|step| {
            let more = if step == most { " and more" } else { "" };
            row(
                heat(step as f32 / most as f32),
                format!("{step}{unit}{more}"),
            )
        });
        rows.into()
    };
    match overlay {
        Overlay::None => Vec::new(),
        Overlay::Points => vec![
            row(0x00ff_ffff, "a traced point".to_owned()),
            row(0x0030_3030, "filled between points".to_owned()),
        ],
        Overlay::Squares => [1, 2, 4, 8, 16, 32]
            .map(|side| row(square_colour(side), format!("{side} px")))
            .into(),
        Overlay::Heat => scale(MOST_RAYS, " rays"),
        Overlay::Error => scale(MOST_ERROR, "/255"),
    }
}
