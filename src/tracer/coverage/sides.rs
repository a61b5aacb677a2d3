//! The rays that meet a sphere, a block or a plane, as a convex region of the picture.
//!
//! Each test is about a ray w from a viewpoint. In direct view, w is the eye's ray `d = (u, v, 1)`.
//! For a shadow, w leads from the light to the point where d meets the plane. It is scaled to be
//! linear in d, so the shadow of a sphere is a cone of rays d, too. `view` writes w as a sum: a
//! vector, plus a number times the vector from the viewpoint to the object's centre. In direct view
//! the number is 0, and the vector is d.
//!
//! Let a be the axis of a sphere's bounding cone, and `sin` and `cos` the sine and cosine of half
//! its opening angle. A ray w meets the sphere if `sin (a . w) >= cos |a x w|`. The left side minus
//! the right side is a concave function of u and v. A plane tangent to its graph is nowhere below
//! it, so rays miss the sphere where the tangent plane is negative. Blocks and planes are bounded
//! by planes through the viewpoint.

use super::screen::{Axes, Rect, Rects, ScreenBounds, corners};
use crate::lanes::*;
use crate::maths::sqrt;
use crate::prepare::BvhNode;
use crate::rounding::{CONE_RADIUS_FACTOR, HIT, SIDE, UNSURE, within_pixel};
use crate::scene::{Block, List, Plane, Shape};
use crate::shapes::plane;
use core::array;
use glam::{Mat3A, Vec3A, Vec3Swizzles, Vec4};

const SHORTEST: f32 = 1e-20;

/// The number of successive cuts at each end of a row's range. Each is by the tangent at the
/// current end, initially the rectangle's end.
const TANGENTS: usize = 3;

/// Four linear functions of u and v, one per lane: the slope in u, the slope in v, and the value at
/// (0, 0).
pub(crate) type Terms = [Vec4; 3];

#[derive(Clone, Copy)]
pub(crate) enum Sides {
    /// All rays, because the viewpoint may be inside the object.
    All,
    /// The rays in a cone: `cos (a x w)` in three lanes, `sin (a . w)` in the last.
    Round {
        terms: Terms,
        /// The hit error widens the cone, so a ray inside it may miss the sphere. A ray certainly
        /// meets the sphere if the last lane minus the length of the other three is at least this
        /// multiple of the last lane.
        unsure: f32,
    },
    /// The rays inside up to eight planes around the object, and inside up to eight planes within
    /// it. `outer` is a full list: a loop over an array would be unrolled, which takes 284 bytes of
    /// code.
    Flat { outer: List<Terms, 2>, inner: [Terms; 2] },
}

impl Sides {
    /// Returns the rays in the bounding cone of a node's sphere. `to` is the vector from the
    /// viewpoint to the centre. The ray w is linear in u and v, and `rays` has its coefficients of
    /// u, v and 1. A coefficient stands for a vector: its first three lanes, plus its last lane
    /// times `to`.
    #[inline(never)]
    pub fn of_sphere(rays: &[Vec4; 3], to: Vec3A, node: &BvhNode) -> Self {
        let radius = (node.radius + node.hit_error) * CONE_RADIUS_FACTOR;
        let distance2 = to.length_squared();
        let cosine2 = (distance2 - radius * radius) / distance2;
        if cosine2 < 0.0 {
            return Self::All;
        }
        let [cosine, sine] = [sqrt(cosine2 / distance2), radius / distance2];
        let error = UNSURE * (node.hit_error + HIT * sqrt(distance2));
        Self::Round {
            terms: rays.map(|ray| {
                let w = Vec3A::from_vec4(ray);
                (to.cross(w) * cosine).extend(to.dot(w) * sine + ray.w * radius)
            }),
            unsure: error / (radius * cosine2),
        }
    }

    /// Returns the rays between a block's silhouette planes, at most two per axis, moved outward
    /// and inward by `slack`. For `rays` and `to` see [`Sides::of_sphere`].
    #[inline(never)]
    pub fn of_block(rays: &[Vec4; 3], to: Vec3A, block: &Block, slack: f32) -> Self {
        let inward = Mat3A::from(block.axes).transpose();
        let half = Vec3A::from(block.half);
        let (shape, centre) = (block.shape, inward * to);
        let rays = rays.map(|ray| (across(shape, inward * Vec3A::from_vec4(ray)), ray.w));
        // The inner prism is hexagonal in a cylinder or a capsule, and leaves out a capsule's round
        // ends.
        let ends = if shape == Shape::Capsule { half.x } else { 0.0 };
        let inside = half - slack - Vec3A::Y * ends;
        let inner = if inside.min_element() > 0.0 {
            silhouette_terms(shape, centre, inside, SINE, &rays)
        } else {
            [[Vec4::ZERO, Vec4::ZERO, Vec4::NEG_ONE]; 2]
        };
        let outer = List::full(silhouette_terms(shape, centre, half + slack, 1.0, &rays));
        Self::Flat { outer, inner }
    }

    pub fn of_rectangle(rays: &[Vec3A; 3], eye: Vec3A, plane: &Plane) -> Self {
        let terms =
            [rays.map(|ray| plane::sides(plane, eye, ray)), [Vec4::ZERO, Vec4::ZERO, Vec4::ONE]];
        Self::Flat { outer: List::full(terms), inner: terms }
    }

    /// Clips each rectangle to the range of u whose rays may be at least `margin` deep inside. A
    /// cone's tangent planes clip both ends.
    #[inline(never)]
    fn clip<S: Isa>(&self, rects: &mut Rects<S>, margin: f32) {
        let simd = rects.left.token();
        match self {
            Self::All => {}
            Self::Round { terms, .. } => {
                let [right, down, origin] = terms.map(|term| term.to_array());
                let middle = (rects.top + rects.bottom) * 0.5;
                let row: [F<S>; 3] = array::from_fn(|i| middle * down[i] + origin[i]);
                for _ in 0..TANGENTS {
                    if rects.left.simd_gt(rects.right).all_true() {
                        return;
                    }
                    let tangents = [rects.left, rects.right].map(|u| {
                        let [x, y, z]: [F<S>; 3] = array::from_fn(|i| u * right[i] + row[i]);
                        // On the cone's axis, (x, y, z) is 0 and has no direction. Any unit vector
                        // instead of the direction gives a valid upper bound, and so does 0.
                        let length = (x * x + y * y + z * z).sqrt().max(splat(simd, SHORTEST));
                        let side = |[a, b, c, d]: [f32; 4]| length * d - (x * a + y * b + z * c);
                        [side(right), side(down), side(origin) - length * margin]
                    });
                    for [right, down, origin] in tangents {
                        rects.cut(right, down, origin);
                    }
                }
            }
            Self::Flat { outer, .. } => {
                for sides in outer.iter() {
                    let sides = sides.map(|side| side.to_array());
                    for i in 0..4 {
                        let [right, down, origin] = sides.map(|side| splat(simd, side[i]));
                        rects.cut(right, down, origin - margin);
                    }
                }
            }
        }
    }

    /// Returns lower bounds of the rays' depths inside, negative if a ray may be outside.
    #[inline(always)]
    fn depth(&self, u: F<Baseline>, v: F<Baseline>) -> F<Baseline> {
        let at = |terms: &Terms| -> [F<Baseline>; 4] {
            let [right, down, origin] = terms.map(|term| term.to_array());
            array::from_fn(|i| u * right[i] + v * down[i] + origin[i])
        };
        match self {
            Self::All => splat(u.token(), f32::NEG_INFINITY),
            Self::Round { terms, unsure } => {
                let [x, y, z, w] = at(terms);
                w * (1.0 - unsure) - (x * x + y * y + z * z).sqrt()
            }
            Self::Flat { inner, .. } => {
                let [first, second] = [0, 1].map(|i| {
                    let [x, y, z, w] = at(&inner[i]);
                    x.min(y).min(z.min(w))
                });
                first.min(second)
            }
        }
    }
}

impl<S: Isa> Rects<S> {
    /// Clips rectangles to the range of u where `right u + down v + origin >= 0` for some v of the
    /// rectangle.
    #[inline(never)]
    fn cut(&mut self, right: F<S>, down: F<S>, origin: F<S>) {
        let zero = splat(right.token(), 0.0);
        let max = (down * self.top).max(down * self.bottom) + origin;
        // NaN clips nothing. Adding zero turns -0 into 0, so that a `right` of 0 clips all or
        // nothing.
        let end = -max / (right + zero);
        let min = at_least::<S>(end, self.left);
        let greatest = at_most::<S>(end, self.right);
        self.left = right.simd_ge(zero).select(min, self.left);
        self.right = right.simd_lt(zero).select(greatest, self.right);
    }
}

pub(crate) struct Region {
    pub bounds: ScreenBounds,
    pub sides: Sides,
    /// The bound on the rounding error of a side's inequality.
    pub rounding: f32,
    /// The least depth at which a point of the plane counts as certainly in the shadow or image;
    /// infinity if none does.
    pub margin: f32,
}

impl Region {
    /// `rounding` is the factor on [`SIDE`], see [`View::rounding`](super::view::View::rounding).
    pub fn new(axes: &Axes, bounds: ScreenBounds, sides: Sides, rounding: f32) -> Self {
        let rounding = within_pixel(SIDE * axes.reach * rounding, axes.pixel);
        Self { bounds, sides, rounding, margin: rounding }
    }

    /// Returns the least and greatest u of the region in each rectangle. If the region misses a
    /// rectangle, the least exceeds the greatest.
    #[inline(always)]
    pub fn clip<S: Isa>(&self, mut rects: Rects<S>) -> [F<S>; 2] {
        self.bounds.clip(&mut rects);
        self.sides.clip(&mut rects, -self.rounding);
        [rects.left, rects.right]
    }

    /// A bit is set if the corner is certainly inside.
    #[inline(always)]
    pub fn corners(&self, rect: Rect) -> u64 {
        let [u, v] = corners(rect);
        self.sides.depth(u, v).simd_ge(self.margin).to_bitmask()
    }
}

/// Returns how deep rays are inside planes, each of which contains the viewpoint and an edge of the
/// block's silhouette. Vectors are in the block's axes, and the viewpoint is the origin.
///
/// Each lane projects the block along an axis to a rectangle, which has two corners on the
/// silhouette. Seen along its own axis, a cylinder or capsule is a circle. The other lanes see it
/// from the side, as a hexagonal prism whose inscribed circle has `hexagon` times the radius.
#[inline(never)]
fn silhouette_terms(
    shape: Shape,
    centre: Vec3A,
    half: Vec3A,
    hexagon: f32,
    rays: &[([Vec4; 2], f32); 3],
) -> [Terms; 2] {
    let [a, b] = across(shape, centre);
    let [half_a, mut half_b] = across(shape, half);
    if shape != Shape::Box {
        half_b = Vec4::new(hexagon, 1.0, hexagon, hexagon) * half.x;
    }
    let is_beside = a.abs().cmpgt(half_a);
    // From inside the rectangle there is no silhouette.
    let has_none = !(is_beside | b.abs().cmpgt(half_b));
    [1.0, -1.0].map(|sign| {
        // The vector from the rectangle's centre to its corner on the silhouette, on the side of
        // `sign`.
        let is_below = Vec4::select(is_beside, a * sign, b).cmplt(Vec4::ZERO);
        let mut up = Vec4::select(is_below, half_b, -half_b);
        let is_left = ((b + up) * sign).cmplt(Vec4::ZERO);
        let mut right = Vec4::select(is_left, -half_a, half_a);
        if shape != Shape::Box {
            [right.y, up.y] = tangent_point(a.y, b.y, half_b.y, sign);
        }
        let (x, y) = (a + right, b + up);
        let scale = Vec4::select(has_none, Vec4::ZERO, sign / (x.abs() + y.abs()));
        let mut terms = rays.map(|([across_a, across_b], share)| {
            let depth = across_b * x - across_a * y + (b * right - a * up) * share;
            // If the origin is inside a cylinder's circle, `depth` is NaN.
            Vec4::select(has_none, Vec4::ZERO, depth * scale)
        });
        terms[2] += Vec4::select(has_none, Vec4::ONE, Vec4::ZERO);
        terms
    })
}

/// The sine of 60 degrees.
const SINE: f32 = 0.866_025_4;

/// Returns, for the axis of each lane, the vector's two coordinates perpendicular to it. A box has
/// three axes. A cylinder has its own and three across it, 60 degrees apart.
#[inline(never)]
fn across(shape: Shape, v: Vec3A) -> [Vec4; 2] {
    match shape {
        Shape::Box => [v.yzx().extend(0.0), v.zxy().extend(0.0)],
        Shape::Cylinder | Shape::Capsule => {
            let (z, x) = (0.5 * v.z, SINE * v.x);
            [v.yzy().extend(v.y), Vec4::new(v.z, v.x, z - x, -z - x)]
        }
    }
}

/// Returns the vector from the centre (a, b) of a circle to the point where a line from the origin
/// touches it, on the side of `sign`.
fn tangent_point(a: f32, b: f32, radius: f32, sign: f32) -> [f32; 2] {
    // The vector's parts along and across the line to the centre, relative to the centre's
    // distance.
    let share = radius * radius / (a * a + b * b);
    let apart = sqrt((1.0 - share) * share) * sign;
    [b * apart - a * share, -a * apart - b * share]
}
