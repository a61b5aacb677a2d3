//! What reaches a place of a light.

use super::intersect::{block, is_within};
use super::{Oracle, Ray};
use eightfold::scene::{Light, Sphere};
use glam::DVec3;

/// A light seen from a place.
pub(super) struct Seen {
    /// Towards it, of length 1.
    pub l: DVec3,
    pub distance: f64,
}

impl Seen {
    /// From `p`.
    pub fn new(light: &Light, p: DVec3) -> Self {
        let far = if light.parallel {
            f64::from(Light::FAR)
        } else {
            1.0
        };
        let to_light = far * light.position.as_dvec3() - p;
        let distance = to_light.length();
        Self {
            l: to_light / distance,
            distance,
        }
    }
}

impl Oracle<'_> {
    /// The share of a light that reaches `p` through its cone and past all that throws shadows, as a colour.
    pub(super) fn reaching(&self, light: &Light, seen: &Seen, p: DVec3) -> DVec3 {
        let Seen { l, distance } = *seen;
        let ray = Ray { o: p, d: l };
        let cone = light.spot.map_or(1.0, |spot| {
            let (dark, bright) = (f64::from(spot.dark), f64::from(spot.bright));
            let cosine = -l.dot(spot.aim.as_dvec3());
            smooth((cosine - dark) / (bright - dark))
        });
        if self.blocked_by_planes(ray, distance) {
            return DVec3::ZERO;
        }
        if light.size == 0.0 {
            let mut blocks = self.scene.blocks.iter();
            let is_dark = self.blocked_by_spheres(ray, distance)
                || blocks.any(|s| is_within(block(ray, s).map(|hit| hit.0), distance));
            return DVec3::splat(if is_dark { 0.0 } else { cone });
        }
        let mut share = DVec3::splat(cone);
        for s in self.scene.blocks.iter() {
            if is_within(block(ray, s).map(|hit| hit.0), distance) {
                share *= s.material.tint.as_dvec3();
            }
        }
        for s in self.scene.spheres.iter() {
            let passing = penumbra(s, p, seen, light);
            let tint = s.material.tint.as_dvec3();
            share *= tint + passing * (DVec3::ONE - tint);
        }
        share
    }
}

/// The share of a light with a size that a sphere lets pass (after Parker, Shirley and Smits: Single Sample Soft Shadows,
/// 1998).
///
/// From `p` the light is a cone; where it passes the sphere, `a` away, it is as wide as `b = a size / distance`. The
/// sphere's edge crosses it from one side to the other as the shadow goes from none to full.
fn penumbra(sphere: &Sphere, p: DVec3, seen: &Seen, light: &Light) -> f64 {
    let centre = sphere.centre.as_dvec3();
    let radius = f64::from(sphere.radius);
    // What lies on the surface by rounding lies on it.
    let slack = 2e-6 * (centre.abs().max_element() + radius);
    let to_centre = centre - p;
    let a = to_centre.dot(seen.l).clamp(0.0, seen.distance);
    let off = (to_centre - a * seen.l).length() + slack - radius;
    let far = if light.parallel {
        f64::from(Light::FAR)
    } else {
        1.0
    };
    let b = a * far * f64::from(light.size) / seen.distance;
    if b == 0.0 {
        return f64::from(u8::from(off > 0.0));
    }
    smooth(off / b + 0.5)
}

/// From 0 at 0 to 1 at 1, level at both ends and beyond.
fn smooth(tau: f64) -> f64 {
    let tau = tau.clamp(0.0, 1.0);
    tau * tau * (3.0 - 2.0 * tau)
}
