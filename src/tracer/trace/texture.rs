//! [`crate::scene::Pattern`]s and the directions of grooves.

use super::rays::to_picture;
use crate::lanes::*;
use crate::prepare::{Object, ObjectId, World};
use crate::scene::{Light, Pattern, Sphere};
use crate::shapes::block::{self, BlockHit};
use crate::shapes::{TexturePoint, plane, sphere};
use fearless_simd::f32x4;
use glam::Mat3;

impl<S: Isa> TexturePoint<S> {
    #[inline(always)]
    pub fn on(simd: S, object: &Object<'_>, out: Vec3x<S>) -> Self {
        match object {
            Object::Sphere(it) => sphere::texture_point(simd, it, out),
            Object::Block(block) => BlockHit::near(simd, block, out).texture_point,
            Object::Plane(_) | Object::Light(_) | Object::Background => {
                plane::texture_point(simd, out)
            }
        }
    }

    /// Returns the directions, of length 1, of grooves around the y axis of `axes`.
    #[inline(always)]
    pub fn groove(&self, simd: S, axes: &Mat3) -> Vec3x<S> {
        let [x, z] = [axes.x_axis, axes.z_axis].map(|axis| Vec3x::splat(simd, axis));
        let around = x.scaled(self.own.z).add_scaled(z, -self.own.x);
        let along = around.add_scaled(self.n, -around.dot(self.n));
        // Avoids NaN on the axis.
        let length2 = at_least::<S>(along.dot(along), splat(simd, f32::MIN_POSITIVE));
        along.scaled(splat::<S>(simd, 1.0) / length2.sqrt())
    }

    /// Returns the pattern's factor on the colour, and a hash of the half-wave between the
    /// pattern's edges, seen along `d` from the distance `t`, in lengths of `d`. The factor is 0 to
    /// 1, negated where the pattern is fine.
    #[inline(always)]
    pub fn reflectance(
        &self,
        simd: S,
        world: World<'_>,
        pattern: &Pattern,
        d: &Vec3x<S>,
        t: F<S>,
    ) -> (F<S>, U<S>) {
        // The second point is idle: another copy of the code would cost bytes.
        let mut pair = [(self.own, self.pixels(world, d, t)); 2];
        swirl(simd, pattern, &mut pair);
        let [(own, pixels), _] = &pair;
        reflectance(simd, pattern, own, *pixels)
    }

    /// Returns the length of a scene unit in pixels, seen along `d` from the distance `t`.
    #[inline(always)]
    fn pixels(&self, world: World<'_>, d: &Vec3x<S>, t: F<S>) -> F<S> {
        // At distance 1, seen perpendicularly, a pixel is `pixel` wide.
        d.dot(self.n).abs() / (t * world.pixel)
    }
}

pub(crate) struct PatternOnScreen<'a> {
    world: World<'a>,
    object: Object<'a>,
    pattern: &'a Pattern,
}

impl<'a> PatternOnScreen<'a> {
    pub fn new(world: World<'a>, id: ObjectId) -> Self {
        let (object, material) = world.object(id);
        Self { world, object, pattern: &material.pattern }
    }

    /// Sets the factors on the colour, 0 to 1, of the pixels of a square from (x, y) on, row by
    /// row; undefined at pixels that show other objects. The side is a power of two up to 8.
    #[inline(always)]
    pub fn set_shares<S: Isa>(
        &self,
        simd: S,
        [x, y]: [f32; 2],
        side: usize,
        shares: &mut [f32; 64],
    ) {
        let (world, lanes) = (self.world, lanes::<S>());
        let from = Vec3x::splat(simd, world.eye) - Vec3x::splat(simd, self.object.centre());
        let mut pair = [(from, splat(simd, 0.0)); 2];
        // A nested loop over the pair would take 670 packed bytes.
        for first in (0..(side * side).clamp(2 * lanes, 64)).step_by(lanes) {
            let i = lane_numbers(simd) + first as u32;
            let columns = (i & (side as u32 - 1)).to_float::<F<S>>() + x;
            let rows = (i >> side.trailing_zeros()).to_float::<F<S>>() + y;
            let (d, t) = hits(simd, world, &self.object, [columns, rows]);
            let point = TexturePoint::on(simd, &self.object, from.add_scaled(d, t));
            let second = first & lanes;
            pair[second / lanes] = (point.own, point.pixels(world, &d, t * d.dot(d)));
            if second > 0 {
                swirl(simd, self.pattern, &mut pair);
                for (i, (own, pixels)) in pair.iter().enumerate() {
                    let start = first - second + i * lanes;
                    let (share, _) = reflectance(simd, self.pattern, own, *pixels);
                    share.abs().store_slice(&mut shares[start..start + lanes]);
                }
            }
        }
    }
}

/// Compiled by the baseline, once for all callers.
#[inline(never)]
pub(crate) fn surface_points(
    world: World<'_>,
    object: &Object<'_>,
    at: [f32x4<Baseline>; 2],
) -> (Vec3x<Baseline>, f32x4<Baseline>) {
    hits(baseline(), world, object, at)
}

/// Returns the rays to points (x, y) of the picture, in pixels, and the distances of their hits on
/// the object, in lengths of the rays.
#[inline(always)]
fn hits<S: Isa>(
    simd: S,
    world: World<'_>,
    object: &Object<'_>,
    [x, y]: [F<S>; 2],
) -> (Vec3x<S>, F<S>) {
    let o = Vec3x::splat(simd, world.eye);
    let d = to_picture(simd, world, x, y);
    let from = o - Vec3x::splat(simd, object.centre());
    let t = match object {
        Object::Sphere(Sphere { radius, .. })
        | Object::Light(Light { drawn_radius: radius, .. }) => {
            sphere::distance(simd, *radius, &from, &d, d.dot(d))
        }
        Object::Block(block) => block::distance(simd, block, &o, &d, M::<S>::splat(simd, false)).0,
        Object::Plane(_) => plane::distance(&from, &d),
        Object::Background => splat(simd, f32::INFINITY),
    };
    (d, t)
}

/// The largest distance of a pixel from the nearest corner of a square of 8 pixels.
const REACH: f32 = 5.7;

/// The largest change of a pattern within [`REACH`] that may be interpolated, in halves of the
/// pattern's range. 0.2 costs 1 % of a colonnade's time for 2 dB in the worst of 2,000 random
/// patterns.
const SMOOTH: f32 = 0.5;

/// The slope of an octave of noise, divided by `warp * grain`. It is at most 3.8 where all octaves
/// agree, but mostly below 1. In 2,000 random patterns, 1.2 loses no spot of 9 pixels, and 0.7
/// loses two.
const NOISE_SLOPE: f32 = 1.2;

/// Returns a pattern's factor on the colour, 0 to 1, at the swirled points `own`, where a scene
/// unit is `pixels` pixels long, and a hash of the half-wave. The factor is negative where the
/// pattern is fine: it may change within [`REACH`] by more than [`SMOOTH`], unless clamping keeps
/// it constant.
///
/// The factor is `1 - depth / 2 (1 - clamp(edge * h + balance * max(edge, 1), -1, 1))`, where h is
/// `min(abs(w)) * sign(product of w)` of the waves w along the axes.
///
/// Inlining would add 630 packed bytes.
#[inline(never)]
fn reflectance<S: Isa>(simd: S, pattern: &Pattern, own: &Vec3x<S>, pixels: F<S>) -> (F<S>, U<S>) {
    by_isa!(simd: reflectance_by(simd, pattern, own, pixels))
}

#[inline(always)]
fn reflectance_by<S: Isa>(
    simd: S,
    pattern: &Pattern,
    own: &Vec3x<S>,
    pixels: F<S>,
) -> (F<S>, U<S>) {
    let mut height = splat(simd, 1.0);
    let mut hash = U::<S>::splat(simd, 0);
    if pattern.depth == 0.0 {
        return (height, hash);
    }
    let [along_x, along_y, along_z] = pattern.waves.to_array();
    let (noise, slope) = turbulence(simd, pattern, *own);
    for v in [own.x * along_x + noise, own.y * along_y, own.z * along_z] {
        let halves: F<S> = v + v;
        let wave = off_integer::<S>(halves).abs() * -2.0 + 1.0;
        height = at_most::<S>(wave, height);
        // Multiplies by an odd number: the lowest bit is the parity.
        hash = (hash + (hash << 4)) ^ (halves + ROUND_TO_INTEGER).bitcast::<U<S>>();
    }
    // Edges are at least a pixel wide.
    let steepest = pixels * (0.5 / pattern.waves.max_element());
    let edge = at_most::<S>(steepest, splat(simd, pattern.edge));
    let one = splat(simd, 1.0);
    let height = flipped::<S>(height * edge, hash << 31);
    let height = height + at_least::<S>(edge, one) * pattern.balance;
    let frequency = (along_x + slope).max(along_y).max(along_z) * steepness(pattern);
    let excess = at_least::<S>(height.abs() - 1.0, splat(simd, SMOOTH));
    let fine = (excess * pixels).simd_lt(edge * (4.0 * REACH * frequency));
    let height = clamp::<S>(height, -one, one);
    let share = (height - 1.0) * (0.5 * pattern.depth) + 1.0;
    let sign: U<S> = fine.to_vector().bitcast();
    (flipped::<S>(share, sign & (1 << 31)), hash)
}

/// Swirls the points of two packets, each with the pixels per scene unit. Every step waits for the
/// previous one, so two packets at once take little longer than one.
#[inline(never)]
fn swirl<S: Isa>(simd: S, pattern: &Pattern, points: &mut [(Vec3x<S>, F<S>); 2]) {
    by_isa!(simd: swirl_by(simd, pattern, points));
}

#[inline(always)]
fn swirl_by<S: Isa>(simd: S, pattern: &Pattern, points: &mut [(Vec3x<S>, F<S>); 2]) {
    let Pattern { swirl, stretch, .. } = *pattern;
    if swirl * pattern.grain == 0.0 {
        return;
    }
    for (p, _) in points.iter_mut() {
        p.x *= 1.0 - stretch;
        p.z *= 1.0 - stretch;
    }
    let (mut cells, mut length) = (pattern.grain, 1.0 / pattern.grain);
    for _ in 0..SWIRLS {
        for (p, pixels) in points.iter_mut() {
            let share = *pixels * (0.125 * length) - 0.5;
            let share = clamp::<S>(share, splat(simd, 0.0), splat(simd, 1.0));
            let strength = share * (-16.0 * swirl * length);
            p.x = shifted::<S>(p.x, p.y * cells, strength);
            p.y = shifted::<S>(p.y, p.z * cells, strength);
            p.z = shifted::<S>(p.z, p.x * cells, strength);
        }
        cells *= FINER;
        length *= 1.0 / FINER;
    }
}

/// Returns the factor of the swirls on a pattern's slope.
fn steepness(pattern: &Pattern) -> f32 {
    let growth = 1.0 + SWIRL_SLOPE * pattern.swirl * f32::from(pattern.grain != 0.0);
    (0..SWIRLS).fold(1.0, |steepness, _| steepness * growth)
}

/// Octaves of swirls.
const SWIRLS: usize = 7;

/// The ratio of the lengths of an octave's waves and the next one's: irrational, so that the
/// pattern does not repeat.
const FINER: f32 = 1.618_034;

/// The growth of a swirling pattern's slope per octave, for a `swirl` of 1. With 1, thin bands of
/// planets lose spots.
const SWIRL_SLOPE: f32 = 2.0;

/// Adds nearly a sine of `u`, with a period of 1 and the amplitude `strength / -16`.
#[inline(always)]
fn shifted<S: Isa>(p: F<S>, u: F<S>, strength: F<S>) -> F<S> {
    let f = off_integer::<S>(u);
    (f * strength).mul_add(f.abs() - 0.5, p)
}

/// Returns the noise along x, in periods, and its slope in periods per scene unit. The noise is
/// constant along one oblique direction.
#[inline(always)]
fn turbulence<S: Isa>(simd: S, pattern: &Pattern, p: Vec3x<S>) -> (F<S>, f32) {
    let mut u: F<S> = (p.z * 0.6 + p.x) * pattern.grain;
    let mut v: F<S> = (p.z * 0.8 + p.y) * pattern.grain;
    let mut sum = splat(simd, 0.0);
    let mut slope = 0.0;
    let mut strength = pattern.warp.min(64.0);
    while strength > Pattern::MIN_WARP {
        sum += noise::<S>(u, v) * strength;
        slope += NOISE_SLOPE * pattern.warp * pattern.grain;
        strength *= 0.5;
        u += u;
        v += v;
    }
    (sum, slope)
}

#[inline(always)]
fn noise<S: Isa>(u: F<S>, v: F<S>) -> F<S> {
    let (cell_u, s) = cell::<S>(u);
    let (cell_v, t) = cell::<S>(v);
    let lower = product::<S>(cell_u, ACROSS) + product::<S>(cell_v, ALONG);
    let mut corners = [s; 4];
    for (corner, step) in corners.iter_mut().zip(STEPS) {
        *corner = random::<S>(lower + step);
    }
    let [a, b, c, d] = corners;
    let (upper, lower) = (a + (b - a) * s, c + (d - c) * s);
    upper + (lower - upper) * t
}

const ACROSS: u32 = 0x9e37_79b9;
const ALONG: u32 = 0x85eb_ca6b;
const STEPS: [u32; 4] = [0, ACROSS, ALONG, ACROSS.wrapping_add(ALONG)];

/// Returns the bits of a cell's lower corner, and the smooth step from there.
#[inline(always)]
fn cell<S: Isa>(u: F<S>) -> (U<S>, F<S>) {
    let cell = u - 0.5 + ROUND_TO_INTEGER;
    let fraction: F<S> = u - (cell - ROUND_TO_INTEGER);
    (cell.bitcast(), smooth_step::<S>(fraction))
}

#[inline(always)]
fn random<S: Isa>(h: U<S>) -> F<S> {
    let h = product::<S>(h ^ (h >> 15), 0x846c_a68b).bitcast::<I<S>>();
    h.to_float::<F<S>>() * (1.0 / (1u32 << 31) as f32)
}

/// Returns the lower halves of the products.
#[inline(always)]
fn product<S: Isa>(a: U<S>, b: u32) -> U<S> {
    if S::MULTIPLIES_INTEGERS {
        return a * b;
    }
    let (first, last) = a.widening_mul(b);
    first.narrow(last)
}
