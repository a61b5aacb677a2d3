//! Boxes, cylinders, patterns, air and lamps of every kind: the scenes of the show against the oracle, and penumbras
//! against what they stand for.

use crate::accuracy::assert_as_traced;
use crate::cpu;
use crate::drawn::{draw, draw_by_all};
use eightfold::Quality;
use eightfold::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use eightfold::show::{self, grid};
use eightfold_oracle::frame::Frame;
use glam::{DVec3, Vec3A, vec3a};

#[test]
fn every_scene_of_the_show_is_as_the_oracle_sees_it() {
    for bar in 0..grid::BARS {
        if bar % 3 != 1 {
            continue;
        }
        let time = (bar as f32 + 0.3) * grid::BAR;
        let mut scene = Scene::default();
        show::at(time, &mut scene);
        // The oracle can't write.
        scene.captions.clear();
        scene.validate().unwrap();
        // Large enough for a share of silhouettes that rounding decides about.
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 320, 180);
        for (isa, drawn) in draw_by_all(&scene, &Quality::EXHAUSTIVE, 320, 180) {
            assert_as_traced(&drawn, &frame, &format!("bar {bar} by {}", isa.name));
        }
    }
}

const SPHERE: Sphere = Sphere {
    centre: vec3a(0.0, 1.5, 0.0),
    radius: 0.6,
    material: Material::BLACK,
};

const LAMP: Light = Light {
    position: vec3a(1.0, 6.0, 0.5),
    colour: Vec3A::ONE,
    size: 1.0,
    ..Light::DARK
};

/// The share of a round lamp that is seen past the sphere, by many rays.
fn seen_past(p: DVec3) -> f64 {
    const RINGS: usize = 40;
    let to_lamp = LAMP.position.as_dvec3() - p;
    let axis = to_lamp.normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let (mut seen, mut all) = (0, 0);
    for i in 0..RINGS * RINGS {
        let radius =
            0.5 * f64::from(LAMP.size) * ((i as f64 + 0.5) / (RINGS * RINGS) as f64).sqrt();
        let angle = 2.399_963 * i as f64;
        let target = to_lamp + radius * (angle.cos() * u + angle.sin() * v);
        let d = target.normalize();
        let to_centre = SPHERE.centre.as_dvec3() - p;
        let off = to_centre - to_centre.dot(d) * d;
        seen += usize::from(off.length() > f64::from(SPHERE.radius));
        all += 1;
    }
    seen as f64 / all as f64
}

#[test]
fn a_penumbra_is_within_a_tenth_of_what_many_rays_find() {
    // White paper from straight above: brightness is the cosine to the lamp times its share.
    let floor = Plane {
        half_x: 9.0,
        half_z: 9.0,
        material: Material {
            colour: Vec3A::ONE,
            kd: 1.0,
            ..Material::BLACK
        },
        ..Plane::default()
    };
    let eye = vec3a(0.0, 30.0, 0.0);
    let scene = Scene {
        camera: Camera {
            eye,
            look_at: Vec3A::ZERO,
            up: Vec3A::X,
            field_of_view: 0.2,
        },
        spheres: List::of(&[SPHERE]),
        planes: List::of(&[floor]),
        lights: List::of(&[LAMP]),
        ..Scene::default()
    };
    let size = 200;
    let raster = scene.camera;
    let drawn = draw(cpu::best(), 1, &scene, &Quality::EXHAUSTIVE, size, size);
    let half = (0.5 * raster.field_of_view).tan() * eye.y;
    let (mut sum, mut largest, mut count) = (0.0, 0.0_f64, 0);
    for (i, &pixel) in drawn.pixels.iter().enumerate() {
        let place = |i: usize| (i as f32 + 0.5) / size as f32 * 2.0 - 1.0;
        // To the right is along z, down against x.
        let p = vec3a(-place(i / size) * half, 0.0, place(i % size) * half).as_dvec3();
        let to_sphere = (p - SPHERE.centre.as_dvec3().with_y(0.0)).length();
        if to_sphere < 0.65 {
            continue;
        }
        let cosine = (LAMP.position.as_dvec3() - p).normalize().y;
        let share = f64::from(pixel & 0xff) / 255.0 / cosine;
        let off = (share - seen_past(p)).abs();
        sum += off;
        largest = largest.max(off);
        count += 1;
    }
    let mean = sum / f64::from(count);
    println!("penumbra: mean {mean:.4}, largest {largest:.3} of the lamp's light");
    assert!(
        mean < 0.01 && largest < 0.1,
        "mean {mean}, largest {largest}"
    );
}
