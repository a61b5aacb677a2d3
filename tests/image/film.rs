//! Film, glow and grazing reflection do what their documentation says. That pictures with them are the oracle's is held by
//! `any_rich_scene_is_as_the_oracle_sees_it`.

use crate::drawn::draw_best;
use eightfold::show;
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{Vec3, vec3};
use eightfold_tracer::scene::{Camera, Film, Light, List, Material, Plane, Scene};

/// The picture of a scene with every pixel traced, and its brightest channels.
fn channels(scene: &Scene, width: usize, height: usize) -> Vec<u32> {
    let drawn = draw_best(scene, &Quality::EXHAUSTIVE, width, height);
    let brightest = |pixel: &u32| {
        [16, 8, 0]
            .map(|shift| pixel >> shift & 0xff)
            .into_iter()
            .max()
    };
    drawn.pixels.iter().filter_map(brightest).collect()
}

/// Nothing but a background.
fn empty(background: f32, film: Film) -> Scene {
    Scene {
        background: Vec3::splat(background),
        film,
        ..Scene::default()
    }
}

#[test]
fn what_is_below_the_shoulder_stays_and_what_is_above_keeps_its_order() {
    let film = Film {
        shoulder: 0.5,
        ..Film::PLAIN
    };
    let value = |light: f32, film| channels(&empty(light, film), 1, 1)[0];
    for step in 0..=127 {
        assert_eq!(value(step as f32 / 255.0, film), step);
    }
    let above = [0.6, 0.8, 1.0, 1.3, 1.6, 1.9].map(|light| value(light, film));
    assert!(above.is_sorted_by(|a, b| a < b), "{above:?}");
    assert!(above.iter().all(|&value| value < 255), "{above:?}");
    // Twice the room above the shoulder fills half of it: 0.5 + 0.25.
    assert_eq!(value(1.0, film), 191);
    // One that lies at full brightness is none.
    assert_eq!(value(1.9, Film::PLAIN), 255);
}

#[test]
fn a_vignette_leaves_the_middle_and_darkens_all_sides_alike() {
    let film = Film {
        vignette: 0.5,
        ..Film::PLAIN
    };
    let (width, height) = (161, 91);
    let picture = channels(&empty(0.8, film), width, height);
    let at = |x: usize, y: usize| picture[y * width + x];
    assert_eq!(at(80, 45), 204);
    let corners = [at(0, 0), at(160, 0), at(0, 90), at(160, 90)];
    assert!(corners.iter().all(|&corner| corner == corners[0]));
    // The middle of the lower side is 90/91 of half the height away, and loses a third of its light.
    assert!(at(80, 90).abs_diff(137) <= 1, "{}", at(80, 90));
    let row: Vec<u32> = (80..width).map(|x| at(x, 45)).collect();
    assert!(row.is_sorted_by(|a, b| a >= b));
}

#[test]
fn a_films_tolerance_is_a_share_of_the_qualitys() {
    let mut scene = show::model_scene(1.0);
    let quality = Quality::DEFAULT;
    let seen = |scene: &Scene, quality: &Quality| draw_best(scene, quality, 160, 120);
    let whole = seen(&scene, &quality);
    let halved = Quality {
        tolerance_agreeing: 0.5 * quality.tolerance_agreeing,
        tolerance_differing: 0.5 * quality.tolerance_differing,
        tolerance_side: 0.5 * quality.tolerance_side,
        ..quality
    };
    let by_quality = seen(&scene, &halved);
    scene.film.tolerance = 0.5;
    let by_film = seen(&scene, &quality);
    assert_eq!(by_film.pixels, by_quality.pixels);
    assert!(by_film.counts.points > whole.counts.points);
}

#[test]
fn dither_keeps_means_between_two_steps_at_every_quality() {
    let film = Film {
        dither: 1.0,
        ..Film::PLAIN
    };
    let (width, height) = (70, 46);
    for quality in [Quality::EXHAUSTIVE, Quality::DEFAULT, Quality::THESIS] {
        for sixteenths in 0..=16 {
            let scene = empty((10.0 + sixteenths as f32 / 16.0) / 255.0, film);
            let drawn = draw_best(&scene, &quality, width, height);
            let at = |x: usize, y: usize| drawn.pixels[y * width + x] & 0xff;
            // Squares of 4x4 anywhere have as many pixels of the higher step as the colour has sixteenths above the lower one.
            for (left, top) in [(0, 0), (13, 7), (33, 30), (66, 42)] {
                let places = (0..16).map(|i| at(left + i % 4, top + i / 4));
                let sum: u32 = places.sum();
                assert!(sum.abs_diff(160 + sixteenths) <= 1, "{sum}, {sixteenths}");
            }
            assert!((0..width).all(|x| at(x, 0) == at(x % 4, 0)));
        }
    }
}

#[test]
fn without_dither_all_pixels_are_rounded_alike() {
    for (light, expected) in [(10.49, 10), (10.51, 11)] {
        let picture = channels(&empty(light / 255.0, Film::PLAIN), 9, 5);
        assert!(picture.iter().all(|&value| value == expected));
    }
}

#[test]
fn a_dither_out_of_its_range_leaves_white_as_it_is() {
    for dither in [1e20, f32::INFINITY] {
        let film = Film {
            dither,
            ..Film::PLAIN
        };
        let drawn = draw_best(&empty(1.0, film), &Quality::EXHAUSTIVE, 8, 8);
        assert!(drawn.pixels.contains(&0x00ff_ffff));
        assert!(
            drawn
                .pixels
                .iter()
                .all(|&pixel| pixel | 0x01_0101 == 0x00ff_ffff)
        );
    }
}

#[test]
fn a_glow_is_as_bright_as_its_light_and_half_as_bright_at_its_radius() {
    // Seen from 1,000 radii, so that rays beside each other are parallel; a pixel is a tenth of a radius.
    let size: usize = 101;
    let scene = Scene {
        camera: Camera {
            eye: vec3(0.0, 0.0, 1000.0),
            field_of_view: 2.0 * (0.5 * size as f32 * 1e-4).atan(),
            ..Camera::default()
        },
        lights: List::of(&[Light {
            colour: Vec3::splat(0.8),
            glow: 1.0,
            ..Light::DARK
        }]),
        ..Scene::default()
    };
    let picture = channels(&scene, size, size);
    let at = |pixels: usize| picture[50 * size + 50 + pixels];
    for (pixels, share) in [(0, 1.0), (10, 0.5), (20, 0.2), (30, 0.1)] {
        let expected = 204.0 * share;
        assert!((at(pixels) as f32 - expected).abs() <= 1.0, "{pixels}");
    }
    // A wall at the light leaves the half of the glow that is before it.
    let wall = |y: f32| {
        let mut scene = scene.clone();
        (scene.camera.eye, scene.camera.up) = (vec3(0.0, 1000.0, 0.0), Vec3::Z);
        scene.planes.push(Plane {
            centre: vec3(0.0, y, 0.0),
            half_x: 100.0,
            half_z: 100.0,
            material: Material::BLACK,
        });
        channels(&scene, size, size)[50 * size + 50]
    };
    assert!(wall(0.0).abs_diff(102) <= 1, "{}", wall(0.0));
    assert!(wall(20.0) <= 1, "{}", wall(20.0));
}

#[test]
fn a_floor_with_fresnel_mirrors_more_the_lower_one_looks_along_it() {
    let seen = |height: f32, fresnel: f32| {
        let scene = Scene {
            camera: Camera {
                eye: vec3(0.0, height, -1.0),
                ..Camera::default()
            },
            background: Vec3::ONE,
            planes: List::of(&[Plane {
                centre: Vec3::ZERO,
                half_x: 1e3,
                half_z: 1e3,
                material: Material {
                    kr: 0.1,
                    fresnel,
                    ..Material::BLACK
                },
            }]),
            ..Scene::default()
        };
        channels(&scene, 1, 1)[0]
    };
    for height in [10.0_f32, 1.0, 0.5, 0.2, 0.05] {
        assert_eq!(seen(height, 0.0), 26, "a tenth, from everywhere");
        let cosine = height / (height * height + 1.0).sqrt();
        let expected = 255.0 * (0.1 + 0.9 * (1.0 - cosine).powi(5));
        let found = seen(height, 1.0);
        assert!((found as f32 - expected).abs() <= 0.6, "{height}: {found}");
    }
}
