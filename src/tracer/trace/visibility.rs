//! Visibility: which points of a packet a lamp's light reaches, and how much of it. Coordinates are the scene's.

use super::candidates::Blockers;
use super::point::ShadingPoint;
use super::shadow::ShadowRays;
use super::surface::SurfaceLanes;
use super::transmittance::transmittance;
use crate::counts::Counts;
use crate::lanes::*;
use crate::prepare::{Lamp, Parameter, World};

/// The light of one lamp that arrives at the points of a packet.
pub(super) struct ArrivingLight<S: Isa> {
    /// The directions to the lamp, of length 1.
    pub l: Vec3x<S>,
    /// The cosine of the angle between normal and `l`.
    pub nl: F<S>,
    /// The points that light arrives at.
    pub lit: M<S>,
    /// The light, per channel; of no meaning at other points.
    pub colour: Vec3x<S>,
}

/// The points of a packet, as lamps see them.
pub(super) struct Visibility<'a, S: Isa> {
    simd: S,
    world: World<'a>,
    point: &'a ShadingPoint<S>,
    /// The cosine of the angle between normal and lamp has to be more than this times the lamp's distance.
    ///
    /// It is 0 but for points inside of a sphere, whose far side blocks all lamps beyond it: the chord towards a lamp has the
    /// length of twice the cosine times the radius.
    least: F<S>,
}

impl<'a, S: Isa> Visibility<'a, S> {
    /// The points of a packet, on these surfaces.
    #[inline(always)]
    pub fn new(
        simd: S,
        world: World<'a>,
        surface: &SurfaceLanes<'_, S>,
        point: &'a ShadingPoint<S>,
    ) -> Self {
        let least = surface.number(Parameter::InverseRadius) * 0.5;
        Self {
            simd,
            world,
            point,
            least: point.inside.select(least, splat(simd, 0.0)),
        }
    }

    /// The light of a lamp that arrives; `None` if all points face away from the lamp or are outside of its cone.
    #[inline(always)]
    pub fn light_of(
        &self,
        lamp: &Lamp,
        blockers: &mut Blockers,
        counts: &mut Counts,
    ) -> Option<ArrivingLight<S>> {
        let &Self {
            simd, world, point, ..
        } = self;
        let to_light = Vec3x::splat(simd, lamp.position) - point.p;
        let distance = to_light.dot(to_light).sqrt();
        let l = to_light.scaled(splat::<S>(simd, 1.0) / distance);
        let nl = point.n.dot(l);
        let mut facing = point.solid & nl.simd_gt(distance * self.least);
        if !lamp.is_point {
            let inward: F<S> = -l.dot(Vec3x::splat(simd, lamp.cone.aim));
            facing &= inward.simd_gt(splat(simd, lamp.cone.cos_outer));
        }
        if !facing.any_true() {
            return None;
        }
        counts.shadow_rays += u64::from(facing.to_bitmask().count_ones());
        let rays = ShadowRays {
            o: point.p,
            d: l,
            distance,
        };
        let mut lit = facing & !blockers.find(simd, world, lamp, &rays);
        let mut colour = Vec3x::splat(simd, lamp.colour);
        if lamp.is_cone || !blockers.solids.is_empty() {
            let rays = ShadowRays {
                distance: lit.select(distance, splat(simd, 0.0)),
                ..rays
            };
            let passing = transmittance(simd, world, lamp, &rays, &blockers.solids);
            lit &= passing.max_element().simd_gt(splat(simd, 0.0));
            colour = colour * passing;
        }
        Some(ArrivingLight { l, nl, lit, colour })
    }
}
