//! Light at a hit by Phong's model, and the rays that leave it.

use super::{Object, Oracle, Ray, Traced};
use eightfold::scene::Material;
use glam::DVec3;
use std::hash::{DefaultHasher, Hash, Hasher};

/// A light at a hit: shadowed or facing away, lit, lit with a highlight.
#[derive(Clone, Copy, Hash, PartialEq, Eq)]
enum State {
    Dark,
    Lit,
    Highlight,
}

impl Oracle<'_> {
    /// The colour along a ray. `weight` is the product of the coefficients on its way, `path` its place in the tree:
    /// 1 for a primary ray, 2 p for the reflected and 2 p + 1 for the transmitted ray of path p.
    pub(super) fn follow(&self, ray: Ray, weight: f32, path: u32, traced: &mut Traced) -> DVec3 {
        traced.rays += 1;
        let (object, t) = self.nearest(ray);
        let (material, normal): (&Material, _) = match object {
            Object::Nothing => return self.emitted(self.scene.background, object, path, traced),
            Object::Light(i) => {
                return self.emitted(self.scene.lights[i].colour, object, path, traced);
            }
            Object::Sphere(i) => {
                let sphere = &self.scene.spheres[i];
                let out = ray.o + t * ray.d - sphere.centre.as_dvec3();
                (&sphere.material, out / f64::from(sphere.radius))
            }
            Object::Plane(i) => (&self.scene.planes[i].material, DVec3::Y),
        };
        let p = ray.o + t * ray.d;
        let inside = ray.d.dot(normal) > 0.0;
        let n = if inside { -normal } else { normal };

        let mut colour = self.scene.ambient.as_dvec3() * material.colour.as_dvec3();
        let mut states = Vec::new();
        for i in 0..self.scene.lights.len() {
            let (state, light) = self.lit(i, ray, p, n, material, traced);
            colour += light;
            states.push(state);
        }
        self.note(object, &states, path, traced);

        if depth(path) == self.quality.depth {
            return colour;
        }
        let cosine = -ray.d.dot(n);
        let mut kr = material.kr;
        if material.kt > 0.0 {
            let index = f64::from(material.index);
            let eta = if inside { index } else { 1.0 / index };
            let k = 1.0 - eta * eta * (1.0 - cosine * cosine);
            let weight = weight * material.kt;
            if k < 0.0 {
                kr += material.kt;
            } else if weight >= self.quality.least_contribution {
                let d = eta * ray.d + (eta * cosine - k.sqrt()) * n;
                let seen = self.follow(Ray { o: p, d }, weight, 2 * path + 1, traced);
                colour += f64::from(material.kt) * seen;
            }
        }
        let weight = weight * kr;
        if weight >= self.quality.least_contribution {
            let d = ray.d + 2.0 * cosine * n;
            let seen = self.follow(Ray { o: p, d }, weight, 2 * path, traced);
            colour += f64::from(kr) * seen;
        }
        colour
    }

    /// What a light adds to a hit at `p` with normal `n`.
    fn lit(
        &self,
        light: usize,
        ray: Ray,
        p: DVec3,
        n: DVec3,
        material: &Material,
        traced: &mut Traced,
    ) -> (State, DVec3) {
        let light = &self.scene.lights[light];
        let to_light = light.position.as_dvec3() - p;
        let distance = to_light.length();
        let l = to_light / distance;
        let nl = n.dot(l);
        if nl <= 0.0 {
            return (State::Dark, DVec3::ZERO);
        }
        traced.shadow_rays += 1;
        if self.blocked(Ray { o: p, d: l }, distance) {
            return (State::Dark, DVec3::ZERO);
        }
        let rv = (2.0 * nl * n - l).dot(-ray.d).max(0.0);
        let specular = f64::from(material.ks) * rv.powf(f64::from(material.exponent));
        let diffuse = f64::from(material.kd) * nl * material.colour.as_dvec3();
        let state = if specular > f64::from(self.quality.highlight) {
            State::Highlight
        } else {
            State::Lit
        };
        (state, light.colour.as_dvec3() * (diffuse + specular))
    }

    /// A hit that ends its ray.
    fn emitted(&self, colour: glam::Vec3, object: Object, path: u32, traced: &mut Traced) -> DVec3 {
        self.note(object, &[], path, traced);
        colour.as_dvec3()
    }

    /// Adds a node of the ray tree to what stands for it.
    fn note(&self, object: Object, states: &[State], path: u32, traced: &mut Traced) {
        let lit: Vec<bool> = states.iter().map(|&s| s != State::Dark).collect();
        traced.tree ^= hash(&(path, object, lit));
        if depth(path) <= self.quality.key_depth {
            traced.key ^= hash(&("object", path, object));
        }
        if depth(path) <= self.quality.state_depth.min(self.quality.key_depth) {
            traced.key ^= hash(&("states", path, states));
        }
    }
}

/// The secondary rays on the way to a place in the tree.
fn depth(path: u32) -> u32 {
    path.ilog2()
}

fn hash(node: &impl Hash) -> u64 {
    let mut hasher = DefaultHasher::new();
    node.hash(&mut hasher);
    hasher.finish()
}
