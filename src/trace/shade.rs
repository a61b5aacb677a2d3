//! Shading: the contribution of a hit to its point, and the secondary rays.

use super::air::AirLanes;
use super::batch::{Batch, FIXED_POINT};
use super::intersect::Hit;
use super::key::Keys;
use super::light::{self, Reflected};
use super::point::ShadingPoint;
use super::stack::{Rays, Stack};
use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;

/// The largest contribution of a node of the ray tree, as a multiple of full brightness.
///
/// More than 1 is not visible, since contributions are not negative. With this bound the sum over the 255 nodes of the deepest
/// tree does not overflow.
const BRIGHTEST: f32 = 2.0;

/// The contributions of a packet's hits to their points.
pub(super) struct Contribution<S: Isa> {
    pub colour: Vec3x<S>,
    key: U<S>,
    /// The part of the colour that a texture leaves a share of, and that share; of rays that hit no lamp and no
    /// background.
    untextured: Vec3x<S>,
    reflectance: F<S>,
}

impl<S: Isa> Contribution<S> {
    /// Stores blue, green and red in fixed point and the key, a point after the other.
    #[inline(always)]
    pub fn store(&self, simd: S, sums: &mut [i32]) {
        let [blue, green, red] =
            [self.colour.z, self.colour.y, self.colour.x].map(|c| fixed(simd, c));
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

/// Shades the hits, puts the secondary rays on the stack and returns what the hits add to their points.
#[inline(always)]
pub(super) fn shade<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    rays: &Rays<S>,
    hit: &Hit<S>,
    active: M<S>,
    batch: &mut Batch,
) -> Contribution<S> {
    let Batch {
        surfaces,
        stack,
        counts,
        candidates,
        ..
    } = batch;
    let surface = SurfaceLanes::look_up(simd, scene, hit.object, active, surfaces);
    let solid = active & surface.is_lit();
    let air = AirLanes::along(simd, scene, &rays.d, hit.t, &surface);
    // What the light that leaves the surface is multiplied by on its way to the eye.
    let weight = match &air {
        Some(air) => rays.weight * air.transmittance,
        None => rays.weight,
    };
    let mut colour = surface.emitted();
    let mut untextured = colour;
    let mut reflectance = splat(simd, 1.0);
    let mut keys = Keys::new(simd, quality, active, rays.paths());
    if solid.any_true() {
        let point = ShadingPoint::new(simd, scene, rays, hit, &surface, solid);
        let reflected = light::gather(
            simd, scene, quality, &surface, &point, &mut keys, counts, candidates,
        );
        Reflected { untextured, .. } = reflected;
        reflectance = point.reflectance;
        colour = reflected.specular.add_scaled(untextured, reflectance);
        let marks = rays.mirror_marks(simd, hit.object, scene.first_plane());
        scatter(simd, quality, rays, weight, &surface, &point, marks, stack);
    }
    if let Some(air) = &air {
        colour = air.veil(colour);
    }
    Contribution {
        colour: colour.scaled(active.select(rays.weight, splat(simd, 0.0))),
        key: keys.terms(simd, quality, hit.object),
        untextured: untextured.scaled(weight),
        reflectance,
    }
}

/// Puts the transmitted and the reflected rays on the stack.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a hit and its secondary rays")]
fn scatter<S: Isa>(
    simd: S,
    quality: &Quality,
    rays: &Rays<S>,
    weight: F<S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    marks: U<S>,
    stack: &mut Stack,
) {
    let zero = splat(simd, 0.0);
    let one = splat(simd, 1.0);
    let least = splat(simd, quality.least_contribution);
    let deepest = U::<S>::splat(simd, 1 << quality.depth);
    let follow = point.solid & rays.paths().simd_lt(deepest);
    let reflected = rays.reflected_slot_paths();
    let mut kr = surface.kr();
    let ShadingPoint {
        p,
        n,
        dn,
        hit_error,
        ..
    } = *point;
    let mut through = M::<S>::splat(simd, false);
    let mut transmitted = Rays {
        o: p.add_scaled(n, hit_error * -2.0),
        d: point.r,
        weight: zero,
        slot_path: reflected + 1,
    };
    let glass = follow & surface.kt().simd_gt(zero);
    if glass.any_true() {
        let eta = point.inside.select(surface.index(), one / surface.index());
        // The cosine of the transmitted ray, squared; below 0 all light is reflected.
        let k = one - eta * eta * (one - dn * dn);
        let total = k.simd_lt(zero);
        kr = (glass & total).select(kr + surface.kt(), kr);
        transmitted.weight = weight * surface.kt();
        through = glass & !total & transmitted.weight.simd_ge(least);
        let along = -eta.mul_add(dn, at_least::<S>(k, zero).sqrt());
        transmitted.d = rays.d.scaled(eta).add_scaled(n, along);
    }
    let weight = weight * kr;
    let back = follow & weight.simd_ge(least);
    let reflected = Rays {
        o: p,
        d: point.r,
        weight,
        slot_path: reflected | marks,
    };
    if through.any_true() {
        stack.push(simd, &transmitted, through);
    }
    if back.any_true() {
        stack.push(simd, &reflected, back);
    }
}
