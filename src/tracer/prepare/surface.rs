//! The surface parameters of an object, prepared for shading.

use super::object::Object;
use crate::lanes::MAX_LANES;
use crate::scene::{Material, Scene};
use glam::Vec3;

/// Highlights below this are not computed: 1/40 of a step of 8-bit output.
const MIN_HIGHLIGHT: f32 = 1e-4;

/// More than any value of r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// Declares the numbers of a surface, each once: a field with one name, or with three for the components of a vector.
macro_rules! surface {
    ($($(#[$doc:meta])* $field:ident [$($number:ident)*],)*) => {
        /// An object's surface, with each parameter either one number or a [`PerLane`] of them. Lengths are in scene units.
        pub(crate) struct Surface<T> {
            $($(#[$doc])* pub $field: surface!(@type T $($number)*),)*
        }

        /// How many numbers a surface has.
        pub(crate) const SURFACE_NUMBERS: usize = [$($(stringify!($number)),*),*].len();

        impl<T> Surface<T> {
            /// Gives a surface's numbers their names.
            #[inline(always)]
            pub fn from_numbers([$($($number),*),*]: [T; SURFACE_NUMBERS]) -> Self {
                Self {
                    $($field: surface!(@value $($number)*),)*
                }
            }

            /// The numbers, in the same order.
            fn into_numbers(self) -> [T; SURFACE_NUMBERS] {
                let Self {
                    $($field: surface!(@value $($number)*),)*
                } = self;
                [$($($number),*),*]
            }
        }
    };
    (@type $type:ident $number:ident) => { $type };
    (@type $type:ident $x:ident $y:ident $z:ident) => { [$type; 3] };
    (@value $number:ident) => { $number };
    (@value $x:ident $y:ident $z:ident) => { [$x, $y, $z] };
}

surface! {
    /// The centre of a sphere or a plane.
    centre [centre_x centre_y centre_z],
    /// 1 / radius for a sphere, otherwise 0: then the normal is upright, or a block's.
    inverse_radius [inverse_radius],
    /// 1 for surfaces on which lights shine, 0 for the lights' own spheres and the background.
    is_lit [is_lit],
    /// The radiance that does not depend on lights: reflected ambient light, or the light's or the background's own colour.
    emitted [emitted_red emitted_green emitted_blue],
    /// The colour times the diffuse coefficient.
    diffuse [diffuse_red diffuse_green diffuse_blue],
    /// The share of a lamp's light that highlights keep, per channel.
    highlight [highlight_red highlight_green highlight_blue],
    /// The specular coefficient.
    ks [ks],
    /// The exponent of the highlight.
    exponent [exponent],
    /// The smallest r.v with a visible highlight.
    highlight_start [highlight_start],
    /// The weight of the reflected ray.
    kr [kr],
    /// See [`Material::fresnel`].
    fresnel [fresnel],
    /// The weight of the transmitted ray.
    kt [kt],
    /// The refractive index.
    index [index],
}

/// A surface's numbers, in the order of [`Surface::from_numbers`].
pub(crate) type SurfaceNumbers = [f32; SURFACE_NUMBERS];

/// One number for each lane of the widest instruction set.
pub(crate) type PerLane = [f32; MAX_LANES];

/// The numbers of the surfaces that the lanes of a packet hit, each for all lanes.
pub(crate) type SurfaceTable = [PerLane; SURFACE_NUMBERS];

/// More than any parameter of a valid scene, and so small that products of a few such numbers do not overflow.
const LARGEST: f32 = 2e9;

/// A number, or 0 if it is NaN or its magnitude exceeds [`LARGEST`]: such a number would spoil the sum of a point even if it were
/// multiplied by 0.
pub(super) fn bounded(number: f32) -> f32 {
    if number.abs() <= LARGEST { number } else { 0.0 }
}

impl Surface<f32> {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: SurfaceNumbers = [0.0; SURFACE_NUMBERS];

    /// The surface of an object, with all numbers [`bounded`].
    pub fn numbers(object: &Object<'_>, material: &Material, scene: &Scene) -> SurfaceNumbers {
        Self::of(object, material, scene)
            .into_numbers()
            .map(bounded)
    }

    /// The surface of an object, without bounds on its numbers.
    fn of(object: &Object<'_>, material: &Material, scene: &Scene) -> Self {
        let emitted = match object {
            Object::Light(light) => light.colour,
            Object::Background => scene.background,
            Object::Sphere(_) | Object::Block(_) | Object::Plane(_) => {
                material.colour * scene.ambient
            }
        };
        let (centre, inverse_radius) = match object {
            Object::Sphere(sphere) => (sphere.centre, 1.0 / sphere.radius),
            Object::Plane(plane) => (plane.centre, 0.0),
            // Of a block the tracer computes the point that is hit.
            Object::Block(_) | Object::Light(_) | Object::Background => (Vec3::ZERO, 0.0),
        };
        let highlight_start = if material.ks > MIN_HIGHLIGHT {
            root_below(MIN_HIGHLIGHT / material.ks, material.exponent)
        } else {
            NO_HIGHLIGHT
        };
        Self {
            centre: centre.to_array(),
            inverse_radius,
            is_lit: match object {
                Object::Light(_) | Object::Background => 0.0,
                Object::Sphere(_) | Object::Block(_) | Object::Plane(_) => 1.0,
            },
            emitted: emitted.to_array(),
            diffuse: (material.colour * material.kd).to_array(),
            highlight: Vec3::ONE
                .lerp(material.colour, material.metallic)
                .to_array(),
            ks: material.ks,
            exponent: material.exponent,
            highlight_start,
            kr: material.kr,
            fresnel: material.fresnel,
            kt: material.kt,
            index: material.index,
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
