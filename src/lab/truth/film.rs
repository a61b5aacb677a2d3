//! The film: the sums of the samples of a picture's pixels, which a run leaves to the next one.

use super::REPLICATIONS;
use super::effects::Effects;
use super::estimate::{Estimate, Pixel};
use super::path::PathTracer;
use super::photons::{Caustics, Photons};
use super::world::World;
use crate::arguments::{Part, Size};
use crate::interrupt;
use crate::sampler::{Sampler, Sequence, seed_of};
use rayon::prelude::*;

/// A picture that is being sampled.
///
/// The samples of a pixel belong to [`REPLICATIONS`] sequences, whose seeds depend on the pixel and nothing else: so the picture
/// has the same bits in whatever order its rows are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    pub width: usize,
    pub rows: Vec<Row>,
}

/// A row of pixels.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The number of samples of each replication of each pixel.
    pub count: usize,
    /// None, if another part of the picture has the row.
    pub pixels: Vec<Pixel>,
}

/// How a picture is sampled.
#[derive(Clone, Copy, Debug)]
pub struct Sampling {
    /// Samples of each replication.
    pub count: usize,
    pub sequence: Sequence,
    pub seed: u32,
    /// Whether samples are spread over the pixel; otherwise all are at its centre.
    pub is_antialiased: bool,
}

/// What a picture shows, and how it is sampled.
pub struct Subject {
    pub world: World,
    pub caustics: Caustics,
    pub effects: Effects,
    pub sampling: Sampling,
}

impl Film {
    /// A film for a part of a picture's rows, without samples.
    pub fn new(size: Size, part: Part) -> Self {
        let row = |y| {
            let width = if part.has(y) { size.width } else { 0 };
            Row {
                count: 0,
                pixels: vec![Pixel::default(); width],
            }
        };
        Self {
            width: size.width,
            rows: (0..size.height).map(row).collect(),
        }
    }

    /// The rows that it has.
    pub fn own_rows(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().filter(|row| !row.pixels.is_empty())
    }

    /// Adds one sample to each replication of every row that has fewer than `count` of them, on the threads of the pool that it
    /// is called in. Calls `done` after each row. After Ctrl-C, the other rows are left as they are.
    ///
    /// All its rows must have `count` samples, or one less.
    pub fn expose(&mut self, subject: &Subject, count: usize, done: &(impl Fn() + Sync)) {
        let (width, sampling) = (self.width, subject.sampling);
        let photons = subject.photons(count - 1);
        let rows = self.rows.par_iter_mut().enumerate();
        let rows = rows.filter(|(_, row)| row.count < count && !row.pixels.is_empty());
        rows.for_each(|(y, row)| {
            if interrupt::is_stopped() {
                return;
            }
            for (x, pixel) in row.pixels.iter_mut().enumerate() {
                let index = y * width + x;
                for (replication, sum) in pixel.sums.iter_mut().enumerate() {
                    let tracer = PathTracer {
                        world: &subject.world,
                        connections: &subject.caustics.connections,
                        effects: subject.effects,
                        photons: &photons[replication],
                    };
                    let seed = seed_of(sampling.seed, (index * REPLICATIONS + replication) as u64);
                    let mut sampler = Sampler::new(sampling.sequence, count - 1, seed);
                    let u = sampler.next_2d();
                    let (mut x, mut y) = (x as f64, y as f64);
                    if sampling.is_antialiased {
                        x += u.x - 0.5;
                        y += u.y - 0.5;
                    }
                    let found = tracer.follow(x, y, &mut sampler);
                    *sum += found.light;
                    pixel.blur += found.blur;
                }
            }
            row.count += 1;
            done();
        });
    }

    /// The number of samples of each replication that every pixel has.
    pub fn count(&self) -> usize {
        self.own_rows().map(|row| row.count).min().unwrap_or(0)
    }

    /// The estimates of all pixels, row by row.
    pub fn estimates(&self) -> Vec<Estimate> {
        let rows = self.rows.iter();
        let of = |row: &Row| -> Vec<Estimate> {
            let pixels = row.pixels.iter();
            pixels.map(|pixel| Estimate::of(pixel, row.count)).collect()
        };
        rows.flat_map(of).collect()
    }
}

impl Subject {
    /// The photons of a sample, for each replication.
    fn photons(&self, index: usize) -> Vec<Photons> {
        let of = |replication: usize| {
            if !self.effects.caustics {
                return Photons::none();
            }
            // Other seeds than those of the pixels.
            let part = (index * REPLICATIONS + replication) as u64;
            let seed = seed_of(!self.sampling.seed, part);
            let sequence = self.sampling.sequence;
            Photons::emit(
                &self.world,
                &self.caustics,
                self.effects,
                sequence,
                seed,
                index,
            )
        };
        (0..REPLICATIONS).into_par_iter().map(of).collect()
    }
}
