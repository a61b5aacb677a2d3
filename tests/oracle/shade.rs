//! Shading by Phong's model, and secondary rays.

use super::geometry::Ray;
use super::grooves;
use super::light::ToLight;
use super::pattern::reflectance;
use super::waves;
use super::{Object, Oracle, Traced};
use eightfold_tracer::scene::{Light, Material};
use glam::DVec3;
use std::hash::{DefaultHasher, Hash, Hasher};

/// The state of a light at a hit: shadowed or behind the surface, lit, or lit with a highlight.
#[derive(Clone, Copy, Hash, PartialEq, Eq)]
enum State {
    Dark,
    Lit,
    Highlight,
}

impl Oracle<'_> {
    /// The colour that a ray sees. `weight` is the product of the coefficients along its path. `path` identifies its node in the
    /// ray tree: 1 for a primary ray, 2 p for the reflected and 2 p + 1 for the transmitted ray of the node p.
    pub(super) fn follow(&self, ray: Ray, weight: f32, path: u32, traced: &mut Traced) -> DVec3 {
        traced.rays += 1;
        let nearest = self.nearest(ray);
        let object = nearest.map_or(Object::Background, |(body, _)| body.object);
        let t = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
        let glow = self.glow(ray, t);
        // What a single ray brings to the eye, without those that follow it.
        let cut = |light: DVec3| light.min(DVec3::splat(2.0 / f64::from(weight)));
        let Some(((body, met), material)) = nearest.zip(object.material(self.scene)) else {
            self.note(object, &[], weight, path, traced);
            let light = match object {
                Object::Light(i) => self.scene.lights[i].colour.as_dvec3(),
                _ => self.behind(ray.d),
            };
            return cut(light + glow);
        };
        let p = ray.at(t);
        let normal = met.normal.normalize();
        let own = body.shape.own_coordinates(p);
        let inside = ray.d.dot(normal) > 0.0;
        let footprint = t * self.plane.pixel / ray.d.dot(normal).abs();
        let groove = body.shape.groove(p, normal);
        let normal = match object {
            Object::Plane(0) => waves::normal(&self.scene.water, p, ray.d, footprint),
            _ => normal,
        };
        let n = if inside { -normal } else { normal };
        let painted = material.colour.as_dvec3() * reflectance(&material.pattern, own, footprint);
        // The transmittance of the haze.
        let transmittance = 1.0 / (1.0 + (f64::from(self.scene.haze) * t).powi(2));

        let mut colour = self.scene.ambient.as_dvec3() * painted;
        let within = match object {
            Object::Sphere(i) if inside => Some(f64::from(self.scene.spheres[i].radius)),
            _ => None,
        };
        let mut states = Vec::new();
        for i in 0..self.scene.lights.len() {
            let (state, light) = self.lit(i, ray, t, n, groove, within, material, painted, traced);
            colour += light;
            states.push(state);
        }
        self.note(object, &states, weight, path, traced);
        let own = cut(self.behind(ray.d).lerp(colour, transmittance) + glow);
        let secondary = self.secondary(
            ray,
            t,
            n,
            inside,
            material,
            weight * transmittance as f32,
            path,
            traced,
        );
        own + transmittance * secondary
    }

    /// The light of the air around lamps up to a distance: the sum over short steps would be the same.
    fn glow(&self, ray: Ray, t: f64) -> DVec3 {
        let mut light = DVec3::ZERO;
        for lamp in self.scene.lights.iter() {
            let far = if lamp.parallel {
                f64::from(Light::FAR)
            } else {
                1.0
            };
            let radius2 = (f64::from(lamp.glow) * far).powi(2);
            if radius2 > 0.0 {
                let to_lamp = lamp.position.as_dvec3() * far - ray.o;
                let nearest = to_lamp.dot(ray.d);
                let q = (to_lamp - nearest * ray.d).length_squared() + radius2;
                let sine = |at: f64| (at - nearest) / (q + (at - nearest).powi(2)).sqrt();
                let share = 0.5 * radius2 / q * (sine(t.min(1e20)) - sine(0.0));
                light += share * lamp.colour.as_dvec3();
            }
        }
        light
    }

    /// The background in a direction.
    fn behind(&self, d: DVec3) -> DVec3 {
        let rise = d.y.max(0.0);
        self.scene.background.as_dvec3() + rise * (2.0 - rise) * self.scene.sky.as_dvec3()
    }

    /// The light of the transmitted and the reflected ray.
    #[allow(clippy::too_many_arguments, reason = "a hit and its ray")]
    fn secondary(
        &self,
        ray: Ray,
        t: f64,
        n: DVec3,
        inside: bool,
        material: &Material,
        weight: f32,
        path: u32,
        traced: &mut Traced,
    ) -> DVec3 {
        let mut colour = DVec3::ZERO;
        if depth(path) == self.quality.depth {
            return colour;
        }
        let cosine = -ray.d.dot(n);
        let gain = material.fresnel * (1.0 - cosine).powi(5) as f32;
        let mut kr = material.kr + gain * (1.0 - material.kr);
        let kt = material.kt * (1.0 - gain);
        if kt > 0.0 {
            let index = f64::from(material.index);
            let eta = if inside { index } else { 1.0 / index };
            let k = 1.0 - eta * eta * (1.0 - cosine * cosine);
            let weight = weight * kt;
            if k < 0.0 {
                kr += kt;
            } else if weight >= self.quality.least_contribution {
                let d = eta * ray.d + (eta * cosine - k.sqrt()) * n;
                let seen = self.follow(ray.moved(t).turned(d), weight, 2 * path + 1, traced);
                colour += f64::from(kt) * seen;
            }
        }
        let weight = weight * kr;
        if weight >= self.quality.least_contribution {
            let d = ray.d + 2.0 * cosine * n;
            let seen = self.follow(ray.moved(t).turned(d), weight, 2 * path, traced);
            colour += f64::from(kr) * seen;
        }
        colour
    }

    /// The state of a light where a ray hits something at the distance `t`, with normal `n` and grooves along `groove`, and the light
    /// that it adds. `within` is the radius if the hit is on the inside of a sphere; `painted` is the colour with its pattern.
    #[allow(clippy::too_many_arguments, reason = "a light and a hit")]
    fn lit(
        &self,
        light: usize,
        ray: Ray,
        t: f64,
        n: DVec3,
        groove: DVec3,
        within: Option<f64>,
        material: &Material,
        painted: DVec3,
        traced: &mut Traced,
    ) -> (State, DVec3) {
        let light = &self.scene.lights[light];
        let to_light = ToLight::new(light, ray.at(t));
        let l = to_light.l;
        let nl = n.dot(l);
        if nl <= 0.0 {
            return (State::Dark, DVec3::ZERO);
        }
        traced.shadow_rays += 1;
        // Inside a sphere, lights beyond its far side are blocked by the sphere itself.
        let is_beyond = within.is_some_and(|radius| 2.0 * nl * radius < to_light.distance);
        let share = self.reaching(light, &to_light, ray.moved(t).turned(l));
        if is_beyond || share == DVec3::ZERO {
            return (State::Dark, DVec3::ZERO);
        }
        let r = ray.d - 2.0 * ray.d.dot(n) * n;
        let rv = grooves::cosine(r, l, groove, material.anisotropy.into()).max(0.0);
        let specular = f64::from(material.ks) * rv.powf(f64::from(material.exponent));
        let highlight = DVec3::ONE.lerp(material.colour.as_dvec3(), material.metallic.into());
        let diffuse = f64::from(material.kd) * nl * painted;
        let state = if specular > f64::from(self.quality.highlight) {
            State::Highlight
        } else {
            State::Lit
        };
        (
            state,
            share * light.colour.as_dvec3() * (diffuse + specular * highlight),
        )
    }

    /// Adds a node of the ray tree to the hashes.
    fn note(&self, object: Object, states: &[State], weight: f32, path: u32, traced: &mut Traced) {
        let lit: Vec<bool> = states.iter().map(|&s| s != State::Dark).collect();
        traced.tree ^= hash(&(path, object, lit));
        if weight < self.quality.key_weight {
            return;
        }
        if depth(path) <= self.quality.key_depth {
            traced.key ^= hash(&("object", path, object));
        }
        if depth(path) <= self.quality.state_depth.min(self.quality.key_depth) {
            traced.key ^= hash(&("states", path, states));
        }
    }
}

/// The depth of a node of the ray tree.
fn depth(path: u32) -> u32 {
    path.ilog2()
}

fn hash(node: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    node.hash(&mut hasher);
    hasher.finish()
}
