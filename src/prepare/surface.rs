//! What shading needs of an object.

use crate::lanes::MAX_LANES;
use crate::scene::Material;
use glam::Vec3A;

/// A highlight below this is not computed: 1/40 of what 8 bits can show.
const FAINT: f32 = 1e-4;

/// More than any r.v.
const NO_HIGHLIGHT: f32 = 2.0;

/// Numbers of a [`Surface`].
pub(crate) const FIELDS: usize = 18;

/// What kernels spread over lanes: the centre, the light that needs no lamp (ambient light reflected, or what a lamp or the
/// background emits), the colour times the diffuse coefficient, three numbers each; then
///
/// - 1 / radius of a sphere, 0 of a plane;
/// - upright: 1 for a plane, 0 for a sphere, so that the normal at p is `(p - centre) / radius + (0, upright, 0)`;
/// - specular coefficient and exponent, and the r.v below which there is no highlight;
/// - the shares of the reflected and of the transmitted ray, and the refractive index;
/// - solid: 1 where lamps shine on it, 0 for lamps and the background.
pub(crate) type Surface = [f32; FIELDS];

/// A surface's numbers, each in as many lanes as there can be: a packet that hits one object needs no more than its address.
pub(crate) type Spread = [[f32; MAX_LANES]; FIELDS];

/// The largest number of a surface of a valid scene, and what is above: no product of a few overflows.
const LARGEST: f32 = 2e9;

/// Spreads a surface over lanes. What is no number, or out of all measure, counts as 0: it would spoil the sum of a point
/// even where it is multiplied by 0.
#[inline(never)]
pub(super) fn spread(surface: &Surface, lanes: &mut Spread) {
    for (lanes, &field) in lanes.iter_mut().zip(surface) {
        let field = if field.abs() <= LARGEST { field } else { 0.0 };
        *lanes = [field; MAX_LANES];
    }
}

/// The surface of an object of a material; `inverse_radius` is 0 for a plane.
#[inline(never)]
pub(super) fn solid(
    centre: Vec3A,
    inverse_radius: f32,
    material: &Material,
    ambient: Vec3A,
) -> Surface {
    let m = material;
    let (base, diffuse) = (m.colour * ambient, m.colour * m.kd);
    let upright = if inverse_radius == 0.0 { 1.0 } else { 0.0 };
    let faint = if m.ks > FAINT {
        root_below(FAINT / m.ks, m.exponent)
    } else {
        NO_HIGHLIGHT
    };
    [
        centre.x,
        centre.y,
        centre.z,
        base.x,
        base.y,
        base.z,
        diffuse.x,
        diffuse.y,
        diffuse.z,
        inverse_radius,
        upright,
        m.ks,
        m.exponent,
        faint,
        m.kr,
        m.kt,
        m.index,
        1.0,
    ]
}

/// The surface of what shines by itself.
#[inline(never)]
pub(super) fn emitting(colour: Vec3A) -> Surface {
    let mut surface = [0.0; FIELDS];
    surface[3..6].copy_from_slice(&colour.to_array());
    surface[13] = NO_HIGHLIGHT;
    surface
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
