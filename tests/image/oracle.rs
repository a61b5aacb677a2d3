use crate::built::TIMES;
use crate::cpu;
use crate::drawn::{Drawn, RULES, Record, bare, draw_by_all, example, of_the_show};
use crate::error::{Difference, worst_channel};
use crate::threaded_renderer::ThreadedRenderer;
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_scenes::{Kinds, Random, cases, crowd, known};
use eightfold_tracer::scene::{Camera, Light, List, Material, Scene, Sphere};
use eightfold_tracer::{Counts, MAX_HEIGHT, MAX_WIDTH, Quality};
use glam::{DVec3, Vec3, vec3};

/// Allows 0.02 % of the pixels, or four.
#[track_caller]
fn assert_as_traced(drawn: &Drawn, frame: &Frame, what: &str) {
    assert_few_wrong(drawn, frame, (drawn.pixels.len() / 5000).max(4), what);
}

/// Asserts that at most `max` pixels differ by more than 8/255, all on silhouettes, and the others
/// by at most 0.01/255 on average (0.05/255 on film).
#[track_caller]
fn assert_few_wrong(drawn: &Drawn, frame: &Frame, max: usize, what: &str) {
    let mut expected = frame.picture_like(&drawn.pixels);
    let silhouettes = frame.silhouettes();
    let mut wrong = 0;
    for (i, (a, &b)) in expected.iter_mut().zip(&drawn.pixels).enumerate() {
        let (x, y, off) = (i % frame.width, i / frame.width, worst_channel(*a, b));
        if off > 8 {
            assert!(silhouettes[i], "{what}: ({x}, {y}) is off by {off}: {b:06x} for {a:06x}");
            (wrong, *a) = (wrong + 1, b);
        }
    }
    assert!(wrong <= max, "{what}: {wrong} wrong pixels");
    // The gamma of film enlarges the rounding errors of dark colours.
    let max = if frame.film.filmic { 0.05 } else { 0.01 };
    let mean = Difference::between(&expected, &drawn.pixels).mean;
    assert!(mean <= max, "{what}: {mean}");
}

#[track_caller]
fn assert_traced(scene: &Scene, [width, height]: [usize; 2], what: &str) {
    let frame = Frame::new(scene, &Quality::EXHAUSTIVE, width, height);
    for (isa, drawn) in draw_by_all(scene, &Quality::EXHAUSTIVE, width, height) {
        assert_as_traced(&drawn, &frame, &format!("{what} by {}", isa.name));
    }
}

/// Asserts that squares of 8 pixels are filled by the rules, except for one in 200, or 2, where
/// rounding decides.
#[track_caller]
fn assert_refined(scene: &Scene, quality: &Quality, [width, height]: [usize; 2], what: &str) {
    let frame = Frame::new(scene, quality, width, height);
    let rows = (0..height).step_by(8);
    let squares = rows.flat_map(|y| (0..width).step_by(8).map(move |x| [x, y, 8]));
    let squares: Vec<[usize; 3]> = squares.collect();
    for isa in cpu::instruction_sets() {
        let (mut pixels, record) = (vec![0; width * height], Record::default());
        let mut renderer = ThreadedRenderer::new(1);
        renderer.draw_observed(isa.level, scene, quality, width, &mut pixels, &record);
        let split = record.split.into_inner().unwrap();
        let wrong = squares.iter().filter(|&&[x, y, side]| {
            let places = [(0, 0), (side, 0), (0, side), (side, side)];
            let corners = places.map(|(u, v)| frame.at(x + u, y + v));
            let colours = corners.map(|it| 255.0 * it.colour.clamp(DVec3::ZERO, DVec3::ONE));
            let [max, min] = [DVec3::max, DVec3::min].map(|of| colours.into_iter().reduce(of));
            let spread = (max.unwrap() - min.unwrap()).max_element();
            let tolerance = match corners.iter().all(|corner| corner.key == corners[0].key) {
                true => quality.tolerance_agreeing,
                false => quality.tolerance_differing,
            };
            let excess = spread - f64::from(tolerance);
            let is_flat = colours.iter().all(|colour| colour.round() == colours[0].round());
            let is_filled = !split.contains(&[x, y, side]);
            // A tie of rounding, or not.
            excess.abs() > 0.1 && is_filled != (is_flat || excess < 0.0)
        });
        let wrong: Vec<_> = wrong.collect();
        let max = (squares.len() / 200).max(2);
        assert!(wrong.len() <= max, "{what} by {} and {quality:?}: {wrong:?}", isa.name);
    }
}

#[test]
fn fields_and_crowds_match_the_oracle() {
    for (count, time) in [(4, 0.0), (64, 3.0), (320, 1.0)] {
        let what = format!("a field of {count} at {time} s");
        assert_traced(&show::field(count, time), [120, 90], &what);
    }
    for (seed, counts) in (0..).zip([[320, 64], [130, 0], [0, 64]]) {
        let scene = crowd(&mut Random::new(seed), counts, [0.0, 0.3]);
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 120, 90);
        // Curved mirrors enlarge rounding errors: at seed 0, of 9 pixels of 8,341 on silhouettes.
        let max = counts.iter().sum::<usize>() / 32;
        for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 120, 90) {
            let what = format!("a crowd of {counts:?} by {}", isa.name);
            assert_few_wrong(&drawn, &frame, max, &what);
        }
    }
}

#[test]
fn films_names_and_narrow_lights_match_the_oracle() {
    assert_traced(&example("bubbles"), [192, 108], "bubbles");
    assert_traced(&of_the_show(9.0), [90, 160], "the name");
    for far in [1e2, 1e3, 1e4] {
        let mut scene = show::model_scene(0.0);
        let position = vec3(0.3, 1.0, 0.2) * far;
        scene.lights = List::of(&[Light::spotlight(position, -position, 3.0 / far, Vec3::ONE)]);
        assert_traced(&scene, [160, 120], &format!("a spotlight at {far}"));
    }
}

#[test]
fn show_matches_the_oracle() {
    for time in TIMES.into_iter().step_by(2) {
        let scene = of_the_show(time as f32 / 1000.0);
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 240, 135);
        let silhouettes = frame.silhouettes();
        // Otherwise the tolerance for silhouettes would hide errors.
        let on = silhouettes.iter().filter(|&&on| on).count();
        assert!(on < 240 * 135 / 4, "{time} ms: {on} pixels");
        let drawn = draw_by_all(&scene, &Quality::EXHAUSTIVE, 240, 135);
        for (isa, drawn_by) in &drawn {
            let what = format!("{time} ms by {}", isa.name);
            assert_as_traced(drawn_by, &frame, &what);
            for (i, &on) in silhouettes.iter().enumerate() {
                let off = worst_channel(drawn[0].1.pixels[i], drawn_by.pixels[i]);
                assert!(off <= 1 || on, "{what}: pixel {i} differs by {off}");
            }
        }
    }
}

fn shells(count: usize) -> Scene {
    let plastic = Material { ks: 0.5, exponent: 50.0, ..Material::matt(Vec3::splat(0.9), 0.2) };
    let glass = Material { kr: 0.5, kt: 0.5, index: 1.01, ..plastic };
    let shell = |i| Sphere::new(Vec3::ZERO, 2.0 + 0.5 * i as f32, glass);
    Scene {
        camera: Camera::new(vec3(0.1, 0.2, 0.3), Vec3::X, 1.0),
        background: Vec3::splat(0.4),
        ambient: Vec3::splat(0.3),
        spheres: (0..count).map(shell).collect(),
        ..Scene::default()
    }
}

/// Rays end at a black light, so that packets of secondary rays are partly empty.
#[test]
fn no_ray_is_lost_at_any_depth() {
    let whole = shells(Quality::MAX_DEPTH as usize + 1);
    let black = Light { drawn_radius: 0.15, ..Light::new(vec3(0.6, 0.2, 0.3), Vec3::ZERO) };
    let broken = Scene { lights: List::of(&[black]), ..whole.clone() };
    let model = show::model_scene(0.0);
    for depth in 0..=Quality::MAX_DEPTH {
        let quality = Quality { depth, least_contribution: 0.0, ..Quality::EXHAUSTIVE };
        for (scene, is_whole) in [(&whole, true), (&broken, false), (&model, false)] {
            let frame = Frame::new(scene, &quality, 36, 24);
            let expected = frame.total(|point| point.rays);
            // The library skips shadow rays that have no occluder.
            let max = frame.total(|point| point.shadow_rays);
            for (isa, drawn) in draw_by_all(scene, &quality, 36, 24) {
                let what = format!("depth {depth} by {}", isa.name);
                let Counts { points, rays, shadow_rays, .. } = drawn.counts;
                assert!(points == 36 * 24 && shadow_rays <= max, "{what}: {shadow_rays}, {max}");
                let off = rays.abs_diff(expected);
                assert!(off <= expected / 5000, "{what}: {rays}, not {expected}");
                assert!(!is_whole || rays == points * ((2 << depth) - 1), "{what}");
                assert_as_traced(&drawn, &frame, &what);
            }
        }
    }
}

#[test]
fn spheres_around_lights_and_cameras_match() {
    let mut scene = shells(1);
    scene.planes = show::model_scene(0.0).planes.iter().copied().collect();
    for (position, eye) in [
        (vec3(0.5, 0.7, 0.1), vec3(0.1, 0.2, 0.3)),
        (vec3(0.5, 0.7, 0.1), vec3(1.0, 3.0, 7.0)),
        (vec3(3.5, 3.7, 0.1), vec3(0.1, 0.2, 0.3)),
    ] {
        scene.camera = Camera { eye, look_at: Vec3::ZERO, ..scene.camera };
        let light = Light { drawn_radius: 0.1, ..Light::new(position, Vec3::ONE) };
        scene.lights = List::of(&[light]);
        let what = format!("a light at {position} seen from {eye}");
        assert_traced(&scene, [120, 90], &what);
    }
    let mut scene = show::model_scene(0.0);
    let Sphere { centre, radius, .. } = scene.spheres[1];
    for material in [3, 0].map(|i| scene.spheres[i].material) {
        scene.spheres[1].material = material;
        for (distances, ahead) in
            [(&[0.0, 0.5, 0.999, 1.0, 1.5][..], Vec3::Z), (&[1.0, 1.001], Vec3::X)]
        {
            for distance in distances {
                let eye = centre + Vec3::NEG_Z * (radius * distance);
                scene.camera = Camera::new(eye, eye + ahead, 1.2);
                let what = format!("at {distance} radii towards {ahead}");
                assert_traced(&scene, [120, 90], &what);
            }
        }
    }
}

#[test]
fn random_scenes_match_the_oracle() {
    for mut random in cases(24) {
        let what = format!("case {}", random.seed);
        let scene = Kinds::SPHERES.scene(&mut random);
        assert_traced(&scene, [96, 72], &what);
        for quality in RULES.map(bare) {
            // The oracle has no rule for crowds.
            let quality = Quality { crowds: false, ..quality };
            assert_refined(&scene, &quality, [96, 72], &what);
        }
        let scene = Scene { black_beyond: random.seed % 2 == 1, ..Kinds::RICH.scene(&mut random) };
        assert_eq!(scene.validate(), Ok(()), "{what}");
        assert_traced(&scene, [96, 72], &what);
    }
}

/// Rounding decides every pixel of this scene.
#[test]
fn colour_half_way_between_steps_rounds_either_way() {
    let tie = &known("tie")[0].scene;
    assert_traced(tie, [96, 72], "a tie");
    for quality in RULES.map(bare) {
        assert_refined(tie, &quality, [96, 72], "a tie");
    }
}

#[test]
fn pictures_of_any_size_are_right() {
    let known = [[1, 1], [2, 1], [1, 2], [7, 3], [16, 16], [255, 33], [257, 31]];
    for size in known.into_iter().chain([[MAX_WIDTH, 20], [20, MAX_HEIGHT]]) {
        assert_traced(&show::model_scene(0.5), size, &format!("{size:?}"));
    }
    for mut random in cases(12) {
        let [width, height] = [0; 2].map(|_| 1 + random.below(200));
        let scene = show::model_scene(random.between(0.0, show::MODEL_LENGTH));
        assert_traced(&scene, [width, height], &format!("case {}, {width}x{height}", random.seed));
    }
}

#[test]
fn squares_are_filled_and_split_by_the_rules() {
    let scene = show::model_scene(1.0);
    for rules in RULES {
        assert_refined(&scene, &bare(rules), [136, 96], "the model scene");
    }
    for (key_depth, state_depth, tolerance_agreeing, tolerance_differing) in [
        (0, 0, f32::INFINITY, 0.0),
        (1, 1, f32::INFINITY, 5.0),
        (5, 5, f32::INFINITY, 0.0),
        (u32::MAX, 31, 30.0, 3.0),
        (5, 1, 2.0, 20.0),
        (0, 0, 4.0, 4.0),
    ] {
        let quality = Quality {
            key_depth,
            state_depth,
            tolerance_agreeing,
            tolerance_differing,
            highlight: 0.1,
            ..bare(Quality::THESIS)
        };
        assert_refined(&scene, &quality, [136, 96], "the model scene");
    }
}
