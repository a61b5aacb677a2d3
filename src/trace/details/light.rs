//! How much of a lamp reaches places, where it is more than a point or casters more than spheres.

use super::body::first_ahead;
use super::{LANES, Packet, load};
use crate::lanes::*;
use crate::prepare::{Lamp, Object, Prepared};
use crate::scene::{Sphere, Spot};
use glam::Vec3A;

/// Finds what reaches some of a packet's places of a lamp, as a colour: the packet's rays lead there, and
/// meet none but its candidates.
#[inline(always)]
pub(in crate::trace) fn reach<S: Isa>(
    scene: &Prepared,
    lamp: &Lamp,
    active: M<S>,
    packet: &mut Packet,
) {
    let active = active.to_bitmask();
    for place in steps(0, lanes::<S>(), LANES) {
        if active >> place & ((1 << LANES) - 1) != 0 {
            reach_from(scene, lamp, place, packet);
        }
    }
}

/// The same of those from number `place` on that every CPU has lanes for.
#[inline(never)]
fn reach_from(scene: &Prepared, lamp: &Lamp, place: usize, packet: &mut Packet) {
    by_what_every_cpu_has!(simd => reach_by(simd, scene, lamp, place, packet));
}

#[inline(always)]
fn reach_by<S: Isa>(simd: S, scene: &Prepared, lamp: &Lamp, place: usize, packet: &mut Packet) {
    let one = splat(simd, 1.0);
    let place = place % MAX_LANES / lanes::<S>() * lanes::<S>();
    let o = packet.o.load_from(simd, place);
    let d = packet.d.load_from(simd, place);
    let t = load(simd, &packet.t[place..]);
    let zero = splat(simd, 0.0);
    let Spot { aim, dark, bright } = lamp.cone;
    let inward = (-d.dot(Vec3x::splat(simd, aim)) - dark) / (bright - dark);
    // Nothing where none is asked for.
    let asked = t.simd_gt(zero).select(step(simd, inward), zero);
    let mut passing = Vec3x {
        x: asked,
        y: asked,
        z: asked,
    };
    for &candidate in packet.candidates() {
        let (object, material) = scene.details.object(candidate.number());
        let blocked = match object {
            Object::Block(block) => {
                let is_met = first_ahead(simd, block, &o, &d).simd_lt(t);
                is_met.select(one, splat(simd, 0.0))
            }
            Object::Sphere(sphere) => blocked(simd, lamp, sphere, o, d, t),
            _ => continue,
        };
        // Of what is blocked the tint passes. What is no number is none: it would spoil what is not blocked, too.
        let mut left = Vec3A::ONE;
        if lamp.diameter > 0.0 {
            left -= material.tint.max(Vec3A::ZERO).min(Vec3A::ONE);
        }
        let blocked = candidate.lanes(simd, place).select(blocked, zero);
        passing = passing - (passing * Vec3x::splat(simd, left)).scaled(blocked);
        let most = passing.x.max(passing.y).max(passing.z);
        if most.simd_le(zero).all_true() {
            break;
        }
    }
    packet.passing.store_from(passing, place);
}

/// The share of a light that a sphere blocks (after Parker, Shirley and Smits: Single Sample Soft Shadows, 1998).
///
/// From the place the light is a cone; where it passes the sphere, `a` away, it is as wide as `b = a size / distance`. The
/// sphere's edge crosses it from one side to the other as the shadow goes from none to full.
#[inline(always)]
fn blocked<S: Isa>(
    simd: S,
    lamp: &Lamp,
    sphere: &Sphere,
    o: Vec3x<S>,
    d: Vec3x<S>,
    distance: F<S>,
) -> F<S> {
    let centre = sphere.centre;
    let to_centre = Vec3x::splat(simd, centre) - o;
    let a = to_centre.dot(d).max(splat(simd, 0.0)).min(distance);
    let off = to_centre.add_scaled(d, -a);
    // What starts on the sphere by rounding starts on it.
    let slack = 2e-6 * (centre.abs().max_element() + sphere.radius);
    let b = (a * lamp.diameter / distance).min(splat(simd, lamp.widest));
    let covered = -off.dot(off).sqrt() + (sphere.radius - slack);
    step(simd, covered / b.max(splat(simd, f32::MIN_POSITIVE)) + 0.5)
}

/// From 0 at 0 to 1 at 1, level at both ends and beyond.
#[inline(always)]
fn step<S: Isa>(simd: S, v: F<S>) -> F<S> {
    let v = v.max(splat(simd, 0.0)).min(splat(simd, 1.0));
    v * v * (v * -2.0 + 3.0)
}
