use crate::drawn::{draw, isa_of, jagged};
use crate::error::Difference;
use eightfold_scenes::{Random, cases, materials_of, solids};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Light, List, Material, Pattern, Plane, Scene, Sphere};
use glam::{Mat3, Vec3, vec3};

fn patterned(random: &mut Random) -> Scene {
    let distance = random.power(-0.3, 1.5);
    let waves = [Vec3::X, Vec3::Z, vec3(1.0, 0.0, 1.0), Vec3::Y, Vec3::ONE];
    let pattern = Pattern {
        waves: random.one_of(waves) * random.power(-0.7, 0.7),
        depth: random.between(0.4, 1.0),
        edge: random.power(-0.3, 1.6),
        balance: random.between(-0.9, 0.9),
        warp: random.zero_or(0.3, 1.5),
        grain: random.between(0.3, 2.0),
    };
    let material = Material {
        pattern,
        ..Material::matt(random.colour(), 0.8)
    };
    let eye = vec3(0.0, random.between(0.4, 3.0), -distance);
    let mut scene = Scene {
        camera: Camera::new(
            Mat3::from_rotation_y(random.between(0.0, 6.0)) * eye,
            Vec3::ZERO,
            0.6,
        ),
        background: random.colour(),
        ambient: Vec3::splat(0.3),
        planes: List::of(&[Plane::new(-Vec3::Y, 20.0, 20.0, material)]),
        lights: List::of(&[Light::new(vec3(-3.0, 6.0, -4.0), Vec3::splat(0.7))]),
        ..Scene::default()
    };
    match random.below(3) {
        0 => {}
        1 => scene.spheres.push(Sphere::new(Vec3::ZERO, 0.9, material)),
        _ => scene.blocks.push(solids::block(
            random,
            Vec3::ZERO,
            vec3(0.5, 0.8, 0.5),
            material,
        )),
    }
    scene
}

/// Squares split at the edges of objects and shadows, but not at the much longer edges of sharp patterns.
#[test]
fn patterns_are_right_at_any_distance() {
    let mut worst = f64::INFINITY;
    let (mut points, mut plainly) = (0, 0);
    for mut random in cases(40) {
        let isa = isa_of(random.seed);
        let scene = patterned(&mut random);
        let draw = |scene: &Scene, quality| draw(isa, 2, scene, &quality, 480, 270);
        let pattern = &scene.planes[0].material.pattern;
        let qualities = [jagged(Quality::DEFAULT), Quality::DEFAULT];
        let drawn = qualities.map(|quality| draw(&scene, quality));
        for (quality, drawn) in qualities.iter().zip(&drawn) {
            let exact = draw(&scene, quality.reference());
            let psnr = Difference::between(&exact.pixels, &drawn.pixels).psnr;
            assert!(
                psnr >= 42.0,
                "case {}: {psnr:.1} dB of {pattern:?}",
                random.seed
            );
            worst = worst.min(psnr);
        }
        if pattern.edge > 10.0 {
            points += drawn[0].counts.points;
            let mut plain = scene.clone();
            let materials = materials_of(&mut plain);
            materials.into_iter().for_each(|it| it.pattern.depth = 0.0);
            plainly += draw(&plain, qualities[0]).counts.points;
        }
    }
    println!("{worst:.1} dB, {points} points, {plainly} without patterns");
    assert!(3 * points < 4 * plainly, "{points} of {plainly}");
}
