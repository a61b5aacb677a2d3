//! The measures of a picture's error: differences, flicker, FLIP and missed objects.

use crate::cpu;
use crate::error::Difference;
use crate::flicker::Flicker;
use crate::flip::Flip;
use crate::missed::Visible;
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::scene::{List, Scene};
use eightfold::{Quality, show};

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

/// The number of flickering blocks in frames, compared with black ones.
fn jumps(frames: &[Vec<u32>]) -> usize {
    let mut flicker = Flicker::default();
    for frame in frames {
        flicker.next(WIDTH, &DARK, frame);
    }
    flicker.jumps
}

#[test]
fn a_difference_is_that_of_the_furthest_channel() {
    let difference = Difference::between(&DARK, &block(0, 0, 0x0002_0900));
    assert_eq!((difference.largest, difference.over_8), (9, 64));
    let squares = f64::from(64 * (2 * 2 + 9 * 9)) / (3 * DARK.len()) as f64;
    assert!((difference.psnr - 10.0 * (255.0 * 255.0 / squares).log10()).abs() < 1e-9);
}

#[test]
fn an_error_that_comes_and_goes_flickers() {
    let (on, off) = (block(1, 1, 0x0009_0000), DARK.to_vec());
    assert_eq!(
        jumps(&[off.clone(), on.clone(), off.clone(), on.clone()]),
        3
    );
    // If the error moves from a block to another, both flicker.
    assert_eq!(jumps(&[on, block(0, 1, 0x0009_0000)]), 2);
    // Clipped blocks at the picture's edges count, too.
    assert_eq!(jumps(&[off.clone(), block(2, 2, 0x0000_0009)]), 1);
    assert_eq!(jumps(&[off, block(1, 1, 0x0008_0808)]), 0);
}

#[test]
fn an_error_that_stays_does_not_flicker() {
    let on = block(1, 1, 0x00ff_ffff);
    assert_eq!(jumps(&[on.clone(), on.clone(), on]), 0);
}

#[test]
fn flicker_is_told_from_the_second_frame_on() {
    let mut flicker = Flicker::default();
    assert_eq!(flicker.per_frame(), None);
    flicker.next(WIDTH, &DARK, &DARK);
    assert_eq!(flicker.per_frame(), None);
    flicker.next(WIDTH, &DARK, &block(0, 0, 0x00ff_ffff));
    assert_eq!(flicker.per_frame(), Some(1.0));
}

#[test]
fn flip_is_0_for_the_same_picture_and_near_1_for_its_opposite() {
    let light = [0x00ff_ffff; WIDTH * HEIGHT];
    let same = Flip::between(WIDTH, &light, &light);
    assert_eq!((same.mean(), same.p99()), (0.0, 0.0));
    let opposite = Flip::between(WIDTH, &light, &DARK);
    assert!(opposite.mean() > 0.9 && opposite.p99() <= 1.0);
}

#[test]
fn a_percentile_of_flip_looks_past_one_pixel_in_a_hundred() {
    let mut errors = vec![0.25; 99];
    errors.push(1.0);
    assert_eq!(
        Flip {
            errors: errors.clone()
        }
        .p99(),
        0.25
    );
    errors.push(1.0);
    assert_eq!(Flip { errors }.p99(), 1.0);
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
