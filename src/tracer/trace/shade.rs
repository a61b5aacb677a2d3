use super::accumulator::Contribution;
use super::air::{self, AirLanes};
use super::ambient;
use super::intersect::Hit;
use super::key::Keys;
use super::light;
use super::point::ShadingPoint;
use super::rays::{INWARD, Rays};
use super::stack::RayStack;
use super::surface::SurfaceLanes;
use super::{Batch, Tracer};
use crate::lanes::*;
use crate::prepare::Parameter;
use glam::Vec3A;

/// Pushes the secondary rays of hits, and returns the hits' contributions.
#[inline(always)]
pub(super) fn shade<S: Isa>(
    tracer: Tracer<'_, S>,
    rays: &Rays<S>,
    hit: &Hit<S>,
    active: M<S>,
    batch: &mut Batch,
) -> Contribution<S> {
    let (simd, world, quality) = (tracer.isa, tracer.world, tracer.quality);
    let surface = SurfaceLanes::look_up(simd, world, hit.object, active, &mut batch.surfaces);
    let shaded = active & surface.is_lit();
    let air = AirLanes::along(simd, world, &rays.d, hit.t, &surface);
    // The weight of the light that leaves the surface.
    let weight = match &air {
        Some(air) => rays.weight * air.transmittance,
        None => rays.weight,
    };
    let mut colour = surface.emitted();
    let mut untextured = colour;
    let mut reflectance = splat(simd, 1.0);
    let mut field = U::<S>::splat(simd, 0);
    let mut untraced = Vec3x::splat(simd, Vec3A::ZERO);
    let mut keys = Keys::new(simd, quality, active, rays);
    if shaded.any_true() {
        let point = &ShadingPoint::new(simd, world, rays, hit, &surface, shaded);
        let ambient = if world.ambience.is_on {
            let light = ambient::light(tracer, rays, point);
            Vec3x::select(shaded, colour * light, colour)
        } else {
            colour
        };
        let reflected = light::gather(
            tracer,
            &surface,
            point,
            ambient,
            &mut keys,
            &mut batch.occluders,
            &mut batch.counts,
        );
        untextured = reflected.untextured;
        reflectance = point.reflectance;
        field = point.field;
        colour = reflected.specular.add_scaled(untextured, reflectance.abs());
        let parents = Rays { weight, ..*rays };
        let marks = rays.mirror_marks(simd, hit.object, world.first_plane());
        let scattered = scatter(tracer, &parents, &surface, point, marks, &mut batch.stack);
        untraced = scattered.untraced;
        // The guard knows the images in the first plane, but not the shadows there.
        let much = splat(simd, quality.unguarded_weight);
        let shadows = shaded & rays.mirrored(simd) & weight.simd_ge(much);
        batch.results.mark_unguarded(rays, shadows | scattered.unguarded);
    }
    if let Some(air) = &air {
        colour = air.veil(colour);
    }
    if world.glows {
        colour = colour + air::glow(simd, world, rays, hit.t);
    }
    Contribution {
        colour: untraced.add_scaled(colour, active.select(rays.weight, splat(simd, 0.0))),
        key: keys.terms(simd, quality, hit.object, field),
        untextured: untextured.scaled(weight),
        reflectance,
    }
}

/// The light of secondary rays.
struct Scattered<S: Isa> {
    /// The light of the rays beyond the quality's limits.
    untraced: Vec3x<S>,
    /// The lanes with rays that the guard does not know.
    unguarded: M<S>,
}

/// Pushes the transmitted and the reflected rays. The weight of `parents` includes the haze; `marks` are [`Rays::mirror_marks`].
#[inline(always)]
fn scatter<S: Isa>(
    tracer: Tracer<'_, S>,
    parents: &Rays<S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    marks: U<S>,
    stack: &mut RayStack,
) -> Scattered<S> {
    let (simd, quality) = (tracer.isa, tracer.quality);
    let zero = splat(simd, 0.0);
    let one = splat(simd, 1.0);
    let least = splat(simd, quality.least_contribution);
    let deepest = U::<S>::splat(simd, 1 << quality.depth);
    let follow = point.shaded & parents.paths().simd_lt(deepest);
    let reflected = parents.reflected_slot_paths();
    let ShadingPoint { p, n, dn, hit_error, departure, .. } = *point;
    // Schlick's approximation.
    let grazing = dn + 1.0;
    let grazing2 = grazing * grazing;
    let gain = surface.number(Parameter::Fresnel) * (grazing2 * grazing2 * grazing);
    let mut kr = surface.number(Parameter::Kr);
    kr = kr + gain * (one - kr);
    let kt = surface.number(Parameter::Kt) * (one - gain);
    // On total reflection the transmitted weight goes to the reflected ray.
    let mut refracted = M::<S>::splat(simd, false);
    let mut through = refracted;
    let mut transmitted = Rays {
        o: p.add_scaled(n, hit_error * -2.0),
        d: point.r,
        weight: zero,
        slot_path: (reflected + 1) | (departure ^ INWARD),
    };
    let glass = point.shaded & kt.simd_gt(zero);
    if glass.any_true() {
        let eta = point
            .inside
            .select(surface.number(Parameter::Index), one / surface.number(Parameter::Index));
        // The squared cosine of the transmitted ray, negative on total reflection.
        let k = one - eta * eta * (one - dn * dn);
        let total = k.simd_lt(zero);
        kr = (glass & total).select(kr + kt, kr);
        transmitted.weight = parents.weight * kt;
        refracted = glass & !total;
        through = follow & refracted & transmitted.weight.simd_ge(least);
        let along = -eta.mul_add(dn, at_least::<S>(k, zero).sqrt());
        transmitted.d = parents.d.scaled(eta).add_scaled(n, along);
    }
    let weight = parents.weight * kr;
    let back = follow & weight.simd_ge(least);
    let reflected = Rays { o: p, d: point.r, weight, slot_path: reflected | departure | marks };
    let much = splat(simd, quality.unguarded_weight);
    let mut unguarded = back & weight.simd_ge(much);
    if tracer.world.scene.water.are_calm() {
        unguarded &= marks.simd_eq(U::<S>::splat(simd, 0));
    }
    unguarded |= through & transmitted.weight.simd_ge(much);
    // The reflected rays are on top of the stack.
    if through.any_true() {
        stack.push(simd, &transmitted, through);
    }
    if back.any_true() {
        stack.push(simd, &reflected, back);
    }
    Scattered {
        untraced: untraced(tracer, &transmitted, refracted & !through)
            + untraced(tracer, &reflected, point.shaded & !back),
        unguarded,
    }
}

/// Returns the light of rays that are not traced: the brighter of background and ambient light in each channel.
///
/// The background is right for rays that leave the scene, the ambient light for rays between surfaces. In crowds of glass at the
/// fastest preset's limits, the maximum has 30 dB against deeper rays, the background 29 dB, the ambient light 23 dB, and black 20 dB.
#[inline(always)]
fn untraced<S: Isa>(tracer: Tracer<'_, S>, rays: &Rays<S>, lost: M<S>) -> Vec3x<S> {
    let (simd, world) = (tracer.isa, tracer.world);
    let none = Vec3x::splat(simd, Vec3A::ZERO);
    let lost = lost & rays.weight.simd_gt(splat(simd, 0.0));
    if world.scene.black_beyond || !lost.any_true() {
        return none;
    }
    let ambient = Vec3x::splat(simd, world.scene.ambient);
    let light = air::sky(simd, world, &rays.d).at_least(ambient);
    Vec3x::select(lost, light.scaled(rays.weight), none)
}
