//! The highlights of metals and of brushed surfaces.

use crate::drawn::{draw_best, jagged};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Scene, Shape};
use glam::{Mat3, Vec3, vec3};

/// The sides of the pictures, in pixels.
const SIDE: usize = 101;
/// The angle of the lamp from the vertical.
const SLANT: f32 = 0.4;
const EXPONENT: f32 = 30.0;

/// The red, green and blue of a black disc of radius 1 that reflects a lamp along x, seen from far above; -x is to the left and
/// -z at the top. There are 50 pixels to a unit.
fn disc(material: Material) -> Vec<[f32; 3]> {
    const HEIGHT: f32 = 1000.0;
    let scene = Scene {
        camera: Camera {
            up: -Vec3::Z,
            ..Camera::new(Vec3::Y * HEIGHT, Vec3::ZERO, SIDE as f32 / 50.0 / HEIGHT)
        },
        blocks: List::of(&[Block {
            centre: Vec3::ZERO,
            half: vec3(1.0, 0.1, 1.0),
            axes: Mat3::IDENTITY,
            shape: Shape::Cylinder,
            material: Material {
                exponent: EXPONENT,
                ..material
            },
        }]),
        lights: List::of(&[Light {
            parallel: true,
            ..Light::new(vec3(SLANT.sin(), SLANT.cos(), 0.0), Vec3::ONE)
        }]),
        ..Scene::default()
    };
    let quality = jagged(Quality::EXHAUSTIVE);
    let drawn = draw_best(&scene, &quality, SIDE, SIDE);
    let channels = |pixel: &u32| [16, 8, 0].map(|shift| (pixel >> shift & 0xff) as f32 / 255.0);
    drawn.pixels.iter().map(channels).collect()
}

#[test]
fn a_brushed_disc_shines_along_the_line_towards_the_lamp() {
    for anisotropy in [0.0, 0.6, 1.0] {
        let seen = disc(Material {
            ks: 0.9,
            anisotropy,
            ..Material::BLACK
        });
        let mut brightest = 0.0_f32;
        for y in 0..SIDE {
            for x in 0..SIDE {
                let at = [x, y].map(|i| (i as f32 - 50.0) / 50.0);
                let distance = at[0].hypot(at[1]);
                if !(0.05..0.97).contains(&distance) {
                    continue;
                }
                // The lamp's direction differs from the mirrored one by so much, and along the grooves by so much.
                let apart2 = 2.0 - 2.0 * SLANT.cos();
                let along = SLANT.sin() * at[1] / distance;
                let cosine = 1.0 - 0.5 * (apart2 + anisotropy * (along * along - apart2));
                let expected = 0.9 * cosine.powf(EXPONENT);
                let [red, _, blue] = seen[y * SIDE + x];
                assert!(
                    (red - expected).abs() < 0.01 && red == blue,
                    "anisotropy {anisotropy}, {at:?}: {red} instead of {expected}"
                );
                brightest = brightest.max(red);
            }
        }
        // Smooth metal mirrors the lamp elsewhere.
        assert_eq!(
            brightest > 0.8,
            anisotropy == 1.0,
            "{anisotropy}: {brightest}"
        );
    }
}

#[test]
fn the_highlight_of_a_metal_has_its_colour() {
    let colour = vec3(0.9, 0.6, 0.3);
    let seen = |metallic| {
        let all = disc(Material {
            colour,
            ks: 1.0,
            metallic,
            anisotropy: 1.0,
            ..Material::BLACK
        });
        all[50 * SIDE + 80]
    };
    assert_eq!(seen(0.0), [1.0; 3], "the lamp's");
    for metallic in [0.5, 1.0] {
        for (channel, share) in seen(metallic).into_iter().zip(colour.to_array()) {
            let expected = 1.0 + metallic * (share - 1.0);
            assert!((channel - expected).abs() < 0.01, "{metallic}: {channel}");
        }
    }
}
