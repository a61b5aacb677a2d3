//! The background, the haze, the floor and the lights of each set.

use super::Set;
use super::material;
use crate::scene::{Light, Material, Plane, Scene, Spot};
use glam::{Vec3A, vec3a};

/// The surroundings of a [`Set`].
struct Environment {
    /// See [`Scene::background`].
    background: Vec3A,
    /// See [`Scene::sky`].
    sky: Vec3A,
    /// See [`Scene::ambient`].
    ambient: Vec3A,
    /// See [`Scene::haze`].
    haze: f32,
    /// The material of the floor, a square about the origin at y = 0.
    floor: &'static Material,
    /// Half the side of the floor, in scene units.
    floor_half: f32,
    /// The lights. Here a spotlight's aim may have any length.
    lights: &'static [Light],
}

/// Half the side of a floor that seems endless: haze hides its edge.
const FAR: f32 = 100.0;

static TITLE: Environment = Environment {
    background: vec3a(0.05, 0.07, 0.14),
    sky: vec3a(-0.04, -0.05, -0.08),
    ambient: vec3a(0.10, 0.10, 0.10),
    haze: 0.015,
    floor: &material::NIGHT,
    floor_half: FAR,
    lights: &[
        point([7.0, 8.0, -9.0], [1.25, 0.95, 0.62]),
        point([-9.0, 4.0, -5.0], [0.30, 0.48, 0.95]),
    ],
};

static MODEL: Environment = Environment {
    background: vec3a(0.10, 0.12, 0.20),
    sky: Vec3A::ZERO,
    ambient: vec3a(0.12, 0.12, 0.14),
    haze: 0.0,
    floor: &material::PAPER,
    floor_half: 12.0,
    lights: &[
        Light {
            radius: 0.15,
            ..point([-4.0, 6.0, -4.0], [0.90, 0.85, 0.80])
        },
        Light {
            radius: 0.15,
            ..point([5.0, 5.0, -2.0], [0.35, 0.40, 0.50])
        },
    ],
};

static COLONNADE: Environment = Environment {
    background: vec3a(0.78, 0.50, 0.36),
    sky: vec3a(-0.62, -0.26, 0.10),
    ambient: vec3a(0.16, 0.15, 0.20),
    haze: 0.022,
    floor: &material::SANDSTONE,
    floor_half: FAR,
    lights: &[
        Light {
            size: 0.2,
            ..sun([7.0, 4.2, -3.4], [1.00, 0.70, 0.40])
        },
        sun([-4.0, 5.0, -5.0], [0.16, 0.22, 0.38]),
        Light {
            size: 1.2,
            spot: Some(Spot {
                aim: vec3a(0.0, -1.0, 0.0),
                dark: 0.96,
                bright: 0.98,
            }),
            ..point([0.0, 9.0, 6.0], [0.45, 0.50, 0.65])
        },
    ],
};

static MACHINE: Environment = Environment {
    background: vec3a(0.06, 0.07, 0.11),
    sky: vec3a(-0.03, -0.03, -0.03),
    ambient: vec3a(0.10, 0.11, 0.15),
    haze: 0.03,
    floor: &material::SLATE,
    floor_half: FAR,
    lights: &[
        Light {
            size: 0.8,
            spot: Some(Spot {
                aim: vec3a(0.5, -0.9, 0.6),
                dark: 0.70,
                bright: 0.95,
            }),
            ..point([-5.0, 9.0, -6.0], [1.20, 1.01, 0.79])
        },
        Light {
            radius: 0.2,
            ..point([8.0, 7.0, 2.0], [0.35, 0.50, 0.95])
        },
    ],
};

static SWARM: Environment = Environment {
    background: vec3a(0.10, 0.12, 0.20),
    sky: vec3a(-0.08, -0.09, -0.12),
    ambient: vec3a(0.12, 0.12, 0.15),
    haze: 0.03,
    floor: &material::NIGHT,
    floor_half: FAR,
    lights: &[
        Light {
            size: 1.25,
            ..point([-8.0, 12.0, -6.0], [1.00, 0.86, 0.70])
        },
        point([10.0, 6.0, 4.0], [0.16, 0.26, 0.55]),
    ],
};

static FINALE: Environment = Environment {
    background: vec3a(0.55, 0.30, 0.22),
    sky: vec3a(-0.52, -0.24, -0.06),
    ambient: vec3a(0.12, 0.11, 0.16),
    haze: 0.03,
    floor: &material::DUSK,
    floor_half: FAR,
    lights: &[
        Light {
            size: 0.3,
            ..sun([4.0, 2.2, 6.0], [0.85, 0.50, 0.28])
        },
        point([-6.0, 8.0, -8.0], [0.30, 0.36, 0.55]),
    ],
};

/// An invisible point light, whose shadows are hard.
const fn point(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light {
        position: Vec3A::from_array(position),
        colour: Vec3A::from_array(colour),
        ..Light::DARK
    }
}

/// An invisible light whose rays are parallel.
const fn sun(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light {
        parallel: true,
        ..point(position, colour)
    }
}

/// Replaces a scene's background, haze, planes and lights by those of a set.
pub(super) fn apply(set: Set, scene: &mut Scene) {
    let environment = match set {
        Set::Title => &TITLE,
        Set::Model => &MODEL,
        Set::Colonnade => &COLONNADE,
        Set::Machine => &MACHINE,
        Set::Swarm => &SWARM,
        Set::Finale => &FINALE,
    };
    scene.background = environment.background;
    scene.sky = environment.sky;
    scene.ambient = environment.ambient;
    scene.haze = environment.haze;
    scene.planes.clear();
    scene.planes.push(Plane {
        centre: Vec3A::ZERO,
        half_x: environment.floor_half,
        half_z: environment.floor_half,
        material: *environment.floor,
    });
    scene.lights.clear();
    for &light in environment.lights {
        let spot = light.spot.map(|spot| Spot {
            aim: spot.aim.normalize(),
            ..spot
        });
        scene.lights.push(Light { spot, ..light });
    }
}
