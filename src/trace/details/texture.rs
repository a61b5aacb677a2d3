//! Procedural textures: what is left of a colour. See [`crate::scene::Pattern`].

use crate::lanes::*;
use crate::scene::Pattern;

/// What a pattern leaves of a colour at places `own`, from where its coordinates begin; a unit of length is `pixels` pixels
/// there. From 0 to 1, whatever the places.
#[inline(never)]
pub(super) fn left_of_colour<S: Isa>(
    simd: S,
    pattern: &Pattern,
    own: &Vec3x<S>,
    pixels: F<S>,
) -> F<S> {
    let mut height = splat(simd, 1.0);
    if pattern.depth == 0.0 {
        return height;
    }
    let mut sign = U::<S>::splat(simd, 0);
    let [along_x, along_y, along_z] = pattern.waves.to_array();
    for v in [
        own.x * along_x + turbulence(simd, pattern, *own),
        own.y * along_y,
        own.z * along_z,
    ] {
        // A triangle wave of length 1, between -1 and 1, highest at 0.
        let wave = (v - (v + ROUND_TO_INTEGER - ROUND_TO_INTEGER)).abs() * -4.0 + 1.0;
        // Of what is no number the other stays, here and below.
        height = wave.abs().min(height);
        sign ^= wave.bitcast::<U<S>>();
    }
    // A wave falls from 1 to -1 in half its length: no edge is narrower than a pixel.
    let steepest = pixels * (0.5 / pattern.waves.max_element());
    let edge = steepest.min(splat(simd, pattern.edge));
    let height = (height * edge).min(splat(simd, 1.0));
    let height = flipped::<S>(height, sign & (1 << 31));
    (height - 1.0) * (0.5 * pattern.depth) + 1.0
}

/// Added to a number it leaves the nearest whole one in the low bits, for numbers to 2^22.
const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// Noise by which the pattern is shifted, in waves: it is the same along a slope through the three axes.
#[inline(always)]
fn turbulence<S: Isa>(simd: S, pattern: &Pattern, p: Vec3x<S>) -> F<S> {
    let mut u: F<S> = (p.z * 0.6 + p.x) * pattern.grain;
    let mut v: F<S> = (p.z * 0.8 + p.y) * pattern.grain;
    let mut sum = splat(simd, 0.0);
    // Whatever it is, it gets small soon.
    let mut strength = pattern.warp.min(64.0);
    while strength > Pattern::LEAST_WARP {
        sum += noise::<S>(u, v) * strength;
        strength *= 0.5;
        u += u;
        v += v;
    }
    sum
}

/// Numbers by chance at whole coordinates, -1 to 1, and smooth between them.
#[inline(always)]
fn noise<S: Isa>(u: F<S>, v: F<S>) -> F<S> {
    let (cell_u, s) = cell::<S>(u);
    let (cell_v, t) = cell::<S>(v);
    let lower = product::<S>(cell_u, ACROSS) + product::<S>(cell_v, ALONG);
    let mut corners = [s; 4];
    for (corner, step) in corners.iter_mut().zip(STEPS) {
        *corner = chance::<S>(lower + step);
    }
    let [a, b, c, d] = corners;
    let (upper, lower) = (a + (b - a) * s, c + (d - c) * s);
    upper + (lower - upper) * t
}

/// What a step along each coordinate adds to the number that [`chance`] takes.
const ACROSS: u32 = 0x9e37_79b9;
const ALONG: u32 = 0x85eb_ca6b;
/// To each corner of a cell.
static STEPS: [u32; 4] = [0, ACROSS, ALONG, ACROSS.wrapping_add(ALONG)];

/// The bits of the cell's lower corner, as rounding leaves them, and the way on from there, level at both ends.
#[inline(always)]
fn cell<S: Isa>(u: F<S>) -> (U<S>, F<S>) {
    let cell = u - 0.5 + ROUND_TO_INTEGER;
    let way: F<S> = u - (cell - ROUND_TO_INTEGER);
    (cell.bitcast(), way * way * (way * -2.0 + 3.0))
}

/// A number from -1 to 1 by whole coordinates.
#[inline(always)]
fn chance<S: Isa>(h: U<S>) -> F<S> {
    let h = product::<S>(h ^ (h >> 15), 0x846c_a68b).bitcast::<I<S>>();
    h.to_float::<F<S>>() * (1.0 / (1u32 << 31) as f32)
}

/// The lower halves of products: those of whole registers the plainest processors have to take apart.
#[inline(always)]
fn product<S: Isa>(a: U<S>, b: u32) -> U<S> {
    let (first, last) = a.widening_mul(b);
    first.narrow(last)
}
