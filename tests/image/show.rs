//! The show has valid scenes that change on the beat, and captions inside the picture.

use crate::drawn::{draw_best, of_the_show as at};
use eightfold::show::{self, grid};
use eightfold::sound::pulse;
use eightfold_oracle::Object;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Camera, Caption, List, Scene};
use std::collections::HashMap;

#[test]
fn show_is_valid_at_all_times() {
    let mut scene = at(show::LENGTH);
    for i in 0..=(show::LENGTH * 10.0) as usize {
        let time = i as f32 / 10.0;
        assert_eq!(at(time).validate(), Ok(()), "{time} s");
        show::at(time, &mut scene);
        assert!(scene == at(time), "{time} s: depends on the scene before");
    }
}

/// Sums the channels of a small picture.
fn brightness(time: f32, frames: f32) -> f64 {
    let drawn = draw_best(&at(time + frames / 60.0), &Quality::DEFAULT, 64, 36);
    let sums = drawn.pixels.iter().flat_map(|pixel| pixel.to_le_bytes());
    sums.map(f64::from).sum()
}

#[test]
fn first_frame_is_as_bright_as_the_title() {
    // The end of the title has no caption, but similar brightness.
    let title = brightness(10.0, 0.0);
    for frames in 0..60 {
        let share = brightness(0.0, frames as f32) / title;
        assert!(share > 0.6, "{frames}: {share}");
    }
}

#[test]
fn kick_is_a_flash_in_its_own_frame() {
    for bar in [show::cut("machine") + 1, show::cut("swarm") + 1] {
        let time = bar as f32 * grid::BAR;
        assert_eq!(pulse(time).kick, 1.0, "a kick, and no cut");
        let [calm, before, flash] = [-2.0, -1.0, 0.0].map(|frames| brightness(time, frames));
        assert!((before / calm - 1.0).abs() < 0.03, "{calm}, {before}");
        assert!(flash > before * 1.1, "{before}, {flash}");
    }
}

#[test]
fn copper_bars_flash_with_the_kicks_of_one_bar() {
    let first = (show::cut("swarm") + 4) as f32 * grid::BAR;
    assert_eq!(pulse(first).kick, 1.0);
    for sixteenth in 0..show::BARS * 16 {
        let time = sixteenth as f32 * grid::BEAT / 4.0;
        let is_shown = (first..first + grid::BAR).contains(&time);
        let expected = if is_shown { pulse(time).kick } else { 0.0 };
        for bar in at(time).copper_bars.iter() {
            assert_eq!(bar.brightness, expected, "{time} s");
        }
        assert!(!is_shown || at(time).copper_bars.len() == 2);
    }
}

/// Removing an object changes a pixel at one time or more. Scenes with the same number of objects have the same objects.
#[test]
fn every_object_of_the_show_is_seen() {
    const MOMENTS: usize = 8;
    let mut unseen: HashMap<(&str, usize), Vec<Object>> = HashMap::new();
    for (number, name) in show::NAMES.into_iter().enumerate() {
        let start = show::CUTS[number];
        let end = show::CUTS.get(number + 1).unwrap_or(&show::BARS);
        for moment in 0..MOMENTS {
            let bars = (end - start) as f32 * (moment as f32 + 0.5) / MOMENTS as f32;
            let scene = at((start as f32 + bars) * grid::BAR);
            let draw = |scene: &Scene| draw_best(scene, &Quality::EXHAUSTIVE, 160, 90).pixels;
            let whole = draw(&scene);
            let spheres = (0..scene.spheres.len()).map(Object::Sphere);
            let blocks = (0..scene.blocks.len()).map(Object::Block);
            let all: Vec<Object> = spheres.chain(blocks).collect();
            let objects = unseen.entry((name, all.len())).or_insert(all);
            objects.retain(|&object| draw(&without(&scene, object)) == whole);
        }
    }
    unseen.retain(|_, objects| !objects.is_empty());
    assert!(unseen.is_empty(), "{unseen:?}");
}

fn without(scene: &Scene, object: Object) -> Scene {
    let mut scene = scene.clone();
    match object {
        Object::Sphere(i) => scene.spheres = all_but(&scene.spheres, i),
        Object::Block(i) => scene.blocks = all_but(&scene.blocks, i),
        _ => {}
    }
    scene
}

fn all_but<T: Copy + Default, const N: usize>(list: &[T], i: usize) -> List<T, N> {
    let others = list[..i].iter().chain(&list[i + 1..]);
    others.copied().collect()
}

#[test]
fn camera_jumps_on_bars_and_at_every_cut() {
    let mut jumps = Vec::new();
    let frames = (show::LENGTH * 60.0) as usize;
    for i in 1..frames {
        let eye = |i: usize| at(i as f32 / 60.0).camera.eye;
        if (eye(i) - eye(i - 1)).length() > 0.4 {
            assert_eq!(i % 120, 0, "frame {i}");
            jumps.push((i / 120) as u32);
        }
    }
    for cut in &show::CUTS[1..] {
        assert!(jumps.contains(cut), "bar {cut} of {jumps:?}");
    }
}

fn is_framed(camera: &Camera, width: usize, height: usize, centre: Vec3, radius: f32) -> bool {
    let aspect = width as f32 / height as f32;
    let forward = (camera.look_at - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let up = right.cross(forward);
    let half_height = 0.5 * height as f32 * camera.pixel(width, height);
    let sides = [right / aspect, -right / aspect, up, -up];
    sides.iter().all(|side| {
        let inwards = (forward * half_height - *side).normalize();
        (centre - camera.eye).dot(inwards) >= radius
    })
}

fn balls(scene: &Scene) -> Vec<(Vec3, f32)> {
    let spheres = scene.spheres.iter().map(|it| (it.centre, it.radius));
    let mut balls: Vec<_> = spheres.collect();
    for block in scene.blocks.iter() {
        for corner in 0..8 {
            let sign = |axis: u32| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 };
            let corner = block.half * vec3(sign(0), sign(1), sign(2));
            balls.push((block.centre + block.axes * corner, 0.0));
        }
    }
    balls
}

/// Returns balls around the subject of a scene.
fn subject(name: &str, scene: &Scene) -> Vec<(Vec3, f32)> {
    let mut balls = balls(scene);
    match name {
        "title" => {
            balls.retain(|(centre, radius)| centre.y + radius > 0.0);
            balls
        }
        // Crystal, scarlet and silver. The columns extend beyond the picture; the camera passes the golden sphere.
        "colonnade" => vec![balls[0], balls[2], balls[3]],
        // The middle ball and the light. The camera passes other balls; columns and arms extend beyond the picture.
        "mirrors" | "finale" => {
            let light = scene.lights[0];
            vec![balls[0], (light.position, light.drawn_radius)]
        }
        _ => balls,
    }
}

#[test]
fn subjects_fit_pictures_from_4_3_to_21_9() {
    // In beats of the scene; the camera is close at other times.
    let whole = [
        ("title", 0.0..24.0),
        ("model", 0.0..16.0),
        ("model", 22.0..24.0),
        ("method", 0.0..32.0),
        ("colonnade", 20.0..32.0),
        ("machine", 7.0..12.0),
        ("machine", 19.0..24.0),
        ("flake", 4.0..16.0),
        ("flake", 22.0..24.0),
        ("mirrors", 0.0..24.0),
        ("swarm", 0.0..24.0),
        ("finale", 0.0..24.0),
    ];
    for name in show::NAMES {
        assert!(whole.iter().any(|(whole, _)| *whole == name), "{name}");
    }
    for (name, beats) in whole {
        let start = show::cut(name) as f32 * grid::BAR;
        for frame in 0..((beats.end - beats.start) * grid::BEAT * 60.0) as usize {
            let time = start + beats.start * grid::BEAT + frame as f32 / 60.0;
            let scene = at(time);
            let portrait = [(405, 720), (500, 700), (1, 1), (1, 3)];
            let narrow = if name == "title" { 4 } else { 0 };
            let wide = [(4, 3), (16, 10), (16, 9), (21, 9)];
            for &(width, height) in wide.iter().chain(&portrait[..narrow]) {
                for (centre, radius) in subject(name, &scene) {
                    let is_framed = is_framed(&scene.camera, width, height, centre, radius);
                    assert!(is_framed, "{name}, {time} s, {width}x{height}: {centre}");
                }
            }
        }
    }
}

#[test]
fn captions_are_inside_the_picture_and_bright() {
    for (width, height) in [(640, 360), (3840, 2160), (360, 640)] {
        let mut seen = 0;
        for beat in 0..show::BARS * grid::BEATS_PER_BAR {
            let mut scene = Scene {
                captions: at((beat as f32 + 0.5) * grid::BEAT).captions,
                ..Scene::default()
            };
            let captions = scene.captions.iter_mut();
            captions.for_each(|caption| caption.brightness = caption.brightness.ceil());
            let shown = scene.captions.iter().filter(|it| it.brightness > 0.0);
            let letters: usize = shown.map(|caption| caption.letters.len()).sum();
            if letters == seen {
                continue;
            }
            seen = letters;
            let pixels = draw_best(&scene, &Quality::DEFAULT, width, height).pixels;
            // The strokes of a letter are about twice its height.
            let bright = pixels.iter().filter(|&&pixel| pixel & 0xff > 0xb0).count();
            assert!(width < height || bright >= letters * 3, "beat {beat}: {bright}");
            let margin = height.min(width) / 40;
            for (i, pixel) in pixels.iter().enumerate() {
                let is_within = |at: usize, side: usize| (margin..side - margin).contains(&at);
                let is_inside = is_within(i % width, width) && is_within(i / width, height);
                assert!(is_inside || *pixel == 0, "beat {beat}, {width}x{height}: {i}");
            }
        }
    }
}

#[test]
fn caption_shows_points_and_pixels_of_its_frame() {
    for (width, height) in [(331, 217), (1280, 720)] {
        let with = |letters: &str| {
            let caption = Caption {
                letters: letters.bytes().collect(),
                middle: 0.5,
                size: 0.05,
                brightness: 1.0,
            };
            let scene = Scene { captions: List::of(&[caption]), ..show::model_scene(2.0) };
            draw_best(&scene, &Quality::DEFAULT, width, height)
        };
        let counted = with("TRACED ####### OF $$$$$$$ PIXELS");
        let points = counted.counts.points;
        let written = |points| {
            let pixels = width * height;
            // Numbers have no leading zeros.
            with(&format!("TRACED {points:7} OF {pixels:7} PIXELS")).pixels
        };
        assert!(points > 1000 && counted.pixels == written(points), "{points}");
        assert!(counted.pixels != written(points + 1));
    }
}
