use crate::drawn::draw_best;
use eightfold_oracle::Oracle;
use eightfold_oracle::geometry::Ray;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use glam::{DVec3, Mat3, Vec3, vec3};

const LIGHT: Light = Light { diameter: 1.0, ..Light::new(vec3(1.0, 6.0, 0.5), Vec3::ONE) };

fn visible_share(oracle: &Oracle<'_>, p: DVec3) -> f64 {
    const SAMPLES: usize = 400;
    let to_light = LIGHT.position.as_dvec3() - p;
    let (u, v) = to_light.normalize().any_orthonormal_pair();
    let visible = (0..SAMPLES).filter(|&i| {
        let radius = 0.5 * f64::from(LIGHT.diameter) * ((i as f64 + 0.5) / SAMPLES as f64).sqrt();
        let angle = 2.399_963 * i as f64;
        let target = to_light + radius * (angle.cos() * u + angle.sin() * v);
        oracle.is_free(Ray::new(p, target.normalize()), target.length())
    });
    visible.count() as f64 / SAMPLES as f64
}

/// Returns the mean and the largest error of a white floor's brightness, seen from above, where the
/// occluder does not hide it.
fn errors(scene: &Scene) -> [f64; 2] {
    let size = 50;
    let drawn = draw_best(scene, &Quality::EXHAUSTIVE, size, size);
    let oracle = Oracle::new(scene, &Quality::EXHAUSTIVE, size, size);
    let (mut sum, mut largest, mut count) = (0.0, 0.0_f64, 0);
    for (i, &pixel) in drawn.pixels.iter().enumerate() {
        let hit = oracle.surface(oracle.ray((i % size) as f64, (i / size) as f64));
        let Some(p) = hit.map(|hit| hit.ray.o).filter(|p| p.y.abs() < 1e-9) else { continue };
        let cosine = (LIGHT.position.as_dvec3() - p).normalize().y;
        let share = f64::from(pixel & 0xff) / 255.0 / cosine;
        let off = (share - visible_share(&oracle, p)).abs();
        sum += off;
        largest = largest.max(off);
        count += 1;
    }
    [sum / f64::from(count), largest]
}

#[test]
fn penumbrae_match_sampled_light() {
    let floor = Plane::new(Vec3::ZERO, 9.0, 9.0, Material::matt(Vec3::ONE, 1.0));
    let camera = Camera { up: Vec3::X, ..Camera::new(vec3(0.0, 30.0, 0.0), Vec3::ZERO, 0.2) };
    let (planes, lights) = (List::of(&[floor]), List::of(&[LIGHT]));
    let scene = Scene { camera, planes, lights, ..Scene::default() };
    let centre = vec3(0.0, 1.5, 0.0);
    let spheres = List::of(&[Sphere::new(centre, 0.6, Material::BLACK)]);
    let assert_within = |scene: &Scene, limits: [f64; 2]| {
        let errors = errors(scene);
        let is_within = errors[0] < limits[0] && errors[1] < limits[1];
        assert!(is_within, "mean and largest: {errors:?}");
    };
    assert_within(&Scene { spheres, ..scene.clone() }, [0.01, 0.1]);
    for (shape, half) in [
        (Shape::Box, vec3(0.6, 0.4, 0.5)),
        (Shape::Box, vec3(0.1, 1.5, 0.8)),
        (Shape::Cylinder, vec3(0.5, 1.2, 0.5)),
        (Shape::Capsule, vec3(0.3, 1.3, 0.3)),
    ] {
        let turned = Mat3::from_rotation_z(0.7) * Mat3::from_rotation_x(0.5);
        for axes in [Mat3::IDENTITY, turned] {
            let block = Block { axes, ..Block::new(shape, centre, half, Material::BLACK) };
            let scene = Scene { blocks: List::of(&[block]), ..scene.clone() };
            assert_within(&scene, [0.02, 0.5]);
        }
    }
}
