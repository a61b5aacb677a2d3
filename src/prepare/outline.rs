//! What an object covers of the picture, and what it hides, so that no square is filled over something unseen.

use super::cone::{Cone, ROUNDING};
use super::screen::{Axes, Rect, Window};
use super::{Node, OUTLINES, Prepared, Rectangle};
use crate::scene::{MAX_LIGHTS, MAX_PLANES};
use crate::trigonometry::root;
use glam::{Vec3A, Vec3Swizzles, Vec4};

/// An object's outline.
#[derive(Clone, Copy)]
pub(crate) struct Outline {
    /// The number of the object that is seen: of a shadow, that of the plane.
    pub object: u16,
    /// The rays that meet it, all of them where the eye is inside, or nearly.
    pub cone: Cone,
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

/// An eye as near to a sphere as so many times its slack, below which hits are none, is neither outside nor inside for
/// sure.
const TOUCHING: f32 = 4.0;

/// The square of the least cosine of a shadow's cone: the lamp of a flatter one touches the sphere by 0.1 % of the radius.
const LEAST_COSINE2: f32 = 0.0025;

impl Outline {
    pub const NONE: Self = Self {
        object: 0,
        cone: Cone::NONE,
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
        let distance = root(distance2);
        let power = distance2 - radius * radius;
        self.power = if (distance - radius).abs() > TOUCHING * ball.slack {
            if power < 0.0 && !ball.is_block {
                f32::INFINITY
            } else {
                power
            }
        } else {
            f32::NAN
        };
        self.cone.set_round(axes, &Vec4::W, to, radius);
        self.window = axes.window(to, radius);
        self.centre = ball.centre;
        self.radius = radius;
        self.is_block = ball.is_block;
        self.object = ball.number;
    }

    /// Takes in a horizontal rectangle, the object of that number.
    pub fn set_rectangle(&mut self, axes: &Axes, eye: Vec3A, plane: &Rectangle, number: usize) {
        self.cone.set_flat(axes, eye, plane);
        self.window = Window::ALL;
        self.centre = plane.centre;
        self.radius = 0.0;
        self.is_block = false;
        self.power = f32::INFINITY;
        self.object = number as u16;
    }
}

impl Rectangle {
    /// How far on the inner side of the four planes through the eye and an edge a direction leads, and how far at most for
    /// its length.
    ///
    /// A ray d meets the plane at `eye + d h / q`, with q = -d.y or d.y the speed at which it comes nearer, and lies on
    /// the inner side of an edge `reach` away along x where `reach q - h d.x >= 0`. Numbers below 1 are as good.
    #[inline(never)]
    pub(super) fn sides(&self, eye: Vec3A, d: Vec3A) -> (Vec4, Vec4) {
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
    /// Whether a rectangle of the picture may show what has the outline of a number.
    #[inline(never)]
    pub fn may_show(&self, outline: usize, rect: &Rect) -> bool {
        let outline = &self.outlines[outline % OUTLINES];
        outline.window.meets(*rect) && outline.cone.meets(rect, -ROUNDING)
    }

    /// Takes in the shadows of spheres on a plane, an object's number and all; of a lamp that is more than a point, or that is
    /// in a sphere or nearly so, there are none. What is on the other side of the plane counts as well.
    #[inline(never)]
    pub(super) fn add_shadows(&mut self, plane: &Rectangle, number: usize, lamp: usize) {
        let lamp = &self.lamps[lamp % MAX_LIGHTS];
        if !lamp.is_point {
            return;
        }
        let height = self.eye.y - plane.centre.y;
        let mut by = (lamp.position - self.eye).extend(height);
        // Terms below 2, and forward, which is towards the plane.
        by *= (1.0 / by.length()).copysign(height);
        for node in self.tree.solid() {
            if node.is_bound || node.is_block {
                continue;
            }
            let outline = &mut self.outlines[self.outlined % OUTLINES];
            outline.window = Window::ALL;
            outline.object = number as u16;
            let to = node.centre - lamp.position;
            let cosine2 = outline.cone.set_round(&self.axes, &by, to, node.radius);
            self.outlined += usize::from(cosine2 > LEAST_COSINE2);
        }
    }

    /// Whether a patch whose corners all see the object `front` cannot see the object `back` anywhere.
    ///
    /// What can be seen of an object is convex where one other is between, as long as the eye is outside: so it covers the
    /// patch.
    #[inline(never)]
    pub fn hides(&self, front: usize, back: usize) -> bool {
        let (f, b) = (
            &self.outlines[front % OUTLINES],
            &self.outlines[back % OUTLINES],
        );
        let first_plane = self.first_plane();
        if front >= self.nothing() || f.power.is_nan() {
            false
        } else if back >= first_plane {
            let is_over = || {
                let plane = &self.planes[(back - first_plane) % MAX_PLANES];
                let (inner, most) = plane.sides(self.eye, f.centre - self.eye);
                inner.cmpgt(most * f.radius).all()
            };
            self.above(f, b) > f.radius * TOUCHES || f.power < f32::INFINITY && is_over()
        } else if front >= first_plane {
            self.above(b, f) <= -b.radius
        } else {
            let is_apart = f.centre.distance(b.centre) > f.radius + b.radius;
            // Of boxes and cylinders it is known where they are not: beyond the spheres around them.
            is_apart && f.power == f32::INFINITY
                || f.power < b.power && (is_apart || !(f.is_block || b.is_block))
        }
    }

    /// How far above a plane an object is, taken from the eye's side of the plane.
    #[inline(never)]
    fn above(&self, object: &Outline, plane: &Outline) -> f32 {
        let above = object.centre.y - plane.centre.y;
        if self.eye.y < plane.centre.y {
            -above
        } else {
            above
        }
    }
}

/// A sphere stands on a plane, and does not pass through it, up to rounding.
const TOUCHES: f32 = 1.0 - 1e-5;
