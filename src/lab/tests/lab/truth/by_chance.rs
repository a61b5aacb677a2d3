//! A room with mirrors is as bright as paths say that find its lamp by chance alone: no direction is chosen for the lamp's sake, no
//! light is followed from it, and there are no photons and no closed forms.

use super::drawn;
use eightfold_lab::arguments::Size;
use eightfold_lab::sampler::{Sampler, Sequence, cosine_hemisphere, seed_of};
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::surface::Bounce;
use eightfold_lab::truth::world::World;
use eightfold_tracer::glam::{Vec3A, vec3a};
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};

/// The side of the picture, in pixels.
const SIDE: usize = 16;
/// Paths by chance for each pixel: their mean over the picture is off by a thousandth, as a standard deviation.
const PATHS: usize = 6000;
/// Paths of the truth for each pixel.
const SAMPLES: usize = 256;
/// Light that was reflected so often is less than a thousandth of all.
const MOST_BOUNCES: usize = 40;

/// A room of grey walls with a ball and a box that mirror, under a lamp that is large, so that chance finds it.
fn room() -> Scene {
    let grey = Material::matt(Vec3A::splat(0.7), 1.0);
    let mirror = Material::mirror(0.9);
    let wall = |centre, half| Block::new(Shape::Box, centre, half, grey);
    Scene {
        camera: Camera::new(vec3a(0.0, 2.0, 7.4), 1.5 * Vec3A::Y, 0.5),
        background: Vec3A::splat(0.1),
        spheres: List::of(&[Sphere::new(vec3a(-1.0, 0.75, -0.6), 0.75, mirror)]),
        planes: List::of(&[0.0, 4.0].map(|y| Plane::new(y * Vec3A::Y, 2.2, 2.2, grey))),
        blocks: List::of(&[
            wall(vec3a(-2.2, 2.0, 0.0), vec3a(0.05, 2.0, 2.2)),
            wall(vec3a(2.2, 2.0, 0.0), vec3a(0.05, 2.0, 2.2)),
            wall(vec3a(0.0, 2.0, -2.2), vec3a(2.2, 2.0, 0.05)),
            Block::new(
                Shape::Box,
                vec3a(1.0, 0.8, -0.6),
                vec3a(0.6, 0.8, 0.3),
                mirror,
            ),
        ]),
        lights: List::of(&[Light {
            diameter: 1.0,
            ..Light::new(vec3a(0.0, 3.2, 0.3), Vec3A::splat(0.4))
        }]),
        ..Scene::default()
    }
}

/// The radiance along a path that goes on as the surfaces say, through a pixel's centre. The lamp is no body.
fn radiance(world: &World, x: f64, y: f64, sampler: &mut Sampler) -> f64 {
    let lamp = &world.lamps[0];
    let mut ray = world.primary_ray(x, y);
    let (mut light, mut throughput, mut is_scattered) = (0.0, 1.0, false);
    for _ in 0..MOST_BOUNCES {
        let nearest = world.nearest(ray);
        let t = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
        // The eye sees no lamp that has a size and no radius.
        if is_scattered && lamp.meet(ray).is_some_and(|lamp| lamp < t) {
            light += throughput * lamp.radiance(ray.o).x;
        }
        let Some((body, met)) = nearest else {
            return light + throughput * world.behind(ray.d).x;
        };
        let bsdf = world.surface(body, ray, &met, true);
        let (d, share) = if bsdf.is_rough() {
            is_scattered = true;
            let facing = -met.normal * met.normal.dot(ray.d).signum();
            let d = cosine_hemisphere(facing, sampler.next_2d());
            (d, f64::from(0.7_f32))
        } else {
            bsdf.bounced(Bounce::Mirrored).expect("a mirror")
        };
        throughput *= share;
        ray = ray.moved(met.t).turned(d);
    }
    light
}

#[test]
#[ignore = "many paths"]
fn a_room_with_mirrors_is_as_bright_as_by_paths_that_find_the_lamp_by_chance() {
    let scene = room();
    let world = World::new(&scene, SIDE, SIDE, true);
    let mut by_chance = 0.0;
    for pixel in 0..SIDE * SIDE {
        for path in 0..PATHS {
            let mut sampler = Sampler::new(Sequence::Random, path, seed_of(0, pixel as u64));
            let [x, y] = [pixel % SIDE, pixel / SIDE].map(|at| at as f64);
            by_chance += radiance(&world, x, y, &mut sampler) / PATHS as f64;
        }
    }
    let size = Size::new(SIDE, SIDE);
    let effects = Effects {
        falloff: true,
        ..Effects::TRUTH
    };
    let found = drawn(&scene, size, effects, SAMPLES);
    let found: f64 = found.iter().map(|pixel| pixel.mean.x).sum();
    let off = found / by_chance - 1.0;
    println!("{off} off");
    assert!(off.abs() < 0.005, "{off}");
}
