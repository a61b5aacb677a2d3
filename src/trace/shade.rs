//! Light at a hit, by Phong's model, and the rays that leave it.

use super::Counts;
use super::batch::{Batch, FIXED_POINT};
use super::details::{self, Packet};
use super::intersect::{Hit, blocked};
use super::key::{self, States};
use super::stack::{Rays, Stack};
use super::surface::SurfaceLanes;
use crate::lanes::*;
use crate::prepare::Prepared;
use crate::quality::Quality;
use glam::Vec3A;

/// The most a node adds to a point, in units of full brightness.
///
/// Beyond 1 it would not be seen, since no node takes light away; the sums of the 255 nodes of the deepest tree do not
/// overflow.
const BRIGHTEST: f32 = 2.0;

/// What a node of a ray tree adds to its point.
pub(super) struct Node<S: Isa> {
    pub colour: Vec3x<S>,
    key: U<S>,
}

impl<S: Isa> Node<S> {
    /// Stores blue, green and red in fixed point and the key, a point after the other.
    #[inline(always)]
    pub fn store(&self, simd: S, sums: &mut [i32]) {
        let key: I<S> = self.key.bitcast();
        let (br0, br1) = fixed(simd, self.colour.z).interleave(fixed(simd, self.colour.x));
        let (gk0, gk1) = fixed(simd, self.colour.y).interleave(key);
        let (first, second) = br0.interleave(gk0);
        let (third, fourth) = br1.interleave(gk1);
        for (row, sums) in [first, second, third, fourth]
            .iter()
            .zip(sums.chunks_mut(lanes::<S>()))
        {
            row.store_slice(sums);
        }
    }
}

/// A number in fixed point, rounded.
#[inline(always)]
fn fixed<S: Isa>(simd: S, c: F<S>) -> I<S> {
    let c = c.max(splat(simd, 0.0)).min(splat(simd, BRIGHTEST));
    // Half of one is added so that cutting off rounds.
    c.mul_add(splat(simd, FIXED_POINT), splat(simd, 0.5))
        .to_int()
}

/// Where a hit is farther than this share of the radius from its sphere, one Newton step does not take it there to
/// within rounding.
const NEWTON: f32 = 1.0 / (1 << 13) as f32;

/// Where light is gathered.
pub(super) struct Place<S: Isa> {
    pub p: Vec3x<S>,
    /// The normal, of length 1; it faces the ray.
    pub n: Vec3x<S>,
    /// The ray's direction against the normal, not above 0.
    dn: F<S>,
    /// The reflected direction.
    r: Vec3x<S>,
    /// How far `p` is from the surface, against the ray.
    slack: F<S>,
    /// What a pattern leaves of the colour.
    left: F<S>,
    /// Whether the ray comes from within.
    pub inside: M<S>,
    /// Lanes that hit something that lamps shine on.
    solid: M<S>,
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
) -> Node<S> {
    let Batch {
        mixed,
        stack,
        counts,
        packet,
        ..
    } = batch;
    let surface = SurfaceLanes::look_up(simd, scene, hit.object, active, mixed);
    let solid = active & surface.solid().simd_gt(splat(simd, 0.0));
    let mut colour = surface.base();
    let mut states = States::new(simd);
    let mut weight = rays.weight;
    if scene.details.is_there() {
        weight *= packet.through(simd);
    }
    if solid.any_true() {
        let closer = scene.details.is_there().then_some(&*packet);
        let place = Place::new(simd, rays, hit.t, &surface, solid, closer);
        colour = gather(
            simd,
            scene,
            quality,
            &surface,
            &place,
            &mut states,
            counts,
            packet,
        );
        let marks = rays.mirror_marks(simd, hit.object, scene.first_plane());
        scatter(simd, quality, rays, weight, &surface, &place, marks, stack);
    }
    if scene.details.is_there() {
        let behind = packet.behind.load(simd);
        let through = packet.through(simd);
        colour = behind.add_scaled(colour - behind, through);
    }
    let paths = rays.paths();
    Node {
        colour: colour.scaled(active.select(rays.weight, splat(simd, 0.0))),
        key: key::term(simd, quality, active, paths, hit.object, states),
    }
}

impl<S: Isa> Place<S> {
    /// Where rays of length `t` hit, by what a closer look has found, if there was one.
    #[inline(always)]
    pub fn new(
        simd: S,
        rays: &Rays<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
        solid: M<S>,
        closer: Option<&Packet>,
    ) -> Self {
        let mut place = Self::on_surface(simd, rays, t, surface, solid);
        if let Some(packet) = closer {
            place.look_closer(simd, packet);
        }
        place.face(simd, rays);
        place
    }

    /// As spheres and planes are hit.
    #[inline(always)]
    fn on_surface(
        simd: S,
        rays: &Rays<S>,
        t: F<S>,
        surface: &SurfaceLanes<'_, S>,
        solid: M<S>,
    ) -> Self {
        let zero = splat(simd, 0.0);
        let inverse_radius = surface.inverse_radius();
        let upright = surface.upright();
        // From the centre to the hit, and back to a sphere by its square against the radius: the error of t does not go on
        // to the rays that start here.
        let out = (rays.o - surface.centre()).add_scaled(rays.d, t);
        let square: F<S> = out.dot(out) * (inverse_radius * inverse_radius);
        let mut scale = square.mul_add(
            splat(simd, -0.5),
            upright.mul_add(splat(simd, -0.5), splat(simd, 1.5)),
        );
        let far = solid & (scale - 1.0).abs().simd_gt(splat(simd, NEWTON));
        if far.any_true() {
            scale = far.select(splat::<S>(simd, 1.0) / square.sqrt(), scale);
        }
        let mut p = surface.centre().add_scaled(out, scale);
        // On a plane, exactly.
        p.y = upright.simd_gt(zero).select(surface.centre().y, p.y);
        let mut n = out.scaled(scale * inverse_radius);
        n.y += upright;
        Self {
            p,
            n,
            dn: zero,
            r: n,
            slack: zero,
            left: splat(simd, 1.0),
            inside: solid,
            solid,
        }
    }

    /// Boxes and cylinders as they are, and what patterns leave.
    #[inline(always)]
    fn look_closer(&mut self, simd: S, packet: &Packet) {
        self.slack = packet.slack(simd);
        self.left = packet.left(simd);
        let is_block = self.slack.simd_gt(splat(simd, 0.0));
        let (p, n) = (packet.p(simd), packet.n(simd));
        self.p = select(is_block, p, self.p);
        self.n = select(is_block, n, self.n);
    }

    /// Turns the normal to the rays, and reflects them.
    #[inline(always)]
    fn face(&mut self, simd: S, rays: &Rays<S>) {
        let n = self.n;
        let outward = rays.d.dot(n);
        // The sign that turns a normal along the ray round.
        let sign = U::<S>::splat(simd, 1 << 31);
        let flip = (outward.bitcast::<U<S>>() & sign) ^ sign;
        let n = Vec3x {
            x: flipped::<S>(n.x, flip),
            y: flipped::<S>(n.y, flip),
            z: flipped::<S>(n.z, flip),
        };
        self.n = n;
        self.dn = flipped::<S>(outward, flip);
        self.r = rays.d.add_scaled(n, self.dn * -2.0);
        self.inside = outward.simd_gt(splat(simd, 0.0));
    }
}

#[inline(always)]
fn select<S: Isa>(mask: M<S>, a: Vec3x<S>, b: Vec3x<S>) -> Vec3x<S> {
    Vec3x {
        x: mask.select(a.x, b.x),
        y: mask.select(a.y, b.y),
        z: mask.select(a.z, b.z),
    }
}

/// The light that a place sends back along the ray: ambient light, and each lamp's that is not blocked.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a place, and who looks at it")]
fn gather<S: Isa>(
    simd: S,
    scene: &Prepared,
    quality: &Quality,
    surface: &SurfaceLanes<'_, S>,
    place: &Place<S>,
    states: &mut States<S>,
    counts: &mut Counts,
    packet: &mut Packet,
) -> Vec3x<S> {
    let zero = splat(simd, 0.0);
    let one = splat(simd, 1.0);
    // What lamps give to all diffuse and to all specular reflection.
    let mut diffuse = Vec3x::splat(simd, Vec3A::ZERO);
    let mut specular = diffuse;
    // A sphere shades itself from within: no light comes from beyond the chord towards the lamp, which is as long as
    // twice the cosine and the radius.
    let least = place.inside.select(surface.inverse_radius() * 0.5, zero);
    for lamp in scene.lamps() {
        let to_light = Vec3x::splat(simd, lamp.position) - place.p;
        let distance = to_light.dot(to_light).sqrt();
        let l = to_light.scaled(one / distance);
        let nl = place.n.dot(l);
        let mut facing = place.solid & nl.simd_gt(distance * least);
        if !lamp.is_plain() {
            let inward: F<S> = -l.dot(Vec3x::splat(simd, lamp.cone.aim));
            facing &= inward.simd_gt(splat(simd, lamp.cone.dark));
        }
        let mut lit = facing;
        let mut highlight = M::<S>::splat(simd, false);
        if facing.any_true() {
            counts.shadow_rays += u64::from(facing.to_bitmask().count_ones());
            lit &= !blocked(simd, scene, lamp, place.p, l, distance, packet);
            let mut colour = Vec3x::splat(simd, lamp.colour);
            if !lamp.is_plain() && (lamp.is_cone || !packet.is_empty()) {
                packet.set(place.p, l, lit.select(distance, zero));
                details::reach::<S>(scene, lamp, lit, packet);
                let passing = packet.passing.load(simd);
                lit &= passing.x.max(passing.y).max(passing.z).simd_gt(zero);
                colour = colour * passing;
            }
            diffuse = diffuse.add_scaled(colour, lit.select(nl, zero));
            let rv = place.r.dot(l);
            let shiny = lit & rv.simd_gt(surface.faint());
            if shiny.any_true() {
                let strength = surface.ks() * pow(simd, shiny.select(rv, one), surface.exponent());
                let strength = shiny.select(strength, zero);
                highlight = strength.simd_gt(splat(simd, quality.highlight));
                specular = specular.add_scaled(colour, strength);
            }
        }
        if quality.needs_keys() {
            states.push(lit, highlight);
        }
    }
    let full = surface.base() + surface.diffuse() * diffuse;
    packet.full.store(full);
    specular.add_scaled(full, place.left)
}

/// Puts the transmitted and the reflected rays on the stack.
#[inline(always)]
#[allow(clippy::too_many_arguments, reason = "a place, and rays that leave it")]
fn scatter<S: Isa>(
    simd: S,
    quality: &Quality,
    rays: &Rays<S>,
    weight: F<S>,
    surface: &SurfaceLanes<'_, S>,
    place: &Place<S>,
    marks: U<S>,
    stack: &mut Stack,
) {
    let zero = splat(simd, 0.0);
    let one = splat(simd, 1.0);
    let least = splat(simd, quality.least_contribution);
    let deepest = U::<S>::splat(simd, 1 << quality.depth);
    let follow = place.solid & rays.paths().simd_lt(deepest);
    let reflected = rays.reflected_places();
    let mut kr = surface.kr();
    let Place {
        p, n, dn, slack, ..
    } = *place;
    let mut through = M::<S>::splat(simd, false);
    let mut transmitted = Rays {
        o: p.add_scaled(n, slack * -2.0),
        d: place.r,
        weight: zero,
        place: reflected + 1,
    };
    let glass = follow & surface.kt().simd_gt(zero);
    if glass.any_true() {
        let eta = place.inside.select(surface.index(), one / surface.index());
        // The cosine of the transmitted ray, squared; below 0 all light is reflected.
        let k = one - eta * eta * (one - dn * dn);
        let total = k.simd_lt(zero);
        kr = (glass & total).select(kr + surface.kt(), kr);
        transmitted.weight = weight * surface.kt();
        through = glass & !total & transmitted.weight.simd_ge(least);
        let along = -eta.mul_add(dn, k.max(zero).sqrt());
        transmitted.d = rays.d.scaled(eta).add_scaled(n, along);
    }
    let weight = weight * kr;
    let back = follow & weight.simd_ge(least);
    let reflected = Rays {
        o: p,
        d: place.r,
        weight,
        place: reflected | marks,
    };
    if through.any_true() {
        stack.push(simd, &transmitted, through);
    }
    if back.any_true() {
        stack.push(simd, &reflected, back);
    }
}
