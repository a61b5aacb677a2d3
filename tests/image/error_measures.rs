//! The measures of a picture's error: differences, FLIP and missed objects.

use crate::cpu;
use crate::error::Difference;
use crate::flip::Flip;
use crate::missed::Visible;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{List, Scene};

const WIDTH: usize = 20;
const HEIGHT: usize = 20;
const DARK: [u32; WIDTH * HEIGHT] = [0; WIDTH * HEIGHT];

/// A black picture with one bright block of 8x8 pixels, clipped to the picture.
fn block(column: usize, row: usize, light: u32) -> Vec<u32> {
    let mut pixels = DARK.to_vec();
    for y in (8 * row..8 * row + 8).take_while(|&y| y < HEIGHT) {
        for x in (8 * column..8 * column + 8).take_while(|&x| x < WIDTH) {
            pixels[y * WIDTH + x] = light;
        }
    }
    pixels
}

#[test]
fn a_difference_is_that_of_the_furthest_channel() {
    let difference = Difference::between(&DARK, &block(0, 0, 0x0002_0900));
    assert_eq!((difference.largest, difference.over_8), (9, 64));
    let squares = f64::from(64 * (2 * 2 + 9 * 9)) / (3 * DARK.len()) as f64;
    assert!((difference.psnr - 10.0 * (255.0 * 255.0 / squares).log10()).abs() < 1e-9);
}

#[test]
fn frames_together_have_the_psnr_of_their_squares_mean() {
    let lights = [0x0002_0900, 0x0000_0011, 0];
    let differences = lights.map(|light| Difference::between(&DARK, &block(0, 0, light)));
    let squares = f64::from(64 * (2 * 2 + 9 * 9 + 17 * 17)) / (3 * 3 * DARK.len()) as f64;
    let psnr = 10.0 * (255.0 * 255.0 / squares).log10();
    assert!((Difference::pooled_psnr(&differences) - psnr).abs() < 1e-9);
    // The last one equals its reference, whose PSNR alone is infinite.
    assert!(differences[2].psnr.is_infinite());
    assert!(Difference::pooled_psnr(&differences[2..]).is_infinite());
}

#[test]
fn flip_is_0_for_the_same_picture_and_near_1_for_its_opposite() {
    let light = [0x00ff_ffff; WIDTH * HEIGHT];
    let same = Flip::between(WIDTH, &light, &light);
    assert_eq!(same.mean(), 0.0);
    let opposite = Flip::between(WIDTH, &light, &DARK);
    assert!(opposite.mean() > 0.9 && opposite.mean() <= 1.0);
}

fn exhaustive(scene: &Scene) -> Vec<u32> {
    let mut pixels = vec![0; 160 * 120];
    ThreadedRenderer::new(1).draw(
        cpu::best().level,
        scene,
        &Quality::EXHAUSTIVE,
        160,
        &mut pixels,
    );
    pixels
}

#[test]
fn an_object_is_missed_where_it_is_not_shown() {
    let scene = show::field(40, 2.0);
    let picture = exhaustive(&scene);
    let visible = Visible::new(&scene, 160, 120);
    assert_eq!(visible.missed(&picture, &picture), 0);
    // A small change of brightness misses nothing.
    let brighter: Vec<u32> = picture.iter().map(|pixel| pixel | 0x0007_0707).collect();
    assert_eq!(visible.missed(&picture, &brighter), 0);
    let bare = Scene {
        spheres: List::default(),
        ..scene
    };
    let missed = visible.missed(&picture, &exhaustive(&bare));
    assert!((28..=40).contains(&missed), "{missed} of 40");
}
