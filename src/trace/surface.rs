//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, Surface};
use crate::scene::MAX_LIGHTS;

/// A [`Surface`] per lane.
pub(super) struct SurfaceLanes<S: Simd> {
    pub centre: Vec3x<S>,
    pub inverse_radius: F<S>,
    pub upright: F<S>,
    pub base: Vec3x<S>,
    pub diffuse: Vec3x<S>,
    pub ks: F<S>,
    pub exponent: F<S>,
    pub faint: F<S>,
    pub kr: F<S>,
    pub kt: F<S>,
    pub index: F<S>,
    pub solid: F<S>,
    /// The groups that can stand between any lane's object and each lamp.
    pub casters: [GroupSet; MAX_LIGHTS],
}

impl<S: Simd> SurfaceLanes<S> {
    /// Looks the objects of the active lanes up.
    ///
    /// Most packets meet one or two objects: one is spread over all lanes, then each other one over those that hit it.
    #[inline(always)]
    pub fn look_up(simd: S, scene: &Prepared, objects: U<S>, active: M<S>) -> Self {
        let numbers = objects.to_array();
        let mut rest = active.to_bitmask();
        let mut number = numbers[rest.trailing_zeros() as usize % LANES];
        let mut lanes = Self::splat(simd, &scene.surfaces[number as usize]);
        loop {
            rest &= !objects.simd_eq(U::splat(simd, number)).to_bitmask();
            if rest == 0 {
                return lanes;
            }
            number = numbers[rest.trailing_zeros() as usize % LANES];
            let mask = objects.simd_eq(U::splat(simd, number));
            lanes.put(mask, &Self::splat(simd, &scene.surfaces[number as usize]));
        }
    }

    #[inline(always)]
    fn splat(simd: S, s: &Surface) -> Self {
        Self {
            centre: Vec3x::splat(simd, s.centre),
            inverse_radius: splat(simd, s.inverse_radius),
            upright: splat(simd, s.upright),
            base: Vec3x::splat(simd, s.base),
            diffuse: Vec3x::splat(simd, s.diffuse),
            ks: splat(simd, s.ks),
            exponent: splat(simd, s.exponent),
            faint: splat(simd, s.faint),
            kr: splat(simd, s.kr),
            kt: splat(simd, s.kt),
            index: splat(simd, s.index),
            solid: splat(simd, s.solid),
            casters: s.casters,
        }
    }

    #[inline(always)]
    fn put(&mut self, mask: M<S>, other: &Self) {
        self.centre = other.centre.where_else(mask, self.centre);
        self.base = other.base.where_else(mask, self.base);
        self.diffuse = other.diffuse.where_else(mask, self.diffuse);
        for (mine, new) in [
            (&mut self.inverse_radius, other.inverse_radius),
            (&mut self.upright, other.upright),
            (&mut self.ks, other.ks),
            (&mut self.exponent, other.exponent),
            (&mut self.faint, other.faint),
            (&mut self.kr, other.kr),
            (&mut self.kt, other.kt),
            (&mut self.index, other.index),
            (&mut self.solid, other.solid),
        ] {
            *mine = mask.select(new, *mine);
        }
        for (mine, new) in self.casters.iter_mut().zip(other.casters) {
            *mine |= new;
        }
    }
}
