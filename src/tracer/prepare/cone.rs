//! Cones as parts of the picture see them: around a sphere, a rectangle, or the shadow of a sphere on a plane.
//!
//! A round cone are the rays w with `sin (a . w) >= cos |a x w|`, a its axis. Seen from the eye, w is the picture's own ray
//! (u, v, 1). A lamp's ray to where the eye's ray d meets a plane, which is H below the eye, is a linear image of that but
//! for its length, `w = H d - (eye - lamp) d.y`: so a shadow is a cone as well. One with flat sides, through the eye, are
//! the rays on the inner side of all.
//!
//! The difference of both sides of the inequality is a concave function of u and v, nowhere above its tangent plane, which
//! is greatest at a corner of a square of the picture. So a square that has a side's tangent plane in its middle below 0 at
//! all corners is outside.

use super::screen::{Axes, Rects, ScreenBounds};
use crate::lanes::*;
use crate::maths::sqrt;
use crate::shapes::plane::Rectangle;
use crate::shapes::sphere::HIT_ERROR;
use core::array;
use glam::{Vec3, Vec3A, Vec4};

/// Tangents from each end that a rectangle is narrowed by: the first ones touch a cone on their side of it, later ones in the
/// rectangle.
const TANGENTS: usize = 3;

/// A cone.
#[derive(Clone, Copy)]
pub(crate) struct Cone {
    /// For a step along u, for one along v, and for (0, 0): `cos (a x w)` and, in the last lane, `sin (a . w)`; or how far
    /// inside of four flat sides w is.
    pub(super) terms: [Vec4; 3],
    pub(super) is_flat: bool,
}

/// The most that rounding may add to a side's inequality, whose terms are below twice [`Axes::reach`].
pub(super) const ROUNDING: f32 = 1e-5;

/// The least length that is divided by, where there is a direction across.
const SHORTEST: f32 = 1e-20;

/// The factor by which a sphere is taken to be larger: the cosine of a cone is wider by more than its rounding, however flat.
const WIDE: f32 = 1.0 + 1e-6;

/// The number that is added to the sine of a cone before it is bounded: more than rounding turns the tangent planes.
const WIDER: f32 = 1e-4;

/// The cone around a sphere, whatever rays it is to hold.
#[derive(Clone, Copy)]
pub(super) struct RoundCone {
    /// Where the sphere's centre is, from the tip. (Not aligned, to be small: there is one for each lamp and sphere.)
    to: Vec3,
    /// The cosine of the angle at the tip, divided by the length of `to`; no number if the tip is inside.
    cosine_by_length: f32,
    /// The sine of that angle, divided by the same.
    sine_by_length: f32,
}

impl RoundCone {
    /// All zeros.
    pub const ZERO: Self = Self {
        to: Vec3::ZERO,
        cosine_by_length: 0.0,
        sine_by_length: 0.0,
    };

    /// The cone around a sphere whose centre is at `to`; all rays are inside where there is none.
    pub fn around(to: Vec3A, radius: f32) -> Self {
        let distance2 = to.length_squared();
        let radius = radius * WIDE;
        let cosine2 = (distance2 - radius * radius) / distance2;
        Self {
            to: to.into(),
            // `to` is as long as the distance, which the sine has once more.
            cosine_by_length: sqrt(cosine2 / distance2),
            sine_by_length: radius / distance2,
        }
    }

    /// The share of its sine by which rays may be inside and miss the sphere, around which it is wider by `hit_error`; not a number if
    /// the tip is inside.
    ///
    /// Shadow rays have another such error taken from the radius, so that no sphere shadows itself, and one more of the way to the
    /// lamp, see `ShadowCone::r2`; the points that they leave from are off by less than a third one.
    #[inline(never)]
    pub fn unsure(&self, hit_error: f32) -> f32 {
        let distance2 = self.to.length_squared();
        let (radius, cosine2) = (
            self.sine_by_length * distance2,
            self.cosine_by_length * self.cosine_by_length * distance2,
        );
        let error = 3.0 * (hit_error + HIT_ERROR * sqrt(distance2));
        error / (radius * cosine2)
    }

    /// The rays of the picture that are inside; `rays` are what a step along u is, one along v, and (0, 0).
    #[inline(never)]
    pub fn seen_by(&self, rays: &[Vec3A; 3]) -> Cone {
        let to = Vec3A::from(self.to);
        let terms = rays.map(|ray| {
            (to.cross(ray) * self.cosine_by_length).extend(to.dot(ray) * self.sine_by_length)
        });
        Cone {
            terms,
            is_flat: false,
        }
    }

    /// Where it can be seen, if the planes through the tip with three normals are seen as the lines u = 0, v = 0, and that at
    /// infinity: the camera's axes, where the tip is the eye.
    ///
    /// The line u = c is the plane that has the first normal less c times the last. It touches the cone where its angle with the
    /// axis is that of the cone (Mara and McGuire: 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere, JCGT 2013,
    /// where normals are at right angles to each other).
    #[inline(never)]
    pub fn bounds(&self, [right, down, forward]: &[Vec3A; 3], pixel: f32) -> ScreenBounds {
        let to = Vec3A::from(self.to);
        let distance = to.length();
        let (axis, sine) = (to / distance, self.sine_by_length * distance + WIDER);
        let ahead = axis.dot(*forward);
        if ahead < -sine * forward.length() {
            return ScreenBounds::NONE;
        }
        let [u, v] = [right, down].map(|normal| {
            // All planes have one direction in common. Across it the cone is as wide as a flat one.
            let along = normal.cross(*forward).normalize();
            let shared = axis.dot(along);
            let cosine = sqrt(1.0 - sine * sine - shared * shared);
            let across = along.cross(axis) * sine;
            Vec4::new(
                normal.dot(across),
                cosine * axis.dot(*normal),
                forward.dot(across),
                cosine * ahead,
            )
        });
        ScreenBounds::around(u, v, pixel)
    }
}

impl Cone {
    /// Nothing, all zeros.
    pub const NONE: Self = Self {
        terms: [Vec4::ZERO; 3],
        is_flat: false,
    };

    /// Takes in the cone between the eye and a horizontal rectangle.
    pub fn set_flat(&mut self, axes: &Axes, eye: Vec3A, plane: &Rectangle) {
        for (terms, &ray) in self.terms.iter_mut().zip(&axes.rows) {
            *terms = plane.sides(eye, ray);
        }
        self.is_flat = true;
    }

    /// How far inside rays through points of the picture are, below 0 if they are outside, and not a number if all are
    /// inside. A round cone counts as one whose sine is so many times as large.
    #[inline(never)]
    pub fn depth<S: Isa>(&self, u: F<S>, v: F<S>, sine: f32) -> F<S> {
        let [right, down, terms] = self.terms.map(|terms| terms.to_array());
        let [x, y, z, w]: [F<S>; 4] = array::from_fn(|i| u * right[i] + v * down[i] + terms[i]);
        if self.is_flat {
            x.min(y).min(z.min(w))
        } else {
            w * sine - (x * x + y * y + z * z).sqrt()
        }
    }

    /// Narrows rectangles of the picture to the u between which rays through them may be inside, by a margin; to none, the
    /// least u beyond the greatest, where none may.
    ///
    /// By tangent planes from both ends: each is a line in the picture that has the cone on one side.
    #[inline(never)]
    pub fn narrow<S: Isa>(&self, rects: &mut Rects<S>, margin: f32) {
        let simd = rects.left.token();
        let terms = self.terms.map(|terms| terms.to_array());
        if self.is_flat {
            for i in 0..4 {
                let [right, down, terms] = terms.map(|terms| splat(simd, terms[i]));
                rects.cut(right, down, terms - margin);
            }
            return;
        }
        let [right, down, terms] = terms;
        let middle = (rects.top + rects.bottom) * 0.5;
        let row: [F<S>; 3] = array::from_fn(|i| middle * down[i] + terms[i]);
        for _ in 0..TANGENTS {
            let tangents = [rects.left, rects.right].map(|u| {
                let [x, y, z]: [F<S>; 3] = array::from_fn(|i| u * right[i] + row[i]);
                // On the axis any direction across will do, such as none.
                let length = (x * x + y * y + z * z).sqrt().max(splat(simd, SHORTEST));
                // What it has of the cone's terms, times that length.
                let side = |[a, b, c, d]: [f32; 4]| length * d - (x * a + y * b + z * c);
                [side(right), side(down), side(terms) - length * margin]
            });
            for [right, down, terms] in tangents {
                rects.cut(right, down, terms);
            }
        }
    }
}

impl<S: Isa> Rects<S> {
    /// Narrows rectangles to the u for which `right u + down v + terms` is not below 0 for some v.
    #[inline(never)]
    fn cut(&mut self, right: F<S>, down: F<S>, terms: F<S>) {
        let zero = splat(right.token(), 0.0);
        let most = (down * self.top).max(down * self.bottom) + terms;
        // What is not a number cuts nothing off. Where `right` is 0, which must not be -0, all is cut off or nothing.
        let end = -most / (right + zero);
        let least = at_least::<S>(end, self.left);
        let greatest = at_most::<S>(end, self.right);
        self.left = right.simd_ge(zero).select(least, self.left);
        self.right = right.simd_lt(zero).select(greatest, self.right);
    }
}
