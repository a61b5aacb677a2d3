//! Conservative bounds in screen space. A ray is (u, v, 1) in the camera's axes: right, down and
//! forward.

use crate::lanes::*;
use crate::maths::to_f32;
use crate::rounding::PIXELS_AROUND;
use crate::scene::camera::Raster;
use glam::{Vec2, Vec3A, Vec4, Vec4Swizzles};

#[derive(Clone)]
pub(crate) struct Axes {
    /// Right, down, and forward.
    pub rows: [Vec3A; 3],
    pub pixel: f32,
    /// The largest u or v of the picture, at least 1. A ray's length is at most `reach` times the
    /// root of 3.
    pub reach: f32,
    /// The centre of the picture in pixels, x and y, twice.
    middle: Vec4,
}

/// The least u, the least v, the greatest u, and the greatest v.
pub(crate) type Rect = Vec4;

#[derive(Clone, Copy)]
pub(crate) struct Rects<S: Isa> {
    pub left: F<S>,
    pub top: F<S>,
    pub right: F<S>,
    pub bottom: F<S>,
}

/// Builds the vector in a register: loading it right after storing its parts would stall.
#[inline(always)]
pub(crate) fn rectangle(left: usize, top: usize, right: usize, bottom: usize) -> Vec4 {
    Vec4::new(to_f32(left), to_f32(top), to_f32(right), to_f32(bottom))
}

/// Upper left, upper right, lower left, lower right: x, then y.
#[inline(always)]
pub(crate) fn corners(rect: Vec4) -> [F<Baseline>; 2] {
    [rect.xzxz(), rect.yyww()].map(|ends| F::<Baseline>::simd_from(baseline(), ends.to_array()))
}

/// A bounding rectangle: the least u and v, and the negated greatest u and v.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct ScreenBounds(Vec4);

zero! { ScreenBounds = Self(Vec4::ZERO); }

zero! { Axes { rows, pixel, reach, middle } }

impl Axes {
    /// Samples are `offset` pixels off the pixels' centres; `raster` has no offset.
    pub fn new(raster: &Raster, [width, height]: [usize; 2], offset: Vec2) -> Self {
        let pixel = raster.dx.length();
        let [x, y] = [width, height].map(|side| 0.5 * (to_f32(side) - 1.0));
        let [corner, dx, dy] = [raster.corner, raster.dx, raster.dy].map(Vec3A::from);
        Self {
            rows: [dx / pixel, dy / pixel, corner + dx * x + dy * y],
            pixel,
            reach: (pixel * x.max(y)).max(1.0),
            middle: Vec4::new(x, y, x, y) - Vec4::from((offset, offset)),
        }
    }

    pub fn rect(&self, pixels: Vec4) -> Rect {
        (pixels - self.middle) * self.pixel
    }

    /// Returns rectangles of `size` pixels, one below the other, one per lane. `left` and `top` are
    /// the first one's.
    #[inline(always)]
    pub fn rects<S: Isa>(&self, simd: S, [left, top]: [usize; 2], size: [usize; 2]) -> Rects<S> {
        let [width, height] = size.map(to_f32);
        let [x, y, ..] = self.middle.to_array();
        let left = splat(simd, to_f32(left) - x);
        let top =
            lane_numbers(simd).bitcast::<I<S>>().to_float::<F<S>>() * height + (to_f32(top) - y);
        Rects {
            left: left * self.pixel,
            top: top * self.pixel,
            right: (left + width) * self.pixel,
            bottom: (top + height) * self.pixel,
        }
    }

    pub fn pixel_at(&self, u: f32, v: f32) -> Vec2 {
        self.middle.xy() + Vec2::new(u, v) / self.pixel
    }

    /// Converts `u` to columns of pixels, without rounding.
    #[inline(always)]
    pub fn column<S: Isa>(&self, u: F<S>) -> F<S> {
        u / self.pixel + self.middle.x
    }
}

impl ScreenBounds {
    pub const NONE: Self = Self(Vec4::INFINITY);

    pub const ALL: Self = Self(Vec4::NEG_INFINITY);

    /// Returns the bounds of two ranges. `u` is (a, b, c, d) for the range from `(b + a) / (d + c)`
    /// to `(b - a) / (d - c)`; `v` alike.
    pub fn around(u: Vec4, v: Vec4, pixel: f32) -> Self {
        // The upper ends are computed negated: all four lanes are lower ends then, with one margin.
        let ends = |c: f32, d: f32| Vec4::new(c, d, -c, -d);
        let ahead = Vec4::new(u.w, v.w, u.w, v.w) + ends(u.z, v.z);
        let across = Vec4::new(u.x, v.x, u.x, v.x) + ends(u.y, v.y);
        let slope = across / ahead - PIXELS_AROUND * pixel;
        // A tangent that points backwards, or NaN, does not bound its side.
        let is_slope = ahead.cmpgt(Vec4::ZERO) & slope.cmpeq(slope);
        Self(Vec4::select(is_slope, slope, Vec4::NEG_INFINITY))
    }

    pub fn in_pixels(&self, axes: &Axes) -> Vec4 {
        self.0 / axes.pixel + axes.middle * Vec4::new(1.0, 1.0, -1.0, -1.0)
    }

    pub fn join(&mut self, other: Self) {
        self.0 = self.0.min(other.0);
    }

    /// Clips rectangles to the bounds' range of u; rectangles above or below become empty.
    #[inline(always)]
    pub fn clip<S: Isa>(&self, rects: &mut Rects<S>) {
        let simd = rects.left.token();
        let [left, top, right, bottom] = self.0.to_array();
        rects.left = rects.left.max(splat(simd, left));
        rects.right = rects.right.min(splat(simd, -right));
        let is_outside =
            rects.bottom.simd_lt(splat(simd, top)) | rects.top.simd_gt(splat(simd, -bottom));
        rects.right = is_outside.select(splat(simd, f32::NEG_INFINITY), rects.right);
    }

    pub fn meets(&self, rect: Rect) -> bool {
        let far = rect.zwxy() * Vec4::new(1.0, 1.0, -1.0, -1.0);
        self.0.cmple(far).all()
    }
}
