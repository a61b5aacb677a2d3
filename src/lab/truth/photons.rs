//! Caustics: light that mirrors and glass send from a lamp to a rough surface, by ways that no closed form (`connect`) has.
//!
//! Paths from the eye hardly ever find such light, and those from the lamp do (Jensen, "Global Illumination using Photon Maps",
//! 1996). A photon lights a disc that reaches as far as some of its neighbours, and at least as far as some pixels: caustics are
//! blurred by as much. Each sample has photons of its own, of smaller discs from sample to sample (Knaus and Zwicker, "Progressive
//! Photon Mapping: A Probabilistic Approach", 2011): so noise and blur average out. What the same photons would light by discs of
//! half the radius tells how far the blur changes a pixel, which is part of its interval as the noise is.
//!
//! Photons are sent from lamps in the directions that `Aim` finds, most of them.
//!
//! At the edges of what is lit a part of the disc would be lost: there the photons that are on the surface count for those that
//! cannot be.

use super::aim::{Aim, Reach};
use super::connect::{Connections, Event, Gap};
use super::effects::Effects;
use super::lamp::Lamp;
use super::surface::Bsdf;
use super::world::{Body, World};
use crate::sampler::{Sampler, Sequence, around, seed_of};
use eightfold_oracle::geometry::Ray;
use eightfold_tracer::glam::{DVec2, DVec3};
use rayon::prelude::*;
use rstar::primitives::GeomWithData;
use rstar::{AABB, RTree, RTreeObject};
use std::f64::consts::{PI, TAU};

/// Photons that are sent out for one sample of a picture, all lamps together.
const PHOTONS: usize = 1 << 14;
/// The most mirrors and surfaces of glass that a photon passes.
const MAX_BOUNCES: usize = 16;
/// The least cosine between the normals of places that share their photons.
const SAME_SIDE: f64 = 0.9;
/// The least cosine of the angle at which light comes to a place, so that none is divided by 0.
const LEAST_COSINE: f64 = 1e-3;

/// The share of their radius that discs have to tell the blur.
const NARROW: f64 = 0.5;
/// Beyond the edge of a surface its plane is looked for as near as this to it, of the radius of a disc: as far as a surface is bent
/// within a disc while its normals are on the same side.
const LIFT: f64 = 0.25;
/// Places around a photon by which it is told how much of its surroundings is surface.
const AROUND: usize = 8;

/// Photons that tell whether light arrives by a part of the directions from a lamp.
const TRIED: usize = 8;

/// The neighbours that a photon's disc reaches: so many photons light a point, give or take some.
const NEIGHBOURS: usize = 12;

/// Light that has come to a rough surface.
struct Photon {
    p: DVec3,
    n: DVec3,
    /// Where it has come from, of length 1.
    d: DVec3,
    /// The power of the light, red, green and blue.
    power: DVec3,
    /// The radius of the disc that it lights, in scene units.
    radius: f64,
    /// Where its way has no closed form.
    gap: Gap,
    /// The index of the body that it has come to.
    body: usize,
    /// Whether that body's surface is all around the points that it lights.
    is_inner: bool,
}

/// Light, a part of which photons have blurred.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blurred {
    pub light: DVec3,
    /// How much more of it there is than by discs of `NARROW` of the radius.
    pub blur: DVec3,
}

/// The photons of one sample.
pub struct Photons {
    tree: RTree<Photon>,
    /// The share of its radius that a photon's disc has where the eye sees it, by way of mirrors and glass or not. What comes from
    /// there to other surfaces is a mean over all of these, so that its blur is hardly seen.
    narrower: f64,
}

impl RTreeObject for Photon {
    type Envelope = AABB<[f64; 3]>;

    /// The box around its disc.
    fn envelope(&self) -> Self::Envelope {
        let lower = self.p - self.radius;
        let upper = self.p + self.radius;
        AABB::from_corners(lower.to_array(), upper.to_array())
    }
}

impl Photons {
    /// No photons.
    pub fn none() -> Self {
        Self {
            tree: RTree::new(),
            narrower: 1.0,
        }
    }

    /// Sends photons from every lamp to every body that mirrors or lets light through, by points of a sequence with a seed. So many
    /// samples, `index`, had photons before.
    pub fn emit(
        world: &World,
        caustics: &Caustics,
        effects: Effects,
        sequence: Sequence,
        seed: u32,
        index: usize,
    ) -> Self {
        let mut photons = Vec::new();
        let count = PHOTONS / caustics.beams.len().max(1);
        for beam in &caustics.beams {
            let flight = Flight {
                world,
                connections: &caustics.connections,
                lamp: &world.lamps[beam.lamp],
                target: &world.bodies[beam.target],
                effects,
            };
            let seed = seed_of(seed, beam.part(world));
            for photon in 0..count {
                let mut sampler = Sampler::new(sequence, photon, seed);
                let (u, weight) = beam.aim.choose(&mut sampler);
                flight.send(u, weight / count as f64, &mut sampler, &mut photons);
            }
        }
        // The variance of the mean falls by the number of samples to the power of 2/3, and so does the squared error by the blur.
        let narrower = (index as f64 + 1.0).powf(-1.0 / 6.0);
        widen(&mut photons, world);
        Self {
            tree: RTree::bulk_load(photons),
            narrower,
        }
    }

    /// The light of the photons that a surface at `p` sends back along the path, which has been scattered before or not.
    pub fn reflected(&self, world: &World, p: DVec3, bsdf: &Bsdf, is_scattered: bool) -> Blurred {
        let here = AABB::from_point(p.to_array());
        let mut sum = Blurred::default();
        let narrower = if is_scattered { 1.0 } else { self.narrower };
        for photon in self.tree.locate_in_envelope_intersecting(here) {
            if photon.gap == Gap::Scattered && !is_scattered {
                continue;
            }
            let radius = narrower * photon.radius;
            // Epanechnikov's kernel, whose integral over the disc is 1.
            let kernel = |radius: f64| {
                let area = PI * radius * radius;
                2.0 * (1.0 - PI * p.distance_squared(photon.p) / area).max(0.0) / area
            };
            let wide = kernel(radius);
            let cosine = bsdf.n.dot(photon.d);
            if wide > 0.0 && cosine > LEAST_COSINE && bsdf.n.dot(photon.n) > SAME_SIDE {
                // The power counts the cosine already.
                let gain = photon.gain(world, p, radius) / cosine;
                let light = gain * photon.power * bsdf.of(photon.d);
                sum.light += wide * light;
                sum.blur += (wide - kernel(NARROW * radius)) * light;
            }
        }
        sum
    }
}

impl Photon {
    /// How many photons it counts for at a point that its disc of a radius lights. Turned about the point by quarters, it would come
    /// to up to four places on the surface; where it would come to none, no photon can.
    fn gain(&self, world: &World, p: DVec3, radius: f64) -> f64 {
        if self.is_inner {
            return 1.0;
        }
        let mut off = self.p - p;
        let mut places = 1;
        for _ in 1..4 {
            off = self.n.cross(off);
            places += u32::from(self.is_on_surface(world, p + off, radius));
        }
        4.0 / f64::from(places)
    }

    /// Whether the surface that it lights is at a point, too, by discs of a radius.
    fn is_on_surface(&self, world: &World, p: DVec3, radius: f64) -> bool {
        let lift = LIFT * radius;
        let met = world.nearest(Ray::new(p + lift * self.n, -self.n));
        met.is_some_and(|(body, met)| {
            std::ptr::eq(body, &world.bodies[self.body])
                && met.t < 2.0 * lift
                && met.normal.dot(self.n).abs() > SAME_SIDE
        })
    }

    /// How much of the surroundings of the points that it lights is its surface: all of it is 1.
    fn surface_around(&self, world: &World) -> f64 {
        let reach = 2.0 * self.radius;
        let is_there = |i: &usize| {
            let off = around(self.n, 0.0, *i as f64 / AROUND as f64);
            self.is_on_surface(world, self.p + reach * off, reach)
        };
        (0..AROUND).filter(is_there).count() as f64 / AROUND as f64
    }
}

/// Widens the discs of photons until each reaches some neighbours, or all if there are few, and some pixels at least.
fn widen(photons: &mut [Photon], world: &World) {
    let places = photons.iter().map(|photon| photon.p.to_array());
    let places: Vec<_> = places.map(|p| GeomWithData::new(p, ())).collect();
    let tree = RTree::bulk_load(places);
    for photon in photons {
        let near = tree.nearest_neighbor_iter_with_distance_2(photon.p.to_array());
        // The first one is itself.
        let reach = near
            .take(NEIGHBOURS + 1)
            .last()
            .map_or(0.0, |(_, squared)| squared.sqrt());
        photon.radius = reach.max(world.blur);
        // Beyond an edge there are no neighbours, and the others are farther away.
        let there = photon.surface_around(world);
        photon.is_inner = there == 1.0;
        photon.radius = (there.sqrt() * reach).max(world.blur);
    }
}

/// The ways of light from a world's lamps by mirrors and glass.
pub struct Caustics {
    /// Those in closed form.
    pub connections: Connections,
    /// Where the others begin; none, if there are no others.
    beams: Vec<Beam>,
}

impl Caustics {
    /// Those of a world; without any but the ones in closed form, if photons are not asked for.
    pub fn new(world: &World, has_photons: bool) -> Self {
        let connections = Connections::new(&world.bodies, &world.lamps);
        let bodies = world.bodies.iter().enumerate();
        let targets: Vec<usize> = bodies
            .filter(|(_, body)| body.material.is_specular())
            .map(|(target, _)| target)
            .collect();
        let is_known = match *targets {
            [only] => world.bodies[only].material.kt == 0.0 && world.bodies[only].is_smooth(),
            _ => false,
        };
        let lamps = 0..world.lamps.len();
        let pairs: Vec<(usize, usize)> = lamps
            .flat_map(|lamp| targets.iter().map(move |&target| (lamp, target)))
            .filter(|_| has_photons && !is_known)
            .collect();
        let beams = pairs.into_par_iter().map(|(lamp, target)| {
            let flight = Flight {
                world,
                connections: &connections,
                lamp: &world.lamps[lamp],
                target: &world.bodies[target],
                effects: Effects::TRUTH,
            };
            let aim = Aim::new(|corner, side| flight.tried(corner, side));
            Beam { lamp, target, aim }
        });
        let beams = beams.collect();
        Self { connections, beams }
    }
}

/// What a lamp sends towards a body that mirrors or lets light through.
struct Beam {
    /// The lamp's index.
    lamp: usize,
    /// The body's.
    target: usize,
    aim: Aim,
}

impl Beam {
    /// A number of its own.
    fn part(&self, world: &World) -> u64 {
        (self.lamp * world.bodies.len() + self.target) as u64
    }
}

/// A photon on its way.
struct Flight<'a> {
    world: &'a World,
    connections: &'a Connections,
    lamp: &'a Lamp,
    target: &'a Body,
    effects: Effects,
}

impl Flight<'_> {
    /// How far photons come by some directions of a part of them, which is given by its lower corner and its side.
    fn tried(&self, corner: DVec2, side: f64) -> Reach {
        let bits = corner.x.to_bits() ^ corner.y.to_bits().rotate_left(32);
        let seed = seed_of(side.to_bits() as u32, bits);
        let reach = |i| {
            let mut sampler = Sampler::new(Sequence::Sobol, i, seed);
            let u = corner + side * sampler.next_2d();
            self.send(u, 1.0, &mut sampler, &mut Vec::new())
        };
        (0..TRIED).map(reach).max().unwrap_or(Reach::Nowhere)
    }

    /// Sends a photon with a share of the lamp's light towards the target in a direction, chosen by `u`, and leaves it where it meets
    /// rough surfaces behind that.
    fn send(
        &self,
        u: DVec2,
        share: f64,
        sampler: &mut Sampler,
        photons: &mut Vec<Photon>,
    ) -> Reach {
        let target = self.target;
        // Choose a ray from the lamp within the cone around the target.
        let (o, normal) = self
            .lamp
            .point(self.effects.soft_shadows, sampler.next_2d());
        let width = target.shape.width_from(o);
        let axis = (target.shape.centre() - o).normalize_or(DVec3::Y);
        let start = around(axis, 1.0 - u.x * width, u.y);
        let mut ray = Ray::new(o, start);
        let Some((body, met)) = self.world.nearest(ray) else {
            return Reach::Nowhere;
        };
        // Others have photons of their own. Those that would enter the lamp are not sent.
        let cosine = normal.map_or(1.0, |n| n.dot(start));
        if !std::ptr::eq(body, target) || cosine <= 0.0 {
            return Reach::Nowhere;
        }
        // Follow it from body to body.
        let first = ray.at(met.t);
        let solid_angle = TAU * width * cosine * share;
        let mut travelled = 0.0;
        let mut way: Vec<Event> = Vec::new();
        let mut reach = Reach::Nowhere;
        for bounce in 0..MAX_BOUNCES {
            let Some((body, met)) = self.world.nearest(ray) else {
                return reach;
            };
            if bounce > 0 {
                travelled += met.t;
            }
            let bsdf = self.world.surface(body, ray, &met, self.effects.surfaces);
            let next = ray.moved(met.t);
            // Leave a photon where no connection finds the way.
            let gap = if bounce > 0 {
                self.connections.gap(&way)
            } else {
                Gap::Nowhere
            };
            if !std::ptr::eq(body, target) && body.material.is_specular() {
                reach = reach.max(Reach::Further);
            }
            if bsdf.is_rough() && gap != Gap::Nowhere {
                reach = Reach::Rough;
                let unfolded = first + travelled * start;
                photons.push(Photon {
                    p: next.o,
                    n: bsdf.n,
                    d: -ray.d,
                    power: solid_angle * self.lamp.power(unfolded, self.effects.soft_shadows),
                    radius: 0.0,
                    gap,
                    body: self.world.index(body),
                    is_inner: false,
                });
            }
            // Go on as the surface mirrors it or lets it through.
            let Some(bounce) = bsdf.sample_bounce(sampler.next_1d()) else {
                return reach;
            };
            let Some((d, _)) = bsdf.bounced(bounce) else {
                return reach;
            };
            way.push(Event {
                body: self.world.index(body),
                bounce,
                is_flat: body.faces().iter().any(|face| face.is_at(ray, met)),
                is_inside: ray.d.dot(met.normal) > 0.0,
            });
            ray = next.turned(d);
        }
        reach
    }
}
