//! Rays and shapes, in scene coordinates.

use super::grooves;
use eightfold_tracer::scene::{Block, Camera, Plane, Shape as BlockShape, Sphere};
use glam::{DMat3, DVec3};

/// The relative rounding error of a few operations in f64.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub o: DVec3,
    /// Of length 1.
    pub d: DVec3,
    /// The rounding error of the origin, in scene units. Outward rays do not hit surfaces within
    /// it; inward rays hit their far sides.
    slack: f64,
}

impl Ray {
    pub fn new(o: DVec3, d: DVec3) -> Self {
        let slack = f64::from(f32::EPSILON) * o.abs().max_element();
        Self { o, d, slack }
    }

    pub fn at(&self, t: f64) -> DVec3 {
        self.o + t * self.d
    }

    pub fn moved(&self, t: f64) -> Self {
        let slack = ROUNDING * (self.o.abs().max_element() + t);
        Self { o: self.at(t), slack, ..*self }
    }

    pub fn turned(&self, d: DVec3) -> Self {
        Self { d, ..*self }
    }
}

pub struct PicturePlane {
    eye: DVec3,
    /// The ray through pixel (x, y) has the direction `corner + x dx + y dy`.
    corner: DVec3,
    dx: DVec3,
    dy: DVec3,
    pub pixel: f64,
}

impl PicturePlane {
    pub fn new(camera: &Camera, width: usize, height: usize) -> Self {
        let eye = camera.eye.as_dvec3();
        let forward = (camera.look_at.as_dvec3() - eye).normalize();
        let right = forward.cross(camera.up.as_dvec3()).normalize();
        let up = right.cross(forward);
        let ratio = f64::from(camera.min_aspect) * height as f64 / width as f64;
        let height_at_1 = 2.0 * (0.5 * f64::from(camera.field_of_view)).tan() * ratio.max(1.0);
        let pixel = height_at_1 / height as f64;
        let (dx, dy) = (right * pixel, up * -pixel);
        let middle = |side: usize| 0.5 * side as f64 - 0.5;
        Self {
            eye,
            corner: forward - dx * middle(width) - dy * middle(height),
            dx,
            dy,
            pixel: dx.length(),
        }
    }

    /// Returns the ray through a point in pixels. The centre of a pixel has integer coordinates.
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let d = self.corner + x * self.dx + y * self.dy;
        Ray::new(self.eye, d.normalize())
    }
}

/// Returns the two distances at which a ray crosses a sphere, or an infinite cylinder if `d` and
/// `oc`, the origin relative to the centre, are perpendicular to its axis.
fn crossings(oc: DVec3, d: DVec3, radius: f64, slack: f64) -> Option<[f64; 2]> {
    let a = d.length_squared();
    let b = oc.dot(d);
    let above = oc.length() - radius;
    if above.abs() <= slack + ROUNDING * radius {
        let other = -2.0 * b / a;
        return Some([other.min(0.0), other.max(0.0)]);
    }
    let off2 = (oc - b / a * d).length_squared();
    let root = ((radius * radius - off2) / a).sqrt();
    // NaN if the ray misses, or runs along the axis.
    root.is_finite().then(|| [-b / a - root, -b / a + root])
}

#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere { centre: DVec3, radius: f64 },
    Plane { centre: DVec3, half_x: f64, half_z: f64 },
    Block { centre: DVec3, half: DVec3, axes: DMat3, shape: BlockShape },
}

#[derive(Clone, Copy, Debug)]
pub struct Met {
    pub t: f64,
    /// Outward, of length 1.
    pub normal: DVec3,
}

impl From<&Sphere> for Shape {
    fn from(sphere: &Sphere) -> Self {
        Self::Sphere { centre: sphere.centre.as_dvec3(), radius: sphere.radius.into() }
    }
}

impl From<&Plane> for Shape {
    fn from(plane: &Plane) -> Self {
        Self::Plane {
            centre: plane.centre.as_dvec3(),
            half_x: plane.half_x.into(),
            half_z: plane.half_z.into(),
        }
    }
}

impl From<&Block> for Shape {
    fn from(block: &Block) -> Self {
        Self::Block {
            centre: block.centre.as_dvec3(),
            half: block.half.as_dvec3(),
            axes: block.axes.as_dmat3(),
            shape: block.shape,
        }
    }
}

impl Shape {
    pub fn meet(&self, ray: Ray, limit: f64) -> Option<Met> {
        let met = match *self {
            Self::Sphere { centre, radius } => sphere(ray, centre, radius)
                .map(|t| Met { t, normal: (ray.at(t) - centre) / radius }),
            Self::Plane { centre, half_x, half_z } => plane(ray, centre, half_x, half_z),
            Self::Block { centre, half, axes, shape } => {
                let own = Ray {
                    o: axes.transpose() * (ray.o - centre),
                    d: axes.transpose() * ray.d,
                    slack: ray.slack + ROUNDING * half.max_element(),
                };
                let bound = half.length() * (1.0 + 1e-6) + own.slack;
                let nearest = own.o - own.o.dot(own.d) * own.d;
                if nearest.length_squared() > bound * bound {
                    return None;
                }
                let met = match shape {
                    BlockShape::Box => cuboid(own, half),
                    BlockShape::Cylinder => cylinder(own, half),
                    _ => capsule(own, half),
                };
                met.map(|met| Met { normal: axes * met.normal, ..met })
            }
        };
        met.filter(|met| met.t < limit)
    }

    /// Returns a point in the object's own axes, from its centre, where patterns are defined.
    pub fn own_coordinates(&self, p: DVec3) -> DVec3 {
        match *self {
            Self::Sphere { centre, .. } => p - centre,
            Self::Plane { centre, .. } => (p - centre).with_y(0.0),
            Self::Block { centre, axes, .. } => axes.transpose() * (p - centre),
        }
    }

    pub fn groove(&self, p: DVec3, n: DVec3) -> DVec3 {
        let (axis, centre) = match *self {
            Self::Sphere { centre, .. } | Self::Plane { centre, .. } => (DVec3::Y, centre),
            Self::Block { centre, axes, .. } => (axes.y_axis, centre),
        };
        grooves::direction(axis, p - centre, n)
    }
}

pub fn sphere(ray: Ray, centre: DVec3, radius: f64) -> Option<f64> {
    let min_t = ray.slack + ROUNDING * radius;
    crossings(ray.o - centre, ray.d, radius, ray.slack)?.into_iter().find(|&t| t > min_t)
}

fn plane(ray: Ray, centre: DVec3, half_x: f64, half_z: f64) -> Option<Met> {
    let above = ray.o.y - centre.y;
    let t = -above / ray.d.y;
    let p = ray.at(t) - centre;
    // False for NaN and infinity, of a parallel ray.
    let is_hit = above.abs() > ray.slack && t > 0.0 && p.x.abs() <= half_x && p.z.abs() <= half_z;
    is_hit.then_some(Met { t, normal: DVec3::Y })
}

/// Returns the distance to the face at `at` on axis `i`: 0 if the ray starts there.
fn face(ray: &Ray, at: f64, i: usize) -> f64 {
    let to_face = at - ray.o[i];
    if to_face.abs() <= ray.slack { 0.0 } else { to_face / ray.d[i] }
}

/// Intersects a box around the origin: a ray hits the last slab that it enters, or the first that
/// it leaves.
fn cuboid(ray: Ray, half: DVec3) -> Option<Met> {
    let [mut enter, mut leave] =
        [f64::NEG_INFINITY, f64::INFINITY].map(|t| Met { t, normal: DVec3::ZERO });
    for i in 0..3 {
        if ray.d[i] == 0.0 {
            if ray.o[i].abs() > half[i] {
                return None;
            }
            continue;
        }
        let side = half[i].copysign(ray.d[i]);
        let normal = DVec3::AXES[i] * ray.d[i].signum();
        let near = Met { t: face(&ray, -side, i), normal: -normal };
        let far = Met { t: face(&ray, side, i), normal };
        enter = if near.t > enter.t { near } else { enter };
        leave = if far.t < leave.t { far } else { leave };
    }
    let is_hit = enter.t <= leave.t && leave.t > 0.0;
    is_hit.then_some(if enter.t > 0.0 { enter } else { leave })
}

fn first(ray: Ray, met: impl Iterator<Item = Met>) -> Option<Met> {
    let ahead = met.filter(|met| met.t > ray.slack);
    ahead.min_by(|a, b| a.t.total_cmp(&b.t))
}

fn side(ray: Ray, radius: f64, height: f64) -> impl Iterator<Item = Met> {
    let (o, d) = (ray.o.with_y(0.0), ray.d.with_y(0.0));
    let met = crossings(o, d, radius, ray.slack).into_iter().flatten();
    met.filter(move |&t| ray.at(t).y.abs() <= height)
        .map(move |t| Met { t, normal: ray.at(t).with_y(0.0) / radius })
}

fn cylinder(ray: Ray, half: DVec3) -> Option<Met> {
    let cap = |end: f64| {
        let t = face(&ray, end * half.y, 1);
        let is_met = ray.at(t).with_y(0.0).length_squared() <= half.x * half.x;
        is_met.then_some(Met { t, normal: end * DVec3::Y })
    };
    let caps = [-1.0, 1.0].into_iter().filter_map(cap);
    first(ray, caps.chain(side(ray, half.x, half.y)))
}

/// Intersects a capsule around the y axis: its side, and the outer half of a sphere at each end.
fn capsule(ray: Ray, half: DVec3) -> Option<Met> {
    let height = half.y - half.x;
    let cap = |end: f64| {
        let centre = end * height * DVec3::Y;
        let met = crossings(ray.o - centre, ray.d, half.x, ray.slack).into_iter().flatten();
        let met = met.map(move |t| Met { t, normal: (ray.at(t) - centre) / half.x });
        met.filter(move |met| end * met.normal.y >= 0.0)
    };
    let caps = [-1.0, 1.0].into_iter().flat_map(cap);
    first(ray, caps.chain(side(ray, half.x, height)))
}
