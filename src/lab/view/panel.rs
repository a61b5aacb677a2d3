//! Words over the picture, with keys or colours that they explain.

use crate::arguments::Size;
use crate::bitmap::{Area, at, bitmap, colour, register_fonts, text};
use anyhow::Result;
use plotters::prelude::*;
use plotters::style::FontStyle;

/// The height of letters, of lines, and of the gap around them, in pixels.
const LETTERS: u32 = 14;
const LINE: usize = 18;
const GAP: usize = 8;
/// The share of the picture that is seen behind a panel, in 256ths.
const SEEN_THROUGH: u32 = 48;

/// A line of a panel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    pub mark: Mark,
    pub words: String,
}

/// The mark that the words of a line explain.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Mark {
    #[default]
    Nothing,
    Key(&'static str),
    Colour(u32),
}

/// In which corner a panel is.
#[derive(Clone, Copy, Debug)]
pub enum Corner {
    UpperLeft,
    LowerLeft,
    LowerRight,
}

/// Draws rows, and keeps what it has drawn as long as they are the same.
#[derive(Default)]
pub struct Panel {
    rows: Vec<Row>,
    /// The width of the picture that it was drawn for.
    room: usize,
    width: usize,
    pixels: Vec<u32>,
}

impl Panel {
    /// Draws rows over a picture, in a corner; nothing if there are none.
    pub fn show(&mut self, rows: &[Row], corner: Corner, picture: &mut [u32], size: Size) {
        if rows.is_empty() {
            return;
        }
        if self.rows != rows || self.room != size.width {
            self.rows = rows.to_vec();
            self.room = size.width;
            self.draw();
        }
        let height = self.pixels.len() / self.width;
        let left = match corner {
            Corner::LowerRight => size.width.saturating_sub(self.width),
            _ => 0,
        };
        let top = match corner {
            Corner::UpperLeft => 0,
            _ => size.height.saturating_sub(height),
        };
        let lines = picture.chunks_exact_mut(size.width).skip(top);
        for (line, own) in lines.zip(self.pixels.chunks_exact(self.width)) {
            for (pixel, own) in line[left..].iter_mut().zip(own) {
                *pixel = over(*pixel, *own);
            }
        }
    }

    /// Draws the rows on black.
    fn draw(&mut self) {
        register_fonts();
        let measure = |words: &str| {
            let style = text(LETTERS, FontStyle::Normal);
            let size = style.font.box_size(words);
            size.map_or(0, |(width, _)| width as usize)
        };
        let marks = self.rows.iter().map(|row| match &row.mark {
            Mark::Nothing => 0,
            Mark::Key(key) => measure(key) + 2 * GAP,
            Mark::Colour(_) => LINE + GAP,
        });
        let indent = GAP + marks.max().unwrap_or(0);
        let most = self.room.saturating_sub(indent + GAP);
        let lines: Vec<(Mark, String)> = self
            .rows
            .iter()
            .flat_map(|row| {
                let lines = wrapped(&row.words, most, measure).into_iter();
                lines.enumerate().map(|(i, words)| {
                    let mark = if i == 0 {
                        row.mark.clone()
                    } else {
                        Mark::Nothing
                    };
                    (mark, words)
                })
            })
            .collect();
        let widest = lines.iter().map(|(_, words)| measure(words)).max();
        self.width = (indent + widest.unwrap_or(0) + GAP).min(self.room);
        let height = lines.len() * LINE + GAP;
        let drawn = bitmap([self.width, height], 0, |area| {
            let mut lines = lines.iter().enumerate();
            lines.try_for_each(|(i, (mark, words))| {
                draw_line(area, mark, words, [indent, GAP / 2 + i * LINE])
            })
        });
        // A picture in memory takes all that is drawn.
        self.pixels = drawn.unwrap_or_default();
    }
}

fn draw_line(area: &Area<'_>, mark: &Mark, words: &str, [x, y]: [usize; 2]) -> Result<()> {
    let style = |weight| text(LETTERS, weight).color(&WHITE);
    match mark {
        Mark::Nothing => {}
        Mark::Key(key) => area.draw_text(key, &style(FontStyle::Bold), at([GAP, y]))?,
        Mark::Colour(pixel) => {
            // A frame, so that black is seen, too.
            let corners = [at([GAP, y + 1]), at([GAP + LINE, y + LINE - 4])];
            area.draw(&Rectangle::new(corners, colour(*pixel).filled()))?;
            area.draw(&Rectangle::new(corners, RGBColor(160, 160, 160)))?;
        }
    }
    Ok(area.draw_text(words, &style(FontStyle::Normal), at([x, y]))?)
}

/// A text in lines that are as wide as there is room, broken between words.
pub fn wrapped(words: &str, room: usize, measure: impl Fn(&str) -> usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split(' ') {
        match lines.last_mut() {
            Some(line) if measure(&format!("{line} {word}")) <= room => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A pixel of a panel over one of the picture, which is darkened.
pub fn over(picture: u32, panel: u32) -> u32 {
    let [_, r, g, b] = panel.to_be_bytes().map(u32::from);
    let covered = r.max(g).max(b);
    let channel = |shift: u32, own: u32| {
        let behind = (picture >> shift & 0xff) * SEEN_THROUGH * (255 - covered) / (256 * 255);
        (own + behind).min(255) << shift
    };
    channel(16, r) | channel(8, g) | channel(0, b)
}
