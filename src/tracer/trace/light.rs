use super::Tracer;
use super::candidates::Occluders;
use super::key::Keys;
use super::point::ShadingPoint;
use super::surface::SurfaceLanes;
use super::visibility::ArrivingLight;
use crate::counts::Counts;
use crate::lanes::*;
use crate::prepare::Parameter;
use glam::Vec3A;

pub(super) struct Reflected<S: Isa> {
    /// Ambient and diffuse light, before the texture is applied.
    pub untextured: Vec3x<S>,
    pub specular: Vec3x<S>,
}

/// Returns the reflected light, and adds the lights' states to the keys.
#[inline(always)]
pub(super) fn gather<S: Isa>(
    tracer: Tracer<'_, S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    ambient: Vec3x<S>,
    keys: &mut Keys<S>,
    occluders: &mut Occluders,
    counts: &mut Counts,
) -> Reflected<S> {
    let (simd, world, quality) = (tracer.isa, tracer.world, tracer.quality);
    let zero = splat(simd, 0.0);
    let none = M::<S>::splat(simd, false);
    let mut diffuse = Vec3x::splat(simd, Vec3A::ZERO);
    let mut specular = diffuse;
    // Black mirrors, glass and films show neither lights nor shadows.
    let reflectance = surface.vector(Parameter::Diffuse).max_element();
    let shows = point.shaded & (reflectance + surface.number(Parameter::Ks)).simd_gt(zero);
    for light in world.lights() {
        let Some(light) = point.light_of(simd, world, light, shows, occluders, counts) else {
            keys.push(none, none);
            continue;
        };
        let ArrivingLight { nl, lit, colour, .. } = light;
        diffuse = diffuse.add_scaled(colour, lit.select(nl, zero));
        let mut counted = none;
        if let Some(strength) = highlight(simd, surface, point, &light) {
            specular = specular.add_scaled(colour, strength);
            counted = strength.simd_gt(splat(simd, quality.highlight));
        }
        keys.push(lit, counted);
    }
    Reflected {
        untextured: ambient + surface.vector(Parameter::Diffuse) * diffuse,
        specular: surface.vector(Parameter::Highlight) * specular,
    }
}

#[inline(always)]
fn highlight<S: Isa>(
    simd: S,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    light: &ArrivingLight<S>,
) -> Option<F<S>> {
    let rv = cosine(simd, point, &light.l);
    let shiny = light.lit & rv.simd_gt(surface.number(Parameter::HighlightStart));
    if !shiny.any_true() {
        return None;
    }
    let base = shiny.select(rv, splat(simd, 1.0));
    let lobe = pow(simd, base, surface.number(Parameter::Exponent));
    let strength = surface.number(Parameter::Ks) * lobe;
    Some(shiny.select(strength, splat(simd, 0.0)))
}

#[inline(always)]
fn cosine<S: Isa>(simd: S, point: &ShadingPoint<S>, l: &Vec3x<S>) -> F<S> {
    let rv = point.r.dot(*l);
    if !point.anisotropy.simd_gt(splat(simd, 0.0)).any_true() {
        return rv;
    }
    // See `Material::anisotropy`.
    let along = (*l - point.r).dot(point.groove);
    rv + point.anisotropy * (-rv + along.mul_add(along * -0.5, splat(simd, 1.0)))
}
