//! Where a ray hits, by the formulas of any textbook.

use super::{Object, Oracle, Ray};
use eightfold::scene::Plane;
use glam::{DVec3, Vec3};

/// Hits nearer than this are none: what the roots of a ray along a sphere are off by, the root of f64's rounding.
const NEAREST: f64 = 1e-6;

impl Oracle<'_> {
    /// The nearest object and its distance.
    pub(super) fn nearest(&self, ray: Ray) -> (Object, f64) {
        let scene = self.scene;
        let spheres = scene.spheres.iter().enumerate();
        let planes = scene.planes.iter().enumerate();
        let lights = scene.lights.iter().enumerate();
        let hits = spheres
            .map(|(i, s)| (Object::Sphere(i), sphere(ray, s.centre, s.radius)))
            .chain(planes.map(|(i, p)| (Object::Plane(i), plane(ray, p))))
            .chain(lights.map(|(i, l)| (Object::Light(i), sphere(ray, l.position, l.radius))));
        hits.filter_map(|(object, t)| Some((object, t?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or((Object::Nothing, f64::INFINITY))
    }

    /// Whether anything that casts a shadow is hit nearer than `distance`.
    pub(super) fn blocked(&self, ray: Ray, distance: f64) -> bool {
        let within = |t: Option<f64>| t.is_some_and(|t| t < distance);
        let mut spheres = self.scene.spheres.iter();
        let mut planes = self.scene.planes.iter();
        spheres.any(|s| within(sphere(ray, s.centre, s.radius)))
            || planes.any(|p| within(plane(ray, p)))
    }
}

/// The distance to a sphere.
fn sphere(ray: Ray, centre: Vec3, radius: f32) -> Option<f64> {
    let to_centre = centre.as_dvec3() - ray.o;
    let b = to_centre.dot(ray.d);
    let perpendicular = to_centre - b * ray.d;
    let discriminant = f64::from(radius).powi(2) - perpendicular.length_squared();
    if discriminant < 0.0 {
        return None;
    }
    let half = discriminant.sqrt();
    [b - half, b + half].into_iter().find(|&t| t > NEAREST)
}

/// The distance to a plane.
fn plane(ray: Ray, plane: &Plane) -> Option<f64> {
    let from_centre: DVec3 = ray.o - plane.centre.as_dvec3();
    let t = -from_centre.y / ray.d.y;
    let p = from_centre + t * ray.d;
    let inside = p.x.abs() <= f64::from(plane.half_x) && p.z.abs() <= f64::from(plane.half_z);
    (t > NEAREST && t.is_finite() && inside).then_some(t)
}
