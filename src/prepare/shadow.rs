//! The shadows of spheres on planes, as cones in the picture.
//!
//! The cone of a lamp about a sphere does not depend on the plane, and the linear map from the camera's rays to the lamp's rays
//! (see `cone`) does not depend on the sphere. Both are stored, and combined when a shadow is needed: storing all combinations
//! would take more memory than everything else. What is stored of each is a rectangle around it in the picture.

use super::cone::{Cone, RoundCone};
use super::{ObjectId, Prepared, Rectangle};
use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS};
use glam::Vec3A;

/// The smallest squared cosine of a shadow's cone. Wider cones, whose lamp is within 0.1 % of the radius from the sphere, are
/// left out.
const MIN_COSINE2: f32 = 0.0025;

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
}

impl Shadows {
    /// All zeros: no shadows.
    pub const ZERO: Self = Self {
        casters: [Caster {
            cone: RoundCone::ZERO,
            lamp: 0,
        }; MAX_CASTERS],
        count: 0,
        seen: [[Projection::ZERO; MAX_LIGHTS]; MAX_PLANES],
    };
}

impl Prepared {
    /// Prepares the shadows, after objects and lamps. Lamps that are not points have none, nor do spheres that contain a lamp or
    /// nearly touch it. Spheres on the far side of a plane are not left out.
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
                let (cone, cosine2) = RoundCone::around(node.centre - lamp.position, node.radius);
                self.shadows.casters[self.shadows.count] = Caster {
                    cone,
                    lamp: number as u8,
                };
                self.shadows.count += usize::from(cosine2 > MIN_COSINE2);
            }
            let planes = &self.planes[..self.plane_count];
            for (plane, seen) in planes.iter().zip(&mut self.shadows.seen) {
                seen[number] = Projection::new(plane, lamp.position, self.eye, &self.axes.rows);
            }
        }
        self.outlined = self.first_shadow + self.plane_count * self.shadows.count;
        for number in self.first_shadow..self.outlined {
            let (cone, seen) = self.shadow(number);
            self.screen[number] = cone.bounds(&seen.normals, self.axes.pixel);
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

    /// A shadow, given by the number of its outline: the cone of the lamp's rays, and how they are seen.
    fn shadow(&self, number: usize) -> (&RoundCone, &Projection) {
        let Shadows {
            casters,
            count,
            seen,
        } = &self.shadows;
        let (shadow, count) = (number - self.first_shadow, (*count).max(1));
        let caster = &casters[shadow % count];
        (&caster.cone, &seen[shadow / count][caster.lamp as usize])
    }

    /// The cone of camera rays that may meet a shadow, given by the number of its outline.
    pub fn shadow_cone(&self, number: usize) -> Cone {
        let (cone, seen) = self.shadow(number);
        cone.seen_by(&seen.rays)
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
