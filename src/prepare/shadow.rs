//! The shadows of spheres on planes, as cones in the picture.
//!
//! The cone of a lamp about a sphere does not depend on the plane, and the linear map from the camera's rays to the lamp's rays
//! (see `cone`) does not depend on the sphere. Both are stored, and combined when a shadow is needed: storing all combinations
//! would take a dozen times the memory of everything else.

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
    /// For each plane and lamp, the linear map from the camera's rays (u, v, 1) to the lamp's rays through the points where they
    /// meet the plane, up to a factor: its columns for u, v and 1.
    rays: [[[Vec3A; 3]; MAX_LIGHTS]; MAX_PLANES],
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
        rays: [[[Vec3A::ZERO; 3]; MAX_LIGHTS]; MAX_PLANES],
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
            for (plane, rays) in planes.iter().zip(&mut self.shadows.rays) {
                rays[number] = rays_to(plane, lamp.position, self.eye, &self.axes.rows);
            }
        }
        self.outlined = self.first_shadow + self.plane_count * self.shadows.count;
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

    /// The cone of camera rays that may meet a shadow, given by the number of its outline.
    #[inline(never)]
    pub fn shadow_cone(&self, number: usize) -> Cone {
        let Shadows {
            casters,
            count,
            rays,
        } = &self.shadows;
        let (shadow, count) = (number - self.first_shadow, (*count).max(1));
        let caster = &casters[shadow % count];
        caster
            .cone
            .seen_by(&rays[shadow / count][caster.lamp as usize])
    }
}

/// The rays from a lamp to the points where rays from the eye meet a plane, up to a common factor.
fn rays_to(plane: &Rectangle, lamp: Vec3A, eye: Vec3A, rays: &[Vec3A; 3]) -> [Vec3A; 3] {
    let height = eye.y - plane.centre.y;
    let mut by = (lamp - eye).extend(height);
    // Scaled so that all terms are below 2, with the sign that makes them point towards the plane.
    by *= (1.0 / by.length()).copysign(height);
    rays.map(|ray| ray * by.w + Vec3A::from_vec4(by) * ray.y)
}
