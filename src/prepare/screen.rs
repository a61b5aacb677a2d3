//! The picture as the eye sees it, and rectangles of it.
//!
//! In the camera's own axes a ray is (u, v, 1): u to the right, v down.

use crate::maths::sqrt;
use crate::scene::camera::{Raster, pixels};
use glam::{Vec3A, Vec3Swizzles, Vec4, Vec4Swizzles};

/// The camera's axes, and where its pixels are in the plane at distance 1.
#[derive(Clone)]
pub(crate) struct Axes {
    /// To the right, down, and forward.
    pub rows: [Vec3A; 3],
    pub pixel: f32,
    /// The middle of the picture in pixels, x and y, twice.
    middle: Vec4,
}

/// A rectangle of the picture: the least u and v, and the greatest.
pub(crate) type Rect = Vec4;

/// The corners of a rectangle in pixels, made in a register: what is put together in memory takes longer to get back.
#[inline(always)]
pub(crate) fn rectangle(left: usize, top: usize, right: usize, bottom: usize) -> Vec4 {
    Vec4::new(pixels(left), pixels(top), pixels(right), pixels(bottom))
}

/// A rectangle around something in the picture: the least u and v, and the greatest, these two negative.
#[derive(Clone, Copy)]
pub(crate) struct ScreenBounds(Vec4);

/// Pixels around a bound, far more than its rounding.
const MARGIN: f32 = 0.5;

impl Axes {
    pub const NONE: Self = Self {
        rows: [Vec3A::ZERO; 3],
        pixel: 0.0,
        middle: Vec4::ZERO,
    };

    /// Takes in a picture of `width` by `height` pixels.
    pub fn set(&mut self, raster: &Raster, width: usize, height: usize) {
        let pixel = raster.dx.length();
        let [x, y] = [width, height].map(|side| 0.5 * (pixels(side) - 1.0));
        self.rows = [
            raster.dx / pixel,
            raster.dy / pixel,
            raster.corner + raster.dx * x + raster.dy * y,
        ];
        self.pixel = pixel;
        self.middle = Vec4::new(x, y, x, y);
    }

    /// Has the pixels' samples that much to the left and above.
    pub fn move_middle(&mut self, by: glam::Vec2) {
        self.middle += Vec4::new(by.x, by.y, by.x, by.y);
    }

    /// Mirrors them in a horizontal plane.
    pub fn mirror(&mut self) {
        for row in &mut self.rows {
            row.y = -row.y;
        }
    }

    /// The rectangle with these corners, in pixels.
    pub fn rect(&self, pixels: Vec4) -> Rect {
        (pixels - self.middle) * self.pixel
    }

    /// The column of pixels, with its fraction, that has some u.
    pub fn column(&self, u: f32) -> f32 {
        u / self.pixel + self.middle.x
    }

    /// A vector along the axes.
    pub fn to_camera(&self, d: Vec3A) -> Vec3A {
        let [right, down, forward] = self.rows;
        Vec3A::new(d.dot(right), d.dot(down), d.dot(forward))
    }

    /// Where a sphere can be seen whose centre is at `to`, seen from the eye.
    ///
    /// On each side it is bounded by the slope of a tangent through the eye (Mara and McGuire: 2D Polyhedral Bounds of a
    /// Clipped, Perspective-Projected 3D Sphere, JCGT 2013).
    pub fn bounds(&self, to: Vec3A, radius: f32) -> ScreenBounds {
        let to = self.to_camera(to);
        // A little larger than it is, so that what rounding adds is covered.
        let radius = radius * (1.0 + 1e-4);
        let z = to.z;
        if z < -radius {
            return ScreenBounds::NONE;
        }
        let tangent = |c: f32| sqrt(c * c + (z * z - radius * radius));
        let (across, down) = (tangent(to.x), tangent(to.y));
        let tangent = Vec4::new(across, down, across, down);
        // Greatest slopes are least ones the other way round.
        let c = to.xyxy() * Vec4::new(1.0, 1.0, -1.0, -1.0);
        let ahead = z * tangent + c * radius;
        let slope = (c * tangent - z * radius) / ahead - MARGIN * self.pixel;
        // A tangent that points backwards leaves the picture on its side; an eye within has none, nor what is no number.
        let is_slope = ahead.cmpgt(Vec4::ZERO) & slope.cmpeq(slope);
        ScreenBounds(Vec4::select(is_slope, slope, Vec4::NEG_INFINITY))
    }
}

impl ScreenBounds {
    /// Nothing of the picture.
    pub const NONE: Self = Self(Vec4::INFINITY);

    /// All of the picture, and beyond.
    pub const ALL: Self = Self(Vec4::NEG_INFINITY);

    /// No window, all zeros.
    pub const ZERO: Self = Self(Vec4::ZERO);

    /// Around both.
    pub fn join(&mut self, other: Self) {
        self.0 = self.0.min(other.0);
    }

    /// Narrows a rectangle to the u that it shares with it, to none if it is above or below.
    #[inline(always)]
    pub fn narrow(&self, rect: &mut Rect) {
        let [x, y, z, w] = self.0.to_array();
        rect.x = rect.x.max(x);
        rect.z = rect.z.min(-z);
        if y > rect.w || -w < rect.y {
            rect.z = f32::NEG_INFINITY;
        }
    }

    /// Whether it shares a point with a rectangle.
    #[inline(always)]
    pub fn meets(&self, rect: Rect) -> bool {
        let far = rect.zwxy() * Vec4::new(1.0, 1.0, -1.0, -1.0);
        self.0.cmple(far).all()
    }
}
