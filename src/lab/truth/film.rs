//! The film: the sums of the samples of a picture's pixels, which a run leaves to the next one.

use super::REPLICATIONS;
use super::connect::Connections;
use super::effects::Effects;
use super::estimate::Estimate;
use super::path::PathTracer;
use super::photons::{Emission, Photons};
use super::world::World;
use crate::arguments::Size;
use crate::interrupt;
use crate::sampler::{Sampler, Sequence, seed_of};
use eightfold_tracer::glam::DVec3;
use rayon::prelude::*;

/// The samples of a pixel so far: the sum of each replication.
pub type Sums = [DVec3; REPLICATIONS];

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
    pub pixels: Vec<Sums>,
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

impl Film {
    /// A film without samples.
    pub fn new(size: Size) -> Self {
        let row = Row {
            count: 0,
            pixels: vec![[DVec3::ZERO; REPLICATIONS]; size.width],
        };
        Self {
            width: size.width,
            rows: vec![row; size.height],
        }
    }

    /// Adds one sample to each replication of every row that has fewer than `count` of them, on the threads of the pool that it
    /// is called in. Calls `done` after each row. After Ctrl-C, the other rows are left as they are.
    ///
    /// All rows must have `count` samples, or one less.
    pub fn expose(
        &mut self,
        world: &World,
        effects: Effects,
        sampling: &Sampling,
        count: usize,
        done: &(impl Fn() + Sync),
    ) {
        let width = self.width;
        let connections = Connections::new(&world.bodies, &world.lamps);
        let photons = photons(world, &connections, effects, sampling, count - 1);
        let rows = self.rows.par_iter_mut().enumerate();
        let rows = rows.filter(|(_, row)| row.count < count);
        rows.for_each(|(y, row)| {
            if interrupt::is_stopped() {
                return;
            }
            for (x, sums) in row.pixels.iter_mut().enumerate() {
                let pixel = y * width + x;
                for (replication, sum) in sums.iter_mut().enumerate() {
                    let tracer = PathTracer {
                        world,
                        connections: &connections,
                        effects,
                        photons: &photons[replication],
                    };
                    let seed = seed_of(sampling.seed, (pixel * REPLICATIONS + replication) as u64);
                    let mut sampler = Sampler::new(sampling.sequence, count - 1, seed);
                    let u = sampler.next_2d();
                    let (mut x, mut y) = (x as f64, y as f64);
                    if sampling.is_antialiased {
                        x += u.x - 0.5;
                        y += u.y - 0.5;
                    }
                    *sum += tracer.follow(x, y, &mut sampler);
                }
            }
            row.count += 1;
            done();
        });
    }

    /// The number of samples of each replication that every pixel has.
    pub fn count(&self) -> usize {
        self.rows.iter().map(|row| row.count).min().unwrap_or(0)
    }

    /// The estimates of all pixels, row by row.
    pub fn estimates(&self) -> Vec<Estimate> {
        let rows = self.rows.iter();
        let of = |row: &Row| -> Vec<Estimate> {
            let pixels = row.pixels.iter();
            pixels.map(|sums| Estimate::of(sums, row.count)).collect()
        };
        rows.flat_map(of).collect()
    }
}

/// The photons of a sample, for each replication.
fn photons(
    world: &World,
    connections: &Connections,
    effects: Effects,
    sampling: &Sampling,
    index: usize,
) -> Vec<Photons> {
    let of = |replication: usize| {
        if !effects.caustics {
            return Photons::none();
        }
        // Other seeds than those of the pixels.
        let part = (index * REPLICATIONS + replication) as u64;
        let emission = Emission {
            sequence: sampling.sequence,
            seed: seed_of(!sampling.seed, part),
            index,
            has_extents: effects.soft_shadows,
        };
        Photons::emit(world, connections, &emission, effects.surfaces)
    };
    (0..REPLICATIONS).into_par_iter().map(of).collect()
}
