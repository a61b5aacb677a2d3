//! A whole picture by the oracle.

use super::{Oracle, Traced};
use eightfold::Quality;
use eightfold::scene::Scene;
use std::thread::available_parallelism;

/// Every pixel of a picture, and a margin of one around it.
pub struct Frame {
    pub width: usize,
    pub height: usize,
    /// Rows of `width + 2`.
    points: Vec<Traced>,
}

impl Frame {
    /// Traces them all.
    pub fn new(scene: &Scene, quality: &Quality, width: usize, height: usize) -> Self {
        let oracle = Oracle::new(scene, quality, width, height);
        let mut points = vec![Traced::default(); (width + 2) * (height + 2)];
        let threads = available_parallelism().map_or(1, usize::from);
        let rows = (height + 2).div_ceil(threads);
        std::thread::scope(|scope| {
            for (i, part) in points.chunks_mut(rows * (width + 2)).enumerate() {
                let oracle = &oracle;
                scope.spawn(move || {
                    for (j, point) in part.iter_mut().enumerate() {
                        let (x, y) = (j % (width + 2), i * rows + j / (width + 2));
                        *point = oracle.trace(x as isize - 1, y as isize - 1);
                    }
                });
            }
        });
        Self {
            width,
            height,
            points,
        }
    }

    /// The point at a pixel of the picture.
    pub fn at(&self, x: usize, y: usize) -> &Traced {
        &self.points[(y + 1) * (self.width + 2) + x + 1]
    }

    /// The points of the picture, row after row.
    fn pixels_of<T>(&self, of: impl Fn(usize, usize) -> T) -> Vec<T> {
        let places = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        places.map(|(x, y)| of(x, y)).collect()
    }

    /// The picture, `0x00RRGGBB`.
    pub fn picture(&self) -> Vec<u32> {
        self.pixels_of(|x, y| self.at(x, y).pixel())
    }

    /// Which pixels lie on silhouettes: where the ray trees of the 3x3 pixels around it differ, so that the least
    /// rounding can make a ray meet something else.
    pub fn silhouettes(&self) -> Vec<bool> {
        self.pixels_of(|x, y| {
            let tree = self.at(x, y).tree;
            let row = |y: usize| &self.points[y * (self.width + 2)..][x..x + 3];
            (y..y + 3).any(|y| row(y).iter().any(|point| point.tree != tree))
        })
    }

    /// The sum of a count over the picture.
    pub fn total(&self, count: impl Fn(&Traced) -> u64) -> u64 {
        self.pixels_of(|x, y| count(self.at(x, y))).iter().sum()
    }
}
