//! What every ray of a frame uses, computed once a frame.

use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SPHERES, Material, Scene, camera::Raster};
use glam::Vec3;

/// Objects a ray can hit: spheres, lights (drawn as spheres), planes, and the background.
pub(crate) const MAX_OBJECTS: usize = MAX_SPHERES + MAX_LIGHTS + MAX_PLANES + 1;

/// A highlight fainter than this share of its coefficient is not computed: 1/40 of what 8 bits can show.
const FAINT: f32 = 1e-4;

/// One frame's scene in the order the kernels want it.
///
/// Objects are numbered: spheres, lights, planes, background.
pub(crate) struct Prepared {
    pub eye: Vec3,
    pub raster: Raster,
    /// The solid spheres, then the lights' spheres.
    pub balls: [Ball; MAX_SPHERES + MAX_LIGHTS],
    pub solids: usize,
    pub lamps: [Lamp; MAX_LIGHTS],
    pub lamp_count: usize,
    pub planes: [Rectangle; MAX_PLANES],
    pub plane_count: usize,
    pub surfaces: [Surface; MAX_OBJECTS],
}

/// A sphere as its intersection wants it.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    pub centre: Vec3,
    /// The radius squared.
    pub r2: f32,
    /// The camera's eye minus the centre: the start of every primary ray, seen from the centre.
    pub from_eye: Vec3,
}

/// A horizontal rectangle.
#[derive(Clone, Copy)]
pub(crate) struct Rectangle {
    pub centre: Vec3,
    pub half_x: f32,
    pub half_z: f32,
}

/// A point light.
#[derive(Clone, Copy)]
pub(crate) struct Lamp {
    pub position: Vec3,
    pub colour: Vec3,
    /// The solid spheres that can throw a shadow.
    pub casters: [Caster; MAX_SPHERES],
}

/// A sphere as shadow rays want it.
#[derive(Clone, Copy)]
pub(crate) struct Caster {
    /// The lamp seen from the centre.
    pub from_lamp: Vec3,
    /// The radius squared.
    pub r2: f32,
}

/// What shading needs of an object.
#[derive(Clone, Copy)]
pub(crate) struct Surface {
    /// The normal at p is `(p - centre) inverse_radius + (0, upright, 0)`.
    pub centre: Vec3,
    /// 1 / radius of a sphere, 0 of a plane.
    pub inverse_radius: f32,
    /// 1 for a plane, 0 for a sphere.
    pub upright: f32,
    /// Light that needs no lamp: ambient light reflected, or what a lamp or the background emits.
    pub base: Vec3,
    /// Colour times diffuse coefficient.
    pub diffuse: Vec3,
    pub ks: f32,
    pub exponent: f32,
    /// No highlight where r.v is below this; 2 where there is none at all.
    pub faint: f32,
    pub kr: f32,
    pub kt: f32,
    pub index: f32,
    /// Lamps shine on it: 1, or 0 for lamps and the background.
    pub solid: f32,
}

impl Prepared {
    /// An empty frame.
    pub const fn new() -> Self {
        Self {
            eye: Vec3::ZERO,
            raster: Raster::NONE,
            balls: [Ball::NONE; MAX_SPHERES + MAX_LIGHTS],
            solids: 0,
            lamps: [const { Lamp::NONE }; MAX_LIGHTS],
            lamp_count: 0,
            planes: [Rectangle::NONE; MAX_PLANES],
            plane_count: 0,
            surfaces: [Surface::NONE; MAX_OBJECTS],
        }
    }

    /// The balls and the planes end here: the background's number.
    pub fn nothing(&self) -> usize {
        self.solids + self.lamp_count + self.plane_count
    }

    /// Takes a scene in, for pictures of `width` by `height` pixels.
    pub fn set(&mut self, scene: &Scene, width: usize, height: usize) {
        self.eye = scene.camera.eye;
        self.raster = scene.camera.raster(width, height);
        self.solids = scene.spheres.len();
        self.lamp_count = scene.lights.len();
        self.plane_count = scene.planes.len();
        let ball = |centre: Vec3, radius: f32| Ball {
            centre,
            r2: radius * radius,
            from_eye: scene.camera.eye - centre,
        };
        for (i, sphere) in scene.spheres.iter().enumerate() {
            self.balls[i] = ball(sphere.centre, sphere.radius);
            self.surfaces[i] = Surface {
                centre: sphere.centre,
                inverse_radius: 1.0 / sphere.radius,
                upright: 0.0,
                ..Surface::of(&sphere.material, scene.ambient)
            };
        }
        for (i, light) in scene.lights.iter().enumerate() {
            let lamp = &mut self.lamps[i];
            lamp.position = light.position;
            lamp.colour = light.colour;
            for (caster, sphere) in lamp.casters.iter_mut().zip(scene.spheres.iter()) {
                caster.from_lamp = light.position - sphere.centre;
                caster.r2 = sphere.radius * sphere.radius;
            }
            self.balls[self.solids + i] = ball(light.position, light.radius);
            self.surfaces[self.solids + i] = Surface::emitting(light.colour);
        }
        let first_plane = self.solids + self.lamp_count;
        for (i, plane) in scene.planes.iter().enumerate() {
            self.planes[i] = Rectangle {
                centre: plane.centre,
                half_x: plane.half_x,
                half_z: plane.half_z,
            };
            self.surfaces[first_plane + i] = Surface {
                centre: plane.centre,
                inverse_radius: 0.0,
                upright: 1.0,
                ..Surface::of(&plane.material, scene.ambient)
            };
        }
        self.surfaces[self.nothing()] = Surface::emitting(scene.background);
    }
}

impl Surface {
    fn of(material: &Material, ambient: Vec3) -> Self {
        Self {
            base: material.colour * ambient,
            diffuse: material.colour * material.kd,
            ks: material.ks,
            exponent: material.exponent,
            faint: if material.ks > 0.0 {
                libm::powf(FAINT, 1.0 / material.exponent)
            } else {
                2.0
            },
            kr: material.kr,
            kt: material.kt,
            index: material.index,
            solid: 1.0,
            ..Self::NONE
        }
    }

    fn emitting(colour: Vec3) -> Self {
        Self {
            base: colour,
            faint: 2.0,
            ..Self::NONE
        }
    }
}

impl Ball {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        r2: 0.0,
        from_eye: Vec3::ZERO,
    };
}

impl Rectangle {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        half_x: 0.0,
        half_z: 0.0,
    };
}

impl Lamp {
    const NONE: Self = Self {
        position: Vec3::ZERO,
        colour: Vec3::ZERO,
        casters: [Caster::NONE; MAX_SPHERES],
    };
}

impl Caster {
    const NONE: Self = Self {
        from_lamp: Vec3::ZERO,
        r2: 0.0,
    };
}

impl Surface {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        inverse_radius: 0.0,
        upright: 0.0,
        base: Vec3::ZERO,
        diffuse: Vec3::ZERO,
        ks: 0.0,
        exponent: 1.0,
        faint: 2.0,
        kr: 0.0,
        kt: 0.0,
        index: 1.0,
        solid: 0.0,
    };
}
