//! Every mirror image in the first plane that 2x2 pixels show is shown in a pixel at least.
//!
//! Images of cylinders and capsules are the exception: their outlines are those of the boxes around them, and a corner of a square that
//! lies in such an outline beside the block counts as showing it. Measured: the named qualities miss 0 of 358 images of spheres and
//! boxes, and one of 320 of cylinders and capsules; squares of other sides miss another one. Both are of capsules. The bare rules miss 273.

use crate::cpu;
use crate::drawn::{draw, draw_best, jagged, named, with_any_squares};
use crate::generator::alone::{image, wide_image};
use crate::generator::near::seeds;
use crate::generator::seeded::{Random, floor};
use crate::refinement::bare;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Material, Scene, Shape, Sphere};
use glam::{Mat3, Vec3, vec3};
use std::collections::BTreeSet;

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// The number of random scenes.
const SCENES: u64 = 40;

/// How many objects a scene has: a sphere, a box, a cylinder, a capsule, and so on.
const OBJECTS: usize = 30;

/// The share of an object's light that its image has.
const KR: f32 = 0.5;

/// A colour of its own for each object: channels are half of the steps of 255 at least, so that no image has an object's colour.
fn colour(number: usize) -> Vec3 {
    let channel = |digit: usize| (128 + 30 * digit) as f32 / 255.0;
    vec3(
        channel(number % 4),
        channel(number / 4 % 4),
        channel(number / 16),
    )
}

/// The shape of a block; `None` for spheres.
fn shape(number: usize) -> Option<Shape> {
    [
        None,
        Some(Shape::Box),
        Some(Shape::Cylinder),
        Some(Shape::Capsule),
    ][number % 4]
}

/// Small objects above a mirror that is black but for their images.
fn scene(random: &mut Random) -> Scene {
    let (mut spheres, mut blocks) = (Vec::new(), Vec::new());
    for number in 0..OBJECTS {
        let centre = random.vector(vec3(-5.0, 0.7, -5.0), vec3(5.0, 3.0, 5.0));
        let size = 10.0_f32.powf(random.between(-2.0, -0.5));
        let material = Material {
            colour: colour(number),
            ..Material::BLACK
        };
        let Some(shape) = shape(number) else {
            spheres.push(Sphere::new(centre, size, material));
            continue;
        };
        let angles = [0; 3].map(|_| random.between(0.0, 6.0));
        // A capsule is at least as high as its ends.
        let least = if shape == Shape::Capsule { 1.0 } else { 0.3 };
        blocks.push(Block {
            centre,
            half: vec3(size, size * random.between(least, 3.0), size),
            axes: Mat3::from_euler(glam::EulerRot::XYZ, angles[0], angles[1], angles[2]),
            shape,
            material,
        });
    }
    let mirror = Material::mirror(KR);
    Scene {
        ambient: Vec3::ONE,
        spheres: spheres.iter().copied().collect(),
        blocks: blocks.iter().copied().collect(),
        ..floor(random, -Vec3::Y, mirror)
    }
}

/// Whether an image with this colour is that of a cylinder or a capsule.
fn is_of_round_block(image: u32) -> bool {
    let digit = |shift: u32| ((image >> shift & 0xff) as usize - 64) / 15;
    let number = digit(16) + 4 * digit(8) + 16 * digit(0);
    matches!(shape(number), Some(Shape::Cylinder | Shape::Capsule))
}

/// Whether a pixel shows an image.
fn is_image(pixel: u32) -> bool {
    pixel != 0 && pixel.to_be_bytes().iter().all(|&channel| channel < 128)
}

/// The images that 2x2 pixels of a picture show, by their colours.
fn images(pixels: &[u32]) -> BTreeSet<u32> {
    let mut images = BTreeSet::new();
    for y in 1..HEIGHT {
        for x in 1..WIDTH {
            let i = y * WIDTH + x;
            let square = [i - WIDTH - 1, i - WIDTH, i - 1, i].map(|i| pixels[i]);
            if is_image(square[0]) && square.iter().all(|&pixel| pixel == square[0]) {
                images.insert(square[0]);
            }
        }
    }
    images
}

#[test]
fn every_image_in_a_plane_that_2x2_pixels_show_is_shown_and_the_bare_rules_miss_some() {
    let qualities: Vec<Quality> = with_any_squares().collect();
    let (mut shown, mut bare_misses) = ([0; 2], 0);
    // Of cylinders and capsules, by the scene's seed and the colour.
    let mut missed = BTreeSet::new();
    for seed in 0..SCENES {
        let scene = scene(&mut Random(seed));
        let draw = |quality| draw_best(&scene, &jagged(quality), WIDTH, HEIGHT).pixels;
        let exhaustive = draw(Quality::EXHAUSTIVE);
        let images = images(&exhaustive);
        for &image in &images {
            shown[usize::from(is_of_round_block(image))] += 1;
        }
        let not_in = |pixels: Vec<u32>| {
            let pairs = exhaustive.iter().zip(&pixels);
            let all: BTreeSet<u32> = pairs.filter(|(a, b)| a == b).map(|(&a, _)| a).collect();
            images.difference(&all).copied().collect::<Vec<_>>()
        };
        for &quality in &qualities {
            let (round, others): (Vec<_>, Vec<_>) = not_in(draw(quality))
                .into_iter()
                .partition(|&image| is_of_round_block(image));
            assert!(others.is_empty(), "{others:x?} of {seed} by {quality:?}");
            missed.extend(round.into_iter().map(|image| (seed, image)));
        }
        bare_misses += not_in(draw(bare(Quality::DEFAULT))).len();
    }
    let [others, round] = shown;
    println!("{others} images of spheres and boxes, {round} of cylinders and capsules");
    println!("missed: {missed:x?} by some quality, {bare_misses} by the bare rules");
    assert!(missed.len() <= 2, "{missed:x?}");
    assert!(others > 250 && round > 250 && bare_misses > 150);
}

/// The image's pixel in the random scenes, but for rounding: half of its object's colour.
fn is_imaged(pixel: u32) -> bool {
    (0x7f_664c..=0x80_664d).contains(&pixel)
}

#[test]
#[ignore = "many scenes by chance"]
fn the_image_of_a_single_thing_is_shown_wherever_it_is() {
    let mut images = 0;
    let scenes = [wide_image()].into_iter();
    for near in scenes.chain(seeds(400).map(|mut random| image(&mut random))) {
        for isa in cpu::instruction_sets() {
            let draw =
                |quality| draw(isa, 2, &near.scene, &quality, near.width, near.height).pixels;
            let exhaustive = draw(Quality::EXHAUSTIVE);
            if !exhaustive.iter().any(|&pixel| is_imaged(pixel)) {
                continue;
            }
            images += 1;
            for quality in named() {
                let drawn = draw(jagged(quality));
                let mut pairs = exhaustive.iter().zip(&drawn);
                let is_shown = pairs.any(|(&a, &b)| is_imaged(a) && is_imaged(b));
                assert!(is_shown, "{} {quality:?} {:?}", isa.name, near.scene);
            }
        }
    }
    assert!(images > 500, "{images}");
}
