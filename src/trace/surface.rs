//! The surfaces that a packet hits.

use crate::lanes::*;
use crate::prepare::{GroupSet, Prepared, Surface};
use crate::scene::MAX_LIGHTS;

/// A [`Surface`] per lane.
pub(super) struct SurfaceLanes<S: Isa> {
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

impl<S: Isa> SurfaceLanes<S> {
    /// Looks the objects of the active lanes up.
    ///
    /// Most packets meet one or two objects: one is spread over all lanes, then each other one over those that hit it.
    #[inline(always)]
    pub fn look_up(simd: S, scene: &Prepared, objects: U<S>, active: M<S>) -> Self {
        let some = |set: u64| objects.as_slice()[set.trailing_zeros() as usize % lanes::<S>()];
        let mut rest = active.to_bitmask();
        let number = some(rest);
        let mut lanes = Self::splat(simd, &scene.surfaces[number as usize]);
        rest &= !objects.simd_eq(U::<S>::splat(simd, number)).to_bitmask();
        while rest != 0 {
            let number = some(rest);
            let mask = objects.simd_eq(U::<S>::splat(simd, number));
            lanes.put(mask, &scene.surfaces[number as usize]);
            rest &= !mask.to_bitmask();
        }
        lanes
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

    /// Sets the lanes in `mask`.
    #[inline(always)]
    fn put(&mut self, mask: M<S>, s: &Surface) {
        put_lanes::<S>(mask, &mut self.centre.x, s.centre.x);
        put_lanes::<S>(mask, &mut self.centre.y, s.centre.y);
        put_lanes::<S>(mask, &mut self.centre.z, s.centre.z);
        put_lanes::<S>(mask, &mut self.inverse_radius, s.inverse_radius);
        put_lanes::<S>(mask, &mut self.upright, s.upright);
        put_lanes::<S>(mask, &mut self.base.x, s.base.x);
        put_lanes::<S>(mask, &mut self.base.y, s.base.y);
        put_lanes::<S>(mask, &mut self.base.z, s.base.z);
        put_lanes::<S>(mask, &mut self.diffuse.x, s.diffuse.x);
        put_lanes::<S>(mask, &mut self.diffuse.y, s.diffuse.y);
        put_lanes::<S>(mask, &mut self.diffuse.z, s.diffuse.z);
        put_lanes::<S>(mask, &mut self.ks, s.ks);
        put_lanes::<S>(mask, &mut self.exponent, s.exponent);
        put_lanes::<S>(mask, &mut self.faint, s.faint);
        put_lanes::<S>(mask, &mut self.kr, s.kr);
        put_lanes::<S>(mask, &mut self.kt, s.kt);
        put_lanes::<S>(mask, &mut self.index, s.index);
        put_lanes::<S>(mask, &mut self.solid, s.solid);
        for (mine, new) in self.casters.iter_mut().zip(s.casters) {
            *mine |= new;
        }
    }
}

/// Sets the lanes in `mask` to one number.
#[inline(always)]
fn put_lanes<S: Isa>(mask: M<S>, lanes: &mut F<S>, v: f32) {
    *lanes = mask.select(splat(lanes.token(), v), *lanes);
}
