//! Direct light by Phong's model: what surfaces reflect of the light that arrives.

use super::Tracer;
use super::candidates::Blockers;
use super::key::Keys;
use super::point::ShadingPoint;
use super::surface::SurfaceLanes;
use super::visibility::{ArrivingLight, Visibility};
use crate::counts::Counts;
use crate::lanes::*;
use crate::prepare::Parameter;
use glam::Vec3A;

/// The light that surfaces reflect along the rays.
pub(super) struct Reflected<S: Isa> {
    /// Ambient light and diffuse reflection, before the texture is applied.
    pub untextured: Vec3x<S>,
    /// Highlights.
    pub specular: Vec3x<S>,
}

/// Ambient light, and the light of each lamp that reaches the points. The keys get each lamp's state.
#[inline(always)]
pub(super) fn gather<S: Isa>(
    tracer: Tracer<'_, S>,
    surface: &SurfaceLanes<'_, S>,
    point: &ShadingPoint<S>,
    keys: &mut Keys<S>,
    blockers: &mut Blockers,
    counts: &mut Counts,
) -> Reflected<S> {
    let Tracer {
        isa: simd, world, ..
    } = tracer;
    let visibility = Visibility::new(simd, world, surface, point);
    let mut phong = Phong {
        tracer,
        surface,
        point,
        diffuse: Vec3x::splat(simd, Vec3A::ZERO),
        specular: Vec3x::splat(simd, Vec3A::ZERO),
    };
    let none = M::<S>::splat(simd, false);
    for lamp in world.lamps() {
        match visibility.light_of(lamp, blockers, counts) {
            Some(light) => {
                let highlight = phong.add(&light);
                keys.push(light.lit, highlight);
            }
            None => keys.push(none, none),
        }
    }
    Reflected {
        untextured: surface.emitted() + surface.vector(Parameter::Diffuse) * phong.diffuse,
        specular: surface.vector(Parameter::Highlight) * phong.specular,
    }
}

/// Sums of the light that a packet's surfaces reflect.
struct Phong<'a, S: Isa> {
    tracer: Tracer<'a, S>,
    surface: &'a SurfaceLanes<'a, S>,
    point: &'a ShadingPoint<S>,
    /// Diffuse reflection by white surfaces.
    diffuse: Vec3x<S>,
    specular: Vec3x<S>,
}

impl<S: Isa> Phong<'_, S> {
    /// Adds a lamp's light. Returns the points where its highlight is strong enough to count in the key.
    #[inline(always)]
    fn add(&mut self, light: &ArrivingLight<S>) -> M<S> {
        let Tracer {
            isa: simd, quality, ..
        } = self.tracer;
        let (zero, one) = (splat(simd, 0.0), splat(simd, 1.0));
        let &ArrivingLight { l, nl, lit, colour } = light;
        self.diffuse = self.diffuse.add_scaled(colour, lit.select(nl, zero));
        let rv = self.cosine(&l);
        let shiny = lit & rv.simd_gt(self.surface.number(Parameter::HighlightStart));
        if !shiny.any_true() {
            return M::<S>::splat(simd, false);
        }
        let base = shiny.select(rv, one);
        let strength = self.surface.number(Parameter::Ks)
            * pow(simd, base, self.surface.number(Parameter::Exponent));
        let strength = shiny.select(strength, zero);
        self.specular = self.specular.add_scaled(colour, strength);
        strength.simd_gt(splat(simd, quality.highlight))
    }

    /// The cosine of the angle between the mirrored ray and the direction to a lamp, or what grooves make of it.
    #[inline(always)]
    fn cosine(&self, l: &Vec3x<S>) -> F<S> {
        let &ShadingPoint {
            r,
            groove,
            anisotropy,
            ..
        } = self.point;
        let simd = self.tracer.isa;
        let rv = r.dot(*l);
        if !anisotropy.simd_gt(splat(simd, 0.0)).any_true() {
            return rv;
        }
        // See `Material::anisotropy`.
        let along = (*l - r).dot(groove);
        rv + anisotropy * (-rv + along.mul_add(along * -0.5, splat(simd, 1.0)))
    }
}
