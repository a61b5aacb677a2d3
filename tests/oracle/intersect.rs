//! Ray intersections by textbook formulas.

use super::{Object, Oracle, Ray};
use eightfold_tracer::scene::{Block, Light, Plane, Shape};
use glam::{DVec3, Vec3A};

/// The rounding error of a few operations in f64, relative to the lengths in them.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

impl Ray {
    /// A ray from a place that a scene names, by numbers of 32 bits.
    pub(super) fn from_scene(o: DVec3, d: DVec3) -> Self {
        let slack = f64::from(f32::EPSILON) * o.abs().max_element();
        Self { o, d, slack }
    }

    /// A ray from where this one hits something at the distance `t`.
    pub(super) fn onward(&self, t: f64, d: DVec3) -> Self {
        let o = self.o + t * self.d;
        let slack = ROUNDING * (self.o.abs().max_element() + t);
        Self { o, d, slack }
    }
}

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
    let o = axes.transpose() * (ray.o - it.centre.as_dvec3());
    let d = axes.transpose() * ray.d;
    let slack = ray.slack + ROUNDING * half.max_element();
    let mut hits: Vec<(f64, DVec3)> = Vec::new();
    // The flat faces: their planes, if hit inside the face.
    let flat: &[usize] = match it.shape {
        Shape::Box => &[0, 1, 2],
        Shape::Cylinder => &[1],
    };
    for &i in flat {
        for side in [-1.0, 1.0] {
            let to_face = side * half[i] - o[i];
            let t = to_face / d[i];
            let p = o + t * d;
            let is_inside = match it.shape {
                Shape::Box => (0..3).all(|j| j == i || p[j].abs() <= half[j]),
                Shape::Cylinder => p.x * p.x + p.z * p.z <= half.x * half.x,
            };
            if t.is_finite() && is_inside && to_face.abs() > slack {
                hits.push((t, side * axes.col(i)));
            }
        }
    }
    match it.shape {
        Shape::Box => {}
        Shape::Cylinder => {
            let (across, along) = (o.with_y(0.0), d.with_y(0.0));
            for t in round(across, along, half.x, slack) {
                let p = o + t * d;
                if p.y.abs() <= half.y {
                    hits.push((t, axes * (p.with_y(0.0) / half.x)));
                }
            }
        }
    }
    let ahead = hits.into_iter().filter(|hit| hit.0 > 0.0);
    ahead.min_by(|a, b| a.0.total_cmp(&b.0))
}

/// The distances to a sphere about the origin, or to a cylinder along whose axis `o` and `d` have no part. A ray that starts within
/// `slack` of it starts on it, and hits only its far side.
fn round(o: DVec3, d: DVec3, radius: f64, slack: f64) -> Vec<f64> {
    let a = d.length_squared();
    let nearest = -o.dot(d) / a;
    let is_on = (o.length() - radius).abs() <= slack;
    let half = ((radius * radius - (o + nearest * d).length_squared()) / a).sqrt();
    let roots = if is_on {
        vec![2.0 * nearest]
    } else {
        vec![nearest - half, nearest + half]
    };
    // NaN, without a root or along the axis, fails this comparison.
    roots.into_iter().filter(|&t| t > slack).collect()
}

/// The distance to a sphere.
fn sphere(ray: Ray, centre: Vec3A, radius: f32) -> Option<f64> {
    let radius = f64::from(radius);
    let slack = ray.slack + ROUNDING * radius;
    let hits = round(ray.o - centre.as_dvec3(), ray.d, radius, slack);
    hits.first().copied()
}

/// The distance to a plane.
fn plane(ray: Ray, plane: &Plane) -> Option<f64> {
    let from_centre: DVec3 = ray.o - plane.centre.as_dvec3();
    let t = -from_centre.y / ray.d.y;
    let p = from_centre + t * ray.d;
    let inside = p.x.abs() <= f64::from(plane.half_x) && p.z.abs() <= f64::from(plane.half_z);
    (from_centre.y.abs() > ray.slack && t > 0.0 && t.is_finite() && inside).then_some(t)
}
