use super::accumulator::Contribution;
use super::air::{self, AirLanes};
use super::intersect::Hit;
use super::key::Keys;
use super::point::ShadingPoint;
use super::rays::{INWARD, Rays};
use super::stack::RayStack;
use super::surface::SurfaceLanes;
use super::{Batch, Tracer, ambient, light};
use crate::lanes::*;
use crate::prepare::{Parameter, World};
use glam::Vec3A;

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
    let air = AirLanes::along(simd, world, rays, hit.t, &surface);
    // The weight of the light that leaves the surface.
    let weight = match &air {
        Some(air) => rays.weight * air.transmittance,
        None => rays.weight,
    };
    let mut colour = surface.emitted();
    let mut untextured = colour;
    let mut reflectance = splat(simd, 1.0);
    let mut pattern_hash = U::<S>::splat(simd, 0);
    let mut scattered = Scattered::none(simd);
    let mut keys = Keys::new(simd, quality, active, rays);
    if shaded.any_true() {
        let point = &ShadingPoint::new(simd, world, rays, hit, &surface, shaded);
        let ambient = ambient::light(tracer, rays, point, colour);
        let Batch { occluders, counts, .. } = batch;
        let reflected =
            light::gather(tracer, &surface, point, ambient, &mut keys, occluders, counts);
        (colour, untextured) = textured(world, reflected, point);
        reflectance = point.reflectance;
        pattern_hash = point.pattern_hash;
        let parents = Rays { weight, ..*rays };
        let marks = rays.mirror_marks(simd, hit.object, world.first_plane());
        scattered = scatter(tracer, &parents, &surface, point, marks, &mut batch.stack);
        // The guard has bounds of images in the first plane, but not of shadows there.
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
    let untraced = untraced_light(tracer, rays, &surface, active, &scattered);
    Contribution {
        colour: untraced.add_scaled(colour, active.select(rays.weight, splat(simd, 0.0))),
        key: keys.terms(simd, quality, hit.object, pattern_hash),
        untextured: untextured.scaled(weight),
        reflectance,
    }
}

/// Returns the points' colours, and the light in them that the pattern scales.
#[inline(always)]
fn textured<S: Isa>(
    world: World<'_>,
    reflected: light::Reflected<S>,
    point: &ShadingPoint<S>,
) -> (Vec3x<S>, Vec3x<S>) {
    let light::Reflected { mut untextured, specular: mut plain } = reflected;
    if world.has_patterns {
        let tinted = untextured * point.tint;
        plain = plain + tinted;
        untextured = untextured - tinted;
    }
    (plain.add_scaled(untextured, point.reflectance.abs()), untextured)
}

/// Returns the light of untraced rays, with the softboxes that they and rays to the background
/// meet.
#[inline(always)]
fn untraced_light<S: Isa>(
    tracer: Tracer<'_, S>,
    rays: &Rays<S>,
    surface: &SurfaceLanes<'_, S>,
    active: M<S>,
    scattered: &Scattered<S>,
) -> Vec3x<S> {
    let (simd, world) = (tracer.isa, tracer.world);
    let untraced = scattered.untraced;
    if world.softboxes().is_empty() {
        return untraced;
    }
    let leaving = surface.is_background & rays.paths().simd_gt(U::<S>::splat(simd, 1));
    let weight = Vec3x::select(leaving, Vec3x::equal(rays.weight), scattered.mirrored);
    let d = Vec3x::select(leaving, rays.d, scattered.d);
    let light = air::softboxes(simd, world, &d) * weight;
    Vec3x::select(active, untraced + light, untraced)
}

struct Scattered<S: Isa> {
    untraced: Vec3x<S>,
    /// Of the untraced reflected rays.
    d: Vec3x<S>,
    mirrored: Vec3x<S>,
    unguarded: M<S>,
}

impl<S: Isa> Scattered<S> {
    #[inline(always)]
    fn none(simd: S) -> Self {
        let zero = Vec3x::splat(simd, Vec3A::ZERO);
        Self { untraced: zero, d: zero, mirrored: zero, unguarded: M::<S>::splat(simd, false) }
    }
}

/// Pushes the transmitted and the reflected rays. The weight of `parents` includes the haze;
/// `marks` are [`Rays::mirror_marks`].
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
    let min_weight = splat(simd, quality.least_contribution);
    let deepest = U::<S>::splat(simd, 1 << quality.depth);
    let follow = point.shaded & parents.paths().simd_lt(deepest);
    let reflected = parents.reflected_slot_paths();
    let Refraction { rays: transmitted, refracted, through, kr } =
        refract(tracer, parents, surface, point, reflected, follow);
    let weight = parents.weight * kr;
    let mut back = follow & weight.simd_ge(min_weight);
    let mut mirrored = Vec3x::equal(weight);
    let film = surface.number(Parameter::IsLit) - 1.0;
    let zero = splat(simd, 0.0);
    let is_film = film.simd_gt(zero);
    if is_film.any_true() {
        back &= !is_film;
        let colour = film_colour(film, surface, point);
        mirrored = Vec3x::select(is_film, colour.scaled(weight), mirrored);
    }
    let slot_path = reflected | point.departure | marks;
    let reflected = Rays { o: point.p, d: point.r, weight, slot_path };
    let much = splat(simd, quality.unguarded_weight);
    let mut unguarded = back & weight.simd_ge(much);
    if tracer.world.scene.water.is_calm() {
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
    // The weight above which untraced rays are not black.
    let black = splat(simd, if tracer.world.scene.black_beyond { f32::INFINITY } else { 0.0 });
    let lost = point.shaded & !back & weight.simd_gt(black);
    Scattered {
        untraced: untraced(
            tracer,
            &transmitted.d,
            refracted & !through & transmitted.weight.simd_gt(black),
            Vec3x::equal(transmitted.weight),
        ) + untraced(tracer, &reflected.d, lost, mirrored),
        d: reflected.d,
        mirrored: Vec3x::select(lost, mirrored, Vec3x::splat(simd, Vec3A::ZERO)),
        unguarded,
    }
}

struct Refraction<S: Isa> {
    /// The transmitted rays; other lanes have no weight.
    rays: Rays<S>,
    refracted: M<S>,
    /// The rays within the quality's limits.
    through: M<S>,
    /// The reflected rays' share of the parents' weight.
    kr: F<S>,
}

/// Returns the transmitted rays. `reflected` are [`Rays::reflected_slot_paths`].
#[inline(always)]
fn refract<S: Isa>(
    tracer: Tracer<'_, S>,
    parents: &Rays<S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    reflected: U<S>,
    follow: M<S>,
) -> Refraction<S> {
    let simd = tracer.isa;
    let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
    let ShadingPoint { p, n, dn, hit_error, departure, .. } = *point;
    // Schlick's approximation.
    let grazing = dn + 1.0;
    let grazing2 = grazing * grazing;
    let gain = surface.number(Parameter::Fresnel) * (grazing2 * grazing2 * grazing);
    let mut kr = surface.number(Parameter::Kr);
    kr = kr + gain * (one - kr);
    let kt = surface.number(Parameter::Kt) * (one - gain);
    let mut refracted = M::<S>::splat(simd, false);
    let mut through = refracted;
    let mut rays = Rays {
        o: p.add_scaled(n, hit_error * -2.0),
        d: point.r,
        weight: zero,
        slot_path: (reflected + 1) | (departure ^ INWARD),
    };
    let glass = point.shaded & kt.simd_gt(zero);
    if glass.any_true() {
        let index = surface.number(Parameter::Index);
        let eta = point.inside.select(index, one / index);
        // The squared cosine of the transmitted ray, negative on total reflection.
        let k = one - eta * eta * (one - dn * dn);
        let total = k.simd_lt(zero);
        // On total reflection the transmitted weight goes to the reflected ray.
        kr = (glass & total).select(kr + kt, kr);
        refracted = glass & !total;
        rays.weight = parents.weight * kt;
        let min_weight = splat(simd, tracer.quality.least_contribution);
        through = follow & refracted & rays.weight.simd_ge(min_weight);
        let along = -eta.mul_add(dn, at_least::<S>(k, zero).sqrt());
        rays.d = parents.d.scaled(eta).add_scaled(n, along);
    }
    Refraction { rays, refracted, through, kr }
}

/// Returns the light of untraced rays: the brighter of background and ambient light in each
/// channel. In crowds of glass at the fastest preset's limits it has 30 dB against deeper rays, the
/// background 29, the ambient light 23, and black 20 dB.
#[inline(always)]
fn untraced<S: Isa>(tracer: Tracer<'_, S>, d: &Vec3x<S>, lost: M<S>, weight: Vec3x<S>) -> Vec3x<S> {
    let (simd, world) = (tracer.isa, tracer.world);
    let none = Vec3x::splat(simd, Vec3A::ZERO);
    if !lost.any_true() {
        return none;
    }
    let ambient = Vec3x::splat(simd, world.scene.ambient);
    let light = air::sky(simd, world, d).at_least(ambient);
    Vec3x::select(lost, light * weight, none)
}

/// Returns the reflectances of thin films relative to mirrors, see
/// [`crate::scene::Material::film_thickness`].
#[inline(always)]
fn film_colour<S: Isa>(
    thickness: F<S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
) -> Vec3x<S> {
    let centre = surface.vector(Parameter::Centre).y;
    let height = (point.p.y - centre) * surface.number(Parameter::InverseRadius);
    let inner = (point.dn * point.dn * IN_FILM + (1.0 - IN_FILM)).sqrt();
    let path = (height * -0.8 + 1.0) * thickness * inner;
    let [x, y, z] = [610.0, 540.0, 455.0].map(
        #[inline(always)]
        |wavelength| {
            let w = off_integer::<S>(path * (2.0 * FILM_INDEX / wavelength)).abs() * 4.0 - 1.0;
            w * (w.abs() * -0.5 + 1.0) + 0.5
        },
    );
    Vec3x { x, y, z }
}

const FILM_INDEX: f32 = 1.33;
const IN_FILM: f32 = 1.0 / (FILM_INDEX * FILM_INDEX);
