//! Ambient light, by the formulas of the library's `trace::ambient`.

use super::Oracle;
use super::light::{cone, outside, reach};
use super::shade::{Hit, depth};
use eightfold_tracer::scene::{Ambience, Block, Material, Shape, Sphere};
use glam::DVec3;

/// The share of the hemisphere that a solid covers, and the direction from it, in world
/// coordinates.
struct Cover {
    share: f64,
    from: DVec3,
}

impl Oracle<'_> {
    pub(super) fn ambient(&self, hit: &Hit<'_>, weight: f32, path: u32) -> DVec3 {
        let (scene, ambience) = (self.scene, &self.scene.ambience);
        let sky = scene.ambient.as_dvec3();
        if ambience.occlusion == 0.0 {
            return sky;
        }
        let up = 0.5 + 0.5 * hit.n.y;
        let floor = scene.planes.first().map_or(f64::from(f32::MIN), |plane| plane.centre.y.into());
        let height = (hit.ray.o.y - floor).max(0.0);
        let below = (1.0 - up) * height / (height + 0.2 * f64::from(ambience.reach));
        let light = sky * up + ambience.ground.as_dvec3() * below;
        if hit.is_inside || weight <= Ambience::FAINT || depth(path) > 1 {
            return light;
        }
        let (mut open, mut bounced) = (1.0, DVec3::ZERO);
        let spheres =
            scene.spheres.iter().map(|s| (by_sphere(s, hit, ambience), s.centre, &s.material));
        let blocks =
            scene.blocks.iter().map(|b| (by_block(b, hit, ambience), b.centre, &b.material));
        for (cover, centre, material) in spheres.chain(blocks) {
            let opacity = f64::from((1.0 - material.kt).max(0.0) * ambience.occlusion);
            let share = (cover.share * opacity).min(1.0);
            bounced += share * open * self.reflected(&cover, centre.as_dvec3(), material);
            open *= 1.0 - share;
        }
        light * open + bounced
    }

    fn reflected(&self, cover: &Cover, centre: DVec3, material: &Material) -> DVec3 {
        let mut light = 0.6 * self.scene.ambient.as_dvec3();
        for it in self.scene.lights.iter() {
            let l = (it.position.as_dvec3() * reach(it) - centre).normalize();
            light += cover.from.dot(l).max(0.0) * cone(it, -l) * it.colour.as_dvec3();
        }
        let share = f64::from(self.scene.ambience.bounce * material.kd);
        light * share * material.colour.as_dvec3()
    }
}

fn by_sphere(sphere: &Sphere, hit: &Hit<'_>, ambience: &Ambience) -> Cover {
    let radius = f64::from(sphere.radius);
    let to = sphere.centre.as_dvec3() - hit.ray.o;
    let farthest = radius + f64::from(ambience.reach).min(4.0 * radius);
    let fade = (1.0 - to.length_squared() / (farthest * farthest)).max(0.0);
    let h2 = (to.length_squared() / (radius * radius)).max(1.0);
    let height = hit.n.dot(to) / radius;
    let share = if height.abs() < 1.0 {
        (0.5 * (height + 1.0) / h2).clamp(0.0, 1.0).powf(1.5)
    } else {
        height.max(0.0) * radius / to.length() / h2
    };
    Cover { share: share * fade * fade, from: -to.normalize() }
}

fn by_block(block: &Block, hit: &Hit<'_>, ambience: &Ambience) -> Cover {
    let axes = block.axes.as_dmat3();
    let own = |v: DVec3| axes.transpose() * v;
    let (p, n) = (own(hit.ray.o - block.centre.as_dvec3()), own(hit.n));
    let half = block.half.as_dvec3();
    let middle = match block.shape {
        Shape::Box => half.element_sum() - half.max_element() - half.min_element(),
        _ => half.x,
    };
    let reach = f64::from(ambience.reach).min(2.5 * middle);
    let (mut share, mut sum, mut from) = (0.0, 0.09 * reach, DVec3::ZERO);
    for (at, weight) in [(0.9, 0.584), (0.22, 0.522)] {
        let height = at * reach;
        let (out, _) = outside(block, half, p + height * n);
        let closeness = (1.0 - out.length() / (0.98 * height)).max(0.0);
        let covered = closeness * closeness * weight * middle / (middle + 0.4 * height);
        share += covered;
        sum += covered * out.length();
        from += covered * out;
    }
    Cover { share, from: axes * from / sum }
}
