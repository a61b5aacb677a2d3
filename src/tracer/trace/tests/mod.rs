//! Properties of the kernels, checked with many rays on every instruction set of the machine. [`crate::limits`] lists their
//! figures.

mod leaving;
mod neighbours;
mod patterns;
mod precision;
mod refraction;
mod scenes;
mod shadows;

extern crate std;

use super::candidates;
use super::intersect::{Hit, nearest, resolve_blocks};
use super::point::ShadingPoint;
use super::rays::{Rays, primary_directions};
use super::surface::{SurfaceLanes, SurfaceRows};
use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, World};
use crate::scene::{List, Material, Scene, Sphere};
use core::cell::RefCell;
#[cfg(target_arch = "x86_64")]
use fearless_simd::Level;
use glam::{DVec3, Vec2, Vec3};
use std::boxed::Box;
use std::vec::Vec;

/// A property that holds on every instruction set.
trait Property {
    /// Asserts the property. Implementations have to be inlined, as kernels are.
    fn hold<S: Isa>(&self, simd: S, isa: &str);
}

fn on_every_instruction_set(property: &impl Property) {
    #[cfg(target_arch = "x86_64")]
    {
        let level = Level::new();
        if let Some(simd) = level.as_avx512() {
            simd.vectorize(
                #[inline(always)]
                || property.hold(simd, "avx512"),
            );
        }
        if let Some(simd) = level.as_avx2() {
            simd.vectorize(
                #[inline(always)]
                || property.hold(simd, "avx2"),
            );
        }
    }
    let simd = baseline();
    simd.vectorize(
        #[inline(always)]
        || property.hold(simd, "the least"),
    );
}

/// A generator of pseudorandom numbers with its state (Steele, Lea and Flood's SplitMix).
struct Random(u64);

impl Random {
    /// A generator for a seed. `RAY_SEED=1 cargo test -p eightfold-tracer trace` changes all seeds; the tests have to pass with any.
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

    /// A number of random sign whose logarithm to base 10 is uniformly distributed.
    fn of_magnitude(&mut self, low: f64, high: f64) -> f64 {
        let number = 10_f64.powf(self.between(low, high));
        if self.bits() & 1 == 0 {
            number
        } else {
            -number
        }
    }

    /// A vector of such numbers.
    fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        let mut number = || self.of_magnitude(low, high);
        DVec3::new(number(), number(), number())
    }

    /// A uniformly distributed direction.
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

    /// A direction from a surface, on the side that its normal points to.
    fn direction_from(&mut self, n: Vec3) -> Vec3 {
        let any = self.direction().as_vec3();
        if any.dot(n) < 0.0 { -any } else { any }
    }
}

/// A normalised direction in f32.
fn unit(d: DVec3) -> Vec3 {
    d.normalize().as_vec3()
}

/// A scene with one sphere.
fn one_sphere(centre: Vec3, radius: f32, material: Material) -> Scene {
    Scene {
        spheres: List::of(&[Sphere::new(centre, radius, material)]),
        ..Scene::default()
    }
}

std::thread_local! {
    /// Prepared scenes that are no longer in use on this thread.
    static UNUSED: RefCell<Vec<Box<Prepared>>> = const { RefCell::new(Vec::new()) };
}

/// A prepared scene. Its memory is reused for the next scene, as it is for the next frame.
struct Ready {
    scene: Scene,
    /// `None` once the memory has been handed on.
    memory: Option<Box<Prepared>>,
}

impl Ready {
    fn world(&self) -> World<'_> {
        World {
            scene: &self.scene,
            prepared: self.memory.as_ref().expect("it is handed on last"),
        }
    }
}

impl Drop for Ready {
    fn drop(&mut self) {
        UNUSED.with_borrow_mut(|unused| unused.extend(self.memory.take()));
    }
}

fn prepared(scene: &Scene) -> Ready {
    let unused = UNUSED.with_borrow_mut(Vec::pop);
    let mut memory = unused.unwrap_or_else(|| Box::new(Prepared::new()));
    memory.prepare(scene, [8, 8], Vec2::ZERO);
    Ready {
        scene: scene.clone(),
        memory: Some(memory),
    }
}

/// A packet of rays with a common origin. Lanes beyond the slice repeat its last direction.
#[inline(always)]
fn packet<S: Isa>(simd: S, o: Vec3, d: &[Vec3]) -> Rays<S> {
    let d = |i: usize| d[i.min(d.len() - 1)];
    Rays {
        o: Vec3x::splat(simd, o),
        d: Vec3x {
            x: F::<S>::from_fn(simd, |i| d(i).x),
            y: F::<S>::from_fn(simd, |i| d(i).y),
            z: F::<S>::from_fn(simd, |i| d(i).z),
        },
        weight: splat(simd, 1.0),
        slot_path: Rays::slot_paths(simd, 0),
    }
}

/// The hits of a packet, as the tracer finds them.
#[inline(always)]
fn hits<S: Isa>(simd: S, world: World<'_>, rays: &Rays<S>) -> Hit<S> {
    let mut blocks = candidates::NONE;
    let mut hit = nearest(simd, world, rays, GroupSet::MAX, &mut blocks);
    resolve_blocks(simd, world, rays, &blocks, &mut hit);
    hit
}

/// The shading points of these hits.
#[inline(always)]
fn shading_point<S: Isa>(
    simd: S,
    world: World<'_>,
    rays: &Rays<S>,
    hit: &Hit<S>,
) -> ShadingPoint<S> {
    let active = first(simd, lanes::<S>());
    let mut rows = SurfaceRows::NONE;
    let surface = SurfaceLanes::look_up(simd, world, hit.object, active, &mut rows);
    ShadingPoint::new(simd, world, rays, hit, &surface, active)
}

/// The vector in a lane.
#[inline(always)]
fn lane<S: Isa>(v: Vec3x<S>, i: usize) -> Vec3 {
    Vec3::new(v.x.as_slice()[i], v.y.as_slice()[i], v.z.as_slice()[i])
}
