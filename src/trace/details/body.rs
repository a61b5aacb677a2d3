//! Rays against boxes and cylinders.

use crate::scene::Block;
use glam::Vec3A;

/// Added to directions, so that none along a side is divided by.
const TINY: f32 = 1e-12;

/// 1 where a cylinder is round.
const AROUND: Vec3A = Vec3A::new(1.0, 0.0, 1.0);

/// A vector along a block's own axes.
#[inline(never)]
fn inward(block: &Block, v: Vec3A) -> Vec3A {
    block.axes.transpose() * v
}

/// The distance at which a ray first meets a block ahead; infinite where it passes by.
///
/// It is inside where it is between all sides at once.
pub(super) fn first_ahead(block: &Block, o: Vec3A, d: Vec3A) -> f32 {
    let o = inward(block, o - block.centre);
    let d = inward(block, d) + TINY;
    let mut middle = -o / d;
    let mut half = (block.half / d).abs();
    if block.round {
        let across = d * AROUND;
        let a = across.dot(across);
        let to_middle = -across.dot(o) / a;
        // The square of half the chord from the perpendicular to the axis, which loses no digits far away.
        let off = (o + d * to_middle) * AROUND;
        let c = block.half.x * block.half.x - off.dot(off);
        if c < 0.0 {
            return f32::INFINITY;
        }
        let to_end = libm::sqrtf(c / a);
        middle = Vec3A::new(to_middle, middle.y, to_middle);
        half = Vec3A::new(to_end, half.y, to_end);
    }
    let near = (middle - half).max_element();
    let far = (middle + half).min_element();
    let t = if near > 0.0 { near } else { far };
    if near <= far && t > 0.0 {
        t
    } else {
        f32::INFINITY
    }
}

/// A place on a block's surface.
pub(super) struct Spot {
    /// From the centre.
    pub out: Vec3A,
    /// The normal there, outward.
    pub n: Vec3A,
    /// From the centre along the block's own axes.
    pub own: Vec3A,
}

impl Spot {
    /// The place on the surface by one that is off by rounding: on the side that it is least within of.
    pub fn near(block: &Block, out: Vec3A) -> Self {
        let own = inward(block, out);
        // How far out it is, the sides being at 1.
        let mut sides = (own / block.half).abs();
        if block.round {
            sides = AROUND * (sides * AROUND).length() + sides * Vec3A::Y;
        }
        let most = sides.max_element();
        let side = Vec3A::select(sides.cmpge(Vec3A::splat(most)), own, Vec3A::ZERO);
        let length = side.length();
        let n = block.axes * side / length;
        // Along the normal to where `most` is 1.
        let out = out + n * (length / most - length);
        Self { out, n, own }
    }
}

/// How far from a block's surface rays start that leave it: what rounding can displace a point on it by, in both
/// directions, many times over. Ten units from the origin it is a ten-thousandth.
pub(super) fn slack(block: &Block) -> f32 {
    1e-5 * (block.centre.abs() + block.half).element_sum()
}
