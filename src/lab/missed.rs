//! Objects that a frame does not show although they are there.

use crate::error::worst_channel;
use eightfold::scene::Scene;
use glam::Vec3A;
use std::collections::BTreeMap;

/// A pixel is off where a channel differs by more than so much of 255 from the exhaustive frame's.
const OFF: u32 = 8;

/// Which object each pixel of a frame looks at.
pub struct Visible {
    /// For each object that some pixel looks at, those pixels.
    pixels: BTreeMap<usize, Vec<u32>>,
}

impl Visible {
    /// What the centres of a frame's pixels look at; the background is no object.
    pub fn new(scene: &Scene, width: usize, height: usize) -> Self {
        let camera = &scene.camera;
        let forward = (camera.look_at - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let up = right.cross(forward);
        let pixel = 2.0 * (0.5 * camera.field_of_view).tan() / height as f32;
        let mut pixels: BTreeMap<usize, Vec<u32>> = BTreeMap::new();
        for y in 0..height {
            for x in 0..width {
                let across = pixel * (x as f32 - 0.5 * (width as f32 - 1.0));
                let down = pixel * (y as f32 - 0.5 * (height as f32 - 1.0));
                let d = (forward + across * right - down * up).normalize();
                if let Some(object) = nearest(scene, camera.eye, d) {
                    let place = (y * width + x) as u32;
                    pixels.entry(object).or_default().push(place);
                }
            }
        }
        Self { pixels }
    }

    /// Objects that a picture misses: of the pixels that look at one more than three in four are off. One in another light,
    /// or in rays that end too soon, is wrong but there.
    pub fn missed(&self, exhaustive: &[u32], picture: &[u32]) -> usize {
        let is_off = |&&i: &&u32| worst_channel(exhaustive[i as usize], picture[i as usize]) > OFF;
        let objects = self.pixels.values();
        objects
            .filter(|pixels| 4 * pixels.iter().filter(is_off).count() > 3 * pixels.len())
            .count()
    }
}

/// The first object along a ray: spheres, lights and planes counted on.
fn nearest(scene: &Scene, o: Vec3A, d: Vec3A) -> Option<usize> {
    let spheres = scene.spheres.iter().map(|s| (s.centre, s.radius));
    let lights = scene.lights.iter().map(|l| (l.position, l.radius));
    let round = spheres.chain(lights).map(|(c, r)| sphere(o, d, c, r));
    let planes = scene.planes.iter().map(|plane| {
        let t = (plane.centre.y - o.y) / d.y;
        let p = o + t * d - plane.centre;
        (t > 0.0 && p.x.abs() <= plane.half_x && p.z.abs() <= plane.half_z).then_some(t)
    });
    let hits = round.chain(planes).enumerate();
    hits.filter_map(|(i, t)| Some((i, t?)))
        .min_by(|(_, a), (_, b)| a.total_cmp(b))
        .map(|(i, _)| i)
}

/// How far along a ray a sphere begins, for an eye outside of it.
fn sphere(o: Vec3A, d: Vec3A, centre: Vec3A, radius: f32) -> Option<f32> {
    let to = centre - o;
    let along = to.dot(d);
    // The distance of the centre from the ray, not the difference of two large squares.
    let beside = to - along * d;
    let inside = radius * radius - beside.dot(beside);
    (inside > 0.0 && along > 0.0).then(|| along - inside.sqrt())
}
