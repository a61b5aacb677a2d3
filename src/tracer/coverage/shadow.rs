//! The shadows of solids on planes, as cones in the picture.
//!
//! A lamp with a size casts the shadows of its middle here, which lie in the penumbra, somewhere.
//!
//! # What rounding does
//!
//! By a point light, all pixels of a sphere's shadow are inside of its cone, and a point that is sure to be inside (see
//! `BoundingCone::unsure`) is dark. Let `h` be the sphere's hit error and `e` the same share, `HIT_ERROR`, of its distance from the
//! lamp. Shadow rays meet a sphere whose radius is smaller by `h + e` (see `ShadowCone::r2`), the cone is about one that is larger by
//! `h`, and a sure point is inside of one that is smaller by `2 h + 3 e`: `2 h + e` outside and `h + 2 e` inside are left for errors.
//! These are, at the sphere:
//!
//! - The vector from the lamp, and the perpendicular that is computed of it: some 2^-24 of the distance from the lamp, less than
//!   `e / 2`.
//! - The point on the plane, by its coordinates: less than `h / 3` by the coordinates of the sphere, and `e / 3` by the way from it, as
//!   an error that moves the far end of a ray from the lamp by a share of that way moves its part at the sphere by less. (Points are
//!   computed from the plane's centre. One that is much farther from the eye than all this is not allowed for.)
//! - The point on the plane, by its distance from the eye: some 2^-24 of it. A side's `ROUNDING` is 1e-5 of that distance there, as
//!   its terms are scaled by the way from the lamp to the eye's mirror image, which is longer than the eye is high.
//! - The cone's own terms: below `ROUNDING`, and `WIDE` is for the cosine.

use super::sides::CORNER_BY_LAMP;
use super::view::View;
use super::{Coverage, Outline};
use crate::prepare::{Lamp, World};
use crate::shapes::plane::Rectangle;
use glam::Vec3A;

/// The part of a side's rounding that is usual: some 5 roundings. That is enough for shadows that are not exact by more, and leaves
/// a part of the shadows by lamps that are a thousand times as far away.
const USUAL: f32 = 0.03;

/// The least height of the eye and of the lamp above a plane, as a share of the way from the lamp to the eye's mirror image, that
/// leaves shadows bounds which rounding cannot spoil.
const LEAST_HEIGHT: f32 = 0.01;

impl View {
    /// Returns the view of a lamp whose light a plane shows to an eye with some axes. The normals are zeros where rounding might turn
    /// them by more than bounds allow for.
    ///
    /// They are linear in the eye's. With H and L the heights of the eye and the lamp, and w the lamp's ray for the eye's ray d
    /// (see `sides`), `n . d H L = (n L - y (n . (lamp - eye))) . w`.
    fn lamp(lamp: &Lamp, plane: &Rectangle, eye: Vec3A, axes: &[Vec3A; 3]) -> Self {
        let height = eye.y - plane.centre.y;
        let mut by = (lamp.position - eye).extend(height);
        // Scaled so that all terms are below 2, with the sign that makes them point towards the plane.
        by *= (1.0 / by.length()).copysign(height);
        let (to, height) = (Vec3A::from_vec4(by), by.w);
        let above = height + to.y;
        let is_sure = height.min(above) > LEAST_HEIGHT;
        let normal = |axis: Vec3A| axis * above - Vec3A::Y * axis.dot(to);
        Self {
            from: lamp.position,
            rays: axes.map(|ray| ray * height + to * ray.y),
            normals: if is_sure {
                axes.map(normal)
            } else {
                [Vec3A::ZERO; 3]
            },
            corner: CORNER_BY_LAMP,
            rounding: if lamp.is_point { 1.0 } else { USUAL },
        }
    }
}

impl Coverage {
    /// Sets the bounds of the shadow of each solid on each plane by each lamp, after the objects.
    pub(super) fn set_shadows(&mut self, world: World<'_>) {
        for (plane, rectangle) in world.planes().iter().enumerate() {
            for (number, lamp) in world.lamps().iter().enumerate() {
                let view = View::lamp(lamp, rectangle, world.eye, &self.axes.rows);
                self.shadows[plane][number] = view;
                for (_, node) in world.tree.solids() {
                    // A sphere around the lamp casts no shadow, nor does a solid beyond the plane.
                    let to = node.centre - lamp.position;
                    let is_outside = node.is_block || to.length_squared() > node.r2;
                    let [_, most] = self.heights(node.object, rectangle, lamp.position);
                    if is_outside && most >= 0.0 {
                        let shadow = Outline::Shadow {
                            object: node.object,
                            plane: plane as u8,
                            lamp: number as u8,
                        };
                        self.list(shadow, view.screen(node, self.axes.pixel));
                    }
                }
            }
        }
    }
}
