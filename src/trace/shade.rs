//! Light at a hit, by Phong's model, and the rays that leave it.

use super::intersect::{Hit, blocked};
use super::key::{self, States};
use super::stack::{Rays, Stack};
use super::{Counts, FIXED_POINT};
use crate::lanes::*;
use crate::prepare::{Prepared, Surface};
use crate::quality::Quality;

/// The most a node adds to a point, in units of full brightness; keeps sums of 127 nodes from overflowing.
pub(crate) const BRIGHTEST: f32 = 4.0;

/// What a node of a ray tree adds to its point.
pub(crate) struct Node<S: Simd> {
    colour: Vec3x<S>,
    key: U<S>,
}

impl<S: Simd> Node<S> {
    /// The terms in fixed point, a point after the other.
    #[inline(always)]
    pub fn pack(&self, simd: S) -> [[u32; 4]; LANES] {
        let fixed = |c: F<S>| {
            let c = c.min(F::splat(simd, BRIGHTEST));
            // Half of one is added so that cutting off rounds.
            let i: I<S> = fma(c, F::splat(simd, FIXED_POINT), F::splat(simd, 0.5)).to_int();
            i.bitcast::<U<S>>().to_array()
        };
        let (r, g, b) = (
            fixed(self.colour.x),
            fixed(self.colour.y),
            fixed(self.colour.z),
        );
        let key = self.key.to_array();
        core::array::from_fn(|i| [r[i], g[i], b[i], key[i]])
    }
}

/// Shades the hits, puts the secondary rays on the stack and returns what the hits add to their points.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a kernel's inputs and outputs")]
pub(crate) fn shade<S: Simd>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    rays: &Rays<S>,
    hit: &Hit<S>,
    active: M<S>,
    stack: &mut Stack,
    counts: &mut Counts,
) -> Node<S> {
    let splat = |v: f32| F::splat(simd, v);
    let zero = splat(0.0);
    let surface = SurfaceLanes::look_up(simd, scene, hit.object, active);
    let solid = active & surface.solid.simd_gt(zero);
    let paths = rays.paths();
    let in_key = paths.simd_lt(U::splat(simd, 2 << quality.key_depth));
    let mut colour = surface.base;
    let mut states = States::new(simd);

    if solid.any_true() {
        // The normal faces the ray.
        let p = rays.o.add_scaled(rays.d, hit.t);
        let mut n = (p - surface.centre) * surface.inverse_radius;
        n.y += surface.upright;
        let outward = rays.d.dot(n);
        let inside = outward.simd_gt(zero);
        let flip = outward.to_bits() & U::splat(simd, 1 << 31) ^ U::splat(simd, 1 << 31);
        let flipped = |c: F<S>| -> F<S> { (c.to_bits() ^ flip).bitcast() };
        let n = Vec3x {
            x: flipped(n.x),
            y: flipped(n.y),
            z: flipped(n.z),
        };
        let dn = flipped(outward);
        let reflected = rays.d.add_scaled(n, dn * -2.0);

        for lamp in &scene.lights[..scene.light_count] {
            let to_light = Vec3x::splat(simd, lamp.position) - p;
            let distance = to_light.dot(to_light).sqrt();
            let l = to_light * (splat(1.0) / distance);
            let nl = n.dot(l);
            let facing = solid & nl.simd_gt(zero);
            let mut lit = facing;
            let mut highlight = M::splat(simd, false);
            if facing.any_true() {
                counts.shadow_rays += u64::from(facing.to_bitmask().count_ones());
                lit &= !blocked(simd, scene, p, l, distance, facing);
                let mut light = surface.diffuse * lit.select(nl, zero);
                let rv = reflected.dot(l);
                let shiny = lit & rv.simd_gt(surface.faint);
                if shiny.any_true() {
                    let base = shiny.select(rv, splat(1.0));
                    let specular = shiny.select(surface.ks * pow(base, surface.exponent), zero);
                    highlight = specular.simd_gt(splat(quality.highlight));
                    light = light
                        + Vec3x {
                            x: specular,
                            y: specular,
                            z: specular,
                        };
                }
                colour = colour + Vec3x::splat(simd, lamp.colour) * light;
            }
            states.push(lit, highlight);
        }

        // The secondary rays.
        let least = splat(quality.least_contribution);
        let deep = paths.simd_ge(U::splat(simd, 1 << quality.depth));
        let follow = solid & !deep;
        let mut kr = surface.kr;
        let glass = follow & surface.kt.simd_gt(zero);
        if glass.any_true() {
            let eta = inside.select(surface.index, splat(1.0) / surface.index);
            let k = splat(1.0) - eta * eta * (splat(1.0) - dn * dn);
            let total = k.simd_lt(zero);
            kr = (glass & total).select(kr + surface.kt, kr);
            let weight = rays.weight * surface.kt;
            let through = glass & !total & weight.simd_ge(least);
            let along = -(fma(eta, dn, k.max(zero).sqrt()));
            let d = (rays.d * eta).add_scaled(n, along);
            let place = rays.reflected_places() + 1;
            stack.push(
                &Rays {
                    o: p,
                    d,
                    weight,
                    place,
                },
                through,
            );
        }
        let weight = rays.weight * kr;
        let back = follow & weight.simd_ge(least);
        if back.any_true() {
            let place = rays.reflected_places();
            stack.push(
                &Rays {
                    o: p,
                    d: reflected,
                    weight,
                    place,
                },
                back,
            );
        }
    }

    let with_states = paths.simd_lt(U::splat(simd, 2 << quality.state_depth));
    let key = key::term(paths, hit.object, states, with_states);
    Node {
        colour: colour * rays.weight,
        key: in_key.select(key, U::splat(simd, 0)),
    }
}

/// The surfaces that eight rays hit.
struct SurfaceLanes<S: Simd> {
    centre: Vec3x<S>,
    inverse_radius: F<S>,
    upright: F<S>,
    base: Vec3x<S>,
    diffuse: Vec3x<S>,
    ks: F<S>,
    exponent: F<S>,
    faint: F<S>,
    kr: F<S>,
    kt: F<S>,
    index: F<S>,
    solid: F<S>,
}

impl<S: Simd> SurfaceLanes<S> {
    /// Looks the objects up. Most packets meet one or two objects: one is spread over all lanes, then each other one
    /// over those that hit it.
    #[inline(always)]
    fn look_up(simd: S, scene: &Prepared, objects: U<S>, active: M<S>) -> Self {
        let numbers = objects.to_array();
        let mut rest = active.to_bitmask();
        let mut number = numbers[rest.trailing_zeros() as usize % LANES];
        let mut lanes = Self::splat(simd, &scene.surfaces[number as usize]);
        loop {
            rest &= !objects.simd_eq(U::splat(simd, number)).to_bitmask();
            if rest == 0 {
                return lanes;
            }
            number = numbers[rest.trailing_zeros() as usize % LANES];
            let mask = objects.simd_eq(U::splat(simd, number));
            lanes.put(mask, &Self::splat(simd, &scene.surfaces[number as usize]));
        }
    }

    #[inline(always)]
    fn splat(simd: S, s: &Surface) -> Self {
        let splat = |v: f32| F::splat(simd, v);
        Self {
            centre: Vec3x::splat(simd, s.centre),
            inverse_radius: splat(s.inverse_radius),
            upright: splat(s.upright),
            base: Vec3x::splat(simd, s.base),
            diffuse: Vec3x::splat(simd, s.diffuse),
            ks: splat(s.ks),
            exponent: splat(s.exponent),
            faint: splat(s.faint),
            kr: splat(s.kr),
            kt: splat(s.kt),
            index: splat(s.index),
            solid: splat(s.solid),
        }
    }

    #[inline(always)]
    fn put(&mut self, mask: M<S>, other: &Self) {
        self.centre = other.centre.where_else(mask, self.centre);
        self.base = other.base.where_else(mask, self.base);
        self.diffuse = other.diffuse.where_else(mask, self.diffuse);
        for (mine, new) in [
            (&mut self.inverse_radius, other.inverse_radius),
            (&mut self.upright, other.upright),
            (&mut self.ks, other.ks),
            (&mut self.exponent, other.exponent),
            (&mut self.faint, other.faint),
            (&mut self.kr, other.kr),
            (&mut self.kt, other.kt),
            (&mut self.index, other.index),
            (&mut self.solid, other.solid),
        ] {
            *mine = mask.select(new, *mine);
        }
    }
}
