//! What shading needs of an object.

use super::air::BACKGROUND_HAZE;
use super::object::Object;
use crate::lanes::MAX_LANES;
use crate::scene::{Material, Scene};
use glam::Vec3A;

/// A highlight below this is not computed: 1/40 of what 8 bits can show.
const FAINT: f32 = 1e-4;

/// More than any r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// An object's surface: of numbers, or of [`Row`]s.
pub(crate) struct Surface<T> {
    /// The centre of a sphere or a plane.
    pub centre: [T; 3],
    /// 1 / radius of a sphere, 0 of what is none. The normal at p is `(p - centre) / radius + (0, upright, 0)`.
    pub inverse_radius: T,
    /// 1 for a plane, 0 for a sphere.
    pub upright: T,
    /// 1 where lamps shine on it, 0 for lamps and the background.
    pub is_lit: T,
    /// The light that needs no lamp: ambient light reflected, or what a lamp or the background emits.
    pub emitted: [T; 3],
    /// The colour times the diffuse coefficient.
    pub diffuse: [T; 3],
    /// Specular coefficient.
    pub ks: T,
    /// Exponent of the highlight.
    pub exponent: T,
    /// The r.v below which there is no highlight.
    pub highlight_start: T,
    /// Share of the reflected ray.
    pub kr: T,
    /// Share of the transmitted ray.
    pub kt: T,
    /// Refractive index.
    pub index: T,
    /// Haze between it and a ray's start, in 1 / scene units.
    pub haze: T,
}

/// A number in as many lanes as there can be.
pub(crate) type Row = [f32; MAX_LANES];

/// Surfaces of a packet's lanes, a number of each lane in a row.
pub(crate) type SurfaceRow = Surface<Row>;

/// Numbers of a surface.
const NUMBERS: usize = 19;

/// The largest number of a surface of a valid scene, and what is above: no product of a few overflows.
const LARGEST: f32 = 2e9;

impl<T: Copy> Surface<T> {
    /// A surface whose numbers are all the same.
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
            kt: number,
            index: number,
            haze: number,
        }
    }
}

impl<T> Surface<T> {
    /// Its numbers, in the order of the fields.
    #[inline(always)]
    pub fn rows(&self) -> [&T; NUMBERS] {
        let Self {
            centre: [x, y, z],
            inverse_radius,
            upright,
            is_lit,
            emitted: [red, green, blue],
            diffuse: [diffuse_red, diffuse_green, diffuse_blue],
            ks,
            exponent,
            highlight_start,
            kr,
            kt,
            index,
            haze,
        } = self;
        [
            x,
            y,
            z,
            inverse_radius,
            upright,
            is_lit,
            red,
            green,
            blue,
            diffuse_red,
            diffuse_green,
            diffuse_blue,
            ks,
            exponent,
            highlight_start,
            kr,
            kt,
            index,
            haze,
        ]
    }

    /// The same, to be written.
    #[inline(always)]
    pub fn rows_mut(&mut self) -> [&mut T; NUMBERS] {
        let Self {
            centre: [x, y, z],
            inverse_radius,
            upright,
            is_lit,
            emitted: [red, green, blue],
            diffuse: [diffuse_red, diffuse_green, diffuse_blue],
            ks,
            exponent,
            highlight_start,
            kr,
            kt,
            index,
            haze,
        } = self;
        [
            x,
            y,
            z,
            inverse_radius,
            upright,
            is_lit,
            red,
            green,
            blue,
            diffuse_red,
            diffuse_green,
            diffuse_blue,
            ks,
            exponent,
            highlight_start,
            kr,
            kt,
            index,
            haze,
        ]
    }
}

impl SurfaceRow {
    /// Nothing, all zeros.
    pub const ZERO: Self = Self::filled([0.0; MAX_LANES]);

    /// Spreads a surface over all lanes. (It is done for few packets: not worth a copy for each instruction set.)
    #[inline(never)]
    pub fn set(&mut self, surface: &Surface<f32>) {
        for (row, &number) in self.rows_mut().into_iter().zip(surface.rows()) {
            *row = [number; MAX_LANES];
        }
    }
}

/// A number of a surface; what is not a number, or is beyond [`LARGEST`], counts as 0: it would spoil the sum of a point even
/// where it is multiplied by 0.
pub(super) fn bounded(number: f32) -> f32 {
    if number.abs() <= LARGEST { number } else { 0.0 }
}

impl Surface<f32> {
    /// Nothing, all zeros.
    pub const ZERO: Self = Self::filled(0.0);

    /// Takes in the surface of an object of a scene, its numbers [`bounded`].
    pub fn set(&mut self, object: &Object<'_>, material: &Material, scene: &Scene) {
        *self = Self::of(object, material, scene);
        for number in self.rows_mut() {
            *number = bounded(*number);
        }
    }

    /// The surface of an object of a scene, as its numbers come.
    fn of(object: &Object<'_>, material: &Material, scene: &Scene) -> Self {
        let emitted = match object {
            Object::Lamp(light) => light.colour,
            Object::Background => scene.background,
            _ => material.colour * scene.ambient,
        };
        let (centre, inverse_radius) = match object {
            Object::Sphere(sphere) => (sphere.centre, 1.0 / sphere.radius),
            Object::Plane(plane) => (plane.centre, 0.0),
            // Where a block is hit, `trace::block` knows.
            _ => (Vec3A::ZERO, 0.0),
        };
        let highlight_start = if material.ks > FAINT {
            root_below(FAINT / material.ks, material.exponent)
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
                Object::Lamp(_) | Object::Background => 0.0,
                _ => 1.0,
            },
            emitted: emitted.to_array(),
            diffuse: (material.colour * material.kd).to_array(),
            ks: material.ks,
            exponent: material.exponent,
            highlight_start,
            kr: material.kr,
            kt: material.kt,
            index: material.index,
            haze: match object {
                Object::Lamp(_) => 0.0,
                Object::Background => scene.haze + BACKGROUND_HAZE,
                _ => scene.haze,
            },
        }
    }
}

/// At most the root of degree `h`, 1 to 1000, of a number from [`FAINT`] to 1, and at least 0.8 times that.
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
    use super::{FAINT, root_below};

    #[test]
    fn roots_are_below_by_a_fifth_at_most() {
        for h in [1.0, 1.5, 2.0, 5.0, 10.0, 40.0, 100.0, 1000.0] {
            for i in 1..100_000 {
                // From the least that it is asked for, where ks is 1.
                let x = FAINT.max(i as f32 / 100_000.0);
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
