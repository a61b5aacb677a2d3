//! Counts objects that a picture does not show although they are visible.

use super::MAX_ERROR;
use crate::error::worst_channel;
use eightfold_oracle::{Object, Oracle};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::Scene;
use std::collections::BTreeMap;

/// The objects of a scene that are visible in a frame.
pub struct Visible {
    /// For each visible object, the pixels that show it.
    pixels: BTreeMap<Object, Vec<u32>>,
}

impl Visible {
    /// Finds out what the centre of each pixel of a frame shows. The background does not count as an object.
    pub fn new(scene: &Scene, width: usize, height: usize) -> Self {
        let oracle = Oracle::new(scene, &Quality::EXHAUSTIVE, width, height);
        let mut pixels: BTreeMap<Object, Vec<u32>> = BTreeMap::new();
        for y in 0..height {
            for x in 0..width {
                let object = oracle.object_at(x as isize, y as isize);
                if object != Object::Background {
                    let pixel = (y * width + x) as u32;
                    pixels.entry(object).or_default().push(pixel);
                }
            }
        }
        Self { pixels }
    }

    /// The number of objects that a picture misses: more than three quarters of the pixels that show them are wrong. An object in
    /// wrong light or with wrong reflections is not missed.
    pub fn missed(&self, exhaustive: &[u32], picture: &[u32]) -> usize {
        let is_wrong =
            |&&i: &&u32| worst_channel(exhaustive[i as usize], picture[i as usize]) > MAX_ERROR;
        let objects = self.pixels.values();
        objects
            .filter(|pixels| 4 * pixels.iter().filter(is_wrong).count() > 3 * pixels.len())
            .count()
    }
}
