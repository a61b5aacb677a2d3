//! Procedural textures: what is left of a colour. See [`crate::scene::Pattern`].

use crate::scene::Pattern;
use glam::Vec3A;

/// What a pattern leaves of a colour at `own`, from where its coordinates begin; a pixel covers `footprint` there.
#[inline(never)]
pub(super) fn left_of_colour(pattern: &Pattern, own: Vec3A, footprint: f32) -> f32 {
    if pattern.depth == 0.0 {
        return 1.0;
    }
    let mut waves = own * pattern.waves;
    waves.x += turbulence(pattern, own);
    let (mut height, mut sign) = (1.0f32, 1.0f32);
    for v in waves.to_array() {
        // A triangle wave of length 1, between -1 and 1, highest at 0.
        let wave = 1.0 - 4.0 * (v - (v + ROUND_TO_INTEGER - ROUND_TO_INTEGER)).abs();
        height = height.min(wave.abs());
        sign *= wave;
    }
    // A wave falls from 1 to -1 in half its length: no edge is narrower than a pixel.
    let steepest = 0.5 / (footprint * pattern.waves.max_element());
    let edge = pattern.edge.min(steepest);
    let height = (height * edge).min(1.0).copysign(sign);
    1.0 + 0.5 * pattern.depth * (height - 1.0)
}

/// Added to a number it leaves the nearest whole one in the low bits, for numbers to 2^22.
const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// Noise by which the pattern is shifted, in waves: it is the same along a slope through the three axes.
fn turbulence(pattern: &Pattern, p: Vec3A) -> f32 {
    let mut u = (p.x + 0.6 * p.z) * pattern.grain;
    let mut v = (p.y + 0.8 * p.z) * pattern.grain;
    let mut sum = 0.0;
    // Whatever it is, it gets small soon.
    let mut strength = pattern.warp.min(64.0);
    while strength > Pattern::LEAST_WARP {
        sum += strength * noise(u, v);
        strength *= 0.5;
        u += u;
        v += v;
    }
    sum
}

/// Numbers by chance at whole coordinates, -1 to 1, and smooth between them.
#[inline(never)]
fn noise(u: f32, v: f32) -> f32 {
    // The cell's lower corner, with the bits that rounding leaves it in.
    let (cell_u, cell_v) = (u - 0.5 + ROUND_TO_INTEGER, v - 0.5 + ROUND_TO_INTEGER);
    let s = smooth(u - (cell_u - ROUND_TO_INTEGER));
    let t = smooth(v - (cell_v - ROUND_TO_INTEGER));
    let row = |v: u32| {
        let [a, b] = [0, 1].map(|i| chance(cell_u.to_bits() + i, v));
        a + (b - a) * s
    };
    let (upper, lower) = (row(cell_v.to_bits()), row(cell_v.to_bits() + 1));
    upper + (lower - upper) * t
}

/// A number from -1 to 1 by whole coordinates.
#[inline(never)]
fn chance(u: u32, v: u32) -> f32 {
    let h = u
        .wrapping_mul(0x9e37_79b9)
        .wrapping_add(v.wrapping_mul(0x85eb_ca6b));
    let h = (h ^ (h >> 15)).wrapping_mul(0x846c_a68b);
    h as i32 as f32 * (1.0 / (1u32 << 31) as f32)
}

/// From 0 at 0 to 1 at 1, level at both ends.
fn smooth(v: f32) -> f32 {
    v * v * (3.0 - 2.0 * v)
}
