//! Rays and the shapes that they hit, in f64. Coordinates are the scene's.

use eightfold::glam::{DMat3, DVec3, Mat3};
use eightfold::scene::{Block, Plane, Shape as BlockShape, Sphere};
use eightfold_oracle::grooves;

/// The smallest distance that counts as a hit, in scene units: more than the rounding error of a root for a ray that touches a
/// sphere, which is about the square root of that of f64.
pub const T_MIN: f64 = 1e-6;

/// A ray.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// The origin.
    pub o: DVec3,
    /// The direction, of length 1.
    pub d: DVec3,
}

impl Ray {
    /// The point at a distance.
    pub fn at(&self, t: f64) -> DVec3 {
        self.o + t * self.d
    }
}

/// A shape.
#[derive(Clone, Copy, Debug)]
pub enum Shape {
    Sphere {
        centre: DVec3,
        radius: f64,
    },
    /// A horizontal rectangle.
    Plane {
        centre: DVec3,
        half_x: f64,
        half_z: f64,
    },
    /// A box, or a cylinder about its own y axis.
    Block {
        centre: DVec3,
        half: DVec3,
        axes: DMat3,
        is_cylinder: bool,
    },
}

/// Where a ray meets a shape.
#[derive(Clone, Copy, Debug)]
pub struct Met {
    /// The distance along the ray.
    pub t: f64,
    /// The outward normal, of length 1.
    pub normal: DVec3,
}

impl From<&Sphere> for Shape {
    fn from(sphere: &Sphere) -> Self {
        Self::Sphere {
            centre: sphere.centre.as_dvec3(),
            radius: sphere.radius.into(),
        }
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
            axes: Mat3::from(block.axes).as_dmat3(),
            is_cylinder: block.shape == BlockShape::Cylinder,
        }
    }
}

impl Shape {
    /// Where a ray first meets it, between [`T_MIN`] and `limit`.
    pub fn meet(&self, ray: Ray, limit: f64) -> Option<Met> {
        let met = match *self {
            Self::Sphere { centre, radius } => sphere(ray, centre, radius).map(|t| Met {
                t,
                normal: (ray.at(t) - centre) / radius,
            }),
            Self::Plane {
                centre,
                half_x,
                half_z,
            } => plane(ray, centre, half_x, half_z),
            Self::Block {
                centre,
                half,
                axes,
                is_cylinder,
            } => {
                let own = Ray {
                    o: axes.transpose() * (ray.o - centre),
                    d: axes.transpose() * ray.d,
                };
                // Its bounding sphere is met by few rays.
                let bound = half.length() * (1.0 + 1e-9) + T_MIN;
                let nearest = own.o - own.o.dot(own.d) * own.d;
                if nearest.length_squared() > bound * bound {
                    return None;
                }
                let met = if is_cylinder {
                    cylinder(own, half)
                } else {
                    cuboid(own, half)
                };
                met.map(|met| Met {
                    normal: axes * met.normal,
                    ..met
                })
            }
        };
        met.filter(|met| met.t < limit)
    }

    /// Its centre.
    pub fn centre(&self) -> DVec3 {
        match *self {
            Self::Sphere { centre, .. }
            | Self::Plane { centre, .. }
            | Self::Block { centre, .. } => centre,
        }
    }

    /// One minus the cosine of the half angle at which a sphere around it is seen from `p`; 2, for all directions, from within that.
    pub fn width_from(&self, p: DVec3) -> f64 {
        let radius = match *self {
            Self::Sphere { radius, .. } => radius,
            Self::Plane { half_x, half_z, .. } => half_x.hypot(half_z),
            Self::Block { half, .. } => half.length(),
        };
        width(radius, self.centre().distance(p))
    }

    /// A point on it, from its centre along its own axes, in which patterns are painted.
    pub fn own_coordinates(&self, p: DVec3) -> DVec3 {
        match *self {
            Self::Sphere { centre, .. } => p - centre,
            Self::Plane { centre, .. } => (p - centre).with_y(0.0),
            Self::Block { centre, axes, .. } => axes.transpose() * (p - centre),
        }
    }

    /// The direction of the grooves around its own y axis at a point of it with the normal `n`.
    pub fn groove(&self, p: DVec3, n: DVec3) -> DVec3 {
        let (axis, centre) = match *self {
            Self::Sphere { centre, .. } | Self::Plane { centre, .. } => (DVec3::Y, centre),
            Self::Block { centre, axes, .. } => (axes.y_axis, centre),
        };
        grooves::direction(axis, p - centre, n)
    }
}

/// One minus the cosine of the half angle at which a sphere is seen from a distance to its centre; 2 from within.
pub fn width(radius: f64, distance: f64) -> f64 {
    let sine2 = (radius / distance).powi(2);
    if sine2 < 1.0 {
        // 1 - cos, without losing digits where the angle is small.
        sine2 / (1.0 + (1.0 - sine2).sqrt())
    } else {
        2.0
    }
}

/// The distance at which a ray meets a sphere.
pub fn sphere(ray: Ray, centre: DVec3, radius: f64) -> Option<f64> {
    let to_centre = centre - ray.o;
    let middle = to_centre.dot(ray.d);
    let off = to_centre - middle * ray.d;
    let discriminant = radius * radius - off.length_squared();
    if discriminant < 0.0 {
        return None;
    }
    let half = discriminant.sqrt();
    [middle - half, middle + half]
        .into_iter()
        .find(|&t| t > T_MIN)
}

fn plane(ray: Ray, centre: DVec3, half_x: f64, half_z: f64) -> Option<Met> {
    let t = (centre.y - ray.o.y) / ray.d.y;
    let p = ray.at(t) - centre;
    // NaN and infinity, for a ray along the plane, fail these comparisons.
    let is_hit = t > T_MIN && p.x.abs() <= half_x && p.z.abs() <= half_z;
    is_hit.then_some(Met {
        t,
        normal: DVec3::Y,
    })
}

/// Where a ray meets a box about the origin: the last of the three slabs to be entered, or the first to be left.
fn cuboid(ray: Ray, half: DVec3) -> Option<Met> {
    let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut enter_axis, mut leave_axis) = (0, 0);
    for i in 0..3 {
        if ray.d[i] == 0.0 {
            if ray.o[i].abs() > half[i] {
                return None;
            }
            continue;
        }
        let side = half[i].copysign(ray.d[i]);
        let (near, far) = ((-side - ray.o[i]) / ray.d[i], (side - ray.o[i]) / ray.d[i]);
        if near > enter {
            (enter, enter_axis) = (near, i);
        }
        if far < leave {
            (leave, leave_axis) = (far, i);
        }
    }
    let face = |axis: usize, sign: f64| DVec3::AXES[axis] * sign * ray.d[axis].signum();
    if enter > leave || leave <= T_MIN {
        None
    } else if enter > T_MIN {
        Some(Met {
            t: enter,
            normal: face(enter_axis, -1.0),
        })
    } else {
        Some(Met {
            t: leave,
            normal: face(leave_axis, 1.0),
        })
    }
}

/// Where a ray meets a cylinder about the y axis through the origin: its caps and its side.
fn cylinder(ray: Ray, half: DVec3) -> Option<Met> {
    let mut nearest: Option<Met> = None;
    let mut add = |t: f64, normal: DVec3| {
        if t > T_MIN && nearest.is_none_or(|met| t < met.t) {
            nearest = Some(Met { t, normal });
        }
    };
    let radius2 = half.x * half.x;
    for side in [-1.0, 1.0] {
        let t = (side * half.y - ray.o.y) / ray.d.y;
        let p = ray.at(t);
        // NaN, for a ray in the cap's plane, fails this comparison.
        if p.x * p.x + p.z * p.z <= radius2 {
            add(t, side * DVec3::Y);
        }
    }
    let (o, d) = (ray.o.with_y(0.0), ray.d.with_y(0.0));
    let (a, b) = (d.length_squared(), o.dot(d));
    let root = (b * b - a * (o.length_squared() - radius2)).sqrt();
    for t in [(-b - root) / a, (-b + root) / a] {
        let p = ray.at(t);
        // NaN, without a root, fails this comparison.
        if p.y.abs() <= half.y {
            add(t, p.with_y(0.0) / half.x);
        }
    }
    nearest
}
