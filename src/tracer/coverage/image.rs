//! Bounds of the images of solids and lights in the first plane. An image's outline is its object's, as seen by the mirrored camera.

use super::bounds::{Coverage, Outline};
use super::screen::ScreenBounds;
use super::view::View;
use crate::prepare::{MAX_GROUPS, World};

impl Coverage {
    /// Computes the images' bounds, after the objects.
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
}
