//! Highlights that five pixels show are shown, on spheres, planes, cylinders and capsules in the eye's own sight.
//!
//! A highlight counts as whole if the place that mirrors the lamp to the eye is seen, lit, in one of its pixels or next to one.
//! What is seen of any other is cut off from that: by a shadow, the object's own included, by something in front, by an edge, or by
//! what is white without it. It may be missed, as `limits` says.
//!
//! Of 3,000 scenes each, by `PROPTEST_CASES=3000`, no named quality misses a whole one of 8,758 on spheres and planes and of 6,320
//! on cylinders and capsules; the default quality without the guard misses 753 and 461. Of the parts, 1,517 and 4,179, each misses
//! 2 and 12 at most, all of them in the scenes of known seeds.

use crate::cpu;
use crate::drawn::{draw, jagged, named};
use crate::generator::near::power;
use crate::generator::seeded::Random;
use crate::generator::{config, fitting, materials};
use crate::missed::effects::patches;
use crate::refinement::bare;
use crate::wrong_pixels::wrong_pixels;
use eightfold_oracle::geometry::{self, PicturePlane};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Camera, Light, Material, Plane, Scene, Shape, Sphere};
use glam::{DMat2, DVec2, DVec3, EulerRot, Mat3, Vec3, dvec2, vec3};

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// Seeds of scenes of spheres, and of round blocks: all in which something was missed of 7,000 and 14,000. The first two of round
/// blocks have whole highlights, thinner than a pixel; the others have parts.
const KNOWN: [&[u64]; 2] = [
    &[4991, 5199],
    &[
        3975, 4835, 1327, 2120, 5180, 5606, 6671, 7315, 9571, 10104, 13907,
    ],
];

/// The step by which differences from pixel to pixel are taken, in pixels.
const NEAR: f64 = 1e-4;

/// A shiny material whose highlights are of any size.
fn shiny(random: &mut Random) -> Material {
    Material {
        colour: Vec3::splat(random.between(0.0, 0.6)),
        kd: random.between(0.0, 0.8),
        ks: random.between(0.1, 1.0),
        exponent: power(random, 0.3, 3.0),
        metallic: random.between(-1.0, 1.0).max(0.0),
        ..Material::BLACK
    }
}

/// Shiny spheres, or cylinders and capsules, large and tiny, thin, standing on a floor or in the air, a camera and lamps low above it or high, near
/// or far away.
fn scene(random: &mut Random, are_round_blocks: bool) -> Scene {
    let mut scene = Scene {
        ambient: Vec3::splat(0.3),
        background: Vec3::splat(random.between(0.0, 0.3)),
        camera: Camera {
            eye: vec3(
                random.between(-6.0, 6.0),
                power(random, -1.5, 1.0),
                random.between(5.0, 12.0),
            ),
            look_at: random.vector(vec3(-2.0, -0.6, -2.0), vec3(2.0, 0.6, 2.0)),
            up: Vec3::Y,
            field_of_view: random.between(0.4, 1.4),
        },
        ..Scene::default()
    };
    for _ in 0..1 + random.below(14) {
        let at = random.vector(vec3(-5.0, 0.0, -5.0), vec3(5.0, 4.0, 5.0));
        let material = shiny(random);
        if are_round_blocks {
            let (radius, height) = (power(random, -1.3, 0.3), power(random, -1.5, 0.7));
            let shape = [Shape::Cylinder, Shape::Capsule][random.below(2)];
            let turns = [0; 3].map(|_| random.between(0.0, 6.0));
            let axes = Mat3::from_euler(EulerRot::XYZ, turns[0], turns[1], turns[2]);
            scene.blocks.push(Block {
                centre: at + Vec3::Y,
                half: fitting(shape, vec3(radius, height, radius)),
                axes: [axes, axes, Mat3::IDENTITY][random.below(3)],
                shape,
                material,
            });
        } else {
            let radius = power(random, -1.3, 0.5);
            let above = [0.0, at.y][random.below(2)];
            scene.spheres.push(Sphere {
                centre: vec3(at.x, above + radius, at.z),
                radius,
                material,
            });
        }
    }
    if random.below(2) == 0 {
        scene.planes.push(Plane {
            centre: Vec3::ZERO,
            half_x: power(random, 0.3, 2.0),
            half_z: power(random, 0.3, 2.0),
            material: shiny(random),
        });
    }
    for _ in 0..1 + random.below(3) {
        let wide = [8.0, 8.0, 40.0][random.below(3)];
        scene.lights.push(Light {
            position: vec3(
                random.between(-wide, wide),
                power(random, -1.5, 1.2),
                random.between(-wide, wide),
            ),
            colour: Vec3::splat(random.between(0.2, 1.5)),
            parallel: random.below(7) == 0,
            ..Light::DARK
        });
    }
    scene
}

/// The scene, with an object that has no highlights, for each object.
fn made_matt(scene: &Scene) -> Vec<Scene> {
    let matt = |i: usize| {
        let mut matt = scene.clone();
        materials(&mut matt)[i].ks = 0.0;
        matt
    };
    let count = materials(&mut scene.clone()).len();
    (0..count).map(matt).collect()
}

/// The shapes of a scene, in the order of [`materials`].
fn shapes(scene: &Scene) -> Vec<geometry::Shape> {
    let spheres = scene.spheres.iter().map(geometry::Shape::from);
    let planes = scene.planes.iter().map(geometry::Shape::from);
    let blocks = scene.blocks.iter().map(geometry::Shape::from);
    spheres.chain(planes).chain(blocks).collect()
}

/// Whether some pixels that show an object, or those next to them, show a place that mirrors a lamp to the eye.
fn hold_a_middle(scene: &Scene, shape: geometry::Shape, pixels: &[usize]) -> bool {
    let plane = PicturePlane::new(&scene.camera, WIDTH, HEIGHT);
    // How far the mirrored ray and the direction to the lamp are apart.
    let apart = |at: DVec2, lamp: DVec3| {
        let ray = plane.ray(at.x, at.y);
        let met = shape.meet(ray, f64::INFINITY)?;
        let mirrored = ray.d - 2.0 * ray.d.dot(met.normal) * met.normal;
        Some(mirrored - (lamp - ray.at(met.t)).normalize())
    };
    // Newton's step from a pixel to where they are the same.
    let step = |at: DVec2, lamp: DVec3| {
        let here = apart(at, lamp)?;
        let right = (apart(at + NEAR * DVec2::X, lamp)? - here) / NEAR;
        let down = (apart(at + NEAR * DVec2::Y, lamp)? - here) / NEAR;
        let across = right.dot(down);
        let square = DMat2::from_cols_array(&[right.dot(right), across, across, down.dot(down)]);
        Some(-square.inverse() * dvec2(right.dot(here), down.dot(here)))
    };
    scene.lights.iter().any(|light| {
        let far = if light.parallel { Light::FAR } else { 1.0 };
        let lamp = (light.position * far).as_dvec3();
        let is_near = |step: DVec2| step.abs().max_element() <= 1.0;
        let mut places = pixels
            .iter()
            .map(|i| dvec2((i % WIDTH) as f64, (i / WIDTH) as f64));
        places.any(|at| step(at, lamp).is_some_and(is_near))
    })
}

/// Numbers of whole highlights, and of parts of others.
#[derive(Clone, Debug, Default)]
struct Number {
    whole: usize,
    parts: usize,
}

impl Number {
    fn add(&mut self, is_whole: bool) {
        self.whole += usize::from(is_whole);
        self.parts += usize::from(!is_whole);
    }
}

#[test]
#[ignore = "many scenes by chance"]
fn every_highlight_that_five_pixels_show_is_shown_and_the_bare_rules_miss_some() {
    let isas: Vec<_> = cpu::instruction_sets().collect();
    let mut qualities: Vec<Quality> = named().map(jagged).collect();
    qualities.push(bare(Quality::DEFAULT));
    for (are_round_blocks, known) in [false, true].into_iter().zip(KNOWN) {
        let mut shown = Number::default();
        let mut misses = vec![Number::default(); qualities.len()];
        let seeds = 0..u64::from(config(100).cases);
        for seed in known.iter().copied().chain(seeds) {
            let isa = isas[seed as usize % isas.len()];
            let scene = scene(&mut Random(seed), are_round_blocks);
            let draw = |scene: &Scene, quality: Quality| {
                draw(isa, 2, scene, &quality, WIDTH, HEIGHT).pixels
            };
            let whole = draw(&scene, Quality::EXHAUSTIVE);
            let wrong: Vec<_> = qualities
                .iter()
                .map(|&quality| wrong_pixels(&whole, &draw(&scene, quality)))
                .collect();
            for (matt, shape) in made_matt(&scene).into_iter().zip(shapes(&scene)) {
                let changed = wrong_pixels(&whole, &draw(&matt, Quality::EXHAUSTIVE));
                let changed: Vec<usize> = (0..changed.len()).filter(|&i| changed[i]).collect();
                for patch in patches(&changed, WIDTH) {
                    if patch.len() < 5 {
                        continue;
                    }
                    let is_whole = hold_a_middle(&scene, shape, &patch);
                    shown.add(is_whole);
                    for (misses, wrong) in misses.iter_mut().zip(&wrong) {
                        if patch.iter().all(|&i| wrong[i]) {
                            misses.add(is_whole);
                        }
                    }
                }
            }
        }
        let bare = misses.pop().expect("the bare rules");
        println!("{shown:?}, {misses:?} missed, {bare:?} by the bare rules");
        // Of parts, those of known seeds, and no more than one in 400 of all.
        let parts = known.len() + shown.parts / 400;
        assert!(
            misses
                .iter()
                .all(|missed| missed.whole == 0 && missed.parts <= parts),
            "{misses:?} of {shown:?}, round blocks: {are_round_blocks}"
        );
        assert!(
            shown.whole > 200 && 30 * bare.whole > shown.whole,
            "{bare:?} of {shown:?}"
        );
    }
}
