//! The highlights of lights on objects in direct view, as ellipses in the picture.
//!
//! A lobe of Phong's model is `ks (r.l)^h = ks (1 - d.d / 2)^h`, where d is the mirrored ray r
//! minus the direction l to the light. Around the point where d = 0, d is nearly linear in the
//! pixels x and y, so the lobe is `ks e^-u` with the decay `u = a x^2 + 2 b x y + c y^2`.
//! `Material::anisotropy`, which widens a lobe, is ignored.

use super::bounds::{Coverage, Highlight};
use super::mirror::Mirror;
use super::screen::Axes;
use crate::maths::{sqrt, to_f32};
use crate::prepare::{Object, ObjectId, World};
use crate::rounding::DRAWN_OUT;
use crate::zero::Zero;
use glam::{Mat3A, Vec2, Vec3A, Vec4, Vec4Swizzles};

/// The least visible difference in brightness, in 255ths: larger errors count as wrong pixels.
/// Lights share it: their highlights may add up.
pub(crate) const VISIBLE: f32 = 8.0;

/// The decay u at which a highlight ends: `255 e^-u` is below [`VISIBLE`].
const END_DECAY: f32 = 3.5;

/// The factor on the decay: off its centre a lobe may be wider than the Gaussian.
const COUNTED_DECAY: f32 = 0.75;

impl Highlight {
    pub fn meets(&self, rect: Vec4) -> bool {
        self.bounds.cmple(rect.zwxy() * Vec4::new(1.0, 1.0, -1.0, -1.0)).all()
    }

    /// Returns the least and greatest x between the rows `top` and `bottom` at which the highlight
    /// has not ended and the decay is at most `reach`.
    pub fn columns(&self, top: f32, bottom: f32, reach: f32) -> [f32; 2] {
        let [a, b, c] = self.decay;
        let [top, bottom] = [top, bottom].map(|y| y - self.middle.y);
        let near = top.max(0.0).min(bottom);
        let rest = reach.min(END_DECAY) - (c * (1.0 - DRAWN_OUT) - b * b / a) * near * near;
        let half = if rest < 0.0 { f32::NEG_INFINITY } else { sqrt(rest / a) };
        let [x, other] = [top, bottom].map(|y| self.middle.x - b / a * y);
        [(x.min(other) - half).max(self.bounds.x), (x.max(other) + half).min(-self.bounds.z)]
    }

    /// Returns the highlight at a mirror point, or `None` if the object hides the point from the
    /// eye or the light.
    fn at(
        mirror: &Mirror,
        axes: &Axes,
        eye: Vec3A,
        light: Vec3A,
        half_exponent: f32,
    ) -> Option<Self> {
        let &Mirror { p, n, curvature, axis } = mirror;
        let (to, to_light) = (p - eye, light - p);
        let (distance, light_distance) = (to.length(), to_light.length());
        let (d, l) = (to / distance, to_light / light_distance);
        let [x, y, depth] = axes.rows.map(|row| row.dot(to));
        let facing = -d.dot(n);
        let is_visible = depth.min(facing).min(l.dot(n)) > 0.0;
        if !is_visible {
            return None;
        }
        // The change of the mirrored ray minus l from pixel to pixel.
        let [right, down] = [axes.rows[0], axes.rows[1]].map(|step| {
            let step = (step + d * (step.dot(n) / facing)) * (depth * axes.pixel);
            let turned = (step - axis * step.dot(axis)) * curvature;
            let ray = (step - d * d.dot(step)) / distance;
            let mirrored = ray - (n * (ray.dot(n) + d.dot(turned)) - turned * facing) * 2.0;
            mirrored + (step - l * l.dot(step)) / light_distance
        });
        let scale = COUNTED_DECAY * half_exponent;
        let [a, b, c] =
            [(right, right), (right, down), (down, down)].map(|(v, w)| v.dot(w) * scale);
        let scale = END_DECAY / (a * c - b * b).max(a * c * DRAWN_OUT);
        let middle = axes.pixel_at(x / depth, y / depth);
        let reach = Vec2::new(sqrt(c * scale), sqrt(a * scale));
        Some(Self {
            middle,
            bounds: Vec4::from((middle - reach, -middle - reach)),
            decay: [a, b, c],
            ..Self::ZERO
        })
    }
}

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
                    // If the mirror point is off the block, use the nearest point within its half
                    // extents.
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
