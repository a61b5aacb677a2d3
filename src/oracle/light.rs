use super::geometry::Ray;
use super::{Object, Oracle};
use eightfold_tracer::scene::{Block, Light, Shape, Sphere};
use glam::DVec3;

/// Returns the factor on a light's lengths: parallel lights are far away.
pub fn reach(light: &Light) -> f64 {
    if light.parallel { f64::from(Light::FAR) } else { 1.0 }
}

pub fn cone(light: &Light, d: DVec3) -> f64 {
    light.spot.map_or(1.0, |spot| {
        let [outer, inner] =
            [spot.outer_angle, spot.inner_angle].map(|angle| f64::from(angle).cos());
        smooth((d.dot(spot.aim.as_dvec3().normalize()) - outer) / (inner - outer))
    })
}

pub(super) struct ToLight {
    pub l: DVec3,
    pub distance: f64,
}

impl ToLight {
    pub fn new(light: &Light, p: DVec3) -> Self {
        let to_light = reach(light) * light.position.as_dvec3() - p;
        let distance = to_light.length();
        Self { l: to_light / distance, distance }
    }
}

impl Oracle<'_> {
    /// Returns the share of the light, as a colour, that passes the cone and all shadows.
    pub(super) fn reaching(&self, light: &Light, to_light: &ToLight, ray: Ray) -> DVec3 {
        let ToLight { l, distance } = *to_light;
        let bodies = self.bodies.iter();
        let occluders = bodies.filter(|body| body.shape.meet(ray, distance).is_some());
        let mut share = DVec3::splat(cone(light, -l));
        for object in occluders.map(|body| body.object) {
            match object {
                Object::Block(i) if light.diameter > 0.0 => {
                    let block = &self.scene.blocks[i];
                    if contains(block, ray.o + distance * l) {
                        share *= block.material.tint.as_dvec3();
                    }
                }
                Object::Sphere(_) if light.diameter > 0.0 => {}
                Object::Light(_) => {}
                _ => return DVec3::ZERO,
            }
        }
        if light.diameter == 0.0 {
            return share;
        }
        let (spheres, blocks) = (self.scene.spheres.iter(), self.scene.blocks.iter());
        let passing = spheres.map(|s| (penumbra(s, ray.o, to_light, light), s.material.tint));
        let blocks = blocks.filter(|block| !contains(block, ray.o + distance * l));
        let around = blocks.map(|b| (block_penumbra(b, ray.o, to_light, light), b.material.tint));
        for (passing, tint) in passing.chain(around) {
            let tint = tint.as_dvec3();
            share *= tint + passing * (DVec3::ONE - tint);
        }
        share
    }
}

/// Returns the share of an area light that a sphere does not block, by the library's
/// `sphere_covers`. A sphere around `p` and the whole light blocks nothing: domes are lit from
/// within.
fn penumbra(sphere: &Sphere, p: DVec3, to_light: &ToLight, light: &Light) -> f64 {
    let centre = sphere.centre.as_dvec3();
    let radius = f64::from(sphere.radius);
    // A point within the rounding error counts as on the surface.
    let error = 2e-6 * (centre.abs().max_element() + radius);
    let to_centre = centre - p;
    let a = to_centre.dot(to_light.l).clamp(0.0, to_light.distance);
    let off = (to_centre - a * to_light.l).length() + error - radius;
    let size = reach(light) * f64::from(light.diameter);
    let centre_to_light = to_centre - to_light.distance * to_light.l;
    let is_dome =
        to_centre.length() <= radius + error && centre_to_light.length() + 0.5 * size <= radius;
    if is_dome {
        return 1.0;
    }
    soft_edge(off, a, to_light, light)
}

/// Returns the share of an area light that passes an occluder at a distance `a` and `off` its side.
fn soft_edge(off: f64, a: f64, to_light: &ToLight, light: &Light) -> f64 {
    let width = f64::from(light.diameter);
    let size = reach(light) * width;
    let max = if light.parallel { 4.0 * width } else { width };
    let b = (a * size / to_light.distance).min(max);
    if b == 0.0 {
        return f64::from(u8::from(off > 0.0));
    }
    smooth(off / b + 0.5)
}

fn contains(block: &Block, p: DVec3) -> bool {
    let own = block.axes.as_dmat3().transpose() * (p - block.centre.as_dvec3());
    own.abs().cmple(block.half.as_dvec3()).all()
}

/// Returns the share of an area light that a block does not block, by the library's `approach`.
fn block_penumbra(block: &Block, p: DVec3, to_light: &ToLight, light: &Light) -> f64 {
    let axes = block.axes.as_dmat3().transpose();
    let (o, d) = (axes * (p - block.centre.as_dvec3()), axes * to_light.l);
    let half = block.half.as_dvec3();
    let error = 2e-6 * (block.centre.as_dvec3().abs().max_element() + half.max_element());
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut enter = |o: f64, d: f64, half: f64| {
        let (middle, half) = (-o / (d + 1e-12), (half / (d + 1e-12)).abs());
        (near, far) = (near.max(middle - half), far.min(middle + half));
    };
    enter(o.y, d.y, half.y);
    if block.shape == Shape::Box {
        enter(o.x, d.x, half.x);
        enter(o.z, d.z, half.z);
    } else {
        let (o, d) = (o.with_y(0.0), d.with_y(0.0) + 1e-12);
        let middle = -o.dot(d) / d.length_squared();
        let chord2 = half.x * half.x - (o + middle * d).length_squared();
        let chord = (chord2.max(0.0) / d.length_squared()).sqrt();
        (near, far) = (near.max(middle - chord), far.min(middle + chord));
    }
    let middle = (0.5 * (near + far)).clamp(0.0, to_light.distance);
    let (out, _) = outside(block, half, o + middle * d);
    let a = (middle - d.dot(out)).clamp(0.0, to_light.distance);
    let (_, off) = outside(block, half, o + a * d);
    soft_edge(off + error, a, to_light, light)
}

/// Returns the vector along a block's axes from its nearest point to `p`, and its signed length.
pub(super) fn outside(block: &Block, half: DVec3, p: DVec3) -> (DVec3, f64) {
    let (nearest, depth) = match block.shape {
        Shape::Box => (p.clamp(-half, half), (p.abs() - half).max_element()),
        Shape::Cylinder => {
            let across = p.with_y(0.0);
            let nearest = across.clamp_length_max(half.x).with_y(p.y.clamp(-half.y, half.y));
            (nearest, (across.length() - half.x).max(p.y.abs() - half.y))
        }
        _ => {
            let from_core = p - DVec3::Y * p.y.clamp(half.x - half.y, half.y - half.x);
            let off = from_core.length() - half.x;
            return (from_core.normalize_or_zero() * off.max(0.0), off);
        }
    };
    let out = p - nearest;
    (out, out.length() + depth.min(0.0))
}

pub(super) fn smooth(tau: f64) -> f64 {
    let tau = tau.clamp(0.0, 1.0);
    tau * tau * (3.0 - 2.0 * tau)
}
