//! Every shadow of a sphere on a plane is shown in a pixel at least, if it darkens one by two steps of 255, and few of the shadows' pixels
//! are lit.
//!
//! Measured: of the pixels of small spheres' shadows 0.21 % are lit by the finest quality, 0.33 % by the default quality and 0.13
//! % by the rules of 2008; the largest patches have 16, 16 and 9 pixels. Without the guard 4 to 10 % are lit, in patches of 78 to
//! 125 pixels.

use crate::cpu::{self, Isa};
use crate::drawn::{draw, draw_best, jagged, named};
use crate::error::worst_channel;
use crate::generator::alone::{shadow, shadow_beside_a_dark_corner, thin_shadows};
use crate::generator::fitting;
use crate::generator::near::{Near, seeds};
use crate::generator::seeded::{Random, floor};
use crate::refinement::bare;
use crate::wrong_pixels::largest_patch;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Light, List, Material, Scene, Shape, Sphere, Spot};
use glam::{EulerRot, Mat3, Vec3, vec3};
use std::collections::BTreeSet;
use std::mem;

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// The number of random scenes.
const SCENES: u64 = 60;

/// Red spheres above a grey floor with one light. Most of their shadows are a few pixels wide.
fn scene(random: &mut Random) -> Scene {
    let sphere = |random: &mut Random| {
        Sphere::new(
            random.vector(vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0)),
            10.0_f32.powf(random.between(-2.0, -0.3)),
            Material {
                colour: Vec3::X,
                ..Material::BLACK
            },
        )
    };
    let spheres: Vec<Sphere> = (0..32).map(|_| sphere(random)).collect();
    let grey = Material::matt(Vec3::splat(0.8), 0.9);
    let mut scene = floor(random, Vec3::ZERO, grey);
    scene.ambient = Vec3::splat(0.2);
    scene.spheres = spheres.iter().copied().collect();
    scene.lights.push(Light::new(
        random.vector(vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0)),
        Vec3::ONE,
    ));
    scene
}

/// The pixel of the floor in shadow: 0.2 of 0.8.
const SHADED: u32 = 0x29_2929;

/// Whether a pixel is brighter by more than 8/255.
fn is_brighter(pixel: u32) -> bool {
    pixel & 0xff > (SHADED & 0xff) + 8
}

#[test]
fn few_pixels_of_shadows_are_missed_and_their_patches_are_small() {
    // The largest share of the shadows' pixels, and the largest patch in pixels.
    let limits = [
        (Quality::LADDER[0], 0.0035, 20),
        (Quality::DEFAULT, 0.004, 20),
        (Quality::THESIS, 0.002, 12),
    ];
    for (quality, most, largest) in limits {
        let mut random = Random(2008);
        let (mut shaded, mut missed, mut patch) = (0, 0, 0);
        for _ in 0..SCENES {
            let scene = scene(&mut random);
            let draw = |quality| draw_best(&scene, &jagged(quality), WIDTH, HEIGHT).pixels;
            let exhaustive = draw(Quality::EXHAUSTIVE);
            let drawn = draw(quality);
            let pairs = exhaustive.iter().zip(&drawn);
            let lit: Vec<bool> = pairs
                .map(|(&a, &b)| a == SHADED && is_brighter(b))
                .collect();
            shaded += exhaustive.iter().filter(|&&a| a == SHADED).count();
            missed += lit.iter().filter(|&&lit| lit).count();
            patch = patch.max(largest_patch(lit, WIDTH));
        }
        let share = missed as f64 / shaded as f64;
        println!("{share:.4} of {shaded} pixels, a patch of {patch} by {quality:?}");
        assert!(share <= most, "{share} of {shaded} by {quality:?}");
        assert!(patch <= largest, "a patch of {patch} by {quality:?}");
    }
}

/// The scene, with blocks of all shapes, turned in any way, in place of the spheres: as long as each is wide, and much thinner.
fn with_blocks(mut scene: Scene, random: &mut Random) -> Scene {
    for sphere in mem::take(&mut scene.spheres).iter() {
        let shape = [Shape::Box, Shape::Cylinder, Shape::Capsule][random.below(3)];
        let turns = [0; 3].map(|_| random.between(0.0, 6.0));
        let thin = random.vector(Vec3::splat(0.03), Vec3::splat(0.3));
        scene.blocks.push(Block {
            centre: sphere.centre,
            half: fitting(shape, vec3(thin.x, 1.0, thin.z) * sphere.radius * 2.0),
            axes: Mat3::from_euler(EulerRot::XYZ, turns[0], turns[1], turns[2]),
            shape,
            material: sphere.material,
        });
    }
    scene
}

/// The scene, by the light of other lamps than a point that shines in all directions: the sun, a spotlight, and a small ball.
fn by_other_lamps(scene: &Scene) -> [Scene; 3] {
    let lamp = scene.lights[0];
    let sun = Light {
        parallel: true,
        ..lamp
    };
    let spot = Light {
        spot: Some(Spot {
            aim: -Vec3::Y,
            outer_angle: 1.47,
            inner_angle: 1.369,
        }),
        ..lamp
    };
    let ball = Light {
        diameter: 0.1,
        ..lamp
    };
    [sun, spot, ball].map(|lamp| Scene {
        lights: List::of(&[lamp]),
        ..scene.clone()
    })
}

/// Blocks that are thin, and lamps whose shadows are not quite where they are looked for. Measured: of the pixels of blocks' shadows 2.1 %
/// are lit by the default quality, by the sun 0.4 %; of spheres' 0.3 % by the sun and by a spotlight, 0.2 % by a ball. Without the guard 5
/// to 30 % are.
#[test]
fn few_pixels_of_shadows_of_blocks_and_by_other_lamps_are_missed() {
    let limits = [0.025, 0.006, 0.006, 0.004, 0.003];
    let [mut shaded, mut missed, mut bare_missed] = [[0; 5]; 3];
    for seed in 0..SCENES {
        let random = &mut Random(seed);
        let spheres = scene(random);
        let [sun, spot, ball] = by_other_lamps(&spheres);
        let blocks = with_blocks(spheres, random);
        let [blocks_by_sun, ..] = by_other_lamps(&blocks);
        let scenes = [blocks, blocks_by_sun, sun, spot, ball];
        for (kind, scene) in scenes.iter().enumerate() {
            let draw = |quality| draw_best(scene, &jagged(quality), WIDTH, HEIGHT).pixels;
            let exhaustive = draw(Quality::EXHAUSTIVE);
            let lit = |quality| {
                let drawn = draw(quality);
                let is_lit = |&i: &usize| exhaustive[i] == SHADED && is_brighter(drawn[i]);
                (0..drawn.len()).filter(is_lit).count()
            };
            shaded[kind] += exhaustive.iter().filter(|&&a| a == SHADED).count();
            missed[kind] += lit(Quality::DEFAULT);
            bare_missed[kind] += lit(bare(Quality::DEFAULT));
        }
    }
    for (kind, most) in limits.into_iter().enumerate() {
        let share = |missed: usize| missed as f64 / shaded[kind] as f64;
        let (share, bare_share) = (share(missed[kind]), share(bare_missed[kind]));
        println!(
            "{share:.4} of {} pixels, {bare_share:.4} by the bare rules",
            shaded[kind]
        );
        assert!(share <= most, "{kind}: {share}");
        assert!(bare_share >= 5.0 * most, "{kind}: {bare_share}");
    }
}

/// Two spheres above a grey floor, between whose shadows there is a slit of light: most are a few pixels wide, and end where the
/// shadows meet.
fn slit(random: &mut Random) -> Scene {
    let grey = Material::matt(Vec3::splat(0.8), 0.9);
    let mut scene = floor(random, Vec3::ZERO, grey);
    let way = vec3(random.between(-1.0, 1.0), 0.0, random.between(-1.0, 1.0)).normalize_or(Vec3::X);
    let half_gap = random.between(-0.02, 0.05);
    let sphere = |side: f32| {
        Sphere::new(
            Vec3::Y * 1.5 + way * (side * (1.0 + half_gap)),
            1.0,
            Material::BLACK,
        )
    };
    scene.ambient = Vec3::splat(0.2);
    scene.spheres = List::of(&[sphere(-1.0), sphere(1.0)]);
    let lamp = random.vector(vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0));
    scene.lights.push(Light::new(lamp, Vec3::ONE));
    scene
}

#[test]
fn slits_of_light_between_shadows_are_shown_and_the_bare_rules_darken_some() {
    // Pixels of the lit floor that are dark.
    let (mut darkened, mut bare_darkens) = (0, 0);
    for seed in 0..SCENES {
        let scene = slit(&mut Random(seed));
        let draw = |quality| draw(cpu::best(), 2, &scene, &jagged(quality), WIDTH, HEIGHT).pixels;
        let exhaustive = draw(Quality::EXHAUSTIVE);
        let dark = |quality| {
            let pairs = exhaustive.iter().zip(draw(quality));
            let is_dark = |(&lit, drawn)| drawn == SHADED && worst_channel(lit, SHADED) > 8;
            pairs.filter(|&(lit, drawn)| is_dark((lit, drawn))).count()
        };
        darkened += dark(Quality::DEFAULT);
        bare_darkens += dark(bare(Quality::DEFAULT));
    }
    println!("{darkened} pixels, {bare_darkens} by the bare rules");
    assert!(darkened <= 5, "{darkened}");
    assert!(bare_darkens > 100, "{bare_darkens}");
}

/// The indices of the spheres that shade the point of the floor that a pixel shows.
fn casters(scene: &Scene, pixel: usize) -> Vec<usize> {
    let raster = scene.camera.raster(WIDTH, HEIGHT);
    let (eye, lamp) = (
        scene.camera.eye.as_dvec3(),
        scene.lights[0].position.as_dvec3(),
    );
    let (x, y) = (pixel % WIDTH, pixel / WIDTH);
    let d = raster.corner.as_dvec3()
        + x as f64 * raster.dx.as_dvec3()
        + y as f64 * raster.dy.as_dvec3();
    let way = (eye - d * (eye.y / d.y) - lamp).normalize();
    let shades = |sphere: &Sphere| {
        let to = sphere.centre.as_dvec3() - lamp;
        let off = to - way * to.dot(way);
        off.length() < f64::from(sphere.radius)
    };
    let numbers = scene.spheres.iter().enumerate();
    numbers.filter(|(_, s)| shades(s)).map(|(i, _)| i).collect()
}

/// The spheres whose shadows are shown by some pixels, given those that are in shadow.
fn visible_shadows(scene: &Scene, shaded: impl Iterator<Item = usize>) -> BTreeSet<usize> {
    shaded.flat_map(|pixel| casters(scene, pixel)).collect()
}

#[test]
fn every_shadow_that_a_pixel_can_show_is_shown_and_the_bare_rules_miss_some() {
    let mut shadows = 0;
    let mut bare_misses = 0;
    for seed in 0..SCENES {
        let scene = scene(&mut Random(seed));
        let draw = |quality| draw_best(&scene, &jagged(quality), WIDTH, HEIGHT).pixels;
        let exhaustive = draw(Quality::EXHAUSTIVE);
        let is_shaded = |pixels: &[u32], i: usize| pixels[i] == SHADED && exhaustive[i] == SHADED;
        let of = |pixels: Vec<u32>| {
            visible_shadows(&scene, (0..pixels.len()).filter(|&i| is_shaded(&pixels, i)))
        };
        let all = of(exhaustive.clone());
        shadows += all.len();
        for quality in named() {
            let missed: Vec<_> = all.difference(&of(draw(quality))).copied().collect();
            assert!(missed.is_empty(), "{missed:?} of {seed} by {quality:?}");
        }
        bare_misses += all.difference(&of(draw(bare(Quality::DEFAULT)))).count();
    }
    println!("{shadows} shadows, {bare_misses} of them missed by the bare rules");
    assert!(
        shadows > 1000 && bare_misses > 100,
        "{shadows}, {bare_misses}"
    );
}

/// The pixel of the random scenes' floors in shadow: 0.1 of 0.7.
const DARK: u32 = 0x12_1212;

/// A shadow counts if it darkens a pixel by so many steps of 255: one may be rounding.
const STEPS: u32 = 2;

/// Whether some qualities show at a pixel at least the only shadow in a scene's picture; `None` if it darkens no pixel by [`STEPS`].
fn is_shown(isa: Isa, near: &Near, qualities: impl IntoIterator<Item = Quality>) -> Option<bool> {
    let draw = |scene, quality| draw(isa, 2, scene, &quality, near.width, near.height).pixels;
    let floor = near.without_spheres();
    let lit = draw(&floor, Quality::EXHAUSTIVE);
    let exhaustive = draw(&near.scene, Quality::EXHAUSTIVE);
    let shaded: Vec<usize> = (0..lit.len())
        .filter(|&i| exhaustive[i] == DARK && lit[i] != DARK)
        .collect();
    let counts = |&i: &usize| worst_channel(lit[i], DARK) >= STEPS;
    let is_shown = |quality| {
        let drawn = draw(&near.scene, jagged(quality));
        shaded.iter().any(|&i| drawn[i] == DARK)
    };
    shaded
        .iter()
        .any(counts)
        .then(|| qualities.into_iter().all(is_shown))
}

#[test]
#[ignore = "many scenes by chance"]
fn every_shadow_is_shown_however_thin_and_however_near_its_sphere_is_to_the_plane_or_the_lamp() {
    let mut shadows = 0;
    // The first one darkens a single pixel, by a step. The second one's place was once rounded otherwise beside a box.
    let known = [7890, 444].map(|seed| shadow(&mut Random(7919 * seed + 13)));
    let scenes = known.into_iter().chain(thin_shadows());
    for near in scenes.chain(seeds(400).map(|mut random| shadow(&mut random))) {
        for near in [
            near.clone(),
            near.clone().glaring(),
            near.glaring().with_box(),
        ] {
            for isa in cpu::instruction_sets() {
                if let Some(is_shown) = is_shown(isa, &near, named()) {
                    assert!(is_shown, "{} {:?}", isa.name, near.scene);
                    shadows += 1;
                }
            }
        }
    }
    println!("{shadows} shadows");
    assert!(shadows > 1000, "{shadows}");
}

#[test]
fn a_shadow_may_be_shown_where_it_makes_no_difference() {
    let near = shadow_beside_a_dark_corner();
    for isa in cpu::instruction_sets() {
        assert_eq!(is_shown(isa, &near.clone().glaring(), named()), Some(true));
        assert_eq!(is_shown(isa, &near, [Quality::DEFAULT]), Some(false));
    }
}
