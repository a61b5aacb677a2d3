//! What only some scenes have: boxes and cylinders, patterns, air, lamps that are more than points.
//!
//! It is much, and the intro has no room to have it once for every instruction set: it works on packets in memory, in the
//! lanes that every CPU has.

/// So many lanes every CPU has.
pub(super) const LANES: usize = 4;

mod body;
mod light;
mod packet;
mod seen;
mod texture;

pub(super) use light::reach;
pub(crate) use packet::Packet;
use packet::{Closer, LEFT, load, store};
pub(crate) use seen::{has_pattern, left_seen};

use super::surface::object_at;
use crate::lanes::*;
use crate::prepare::{Object, Prepared};
use body::{Spot, first_ahead};
use glam::Vec3A;
use texture::left_of_colour;

/// Finds out what some of a packet's rays meet beyond spheres and planes, among its candidates, and what that looks
/// like: reads the rays, and the hits with spheres and planes; sees to everything but `passing`.
#[inline(always)]
pub(super) fn look<S: Isa>(scene: &Prepared, active: M<S>, packet: &mut Packet) {
    let active = active.to_bitmask();
    for place in steps(0, lanes::<S>(), LANES) {
        look_from(scene, active >> place, place, packet);
    }
}

/// The same of those from number `place` on that every CPU has lanes for.
#[inline(never)]
fn look_from(scene: &Prepared, active: u64, place: usize, packet: &mut Packet) {
    by_what_every_cpu_has!(simd => look_by(simd, scene, active, place, packet));
}

#[inline(always)]
fn look_by<S: Isa>(simd: S, scene: &Prepared, active: u64, place: usize, packet: &mut Packet) {
    let mut rest = active & ((1 << lanes::<S>()) - 1);
    let place = place % MAX_LANES / lanes::<S>() * lanes::<S>();
    let o = packet.o.load_from(simd, place);
    let d = packet.d.load_from(simd, place);
    let mut t = load(simd, &packet.t[place..]);
    let mut object = load(simd, &packet.object[place..]);
    for &candidate in packet.candidates() {
        let number = candidate.number();
        if let (Object::Block(block), _) = scene.details.object(number) {
            let nearer = first_ahead(simd, block, &o, &d);
            let is_nearer = nearer.simd_lt(t) & candidate.lanes(simd, place);
            t = is_nearer.select(nearer, t);
            object = is_nearer.select(splat(simd, f32::from_bits(number as u32)), object);
        }
    }
    store::<S>(t, &mut packet.t[place..]);
    store::<S>(object, &mut packet.object[place..]);
    let rise = d.y.max(splat(simd, 0.0));
    let air = &scene.details.scene;
    let behind = Vec3x::splat(simd, air.background)
        .add_scaled(Vec3x::splat(simd, air.sky), rise * (rise * -1.0 + 2.0));
    packet.behind.store_from(behind, place);
    // Neighbours may well meet different objects.
    while rest != 0 {
        let (number, same) = object_at(simd, object.bitcast(), &mut rest);
        let closer = closer(simd, scene, number, &o, &d, t);
        for (column, new) in packet.closer.iter_mut().zip(closer) {
            let column = &mut column[place..];
            let old = load(simd, column);
            store::<S>(same.select(new, old), column);
        }
    }
}

/// What the object number `number` looks like from where rays of length `t` come that meet it.
#[inline(never)]
fn closer<S: Isa>(
    simd: S,
    scene: &Prepared,
    number: usize,
    o: &Vec3x<S>,
    d: &Vec3x<S>,
    t: F<S>,
) -> Closer<F<S>> {
    let details = &scene.details;
    let (object, material) = details.object(number);
    let centre = match object {
        Object::Sphere(sphere) => sphere.centre,
        Object::Block(block) => block.centre,
        Object::Plane(plane) => plane.centre,
        _ => Vec3A::ZERO,
    };
    let centre = Vec3x::splat(simd, centre);
    let out = (*o - centre).add_scaled(*d, t);
    // As on a plane, whose y is exact; without a pattern it is all the same.
    let mut spot = Spot {
        out,
        n: Vec3x::splat(simd, Vec3A::Y),
        own: out * Vec3x::splat(simd, LEVEL),
    };
    let mut slack = 0.0;
    let mut haze = details.scene.haze + LEAST_HAZE;
    match object {
        Object::Sphere(sphere) => {
            spot.n = out.scaled(splat(simd, 1.0 / sphere.radius));
            spot.own = out;
        }
        Object::Block(block) => {
            slack = body::slack(block);
            spot = Spot::near(simd, block, out);
        }
        Object::Lamp(_) => haze = 0.0,
        _ => {}
    }
    let Spot { out, n, own } = spot;
    let dn = d.dot(n);
    let slack = splat(simd, slack);
    // On the ray's side.
    let p = (centre + out).add_scaled(n, flipped::<S>(slack, !dn.bitcast::<U<S>>() & (1 << 31)));
    let way: F<S> = t * haze;
    let through = splat::<S>(simd, 1.0) / (way * way + 1.0);
    // A pixel at distance 1 covers `pixel`, seen from straight above.
    let pixels = dn.abs() / (t * details.pixel);
    let mut closer = [
        p.x,
        p.y,
        p.z,
        n.x,
        n.y,
        n.z,
        slack,
        through,
        splat(simd, 0.0),
    ];
    // Last, when little else is to be kept.
    closer[LEFT] = left_of_colour(simd, &material.pattern, &own, pixels);
    closer
}

/// Without the y.
const LEVEL: Vec3A = Vec3A::new(1.0, 0.0, 1.0);

/// Haze through which nothing is seen from as far away as nothing is, and all from anywhere else.
const LEAST_HAZE: f32 = 1e-20;
