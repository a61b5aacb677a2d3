//! Properties of the kernels, checked with many rays on every instruction set. [`crate::limits`] has their figures.

mod leaving;
mod neighbours;
mod patterns;
mod precision;
mod refraction;
mod scenes;
mod shadows;

extern crate std;

use super::accumulator::Contribution;
use super::intersect::{Hit, nearest, resolve_blocks};
use super::point::ShadingPoint;
use super::rays::Rays;
use super::shade::shade;
use super::surface::{SurfaceLanes, SurfaceRows};
use super::{Batch, Tracer, candidates};
use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, World};
use crate::quality::Quality;
use crate::scene::{List, Material, Scene, Sphere};
use fearless_simd::Level;
use glam::{DVec3, Vec2, Vec3};
use std::boxed::Box;

/// A property of every instruction set. Inline implementations, as kernels are.
trait Property {
    fn hold<S: Isa>(&self, simd: S, isa: &str);
}

fn on_every_instruction_set(property: &impl Property) {
    let (level, simd) = (Level::new(), baseline());
    by_isa!(simd: property.hold(simd, "baseline"));
    if let Some(simd) = avx2(level) {
        by_isa!(simd: property.hold(simd, "avx2"));
    }
    if let Some(simd) = avx512(level) {
        by_isa!(simd: property.hold(simd, "avx512"));
    }
}

/// A generator of pseudorandom numbers: SplitMix (Steele, Lea and Flood).
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        let other = std::env::var("RAY_SEED").map_or(0, |seed| seed.parse().unwrap());
        Self(seed ^ other << 32)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut h = self.0;
        h = (h ^ (h >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        h = (h ^ (h >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        h ^ (h >> 31)
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a number of random sign whose decimal logarithm is uniform between `low` and `high`.
    fn of_magnitude(&mut self, low: f64, high: f64) -> f64 {
        let number = 10_f64.powf(self.between(low, high));
        if self.bits() & 1 == 0 {
            number
        } else {
            -number
        }
    }

    fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        let mut number = || self.of_magnitude(low, high);
        DVec3::new(number(), number(), number())
    }

    fn direction(&mut self) -> DVec3 {
        loop {
            let mut number = || self.between(-1.0, 1.0);
            let v = DVec3::new(number(), number(), number());
            let length2 = v.length_squared();
            if (1e-3..1.0).contains(&length2) {
                return v / length2.sqrt();
            }
        }
    }

    fn direction_from(&mut self, n: Vec3) -> Vec3 {
        let any = self.direction().as_vec3();
        if any.dot(n) < 0.0 { -any } else { any }
    }
}

fn unit(d: DVec3) -> Vec3 {
    d.normalize().as_vec3()
}

fn one_sphere(centre: Vec3, radius: f32, material: Material) -> Scene {
    Scene {
        spheres: List::of(&[Sphere::new(centre, radius, material)]),
        ..Scene::default()
    }
}

struct Ready {
    scene: Scene,
    memory: Box<Prepared>,
}

impl Ready {
    fn world(&self) -> World<'_> {
        World {
            scene: &self.scene,
            prepared: &self.memory,
        }
    }
}

fn prepared(scene: &Scene) -> Ready {
    let scene = scene.clone();
    let mut memory = Box::new(Prepared::new());
    memory.prepare(&scene, [8, 8], Vec2::ZERO);
    Ready { scene, memory }
}

/// Origin, direction and weight.
type Ray = (Vec3, Vec3, f32);

#[inline(always)]
fn gathered<S: Isa>(simd: S, ray: impl Fn(usize) -> Ray) -> Rays<S> {
    let vectors = |v: fn(Ray) -> Vec3| Vec3x {
        x: F::<S>::from_fn(simd, |i| v(ray(i)).x),
        y: F::<S>::from_fn(simd, |i| v(ray(i)).y),
        z: F::<S>::from_fn(simd, |i| v(ray(i)).z),
    };
    Rays {
        o: vectors(|ray| ray.0),
        d: vectors(|ray| ray.1),
        weight: F::<S>::from_fn(simd, |i| ray(i).2),
        slot_path: Rays::slot_paths(simd, 0),
    }
}

/// Lanes beyond the slice repeat its last direction.
#[inline(always)]
fn packet<S: Isa>(simd: S, o: Vec3, d: &[Vec3]) -> Rays<S> {
    gathered(simd, |i| (o, d[i.min(d.len() - 1)], 1.0))
}

/// Compiled once per instruction set, not once per property.
#[inline(never)]
fn hits<S: Isa>(simd: S, world: World<'_>, rays: &Rays<S>) -> Hit<S> {
    by_isa!(simd: {
        let mut blocks = candidates::NONE;
        let mut hit = nearest(simd, world, rays, GroupSet::MAX, &mut blocks);
        resolve_blocks(simd, world, rays, &blocks, &mut hit);
        hit
    })
}

/// Returns hits, contributions, and each lane's reflected and transmitted ray.
#[inline(never)]
fn shaded<S: Isa>(
    simd: S,
    world: World<'_>,
    quality: &Quality,
    rays: &Rays<S>,
    batch: &mut Batch,
) -> (Hit<S>, Contribution<S>, [[Option<Ray>; MAX_LANES]; 2]) {
    let hit = hits(simd, world, rays);
    let mut secondary = [[None; MAX_LANES]; 2];
    let contribution = by_isa!(simd: {
        let tracer = Tracer {
            isa: simd,
            world,
            quality,
        };
        batch.begin();
        let contribution = shade(tracer, rays, &hit, first(simd, lanes::<S>()), batch);
        while batch.stack.len() > 0 {
            let (rays, count) = batch.stack.pop(simd);
            let (paths, slots) = (rays.paths(), rays.slots());
            for i in 0..count {
                let [path, slot] = [paths, slots].map(|numbers| numbers.as_slice()[i] as usize);
                let weight = rays.weight.as_slice()[i];
                secondary[path - 2][slot] = Some((lane(rays.o, i), lane(rays.d, i), weight));
            }
        }
        contribution
    });
    (hit, contribution, secondary)
}

#[inline(never)]
fn shading_point<S: Isa>(
    simd: S,
    world: World<'_>,
    rays: &Rays<S>,
    hit: &Hit<S>,
) -> ShadingPoint<S> {
    by_isa!(simd: {
        let active = first(simd, lanes::<S>());
        let mut rows = SurfaceRows::NONE;
        let surface = SurfaceLanes::look_up(simd, world, hit.object, active, &mut rows);
        ShadingPoint::new(simd, world, rays, hit, &surface, active)
    })
}

#[inline(always)]
fn lane<S: Isa>(v: Vec3x<S>, i: usize) -> Vec3 {
    Vec3::new(v.x.as_slice()[i], v.y.as_slice()[i], v.z.as_slice()[i])
}
