//! Lamps as spheres that shine: what a surface gets of them, directly and by way of a mirror.

use super::{WHITE, assert_near, floor, seen};
use eightfold_lab::truth::effects::Effects;
use eightfold_tracer::glam::{DVec3, Vec3A, dvec3, vec3a};
use eightfold_tracer::scene::{Camera, Light, List, Material, Scene, Sphere, Spot};
use std::f64::consts::{PI, TAU};

const COLOUR: Vec3A = vec3a(0.9, 0.6, 0.3);

/// A lamp of a diameter.
fn lamp(position: Vec3A, size: f32) -> Light {
    Light {
        diameter: size,
        ..Light::new(position, COLOUR)
    }
}

/// A floor of a material with one lamp.
fn lit(material: Material, light: Light) -> Scene {
    Scene {
        lights: List::of(&[light]),
        ..floor(material)
    }
}

#[test]
fn a_lamp_above_the_horizon_gives_the_same_light_whatever_its_size() {
    let position = vec3a(1.0, 2.0, 0.5);
    let cosine = f64::from(position.y / position.length());
    let known = cosine * COLOUR.as_dvec3();
    for size in [0.0, 0.1, 1.0, 3.0] {
        let scene = lit(WHITE, lamp(position, size));
        assert_near(seen(&scene, Effects::TRUTH, 1024), known, 0.02);
        assert_near(seen(&scene, Effects::NONE, 8), known, 1e-9);
    }
    let sun = Light {
        parallel: true,
        ..lamp(position, 0.2)
    };
    assert_near(seen(&lit(WHITE, sun), Effects::TRUTH, 1024), known, 0.01);
}

#[test]
fn with_falloff_it_is_the_square_of_the_distances() {
    let mut scene = lit(WHITE, lamp(vec3a(0.0, 2.0, 0.0), 0.4));
    let truth = Effects {
        falloff: true,
        ..Effects::TRUTH
    };
    // The camera looks at a point 2 away from the lamp's centre: there it is as bright as without.
    assert_near(seen(&scene, truth, 1024), COLOUR.as_dvec3(), 0.01);
    // A floor in front of that point, which the camera sees elsewhere.
    scene.camera.look_at = vec3a(0.0, -1.0, 0.0);
    let there = scene.camera.eye.lerp(scene.camera.look_at, 0.375);
    assert!(there.y.abs() < 1e-6);
    let to_lamp = (scene.lights[0].position - there).as_dvec3();
    let known = 9.0 / to_lamp.length_squared() * to_lamp.normalize().y * COLOUR.as_dvec3();
    assert_near(seen(&scene, truth, 1024), known, 0.03);
}

#[test]
fn a_highlight_of_a_lamp_with_a_size_is_the_integral_over_it() {
    let shiny = Material {
        ks: 0.9,
        exponent: 30.0,
        ..Material::BLACK
    };
    let (position, size) = (vec3a(-2.0, 0.5, 0.1), 0.8);
    let scene = lit(shiny, lamp(position, size));
    // The radiance over the cone of the lamp's directions, by rings.
    let axis = position.as_dvec3().normalize();
    let sine = 0.5 * f64::from(size) / position.as_dvec3().length();
    let least = (1.0 - sine * sine).sqrt();
    let mirrored = dvec3(-4.0, 0.6, 0.0).normalize();
    let (u, v) = axis.any_orthonormal_pair();
    let (mut sum, rings) = (0.0, 200);
    for i in 0..rings * rings {
        let cosine = 1.0 - (1.0 - least) * ((i / rings) as f64 + 0.5) / f64::from(rings);
        let angle = TAU * ((i % rings) as f64 + 0.5) / f64::from(rings);
        let across = angle.cos() * u + angle.sin() * v;
        let d = cosine * axis + (1.0 - cosine * cosine).sqrt() * across;
        // Reciprocal: the lobe, with the model's peak, times the cosine.
        sum += mirrored.dot(d).powi(30) * d.y.max(0.0);
    }
    let solid_angle = TAU * (1.0 - least);
    let radiance = COLOUR.as_dvec3() / (sine * sine);
    let known = 0.9 / PI * radiance * solid_angle * sum / f64::from(rings * rings);
    // By multiple importance sampling, and by the lobe's or the lamp's directions alone these would be far noisier.
    assert_near(seen(&scene, Effects::TRUTH, 4096), known, 0.02);
}

#[test]
fn a_spotlight_is_dark_beside_its_cone() {
    let spot = |aim: Vec3A| Light {
        spot: Some(Spot {
            aim: aim.normalize(),
            cos_outer: 0.9,
            cos_inner: 0.98,
        }),
        ..lamp(vec3a(0.0, 2.0, 0.0), 0.3)
    };
    let at = seen(&lit(WHITE, spot(Vec3A::NEG_Y)), Effects::TRUTH, 512);
    assert_near(at, COLOUR.as_dvec3(), 0.01);
    let beside = seen(
        &lit(WHITE, spot(vec3a(1.0, -1.0, 0.0))),
        Effects::TRUTH,
        512,
    );
    assert_eq!(beside.mean, DVec3::ZERO);
}

#[test]
fn a_lamp_is_seen_in_a_mirror_as_it_is_but_for_what_the_mirror_takes() {
    let mirror = Material::mirror(0.8);
    let mut light = lamp(vec3a(-4.0, 0.6, 0.0), 0.0);
    light.drawn_radius = 0.2;
    let scene = lit(mirror, light);
    let seen_in_it = seen(&scene, Effects::TRUTH, 512);
    assert_near(seen_in_it, 0.8 * COLOUR.as_dvec3(), 0.02);
    // Directly, when the mirror is away.
    let direct = Scene {
        camera: Camera {
            look_at: light.position,
            ..scene.camera
        },
        ..scene
    };
    let known = COLOUR.as_dvec3();
    assert_near(seen(&direct, Effects::TRUTH, 8), known, 1e-9);
}

#[test]
fn a_sphere_hides_the_share_of_a_lamp_that_its_disc_covers() {
    // A sphere right before the lamp's centre: both are discs about the same middle. By solid angle, weighted by the cosine.
    let (lamp_radius, radius) = (1.0_f32, 0.3_f32);
    let mut scene = lit(WHITE, lamp(vec3a(0.0, 6.0, 0.0), 2.0 * lamp_radius));
    scene.spheres = List::of(&[Sphere::new(vec3a(0.0, 3.0, 0.0), radius, Material::BLACK)]);
    let hidden = (radius / 3.0).powi(2) / (lamp_radius / 6.0).powi(2);
    let known = (1.0 - f64::from(hidden)) * COLOUR.as_dvec3();
    assert_near(seen(&scene, Effects::TRUTH, 4096), known, 0.02);
    // Of a point the sphere hides all.
    let point = Effects {
        soft_shadows: false,
        ..Effects::TRUTH
    };
    assert_near(seen(&scene, point, 64), DVec3::ZERO, 1e-9);
}
