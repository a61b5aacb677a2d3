//! A scene in f64, as the path tracer sees it.

use super::lamp::Lamp;
use super::surface::Bsdf;
use eightfold_oracle::geometry::{Face, Met, PicturePlane, Ray, Shape};
use eightfold_oracle::pattern::reflectance;
use eightfold_oracle::waves;
use eightfold_tracer::glam::DVec3;
use eightfold_tracer::scene::{Material, Scene, Waves};

/// A shape and its material.
#[derive(Clone, Copy, Debug)]
pub struct Body {
    pub shape: Shape,
    pub material: Material,
    /// The waves on it: none but on the first plane.
    pub waves: Waves,
}

impl Body {
    /// Whether no waves tilt its normals.
    pub fn is_smooth(&self) -> bool {
        self.waves == Waves::CALM
    }

    /// Its flat sides.
    pub fn faces(&self) -> Vec<Face> {
        if self.is_smooth() {
            self.shape.faces()
        } else {
            Vec::new()
        }
    }
}

/// A scene for pictures of one size.
#[derive(Clone, Debug)]
pub struct World {
    pub bodies: Vec<Body>,
    pub lamps: Vec<Lamp>,
    background: DVec3,
    sky: DVec3,
    haze: f64,
    pub ambient: DVec3,
    /// The factor on all light, by fading.
    pub brightness: f64,
    plane: PicturePlane,
    /// The radius over which caustics are blurred, in scene units.
    pub blur: f64,
}

/// The radius over which caustics are blurred, in pixels at the distance of the point that the camera looks at.
const BLUR: f64 = 2.0;

impl World {
    /// The world of a scene, without its captions. Whether lamps have falloff is for [`Lamp::new`].
    pub fn new(scene: &Scene, width: usize, height: usize, has_falloff: bool) -> Self {
        let bodies = bodies(scene);
        let lamps = scene.lights.iter();
        let lamps: Vec<Lamp> = lamps
            .map(|light| Lamp::new(light, &scene.camera, has_falloff))
            .collect();
        let plane = PicturePlane::new(&scene.camera, width, height);
        let sight = scene.camera.look_at.distance(scene.camera.eye);
        Self {
            bodies,
            lamps,
            background: scene.background.as_dvec3(),
            sky: scene.sky.as_dvec3(),
            haze: scene.haze.into(),
            ambient: scene.ambient.as_dvec3(),
            brightness: scene.exposure.into(),
            plane,
            blur: BLUR * plane.pixel * f64::from(sight),
        }
    }

    /// The ray through a point of the picture, in pixels. A pixel's coordinates are those of its centre.
    pub fn primary_ray(&self, x: f64, y: f64) -> Ray {
        self.plane.ray(x, y)
    }

    /// The body that a ray meets first.
    pub fn nearest(&self, ray: Ray) -> Option<(&Body, Met)> {
        let mut nearest: Option<(&Body, Met)> = None;
        for body in &self.bodies {
            let limit = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
            if let Some(met) = body.shape.meet(ray, limit) {
                nearest = Some((body, met));
            }
        }
        // Waves tilt the normal. They are seen as coarse as a pixel at the distance of this part of the path would see them.
        nearest.map(|(body, mut met)| {
            if !body.is_smooth() {
                let seen = met.t * self.plane.pixel / ray.d.y.abs();
                met.normal = waves::normal(&body.waves, ray.at(met.t), ray.d, seen);
            }
            (body, met)
        })
    }

    /// The share of light that bodies let pass over a distance along a ray: none, or with `is_tinted` the tint of each solid in
    /// its way.
    pub fn passing(&self, ray: Ray, distance: f64, is_tinted: bool) -> DVec3 {
        let mut share = DVec3::ONE;
        for body in &self.bodies {
            if body.shape.meet(ray, distance).is_some() {
                let is_solid = !matches!(body.shape, Shape::Plane { .. });
                if !(is_tinted && is_solid) {
                    return DVec3::ZERO;
                }
                share *= body.material.tint.as_dvec3();
            }
        }
        share
    }

    /// The radiance of the background in a direction.
    pub fn behind(&self, d: DVec3) -> DVec3 {
        let rise = d.y.max(0.0);
        self.background + rise * (2.0 - rise) * self.sky
    }

    /// The share of light that the haze lets through over a distance. The background's makes up for the rest.
    pub fn transmittance(&self, t: f64) -> f64 {
        1.0 / (1.0 + (self.haze * t).powi(2))
    }

    /// The index of a body.
    pub fn index(&self, body: &Body) -> usize {
        let mut bodies = self.bodies.iter();
        bodies
            .position(|it| std::ptr::eq(it, body))
            .expect("one of its own")
    }

    /// The surface of a body where a ray meets it. `keeps_energy` is whether it is a physical one.
    pub fn surface(&self, body: &Body, ray: Ray, met: &Met, keeps_energy: bool) -> Bsdf {
        let is_inside = ray.d.dot(met.normal) > 0.0;
        let n = if is_inside { -met.normal } else { met.normal };
        Bsdf::new(
            &body.material,
            self.paint(body, ray, met),
            ray.d,
            n,
            body.shape.groove(ray.at(met.t), n),
            is_inside,
            keeps_energy,
        )
    }

    /// The colour of a body, painted with its pattern, where a ray meets it. The edges of a pattern are at least a pixel wide.
    pub fn paint(&self, body: &Body, ray: Ray, met: &Met) -> DVec3 {
        let footprint = met.t * self.plane.pixel / ray.d.dot(met.normal).abs();
        let own = body.shape.own_coordinates(ray.at(met.t));
        body.material.colour.as_dvec3() * reflectance(&body.material.pattern, own, footprint)
    }
}

/// All bodies of a scene.
fn bodies(scene: &Scene) -> Vec<Body> {
    let body = |shape: Shape, material: &Material| Body {
        shape,
        material: *material,
        waves: Waves::CALM,
    };
    let spheres = scene.spheres.iter().map(|it| body(it.into(), &it.material));
    let planes = scene.planes.iter().enumerate().map(|(i, it)| Body {
        waves: if i == 0 { scene.water } else { Waves::CALM },
        ..body(it.into(), &it.material)
    });
    let blocks = scene.blocks.iter().map(|it| body(it.into(), &it.material));
    spheres.chain(planes).chain(blocks).collect()
}
