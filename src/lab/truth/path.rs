//! A path tracer (Kajiya, 1986), unbiased except for missing caustics of point lights. Every hit
//! samples all lights; only camera and specular rays add the lights that they hit.

use super::light::{SphereLight, around};
use eightfold_harness::Size;
use eightfold_oracle::geometry::Ray;
use eightfold_oracle::{Hit, Oracle};
use eightfold_tracer::Quality;
use eightfold_tracer::glam::{DVec2, DVec3, dvec2};
use eightfold_tracer::scene::Scene;
use fastrand::Rng;
use std::f64::consts::{PI, TAU};

/// Bounces without Russian roulette.
const SURE_BOUNCES: u32 = 4;
/// Below 1, so that paths between perfect mirrors end.
const MAX_SURVIVAL: f64 = 0.95;

pub struct PathTracer<'a> {
    oracle: Oracle<'a>,
    lights: Vec<SphereLight<'a>>,
    exposure: f64,
}

impl<'a> PathTracer<'a> {
    pub fn new(scene: &'a Scene, size: Size) -> Self {
        Self {
            // The quality has no effect.
            oracle: Oracle::new(scene, &Quality::EXHAUSTIVE, size.width, size.height),
            lights: scene.lights.iter().map(SphereLight::new).collect(),
            exposure: scene.exposure.into(),
        }
    }

    pub fn follow(&self, x: f64, y: f64, random: &mut Rng) -> DVec3 {
        let mut ray = self.oracle.ray(x, y);
        let mut found = DVec3::ZERO;
        let mut throughput = DVec3::splat(self.exposure);
        // The path's length since the last diffuse or glossy bounce, if any.
        let mut length: Option<f64> = None;
        let mut bounces = 0;
        loop {
            let hit = self.oracle.surface(ray);
            let t = hit.as_ref().map_or(f64::INFINITY, |hit| hit.t);
            match length {
                None => {
                    if let Some(colour) = self.hit_light(ray, t) {
                        return found + throughput * colour;
                    }
                }
                Some(length) if length > 0.0 => {
                    let light = self.lights.iter().map(|it| it.radiance(ray, length, t));
                    found += throughput * light.sum::<DVec3>();
                }
                // The last hit sampled the lights.
                Some(_) => {}
            }
            let behind = throughput * self.oracle.behind(ray.d);
            let Some(hit) = hit else {
                if bounces > 0 && length.is_none() {
                    found += throughput * self.oracle.softboxes(ray.d);
                }
                return found + behind;
            };
            let clear = self.oracle.transmittance(ray, t);
            found += (1.0 - clear) * behind;
            throughput *= clear;

            let surface = Surface::new(&hit);
            if let (Some(film), [Some((d, share)), _]) = (self.oracle.film(&hit), hit.bounces()) {
                found += throughput * f64::from(share) * film * self.oracle.untraced(d, true);
            }
            found += throughput * self.direct(&surface, random);
            let Some(next) = surface.bounce(random) else { return found };
            ray = hit.ray.turned(next.d);
            throughput *= next.weight;
            length = if next.is_rough { Some(0.0) } else { length.map(|length| length + t) };
            bounces += 1;
            if bounces > SURE_BOUNCES {
                let survival = throughput.max_element().min(MAX_SURVIVAL);
                if random.f64() >= survival {
                    return found;
                }
                throughput /= survival;
            }
        }
    }

    fn hit_light(&self, ray: Ray, limit: f64) -> Option<DVec3> {
        let hits = self.lights.iter().filter_map(|light| light.hit(ray));
        let nearest = hits.min_by(|a, b| a.0.total_cmp(&b.0))?;
        (nearest.0 < limit).then_some(nearest.1)
    }

    fn direct(&self, surface: &Surface<'_>, random: &mut Rng) -> DVec3 {
        let here = surface.hit.ray;
        let mut sum = DVec3::ZERO;
        for light in &self.lights {
            let arriving = light.sample(here, dvec2(random.f64(), random.f64()));
            let light = surface.reflected(arriving.d) * arriving.irradiance;
            let is_free = || self.oracle.is_free(here.turned(arriving.d), arriving.distance);
            if light != DVec3::ZERO && is_free() {
                sum += light;
            }
        }
        sum
    }
}

/// A surface as the real-time tracer shades it, scaled to add no energy.
struct Surface<'a> {
    hit: &'a Hit<'a>,
    albedo: f64,
    scale: f64,
    /// Diffuse, glossy, mirrored and refracted.
    probabilities: [f64; 4],
}

struct Next {
    d: DVec3,
    weight: DVec3,
    /// Diffuse or glossy.
    is_rough: bool,
}

impl<'a> Surface<'a> {
    fn new(hit: &'a Hit<'a>) -> Self {
        let material = hit.material;
        let [kd, ks, exponent] = [material.kd, material.ks, material.exponent].map(f64::from);
        let [mut mirrored, refracted] =
            hit.bounces().map(|it| it.map_or(0.0, |(_, share)| share.into()));
        if material.film_thickness > 0.0 {
            mirrored = 0.0;
        }
        let diffuse = kd * hit.painted.max_element();
        // Anisotropic lobes are wide: sample them like diffuse ones.
        let shares = if material.anisotropy > 0.0 {
            let band = ks * (TAU / (exponent + 0.75)).sqrt();
            [diffuse + band, 0.0, mirrored, refracted]
        } else {
            [diffuse, 2.0 * ks / (exponent + 1.0), mirrored, refracted]
        };
        let sum: f64 = shares.iter().sum();
        Self {
            hit,
            albedo: sum.min(1.0),
            scale: 1.0 / sum.max(1.0),
            probabilities: shares.map(|share| share / sum),
        }
    }

    /// Returns the BRDF times the cosine for light from `d`.
    fn reflected(&self, d: DVec3) -> DVec3 {
        if self.hit.n.dot(d) <= 0.0 {
            return DVec3::ZERO;
        }
        self.scale / PI * self.hit.reflected(d).0
    }

    /// Returns the next segment; `None` if the path ends.
    fn bounce(&self, random: &mut Rng) -> Option<Next> {
        let (choice, u) = (random.f64(), dvec2(random.f64(), random.f64()));
        if self.albedo == 0.0 {
            return None;
        }
        let [diffuse, glossy, mirrored, _] = self.probabilities;
        let [mirror, glass] = self.hit.bounces();
        let (mirror, _) = mirror?;
        let exponent = f64::from(self.hit.material.exponent);
        if choice >= diffuse + glossy {
            let is_mirrored = choice < diffuse + glossy + mirrored;
            return Some(Next {
                d: glass.filter(|_| !is_mirrored).map_or(mirror, |(d, _)| d),
                weight: DVec3::splat(self.albedo),
                is_rough: false,
            });
        }
        let d = if choice < diffuse {
            cosine_hemisphere(self.hit.n, u)
        } else {
            around(mirror, u.x.powf(1.0 / (exponent + 1.0)), u.y)
        };
        let lobe = mirror.dot(d).max(0.0).powf(exponent);
        let density =
            diffuse * self.hit.n.dot(d).max(0.0) / PI + glossy * (exponent + 1.0) * lobe / TAU;
        let reflected = self.reflected(d);
        (reflected != DVec3::ZERO && density > 0.0).then(|| Next {
            d,
            weight: reflected / density,
            is_rough: true,
        })
    }
}

/// The density is cosine / pi.
fn cosine_hemisphere(axis: DVec3, u: DVec2) -> DVec3 {
    (axis + around(axis, 1.0 - 2.0 * u.x, u.y)).normalize_or(axis)
}
