//! The shadows of solids on planes, as cones in the picture.
//!
//! The cone of a lamp about a solid does not depend on the plane, and the linear map from the camera's rays to the lamp's rays
//! (see `cone`) does not depend on the solid. Both are stored, and combined when a shadow is needed: storing all combinations
//! would take more memory than everything else. What is stored of each is a rectangle around it in the picture.
//!
//! A lamp with a size casts the shadows of its middle here, so that what is looked for lies in the penumbra, somewhere.
//!
//! # What rounding does
//!
//! By a point light, all pixels of a sphere's shadow are inside of its cone, and what is inside for sure (see [`RoundCone::unsure`]) is dark. Let `h` be the
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

use super::Prepared;
use super::cone::RoundCone;
use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS};
use crate::shapes::plane::Rectangle;
use glam::Vec3A;

/// The largest number of pairs of a solid and a lamp.
const MAX_CASTERS: usize = MAX_LIGHTS * MAX_SOLIDS;

/// The shadows of solids on planes.
pub(super) struct Shadows {
    /// Pairs of a solid and a lamp. Each casts a shadow on every plane.
    casters: [Caster; MAX_CASTERS],
    count: usize,
    /// For each plane, how each lamp and the eye see its points.
    seen: [[Projection; MAX_LIGHTS]; MAX_PLANES],
}

/// A solid that casts shadows by the light of one lamp.
#[derive(Clone, Copy)]
struct Caster {
    /// The cone around it, or around the bounding sphere of a block.
    cone: RoundCone,
    /// The lamp's number.
    lamp: u8,
    /// The solid's.
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
    /// Prepares the shadows, after objects and lamps. Spheres that contain a lamp have none. Solids on the far side of a plane are left
    /// out later.
    pub(super) fn set_shadows(&mut self) {
        self.shadows.count = 0;
        for (number, lamp) in self.lamps[..self.lamp_count].iter().enumerate() {
            for node in self.tree.solid_nodes() {
                if node.is_bound {
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
                let is_outside = to.length_squared() > node.r2;
                self.shadows.count += usize::from(node.is_block | is_outside);
            }
            let planes = &self.planes[..self.plane_count];
            for (plane, seen) in planes.iter().zip(&mut self.shadows.seen) {
                seen[number] = Projection::new(plane, lamp.position, self.eye, &self.axes.rows);
            }
        }
        self.outlined = self.first_shadow + self.plane_count * self.shadows.count;
        for number in self.first_shadow..self.outlined {
            let shadow = self.shadow(number);
            self.screen[number] = shadow.cone.bounds(&shadow.seen.normals, self.axes.pixel);
        }
    }

    /// A shadow, given by the number of its outline.
    pub fn shadow(&self, number: usize) -> Shadow<'_> {
        let (shadow, count) = (number - self.first_shadow, self.shadows.count.max(1));
        let caster = &self.shadows.casters[shadow % count];
        let (plane, lamp) = (shadow / count, usize::from(caster.lamp));
        Shadow {
            cone: &caster.cone,
            object: caster.object.into(),
            plane,
            seen: &self.shadows.seen[plane][lamp],
            lamp: self.lamps[lamp].position,
            is_sharp: self.lamps[lamp].is_point,
        }
    }
}

/// The shadow of a solid on a plane by the light of a lamp.
pub(crate) struct Shadow<'a> {
    /// See [`Caster::cone`].
    pub(super) cone: &'a RoundCone,
    /// The solid's number.
    pub object: usize,
    /// The plane's number.
    pub(super) plane: usize,
    /// How the eye and the lamp see the plane.
    pub(super) seen: &'a Projection,
    /// Where the lamp is.
    pub(super) lamp: Vec3A,
    /// Whether it is a point that shines in all directions, of whose shadows by spheres none is missed.
    pub(super) is_sharp: bool,
}

/// The least height of the eye and of the lamp above a plane, as a share of the way from the lamp to the eye's mirror image, that
/// leaves shadows bounds which rounding cannot spoil.
const LEAST_HEIGHT: f32 = 0.01;

/// How the eye and a lamp see the points of a plane.
#[derive(Clone, Copy)]
pub(super) struct Projection {
    /// The linear map from the camera's rays (u, v, 1) to the lamp's rays through the points where they meet the plane, up to a
    /// factor: its columns for u, v and 1.
    pub rays: [Vec3A; 3],
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
