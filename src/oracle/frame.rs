use super::{Oracle, Traced, pixel_like};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Film, Scene};
use rayon::prelude::*;

pub struct Frame {
    pub width: usize,
    pub height: usize,
    pub film: Film,
    /// Row by row, `width + 2` points each.
    points: Vec<Traced>,
}

impl Frame {
    pub fn new(scene: &Scene, quality: &Quality, width: usize, height: usize) -> Self {
        let oracle = Oracle::new(scene, quality, width, height);
        let trace = |i: usize| {
            let (x, y) = (i % (width + 2), i / (width + 2));
            oracle.trace(x as isize - 1, y as isize - 1)
        };
        let points = (0..(width + 2) * (height + 2)).into_par_iter().map(trace);
        Self { width, height, film: scene.film, points: points.collect() }
    }

    pub fn at(&self, x: usize, y: usize) -> &Traced {
        &self.points[(y + 1) * (self.width + 2) + x + 1]
    }

    fn map_pixels<T>(&self, of: impl Fn(usize, usize) -> T) -> Vec<T> {
        let pixels = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        pixels.map(|(x, y)| of(x, y)).collect()
    }

    pub fn picture_like(&self, drawn: &[u32]) -> Vec<u32> {
        self.map_pixels(|x, y| {
            let drawn = drawn[y * self.width + x];
            pixel_like(drawn, self.at(x, y).colour, self.film.dither, x, y)
        })
    }

    /// Returns the pixels on silhouettes: ray trees differ within 3x3 pixels, so rounding can
    /// change the object hit.
    pub fn silhouettes(&self) -> Vec<bool> {
        self.map_pixels(|x, y| {
            let tree = self.at(x, y).tree;
            let row = |y: usize| &self.points[y * (self.width + 2)..][x..x + 3];
            (y..y + 3).any(|y| row(y).iter().any(|point| point.tree != tree))
        })
    }

    pub fn total(&self, count: impl Fn(&Traced) -> u64) -> u64 {
        self.map_pixels(|x, y| count(self.at(x, y))).iter().sum()
    }
}
