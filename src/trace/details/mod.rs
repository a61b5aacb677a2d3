//! What only some scenes have: boxes and cylinders, patterns, air, lamps that are more than points.
//!
//! It is much, and the intro has no room to have it once for every instruction set: it works on packets in
//! memory, a ray at a time, for neighbours may well meet different objects. What bounds bodies and lamps is told in lanes.

mod body;
mod light;
mod packet;
mod texture;

pub(super) use light::reach;
pub(crate) use packet::Packet;
pub(super) use packet::load;

use crate::lanes::MAX_LANES;
use crate::prepare::{Object, Prepared};
use body::{Spot, first_ahead};
use glam::Vec3A;
use texture::left_of_colour;

/// Finds out what some of a packet's rays meet beyond spheres and planes, among its candidates, and what that looks
/// like: reads the rays, and the hits with spheres and planes; sees to everything but `passing`.
#[inline(never)]
pub(super) fn look(scene: &Prepared, lanes: u64, packet: &mut Packet) {
    let details = &scene.details;
    let air = &details.scene;
    for lane in 0..MAX_LANES {
        if lanes >> lane & 1 == 0 {
            continue;
        }
        let (o, d) = (packet.o.at(lane), packet.d.at(lane));
        let (mut t, mut number) = (packet.t[lane], packet.object[lane].to_bits() as usize);
        for &i in packet.candidates() {
            if let (Object::Block(block), _) = details.object(&scene.tree, i as usize) {
                let nearer = first_ahead(block, o, d);
                if nearer < t {
                    (t, number) = (nearer, i as usize);
                }
            }
        }
        (packet.t[lane], packet.object[lane]) = (t, f32::from_bits(number as u32));

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
