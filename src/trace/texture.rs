//! Procedural textures: what is left of a colour. See [`crate::scene::Pattern`].

use super::batch::primary_directions;
use super::block::{self, BlockHit};
use crate::lanes::*;
use crate::prepare::{Object, ObjectId, Prepared};
use crate::scene::{Pattern, Sphere};
use glam::Vec3A;

/// Points of a surface as its texture sees them, a ray's each.
pub(super) struct TexturePoint<S: Isa> {
    /// From where the pattern's coordinates begin, along the object's own axes.
    pub own: Vec3x<S>,
    /// The normal, of length 1, on either side.
    pub n: Vec3x<S>,
}

impl<S: Isa> TexturePoint<S> {
    /// On a sphere, `out` from its centre.
    #[inline(always)]
    pub fn on_sphere(simd: S, sphere: &Sphere, out: Vec3x<S>) -> Self {
        Self {
            own: out,
            n: out.scaled(splat(simd, 1.0 / sphere.radius)),
        }
    }

    /// On a plane, `out` from its centre: at height 0, but for rounding.
    #[inline(always)]
    pub fn on_plane(simd: S, out: Vec3x<S>) -> Self {
        Self {
            own: out * Vec3x::splat(simd, Vec3A::new(1.0, 0.0, 1.0)),
            n: Vec3x::splat(simd, Vec3A::Y),
        }
    }

    /// On a box or a cylinder.
    #[inline(always)]
    pub fn on_block(hit: &BlockHit<S>) -> Self {
        Self {
            own: hit.own,
            n: hit.n,
        }
    }

    /// The share of its colour that the surface keeps, 0 to 1, seen along `d` from a distance `t`.
    #[inline(always)]
    pub fn reflectance(
        &self,
        simd: S,
        scene: &Prepared,
        pattern: &Pattern,
        d: &Vec3x<S>,
        t: F<S>,
    ) -> F<S> {
        // A pixel at distance 1 is `axes.pixel` wide, seen from straight above.
        let pixels = d.dot(self.n).abs() / (t * scene.axes.pixel);
        reflectance(simd, pattern, &self.own, pixels)
    }
}

/// The share of its colour that a surface with a pattern keeps, 0 to 1, at the pixel (x, y) and the three to the right of
/// it, if these show the object; otherwise any share.
pub(crate) fn pattern_at_pixels(scene: &Prepared, id: ObjectId, x: usize, y: usize) -> [f32; 4] {
    let mut shares = [0.0; 4];
    let found = pattern_at_row(baseline(), scene, id, x, y);
    for (share, &found) in shares.iter_mut().zip(found.as_slice()) {
        *share = found;
    }
    shares
}

/// The same for as many pixels as there are lanes.
#[inline(always)]
fn pattern_at_row<S: Isa>(simd: S, scene: &Prepared, id: ObjectId, x: usize, y: usize) -> F<S> {
    let (object, material) = scene.object(id);
    let o = Vec3x::splat(simd, scene.eye);
    let x: F<S> = numbers(simd).bitcast::<I<S>>().to_float::<F<S>>() + x as f32;
    let d = primary_directions(simd, scene, x, splat(simd, y as f32));
    let (point, t) = match object {
        Object::Sphere(sphere) => {
            let from = o - Vec3x::splat(simd, sphere.centre);
            let t = sphere_distance(simd, sphere.radius, &from, &d);
            let out = from.add_scaled(d, t);
            (TexturePoint::on_sphere(simd, sphere, out), t)
        }
        Object::Block(block) => {
            let from = o - Vec3x::splat(simd, block.centre);
            let t = block::distance(simd, block, &o, &d);
            let hit = BlockHit::near(simd, block, from.add_scaled(d, t));
            (TexturePoint::on_block(&hit), t)
        }
        Object::Plane(plane) => {
            let from = o - Vec3x::splat(simd, plane.centre);
            let t = -from.y / d.y;
            let out = from.add_scaled(d, t);
            (TexturePoint::on_plane(simd, out), t)
        }
        Object::Light(_) | Object::Background => return splat(simd, 1.0),
    };
    point.reflectance(simd, scene, &material.pattern, &d, t)
}

/// The distances at which rays that start `from` a sphere's centre meet it; from within, its far side.
#[inline(always)]
fn sphere_distance<S: Isa>(simd: S, radius: f32, from: &Vec3x<S>, d: &Vec3x<S>) -> F<S> {
    let zero = splat(simd, 0.0);
    let back: F<S> = from.dot(*d);
    let across = from.add_scaled(*d, -back);
    let half2 = -across.dot(across) + radius * radius;
    let half = at_least::<S>(half2, zero).sqrt();
    let (near, far) = (-back - half, half - back);
    near.simd_gt(zero).select(near, far)
}

/// The share that a pattern leaves of a colour, 0 to 1, at points `own`; a unit of length is `pixels` pixels there.
///
/// `1 - depth / 2 (1 - clamp(edge * min(abs(w)) * sign(product of w), -1, 1))` by the waves w along the axes.
#[inline(always)]
fn reflectance<S: Isa>(simd: S, pattern: &Pattern, own: &Vec3x<S>, pixels: F<S>) -> F<S> {
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
        height = at_most::<S>(wave.abs(), height);
        sign ^= wave.bitcast::<U<S>>();
    }
    // A wave falls from 1 to -1 in half its length: no edge is narrower than a pixel.
    let steepest = pixels * (0.5 / pattern.waves.max_element());
    let edge = at_most::<S>(steepest, splat(simd, pattern.edge));
    let height = at_most::<S>(height * edge, splat(simd, 1.0));
    let height = flipped::<S>(height, sign & (1 << 31));
    (height - 1.0) * (0.5 * pattern.depth) + 1.0
}

/// 1.5 * 2^23: adding it leaves the nearest integer in the low bits, for numbers to 2^22.
const ROUND_TO_INTEGER: f32 = 12_582_912.0;

/// Noise by which the pattern is shifted, in waves: it is the same along a slope through the three axes.
#[inline(always)]
fn turbulence<S: Isa>(simd: S, pattern: &Pattern, p: Vec3x<S>) -> F<S> {
    let mut u: F<S> = (p.z * 0.6 + p.x) * pattern.grain;
    let mut v: F<S> = (p.z * 0.8 + p.y) * pattern.grain;
    let mut sum = splat(simd, 0.0);
    // A bound on the turns of the loop, whatever the scene says.
    let mut strength = pattern.warp.min(64.0);
    while strength > Pattern::LEAST_WARP {
        sum += noise::<S>(u, v) * strength;
        strength *= 0.5;
        u += u;
        v += v;
    }
    sum
}

/// Value noise: random numbers from -1 to 1 at whole coordinates, interpolated smoothly between them.
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

/// What a step along each coordinate adds to the number that [`chance`] hashes.
const ACROSS: u32 = 0x9e37_79b9;
const ALONG: u32 = 0x85eb_ca6b;
/// What leads from the lower corner of a cell to each of its corners.
const STEPS: [u32; 4] = [0, ACROSS, ALONG, ACROSS.wrapping_add(ALONG)];

/// The bits of the cell's lower corner, as rounding leaves them, and the smooth step from there: 0 to 1, level at both ends.
#[inline(always)]
fn cell<S: Isa>(u: F<S>) -> (U<S>, F<S>) {
    let cell = u - 0.5 + ROUND_TO_INTEGER;
    let way: F<S> = u - (cell - ROUND_TO_INTEGER);
    (cell.bitcast(), way * way * (way * -2.0 + 3.0))
}

/// A hash as a number from -1 to 1.
#[inline(always)]
fn chance<S: Isa>(h: U<S>) -> F<S> {
    let h = product::<S>(h ^ (h >> 15), 0x846c_a68b).bitcast::<I<S>>();
    h.to_float::<F<S>>() * (1.0 / (1u32 << 31) as f32)
}

/// The lower halves of products, by way of the whole products: SSE2 has no other multiplication.
#[inline(always)]
fn product<S: Isa>(a: U<S>, b: u32) -> U<S> {
    let (first, last) = a.widening_mul(b);
    first.narrow(last)
}
