//! Haze, sky and glow: how the light of a surface fades on its way to the ray's origin, the colour of the background, and the light
//! of the air around lights.

use super::rays::Rays;
use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::World;
use glam::Vec3A;

/// The density of haze added everywhere, in 1 / scene units. It is dense enough to hide everything at the distance that stands
/// for "no hit", 1e30, so that the sky replaces it, and too thin to be visible at any distance within a scene.
const BACKGROUND_HAZE: f32 = 1e-20;

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
        world: World<'_>,
        d: &Vec3x<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
    ) -> Option<Self> {
        if world.is_clear {
            return None;
        }
        let rise = at_least::<S>(d.y, splat(simd, 0.0));
        let gradient = rise * (rise * -1.0 + 2.0);
        // There is none in front of lights.
        let density = surface
            .is_light()
            .select(splat(simd, 0.0), t * (world.haze + BACKGROUND_HAZE));
        let [horizon, sky] =
            [world.scene.background, world.scene.sky].map(|colour| Vec3x::splat(simd, colour));
        Some(Self {
            sky: horizon.add_scaled(sky, gradient),
            transmittance: splat::<S>(simd, 1.0) / (density * density + 1.0),
        })
    }

    /// The colour of a surface as seen through the haze.
    #[inline(always)]
    pub fn veil(&self, colour: Vec3x<S>) -> Vec3x<S> {
        self.sky.add_scaled(colour - self.sky, self.transmittance)
    }
}

/// No surface is farther away, nor any light; the square is finite.
const FARTHEST: f32 = 1e15;

/// The light of the air around lights along rays that hit surfaces at distance `t`.
///
/// The air shines by `a^2 / 2 (r^2 + a^2)^(-3/2)` at the distance r of a light with a glow of radius a. The integral along a ray
/// that passes the light at the distance h, between x and y from there, is `a^2 / 2q (y / sqrt(q + y^2) - x / sqrt(q + x^2))`, where
/// `q = h^2 + a^2`: of an endless ray, `a^2 / q`.
#[inline(always)]
pub(super) fn glow<S: Isa>(simd: S, world: World<'_>, rays: &Rays<S>, t: F<S>) -> Vec3x<S> {
    let t = at_most::<S>(t, splat(simd, FARTHEST));
    let mut glow = Vec3x::splat(simd, Vec3A::ZERO);
    for light in world.lights() {
        if light.glow2 > 0.0 {
            let to_light = Vec3x::splat(simd, light.position) - rays.o;
            let x = -to_light.dot(rays.d);
            let across = to_light.add_scaled(rays.d, x);
            let q = across.dot(across) + light.glow2;
            let y = t + x;
            let (x, y) = (x / (x * x + q).sqrt(), y / (y * y + q).sqrt());
            let share = (y - x) * (0.5 * light.glow2) / q;
            glow = glow.add_scaled(Vec3x::splat(simd, light.colour), share);
        }
    }
    glow
}
