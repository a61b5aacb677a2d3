use super::geometry::{Met, Ray};
use super::light::{ToLight, cone, reach, smooth};
use super::pattern::reflectance;
use super::{Body, Object, Oracle, Traced, grooves, waves};
use eightfold_tracer::scene::{Light, Material, Softbox};
use glam::DVec3;
use std::hash::{DefaultHasher, Hash, Hasher};

#[derive(Clone, Copy, Hash, PartialEq, Eq)]
enum State {
    Dark,
    Lit,
    Highlight,
}

pub struct Hit<'a> {
    pub(super) object: Object,
    pub material: &'a Material,
    /// The ray from this point on, in the same direction.
    pub ray: Ray,
    pub t: f64,
    /// The normal towards the ray, of length 1.
    pub n: DVec3,
    pub(super) is_inside: bool,
    groove: DVec3,
    pub painted: DVec3,
}

impl Hit<'_> {
    fn cosine(&self) -> f64 {
        -self.ray.d.dot(self.n)
    }

    /// Returns the share of light from the direction `l` along the ray, and the strength of the
    /// highlight.
    pub fn reflected(&self, l: DVec3) -> (DVec3, f64) {
        let material = self.material;
        let mirrored = self.ray.d + 2.0 * self.cosine() * self.n;
        let along = grooves::cosine(mirrored, l, self.groove, material.anisotropy.into());
        let highlight = f64::from(material.ks) * along.max(0.0).powf(f64::from(material.exponent));
        let tint = DVec3::ONE.lerp(material.colour.as_dvec3(), material.metallic.into());
        let diffuse = f64::from(material.kd) * self.n.dot(l) * self.painted;
        (diffuse + highlight * tint, highlight)
    }

    pub fn bounces(&self) -> [Option<(DVec3, f32)>; 2] {
        let Self { material, n, .. } = *self;
        let (d, cosine) = (self.ray.d, self.cosine());
        let gain = material.fresnel * (1.0 - cosine).powi(5) as f32;
        let mut kr = material.kr + gain * (1.0 - material.kr);
        let kt = material.kt * (1.0 - gain);
        let mut refracted = None;
        if kt > 0.0 {
            let index = f64::from(material.index);
            let eta = if self.is_inside { index } else { 1.0 / index };
            let k = 1.0 - eta * eta * (1.0 - cosine * cosine);
            if k < 0.0 {
                kr += kt;
            } else {
                refracted = Some((eta * d + (eta * cosine - k.sqrt()) * n, kt));
            }
        }
        [Some((d + 2.0 * cosine * n, kr)), refracted]
    }
}

impl Oracle<'_> {
    pub fn surface(&self, ray: Ray) -> Option<Hit<'_>> {
        let (body, met) = self.nearest(ray, false)?;
        self.hit(ray, body, met)
    }

    fn hit(&self, ray: Ray, body: &Body, met: Met) -> Option<Hit<'_>> {
        let material = body.object.material(self.scene)?;
        let p = ray.at(met.t);
        let normal = met.normal.normalize();
        let is_inside = ray.d.dot(normal) > 0.0;
        let footprint = met.t * self.plane.pixel / ray.d.dot(normal).abs();
        let own = body.shape.own_coordinates(p);
        let groove = body.shape.groove(p, normal);
        let normal = match body.object {
            Object::Plane(0) => waves::normal(&self.scene.water, p, ray.d, footprint),
            _ => normal,
        };
        Some(Hit {
            object: body.object,
            material,
            ray: ray.moved(met.t),
            t: met.t,
            n: if is_inside { -normal } else { normal },
            is_inside,
            groove,
            painted: material.colour.as_dvec3() * reflectance(&material.pattern, own, footprint),
        })
    }

    /// `weight` and `path` are as in the library's `Rays`.
    pub(super) fn follow(&self, ray: Ray, weight: f32, path: u32, traced: &mut Traced) -> DVec3 {
        traced.rays += 1;
        let nearest = self.nearest(ray, true);
        let object = nearest.map_or(Object::Background, |(body, _)| body.object);
        let t = nearest.map_or(f64::INFINITY, |(_, met)| met.t);
        let glow = self.glow(ray, t);
        let brightest = if self.scene.film.filmic { 8.0 } else { 2.0 };
        let cut = |light: DVec3| light.min(DVec3::splat(brightest / f64::from(weight)));
        let Some(hit) = nearest.and_then(|(body, met)| self.hit(ray, body, met)) else {
            self.note(object, &[], weight, path, traced);
            let light = match object {
                Object::Light(i) => self.scene.lights[i].colour.as_dvec3(),
                _ if path > 1 => self.behind(ray.d) + self.softboxes(ray.d),
                _ => self.behind(ray.d),
            };
            return cut(light + glow);
        };
        let lights = self.scene.lights.iter().map(|light| self.lit(light, &hit, traced));
        let (states, lights): (Vec<State>, Vec<DVec3>) = lights.unzip();
        let ambient = self.ambient(&hit, weight, path) * hit.painted;
        let colour = ambient + lights.into_iter().sum::<DVec3>();
        self.note(object, &states, weight, path, traced);
        let transmittance = self.transmittance(ray, t);
        let own = self.behind(ray.d).lerp(colour, transmittance) + glow;
        let left = weight * transmittance as f32;
        let [followed, untraced] = self.secondary(&hit, left, path, traced);
        cut(own + transmittance * untraced) + transmittance * followed
    }

    /// Returns the integral of the glow around lights, in closed form.
    fn glow(&self, ray: Ray, t: f64) -> DVec3 {
        let mut glow = DVec3::ZERO;
        for light in self.scene.lights.iter() {
            let radius2 = (f64::from(light.glow) * reach(light)).powi(2);
            if radius2 > 0.0 {
                let to_light = light.position.as_dvec3() * reach(light) - ray.o;
                let nearest = to_light.dot(ray.d);
                let mut height2 = (to_light - nearest * ray.d).length_squared();
                let mut share = 0.5 * radius2;
                if light.core > 0.0 {
                    let out = nearest.clamp(0.0, t) * ray.d - to_light;
                    share *= cone(light, out.normalize());
                    height2 =
                        (out.length() - f64::from(light.core) * reach(light)).max(0.0).powi(2);
                }
                let q = height2 + radius2;
                let sine = |at: f64| (at - nearest) / (q + (at - nearest).powi(2)).sqrt();
                glow += share / q * (sine(t.min(1e20)) - sine(0.0)) * light.colour.as_dvec3();
            }
        }
        glow
    }

    pub fn behind(&self, d: DVec3) -> DVec3 {
        let rise = d.y.max(0.0);
        let scattered = self.scene.lights.first().map_or(DVec3::ZERO, |sun| {
            let share = d.dot(sun.position.as_dvec3().normalize_or_zero()).max(0.0).powi(8);
            share * f64::from(self.scene.scatter) * sun.colour.as_dvec3()
        });
        let gradient = rise * (2.0 - rise) * self.scene.sky.as_dvec3();
        self.scene.background.as_dvec3() + gradient + scattered
    }

    pub fn untraced(&self, d: DVec3, is_reflected: bool) -> DVec3 {
        let softboxes = if is_reflected { self.softboxes(d) } else { DVec3::ZERO };
        self.behind(d).max(self.scene.ambient.as_dvec3()) + softboxes
    }

    pub fn softboxes(&self, d: DVec3) -> DVec3 {
        let light = |it: &Softbox| {
            let aim = it.aim.as_dvec3().normalize();
            let right = DVec3::Y.cross(aim).normalize_or(DVec3::X);
            let toward = d.dot(aim).max(1e-3);
            let off = |side: DVec3, half: f32| f64::from(half) - d.dot(side).abs() / toward;
            let inside = off(right, it.half_width).min(off(aim.cross(right), it.half_height));
            smooth(inside / f64::from(it.softness)) * it.colour.as_dvec3()
        };
        self.scene.softboxes.iter().map(light).sum()
    }

    /// Returns the reflectances of a thin film relative to a mirror.
    pub fn film(&self, hit: &Hit<'_>) -> Option<DVec3> {
        let thickness = f64::from(hit.material.film_thickness);
        let height = match hit.object {
            Object::Sphere(i) => {
                let sphere = &self.scene.spheres[i];
                (hit.ray.o.y - f64::from(sphere.centre.y)) / f64::from(sphere.radius)
            }
            _ => 0.0,
        };
        let sine = (1.0 - hit.cosine().powi(2)) / 1.33_f64.powi(2);
        let path = 2.0 * 1.33 * thickness * (1.0 - 0.8 * height) * (1.0 - sine).sqrt();
        let reflected = |wavelength: f64| {
            let w = 4.0 * (path / wavelength - (path / wavelength).round()).abs() - 1.0;
            0.5 + w * (1.0 - 0.5 * w.abs())
        };
        (thickness > 0.0).then(|| DVec3::new(610.0, 540.0, 455.0).map(reflected))
    }

    pub fn transmittance(&self, ray: Ray, t: f64) -> f64 {
        let fall = f64::from(self.scene.haze_fall);
        let thinning = |y: f64| 1.0 + fall * y.max(0.0);
        let thinning = thinning(ray.o.y) * thinning(ray.at(t).y);
        1.0 / (1.0 + (f64::from(self.scene.haze) * t / thinning).powi(2))
    }

    fn secondary(&self, hit: &Hit<'_>, weight: f32, path: u32, traced: &mut Traced) -> [DVec3; 2] {
        let [mut followed, mut untraced] = [DVec3::ZERO; 2];
        for (bounce, node) in hit.bounces().into_iter().zip(2 * path..) {
            let Some((d, share)) = bounce else { continue };
            let weight = weight * share;
            let film = self.film(hit).filter(|_| node % 2 == 0);
            let is_traced = depth(path) < self.quality.depth && film.is_none();
            if is_traced && weight >= self.quality.least_contribution {
                followed += f64::from(share) * self.follow(hit.ray.turned(d), weight, node, traced);
            } else if !self.scene.black_beyond {
                let colour = film.unwrap_or(DVec3::ONE) * self.untraced(d, node % 2 == 0);
                untraced += f64::from(share) * colour;
            }
        }
        [followed, untraced]
    }

    fn lit(&self, light: &Light, hit: &Hit<'_>, traced: &mut Traced) -> (State, DVec3) {
        let to_light = ToLight::new(light, hit.ray.o);
        let l = to_light.l;
        let nl = hit.n.dot(l);
        if nl <= 0.0 {
            return (State::Dark, DVec3::ZERO);
        }
        traced.shadow_rays += 1;
        // Inside a sphere, its far side blocks lights outside.
        let is_beyond = match hit.object {
            Object::Sphere(i) if hit.is_inside => {
                2.0 * nl * f64::from(self.scene.spheres[i].radius) < to_light.distance
            }
            _ => false,
        };
        let share = self.reaching(light, &to_light, hit.ray.turned(l));
        if is_beyond || share == DVec3::ZERO {
            return (State::Dark, DVec3::ZERO);
        }
        let (reflected, highlight) = hit.reflected(l);
        let is_bright = highlight > f64::from(self.quality.highlight);
        let state = if is_bright { State::Highlight } else { State::Lit };
        (state, share * light.colour.as_dvec3() * reflected)
    }

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

pub(super) fn depth(path: u32) -> u32 {
    path.ilog2()
}

fn hash(node: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    node.hash(&mut hasher);
    hasher.finish()
}
