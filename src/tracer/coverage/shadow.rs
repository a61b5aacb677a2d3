//! Bounds of the shadows of solids on planes. An area light counts as a point light at its centre, whose shadow ends inside the penumbra.

use super::bounds::{Coverage, Outline};
use super::view::View;
use crate::prepare::World;

impl Coverage {
    pub(super) fn set_shadows(&mut self, world: World<'_>) {
        for (plane, rectangle) in world.planes().iter().enumerate() {
            if rectangle.material.kd + rectangle.material.ks == 0.0 {
                continue;
            }
            for (number, light) in world.lights().iter().enumerate() {
                let height = light.position.y - rectangle.centre.y;
                if light.cone.misses_plane(height) {
                    continue;
                }
                let view = View::light(light, rectangle, &self.eye);
                self.shadows[plane][number] = view;
                for (_, node) in world.tree.solids() {
                    // No shadow is cast by a sphere around the light, a solid beyond the plane, or a clear solid if the light has a
                    // diameter.
                    let to = node.centre - light.position;
                    let is_outside = node.is_block || to.length_squared() > node.r2;
                    let casts = is_outside && !node.is_shadowless(light.diameter);
                    let [_, max] = self.heights(node.object, rectangle, light.position);
                    if casts && max >= 0.0 {
                        let shadow = Outline::Shadow {
                            object: node.object,
                            plane: plane as u8,
                            light: number as u8,
                        };
                        // The projection magnifies the shadow; the eye's angle foreshortens it.
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
