//! What an object covers of the picture, and what it hides, so that no square is filled over something unseen.
//!
//! In the camera's own axes a ray is (u, v, 1): u to the right, v down. What an object covers are the rays with
//! `n . (u, v, 1) >= k |(u, v, 1)|` for each of its sides: a sphere is a cone, one side with k the cosine of its half
//! angle; a rectangle is what lies between four planes through the eye, with k = 0. The difference of both sides of the
//! inequality is a concave function of u and v, nowhere above its tangent plane, which is greatest at a corner of a
//! square of the picture. So a square that has a side's tangent plane in its middle below 0 at all corners is outside.

use super::screen::Window;
use super::{Node, Prepared, Rectangle};
use crate::lanes::*;
use crate::scene::camera::{Raster, pixels};
use fearless_simd::f32x4;
use glam::Vec3A;

/// The camera's axes, and where its pixels are in the plane at distance 1.
pub(crate) struct Axes {
    right: Vec3A,
    down: Vec3A,
    forward: Vec3A,
    pixel: f32,
    middle_x: f32,
    middle_y: f32,
}

/// An object's outline.
#[derive(Clone, Copy)]
pub(crate) struct Outline {
    /// The sides' vectors n, the components of each side in a lane.
    n: [[f32; 4]; 3],
    /// What is called k above; below -1 where the eye is inside, or nearly.
    cosine: f32,
    /// Around all of it.
    pub window: Window,
    pub centre: Vec3A,
    pub radius: f32,
    /// A sphere's power of the eye, distance squared minus radius squared: of two spheres the one with the smaller power
    /// is in front wherever both are, since the plane of equal powers parts what can be seen of them (Aurenhammer: Power
    /// Diagrams, SIAM Journal on Computing, 1987). Infinite around the eye, and not a number where that is not sure.
    power: f32,
}

/// A place in the picture, as outlines look at it: a rectangle of rays.
#[derive(Clone, Copy)]
struct Patch {
    u: f32,
    v: f32,
    half_u: f32,
    half_v: f32,
    length: f32,
}

/// What rounding may add to a side's inequality, whose terms are below 2.
const ROUNDING: f32 = 1e-5;

/// An eye as near to a sphere as so many times its slack, below which hits are none, is neither outside nor inside for
/// sure.
const TOUCHING: f32 = 4.0;

/// Below this cosine rounding makes the cone of a sphere uncertain by more than [`ROUNDING`].
const LEAST_COSINE: f32 = 0.05;

impl Axes {
    pub const NONE: Self = Self {
        right: Vec3A::ZERO,
        down: Vec3A::ZERO,
        forward: Vec3A::ZERO,
        pixel: 0.0,
        middle_x: 0.0,
        middle_y: 0.0,
    };

    /// The axes of a picture of `width` by `height` pixels.
    pub fn of(raster: &Raster, width: usize, height: usize) -> Self {
        let pixel = raster.dx.length();
        let middle_x = 0.5 * (pixels(width) - 1.0);
        let middle_y = 0.5 * (pixels(height) - 1.0);
        Self {
            right: raster.dx / pixel,
            down: raster.dy / pixel,
            forward: raster.corner + raster.dx * middle_x + raster.dy * middle_y,
            pixel,
            middle_x,
            middle_y,
        }
    }

    /// Has the pixels' samples that much to the left and above.
    #[cfg(feature = "lab")]
    pub fn move_middle(&mut self, by: glam::Vec2) {
        self.middle_x += by.x;
        self.middle_y += by.y;
    }

    /// The rectangle of the picture with these corners, in pixels.
    #[inline(always)]
    fn patch(&self, [left, top, right, bottom]: [f32; 4]) -> Patch {
        let half = 0.5 * self.pixel;
        let u = (left + right - 2.0 * self.middle_x) * half;
        let v = (top + bottom - 2.0 * self.middle_y) * half;
        Patch {
            u,
            v,
            half_u: (right - left) * half,
            half_v: (bottom - top) * half,
            length: libm::sqrtf(u * u + v * v + 1.0),
        }
    }

    /// A vector's components along the axes.
    fn components(&self, d: Vec3A) -> [f32; 3] {
        [d.dot(self.right), d.dot(self.down), d.dot(self.forward)]
    }
}

impl Outline {
    pub const NONE: Self = Self {
        n: [[0.0; 4]; 3],
        cosine: 0.0,
        window: Window::ZERO,
        centre: Vec3A::ZERO,
        radius: 0.0,
        power: 0.0,
    };

    /// A sphere's.
    #[inline(never)]
    pub fn sphere(axes: &Axes, eye: Vec3A, ball: &Node, window: Window) -> Self {
        let (centre, radius) = (ball.centre, ball.radius);
        let to = centre - eye;
        let touching = TOUCHING * ball.slack;
        let distance2 = to.dot(to);
        let distance = libm::sqrtf(distance2);
        let cosine = libm::sqrtf((1.0 - radius * radius / distance2).max(0.0));
        let power = if distance > radius + touching {
            distance2 - radius * radius
        } else if distance + touching < radius {
            f32::INFINITY
        } else {
            f32::NAN
        };
        Self {
            n: axes.components(to / distance).map(|c| [c; 4]),
            cosine: if power < f32::INFINITY && cosine > LEAST_COSINE {
                cosine
            } else {
                -2.0
            },
            window,
            centre,
            radius,
            power,
        }
    }

    /// A horizontal rectangle's.
    #[inline(never)]
    pub fn rectangle(axes: &Axes, eye: Vec3A, plane: &Rectangle) -> Self {
        let Rectangle {
            centre,
            half_x,
            half_z,
        } = *plane;
        let from = eye - centre;
        // A ray d meets the plane at `eye + d h / q`, with q = -d.y or d.y the speed at which it comes nearer, and lies on
        // the inner side of an edge `reach` away along x where `reach q - h d.x >= 0`. Numbers below 1 are as good.
        let scale = 1.0 / (from.y.abs() + half_x + half_z + from.x.abs() + from.z.abs());
        let h = from.y.abs() * scale;
        let q = if from.y < 0.0 { scale } else { -scale };
        let side = |axis: Vec3A| {
            let q = q * axis.y;
            [
                (half_x - from.x) * q - h * axis.x,
                (half_x + from.x) * q + h * axis.x,
                (half_z - from.z) * q - h * axis.z,
                (half_z + from.z) * q + h * axis.z,
            ]
        };
        Self {
            n: [side(axes.right), side(axes.down), side(axes.forward)],
            cosine: 0.0,
            window: Window::ALL,
            centre,
            radius: 0.0,
            power: 0.0,
        }
    }

    /// Whether a ray through the rectangle of the picture with these corners, in pixels, may meet it.
    #[inline(always)]
    pub fn meets<S: Simd>(&self, simd: S, axes: &Axes, rectangle: [f32; 4]) -> bool {
        let patch = axes.patch(rectangle);
        let [a, b, c] = self.n.each_ref().map(|n| f32x4::load_array_ref(simd, n));
        let k = self.cosine / patch.length;
        let slope_u = (a - k * patch.u).abs() * patch.half_u;
        let slope_v = (b - k * patch.v).abs() * patch.half_v;
        let middle = a * patch.u + b * patch.v + c - self.cosine * patch.length;
        let most = middle + slope_u + slope_v;
        // Turned round, so that what is not a number meets.
        !most.simd_lt(f32x4::splat(simd, -ROUNDING)).any_true()
    }
}

impl Prepared {
    /// Whether the rectangle of the picture with these corners, in pixels, may show an object.
    #[inline(never)]
    pub fn may_show<S: Simd>(&self, simd: S, object: usize, rectangle: [f32; 4]) -> bool {
        let outline = &self.outlines[object];
        outline.window.meets(rectangle) && outline.meets(simd, &self.axes, rectangle)
    }

    /// Whether a patch whose corners all see the object `front` cannot see the object `back` anywhere.
    ///
    /// What can be seen of a sphere or a rectangle is convex where one other is between, as long as the eye is outside:
    /// so it covers the patch.
    #[inline(never)]
    pub fn hides(&self, front: usize, back: usize) -> bool {
        let (f, b) = (&self.outlines[front], &self.outlines[back]);
        let first_plane = self.first_plane();
        if front >= self.nothing() {
            return false;
        }
        let above = |plane: &Outline| {
            // How far the eye is from the plane, and the sphere's centre on the eye's side of it.
            let h = self.eye.y - plane.centre.y;
            let sphere = if front < first_plane { f } else { b };
            let y = sphere.centre.y - plane.centre.y;
            (h, if h < 0.0 { -y } else { y })
        };
        match (front < first_plane, back < first_plane) {
            (true, true) => {
                f.power < b.power
                    || f.power == f32::INFINITY && f.centre.distance(b.centre) > f.radius + b.radius
            }
            (true, false) => {
                let (h, y) = above(b);
                if f.power == f32::INFINITY {
                    return y.abs() >= f.radius;
                }
                f.power < f32::INFINITY
                    && (y >= f.radius * TOUCHES || self.is_over(f, back, h.abs()))
            }
            (false, true) => above(f).1 <= -b.radius,
            (false, false) => {
                let (h, k) = (self.eye.y - f.centre.y, self.eye.y - b.centre.y);
                h * k < 0.0 || h.abs() < k.abs()
            }
        }
    }

    /// Whether the eye, `h` above or below a plane, sees nothing but the plane around a sphere.
    fn is_over(&self, sphere: &Outline, plane: usize, h: f32) -> bool {
        let plane = &self.planes[plane - self.first_plane()];
        let to = sphere.centre - self.eye;
        let ahead = if self.eye.y > plane.centre.y {
            -to.y
        } else {
            to.y
        };
        // The sphere is on the inner side of the four planes through the eye and an edge, by more than its radius.
        let within = |to: f32, from: f32, half: f32| {
            let inside =
                |to: f32, reach: f32| reach * ahead - h * to > sphere.radius * (h + reach.abs());
            inside(to, half - from) && inside(-to, half + from)
        };
        let from = self.eye - plane.centre;
        within(to.x, from.x, plane.half_x) && within(to.z, from.z, plane.half_z)
    }
}

/// A sphere stands on a plane, and does not pass through it, up to rounding.
const TOUCHES: f32 = 1.0 - 1e-5;
