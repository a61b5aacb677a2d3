//! The silhouette of a block.

use crate::maths::sqrt;
use crate::scene::Shape;
use glam::{BVec3A, Vec3A, Vec3Swizzles};

/// The silhouette of a block from a point. Along each of the block's axes, in a lane, the block is a rectangle across the other two;
/// an edge at either end of it is a side of the silhouette.
pub(super) struct Silhouette {
    shape: Shape,
    half: Vec3A,
    /// The middles of the rectangles.
    a: Vec3A,
    b: Vec3A,
    is_beside: BVec3A,
    /// The axes along which the point is between the block's sides: there the silhouette has no side.
    pub has_none: BVec3A,
}

impl Silhouette {
    /// Returns the silhouette of a block, by its centre and its half extents along its own axes, from the point.
    pub fn new(shape: Shape, centre: Vec3A, half: Vec3A) -> Self {
        let (a, b) = (centre.yzx(), centre.zxy());
        let is_beside = a.abs().cmpgt(half.yzx());
        Self {
            shape,
            half,
            a,
            b,
            is_beside,
            has_none: !(is_beside | b.abs().cmpgt(half.zxy())),
        }
    }

    /// Returns the ends of the rectangles: one way round, or the other if `way` is -1.
    pub fn ends(&self, way: f32) -> [Vec3A; 2] {
        let &Self { a, b, half, .. } = self;
        let (half_a, half_b) = (half.yzx(), half.zxy());
        let is_below = Vec3A::select(self.is_beside, a * way, b).cmplt(Vec3A::ZERO);
        let mut y = Vec3A::select(is_below, b + half_b, b - half_b);
        let is_left = (y * way).cmplt(Vec3A::ZERO);
        let mut x = Vec3A::select(is_left, a - half_a, a + half_a);
        match self.shape {
            Shape::Box => {}
            // Across its axis a cylinder counts as the box around it, and a capsule as the cylinder.
            Shape::Cylinder | Shape::Capsule => [x.y, y.y] = touched(a.y, b.y, half.x, way),
        }
        [x, y]
    }
}

/// Returns the point where a line through the origin touches a circle about (a, b), on one side of it, or on the other if `way` is -1.
fn touched(a: f32, b: f32, radius: f32, way: f32) -> [f32; 2] {
    // As shares of the way to its middle and across.
    let along = 1.0 - radius * radius / (a * a + b * b);
    let apart = sqrt(along - along * along);
    [a * along + b * apart * way, b * along - a * apart * way]
}
