//! What becomes of the squares that a pixel is in, in words.

use eightfold_tracer::Counts;
use eightfold_tracer::observe::{Fill, Observer, Split};
use std::fmt::Write;
use std::sync::{Mutex, PoisonError};

/// Listens for the squares of one pixel.
pub struct Inspector {
    pixel: [usize; 2],
    /// A line for each of its squares so far.
    lines: Mutex<String>,
}

impl Inspector {
    /// Listens for the squares that the pixel (x, y) is in.
    pub fn new(x: usize, y: usize) -> Self {
        Self {
            pixel: [x, y],
            lines: Mutex::default(),
        }
    }

    /// What it has heard: a line for each square, from the largest to the smallest.
    pub fn lines(self) -> String {
        self.lines
            .into_inner()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Notes what happens to a square, if the pixel is in it.
    fn note(&self, corner: [usize; 2], sides: [usize; 2], what: &str) {
        let is_in = |i: usize| (corner[i]..corner[i] + sides[i]).contains(&self.pixel[i]);
        if is_in(0) && is_in(1) {
            let mut lines = self.lines.lock().unwrap_or_else(PoisonError::into_inner);
            let _ = writeln!(lines, "{}\u{d7}{} {what}", sides[0], sides[1]);
        }
    }
}

impl Observer for &Inspector {
    fn point(self, _: usize, _: usize, _: Counts) {}

    fn square(self, x: usize, y: usize, w: usize, h: usize, fill: Fill) {
        let what = match fill {
            Fill::Flat => "filled with one colour",
            Fill::Bilinear => "filled with colours between its corners\u{2019}",
            Fill::Patterned => {
                "filled with light between its corners\u{2019}, on each pixel\u{2019}s pattern"
            }
            Fill::Points => "traced, or averaged, pixel by pixel",
        };
        self.note([x, y], [w, h], what);
    }

    fn split(self, x: usize, y: usize, side: usize, why: Split) {
        let what = match why {
            Split::Uncovered => "split: something may be seen that no corner shows",
            Split::Keys => "split: its corners show different objects or light",
            Split::Colours => "split: its corners\u{2019} colours are too far apart",
        };
        self.note([x, y], [side; 2], what);
    }
}
