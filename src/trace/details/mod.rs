//! What only some scenes have: boxes and cylinders, patterns, air, lamps that are more than points.
//!
//! It is much, and the intro has no room to have it once for every instruction set: it works on packets in memory. What
//! rays meet is told in the lanes that every CPU has; what that looks like a ray at a time, for neighbours may well meet
//! different objects.

/// Evaluates an expression by the instruction set that every CPU has.
macro_rules! by_what_every_cpu_has {
    ($simd:ident => $expression:expr) => {{
        #[cfg(target_arch = "x86_64")]
        if let Some($simd) = fearless_simd::Level::baseline().as_sse2() {
            $expression;
        }
        #[cfg(not(target_arch = "x86_64"))]
        fearless_simd::dispatch!(fearless_simd::Level::baseline(), $simd => $expression);
    }};
}

mod body;
mod light;
mod packet;
mod texture;

pub(super) use light::reach;
pub(crate) use packet::Packet;
pub(super) use packet::load;
use packet::store;

use crate::lanes::*;
use crate::prepare::{Object, Prepared};
use body::{Spot, first_ahead};
use glam::Vec3A;
use texture::left_of_colour;

/// Has a packet's rays, which have met spheres and planes, meet the boxes and cylinders among its candidates.
#[inline(always)]
fn meet<S: Isa>(simd: S, scene: &Prepared, active: u64, packet: &mut Packet) {
    for place in steps(0, MAX_LANES, lanes::<S>()) {
        if active >> place == 0 {
            break;
        }
        let (o, d) = (
            packet.o.load_from(simd, place),
            packet.d.load_from(simd, place),
        );
        let mut t = load(simd, &packet.t[place..]);
        let mut object = load(simd, &packet.object[place..]);
        for &i in packet.candidates() {
            if let (Object::Block(block), _) = scene.details.object(&scene.tree, i as usize) {
                let nearer = first_ahead(simd, block, &o, &d);
                let is_nearer = nearer.simd_lt(t);
                t = is_nearer.select(nearer, t);
                object = is_nearer.select(splat(simd, f32::from_bits(i.into())), object);
            }
        }
        store::<S>(t, &mut packet.t[place..]);
        store::<S>(object, &mut packet.object[place..]);
    }
}

/// Finds out what some of a packet's rays meet beyond spheres and planes, among its candidates, and what that looks
/// like: reads the rays, and the hits with spheres and planes; sees to everything but `passing`.
#[inline(never)]
pub(super) fn look(scene: &Prepared, active: u64, packet: &mut Packet) {
    by_what_every_cpu_has!(simd => meet(simd, scene, active, packet));
    let details = &scene.details;
    let air = &details.scene;
    for lane in 0..MAX_LANES {
        if active >> lane & 1 == 0 {
            continue;
        }
        let (o, d) = (packet.o.at(lane), packet.d.at(lane));
        let (t, number) = (packet.t[lane], packet.object[lane].to_bits() as usize);

        let (object, material) = details.object(&scene.tree, number);
        let hit = o + d * t;
        let mut way = t;
        let mut slack = 0.0;
        let (own, n) = match object {
            Object::Sphere(sphere) => {
                let out = hit - sphere.centre;
                (out, out / sphere.radius)
            }
            Object::Block(block) => {
                let centre = block.centre;
                let spot = Spot::near(block, o - centre + d * t);
                slack = body::slack(block);
                // On the ray's side.
                let apart = slack.copysign(-d.dot(spot.n));
                packet.p.put(lane, centre + spot.out + spot.n * apart);
                packet.n.put(lane, spot.n);
                (spot.own, spot.n)
            }
            Object::Plane(plane) => ((hit - plane.centre) * LEVEL, Vec3A::Y),
            Object::Lamp(_) => {
                way = 0.0;
                (hit, d)
            }
            Object::Nothing => (hit, d),
        };
        packet.slack[lane] = slack;
        way *= air.haze + LEAST_HAZE;
        packet.through[lane] = 1.0 / (1.0 + way * way);
        // A pixel at distance 1 covers `pixel`, seen from straight above.
        let footprint = details.pixel * t / d.dot(n).abs();
        packet.left[lane] = left_of_colour(&material.pattern, own, footprint);

        let rise = d.y.max(0.0);
        let behind = air.background + air.sky * (rise * (2.0 - rise));
        packet.behind.put(lane, behind);
    }
}

/// Haze through which nothing is seen from as far away as nothing is, and all from anywhere else.
const LEAST_HAZE: f32 = 1e-20;

/// Without the y of a plane, which is exact.
const LEVEL: Vec3A = Vec3A::new(1.0, 0.0, 1.0);
