//! The surface points that mirror a light to the eye. Positions are relative to the object's
//! centre.

use crate::maths::unit;
use crate::prepare::Object;
use crate::scene::{Block, Shape};
use glam::Vec3A;

/// Newton steps towards the mirror point of a curved surface. Distant eyes and lights need two,
/// near ones all.
const NEWTON_STEPS: usize = 8;

pub(super) struct Mirror {
    pub p: Vec3A,
    pub n: Vec3A,
    /// The curvature across `axis`. Along `axis` the surface is straight.
    pub curvature: f32,
    pub axis: Vec3A,
}

impl Mirror {
    pub fn each(object: &Object<'_>, eye: Vec3A, light: Vec3A, mut add: impl FnMut(Self)) {
        match object {
            Object::Sphere(sphere) => add(Self::round(eye, light, Vec3A::ZERO, sphere.radius)),
            Object::Plane(_) => add(Self::flat(eye, light, Vec3A::Y, 0.0)),
            Object::Block(block) => match block.shape {
                Shape::Box => {
                    for side in 0..3 {
                        let axis = block.axes.col(side).into();
                        add(Self::flat(eye, light, axis, block.half[side]));
                    }
                }
                Shape::Cylinder => {
                    let axis = block.axes.y_axis.into();
                    add(Self::flat(eye, light, axis, block.half.y));
                    add(Self::round(eye, light, axis, block.half.x));
                }
                Shape::Capsule => Self::on_capsule(block, eye, light, add),
            },
            Object::Light(_) | Object::Background => {}
        }
    }

    /// Adds the mirror point of an endless cylinder if it is on the capsule's straight part.
    /// Otherwise adds two points, the nearest one on this part and the mirror point of the end's
    /// sphere, since a highlight may continue across the joint.
    fn on_capsule(block: &Block, eye: Vec3A, light: Vec3A, mut add: impl FnMut(Self)) {
        let (axis, half) = (Vec3A::from(block.axes.y_axis), block.half);
        let mut side = Self::round(eye, light, axis, half.x);
        let height = side.p.dot(axis);
        let end = half.y - half.x;
        let past = height - height.min(end).max(-end);
        if past != 0.0 {
            let centre = axis * end.copysign(height);
            let mut ball = Self::round(eye - centre, light - centre, Vec3A::ZERO, half.x);
            ball.p += centre;
            add(ball);
            side.p -= axis * past;
        }
        add(side);
    }

    /// Returns the point on a sphere (`axis` is zero) or on a cylinder about a unit axis.
    ///
    /// Seen along the axis, the normal bisects the directions to the eye and the light. The point's
    /// height along the axis divides the interval from the eye's height to the light's in the ratio
    /// of their distances from the point, seen along the axis.
    #[inline(never)]
    fn round(eye: Vec3A, light: Vec3A, axis: Vec3A, radius: f32) -> Self {
        let heights = [eye, light].map(|point| point.dot(axis));
        let [eye, light] = [eye - axis * heights[0], light - axis * heights[1]];
        let mut n = unit(unit(eye) + unit(light));
        let mut height = 0.0;
        for _ in 0..NEWTON_STEPS {
            let [near, far] = [eye, light].map(|point| point - n * radius);
            let [a, b] = [near, far].map(|to| 1.0 / to.length());
            height = (heights[0] * a + heights[1] * b) / (a + b);
            let half = near * a + far * b;
            let length = half.length();
            // The derivative of the bisector's angle with respect to the normal's, negated.
            let back = 0.25 * radius * (a + b) * length;
            n = unit(n + (half / length - n) / (1.0 + back));
        }
        Self { p: n * radius + axis * height, n, curvature: 1.0 / radius, axis }
    }

    /// Returns the point on the face towards the eye, at the distance `half` along the axis.
    fn flat(eye: Vec3A, light: Vec3A, axis: Vec3A, half: f32) -> Self {
        let n = axis * 1.0_f32.copysign(eye.dot(axis));
        let [above, light_above] = [eye, light].map(|point| point.dot(n) - half);
        let p = eye.lerp(light, above / (above + light_above));
        Self { p: p + n * (half - p.dot(n)), n, curvature: 0.0, axis }
    }
}
