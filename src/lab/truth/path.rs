//! Paths of light, followed from the eye: an unbiased estimate of the rendering equation (Kajiya, 1986).
//!
//! At each point of a path the light of every lamp is looked for, and the path goes on in one random direction. Both find
//! lamps with an extent: multiple importance sampling weighs one by the other (Veach and Guibas, 1995). What lamps send by way of
//! mirrors and glass is found in closed form (`connect`), or by `photons` where there is none.

use super::connect::Connections;
use super::effects::Effects;
use super::lamp::Lamp;
use super::photons::{Blurred, Photons};
use super::surface::Bsdf;
use super::world::World;
use crate::sampler::Sampler;
use eightfold_oracle::geometry::Ray;
use eightfold_tracer::glam::DVec3;

/// The number of bounces from which on paths may end at random.
const FIRST_ROULETTE: u32 = 4;
/// The largest chance to go on: paths between perfect mirrors end, too.
const MAX_SURVIVAL: f64 = 0.95;

/// Follows paths through a world.
#[derive(Clone, Copy)]
pub struct PathTracer<'a> {
    pub world: &'a World,
    /// Its ways of light that are known in closed form.
    pub connections: &'a Connections,
    pub effects: Effects,
    /// The light of caustics, for this sample.
    pub photons: &'a Photons,
}

/// A path that is being followed.
struct Path {
    /// Its next part.
    ray: Ray,
    /// The share of the light along the ray that reaches the eye.
    throughput: DVec3,
    /// How often it was scattered by rough surfaces.
    scatters: u32,
    /// The density with which a rough surface has chosen its direction; `None` at the eye, and behind mirrors and glass.
    density: Option<f64>,
    /// The light that it has found.
    found: Blurred,
}

impl PathTracer<'_> {
    /// The radiance that one path finds through a point of the picture, in pixels.
    pub fn follow(&self, x: f64, y: f64, sampler: &mut Sampler) -> Blurred {
        let mut path = Path {
            ray: self.world.primary_ray(x, y),
            throughput: DVec3::splat(self.world.brightness),
            scatters: 0,
            density: None,
            found: Blurred::default(),
        };
        let mut bounces = 0;
        while self.advance(&mut path, sampler) {
            bounces += 1;
            if bounces >= FIRST_ROULETTE {
                let survival = path.throughput.max_element().min(MAX_SURVIVAL);
                if sampler.next_1d() >= survival {
                    break;
                }
                path.throughput /= survival;
            }
        }
        path.found
    }

    /// Follows a path to the next body. Returns whether it goes on.
    fn advance(&self, path: &mut Path, sampler: &mut Sampler) -> bool {
        let world = self.world;
        let nearest = world.nearest(path.ray);
        let t = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
        if path.scatters > 0 {
            self.meet_lamps(path, t);
        } else if let Some(seen) = self.seen_lamp(path.ray, t) {
            path.found.light += path.throughput * seen;
            return false;
        }
        // A path that was scattered and goes on only for the lamp that it may meet finds no other light.
        let is_lit = path.scatters == 0 || self.effects.indirect;
        let behind = if is_lit {
            path.throughput * world.behind(path.ray.d)
        } else {
            DVec3::ZERO
        };
        let Some((body, met)) = nearest else {
            path.found.light += behind;
            return false;
        };
        let clear = world.transmittance(t);
        path.found.light += (1.0 - clear) * behind;
        path.throughput *= clear;

        let bsdf = world.surface(body, path.ray, &met, self.effects.surfaces);
        if !self.effects.indirect && is_lit {
            path.found.light += path.throughput * world.ambient * world.paint(body, path.ray, &met);
        }
        path.ray = path.ray.moved(t);
        if is_lit && bsdf.is_rough() {
            let caustics = self.caustics(path.ray, &bsdf, path.scatters > 0, sampler);
            let direct = self.direct(path.ray, &bsdf, sampler);
            path.found.light += path.throughput * (direct + caustics.light);
            path.found.blur += path.throughput * caustics.blur;
        }
        self.scatter(path, &bsdf, sampler)
    }

    /// The light of all lamps that a surface, at which `here` starts, sends back along the path by way of mirrors and glass;
    /// `is_scattered` is whether the path has been scattered before.
    fn caustics(
        &self,
        here: Ray,
        bsdf: &Bsdf,
        is_scattered: bool,
        sampler: &mut Sampler,
    ) -> Blurred {
        if !self.effects.caustics {
            return Blurred::default();
        }
        let world = self.world;
        let ways = self.connections;
        let known = ways.light(world, here, bsdf, &self.effects, is_scattered, sampler);
        let blurred = self.photons.reflected(world, here.o, bsdf, is_scattered);
        Blurred {
            light: known + blurred.light,
            ..blurred
        }
    }

    /// Has a path go on from a point of a surface. Returns whether it does.
    fn scatter(&self, path: &mut Path, bsdf: &Bsdf, sampler: &mut Sampler) -> bool {
        let Some(next) = bsdf.sample(sampler.next_1d(), sampler.next_2d()) else {
            return false;
        };
        path.ray = path.ray.turned(next.d);
        path.throughput *= next.weight;
        path.density = next.density;
        let is_scattered = next.density.is_some();
        path.scatters += u32::from(is_scattered);
        path.scatters == 0
            || self.effects.indirect
            || is_scattered && path.scatters == 1 && self.effects.soft_shadows
    }

    /// The light of all lamps that a surface, at which `here` starts, sends back along the path.
    fn direct(&self, here: Ray, bsdf: &Bsdf, sampler: &mut Sampler) -> DVec3 {
        let mut sum = DVec3::ZERO;
        for lamp in &self.world.lamps {
            let u = sampler.next_2d();
            let arriving = lamp.sample(here, self.effects.soft_shadows, u);
            let light = bsdf.of(arriving.d) * arriving.light;
            if light == DVec3::ZERO {
                continue;
            }
            let passing = self.passing(lamp, here.turned(arriving.d), arriving.distance);
            let weight = arriving
                .density
                .map_or(1.0, |density| power(density, bsdf.density(arriving.d)));
            sum += weight * passing * light;
        }
        sum
    }

    /// Adds the light of the lamps that a path meets up to the distance `t`, right after it was scattered. Lamps cast no shadows:
    /// it passes them.
    fn meet_lamps(&self, path: &mut Path, t: f64) {
        let Some(density) = path.density.filter(|_| self.effects.soft_shadows) else {
            return;
        };
        for lamp in &self.world.lamps {
            let Some(met) = lamp.meet(path.ray) else {
                continue;
            };
            let passing = if met < t {
                DVec3::ONE
            } else {
                self.passing(lamp, path.ray, met)
            };
            let weight = power(density, lamp.density(path.ray.o));
            let radiance = lamp.radiance(path.ray.o);
            path.found.light += weight * path.throughput * passing * radiance;
        }
    }

    /// The share of a lamp's light that bodies let pass over a distance along a ray.
    fn passing(&self, lamp: &Lamp, ray: Ray, distance: f64) -> DVec3 {
        let is_tinted = lamp.is_tinted && !self.effects.caustics;
        self.world.passing(ray, distance, is_tinted)
    }

    /// The radiance of the lamp that is seen along a ray up to the distance `t`.
    fn seen_lamp(&self, ray: Ray, t: f64) -> Option<DVec3> {
        let seen = self
            .world
            .lamps
            .iter()
            .filter_map(|lamp: &Lamp| lamp.seen(ray));
        let nearest = seen.min_by(|a, b| a.0.total_cmp(&b.0));
        nearest.filter(|&(at, _)| at < t).map(|(_, colour)| colour)
    }
}

/// The weight of a direction that was chosen with one density and could have been chosen with another: Veach's power heuristic.
fn power(density: f64, other: f64) -> f64 {
    let (density2, other2) = (density * density, other * other);
    density2 / (density2 + other2)
}
