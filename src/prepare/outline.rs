//! What an object covers of the picture, and what it hides, so that no square is filled over something unseen.
//!
//! What an object covers are the rays with `n . (u, v, 1) >= k |(u, v, 1)|` for each of its sides: a sphere is a cone, one
//! side with k the cosine of its half angle; a rectangle is what lies between four planes through the eye, with k = 0. The
//! difference of both sides of the inequality is a concave function of u and v, nowhere above its tangent plane, which is
//! greatest at a corner of a square of the picture. So a square that has a side's tangent plane in its middle below 0 at
//! all corners is outside.

use super::screen::{Axes, Rect, Window};
use super::{Node, Prepared, ROOM, Rectangle};
use crate::scene::MAX_PLANES;
use glam::{Vec3A, Vec3Swizzles, Vec4, Vec4Swizzles};

/// An object's outline.
#[derive(Clone, Copy)]
pub(crate) struct Outline {
    /// The sides' vectors n, the components of each side in a lane.
    n: [Vec4; 3],
    /// What is called k above; below -1 where the eye is inside, or nearly.
    cosine: f32,
    /// Around all of it.
    pub window: Window,
    centre: Vec3A,
    radius: f32,
    /// Whether it is a sphere around a box or a cylinder.
    is_block: bool,
    /// A sphere's power of the eye, distance squared minus radius squared: of two spheres the one with the smaller power
    /// is in front wherever both are, since the plane of equal powers parts what can be seen of them (Aurenhammer: Power
    /// Diagrams, SIAM Journal on Computing, 1987). Infinite around the eye, and not a number where that is not sure.
    power: f32,
}

/// What rounding may add to a side's inequality, whose terms are below 2.
const ROUNDING: f32 = 1e-5;

/// An eye as near to a sphere as so many times its slack, below which hits are none, is neither outside nor inside for
/// sure.
const TOUCHING: f32 = 4.0;

/// Below this cosine rounding makes the cone of a sphere uncertain by more than [`ROUNDING`].
const LEAST_COSINE: f32 = 0.05;

impl Outline {
    pub const NONE: Self = Self {
        n: [Vec4::ZERO; 3],
        cosine: 0.0,
        window: Window::ZERO,
        centre: Vec3A::ZERO,
        radius: 0.0,
        is_block: false,
        power: 0.0,
    };

    /// Takes in a sphere, `to` from the eye.
    pub fn set_sphere(&mut self, axes: &Axes, to: Vec3A, ball: &Node) {
        let radius = ball.radius;
        let distance2 = to.length_squared();
        let distance = libm::sqrtf(distance2);
        let power = distance2 - radius * radius;
        let cosine = libm::sqrtf(power / distance2);
        self.power = if (distance - radius).abs() > TOUCHING * ball.slack {
            if power < 0.0 && !ball.is_block {
                f32::INFINITY
            } else {
                power
            }
        } else {
            f32::NAN
        };
        // Nor is it above where it is not a number.
        self.cosine = if cosine > LEAST_COSINE { cosine } else { -2.0 };
        self.n = axes.seen(to / distance).to_array().map(Vec4::splat);
        self.window = axes.window(to, radius);
        self.centre = ball.centre;
        self.radius = radius;
        self.is_block = ball.is_block;
    }

    /// Takes in a horizontal rectangle.
    pub fn set_rectangle(&mut self, axes: &Axes, eye: Vec3A, plane: &Rectangle) {
        for (n, axis) in self.n.iter_mut().zip(axes.rows) {
            *n = plane.sides(eye, axis).0;
        }
        self.cosine = 0.0;
        self.window = Window::ALL;
        self.centre = plane.centre;
        self.radius = 0.0;
        self.is_block = false;
        self.power = f32::INFINITY;
    }

    /// Whether a ray through a rectangle of the picture may meet it.
    fn meets(&self, rect: Rect) -> bool {
        let middle = (rect + rect.zwxy()) * 0.5;
        let half = (rect.zwxy() - rect) * 0.5;
        let (u, v) = (middle.x, middle.y);
        let length = libm::sqrtf(u * u + v * v + 1.0);
        let [a, b, c] = self.n;
        let k = self.cosine / length;
        let slopes = (a - k * u).abs() * half.x + (b - k * v).abs() * half.y;
        let most = a * u + b * v + c - self.cosine * length + slopes;
        // Turned round, so that what is not a number meets.
        !most.cmplt(Vec4::splat(-ROUNDING)).any()
    }
}

impl Rectangle {
    /// How far on the inner side of the four planes through the eye and an edge a direction leads, and how far at most for
    /// its length.
    ///
    /// A ray d meets the plane at `eye + d h / q`, with q = -d.y or d.y the speed at which it comes nearer, and lies on
    /// the inner side of an edge `reach` away along x where `reach q - h d.x >= 0`. Numbers below 1 are as good.
    #[inline(never)]
    fn sides(&self, eye: Vec3A, d: Vec3A) -> (Vec4, Vec4) {
        let from = eye - self.centre;
        let reach = Vec4::new(self.half_x, self.half_x, self.half_z, self.half_z)
            + from.xxzz() * Vec4::new(-1.0, 1.0, -1.0, 1.0);
        let h = from.y.abs();
        let scale = 1.0 / (reach.element_sum() + from.abs().element_sum());
        let across = d.xxzz() * Vec4::new(-h, h, -h, h);
        let q = if from.y < 0.0 { d.y } else { -d.y };
        ((reach * q + across) * scale, (reach.abs() + h) * scale)
    }
}

impl Prepared {
    /// Whether a rectangle of the picture may show an object.
    #[inline(never)]
    pub fn may_show(&self, object: usize, rect: Rect) -> bool {
        let outline = &self.outlines[object % ROOM];
        outline.window.meets(rect) && outline.meets(rect)
    }

    /// Whether a patch whose corners all see the object `front` cannot see the object `back` anywhere.
    ///
    /// What can be seen of an object is convex where one other is between, as long as the eye is outside: so it covers the
    /// patch.
    #[inline(never)]
    pub fn hides(&self, front: usize, back: usize) -> bool {
        let (f, b) = (&self.outlines[front % ROOM], &self.outlines[back % ROOM]);
        let first_plane = self.first_plane();
        // How far above a plane an object is, taken from the eye's side of the plane.
        let over = |object: &Outline, plane: &Outline| {
            let above = object.centre.y - plane.centre.y;
            if self.eye.y < plane.centre.y {
                -above
            } else {
                above
            }
        };
        if front >= self.nothing() || f.power.is_nan() {
            false
        } else if back >= first_plane {
            let is_over = || {
                let plane = &self.planes[(back - first_plane) % MAX_PLANES];
                let (inner, most) = plane.sides(self.eye, f.centre - self.eye);
                inner.cmpgt(most * f.radius).all()
            };
            over(f, b) > f.radius * TOUCHES || f.power < f32::INFINITY && is_over()
        } else if front >= first_plane {
            over(b, f) <= -b.radius
        } else {
            let is_apart = f.centre.distance(b.centre) > f.radius + b.radius;
            // Of boxes and cylinders it is known where they are not: beyond the spheres around them.
            is_apart && f.power == f32::INFINITY
                || f.power < b.power && (is_apart || !(f.is_block || b.is_block))
        }
    }
}

/// A sphere stands on a plane, and does not pass through it, up to rounding.
const TOUCHES: f32 = 1.0 - 1e-5;
