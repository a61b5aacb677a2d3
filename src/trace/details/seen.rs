//! Patterns where the eye sees them, for pixels whose object is known.

use super::body::first_ahead;
use super::closer;
use super::packet::LEFT;
use crate::lanes::*;
use crate::prepare::{Object, PATTERN, Prepared};
use crate::trace::batch::seen_at;

/// Whether a pattern with edges varies the colour of the object number `object`.
#[inline(always)]
pub(crate) fn has_pattern(scene: &Prepared, object: usize) -> bool {
    scene.surface(object)[PATTERN][0] != 0.0
}

/// What the pattern of the object number `object` leaves of its colour, 0 to 1, at the pixel (x, y) and the three to the
/// right of it, where the eye sees it there; anything where it sees none of it.
///
/// Only where the object [has one](has_pattern).
#[inline(never)]
pub(crate) fn left_seen(scene: &Prepared, object: usize, x: usize, y: usize) -> [f32; 4] {
    let mut left = [0.0; 4];
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
    let t = match scene.details.object(object).0 {
        Object::Block(block) => first_ahead(simd, block, &o, &d),
        Object::Plane(plane) => (splat(simd, plane.centre.y) - o.y) / d.y,
        Object::Sphere(sphere) => {
            let from = o - Vec3x::splat(simd, sphere.centre);
            let back: F<S> = from.dot(d);
            let across = from.add_scaled(d, -back);
            let half2 = -across.dot(across) + sphere.radius * sphere.radius;
            let half = half2.max(zero).sqrt();
            // From within the far side.
            let (near, far) = (-back - half, half - back);
            near.simd_gt(zero).select(near, far)
        }
        _ => zero,
    };
    let seen = closer(simd, scene, object, &o, &d, t)[LEFT];
    for (left, seen) in left.iter_mut().zip(seen.as_slice()) {
        *left = *seen;
    }
}
