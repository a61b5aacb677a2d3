//! Haze, sky, softboxes, and the glow around lights.

use super::rays::Rays;
use super::surface::SurfaceLanes;
use super::visibility::soft_edge;
use crate::lanes::*;
use crate::prepare::{SpotCone, World};
use glam::Vec3A;

/// The density of haze added everywhere, in 1 / scene units: invisible within a scene, but it
/// leaves only the sky at the distance of a miss, 1e30.
const BACKGROUND_HAZE: f32 = 1e-20;

pub(super) struct AirLanes<S: Isa> {
    sky: Vec3x<S>,
    /// The weight of the surfaces' light, 0 to 1.
    pub transmittance: F<S>,
}

impl<S: Isa> AirLanes<S> {
    /// Returns the haze in front of surfaces at the distance `t`; `None` if the air is clear.
    ///
    /// Between the heights x and y, the mean of `1 / (1 + b h)^2` is `1 / ((1 + b x) (1 + b y))`,
    /// without cancellation on level rays.
    #[inline(always)]
    pub fn along(
        simd: S,
        world: World<'_>,
        rays: &Rays<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
    ) -> Option<Self> {
        if world.is_clear {
            return None;
        }
        // Haze does not dim visible lights.
        let zero = splat(simd, 0.0);
        let [first, last] = [rays.o.y, rays.d.y * t + rays.o.y].map(
            #[inline(always)]
            |y| at_least::<S>(y, zero) * world.haze_fall + 1.0,
        );
        let haze = splat::<S>(simd, world.haze) / (first * last);
        let density = surface.is_light().select(zero, t * (haze + BACKGROUND_HAZE));
        Some(Self {
            sky: sky(simd, world, &rays.d),
            transmittance: splat::<S>(simd, 1.0) / (density * density + 1.0),
        })
    }

    #[inline(always)]
    pub fn veil(&self, colour: Vec3x<S>) -> Vec3x<S> {
        self.sky.add_scaled(colour - self.sky, self.transmittance)
    }
}

#[inline(always)]
pub(super) fn sky<S: Isa>(simd: S, world: World<'_>, d: &Vec3x<S>) -> Vec3x<S> {
    let rise = at_least::<S>(d.y, splat(simd, 0.0));
    let gradient = rise * (rise * -1.0 + 2.0);
    let [horizon, sky] =
        [world.scene.background, world.scene.sky].map(|colour| Vec3x::splat(simd, colour));
    let [sun, scattered] = world.scattered.map(|it| Vec3x::splat(simd, it));
    let towards = at_least::<S>(d.dot(sun), splat(simd, 0.0));
    let towards = towards * towards;
    let towards = towards * towards;
    horizon.add_scaled(sky, gradient).add_scaled(scattered, towards * towards)
}

/// The least cosine between the aim of a softbox and a direction that sees the softbox.
const BESIDE: f32 = 1e-3;

#[inline(always)]
pub(super) fn softboxes<S: Isa>(simd: S, world: World<'_>, d: &Vec3x<S>) -> Vec3x<S> {
    let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
    let mut light = Vec3x::splat(simd, Vec3A::ZERO);
    for softbox in world.softboxes() {
        let toward = d.dot(Vec3x::splat(simd, softbox.aim));
        let scale = one / at_least::<S>(toward, splat(simd, BESIDE));
        let [x, y] = softbox.along.map(
            #[inline(always)]
            |side| d.dot(Vec3x::splat(simd, side)).abs() * scale,
        );
        let inside = at_most::<S>(x * -1.0 + softbox.half.x, y * -1.0 + softbox.half.y);
        let share = smooth_step::<S>(clamp::<S>(inside, zero, one));
        light = light.add_scaled(Vec3x::splat(simd, softbox.colour), share);
    }
    light
}

/// Larger than the distance of any surface or light, with a finite square.
const FARTHEST: f32 = 1e15;

/// Returns the glow in front of surfaces at the distance `t`.
///
/// At the distance r from a light, the air of a glow with the radius a emits
/// `a^2 / 2 (r^2 + a^2)^(-3/2)`. The integral along a ray that passes the light at the distance h,
/// between x and y from there, is `a^2 / 2q (y / sqrt(q + y^2) - x / sqrt(q + x^2))` with
/// `q = h^2 + a^2`, and `a^2 / q` for an infinite ray. With a core, h is the least height of the
/// visible part of the ray above the core.
#[inline(always)]
pub(super) fn glow<S: Isa>(simd: S, world: World<'_>, rays: &Rays<S>, t: F<S>) -> Vec3x<S> {
    let t = at_most::<S>(t, splat(simd, FARTHEST));
    let mut glow = Vec3x::splat(simd, Vec3A::ZERO);
    for light in world.lights() {
        if light.glow2 > 0.0 {
            let to_light = Vec3x::splat(simd, light.position) - rays.o;
            let x = -to_light.dot(rays.d);
            let across = to_light.add_scaled(rays.d, x);
            let (mut h2, mut in_cone) = (across.dot(across), splat(simd, 1.0));
            if light.core > 0.0 {
                let along = at_most::<S>(at_least::<S>(-x, splat(simd, 0.0)), t);
                let nearest = rays.d.scaled_minus(along, to_light);
                let h: F<S> = nearest.dot(nearest).sqrt();
                let SpotCone { aim, inner2, outer2 } = light.cone;
                let off = nearest.scaled_minus(splat(simd, 1.0) / h, Vec3x::splat(simd, aim));
                in_cone = soft_edge(simd, (splat(simd, outer2) - off.dot(off)) / (outer2 - inner2));
                h2 = at_least::<S>(h - light.core, splat(simd, 0.0));
                h2 *= h2;
            }
            let q = h2 + light.glow2;
            let y = t + x;
            let (x, y) = (x / (x * x + q).sqrt(), y / (y * y + q).sqrt());
            let share = (y - x) * (0.5 * light.glow2) / q * in_cone;
            glow = glow.add_scaled(Vec3x::splat(simd, light.colour), share);
        }
    }
    glow
}
