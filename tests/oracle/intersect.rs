//! Ray intersections by textbook formulas.

use super::{Object, Oracle, Ray};
use eightfold::scene::{Block, Light, Plane, Shape};
use glam::{DVec3, Vec3A};

/// The smallest distance that counts as a hit. The error of the roots for a ray that touches a sphere is about the square root of
/// the rounding error of f64.
const T_MIN: f64 = 1e-6;

impl Oracle<'_> {
    /// The nearest object along a ray, and its distance.
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
            .chain(lights.map(|(i, l)| (Object::Light(i), light_sphere(ray, l))));
        hits.filter_map(|(object, t)| Some((object, t?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or((Object::Background, f64::INFINITY))
    }

    /// Whether a ray hits a sphere nearer than `distance`.
    pub(super) fn blocked_by_spheres(&self, ray: Ray, distance: f64) -> bool {
        let mut spheres = self.scene.spheres.iter();
        spheres.any(|s| is_within(sphere(ray, s.centre, s.radius), distance))
    }

    /// Whether a ray hits a plane nearer than `distance`.
    pub(super) fn blocked_by_planes(&self, ray: Ray, distance: f64) -> bool {
        let mut planes = self.scene.planes.iter();
        planes.any(|p| is_within(plane(ray, p), distance))
    }
}

/// Whether there is a hit nearer than `limit`.
pub(super) fn is_within(t: Option<f64>, limit: f64) -> bool {
    t.is_some_and(|t| t < limit)
}

/// The distance to the sphere that shows a light.
fn light_sphere(ray: Ray, light: &Light) -> Option<f64> {
    let is_drawn = light.radius > 0.0 && !light.parallel;
    is_drawn.then(|| sphere(ray, light.position, light.radius))?
}

/// The distance to a box or a cylinder, and the outward normal there.
pub(super) fn block(ray: Ray, it: &Block) -> Option<(f64, DVec3)> {
    let axes = glam::Mat3::from(it.axes).as_dmat3();
    let half = it.half.as_dvec3();
    let is_cylinder = it.shape == Shape::Cylinder;
    let o = axes.transpose() * (ray.o - it.centre.as_dvec3());
    let d = axes.transpose() * ray.d;
    let mut hits: Vec<(f64, DVec3)> = Vec::new();
    // The flat faces: their planes, if hit inside the face.
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
            // NaN, without a root, fails this comparison.
            if p.y.abs() <= half.y {
                hits.push((t, axes * (DVec3::new(p.x, 0.0, p.z) / half.x)));
            }
        }
    }
    let ahead = hits.into_iter().filter(|hit| hit.0 > T_MIN);
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
    [b - half, b + half].into_iter().find(|&t| t > T_MIN)
}

/// The distance to a plane.
fn plane(ray: Ray, plane: &Plane) -> Option<f64> {
    let from_centre: DVec3 = ray.o - plane.centre.as_dvec3();
    let t = -from_centre.y / ray.d.y;
    let p = from_centre + t * ray.d;
    let inside = p.x.abs() <= f64::from(plane.half_x) && p.z.abs() <= f64::from(plane.half_z);
    (t > T_MIN && t.is_finite() && inside).then_some(t)
}
