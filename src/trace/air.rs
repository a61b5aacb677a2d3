//! Haze and sky: what the way from a surface to the ray's start does to its light, and what lies behind all surfaces.

use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::{Air, Prepared};

/// The air along a packet's rays.
pub(super) struct AirLanes<S: Isa> {
    /// What is seen in the rays' directions behind everything.
    sky: Vec3x<S>,
    /// The share of the light from where they hit that arrives, 0 to 1.
    pub transmittance: F<S>,
}

impl<S: Isa> AirLanes<S> {
    /// The air along rays of length `t` to a surface, if there is any to be seen.
    #[inline(always)]
    pub fn along(
        simd: S,
        scene: &Prepared,
        d: &Vec3x<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
    ) -> Option<Self> {
        let Air { horizon, sky, .. } = scene.air;
        if scene.air.is_clear {
            return None;
        }
        let rise = at_least::<S>(d.y, splat(simd, 0.0));
        let gradient = rise * (rise * -1.0 + 2.0);
        let way = t * surface.haze();
        Some(Self {
            sky: Vec3x::splat(simd, horizon).add_scaled(Vec3x::splat(simd, sky), gradient),
            transmittance: splat::<S>(simd, 1.0) / (way * way + 1.0),
        })
    }

    /// A surface's colour as it arrives.
    #[inline(always)]
    pub fn veil(&self, colour: Vec3x<S>) -> Vec3x<S> {
        self.sky.add_scaled(colour - self.sky, self.transmittance)
    }
}
