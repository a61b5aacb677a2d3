//! Frames a picture of the soundtrack: seconds below, the show's scenes above, a scale at the left. Coordinates are pixels.

use super::SIZE;
use crate::bitmap::{Area, SAMPLES, at, bitmap, text};
use anyhow::Result;
use eightfold::show::{self, grid};
use plotters::prelude::*;
use plotters::style::FontStyle;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Room for the scale, at the left, and for the words at the end of an axis, at the right.
const SIDES: [usize; 2] = [72, 24];
/// Room for the names of the scenes, above, and for the seconds, below.
const ENDS: [usize; 2] = [28, 44];
/// The height of the letters.
const SIZE_OF_TEXT: u32 = 14;
/// The length of the line beside a number.
const TICK: i32 = 5;
/// Seconds between numbers.
const STEP: usize = 10;

/// The values of the heights of a picture: numbers at shares of the height from the top, and their unit.
pub struct Heights {
    pub ticks: Vec<(f32, String)>,
    pub unit: &'static str,
}

/// Puts axes around a picture of the whole soundtrack. Returns the width and the pixels.
pub fn framed(picture: &[u32], heights: &Heights) -> Result<(usize, Vec<u32>)> {
    let (width, height) = SIZE;
    let (left, top) = (SIDES[0], ENDS[0]);
    let [all_width, all_height] = [left + width + SIDES[1], top + height + ENDS[1]];
    let mut pixels = bitmap([all_width, all_height], 0x00ff_ffff, |area| {
        let axes = Axes { area };
        axes.draw_seconds([left, top + height], width)?;
        axes.draw_scenes([left, top], width)?;
        axes.draw_heights([left, top], height, heights)
    })?;
    for (row, line) in picture.chunks_exact(width).enumerate() {
        pixels[(top + row) * all_width + left..][..width].copy_from_slice(line);
    }
    Ok((all_width, pixels))
}

/// The picture that axes are drawn on.
struct Axes<'a, 'b> {
    area: &'a Area<'b>,
}

impl Axes<'_, '_> {
    /// Seconds along the lower end of a picture.
    fn draw_seconds(&self, [left, bottom]: [usize; 2], width: usize) -> Result<()> {
        let below = Pos::new(HPos::Center, VPos::Top);
        for second in (0..=show::LENGTH as usize).step_by(STEP) {
            let x = left + column(second as f32, width);
            self.tick([x, bottom], [0, 1])?;
            self.write(&second.to_string(), [x, bottom + 7], below)?;
        }
        self.write("seconds", [left + width / 2, bottom + 25], below)
    }

    /// The names of the scenes where they begin, along the upper end.
    fn draw_scenes(&self, [left, top]: [usize; 2], width: usize) -> Result<()> {
        for (name, cut) in show::NAMES.into_iter().zip(show::CUTS) {
            let x = left + column(cut as f32 * grid::BAR, width);
            self.tick([x, top], [0, -1])?;
            self.write(name, [x, top - 7], Pos::new(HPos::Left, VPos::Bottom))?;
        }
        Ok(())
    }

    /// A scale along the left end.
    fn draw_heights(
        &self,
        [left, top]: [usize; 2],
        height: usize,
        heights: &Heights,
    ) -> Result<()> {
        for (share, number) in &heights.ticks {
            let y = top + (share * height as f32) as usize;
            self.tick([left, y], [-1, 0])?;
            self.write(number, [left - 8, y], Pos::new(HPos::Right, VPos::Center))?;
        }
        self.write(
            heights.unit,
            [left - 8, top - 7],
            Pos::new(HPos::Right, VPos::Bottom),
        )
    }

    fn write(&self, words: &str, place: [usize; 2], anchor: Pos) -> Result<()> {
        let style = text(SIZE_OF_TEXT, SAMPLES, FontStyle::Normal).pos(anchor);
        Ok(self.area.draw_text(words, &style, at(place))?)
    }

    fn tick(&self, place: [usize; 2], [across, down]: [i32; 2]) -> Result<()> {
        let (x, y) = at(place);
        let length = TICK * SAMPLES as i32;
        let line = vec![(x, y), (x + across * length, y + down * length)];
        Ok(self.area.draw(&PathElement::new(line, BLACK))?)
    }
}

/// How far a second of the show is from the left end.
fn column(second: f32, width: usize) -> usize {
    (second / show::LENGTH * width as f32) as usize
}
