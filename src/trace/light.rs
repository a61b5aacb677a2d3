//! Direct light by Phong's model, and the share of each light that reaches a point.

use super::Counts;
use super::block;
use super::candidates::Candidates;
use super::intersect::blocked;
use super::key::Keys;
use super::point::ShadingPoint;
use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::{Lamp, Object, Prepared};
use crate::quality::Quality;
use crate::scene::{Sphere, Spot};
use glam::Vec3A;

/// The light that surfaces reflect along the rays.
pub(super) struct Reflected<S: Isa> {
    /// Ambient light and diffuse reflection, before the texture is applied.
    pub untextured: Vec3x<S>,
    /// Highlights, in the lights' colours.
    pub specular: Vec3x<S>,
}

/// Ambient light, and the light of each lamp that is not blocked.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a hit and its light")]
pub(super) fn gather<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    keys: &mut Keys<S>,
    counts: &mut Counts,
    candidates: &mut Candidates,
) -> Reflected<S> {
    let zero = splat(simd, 0.0);
    let one = splat(simd, 1.0);
    // The sums of diffuse and of specular reflection.
    let mut diffuse = Vec3x::splat(simd, Vec3A::ZERO);
    let mut specular = diffuse;
    // Inside of a sphere, lights beyond its far side are blocked by the sphere itself. The chord towards the lamp has the length
    // of twice the cosine times the radius.
    let least = point.inside.select(surface.inverse_radius() * 0.5, zero);
    for lamp in scene.lamps() {
        let to_light = Vec3x::splat(simd, lamp.position) - point.p;
        let distance = to_light.dot(to_light).sqrt();
        let l = to_light.scaled(one / distance);
        let nl = point.n.dot(l);
        let mut facing = point.solid & nl.simd_gt(distance * least);
        if !lamp.is_plain() {
            let inward: F<S> = -l.dot(Vec3x::splat(simd, lamp.cone.aim));
            facing &= inward.simd_gt(splat(simd, lamp.cone.dark));
        }
        let mut lit = facing;
        let mut highlight = M::<S>::splat(simd, false);
        if facing.any_true() {
            counts.shadow_rays += u64::from(facing.to_bitmask().count_ones());
            lit &= !blocked(simd, scene, lamp, point.p, l, distance, candidates);
            let mut colour = Vec3x::splat(simd, lamp.colour);
            if !lamp.is_plain() && (lamp.is_cone || !candidates.is_empty()) {
                let ways = Ways {
                    o: point.p,
                    l,
                    distance: lit.select(distance, zero),
                };
                let passing = light_transmittance(simd, scene, lamp, &ways, candidates);
                lit &= at_least::<S>(at_least::<S>(passing.x, passing.y), passing.z).simd_gt(zero);
                colour = colour * passing;
            }
            diffuse = diffuse.add_scaled(colour, lit.select(nl, zero));
            let rv = point.r.dot(l);
            let shiny = lit & rv.simd_gt(surface.highlight_start());
            if shiny.any_true() {
                let strength = surface.ks() * pow(simd, shiny.select(rv, one), surface.exponent());
                let strength = shiny.select(strength, zero);
                highlight = strength.simd_gt(splat(simd, quality.highlight));
                specular = specular.add_scaled(colour, strength);
            }
        }
        keys.push(lit, highlight);
    }
    Reflected {
        untextured: surface.emitted() + surface.diffuse() * diffuse,
        specular,
    }
}

/// Rays from points to a lamp.
struct Ways<S: Isa> {
    o: Vec3x<S>,
    /// Directions, of length 1.
    l: Vec3x<S>,
    /// Distances to the lamp; 0 in lanes that are not needed.
    distance: F<S>,
}

/// The share of a lamp's light, as a colour, that its cone and the candidates let pass; 0 in lanes that are not needed.
#[inline(always)]
fn light_transmittance<S: Isa>(
    simd: S,
    scene: &Prepared,
    lamp: &Lamp,
    ways: &Ways<S>,
    candidates: &Candidates,
) -> Vec3x<S> {
    let zero = splat(simd, 0.0);
    let Spot { aim, dark, bright } = lamp.cone;
    let inward = (-ways.l.dot(Vec3x::splat(simd, aim)) - dark) / (bright - dark);
    let is_asked = ways.distance.simd_gt(zero);
    let in_cone = is_asked.select(smooth_step(simd, inward), zero);
    let mut passing = Vec3x {
        x: in_cone,
        y: in_cone,
        z: in_cone,
    };
    for &candidate in candidates.as_slice() {
        let (object, material) = scene.object(candidate.object);
        let covered = match object {
            Object::Block(block) => {
                let t = block::distance(simd, block, &ways.o, &ways.l);
                t.simd_lt(ways.distance).select(splat(simd, 1.0), zero)
            }
            Object::Sphere(sphere) => sphere_covers(simd, lamp, sphere, ways),
            Object::Plane(_) | Object::Light(_) | Object::Background => continue,
        };
        // The share given by the blocker's tint passes. NaN counts as no tint: it would spoil lanes that are not blocked.
        let mut absorbed = Vec3A::ONE;
        if lamp.diameter > 0.0 {
            absorbed -= material.tint.max(Vec3A::ZERO).min(Vec3A::ONE);
        }
        let covered = candidate.lanes(simd).select(covered, zero);
        passing = passing - (passing * Vec3x::splat(simd, absorbed)).scaled(covered);
        let most = at_least::<S>(at_least::<S>(passing.x, passing.y), passing.z);
        if most.simd_le(zero).all_true() {
            break;
        }
    }
    passing
}

/// The share of a lamp that a sphere covers, 0 to 1 (after Parker, Shirley and Smits: Single Sample Soft Shadows, 1998).
///
/// The rays from the point to the lamp form a cone. At the distance `a`, where it passes the sphere, it is `b = a diameter /
/// distance` wide. As the sphere's edge crosses the cone from one side to the other, the covered share goes from 0 to 1.
#[inline(always)]
fn sphere_covers<S: Isa>(simd: S, lamp: &Lamp, sphere: &Sphere, ways: &Ways<S>) -> F<S> {
    let centre = sphere.centre;
    let to_centre = Vec3x::splat(simd, centre) - ways.o;
    let a = at_least::<S>(to_centre.dot(ways.l), splat(simd, 0.0));
    let a = at_most::<S>(a, ways.distance);
    let off = to_centre.add_scaled(ways.l, -a);
    // A point that is off the sphere by no more than rounding lies on it.
    let error = 2e-6 * (centre.abs().max_element() + sphere.radius);
    let b = at_most::<S>(
        a * lamp.diameter / ways.distance,
        splat(simd, lamp.max_penumbra),
    );
    let depth = -off.dot(off).sqrt() + (sphere.radius - error);
    smooth_step(
        simd,
        depth / at_least::<S>(b, splat(simd, f32::MIN_POSITIVE)) + 0.5,
    )
}

/// Hermite's smooth step: 0 up to 0, 1 from 1 on.
#[inline(always)]
fn smooth_step<S: Isa>(simd: S, v: F<S>) -> F<S> {
    let v = clamp::<S>(v, splat(simd, 0.0), splat(simd, 1.0));
    v * v * (v * -2.0 + 3.0)
}
