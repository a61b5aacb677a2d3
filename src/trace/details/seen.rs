//! Patterns where the eye sees them, for pixels whose object is known.

#![allow(dead_code, reason = "for pixels between samples")]

use super::body::first_ahead;
use super::closer;
use super::packet::LEFT;
use crate::DETAILS;
use crate::lanes::*;
use crate::prepare::{Object, Prepared};
use crate::trace::batch::seen_at;

/// Whether a pattern varies the colour of the object number `object`.
pub(crate) fn has_pattern(scene: &Prepared, object: usize) -> bool {
    let details = &scene.details;
    DETAILS && details.is_there() && details.object(&scene.tree, object).1.pattern.depth != 0.0
}

/// What the pattern of the object number `object` leaves of its colour, 0 to 1, at the pixel (x, y) and the three to the
/// right of it, where the eye sees it there; where it sees none of it, what it leaves nearby.
///
/// Only where the object [has one](has_pattern).
#[inline(never)]
pub(crate) fn left_seen(scene: &Prepared, object: usize, x: usize, y: usize) -> [f32; 4] {
    let mut left = [1.0; 4];
    by_what_every_cpu_has!(simd => left_seen_by(simd, scene, object, [x, y], &mut left));
    left
}

#[inline(always)]
fn left_seen_by<S: Isa>(
    simd: S,
    scene: &Prepared,
    object: usize,
    [x, y]: [usize; 2],
    left: &mut [f32; 4],
) {
    let zero = splat(simd, 0.0);
    let o = Vec3x::splat(simd, scene.eye);
    let x: F<S> = numbers(simd).bitcast::<I<S>>().to_float::<F<S>>() + x as f32;
    let d = seen_at(simd, scene, x, splat(simd, y as f32));
    let way_to = |centre| (Vec3x::splat(simd, centre) - o).dot(d);
    let (t, middle) = match scene.details.object(&scene.tree, object).0 {
        Object::Sphere(sphere) => {
            let middle: F<S> = way_to(sphere.centre);
            let across = (o - Vec3x::splat(simd, sphere.centre)).add_scaled(d, middle);
            let half2 = -across.dot(across) + sphere.radius * sphere.radius;
            let half = half2.max(zero).sqrt();
            let near = middle - half;
            (near.simd_gt(zero).select(near, middle + half), middle)
        }
        Object::Block(block) => (first_ahead(simd, block, &o, &d), way_to(block.centre)),
        Object::Plane(plane) => ((splat(simd, plane.centre.y) - o.y) / d.y, zero),
        _ => (zero, zero),
    };
    // Where it passes by, by where it comes nearest to the centre.
    let t = t.simd_lt(splat(simd, f32::MAX)).select(t, middle).max(zero);
    let seen = closer(simd, scene, object, &o, &d, t)[LEFT];
    for (left, seen) in left.iter_mut().zip(seen.as_slice()) {
        *left = *seen;
    }
}
