use crate::drawn::{draw_best, example, isa_of};
use crate::errors::compared;
use eightfold_harness::Size;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_scenes::{Draw, Random, cases, materials, materials_of, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::observe::Fill;
use eightfold_tracer::scene::{Camera, Light, List, Material, Pattern, Plane, Scene, Sphere};
use glam::{Mat3, Vec3, vec3};

const SIZE: [usize; 2] = [480, 270];

fn patterned(random: &mut Random, any: Draw<Pattern>) -> Scene {
    let distance = random.power(-0.3, 1.5);
    let mut pattern = any(random);
    pattern.waves *= random.one_of([0.0, 1.0, 1.0, 1.0]) * random.power(-0.5, 0.5);
    let material = Material { pattern, ..Material::matt(random.colour(), 0.8) };
    let eye = vec3(0.0, random.between(0.4, 3.0), -distance);
    let turn = Mat3::from_rotation_y(random.between(0.0, 6.0));
    let mut scene = Scene {
        camera: Camera::new(turn * eye, Vec3::ZERO, 0.6),
        background: random.colour(),
        ambient: Vec3::splat(0.3),
        planes: List::of(&[Plane::new(-Vec3::Y, 20.0, 20.0, material)]),
        ..Scene::default()
    };
    for _ in 0..=random.below(3) {
        let position = random.vector(vec3(-6.0, 2.0, -6.0), vec3(6.0, 6.0, 6.0));
        scene.lights.push(Light::new(position, random.colour() * 0.7));
    }
    match random.below(4) {
        0 | 1 => {}
        2 => scene.spheres.push(Sphere::new(Vec3::ZERO, 0.9, material)),
        _ => scene.blocks.push(solids::block(random, Vec3::ZERO, vec3(0.5, 0.8, 0.5), material)),
    }
    scene
}

/// Spots and shadows of shapes are lost where no drawn pixel nearby is similar.
#[test]
fn patterns_are_right_at_any_distance() {
    // Before patterns had bounds, these had 32 to 39 dB, and lost spots of up to 136 pixels.
    let known = [72, 263, 378, 407, 458, 688, 778, 853, 888, 893].map(Random::new);
    let kinds: [Draw<Pattern>; 2] = [materials::pattern, materials::swirled];
    let random = || known.clone().into_iter().chain(cases(4));
    let all = kinds.into_iter().flat_map(|any| random().map(move |random| (any, random)));
    for (any, mut random) in all {
        let scene = patterned(&mut random, any);
        let is_bare = scene.spheres.is_empty() && scene.blocks.is_empty();
        for quality in [Quality::DEFAULT.jagged(), Quality::DEFAULT] {
            let (psnr, patch) = compared(isa_of(random.seed), &scene, quality, SIZE);
            let is_right = psnr >= 42.0 && (patch <= 8 || !is_bare);
            let pattern = &scene.planes[0].material.pattern;
            assert!(is_right, "case {}: {psnr:.1} dB, {patch}: {pattern:?}", random.seed);
        }
    }
}

/// Squares split at the edges of objects and shadows, but not at the much longer edges of sharp
/// patterns.
#[test]
fn sharp_patterns_split_few_squares() {
    let quality = Quality::DEFAULT.jagged();
    let (mut points, mut plainly) = (0, 0);
    for mut random in cases(40) {
        let mut scene = patterned(&mut random, materials::pattern);
        let pattern = scene.planes[0].material.pattern;
        if pattern.edge > 10.0 && pattern.waves != Vec3::ZERO {
            points += draw_best(&scene, &quality, SIZE[0], SIZE[1]).counts.points;
            let materials = materials_of(&mut scene);
            materials.into_iter().for_each(|it| it.pattern.depth = 0.0);
            plainly += draw_best(&scene, &quality, SIZE[0], SIZE[1]).counts.points;
        }
    }
    println!("{points} points, {plainly} without patterns");
    assert!(3 * points < 4 * plainly, "{points} of {plainly}");
}

/// Per-pixel patterns took two thirds of the time of a planet whose night side is black.
#[test]
fn dark_patterns_are_interpolated() {
    for (light, is_patterned) in [(0.3, true), (0.01, true), (0.001, false)] {
        let mut scene = example("planet");
        scene.lights.clear();
        scene.ambient = Vec3::splat(light);
        let (level, size) = (isa_of(0).level, Size::new(SIZE[0], SIZE[1]));
        let (_, frame) = ThreadedRenderer::new(2).trace(level, &scene, &Quality::DEFAULT, size);
        let squares = frame.squares();
        assert_eq!(squares.iter().any(|it| it.fill == Fill::Patterned), is_patterned, "{light}");
        assert!(compared(isa_of(0), &scene, Quality::DEFAULT, SIZE).0 > 55.0, "{light}");
    }
}
