use super::{Oracle, Traced, pixel, pixel_like};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use std::thread::available_parallelism;

/// All pixels of a picture, and a border of one pixel.
pub struct Frame {
    pub width: usize,
    pub height: usize,
    dither: f32,
    /// Row by row, `width + 2` points each.
    points: Vec<Traced>,
}

impl Frame {
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
            dither: scene.film.dither,
            points,
        }
    }

    pub fn at(&self, x: usize, y: usize) -> &Traced {
        &self.points[(y + 1) * (self.width + 2) + x + 1]
    }

    fn map_pixels<T>(&self, of: impl Fn(usize, usize) -> T) -> Vec<T> {
        let pixels = (0..self.height).flat_map(|y| (0..self.width).map(move |x| (x, y)));
        pixels.map(|(x, y)| of(x, y)).collect()
    }

    pub fn picture(&self) -> Vec<u32> {
        self.map_pixels(|x, y| pixel(self.at(x, y).colour, self.dither, x, y))
    }

    pub fn picture_like(&self, drawn: &[u32]) -> Vec<u32> {
        self.map_pixels(|x, y| {
            let drawn = drawn[y * self.width + x];
            pixel_like(drawn, self.at(x, y).colour, self.dither, x, y)
        })
    }

    /// Returns which pixels are on silhouettes: the ray trees differ within 3x3 pixels, so rounding can change the object that a
    /// ray hits.
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
