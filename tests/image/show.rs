use crate::drawn::{draw_best, of_the_show as at, show_at};
use eightfold::show::{self, tempo};
use eightfold::sound::{Track, cue};
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::presentation::{Caption, Moment};
use eightfold_tracer::scene::{Block, Scene};
use eightfold_tracer::{Frame, Quality};

#[test]
fn show_is_valid_at_all_times() {
    let mut moment = show_at(show::LENGTH);
    for i in 0..=(show::LENGTH * 10.0) as usize {
        let time = i as f32 / 10.0;
        assert_eq!(show_at(time).validate(), Ok(()), "{time} s");
        show::at(time, &mut moment);
        assert!(moment == show_at(time), "{time} s: depends on the scene before");
    }
}

/// Both sides of a cut show a disc at the same place, so that coarse squares turn one into the
/// other.
#[test]
fn disc_stands_at_its_place_at_every_cut() {
    const HEIGHT: usize = 90;
    let ring = |time: f32, from: f32, to: f32| {
        let mut scene = show_at(time);
        show::without_transition(time, &mut scene);
        scene.presentation.captions.clear();
        let drawn = draw_best(&scene, &Quality::DEFAULT, 160, HEIGHT);
        let (mut sum, mut count) = ([0.0_f32; 3], 0.0);
        for (i, pixel) in drawn.pixels.iter().enumerate() {
            let (x, y) = (i % 160, i / 160);
            let out = f32::hypot(x as f32 - 79.5, y as f32 - 40.9) / HEIGHT as f32;
            if (from..to).contains(&out) {
                let [_, channels @ ..] = pixel.to_be_bytes();
                sum = core::array::from_fn(|i| sum[i] + f32::from(channels[i]));
                count += 1.0;
            }
        }
        sum.map(|channel| channel / count)
    };
    for cut in &show::CUTS[1..] {
        let cut = *cut as f32 * tempo::BAR;
        for time in [cut - 1.0 / 60.0, cut] {
            let (inside, outside) = (ring(time, 0.0, 0.13), ring(time, 0.22, 0.3));
            let difference = (0..3).map(|i| (inside[i] - outside[i]).abs()).fold(0.0, f32::max);
            assert!(difference > 30.0, "{time} s: {inside:?}, {outside:?}");
        }
    }
}

#[test]
fn balls_land_on_their_notes() {
    for (name, track) in [("still-life", Track::Kick), ("chimes", Track::Chime)] {
        let first = show::cut(name);
        let mut beat = 0.0;
        while beat < 23.0 {
            let scene = at(first as f32 * tempo::BAR + beat * tempo::BEAT);
            let ball = scene.spheres.last().expect("a ball");
            let ground = |block: &Block| {
                let flat = (ball.centre - block.centre).with_y(0.0).length();
                if flat < 0.01 { block.centre.y + block.half.y } else { 0.0 }
            };
            let ground = scene.blocks.iter().map(ground).fold(0.0, f32::max);
            let above = ball.centre.y - ball.radius - ground;
            assert!(above.abs() < 0.02, "{name}, beat {beat}: {above}");
            beat += cue(track, first, beat).until;
        }
    }
}

/// Mirrors, which meet at the lamp, leave no thin slice of a gem.
#[test]
fn resting_gems_leave_no_slivers_at_mirrors() {
    let first = show::cut("kaleidoscope");
    let beats = (0..24 * 16).map(|i| i as f32 / 16.0);
    for beat in beats.filter(|&beat| cue(Track::Kick, first, beat).since > 0.34) {
        let Moment { scene, presentation } =
            show_at(first as f32 * tempo::BAR + beat * tempo::BEAT);
        let raster = scene.camera.raster(16, 9);
        let [right, down] = [raster.dx, raster.dy].map(Vec3::normalize);
        let from_eye = |point: Vec3| point - scene.camera.eye;
        let depth = |point| from_eye(point).dot(right.cross(down));
        let place = |point| [right, down].map(|axis| from_eye(point).dot(axis) / depth(point));
        let [left, top] = place(scene.lights[0].position);
        for gem in scene.spheres.iter() {
            let [x, y] = place(gem.centre);
            let ([x, y], radius) = ([x - left, y - top], gem.radius / depth(gem.centre));
            let inside = match presentation.sectors {
                1.0 => [f32::INFINITY; 2],
                2.0 => [x; 2],
                4.0 => [x.min(y); 2],
                _ => [y.min((x - y) * 0.707), x.min((y - x) * 0.707)],
            };
            let is_sliced = |inside: &f32| (-1.0..-0.1).contains(&(inside / radius));
            assert!(!inside.iter().any(is_sliced), "beat {beat}: {inside:?} of {radius}");
        }
    }
}

/// The method begins where the still life ends.
#[test]
fn camera_jumps_on_bars_and_at_cuts() {
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
        assert!(jumps.contains(cut) || *cut == show::cut("method"), "bar {cut} of {jumps:?}");
    }
}

#[test]
fn names_fit_pictures_from_9_16_to_21_9() {
    for time in [9.0, 55.4] {
        let Scene { camera, blocks, .. } = at(time);
        // Not the city behind the letters.
        let blocks = blocks.iter().copied().filter(|block| block.centre.z > -50.0).collect();
        let scene = Scene { camera, blocks, background: Vec3::X, ..Scene::default() };
        for (width, height) in [(90, 160), (100, 100), (120, 90), (160, 100), (160, 90), (210, 90)]
        {
            let pixels = draw_best(&scene, &Quality::EXHAUSTIVE, width, height).pixels;
            let shown = (0..pixels.len()).filter(|&i| pixels[i] != 0xff_0000);
            let places: Vec<[usize; 2]> = shown.map(|i| [i % width, i / width]).collect();
            let is_inside = |[x, y]: [usize; 2]| x > 0 && x + 1 < width && y > 0 && y + 1 < height;
            let is_whole = places.len() > 100 && places.into_iter().all(is_inside);
            assert!(is_whole, "{time} s, {width}x{height}");
        }
    }
}

#[test]
fn captions_are_inside_the_picture_and_bright() {
    for (width, height) in [(640, 360), (3840, 2160), (360, 640)] {
        let mut last = 0;
        for beat in 0..show::BARS * tempo::BEATS_PER_BAR {
            let mut scene = Moment::default();
            let captions = &mut scene.presentation.captions;
            *captions = show_at((beat as f32 + 0.5) * tempo::BEAT).presentation.captions;
            captions.iter_mut().for_each(|it| it.brightness = it.brightness.ceil());
            let bright = captions.iter().filter(|it| it.brightness > 0.0);
            let letters: usize = bright.map(|caption| caption.letters.len()).sum();
            if letters == last {
                continue;
            }
            last = letters;
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
            let letters = letters.bytes().collect();
            let caption = Caption { letters, middle: 0.5, size: 0.05, brightness: 1.0 };
            let mut scene = Moment::from(show::model_scene(2.0));
            scene.presentation.captions.push(caption);
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

fn written(letters: &[u8], numbers: [usize; 4]) -> Vec<u32> {
    let letters = letters.iter().copied().collect();
    let caption = Caption { letters, middle: 0.1, size: 0.05, brightness: 1.0 };
    let mut pixels = vec![0; 640 * 360];
    let mut frame = Frame::new(640, 360, &mut pixels);
    frame.write(&[caption], numbers);
    pixels
}

#[test]
fn signs_stand_for_the_digits_of_four_numbers() {
    let plain = written(b" A  60 B 12345 C4.7/ .9", [0; 4]);
    let signs = b" A ### B $$$$$ C%.%/&.&";
    assert!(plain == written(signs, [60, 12_345, 1_047, 9]));
    assert!(plain.contains(&0xff_ff_ff));
    for other in [[61, 12_345, 47, 9], [60, 12_345, 47, 8]] {
        assert!(plain != written(signs, other));
    }
}
