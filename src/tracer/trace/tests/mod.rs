//! Properties of the kernels, checked with many rays on every instruction set.

mod leaving;
mod precision;
mod refraction;

extern crate std;

use super::candidates::Candidates;
use super::intersect::{Hit, nearest, resolve_blocks};
use super::point::ShadingPoint;
use super::rays::Rays;
use super::shade::shade;
use super::surface::{SurfaceLanes, SurfaceRows};
use super::{Batch, Tracer};
use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, World};
use crate::quality::Quality;
use crate::scene::{List, Material, Scene, Sphere};
use crate::zero::Zero;
use core::array;
use fearless_simd::Level;
use glam::{DVec3, Vec2, Vec3};
use std::boxed::Box;

/// The kernels of one instruction set. Packets and results have plain numbers, so that properties
/// are compiled once. Only the first `lanes` rays of a packet are traced; further results repeat
/// theirs.
trait Kernels {
    fn lanes(&self) -> usize;

    fn fuses_mul_add(&self) -> bool;

    /// Of rays that leave a surface.
    fn hits(&self, world: World<'_>, packet: &Packet, departure: u32) -> [(f32, u32); MAX_LANES];

    fn meets(&self, world: World<'_>, packet: &Packet) -> [Met; MAX_LANES];

    /// The reflected and the transmitted ray of each.
    fn secondary(
        &self,
        world: World<'_>,
        packet: &Packet,
        batch: &mut Batch,
    ) -> [[Option<Ray>; 2]; MAX_LANES];
}

fn on_every_instruction_set(property: impl Fn(&dyn Kernels, &str)) {
    property(&By(baseline()), "baseline");
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = Level::new().as_avx2() {
        property(&By(simd), "avx2");
    }
    #[cfg(target_arch = "x86_64")]
    if let Some(simd) = Level::new().as_avx512() {
        property(&By(simd), "avx512");
    }
}

/// SplitMix (Steele, Lea and Flood).
struct Random(u64);

impl Random {
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

    /// Of random sign. The decimal logarithm is uniform between `low` and `high`.
    fn of_magnitude(&mut self, low: f64, high: f64) -> f64 {
        let number = 10_f64.powf(self.between(low, high));
        [number, -number][(self.bits() & 1) as usize]
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
    Scene { spheres: List::of(&[Sphere::new(centre, radius, material)]), ..Scene::default() }
}

struct Ready {
    scene: Scene,
    memory: Box<Prepared>,
}

impl Ready {
    fn world(&self) -> World<'_> {
        World { scene: &self.scene, prepared: &self.memory }
    }
}

fn prepared(scene: &Scene) -> Ready {
    let scene = scene.clone();
    let mut memory = Box::new(Prepared::ZERO);
    memory.prepare(&scene, [8, 8], Vec2::ZERO);
    Ready { scene, memory }
}

/// Origin, direction and weight.
type Ray = (Vec3, Vec3, f32);
type Packet = [Ray; MAX_LANES];

/// Further rays repeat the last direction.
fn packet(o: Vec3, d: &[Vec3]) -> Packet {
    array::from_fn(|i| (o, d[i.min(d.len() - 1)], 1.0))
}

struct Met {
    t: f32,
    object: u32,
    p: Vec3,
    n: Vec3,
    /// See [`ShadingPoint::hit_error`].
    error: f32,
    departure: u32,
    is_inside: bool,
}

struct By<S>(S);

impl<S: Isa> By<S> {
    #[inline(always)]
    fn rays(&self, packet: &Packet, departure: u32) -> Rays<S> {
        let simd = self.0;
        let vectors = |v: fn(Ray) -> Vec3| Vec3x {
            x: F::<S>::from_fn(simd, |i| v(packet[i]).x),
            y: F::<S>::from_fn(simd, |i| v(packet[i]).y),
            z: F::<S>::from_fn(simd, |i| v(packet[i]).z),
        };
        Rays {
            o: vectors(|ray| ray.0),
            d: vectors(|ray| ray.1),
            weight: F::<S>::from_fn(simd, |i| packet[i].2),
            slot_path: Rays::slot_paths(simd, 0) | departure,
        }
    }

    #[inline(never)]
    fn nearest(&self, world: World<'_>, rays: &Rays<S>) -> Hit<S> {
        let simd = self.0;
        by_isa!(simd: {
            let mut blocks = Candidates::ZERO;
            let mut hit = nearest(simd, world, rays, GroupSet::MAX, &mut blocks);
            resolve_blocks(simd, world, rays, &blocks, &mut hit);
            hit
        })
    }
}

impl<S: Isa> Kernels for By<S> {
    fn lanes(&self) -> usize {
        lanes::<S>()
    }

    fn fuses_mul_add(&self) -> bool {
        S::FUSES_MUL_ADD
    }

    fn hits(&self, world: World<'_>, packet: &Packet, departure: u32) -> [(f32, u32); MAX_LANES] {
        let hit = self.nearest(world, &self.rays(packet, departure));
        each::<S, _>(|i| (hit.t.as_slice()[i], hit.object.as_slice()[i]))
    }

    fn meets(&self, world: World<'_>, packet: &Packet) -> [Met; MAX_LANES] {
        let simd = self.0;
        let rays = self.rays(packet, 0);
        let hit = self.nearest(world, &rays);
        let point = by_isa!(simd: {
            let active = first_lanes(simd, lanes::<S>());
            let mut rows = SurfaceRows::ZERO;
            let surface = SurfaceLanes::look_up(simd, world, hit.object, active, &mut rows);
            ShadingPoint::new(simd, world, &rays, &hit, &surface, active)
        });
        each::<S, _>(|i| Met {
            t: hit.t.as_slice()[i],
            object: hit.object.as_slice()[i],
            p: lane(point.p, i),
            n: lane(point.n, i),
            error: point.hit_error.as_slice()[i],
            departure: point.departure.as_slice()[i],
            is_inside: point.inside.to_bitmask() >> i & 1 == 1,
        })
    }

    fn secondary(
        &self,
        world: World<'_>,
        packet: &Packet,
        batch: &mut Batch,
    ) -> [[Option<Ray>; 2]; MAX_LANES] {
        let simd = self.0;
        let rays = self.rays(packet, 0);
        let hit = self.nearest(world, &rays);
        let mut secondary = [[None; 2]; MAX_LANES];
        by_isa!(simd: {
            let tracer = Tracer { isa: simd, world, quality: &Quality::EXHAUSTIVE };
            batch.begin();
            shade(tracer, &rays, &hit, first_lanes(simd, lanes::<S>()), batch);
            while batch.stack.len() > 0 {
                let (rays, count) = batch.stack.pop(simd);
                let (paths, slots) = (rays.paths(), rays.slots());
                for i in 0..count {
                    let [path, slot] = [paths, slots].map(|numbers| numbers.as_slice()[i] as usize);
                    let weight = rays.weight.as_slice()[i];
                    secondary[slot][path - 2] = Some((lane(rays.o, i), lane(rays.d, i), weight));
                }
            }
        });
        each::<S, _>(|i| secondary[i])
    }
}

fn each<S: Isa, T>(result: impl Fn(usize) -> T) -> [T; MAX_LANES] {
    array::from_fn(|i| result(i % lanes::<S>()))
}

fn lane<S: Isa>(v: Vec3x<S>, i: usize) -> Vec3 {
    Vec3::new(v.x.as_slice()[i], v.y.as_slice()[i], v.z.as_slice()[i])
}
