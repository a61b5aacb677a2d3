//! Points for averaging: a Sobol sequence with Owen's scrambling, which fills the unit cube evenly, or chance.
//!
//! Owen's scrambling makes every point uniform by itself, so that a mean over the points has no bias, and points with different
//! seeds are independent (Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995). For smooth functions the error of
//! the mean falls faster than that of random points: its slope is measured by `cargo lab truth --convergence`.

use eightfold_tracer::glam::{DVec2, DVec3, dvec2};
use sobol_burley::NUM_DIMENSIONS;
use std::f64::consts::{PI, TAU};

/// The most points of a sequence.
pub const MAX_POINTS: usize = 1 << 16;

/// Where the points come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sequence {
    /// A Sobol sequence with Owen's scrambling.
    Sobol,
    /// Independent random points, to compare with.
    Random,
}

/// One point of a sequence, which hands out its coordinates one after another.
#[derive(Clone, Debug)]
pub struct Sampler {
    sequence: Sequence,
    index: u32,
    seed: u32,
    dimension: u32,
}

impl Sampler {
    /// Point `index` of the sequence with a seed; below [`MAX_POINTS`].
    pub fn new(sequence: Sequence, index: usize, seed: u32) -> Self {
        assert!(index < MAX_POINTS, "the sequence ends at {MAX_POINTS}");
        Self {
            sequence,
            index: index as u32,
            seed,
            dimension: 0,
        }
    }

    /// The next coordinate, from 0 to below 1.
    pub fn next_1d(&mut self) -> f64 {
        let dimension = self.dimension;
        self.dimension += 1;
        match self.sequence {
            Sequence::Sobol => {
                // Beyond the last dimension the first ones follow, scrambled otherwise.
                let lap = dimension / NUM_DIMENSIONS;
                let seed = if lap == 0 {
                    self.seed
                } else {
                    seed_of(self.seed, u64::from(lap))
                };
                f64::from(sobol_burley::sample(
                    self.index,
                    dimension % NUM_DIMENSIONS,
                    seed,
                ))
            }
            Sequence::Random => {
                let point = u64::from(self.seed) << 32 | u64::from(self.index);
                let bits = mixed(mixed(point) ^ u64::from(dimension));
                // The upper 53 bits: as many as the fraction of an f64 has.
                (bits >> 11) as f64 / (1_u64 << 53) as f64
            }
        }
    }

    /// The next two coordinates.
    pub fn next_2d(&mut self) -> DVec2 {
        dvec2(self.next_1d(), self.next_1d())
    }
}

/// A seed for part number `part` of what is sampled with `seed`: seeds of different parts look independent.
pub fn seed_of(seed: u32, part: u64) -> u32 {
    (mixed(mixed(u64::from(seed)) ^ part) >> 32) as u32
}

/// The first number of [`split_mix`] for a state: a bijection whose every output bit depends on all input bits.
fn mixed(mut bits: u64) -> u64 {
    split_mix(&mut bits)
}

/// The next pseudorandom number of a state (Steele, Lea and Flood's SplitMix64, 2014).
pub fn split_mix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let bits = (*state ^ (*state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// A point of the unit disc, uniform by area. The map keeps neighbours together (Shirley and Chiu, 1997).
pub fn disc(u: DVec2) -> DVec2 {
    let p = 2.0 * u - DVec2::ONE;
    if p == DVec2::ZERO {
        return p;
    }
    let (radius, angle) = if p.x.abs() > p.y.abs() {
        (p.x, 0.25 * PI * p.y / p.x)
    } else {
        (p.y, 0.5 * PI - 0.25 * PI * p.x / p.y)
    };
    radius * DVec2::from_angle(angle)
}

/// A direction about an axis of length 1, at an angle of the given cosine.
pub fn around(axis: DVec3, cosine: f64, turn: f64) -> DVec3 {
    let (u, v) = axis.any_orthonormal_pair();
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (y, x) = (TAU * turn).sin_cos();
    (cosine * axis + sine * (x * u + y * v)).normalize()
}

/// A direction of the hemisphere about an axis of length 1, with a density of cosine / pi.
pub fn cosine_hemisphere(axis: DVec3, u: DVec2) -> DVec3 {
    let p = disc(u);
    let (s, t) = axis.any_orthonormal_pair();
    let height = (1.0 - p.length_squared()).max(0.0).sqrt();
    (p.x * s + p.y * t + height * axis).normalize()
}
