//! What shading needs of an object.

use super::object::Object;
use crate::lanes::MAX_LANES;
use crate::scene::Material;
use glam::{Vec3A, Vec4};

/// A highlight below this is not computed: 1/40 of what 8 bits can show.
const FAINT: f32 = 1e-4;

/// More than any r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// Numbers of an object's surface that kernels spread over lanes:
///
/// - the centre, and 1 / radius of a sphere or 0 of what is none;
/// - the light that needs no lamp (ambient light reflected, or what a lamp or the background emits), and upright: 1 for a
///   plane, 0 for a sphere, so that the normal at p is `(p - centre) / radius + (0, upright, 0)`;
/// - the colour times the diffuse coefficient, and solid: 1 where lamps shine on it, 0 for lamps and the background;
/// - specular coefficient and exponent, the r.v below which there is no highlight, and the share of the reflected ray;
/// - the share of the transmitted ray, the refractive index, and the depth of the pattern, if that has edges.
pub(crate) const FIELDS: usize = 20;

/// Where the depth of the pattern is.
pub(crate) const PATTERN: usize = 18;

/// A surface's numbers, each in as many lanes as there can be: a packet that hits one object needs no more than its address.
pub(crate) type Spread = [[f32; MAX_LANES]; FIELDS];

/// Waves that are not steepened have no edges: they change as slowly as light does, and squares with them are filled by their
/// corners' colours. (The show's colonnade, of marble, takes two thirds of the time by it.)
const SOFT: f32 = 1.0;

/// The largest number of a surface of a valid scene, and what is above: no product of a few overflows.
const LARGEST: Vec4 = Vec4::splat(2e9);

/// Spreads the surface of an object of a material over lanes. What is no number, or out of all measure, counts as 0: it
/// would spoil the sum of a point even where it is multiplied by 0.
pub(super) fn spread(
    object: Object<'_>,
    m: &Material,
    ambient: Vec3A,
    background: Vec3A,
    lanes: &mut Spread,
) {
    let mut base = m.colour * ambient;
    let (mut centre, mut inverse_radius, mut solid, mut upright) = (Vec3A::ZERO, 0.0, 1.0, 0.0);
    let pattern = if m.pattern.edge > SOFT {
        m.pattern.depth
    } else {
        0.0
    };
    match object {
        Object::Sphere(sphere) => {
            (centre, inverse_radius) = (sphere.centre, 1.0 / sphere.radius);
        }
        // The details know more.
        Object::Block(_) => upright = 1.0,
        Object::Plane(plane) => (centre, upright) = (plane.centre, 1.0),
        Object::Lamp(light) => (base, solid) = (light.colour, 0.0),
        Object::Nothing => (base, solid) = (background, 0.0),
    }
    let faint = if m.ks > FAINT {
        root_below(FAINT / m.ks, m.exponent)
    } else {
        NO_HIGHLIGHT
    };
    let rows = [
        centre.extend(inverse_radius),
        base.extend(upright),
        (m.colour * m.kd).extend(solid),
        Vec4::new(m.ks, m.exponent, faint, m.kr),
        Vec4::new(m.kt, m.index, pattern, 0.0),
    ];
    for (lanes, row) in lanes.as_chunks_mut::<4>().0.iter_mut().zip(rows) {
        let row = Vec4::select(row.abs().cmple(LARGEST), row, Vec4::ZERO);
        for (lanes, field) in lanes.iter_mut().zip(row.to_array()) {
            *lanes = [field; MAX_LANES];
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
