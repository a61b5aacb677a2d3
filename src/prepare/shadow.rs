//! The shadows of spheres on planes, as parts of the picture.
//!
//! A cone around a sphere, seen from a lamp, depends on these two alone; a linear image of the picture's rays, on the lamp and
//! the plane (see `cone`). So what each sphere, lamp and plane make is put together where it is asked for: kept, it would take
//! a dozen times the memory of all else.

use super::cone::{Cone, RoundCone};
use super::{Prepared, Rectangle};
use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS};
use glam::Vec3A;

/// The square of the least cosine of a shadow's cone: the lamp of a flatter one touches the sphere by 0.1 % of the radius.
const LEAST_COSINE2: f32 = 0.0025;

/// Spheres that throw shadows, each with a lamp: as many as there can be of both.
const MAX_CASTERS: usize = MAX_LIGHTS * MAX_SOLIDS;

/// What throws shadows.
pub(super) struct Shadows {
    /// Spheres by the light of a lamp; on every plane each has a shadow.
    casters: [Caster; MAX_CASTERS],
    count: usize,
    /// The rays from a lamp to where the picture's rays meet a plane, but for their lengths: what a step along u is, one along v,
    /// and (0, 0).
    rays: [[[Vec3A; 3]; MAX_LIGHTS]; MAX_PLANES],
}

/// A sphere by the light of a lamp.
#[derive(Clone, Copy)]
struct Caster {
    cone: RoundCone,
    /// The lamp's number.
    lamp: u8,
}

impl Shadows {
    /// None, all zeros.
    pub const NONE: Self = Self {
        casters: [Caster {
            cone: RoundCone::NONE,
            lamp: 0,
        }; MAX_CASTERS],
        count: 0,
        rays: [[[Vec3A::ZERO; 3]; MAX_LIGHTS]; MAX_PLANES],
    };
}

impl Prepared {
    /// Takes in what throws shadows; objects and lamps are in already. By a lamp that is more than a point there are none, nor of
    /// a sphere that the lamp is in, or nearly so. What is on the other side of a plane counts as well.
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
                self.shadows.count += usize::from(cosine2 > LEAST_COSINE2);
            }
            let planes = &self.planes[..self.plane_count];
            for (plane, rays) in planes.iter().zip(&mut self.shadows.rays) {
                rays[number] = rays_to(plane, lamp.position, self.eye, &self.axes.rows);
            }
        }
        self.outlined = self.background() + self.plane_count * self.shadows.count;
    }

    /// The object that is seen where something has the outline of a number: of a shadow, the plane.
    pub fn outlined_object(&self, number: usize) -> usize {
        match number.checked_sub(self.background()) {
            None => number,
            Some(shadow) => self.first_plane() + shadow / self.shadows.count.max(1),
        }
    }

    /// The rays of the picture that may meet the shadow with the outline of a number.
    #[inline(never)]
    pub fn shadow_cone(&self, number: usize) -> Cone {
        let Shadows {
            casters,
            count,
            rays,
        } = &self.shadows;
        let (shadow, count) = (number - self.background(), (*count).max(1));
        let caster = &casters[shadow % count];
        caster
            .cone
            .seen_by(&rays[shadow / count][caster.lamp as usize])
    }
}

/// The rays from a lamp to where rays from the eye meet a plane.
fn rays_to(plane: &Rectangle, lamp: Vec3A, eye: Vec3A, rays: &[Vec3A; 3]) -> [Vec3A; 3] {
    let height = eye.y - plane.centre.y;
    let mut by = (lamp - eye).extend(height);
    // Terms below 2, and forward, which is towards the plane.
    by *= (1.0 / by.length()).copysign(height);
    rays.map(|ray| ray * by.w + Vec3A::from_vec4(by) * ray.y)
}
