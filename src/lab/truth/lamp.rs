//! Lamps as emitters: points, or spheres that shine. Coordinates are the scene's.
//!
//! A scene says how brightly a lamp lights a surface that faces it: a diffuse one of albedo 1 has the lamp's colour c then, as
//! its radiance, so that the irradiance is pi c. A scene also says that this does not fall off with distance. A sphere of radius
//! R whose centre is at the distance d from the surface has the solid-angle measure pi (R/d)^2, weighted by the cosine to its
//! centre, and so the radiance c (d/R)^2 gives the same irradiance where nothing is in the way. Here d is measured along the path
//! of the light, also by way of mirrors and glass. With falloff the radiance is the same from everywhere: that which gives the
//! irradiance pi c at the point that the camera looks at.

use crate::sampler::around;
use eightfold_oracle::geometry::{self, Face, Ray};
use eightfold_tracer::glam::{DVec2, DVec3};
use eightfold_tracer::scene::{Camera, Light};
use std::f64::consts::{PI, TAU};

/// A lamp.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    position: DVec3,
    /// The radiance of a diffuse surface of albedo 1 that faces it.
    colour: DVec3,
    /// The radius of the sphere that shines; 0 for a point.
    radius: f64,
    /// The radius of the sphere that is seen; 0 if none is.
    drawn_radius: f64,
    /// Whether a material's tint colours its shadow in the real-time model.
    pub is_tinted: bool,
    spot: Option<Spot>,
    /// With falloff, the distance at which it is as bright as without.
    reference: Option<f64>,
}

/// The cone of a spotlight; see [`eightfold_tracer::scene::Spot`].
#[derive(Clone, Copy, Debug)]
struct Spot {
    aim: DVec3,
    cos_outer: f64,
    cos_inner: f64,
}

/// The light of a lamp from one direction at a point.
#[derive(Clone, Copy, Debug)]
pub struct Arriving {
    /// Where it comes from, of length 1.
    pub d: DVec3,
    /// How far the way to it has to be free.
    pub distance: f64,
    /// The radiance over the density of the direction; of a point, the irradiance of a surface that faces it.
    pub light: DVec3,
    /// The density with which the direction was chosen, over solid angle; `None` for a point, which no ray meets by chance.
    pub density: Option<f64>,
}

impl Lamp {
    /// The lamp of a scene's light. `has_falloff` is whether it shines less on what is farther away; lamps with parallel rays do
    /// not.
    pub fn new(light: &Light, camera: &Camera, has_falloff: bool) -> Self {
        let far = if light.parallel {
            f64::from(Light::FAR)
        } else {
            1.0
        };
        let position = far * light.position.as_dvec3();
        // A lamp without a size is as large as it is drawn.
        let drawn_radius = if light.parallel {
            0.0
        } else {
            f64::from(light.drawn_radius)
        };
        let radius = if light.diameter > 0.0 {
            0.5 * far * f64::from(light.diameter)
        } else {
            drawn_radius
        };
        let reference = position.distance(camera.look_at.as_dvec3());
        Self {
            position,
            colour: light.colour.as_dvec3(),
            radius,
            drawn_radius,
            is_tinted: light.diameter > 0.0,
            spot: light.spot.map(|spot| Spot {
                aim: spot.aim.as_dvec3(),
                cos_outer: spot.cos_outer.into(),
                cos_inner: spot.cos_inner.into(),
            }),
            reference: (has_falloff && !light.parallel).then_some(reference),
        }
    }

    /// The lamp that a flat mirror shows; `None` if all of it is behind that.
    pub fn mirrored(&self, face: Face) -> Option<Self> {
        let is_before = face.height(self.position) > -self.radius;
        is_before.then(|| Self {
            position: face.mirrored(self.position),
            spot: self.spot.map(|spot| Spot {
                aim: face.turned(spot.aim),
                ..spot
            }),
            ..*self
        })
    }

    /// Where a ray meets the sphere that is seen, and the radiance that it is seen with.
    pub fn seen(&self, ray: Ray) -> Option<(f64, DVec3)> {
        let t = (self.drawn_radius > 0.0)
            .then(|| geometry::sphere(ray, self.position, self.drawn_radius))??;
        Some((t, self.colour))
    }

    /// The light at `p` from its centre.
    fn of_centre(&self, p: DVec3) -> Arriving {
        let to_lamp = self.position - p;
        let distance = to_lamp.length();
        Arriving {
            d: to_lamp / distance,
            distance,
            light: PI * self.share(p, distance) * self.colour,
            density: None,
        }
    }

    /// The light at the origin of a ray from a direction in which the lamp is, chosen by `u`, uniform over solid angle; or from its
    /// centre.
    pub fn sample(&self, here: Ray, has_extent: bool, u: DVec2) -> Arriving {
        let p = here.o;
        if self.radius == 0.0 || !has_extent {
            return self.of_centre(p);
        }
        let to_lamp = self.position - p;
        let width = self.width(p);
        let cosine = 1.0 - u.x * width;
        let d = around(to_lamp.normalize_or(DVec3::Y), cosine, u.y);
        // A direction along the rim may miss it by rounding.
        let middle = to_lamp.dot(d).max(0.0);
        let distance =
            geometry::sphere(here.turned(d), self.position, self.radius).unwrap_or(middle);
        let density = 1.0 / (TAU * width);
        Arriving {
            d,
            distance,
            light: self.radiance(p) / density,
            density: Some(density),
        }
    }

    /// The distance at which a ray meets the sphere that shines.
    pub fn meet(&self, ray: Ray) -> Option<f64> {
        (self.radius > 0.0).then(|| geometry::sphere(ray, self.position, self.radius))?
    }

    /// The density, over solid angle, with which [`Lamp::sample`] chooses a direction that meets it from `p`.
    pub fn density(&self, p: DVec3) -> f64 {
        1.0 / (TAU * self.width(p))
    }

    /// The radiance of the sphere that shines, seen from `p`: by way of mirrors and glass, where that would be if the way were
    /// straight.
    pub fn radiance(&self, p: DVec3) -> DVec3 {
        // Within the sphere it is that of its surface.
        let distance = self.position.distance(p).max(self.radius);
        let ratio = distance / self.radius;
        self.share(p, distance) * ratio * ratio * self.colour
    }

    /// A point from which it sends light, chosen by `u`, and the normal there: of its sphere, or its centre.
    pub fn point(&self, has_extent: bool, u: DVec2) -> (DVec3, Option<DVec3>) {
        if self.radius == 0.0 || !has_extent {
            return (self.position, None);
        }
        let normal = around(DVec3::Y, 1.0 - 2.0 * u.x, u.y);
        (self.position + self.radius * normal, Some(normal))
    }

    /// The power that it sends into a unit of solid angle and, of a sphere, of the cosine to its normal, for what is lit at `p` if
    /// the way there were straight.
    pub fn power(&self, p: DVec3, has_extent: bool) -> DVec3 {
        if self.radius == 0.0 || !has_extent {
            let distance = self.position.distance(p);
            return PI * distance * distance * self.share(p, distance) * self.colour;
        }
        self.area() * self.radiance(p)
    }

    /// The area of its sphere.
    pub fn area(&self) -> f64 {
        2.0 * TAU * self.radius * self.radius
    }

    /// The cosine at which a ray in direction `d` meets its sphere at `p`.
    pub fn cosine(&self, p: DVec3, d: DVec3) -> f64 {
        (self.position - p).dot(d) / self.radius
    }

    /// One minus the cosine of the half angle at which the sphere that shines is seen from `p`, up to 2 from within.
    fn width(&self, p: DVec3) -> f64 {
        geometry::width(self.radius, self.position.distance(p))
    }

    /// The share of its light that reaches `p`, at a distance along the light's path, by its cone and by falloff.
    fn share(&self, p: DVec3, distance: f64) -> f64 {
        let falloff = self.reference.map_or(1.0, |at| (at / distance).powi(2));
        let cone = self.spot.map_or(1.0, |spot| {
            let cosine = (p - self.position).normalize_or_zero().dot(spot.aim);
            let s = ((cosine - spot.cos_outer) / (spot.cos_inner - spot.cos_outer)).clamp(0.0, 1.0);
            s * s * (3.0 - 2.0 * s)
        });
        falloff * cone
    }
}
