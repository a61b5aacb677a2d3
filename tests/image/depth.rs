//! Rays beyond a quality's limits are neither black nor brighter than their surroundings.

use crate::cpu;
use crate::drawn::{draw, draw_best, isa_of, named};
use crate::errors::assert_near;
use eightfold_scenes::solids::SHAPES;
use eightfold_scenes::{Kinds, cases, materials, materials_of};
use eightfold_tracer::scene::{
    Ambience, Block, Camera, Light, List, Material, Plane, Scene, Softbox, Sphere,
};
use eightfold_tracer::{Preset, Quality};
use glam::{Vec3, vec3};

/// Draws by every depth, tracing all weights, few, or none.
#[track_caller]
fn assert_white(scene: &Scene, seed: u64) {
    for depth in 0..=Quality::MAX_DEPTH {
        for least_contribution in [0.0, 0.01, 0.05, f32::INFINITY] {
            let quality = Quality { depth, least_contribution, ..Quality::EXHAUSTIVE };
            let drawn = draw(isa_of(seed), 2, scene, &quality, 64, 48).pixels;
            let darkest = drawn.iter().flat_map(|pixel| pixel.to_be_bytes()[1..].to_vec()).min();
            assert!(darkest >= Some(250), "{darkest:?}, {quality:?}, {scene:?}");
        }
    }
}

#[test]
fn white_furnace_is_white_at_every_depth() {
    let white = Material { kr: 0.04, fresnel: 1.0, kt: 0.96, index: 0.667, ..Material::BLACK };
    let bubble = Scene {
        camera: Camera::new(4.0 * Vec3::Z, Vec3::ZERO, 0.6),
        spheres: List::of(&[Sphere::new(Vec3::ZERO, 1.0, white)]),
        ..furnace(Scene::default())
    };
    assert_white(&bubble, 0);
    for mut random in cases(24) {
        let mut scene = furnace(Kinds::RICH.scene(&mut random));
        for material in materials_of(&mut scene) {
            *material = materials::plain(&mut random);
            material.colour = Vec3::splat(1.0 - material.kr - material.kt);
        }
        assert_white(&scene, random.seed);
    }
}

fn furnace(scene: Scene) -> Scene {
    Scene {
        background: Vec3::ONE,
        sky: Vec3::ZERO,
        ambient: Vec3::ONE,
        exposure: 1.0,
        lights: List::default(),
        film: Default::default(),
        // Occluded light is lost where solids reflect less.
        ambience: Ambience::UNIFORM,
        ..scene
    }
}

fn mirror(centre: Vec3, half: Vec3) -> Block {
    let material = Material { kr: 0.95, ..Material::BLACK };
    Block::new(SHAPES[0], centre, half, material)
}

/// Also two glass balls in a row, and the eye inside a mirror: once black.
#[test]
fn facing_mirrors_show_no_black_pixel() {
    let floor = Material::matt(Vec3::ONE, 0.6);
    let ball = Material::matt(vec3(1.0, 0.3, 0.1), 0.8);
    let balls =
        [(0.3, 0.0, ball), (-0.4, 0.0, Material::glass(1.5)), (-0.4, -0.6, Material::glass(1.5))];
    let eye = vec3(0.0, 1.0, 0.9);
    let facing = [-1.0, 1.0].map(|z| (vec3(0.0, 1.0, z), vec3(2.0, 1.0, 0.05)));
    let around = [(eye, Vec3::splat(0.5))];
    for (mirrors, background, ambient) in
        [(&facing[..], 0.6, 0.3), (&facing, 0.01, 0.3), (&facing, 0.6, 0.05), (&around, 0.6, 0.3)]
    {
        let scene = Scene {
            camera: Camera::new(eye, vec3(0.0, 0.8, -1.0), 1.0),
            background: Vec3::splat(background),
            ambient: Vec3::splat(ambient),
            planes: List::of(&[Plane::new(Vec3::ZERO, 5.0, 5.0, floor)]),
            blocks: mirrors.iter().map(|&(centre, half)| mirror(centre, half)).collect(),
            spheres: balls
                .into_iter()
                .map(|(x, z, material)| Sphere::new(vec3(x, 0.5, z), 0.3, material))
                .collect(),
            lights: List::of(&[Light::new(vec3(1.0, 5.0, 0.0), Vec3::splat(0.7))]),
            ..Scene::default()
        };
        for quality in named().chain([Quality::EXHAUSTIVE]) {
            let drawn = draw(cpu::best(), 2, &scene, &quality, 320, 240).pixels;
            let black = drawn.iter().filter(|&&pixel| pixel == 0).count();
            assert_eq!(black, 0, "{background}, {ambient}, {quality:?}");
        }
        let fastest = *Preset::Fastest.quality();
        assert_near("facing mirrors", &scene, fastest, [320, 240], (usize::MAX, 20.0));
    }
}

#[test]
fn black_beyond_blackens_only_untraced_rays() {
    let ([half_width, half_height, softness], colour) = ([1.0; 3], Vec3::ONE);
    let softbox = |aim| Softbox { aim, half_width, half_height, softness, colour };
    let sides = [Vec3::Z, Vec3::NEG_Z].map(softbox);
    let white = furnace(Scene::default());
    let dark = Scene { background: Vec3::ZERO, softboxes: List::of(&sides), ..white.clone() };
    for (kt, scene) in [(0.0, &white), (1.0, &white), (0.0, &dark), (1.0, &dark)] {
        let material = Material { kr: 1.0 - kt, kt, ..Material::BLACK };
        let scene = Scene {
            spheres: List::of(&[Sphere::new(Vec3::ZERO, 0.5, material)]),
            black_beyond: true,
            ..scene.clone()
        };
        let middle = |depth| {
            let quality = Quality { depth, ..Quality::EXHAUSTIVE };
            draw_best(&scene, &quality, 9, 9).pixels[40]
        };
        assert_eq!([middle(0), middle(2)], [0, 0xff_ffff], "kt {kt}");
    }
}
