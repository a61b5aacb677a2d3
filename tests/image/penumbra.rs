//! A sphere's approximate penumbra is close to a sampled one.

use crate::drawn::draw_best;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::{DVec3, Vec3, vec3};

const SPHERE: Sphere = Sphere::new(vec3(0.0, 1.5, 0.0), 0.6, Material::BLACK);

const LIGHT: Light = Light {
    diameter: 1.0,
    ..Light::new(vec3(1.0, 6.0, 0.5), Vec3::ONE)
};

fn visible_share(p: DVec3) -> f64 {
    const SAMPLES: usize = 1600;
    let to_light = LIGHT.position.as_dvec3() - p;
    let axis = to_light.normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let mut visible = 0;
    for i in 0..SAMPLES {
        let radius = 0.5 * f64::from(LIGHT.diameter) * ((i as f64 + 0.5) / SAMPLES as f64).sqrt();
        // A spiral by the golden angle.
        let angle = 2.399_963 * i as f64;
        let target = to_light + radius * (angle.cos() * u + angle.sin() * v);
        let d = target.normalize();
        let to_centre = SPHERE.centre.as_dvec3() - p;
        let off = to_centre - to_centre.dot(d) * d;
        visible += usize::from(off.length() > f64::from(SPHERE.radius));
    }
    visible as f64 / SAMPLES as f64
}

#[test]
fn penumbra_matches_sampled_light() {
    // A white floor from above: its brightness is `cosine` times the visible share of the light.
    let floor = Plane {
        half_x: 9.0,
        half_z: 9.0,
        material: Material::matt(Vec3::ONE, 1.0),
        ..Plane::default()
    };
    let eye = vec3(0.0, 30.0, 0.0);
    let scene = Scene {
        camera: Camera {
            up: Vec3::X,
            ..Camera::new(eye, Vec3::ZERO, 0.2)
        },
        spheres: List::of(&[SPHERE]),
        planes: List::of(&[floor]),
        lights: List::of(&[LIGHT]),
        ..Scene::default()
    };
    let size = 100;
    let camera = scene.camera;
    let drawn = draw_best(&scene, &Quality::EXHAUSTIVE, size, size);
    let half = (0.5 * camera.field_of_view).tan() * eye.y;
    let (mut sum, mut largest, mut count) = (0.0, 0.0_f64, 0);
    for (i, &pixel) in drawn.pixels.iter().enumerate() {
        let coordinate = |i: usize| (i as f32 + 0.5) / size as f32 * 2.0 - 1.0;
        let p = vec3(
            -coordinate(i / size) * half,
            0.0,
            coordinate(i % size) * half,
        )
        .as_dvec3();
        // Within 0.63 of its centre, the sphere hides the floor.
        let to_sphere = (p - SPHERE.centre.as_dvec3().with_y(0.0)).length();
        if to_sphere < 0.65 {
            continue;
        }
        let cosine = (LIGHT.position.as_dvec3() - p).normalize().y;
        let share = f64::from(pixel & 0xff) / 255.0 / cosine;
        let off = (share - visible_share(p)).abs();
        sum += off;
        largest = largest.max(off);
        count += 1;
    }
    let mean = sum / f64::from(count);
    println!("penumbra error: mean {mean:.4}, largest {largest:.3}");
    assert!(
        mean < 0.01 && largest < 0.1,
        "mean {mean}, largest {largest}"
    );
}
