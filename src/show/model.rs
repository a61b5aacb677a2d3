//! The model scene: four spheres, a plane and two lights, circled once.
//!
//! The scene of every measurement, after the test scene of the 2008 thesis.

use crate::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use crate::trigonometry::{cos, sin};
use glam::{Vec3A, vec3a};

/// Seconds of one orbit: a full turn at [`ORBIT_SPEED`].
pub const LENGTH: f32 = 8.0 * core::f32::consts::PI;

/// Radians a second.
const ORBIT_SPEED: f32 = 0.25;

pub(super) const FLOOR: Plane = Plane {
    centre: Vec3A::ZERO,
    half_x: 12.0,
    half_z: 12.0,
    material: Material {
        colour: vec3a(0.55, 0.55, 0.60),
        kd: 0.8,
        ks: 0.1,
        exponent: 10.0,
        kr: 0.25,
        kt: 0.0,
        index: 1.0,
        ..Material::BLACK
    },
};

const RED: Sphere = Sphere {
    centre: vec3a(-2.2, 1.0, 0.5),
    radius: 1.0,
    material: Material {
        colour: vec3a(0.90, 0.15, 0.12),
        kd: 0.7,
        ks: 0.5,
        exponent: 40.0,
        kr: 0.25,
        kt: 0.0,
        index: 1.0,
        ..Material::BLACK
    },
};

const MIRROR: Sphere = Sphere {
    centre: vec3a(0.0, 1.2, 1.8),
    radius: 1.2,
    material: Material {
        colour: vec3a(0.90, 0.90, 0.95),
        kd: 0.2,
        ks: 0.8,
        exponent: 80.0,
        kr: 0.70,
        kt: 0.0,
        index: 1.0,
        ..Material::BLACK
    },
};

const BLUE: Sphere = Sphere {
    centre: vec3a(2.2, 1.0, 0.3),
    radius: 1.0,
    material: Material {
        colour: vec3a(0.15, 0.35, 0.90),
        kd: 0.7,
        ks: 0.5,
        exponent: 40.0,
        kr: 0.20,
        kt: 0.0,
        index: 1.0,
        ..Material::BLACK
    },
};

const GLASS: Sphere = Sphere {
    centre: vec3a(0.6, 0.5, -1.6), // lowest point of its bounce
    radius: 0.5,
    material: Material {
        colour: vec3a(0.95, 0.95, 0.95),
        kd: 0.05,
        ks: 0.8,
        exponent: 100.0,
        kr: 0.10,
        kt: 0.85,
        index: 1.5,
        ..Material::BLACK
    },
};

pub(super) static LIGHTS: [Light; 2] = [
    Light {
        position: vec3a(-4.0, 6.0, -4.0),
        colour: vec3a(0.90, 0.85, 0.80),
        radius: 0.15,
        ..Light::DARK
    },
    Light {
        position: vec3a(5.0, 5.0, -2.0),
        colour: vec3a(0.35, 0.40, 0.50),
        radius: 0.15,
        ..Light::DARK
    },
];

pub(super) const BACKGROUND: Vec3A = vec3a(0.10, 0.12, 0.20);
pub(super) const AMBIENT: Vec3A = vec3a(0.12, 0.12, 0.14);

/// All spheres, the one that bounces last.
static SPHERES: [Sphere; 4] = [RED, MIRROR, BLUE, GLASS];
static PLANES: [Plane; 1] = [FLOOR];

/// The scene at `time` seconds; it repeats every [`LENGTH`].
#[must_use]
pub fn scene(time: f32) -> Scene {
    let look_at = vec3a(0.0, 0.9, 0.0);
    let mut spheres = List::of(&SPHERES);
    let sine = sin(time);
    if let Some(glass) = spheres.last_mut() {
        glass.centre.y += 0.4 * sine * sine;
    }
    Scene {
        camera: Camera {
            eye: look_at + circling(time, 7.5, 1.3),
            look_at,
            up: Vec3A::Y,
            field_of_view: core::f32::consts::FRAC_PI_4,
        },
        background: BACKGROUND,
        ambient: AMBIENT,
        spheres,
        planes: List::of(&PLANES),
        lights: List::of(&LIGHTS),
        ..Scene::default()
    }
}

/// From the middle of the scene to the camera that circles it at a distance and a height.
pub(super) fn circling(time: f32, distance: f32, height: f32) -> Vec3A {
    let angle = ORBIT_SPEED * time;
    vec3a(distance * sin(angle), height, -distance * cos(angle))
}
