//! The shadows of solids on planes, as cones in the picture. An area light casts the shadow of its centre, which lies in the penumbra.

use super::view::View;
use super::{Coverage, Outline};
use crate::prepare::{PreparedLight, World};
use crate::rounding::{CORNER_BY_LIGHT, LEAST_HEIGHT, USUAL};
use crate::scene::Plane;
use glam::Vec3A;

impl View {
    /// Returns the view of a light from points on a plane. The normals are zero where rounding exceeds the margins.
    ///
    /// The normals are linear in the eye's axes. With H and L the heights of eye and light, and w the light's ray for the eye's ray d (see
    /// `sides`), `n . d H L = (n L - y (n . (light - eye))) . w`.
    fn light(light: &PreparedLight, plane: &Plane, eye: Vec3A, axes: &[Vec3A; 3]) -> Self {
        let height = eye.y - plane.centre.y;
        let mut by = (light.position - eye).extend(height);
        // All terms are below 2, and point towards the plane.
        by *= (1.0 / by.length()).copysign(height);
        let (to, height) = (Vec3A::from_vec4(by), by.w);
        let above = height + to.y;
        let is_sure = height.min(above) > LEAST_HEIGHT;
        let normal = |axis: Vec3A| axis * above - Vec3A::Y * axis.dot(to);
        Self {
            from: light.position,
            rays: axes.map(|ray| ray * height + to * ray.y),
            normals: if is_sure { axes.map(normal) } else { [Vec3A::ZERO; 3] },
            corner: CORNER_BY_LIGHT,
            rounding: if light.is_point { 1.0 } else { USUAL },
        }
    }
}

impl Coverage {
    pub(super) fn set_shadows(&mut self, world: World<'_>) {
        for (plane, rectangle) in world.planes().iter().enumerate() {
            for (number, light) in world.lights().iter().enumerate() {
                let view = View::light(light, rectangle, world.eye, &self.axes.rows);
                self.shadows[plane][number] = view;
                for (_, node) in world.tree.solids() {
                    // Neither a sphere around the light nor a solid beyond the plane casts a shadow.
                    let to = node.centre - light.position;
                    let is_outside = node.is_block || to.length_squared() > node.r2;
                    let [_, most] = self.heights(node.object, rectangle, light.position);
                    if is_outside && most >= 0.0 {
                        let shadow = Outline::Shadow {
                            object: node.object,
                            plane: plane as u8,
                            light: number as u8,
                        };
                        // The shadow is magnified by the projection and foreshortened for the eye.
                        let height = light.position.y - rectangle.centre.y;
                        let scale = -height / to.y;
                        let at = light.position + to * scale;
                        let far = self.eye.reach(at, node.radius * scale);
                        let steep = (world.eye.y - rectangle.centre.y).abs() / far;
                        let thickness = self.objects[node.object.index()].thickness;
                        let width = 2.0 * thickness * scale * steep / far;
                        self.list(shadow, view.screen(node, self.axes.pixel), width);
                    }
                }
            }
        }
    }
}
