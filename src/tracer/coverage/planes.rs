//! Bounds of images in the first plane, and of shadows on planes.

use super::bounds::{Coverage, Outline};
use super::screen::ScreenBounds;
use super::view::View;
use crate::prepare::{MAX_GROUPS, World};

impl Coverage {
    /// Computes the images' bounds, after the objects. An image's outline is its object's, as seen
    /// by the mirrored camera.
    pub(super) fn set_images(&mut self, world: World<'_>) {
        let Some(plane) = world.scene.planes.first() else {
            return;
        };
        if !world.scene.water.is_calm() {
            // Images in waves may be anywhere.
            self.groups[1] = [ScreenBounds::ALL; MAX_GROUPS];
        } else if plane.material.is_specular() {
            let mut eye = world.eye;
            eye.y = 2.0 * plane.centre.y - eye.y;
            let mirrored = self.axes.rows.map(|row| row.with_y(-row.y));
            self.image = View::eye(eye, mirrored, self.axes.pixel);
            for (_, node) in world.tree.objects() {
                let screen = self.image.screen(node, self.axes.pixel);
                self.groups[1][node.group()].join(screen);
                // An object beyond the plane has no image.
                let [_, max] = self.heights(node.object, &world.planes()[0], world.eye);
                if self.objects[node.object.index()].is_finite() && max >= 0.0 {
                    let far = self.image.reach(node.centre, node.radius);
                    let width = 2.0 * self.objects[node.object.index()].thickness / far;
                    self.list(Outline::Image(node.object), screen, width);
                }
            }
        }
    }

    /// An area light counts as a point light at its centre, whose shadow ends inside the penumbra.
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
                    // No shadow is cast by a sphere around the light, a solid beyond the plane, or
                    // a clear solid if the light has a diameter.
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
