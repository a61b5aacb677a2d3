use crate::bitmap::{at, bitmap, register_fonts, text};
use plotters::prelude::*;

/// The height of letters and lines, and the gap around them, in pixels.
const LETTERS: u32 = 14;
const LINE: usize = 18;
const GAP: usize = 8;
const COLUMN: usize = 128;

/// White text on black at the top of a picture.
#[derive(Default)]
pub struct Panel {
    rows: Vec<(String, String)>,
    width: usize,
    pixels: Vec<u32>,
}

impl Panel {
    pub fn show(&mut self, rows: Vec<(String, String)>, picture: &mut [u32], width: usize) {
        if rows.is_empty() {
            return;
        }
        if (&self.rows, self.width) != (&rows, width) {
            (self.rows, self.width) = (rows, width);
            // Drawing on a bitmap cannot fail.
            self.pixels = self.drawn().unwrap_or_default();
        }
        let covered = self.pixels.len().min(picture.len());
        picture[..covered].copy_from_slice(&self.pixels[..covered]);
    }

    fn drawn(&self) -> anyhow::Result<Vec<u32>> {
        register_fonts();
        let style = text(LETTERS).color(&WHITE);
        let width = |words: &str| {
            let size = style.font.box_size(words);
            size.map_or(0, |(width, _)| width as usize)
        };
        let mut lines: Vec<(&str, usize, String)> = Vec::new();
        for (key, words) in &self.rows {
            let indent = if key.is_empty() { GAP } else { COLUMN };
            let room = self.width.saturating_sub(indent + GAP);
            lines.push((key, indent, String::new()));
            for word in words.split(' ') {
                let (.., line) = lines.last_mut().expect("one was pushed");
                let longer = format!("{line} {word}");
                if line.is_empty() {
                    word.clone_into(line);
                } else if width(&longer) <= room {
                    *line = longer;
                } else {
                    lines.push(("", indent, word.to_owned()));
                }
            }
        }
        bitmap([self.width, lines.len() * LINE + GAP], 0, |area| {
            for (i, (key, indent, words)) in lines.iter().enumerate() {
                let y = GAP / 2 + i * LINE;
                area.draw_text(key, &style, at([GAP, y]))?;
                area.draw_text(words, &style, at([*indent, y]))?;
            }
            Ok(())
        })
    }
}
