//! The shadows of spheres on planes, as cones in the picture.
//!
//! The cone of a lamp about a sphere does not depend on the plane, and the linear map from the camera's rays to the lamp's rays
//! (see `cone`) does not depend on the sphere. Both are stored, and combined when a shadow is needed: storing all combinations
//! would take more memory than everything else. What is stored of each is a rectangle around it in the picture.
//!
//! # What rounding does
//!
//! All pixels of a shadow are inside of its cone, and what is inside for sure (see [`RoundCone::unsure`]) is dark. Let `h` be the
//! sphere's hit error and `e` the same share, `HIT_ERROR`, of its distance from the lamp. Shadow rays meet a sphere whose radius is
//! smaller by `h + e` (see `ShadowCone::r2`), the cone is about one that is larger by `h`, and what is sure is inside of one that is
//! smaller by `2 h + 3 e`: `2 h + e` outside and `h + 2 e` inside are left for errors. These are, at the sphere:
//!
//! - The vector from the lamp, and the perpendicular that is computed of it: some 2^-24 of the distance from the lamp, less than
//!   `e / 2`.
//! - The point on the plane, by its coordinates: less than `h / 3` by those of the sphere, and `e / 3` by the way from it, as what
//!   moves the far end of a ray from the lamp by a share of that way moves its part at the sphere by less. (Points are computed from
//!   the plane's centre. One that is much farther from the eye than all this is not allowed for.)
//! - The point on the plane, by its distance from the eye: some 2^-24 of it. A side's `ROUNDING` is 1e-5 of that distance there, as
//!   its terms are scaled by the way from the lamp to the eye's mirror image, which is longer than the eye is high.
//! - The cone's own terms: below `ROUNDING`, and `WIDE` is for the cosine.

use super::cone::{Cone, RoundCone};
use super::{ObjectId, Prepared};
use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS};
use crate::shapes::plane::Rectangle;
use glam::Vec3A;

/// The largest number of pairs of a sphere and a lamp.
const MAX_CASTERS: usize = MAX_LIGHTS * MAX_SOLIDS;

/// The shadows of spheres on planes.
pub(super) struct Shadows {
    /// Pairs of a sphere and a lamp. Each casts a shadow on every plane.
    casters: [Caster; MAX_CASTERS],
    count: usize,
    /// For each plane, how each lamp and the eye see its points.
    seen: [[Projection; MAX_LIGHTS]; MAX_PLANES],
}

/// A sphere that casts shadows by the light of one lamp.
#[derive(Clone, Copy)]
struct Caster {
    cone: RoundCone,
    /// The lamp's number.
    lamp: u8,
    /// The sphere's.
    object: u16,
}

impl Shadows {
    /// All zeros: no shadows.
    pub const ZERO: Self = Self {
        casters: [Caster {
            cone: RoundCone::ZERO,
            lamp: 0,
            object: 0,
        }; MAX_CASTERS],
        count: 0,
        seen: [[Projection::ZERO; MAX_LIGHTS]; MAX_PLANES],
    };
}

impl Prepared {
    /// Prepares the shadows, after objects and lamps. Lamps that are not points have none, nor do spheres that contain a lamp. Spheres on the far side of a plane are left out later.
    pub(super) fn set_shadows(&mut self) {
        self.shadows.count = 0;
        for (number, lamp) in self.lamps[..self.lamp_count].iter().enumerate() {
            if !lamp.is_point {
                continue;
            }
            for node in self.tree.solid_nodes() {
                if node.is_bound || node.is_block {
                    continue;
                }
                // All rays are inside where the lamp is as near as rounding.
                let to = node.centre - lamp.position;
                let cone = RoundCone::around(to, node.radius + node.hit_error);
                self.shadows.casters[self.shadows.count] = Caster {
                    cone,
                    lamp: number as u8,
                    object: node.object.index() as u16,
                };
                self.shadows.count += usize::from(to.length_squared() > node.r2);
            }
            let planes = &self.planes[..self.plane_count];
            for (plane, seen) in planes.iter().zip(&mut self.shadows.seen) {
                seen[number] = Projection::new(plane, lamp.position, self.eye, &self.axes.rows);
            }
        }
        self.outlined = self.first_shadow + self.plane_count * self.shadows.count;
        for number in self.first_shadow..self.outlined {
            let (caster, plane) = self.shadow(number);
            let seen = &self.shadows.seen[plane][usize::from(caster.lamp)];
            self.screen[number] = caster.cone.bounds(&seen.normals, self.axes.pixel);
        }
    }

    /// The object that shows what has an outline, given by its number: for a shadow, its plane, and for an image the first one.
    pub fn outlined_object(&self, number: usize) -> ObjectId {
        let shadow = number.saturating_sub(self.first_shadow);
        let plane = self.first_plane() + shadow / self.shadows.count.max(1);
        ObjectId::new(if number <= self.background() {
            number
        } else {
            plane
        })
    }

    /// A shadow, given by the number of its outline: the pair that casts it, and the number of its plane.
    fn shadow(&self, number: usize) -> (&Caster, usize) {
        let (shadow, count) = (number - self.first_shadow, self.shadows.count.max(1));
        (&self.shadows.casters[shadow % count], shadow / count)
    }

    /// The cone of camera rays that may meet a shadow, given by the number of its outline, and the share of its sine that is not
    /// sure, see [`RoundCone::unsure`].
    pub(super) fn shadow_cone(&self, number: usize) -> (Cone, f32) {
        let (&Caster { cone, lamp, object }, plane) = self.shadow(number);
        let rays = &self.shadows.seen[plane][usize::from(lamp)].rays;
        let error = self.outlines[usize::from(object)].hit_error();
        (cone.seen_by(rays), cone.unsure(error))
    }

    /// The caster of a shadow, given by the number of its outline: the object's number, the plane's, and where the lamp is.
    pub(super) fn caster(&self, number: usize) -> (usize, usize, Vec3A) {
        let (caster, plane) = self.shadow(number);
        let lamp = self.lamps[usize::from(caster.lamp)].position;
        (caster.object.into(), plane, lamp)
    }
}

/// The least height of the eye and of the lamp above a plane, as a share of the way from the lamp to the eye's mirror image, that
/// leaves shadows bounds which rounding cannot spoil.
const LEAST_HEIGHT: f32 = 0.01;

/// How the eye and a lamp see the points of a plane.
#[derive(Clone, Copy)]
struct Projection {
    /// The linear map from the camera's rays (u, v, 1) to the lamp's rays through the points where they meet the plane, up to a
    /// factor: its columns for u, v and 1.
    rays: [Vec3A; 3],
    /// The normals of the planes through the lamp that meet it where planes through the eye do whose normals are the camera's
    /// axes; zeros where rounding might turn them by more than bounds allow for.
    ///
    /// They are linear in the eye's. With H and L the heights of the eye and the lamp, and w the lamp's ray for the eye's ray d
    /// (see `cone`), `n . d H L = (n L - y (n . (lamp - eye))) . w`.
    normals: [Vec3A; 3],
}

impl Projection {
    /// All zeros.
    const ZERO: Self = Self {
        rays: [Vec3A::ZERO; 3],
        normals: [Vec3A::ZERO; 3],
    };

    /// Of an eye whose camera has some axes.
    fn new(plane: &Rectangle, lamp: Vec3A, eye: Vec3A, axes: &[Vec3A; 3]) -> Self {
        let height = eye.y - plane.centre.y;
        let mut by = (lamp - eye).extend(height);
        // Scaled so that all terms are below 2, with the sign that makes them point towards the plane.
        by *= (1.0 / by.length()).copysign(height);
        let (to, height) = (Vec3A::from_vec4(by), by.w);
        let above = height + to.y;
        let is_sure = height.min(above) > LEAST_HEIGHT;
        let normal = |axis: Vec3A| axis * above - Vec3A::Y * axis.dot(to);
        Self {
            rays: axes.map(|ray| ray * height + to * ray.y),
            normals: if is_sure {
                axes.map(normal)
            } else {
                [Vec3A::ZERO; 3]
            },
        }
    }
}
