//! What shading needs of an object.

use crate::scene::{Material, Plane, Sphere};
use glam::Vec3;

/// A highlight below this is not computed: 1/40 of what 8 bits can show.
const FAINT: f32 = 1e-4;

/// More than any r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// Numbers of a [`Surface`] that kernels spread over lanes.
pub(crate) const FIELDS: usize = 18;

/// An object's surface.
#[derive(Clone, Copy)]
pub(super) struct Surface {
    /// The normal at p is `(p - centre) inverse_radius + (0, upright, 0)`.
    pub centre: Vec3,
    /// 1 / radius of a sphere, 0 of a plane.
    pub inverse_radius: f32,
    /// 1 for a plane, 0 for a sphere.
    pub upright: f32,
    /// Light that needs no lamp: ambient light reflected, or what a lamp or the background emits.
    pub base: Vec3,
    /// Colour times diffuse coefficient.
    pub diffuse: Vec3,
    pub ks: f32,
    pub exponent: f32,
    /// No highlight where r.v is below this.
    pub faint: f32,
    pub kr: f32,
    pub kt: f32,
    pub index: f32,
    /// Lamps shine on it: 1, or 0 for lamps and the background.
    pub solid: f32,
}

impl Surface {
    /// No surface: all zeros, so that a frame's memory need not be part of a program's file.
    pub const NONE: Self = Self {
        centre: Vec3::ZERO,
        inverse_radius: 0.0,
        upright: 0.0,
        base: Vec3::ZERO,
        diffuse: Vec3::ZERO,
        ks: 0.0,
        exponent: 0.0,
        faint: 0.0,
        kr: 0.0,
        kt: 0.0,
        index: 0.0,
        solid: 0.0,
    };

    /// The numbers, in the order that [`crate::trace`] names them.
    pub fn fields(&self) -> [f32; FIELDS] {
        let Self {
            centre: c,
            base: b,
            diffuse: d,
            ..
        } = self;
        [
            c.x,
            c.y,
            c.z,
            b.x,
            b.y,
            b.z,
            d.x,
            d.y,
            d.z,
            self.inverse_radius,
            self.upright,
            self.ks,
            self.exponent,
            self.faint,
            self.kr,
            self.kt,
            self.index,
            self.solid,
        ]
    }

    /// A sphere's.
    pub fn sphere(sphere: &Sphere, ambient: Vec3) -> Self {
        Self {
            centre: sphere.centre,
            inverse_radius: 1.0 / sphere.radius,
            ..Self::of(&sphere.material, ambient)
        }
    }

    /// A plane's.
    pub fn plane(plane: &Plane, ambient: Vec3) -> Self {
        Self {
            centre: plane.centre,
            upright: 1.0,
            ..Self::of(&plane.material, ambient)
        }
    }

    /// Of what shines by itself.
    #[inline(never)]
    pub fn emitting(colour: Vec3) -> Self {
        Self {
            base: colour,
            faint: NO_HIGHLIGHT,
            ..Self::NONE
        }
    }

    #[inline(never)]
    fn of(material: &Material, ambient: Vec3) -> Self {
        let faint = root_below(FAINT / material.ks, material.exponent);
        Self {
            base: material.colour * ambient,
            diffuse: material.colour * material.kd,
            ks: material.ks,
            exponent: material.exponent,
            faint: if material.ks > FAINT {
                faint
            } else {
                NO_HIGHLIGHT
            },
            kr: material.kr,
            kt: material.kt,
            index: material.index,
            solid: 1.0,
            ..Self::NONE
        }
    }
}

/// At most the root of degree `h`, at least 1, of a number between 0 and 1, and at least 0.8 times that.
///
/// A number's bits are nearly its logarithm: `e + m` for `2^e (1 + m)`, which is below it by up to 0.09, and the way
/// back is above by up to a factor of 1.07.
fn root_below(x: f32, h: f32) -> f32 {
    const ONE: f32 = (1 << 23) as f32;
    const BIAS: f32 = 127.0;
    let log2 = x.to_bits() as f32 / ONE - BIAS;
    0.93 * f32::from_bits(((log2 / h + BIAS) * ONE) as u32)
}

#[cfg(test)]
mod tests {
    use super::root_below;

    #[test]
    fn roots_are_below_by_a_fifth_at_most() {
        for h in [1.0, 1.5, 2.0, 5.0, 10.0, 40.0, 100.0, 1000.0] {
            for i in 1..1000 {
                let x = i as f32 / 1000.0;
                let root = libm::powf(x, 1.0 / h);
                let below = root_below(x, h);
                assert!(
                    below <= root && below >= 0.8 * root,
                    "{x}, {h}: {below}, {root}"
                );
            }
        }
    }
}
