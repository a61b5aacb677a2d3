//! Caustics in closed form: the ways of light from a lamp to a point by flat mirrors, or by way of one round body.
//!
//! A flat mirror shows a lamp as if a second one stood behind it: that is looked for as any lamp is. By a sphere the way lies in the
//! plane of its centre, the lamp and the point, so that one angle is to be found (manifold exploration in one dimension), and by the
//! side of a cylinder it does so in a cross-section. All other ways are left to [photons](super::photons), which must leave these
//! out.
//!
//! A ball of glass gathers light in a small place. Paths that were scattered find that by chance, hardly ever and very bright, which is
//! noise; photons, which blur it, have none. So light through balls is theirs wherever a path has been scattered before.

use super::effects::Effects;
use super::lamp::Lamp;
use super::plan::Plan;
use super::surface::{Bounce, Bsdf};
use super::world::{Body, World};
use crate::sampler::{Sampler, around};
use eightfold_oracle::geometry::{Face, Ray, Round, Shape};
use eightfold_tracer::glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// The most flat mirrors that are followed one after another, and the most images of lamps in them: each costs a ray at every point.
const MOST_MIRRORS: usize = 4;
const MOST_IMAGES: usize = 64;
/// The least cosine of the angle between a way that was looked for and the ray that was traced along it.
const SAME_WAY: f64 = 1.0 - 1e-6;

/// A lamp as flat mirrors show it.
#[derive(Clone, Debug)]
struct Image {
    lamp: Lamp,
    /// The mirrors on the way to it: the body's index, and its face.
    mirrors: Vec<(usize, Face)>,
}

/// The lamps and the bodies between which ways are known in closed form.
#[derive(Clone, Debug, Default)]
pub struct Connections {
    images: Vec<Image>,
    /// The number of flat mirrors that are followed one after another.
    mirrors: usize,
    /// The spheres that mirror light, with their bodies' indices.
    rounds: Vec<(usize, Round)>,
    /// The indices of spheres that mirror or let light through.
    spheres: Vec<usize>,
}

impl Connections {
    /// Those of a world's lamps and bodies.
    pub fn new(bodies: &[Body], lamps: &[Lamp]) -> Self {
        let specular = || {
            bodies
                .iter()
                .enumerate()
                .filter(|it| it.1.material.is_specular())
        };
        let spheres = specular().filter(|(_, body)| matches!(body.shape, Shape::Sphere { .. }));
        let faces: Vec<(usize, Face)> = specular()
            .flat_map(|(i, body)| body.faces().into_iter().map(move |face| (i, face)))
            .collect();
        let mut all = Self {
            rounds: specular()
                .flat_map(|(i, body)| body.shape.rounds().into_iter().map(move |it| (i, it)))
                .collect(),
            spheres: spheres.map(|(i, _)| i).collect(),
            ..Self::default()
        };
        let mut last: Vec<Image> = lamps
            .iter()
            .map(|&lamp| Image {
                lamp,
                mirrors: Vec::new(),
            })
            .collect();
        while all.mirrors < MOST_MIRRORS {
            last = last
                .iter()
                .flat_map(|image| faces.iter().filter_map(|&mirror| image.behind(mirror)))
                .collect();
            // Of one mirror all are followed.
            if last.is_empty() || all.mirrors > 0 && all.images.len() + last.len() > MOST_IMAGES {
                break;
            }
            all.images.extend_from_slice(&last);
            all.mirrors += 1;
        }
        all
    }

    /// Where light that has gone this way, by bodies that it met from within or not, is left to photons.
    pub fn gap(&self, way: &[Event]) -> Gap {
        let is_flat = |event: &Event| event.is_flat && event.bounce == Bounce::Mirrored;
        let are_outside = !way[0].is_inside;
        let is_sphere = |event: &Event| self.spheres.contains(&event.body);
        match *way {
            [only] if self.rounds.iter().any(|it| it.0 == only.body) => {
                Gap::none_if(are_outside && only.bounce == Bounce::Mirrored)
            }
            [into, out] if is_sphere(&into) && are_outside && into.body == out.body => {
                let are_through = [into, out].iter().all(|it| it.bounce == Bounce::Through);
                if are_through {
                    Gap::Scattered
                } else {
                    Gap::All
                }
            }
            _ => Gap::none_if(way.len() <= self.mirrors && way.iter().all(is_flat)),
        }
    }

    /// The light of all lamps, by these ways, that a surface sends back along the path. `here` starts at the surface;
    /// `is_scattered` is whether the path has been scattered before.
    pub fn light(
        &self,
        world: &World,
        here: Ray,
        bsdf: &Bsdf,
        effects: &Effects,
        is_scattered: bool,
        sampler: &mut Sampler,
    ) -> DVec3 {
        let point = Point {
            world,
            here,
            bsdf,
            effects,
        };
        let images = self.images.iter();
        let mut sum: DVec3 = images
            .map(|it| point.by_mirrors(it, sampler.next_2d()))
            .sum();
        for round in &self.rounds {
            let is_sphere = self.spheres.contains(&round.0);
            for lamp in &world.lamps {
                let u = sampler.next_2d();
                sum += point.by_round(round, Bounce::Mirrored, lamp, u);
                if is_sphere && world.bodies[round.0].material.kt > 0.0 && !is_scattered {
                    let directions = sampler.next_2d();
                    sum += point.by_round(round, Bounce::Through, lamp, u);
                    sum += point.through_sphere(round, lamp, directions);
                }
            }
        }
        sum
    }
}

/// Where a way of light has no closed form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gap {
    Nowhere,
    /// At surfaces at which a path arrives scattered.
    Scattered,
    All,
}

impl Gap {
    fn none_if(is_known: bool) -> Self {
        if is_known { Self::Nowhere } else { Self::All }
    }
}

/// Something that light has met on its way.
#[derive(Clone, Copy, Debug)]
pub struct Event {
    /// The body's index.
    pub body: usize,
    pub bounce: Bounce,
    pub is_flat: bool,
    /// Whether it came from within.
    pub is_inside: bool,
}

impl Image {
    /// How a further mirror, which is a point's first one, shows it; `None` if it is behind that.
    fn behind(&self, mirror: (usize, Face)) -> Option<Self> {
        let (body, face) = mirror;
        // No ray meets a convex body twice in a row.
        if self.mirrors.first().is_some_and(|first| first.0 == body) {
            return None;
        }
        let lamp = self.lamp.mirrored(face)?;
        let mut mirrors = vec![mirror];
        mirrors.extend_from_slice(&self.mirrors);
        Some(Self { lamp, mirrors })
    }
}

/// A point of a surface to which light is looked for.
struct Point<'a> {
    world: &'a World,
    here: Ray,
    bsdf: &'a Bsdf,
    effects: &'a Effects,
}

impl Point<'_> {
    /// The light of a lamp by way of flat mirrors, chosen by `u`.
    fn by_mirrors(&self, image: &Image, u: DVec2) -> DVec3 {
        if image.mirrors[0].1.height(self.here.o) <= 0.0 {
            return DVec3::ZERO;
        }
        let has_extent = self.effects.soft_shadows;
        let arriving = image.lamp.sample(self.here, has_extent, u);
        let light = self.bsdf.of(arriving.d) * arriving.light;
        if light == DVec3::ZERO {
            return light;
        }
        let mut ray = self.here.turned(arriving.d);
        let (mut travelled, mut share) = (0.0, 1.0);
        for &(index, face) in &image.mirrors {
            // Most rays miss it.
            let is_met = self.world.bodies[index].shape.meet(ray, f64::INFINITY);
            let is_face = is_met.is_some_and(|met| face.is_at(ray, met));
            let Some((t, passed)) = is_face
                .then(|| self.bounce(&mut ray, index, Bounce::Mirrored))
                .flatten()
            else {
                return DVec3::ZERO;
            };
            travelled += t;
            share *= passed;
        }
        // Part of a lamp's sphere may be behind the mirror.
        let left = arriving.distance - travelled;
        if left < 0.0 && !has_extent {
            return DVec3::ZERO;
        }
        share * light * self.world.passing(ray, left, false)
    }

    /// The light of a point of a lamp, chosen by `u`, by way of what is round.
    fn by_round(&self, round: &(usize, Round), bounce: Bounce, lamp: &Lamp, u: DVec2) -> DVec3 {
        let index = round.0;
        let (o, normal) = lamp.point(self.effects.soft_shadows, u);
        let Some(plan) = self.plan(o, round, bounce) else {
            return DVec3::ZERO;
        };
        let light = |at: f64| {
            let (d, spread) = plan.way(at)?;
            let (scattered, ray, travelled) = self.beyond(index, bounce, d)?;
            let to_lamp = o - ray.o;
            let distance = to_lamp.length();
            let d = to_lamp / distance;
            // Where a cylinder has ended, another part of the body may have been met.
            if ray.d.dot(d) < SAME_WAY {
                return None;
            }
            let cosine = normal.map_or(1.0, |n| -n.dot(d)).max(0.0);
            let mut weight = spread * cosine;
            if bounce == Bounce::Through && normal.is_some() {
                // The same way may be found by directions, which are better where much of the lamp is seen: the balance heuristic.
                let density = 1.0 / self.cone(index);
                weight = 1.0 / (1.0 / weight + lamp.area() * density);
            }
            let power = lamp.power(ray.o - travelled * d, self.effects.soft_shadows);
            Some(weight * scattered * power * self.world.passing(ray.turned(d), distance, false))
        };
        plan.roots().into_iter().filter_map(light).sum()
    }

    /// The light of a lamp with an extent that comes through a sphere from a direction, chosen by `u`.
    fn through_sphere(&self, round: &(usize, Round), lamp: &Lamp, u: DVec2) -> DVec3 {
        let index = round.0;
        let light = || {
            let shape = &self.world.bodies[index].shape;
            let axis = (shape.centre() - self.here.o).normalize();
            let chosen = around(axis, 1.0 - u.x * self.cone(index) / TAU, u.y);
            let (scattered, ray, travelled) = self.beyond(index, Bounce::Through, chosen)?;
            let t = lamp.meet(ray)?;
            let o = ray.at(t);
            let plan = self.plan(o, round, Bounce::Through)?;
            let (_, spread) = plan.way(plan.at(chosen))?;
            let chance = lamp.area() * lamp.cosine(o, ray.d) * spread;
            let density = 1.0 / self.cone(index) + 1.0 / chance;
            let radiance = lamp.radiance(ray.o - travelled * ray.d);
            Some(scattered * radiance * self.world.passing(ray, t, false) / density)
        };
        self.effects
            .soft_shadows
            .then(light)
            .flatten()
            .unwrap_or_default()
    }

    /// The plane of the ways by what is round to a point of a lamp; `None` if the surface faces away from a sphere.
    fn plan(&self, o: DVec3, round: &(usize, Round), bounce: Bounce) -> Option<Plan> {
        let (body, round) = (&self.world.bodies[round.0], &round.1);
        let p = self.here.o;
        let is_before = self.bsdf.n.dot(round.centre - p) > -round.radius;
        let index = (bounce == Bounce::Through).then_some(f64::from(body.material.index));
        let plan = || Plan::new(p, o, round, index);
        (is_before || round.axis.is_some()).then(plan).flatten()
    }

    /// The solid angle of a sphere.
    fn cone(&self, index: usize) -> f64 {
        TAU * self.world.bodies[index].shape.width_from(self.here.o)
    }

    /// Follows a ray in the direction `d` by way of a sphere: what is scattered back along the path of the light that comes there,
    /// the ray from there on, and how far it is.
    fn beyond(&self, index: usize, bounce: Bounce, d: DVec3) -> Option<(DVec3, Ray, f64)> {
        let mut scattered = self.bsdf.of(d);
        if scattered == DVec3::ZERO {
            return None;
        }
        let mut ray = self.here.turned(d);
        let mut travelled = 0.0;
        let surfaces = if bounce == Bounce::Through { 2 } else { 1 };
        for _ in 0..surfaces {
            let (t, share) = self.bounce(&mut ray, index, bounce)?;
            travelled += t;
            scattered *= share;
        }
        Some((scattered, ray, travelled))
    }

    /// Has a ray go on from the body that it has to meet next: how far that is, and the share of the light that goes this way.
    fn bounce(&self, ray: &mut Ray, index: usize, bounce: Bounce) -> Option<(f64, f64)> {
        let world = self.world;
        let (body, met) = world.nearest(*ray)?;
        if !std::ptr::eq(body, &world.bodies[index]) {
            return None;
        }
        let bsdf = world.surface(body, *ray, &met, self.effects.surfaces);
        let (d, share) = bsdf.bounced(bounce)?;
        *ray = ray.moved(met.t).turned(d);
        Some((met.t, share))
    }
}
