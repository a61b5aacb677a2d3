//! Where a ray hits, by the formulas of any textbook.

use super::{Object, Oracle, Ray};
use eightfold::scene::{Block, Light, Plane, Shape};
use glam::{DVec3, Vec3A};

/// Hits nearer than this are none: what the roots of a ray along a sphere are off by, the root of f64's rounding.
const NEAREST: f64 = 1e-6;

impl Oracle<'_> {
    /// The nearest object and its distance.
    pub(super) fn nearest(&self, ray: Ray) -> (Object, f64) {
        let scene = self.scene;
        let spheres = scene.spheres.iter().enumerate();
        let planes = scene.planes.iter().enumerate();
        let blocks = scene.blocks.iter().enumerate();
        let lights = scene.lights.iter().enumerate();
        let hits = spheres
            .map(|(i, s)| (Object::Sphere(i), sphere(ray, s.centre, s.radius)))
            .chain(planes.map(|(i, p)| (Object::Plane(i), plane(ray, p))))
            .chain(blocks.map(|(i, s)| (Object::Block(i), block(ray, s).map(|hit| hit.0))))
            .chain(lights.map(|(i, l)| (Object::Light(i), lamp(ray, l))));
        hits.filter_map(|(object, t)| Some((object, t?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or((Object::Background, f64::INFINITY))
    }

    /// Whether a sphere that casts a shadow is hit nearer than `distance`.
    pub(super) fn blocked_by_spheres(&self, ray: Ray, distance: f64) -> bool {
        let mut spheres = self.scene.spheres.iter();
        spheres.any(|s| is_within(sphere(ray, s.centre, s.radius), distance))
    }

    /// Whether a plane is hit nearer than `distance`.
    pub(super) fn blocked_by_planes(&self, ray: Ray, distance: f64) -> bool {
        let mut planes = self.scene.planes.iter();
        planes.any(|p| is_within(plane(ray, p), distance))
    }
}

/// Whether a distance is below a limit.
pub(super) fn is_within(t: Option<f64>, limit: f64) -> bool {
    t.is_some_and(|t| t < limit)
}

/// The distance to the sphere a light is drawn as.
fn lamp(ray: Ray, light: &Light) -> Option<f64> {
    let is_drawn = light.radius > 0.0 && !light.parallel;
    is_drawn.then(|| sphere(ray, light.position, light.radius))?
}

/// The distance to a box or a cylinder, and the normal there, outward.
pub(super) fn block(ray: Ray, it: &Block) -> Option<(f64, DVec3)> {
    let axes = glam::Mat3::from(it.axes).as_dmat3();
    let half = it.half.as_dvec3();
    let is_cylinder = it.shape == Shape::Cylinder;
    let o = axes.transpose() * (ray.o - it.centre.as_dvec3());
    let d = axes.transpose() * ray.d;
    let mut hits: Vec<(f64, DVec3)> = Vec::new();
    // Each side's plane, and whether it is hit between the other sides.
    for i in 0..3 {
        if is_cylinder && i != 1 {
            continue;
        }
        for side in [-1.0, 1.0] {
            let t = (side * half[i] - o[i]) / d[i];
            let p = o + t * d;
            let is_inside = if is_cylinder {
                p.x * p.x + p.z * p.z <= half.x * half.x
            } else {
                (0..3).all(|j| j == i || p[j].abs() <= half[j])
            };
            if t.is_finite() && is_inside {
                hits.push((t, side * axes.col(i)));
            }
        }
    }
    if is_cylinder {
        let a = d.x * d.x + d.z * d.z;
        let b = o.x * d.x + o.z * d.z;
        let root = (b * b - a * (o.x * o.x + o.z * o.z - half.x * half.x)).sqrt();
        for t in [(-b - root) / a, (-b + root) / a] {
            let p = o + t * d;
            // Not where there is no root.
            if p.y.abs() <= half.y {
                hits.push((t, axes * (DVec3::new(p.x, 0.0, p.z) / half.x)));
            }
        }
    }
    let ahead = hits.into_iter().filter(|hit| hit.0 > NEAREST);
    ahead.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The distance to a sphere.
fn sphere(ray: Ray, centre: Vec3A, radius: f32) -> Option<f64> {
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
