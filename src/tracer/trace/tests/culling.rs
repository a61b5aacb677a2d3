//! The tree loses nothing: rays meet what they meet when every sphere is tested, in f64 and without bounds.

use super::*;
use crate::scene::Light;
use crate::trace::candidates::Blockers;
use crate::trace::shadow::ShadowRays;

/// Scenes, each with a number of spheres from one to nearly the most, and packets in each.
const SCENES: usize = 60;
const PACKETS: usize = 100;

/// The distance from a sphere's surface below which a point may be on either side of it by rounding.
const UNSURE: f64 = 1e-3;

/// A sphere, centre and radius.
type Ball = (DVec3, f64);

/// A ray up to a distance.
struct Way {
    o: DVec3,
    d: DVec3,
    length: f64,
}

impl Way {
    /// The distance at which a sphere is hit, from outside or from inside, or infinity; `None` if that is not sure.
    fn meets(&self, &(centre, radius): &Ball) -> Option<f64> {
        let f = centre - self.o;
        let middle = f.dot(self.d);
        let off = (f - self.d * middle).length();
        let end = (self.o + self.d * self.length).distance(centre);
        if [off, f.length(), end]
            .iter()
            .any(|off| (off - radius).abs() < UNSURE)
        {
            return None;
        }
        let half = (radius * radius - off * off).max(0.0).sqrt();
        let is_outside = f.length() > radius;
        let t = if is_outside {
            middle - half
        } else {
            middle + half
        };
        let is_hit = off < radius && t > 0.0 && t < self.length;
        Some(if is_hit { t } else { f64::INFINITY })
    }

    /// The number of the nearest sphere, or that of the background; `None` if that is not sure.
    fn nearest(&self, balls: &[Ball], background: usize) -> Option<usize> {
        let mut best = (background, f64::INFINITY);
        for (i, ball) in balls.iter().enumerate() {
            let t = self.meets(ball)?;
            if (t - best.1).abs() < UNSURE {
                return None;
            }
            if t < best.1 {
                best = (i, t);
            }
        }
        Some(best.0)
    }

    /// Whether a sphere is in the way; `None` if that is not sure, or if one is around the end.
    fn is_blocked(&self, balls: &[Ball]) -> Option<bool> {
        let end = self.o + self.d * self.length;
        let mut is_blocked = false;
        for ball in balls {
            let &(centre, radius) = ball;
            if end.distance(centre) < radius {
                return None;
            }
            is_blocked |= self.meets(ball)?.is_finite();
        }
        Some(is_blocked)
    }
}

/// Spheres in a box of 16 by 16 by 16 units, and a lamp.
fn crowd(random: &mut Random) -> Scene {
    let count = 10_f64.powf(random.between(0.0, 2.5)) as usize;
    let largest = 4.0 / (count as f64).cbrt();
    let mut scene = Scene::default();
    for _ in 0..count {
        let mut number = || random.between(-8.0, 8.0);
        let centre = DVec3::new(number(), number(), number()).as_vec3();
        let radius = random.between(0.05, largest) as f32;
        let sphere = Sphere::new(centre, radius, Material::BLACK);
        scene.spheres.push(sphere);
    }
    scene.lights = List::of(&[Light {
        position: (random.direction() * random.between(1.0, 20.0)).as_vec3(),
        ..Light::DARK
    }]);
    scene
}

/// The directions of a packet's rays from a point to others in the crowd: from next to each other to far apart.
fn directions(random: &mut Random, from: DVec3) -> [Vec3; MAX_LANES] {
    let to = random.direction() * random.between(0.0, 8.0);
    let apart = 10_f64.powf(random.between(-3.0, 1.0));
    [(); MAX_LANES].map(|()| unit(to + random.direction() * apart - from))
}

/// How often something is hit, and not; how often points are lit, and in shadow.
type Tally = [usize; 4];

/// Checks the hits of a packet, and shadow rays from some way along its rays.
#[inline(always)]
fn check<S: Isa>(simd: S, world: World<'_>, random: &mut Random, balls: &[Ball]) -> Tally {
    let from = (random.direction() * random.between(0.0, 15.0)).as_vec3();
    let rays = packet(simd, from, &directions(random, from.as_dvec3()));
    let hit = hits(simd, world, &rays);
    let lamp = &world.lamps()[0];
    let some_way = splat(simd, random.between(0.1, 20.0) as f32);
    let o = rays.o.add_scaled(rays.d, some_way);
    let to_lamp = Vec3x::splat(simd, lamp.position) - o;
    let distance = to_lamp.dot(to_lamp).sqrt();
    let d = to_lamp.scaled(splat::<S>(simd, 1.0) / distance);
    let shadow_rays = ShadowRays { o, d, distance };
    let mut blockers = Blockers::NONE;
    let blocked = blockers.find(simd, world, lamp, &shadow_rays);
    let blocked = blocked.to_bitmask();
    let mut tally = [0; 4];
    for i in 0..lanes::<S>() {
        let way = |o, d, length: f32| Way {
            o: lane(o, i).as_dvec3(),
            d: lane(d, i).as_dvec3(),
            length: f64::from(length),
        };
        let background = world.background();
        if let Some(expected) = way(rays.o, rays.d, 1e9).nearest(balls, background) {
            let found = hit.object.as_slice()[i] as usize;
            assert_eq!(found, expected, "of {} spheres", balls.len());
            tally[usize::from(found == background)] += 1;
        }
        if let Some(expected) = way(o, d, distance.as_slice()[i]).is_blocked(balls) {
            let found = blocked >> i & 1 != 0;
            assert_eq!(found, expected, "shadows of {} spheres", balls.len());
            tally[2 + usize::from(found)] += 1;
        }
    }
    tally
}

struct Culling;

impl Property for Culling {
    #[inline(always)]
    fn hold<S: Isa>(&self, simd: S, isa: &str) {
        let mut random = Random::new(1985);
        let mut tally = [0; 4];
        for _ in 0..SCENES {
            let scene = crowd(&mut random);
            let spheres = scene.spheres.iter();
            let balls: Vec<Ball> = spheres
                .map(|sphere| (sphere.centre.as_dvec3(), f64::from(sphere.radius)))
                .collect();
            let scene = prepared(&scene);
            for _ in 0..PACKETS {
                let new = check(simd, scene.world(), &mut random, &balls);
                for (count, new) in tally.iter_mut().zip(new) {
                    *count += new;
                }
            }
        }
        let least = SCENES * PACKETS * lanes::<S>() / 20;
        assert!(tally.iter().all(|&count| count > least), "{isa}: {tally:?}");
    }
}

#[test]
fn the_tree_loses_no_solid_and_no_shadow() {
    on_every_instruction_set(&Culling);
}
