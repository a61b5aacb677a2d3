//! Contributions of a packet's hits to their points.

use super::sample::FIXED_POINT;
use crate::lanes::*;

/// The largest contribution of a node of the ray tree, as a multiple of full brightness.
///
/// More than 1 is not visible, since contributions are not negative. With this bound the sum over the 255 nodes of the deepest
/// tree does not overflow.
const BRIGHTEST: f32 = 2.0;

/// The contributions of a packet's hits to their points.
pub(super) struct Contribution<S: Isa> {
    pub colour: Vec3x<S>,
    pub key: U<S>,
    /// The part of the colour that a texture leaves a share of, and that share; of rays that hit no lamp and no
    /// background.
    pub untextured: Vec3x<S>,
    pub reflectance: F<S>,
}

impl<S: Isa> Contribution<S> {
    /// Stores blue, green and red in fixed point and the key, a point after the other.
    #[inline(always)]
    pub fn store(&self, simd: S, sums: &mut [i32]) {
        let Vec3x { x, y, z } = self.colour;
        let (blue, green, red) = (fixed(simd, z), fixed(simd, y), fixed(simd, x));
        store_transposed([blue, green, red, self.key.bitcast()], sums);
    }

    /// Stores blue, green and red of what is untextured, in output steps, and the share that the texture leaves of it, a
    /// point after the other.
    #[inline(always)]
    pub fn store_layers(&self, layers: &mut [f32]) {
        let Vec3x { x, y, z } = self.untextured;
        store_transposed([z * 255.0, y * 255.0, x * 255.0, self.reflectance], layers);
    }
}

/// A number in fixed point, rounded to the nearest.
#[inline(always)]
fn fixed<S: Isa>(simd: S, c: F<S>) -> I<S> {
    let c = clamp::<S>(c, splat(simd, 0.0), splat(simd, BRIGHTEST));
    // One half is added, since the conversion truncates.
    c.mul_add(splat(simd, FIXED_POINT), splat(simd, 0.5))
        .to_int()
}

/// Transposes four vectors of lanes: stores the first lane's four numbers, then the second's, and so on.
#[inline(always)]
fn store_transposed<S: Isa, V: SimdBase<S>>([a, b, c, d]: [V; 4], numbers: &mut [V::Element]) {
    let (ac0, ac1) = a.interleave(c);
    let (bd0, bd1) = b.interleave(d);
    let (first, second) = ac0.interleave(bd0);
    let (third, fourth) = ac1.interleave(bd1);
    for (row, numbers) in [first, second, third, fourth]
        .iter()
        .zip(numbers.chunks_mut(lanes::<S>()))
    {
        row.store_slice(numbers);
    }
}
