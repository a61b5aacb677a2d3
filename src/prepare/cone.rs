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

use super::Rectangle;
use super::screen::{Axes, Rect};
use crate::maths::sqrt;
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

/// What rounding may add to a side's inequality, whose terms are below 2.
pub(super) const ROUNDING: f32 = 1e-5;

/// What a sphere is taken to be larger by: the cosine of a cone is wider by more than its rounding, however flat.
const WIDE: f32 = 1.0 + 1e-6;

/// The cone around a sphere, whatever rays it is to hold.
#[derive(Clone, Copy)]
pub(super) struct RoundCone {
    /// Where the sphere's centre is, from the tip. (Not aligned, to be small: there is one for each lamp and sphere.)
    to: Vec3,
    /// The cosine and the sine of the angle at the tip, over the length of `to`. The cosine is no number if the tip is inside.
    cosine: f32,
    sine: f32,
}

impl RoundCone {
    /// All zeros.
    pub const ZERO: Self = Self {
        to: Vec3::ZERO,
        cosine: 0.0,
        sine: 0.0,
    };

    /// The cone around a sphere whose centre is at `to`, and the square of its cosine; all rays are inside where there is none.
    pub fn around(to: Vec3A, radius: f32) -> (Self, f32) {
        let distance2 = to.length_squared();
        let radius = radius * WIDE;
        let cosine2 = (distance2 - radius * radius) / distance2;
        let cone = Self {
            to: to.into(),
            // `to` is as long as the distance, which the sine has once more.
            cosine: sqrt(cosine2 / distance2),
            sine: radius / distance2,
        };
        (cone, cosine2)
    }

    /// The rays of the picture that are inside; `rays` are what a step along u is, one along v, and (0, 0).
    #[inline(never)]
    pub fn seen_by(&self, rays: &[Vec3A; 3]) -> Cone {
        let to = Vec3A::from(self.to);
        let terms = rays.map(|ray| (to.cross(ray) * self.cosine).extend(to.dot(ray) * self.sine));
        Cone {
            terms,
            is_flat: false,
        }
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

    /// Narrows a rectangle of the picture to the u between which rays through it may be inside, by a margin; to none, the
    /// least u beyond the greatest, if none may.
    ///
    /// By tangent planes from both ends: each is a line in the picture that has the cone on one side.
    pub fn narrow(&self, rect: &mut Rect, margin: f32) {
        if self.is_flat {
            let [right, down, terms] = self.terms;
            for ((right, down), terms) in right
                .to_array()
                .into_iter()
                .zip(down.to_array())
                .zip(terms.to_array())
            {
                cut(rect, right, down, terms - margin);
            }
            return;
        }
        for _ in 0..TANGENTS {
            for u in [rect.x, rect.z] {
                let [right, down, terms] = self.terms;
                let across = Vec3A::from_vec4(right * u + down * (0.5 * (rect.y + rect.w)) + terms);
                // On the axis any direction across will do, such as none.
                let side = across / -across.length().max(f32::MIN_POSITIVE);
                let side = side.extend(1.0);
                cut(
                    rect,
                    side.dot(right),
                    side.dot(down),
                    side.dot(terms) - margin,
                );
                // Nothing is left, or a point, which its own tangent has decided.
                if rect.x >= rect.z {
                    return;
                }
            }
        }
    }
}

/// Narrows a rectangle to the u for which `right u + down v + terms` is not below 0 for some v.
#[inline(always)]
fn cut(rect: &mut Rect, right: f32, down: f32, terms: f32) {
    let most = (down * rect.y).max(down * rect.w) + terms;
    let end = -most / right;
    // What is not a number cuts nothing off.
    if right > 0.0 {
        rect.x = rect.x.max(end);
    } else if right < 0.0 {
        rect.z = rect.z.min(end);
    } else if most < 0.0 {
        rect.z = f32::NEG_INFINITY;
    }
}
