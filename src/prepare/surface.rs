//! The surface parameters of an object, prepared for shading.

use super::air::BACKGROUND_HAZE;
use super::object::Object;
use crate::lanes::MAX_LANES;
use crate::scene::{Material, Scene};
use glam::Vec3A;

/// Highlights below this are not computed: 1/40 of a step of 8-bit output.
const MIN_HIGHLIGHT: f32 = 1e-4;

/// More than any value of r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// An object's surface, with each parameter either one number or a [`PerLane`] of them. Lengths are in scene units.
pub(crate) struct Surface<T> {
    /// The centre of a sphere or a plane.
    pub centre: [T; 3],
    /// 1 / radius for a sphere, otherwise 0. The normal at p is `(p - centre) / radius + (0, upright, 0)`.
    pub inverse_radius: T,
    /// 1 for a plane or a block, 0 for a sphere.
    pub upright: T,
    /// 1 for surfaces on which lights shine, 0 for the lights' own spheres and the background.
    pub is_lit: T,
    /// The radiance that does not depend on lights: reflected ambient light, or the light's or the background's own colour.
    pub emitted: [T; 3],
    /// The colour times the diffuse coefficient.
    pub diffuse: [T; 3],
    /// The specular coefficient.
    pub ks: T,
    /// The exponent of the highlight.
    pub exponent: T,
    /// The smallest r.v with a visible highlight.
    pub highlight_start: T,
    /// The weight of the reflected ray.
    pub kr: T,
    /// See [`Material::fresnel`].
    pub fresnel: T,
    /// The weight of the transmitted ray.
    pub kt: T,
    /// The refractive index.
    pub index: T,
    /// The density of the haze in front of it, in 1 / scene units.
    pub haze: T,
}

/// One number for each lane of the widest instruction set.
pub(crate) type PerLane = [f32; MAX_LANES];

/// The surfaces that the lanes of a packet hit.
pub(crate) type SurfaceRow = Surface<PerLane>;

/// More than any parameter of a valid scene, and so small that products of a few such numbers do not overflow.
const LARGEST: f32 = 2e9;

impl<T: Copy> Surface<T> {
    /// A surface with the same number for all parameters.
    const fn filled(number: T) -> Self {
        Self {
            centre: [number; 3],
            inverse_radius: number,
            upright: number,
            is_lit: number,
            emitted: [number; 3],
            diffuse: [number; 3],
            ks: number,
            exponent: number,
            highlight_start: number,
            kr: number,
            fresnel: number,
            kt: number,
            index: number,
            haze: number,
        }
    }
}

impl<T> Surface<T> {
    /// Calls with each of its parameters and the same ones of other surfaces.
    #[inline(always)]
    pub fn for_each<const N: usize>(
        &mut self,
        others: [&Surface<f32>; N],
        mut call: impl FnMut(&mut T, [f32; N]),
    ) {
        for i in 0..3 {
            call(&mut self.centre[i], others.map(|other| other.centre[i]));
            call(&mut self.emitted[i], others.map(|other| other.emitted[i]));
            call(&mut self.diffuse[i], others.map(|other| other.diffuse[i]));
        }
        call(
            &mut self.inverse_radius,
            others.map(|other| other.inverse_radius),
        );
        call(&mut self.upright, others.map(|other| other.upright));
        call(&mut self.is_lit, others.map(|other| other.is_lit));
        call(&mut self.ks, others.map(|other| other.ks));
        call(&mut self.exponent, others.map(|other| other.exponent));
        call(
            &mut self.highlight_start,
            others.map(|other| other.highlight_start),
        );
        call(&mut self.kr, others.map(|other| other.kr));
        call(&mut self.fresnel, others.map(|other| other.fresnel));
        call(&mut self.kt, others.map(|other| other.kt));
        call(&mut self.index, others.map(|other| other.index));
        call(&mut self.haze, others.map(|other| other.haze));
    }
}

impl SurfaceRow {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self::filled([0.0; MAX_LANES]);

    /// Copies a surface to all lanes. Few packets need that, so it is compiled only once, not for each instruction set.
    #[inline(never)]
    pub fn set(&mut self, surface: &Surface<f32>) {
        self.for_each([surface], |row, [number]| *row = [number; MAX_LANES]);
    }
}

/// A number, or 0 if it is NaN or its magnitude exceeds [`LARGEST`]: such a number would spoil the sum of a point even if it were
/// multiplied by 0.
pub(super) fn bounded(number: f32) -> f32 {
    if number.abs() <= LARGEST { number } else { 0.0 }
}

impl Surface<f32> {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self::filled(0.0);

    /// Prepares the surface of an object, with all numbers [`bounded`].
    pub fn set(&mut self, object: &Object<'_>, material: &Material, scene: &Scene) {
        *self = Self::of(object, material, scene);
        self.for_each([], |number, []| *number = bounded(*number));
    }

    /// The surface of an object, without bounds on its numbers.
    fn of(object: &Object<'_>, material: &Material, scene: &Scene) -> Self {
        let emitted = match object {
            Object::Light(light) => light.colour,
            Object::Background => scene.background,
            _ => material.colour * scene.ambient,
        };
        let (centre, inverse_radius) = match object {
            Object::Sphere(sphere) => (sphere.centre, 1.0 / sphere.radius),
            Object::Plane(plane) => (plane.centre, 0.0),
            // Blocks: `trace::block` computes the point that is hit.
            _ => (Vec3A::ZERO, 0.0),
        };
        let highlight_start = if material.ks > MIN_HIGHLIGHT {
            root_below(MIN_HIGHLIGHT / material.ks, material.exponent)
        } else {
            NO_HIGHLIGHT
        };
        Self {
            centre: centre.to_array(),
            inverse_radius,
            upright: match object {
                Object::Plane(_) | Object::Block(_) => 1.0,
                _ => 0.0,
            },
            is_lit: match object {
                Object::Light(_) | Object::Background => 0.0,
                _ => 1.0,
            },
            emitted: emitted.to_array(),
            diffuse: (material.colour * material.kd).to_array(),
            ks: material.ks,
            exponent: material.exponent,
            highlight_start,
            kr: material.kr,
            fresnel: material.fresnel,
            kt: material.kt,
            index: material.index,
            haze: match object {
                Object::Light(_) => 0.0,
                Object::Background => scene.haze + BACKGROUND_HAZE,
                _ => scene.haze,
            },
        }
    }
}

/// A lower bound of the root of degree `h`, 1 to 1000, of a number from [`MIN_HIGHLIGHT`] to 1: at least 0.8 times the
/// root.
///
/// The bits of a float approximate its logarithm: they give `e + m` for `2^e (1 + m)`, which is too small by up to 0.09. The
/// inverse is too large by up to a factor of 1.07.
fn root_below(x: f32, h: f32) -> f32 {
    const ONE: f32 = (1 << 23) as f32;
    const BIAS: f32 = 127.0;
    let log2 = x.to_bits() as f32 / ONE - BIAS;
    0.93 * f32::from_bits(((log2 / h + BIAS) * ONE) as u32)
}

#[cfg(test)]
mod tests {
    use super::{MIN_HIGHLIGHT, root_below};

    #[test]
    fn roots_are_below_by_a_fifth_at_most() {
        for h in [1.0, 1.5, 2.0, 5.0, 10.0, 40.0, 100.0, 1000.0] {
            for i in 1..100_000 {
                // The smallest argument that occurs, for ks = 1.
                let x = MIN_HIGHLIGHT.max(i as f32 / 100_000.0);
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
