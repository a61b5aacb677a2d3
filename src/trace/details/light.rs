//! How much of a lamp reaches places, where it is more than a point or casters more than spheres.

use super::Packet;
use super::body::first_ahead;
use crate::lanes::MAX_LANES;
use crate::prepare::{Object, Prepared};
use crate::scene::{Sphere, Spot};
use glam::Vec3A;

/// Finds what reaches some of a packet's places of the lamp number `lamp`, as a colour: the packet's rays lead there, and
/// meet none but its candidates.
#[inline(never)]
pub(in crate::trace) fn reach(scene: &Prepared, lamp: usize, lanes: u64, packet: &mut Packet) {
    let light = scene.details.light(lamp);
    let size = light.diameter();
    for lane in 0..MAX_LANES {
        if lanes >> lane & 1 == 0 {
            continue;
        }
        let (o, d, t) = (packet.o.at(lane), packet.d.at(lane), packet.t[lane]);
        let mut passing = Vec3A::ONE;
        if let Some(Spot { aim, dark, bright }) = light.spot {
            passing *= step((-d.dot(aim) - dark) / (bright - dark));
        }
        for &i in packet.candidates() {
            let (object, material) = scene.details.object(&scene.tree, i as usize);
            let blocked = match object {
                Object::Block(block) => f32::from(u8::from(first_ahead(block, o, d) < t)),
                Object::Sphere(sphere) => blocked(size, sphere, o, d, t),
                _ => 0.0,
            };
            // Of what is blocked the tint passes.
            let tint = if size > 0.0 {
                material.tint
            } else {
                Vec3A::ZERO
            };
            passing *= 1.0 - blocked + tint * blocked;
        }
        packet.passing.put(lane, passing);
    }
}

/// The share of a light that a sphere blocks (after Parker, Shirley and Smits: Single Sample Soft Shadows, 1998).
///
/// From the place the light is a cone; where it passes the sphere, `a` away, it is as wide as `b = a size / distance`. The
/// sphere's edge crosses it from one side to the other as the shadow goes from none to full.
fn blocked(size: f32, sphere: &Sphere, o: Vec3A, d: Vec3A, distance: f32) -> f32 {
    let centre = sphere.centre;
    let to_centre = centre - o;
    #[allow(clippy::manual_clamp, reason = "a distance is not below 0")]
    let a = to_centre.dot(d).max(0.0).min(distance);
    let off = (to_centre - d * a).length();
    // What starts on the sphere by rounding starts on it.
    let slack = 2e-6 * (centre.abs().max_element() + sphere.radius);
    let b = a * size / distance;
    step((sphere.radius - slack - off) / b.max(f32::MIN_POSITIVE) + 0.5)
}

/// From 0 at 0 to 1 at 1, level at both ends and beyond.
fn step(v: f32) -> f32 {
    // Not `clamp`, which says what is wrong with its limits.
    #[allow(clippy::manual_clamp, reason = "the limits are constants")]
    let v = v.max(0.0).min(1.0);
    v * v * (3.0 - 2.0 * v)
}
