//! The light that reaches a point.

use super::geometry::Ray;
use super::{Object, Oracle};
use eightfold_tracer::scene::{Light, Sphere};
use glam::DVec3;

/// Returns the factor on a light's lengths: parallel lights are far away.
pub fn reach(light: &Light) -> f64 {
    if light.parallel {
        f64::from(Light::FAR)
    } else {
        1.0
    }
}

pub fn cone(light: &Light, d: DVec3) -> f64 {
    light.spot.map_or(1.0, |spot| {
        let [outer, inner] =
            [spot.outer_angle, spot.inner_angle].map(|angle| f64::from(angle).cos());
        smooth((d.dot(spot.aim.as_dvec3().normalize()) - outer) / (inner - outer))
    })
}

pub(super) struct ToLight {
    pub l: DVec3,
    pub distance: f64,
}

impl ToLight {
    pub fn new(light: &Light, p: DVec3) -> Self {
        let to_light = reach(light) * light.position.as_dvec3() - p;
        let distance = to_light.length();
        Self {
            l: to_light / distance,
            distance,
        }
    }
}

impl Oracle<'_> {
    /// Returns the share of the light, as a colour, that passes the cone and all shadows.
    pub(super) fn reaching(&self, light: &Light, to_light: &ToLight, ray: Ray) -> DVec3 {
        let ToLight { l, distance } = *to_light;
        let bodies = self.bodies.iter();
        let occluders = bodies.filter(|body| body.shape.meet(ray, distance).is_some());
        let mut share = DVec3::splat(cone(light, -l));
        for object in occluders.map(|body| body.object) {
            match object {
                Object::Block(i) if light.diameter > 0.0 => {
                    share *= self.scene.blocks[i].material.tint.as_dvec3();
                }
                Object::Sphere(_) if light.diameter > 0.0 => {}
                Object::Light(_) => {}
                _ => return DVec3::ZERO,
            }
        }
        if light.diameter == 0.0 {
            return share;
        }
        for s in self.scene.spheres.iter() {
            let passing = penumbra(s, ray.o, to_light, light);
            let tint = s.material.tint.as_dvec3();
            share *= tint + passing * (DVec3::ONE - tint);
        }
        share
    }
}

/// Returns the share of an area light that a sphere does not block, by the formula of the library's `sphere_covers`.
///
/// A sphere that contains both `p` and the whole light blocks nothing: domes are lit from within.
fn penumbra(sphere: &Sphere, p: DVec3, to_light: &ToLight, light: &Light) -> f64 {
    let centre = sphere.centre.as_dvec3();
    let radius = f64::from(sphere.radius);
    // A point within the rounding error counts as on the surface.
    let error = 2e-6 * (centre.abs().max_element() + radius);
    let to_centre = centre - p;
    let a = to_centre.dot(to_light.l).clamp(0.0, to_light.distance);
    let off = (to_centre - a * to_light.l).length() + error - radius;
    let size = reach(light) * f64::from(light.diameter);
    let b = a * size / to_light.distance;
    let centre_to_light = to_centre - to_light.distance * to_light.l;
    let is_dome =
        to_centre.length() <= radius + error && centre_to_light.length() + 0.5 * size <= radius;
    if is_dome {
        return 1.0;
    }
    if b == 0.0 {
        return f64::from(u8::from(off > 0.0));
    }
    smooth(off / b + 0.5)
}

fn smooth(tau: f64) -> f64 {
    let tau = tau.clamp(0.0, 1.0);
    tau * tau * (3.0 - 2.0 * tau)
}
