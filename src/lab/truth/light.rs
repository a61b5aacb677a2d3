//! Lights have no falloff: at any distance, colour c gives a facing surface the irradiance pi c. So
//! a sphere of radius R at path length D, via mirrors and glass, has the radiance c (D / R)^2.

use eightfold_oracle::geometry::{Ray, sphere};
use eightfold_oracle::light::{cone, reach};
use eightfold_tracer::glam::{DVec2, DVec3};
use eightfold_tracer::scene::Light;
use std::f64::consts::{PI, TAU};

pub struct SphereLight<'a> {
    light: &'a Light,
    position: DVec3,
    /// 0 for a point.
    radius: f64,
}

pub struct Arriving {
    pub d: DVec3,
    pub distance: f64,
    /// At normal incidence.
    pub irradiance: DVec3,
}

impl<'a> SphereLight<'a> {
    pub fn new(light: &'a Light) -> Self {
        Self {
            light,
            position: reach(light) * light.position.as_dvec3(),
            radius: 0.5 * reach(light) * f64::from(light.diameter),
        }
    }

    /// Samples the light uniformly in solid angle.
    pub fn sample(&self, here: Ray, u: DVec2) -> Arriving {
        let to_light = self.position - here.o;
        let axis = to_light.normalize_or(DVec3::Y);
        let sine2 = (self.radius / to_light.length()).powi(2);
        // `width`: 1 - cos(angular radius); `gain`: radiance times solid angle, relative to a point
        // light.
        let (width, gain) = if sine2 < 1.0 {
            let half = 1.0 / (1.0 + (1.0 - sine2).sqrt());
            (sine2 * half, 2.0 * half)
        } else {
            (2.0, 4.0)
        };
        let d = around(axis, 1.0 - u.x * width, u.y);
        // Points, and rounded directions to the rim, can miss.
        let distance = sphere(here.turned(d), self.position, self.radius);
        Arriving {
            d,
            distance: distance.unwrap_or(to_light.dot(d).max(0.0)),
            irradiance: PI * gain * cone(self.light, -axis) * self.light.colour.as_dvec3(),
        }
    }

    /// Returns the radiance, 0 from `limit` on; `length` is the path from the lit surface to the
    /// ray's origin.
    pub fn radiance(&self, ray: Ray, length: f64, limit: f64) -> DVec3 {
        let met = sphere(ray, self.position, self.radius);
        if self.radius == 0.0 || met.is_none_or(|t| t >= limit) {
            return DVec3::ZERO;
        }
        // Unfold the path to a line.
        let to_surface = ray.at(-length) - self.position;
        let ratio = (to_surface.length() / self.radius).max(1.0);
        let share = cone(self.light, to_surface.normalize_or_zero());
        ratio * ratio * share * self.light.colour.as_dvec3()
    }

    pub fn hit(&self, ray: Ray) -> Option<(f64, DVec3)> {
        let radius = f64::from(self.light.drawn_radius);
        let is_drawn = radius > 0.0 && !self.light.parallel;
        let t = is_drawn.then(|| sphere(ray, self.position, radius))??;
        Some((t, self.light.colour.as_dvec3()))
    }
}

/// Returns the unit vector at `cosine` to the unit `axis`; `turn` is the azimuth, 0 to 1.
pub fn around(axis: DVec3, cosine: f64, turn: f64) -> DVec3 {
    let (u, v) = axis.any_orthonormal_pair();
    let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
    let (y, x) = (TAU * turn).sin_cos();
    (cosine * axis + sine * (x * u + y * v)).normalize()
}
