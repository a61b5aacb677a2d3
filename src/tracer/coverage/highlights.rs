//! The highlights of lights on objects in direct view.

use super::bounds::Coverage;
use super::highlight::{Highlight, VISIBLE};
use super::mirror::Mirror;
use crate::maths::to_f32;
use crate::prepare::{Object, ObjectId, World};
use glam::{Mat3A, Vec3A};

impl Coverage {
    /// Waves and solids around the eye get no highlights.
    pub(super) fn set_highlights(&mut self, world: World<'_>) {
        self.highlights.clear();
        for i in 0..world.background() {
            let (object, material) = world.object(ObjectId::new(i));
            let centre = Vec3A::from(object.centre());
            if i == world.first_plane() && !world.scene.water.is_calm() {
                continue;
            }
            let bounds = self.objects[i].screen.in_pixels(&self.axes);
            // The highlights of several lights may add up.
            let visible = VISIBLE / to_f32(world.lights().len());
            let tint = Vec3A::ONE.lerp(material.colour.into(), material.metallic);
            for light in world.lights() {
                let colour = tint * light.colour * (material.ks * world.weight * 255.0);
                let strength = colour.max_element();
                if strength <= visible {
                    continue;
                }
                let [eye, light] = [world.eye, light.position].map(|point| point - centre);
                Mirror::each(&object, eye, light, |mut place| {
                    // If the mirror point is off the block, use the nearest point within its half extents.
                    if let Object::Block(block) = object {
                        let (axes, half) = (Mat3A::from(block.axes), Vec3A::from(block.half));
                        // `clamp` may panic if a half is invalid.
                        place.p = axes * (axes.transpose() * place.p).max(-half).min(half);
                    }
                    let half_exponent = 0.5 * material.exponent;
                    let lobe = Highlight::at(&place, &self.axes, eye, light, half_exponent);
                    if let Some(lobe) = lobe {
                        let (object, bounds) = (ObjectId::new(i), lobe.bounds.max(bounds));
                        self.highlights.push(Highlight { object, bounds, strength, ..lobe });
                    }
                });
            }
        }
    }
}
