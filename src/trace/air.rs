//! Haze and sky: how the light of a surface fades on its way to the ray's origin, and the colour of the background.

use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::{Air, Prepared};

/// The haze along a packet's rays.
pub(super) struct AirLanes<S: Isa> {
    /// The background in the rays' directions.
    sky: Vec3x<S>,
    /// The share of the surfaces' light that arrives, 0 to 1.
    pub transmittance: F<S>,
}

impl<S: Isa> AirLanes<S> {
    /// The haze along rays that hit surfaces at distance `t`; `None` if the air is clear.
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
        let density = t * surface.haze();
        Some(Self {
            sky: Vec3x::splat(simd, horizon).add_scaled(Vec3x::splat(simd, sky), gradient),
            transmittance: splat::<S>(simd, 1.0) / (density * density + 1.0),
        })
    }

    /// The colour of a surface as seen through the haze.
    #[inline(always)]
    pub fn veil(&self, colour: Vec3x<S>) -> Vec3x<S> {
        self.sky.add_scaled(colour - self.sky, self.transmittance)
    }
}
