//! Adaptive squares, as in the thesis: recursive, one at a time. Coordinates are pixels.

use super::{Object, Oracle, TIE, Traced, bytes, pixel_like, steps};
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Material, Scene};
use glam::DVec3;
use std::collections::{HashMap, HashSet};

/// The width and the height of a tile in pixels.
pub const TILE: [usize; 2] = [512, 32];

/// Split squares: x, y, side.
pub type Splits = HashSet<[usize; 3]>;

fn is_strong(material: &Material) -> bool {
    material.kr + material.kt >= 0.3
}

fn has_crowd(scene: &Scene, quality: &Quality) -> bool {
    let spheres = scene.spheres.iter().map(|sphere| &sphere.material);
    let blocks = scene.blocks.iter().map(|block| &block.material);
    let strong = spheres.chain(blocks).filter(|material| is_strong(material));
    quality.key_weight > 0.0 && strong.count() >= 12
}

pub fn largest(scene: &Scene, quality: &Quality) -> usize {
    if has_crowd(scene, quality) { quality.square.min(4) } else { quality.square }
}

pub struct Squares<'a> {
    oracle: Oracle<'a>,
    points: usize,
    traced: HashMap<(usize, usize), Traced>,
    averaged: HashMap<(usize, usize), Traced>,
    /// How crowded the current tile is, 0 to 1.
    crowding: f64,
    /// The splits of another drawing, followed where rounding decides: one square changes the tolerance of a whole crowded tile.
    splits: &'a Splits,
    /// The squares decided by rounding.
    ties: Vec<[usize; 3]>,
    colours: Vec<DVec3>,
}

impl<'a> Squares<'a> {
    pub fn new(
        scene: &'a Scene,
        quality: &'a Quality,
        splits: &'a Splits,
        width: usize,
        height: usize,
    ) -> Self {
        let mut squares = Self {
            oracle: Oracle::new(scene, quality, width, height),
            points: 0,
            traced: HashMap::new(),
            averaged: HashMap::new(),
            crowding: 0.0,
            splits,
            ties: Vec::new(),
            colours: vec![DVec3::ZERO; width * height],
        };
        let square = largest(scene, quality);
        let [tile_width, tile_height] = TILE;
        for top in (0..height).step_by(tile_height) {
            for left in (0..width).step_by(tile_width) {
                let mut all = Vec::new();
                for y in (top..height.min(top + tile_height)).step_by(square) {
                    for x in (left..width.min(left + tile_width)).step_by(square) {
                        all.push((x, y));
                    }
                }
                squares.draw_tile(&all, square);
                squares.points += squares.traced.drain().count();
                squares.averaged.clear();
            }
        }
        squares
    }

    pub fn points(&self) -> usize {
        self.points
    }

    pub fn follows(&self, splits: &Splits) -> bool {
        let mut ties = self.ties.iter();
        ties.all(|tie| splits.contains(tie) == self.splits.contains(tie))
    }

    pub fn picture_like(&self, drawn: &[u32]) -> Vec<u32> {
        let Oracle { scene, width, .. } = self.oracle;
        let pixels = drawn.iter().zip(&self.colours).enumerate();
        let pixels = pixels.map(|(i, (&drawn, &colour))| {
            pixel_like(drawn, colour, scene.film.dither, i % width, i / width)
        });
        pixels.collect()
    }

    fn at(&mut self, x: usize, y: usize) -> Traced {
        if let Some(averaged) = self.averaged.get(&(x, y)) {
            return *averaged;
        }
        let trace = || {
            let mut traced = self.oracle.trace(x as isize, y as isize);
            if self.glitters(x, y) {
                traced.key = (x << 16 | y) as u64;
            }
            traced
        };
        let traced = self.traced.get(&(x, y)).copied().unwrap_or_else(trace);
        self.traced.insert((x, y), traced);
        traced
    }

    /// Returns whether a point shows a small strong mirror or glass in a crowd, which cannot be interpolated.
    fn glitters(&self, x: usize, y: usize) -> bool {
        let Oracle { scene, quality, .. } = self.oracle;
        let object = self.oracle.object_at(x as isize, y as isize);
        let is_small = match object {
            Object::Sphere(i) => {
                let sphere = &scene.spheres[i];
                let distance = (sphere.centre - scene.camera.eye).length();
                sphere.material.kt == 0.0 || sphere.radius < 0.2 * distance
            }
            Object::Block(_) => true,
            Object::Plane(_) | Object::Light(_) | Object::Background => false,
        };
        let material = object.material(scene);
        has_crowd(scene, quality) && is_small && material.is_some_and(is_strong)
    }

    fn draw_tile(&mut self, all: &[(usize, usize)], side: usize) {
        self.crowding = 0.0;
        let mut split = all.to_vec();
        split.retain(|&(x, y)| !self.is_filled(x, y, side));
        let share = split.len() as f64 / all.len() as f64;
        self.crowding = share.powi(4);
        for (x, y) in split {
            self.split(x, y, side);
        }
    }

    fn check(&mut self, x: usize, y: usize, side: usize) {
        let is_inside = x < self.oracle.width && y < self.oracle.height;
        if is_inside && !self.is_filled(x, y, side) {
            self.split(x, y, side);
        }
    }

    fn corners(&mut self, x: usize, y: usize, side: usize) -> [Traced; 4] {
        [(0, 0), (side, 0), (0, side), (side, side)].map(|(u, v)| self.at(x + u, y + v))
    }

    fn is_filled(&mut self, x: usize, y: usize, side: usize) -> bool {
        if side == 1 {
            let point = self.at(x, y);
            self.put(x, y, point.colour);
            return true;
        }
        let corners = self.corners(x, y, side);
        let excess = spread(&corners) - self.allowed(&corners, side);
        let [may_be_flat, is_flat] = flat(&corners);
        let may_be = may_be_flat || excess <= TIE;
        let is_sure = is_flat || excess < -TIE;
        let square = [x, y, side];
        if may_be && !is_sure {
            self.ties.push(square);
        }
        let is_filled = may_be && (is_sure || !self.splits.contains(&square));
        if is_filled {
            self.fill(x, y, side, corners);
        }
        is_filled
    }

    fn split(&mut self, x: usize, y: usize, side: usize) {
        let half = side / 2;
        let [a, b, c, d] = self.corners(x, y, side);
        for ((u, v), p, q) in
            [((half, 0), a, b), ((0, half), a, c), ((side, half), b, d), ((half, side), c, d)]
        {
            if (p.key == q.key || !self.has_keys())
                && spread(&[p, q, p, q]) <= self.allowed_side(side)
            {
                let colour = (shown(p) + shown(q)) / 2.0;
                self.averaged.insert((x + u, y + v), Traced { colour, ..p });
            }
        }
        for (u, v) in [(0, 0), (half, 0), (0, half), (half, half)] {
            self.check(x + u, y + v, half);
        }
    }

    fn allowed(&self, corners: &[Traced; 4], side: usize) -> f64 {
        let quality = self.oracle.quality;
        let agree = corners.iter().all(|corner| corner.key == corners[0].key);
        let spread = if agree { quality.tolerance_agreeing } else { quality.tolerance_differing };
        f64::from(spread) * self.growth(side)
    }

    fn growth(&self, side: usize) -> f64 {
        let growth = 8.0 / side as f64;
        growth + self.crowding * (1.0 - growth)
    }

    /// Returns the tolerance of a side's midpoint; negative if no midpoint is averaged.
    fn allowed_side(&self, side: usize) -> f64 {
        let tolerance = f64::from(self.oracle.quality.tolerance_side);
        if tolerance > 0.0 { tolerance * self.growth(side) } else { -1.0 }
    }

    fn has_keys(&self) -> bool {
        self.oracle.quality.tolerance_agreeing != self.oracle.quality.tolerance_differing
    }

    fn put(&mut self, x: usize, y: usize, colour: DVec3) {
        self.colours[y * self.oracle.width + x] = colour;
    }

    fn fill(&mut self, x: usize, y: usize, side: usize, corners: [Traced; 4]) {
        let [a, b, c, d] = corners.map(shown);
        for v in 0..side.min(self.oracle.height - y) {
            for u in 0..side.min(self.oracle.width - x) {
                let (s, t) = (u as f64 / side as f64, v as f64 / side as f64);
                let colour = a.lerp(b, s).lerp(c.lerp(d, s), t);
                self.put(x + u, y + v, colour);
            }
        }
    }
}

fn shown(point: Traced) -> DVec3 {
    point.colour.clamp(DVec3::ZERO, DVec3::ONE)
}

/// Returns whether the corners can be the same pixel by rounding, and whether they certainly are.
fn flat(corners: &[Traced; 4]) -> [bool; 2] {
    let bytes = corners.map(|corner| steps(corner.colour, 0.0, 0, 0).map(bytes));
    let (mut may_be, mut is_sure) = (true, true);
    for channel in 0..3 {
        let [least, most] = [0, 1].map(|end| bytes.map(|bytes| bytes[channel][end]));
        may_be &= least.into_iter().max() <= most.into_iter().min();
        is_sure &= least.into_iter().min() == most.into_iter().max();
    }
    [may_be, is_sure]
}

/// Returns the largest difference of a channel, in steps of 1/255.
fn spread(corners: &[Traced; 4]) -> f64 {
    let colours = corners.map(shown);
    let most = colours.into_iter().fold(DVec3::ZERO, DVec3::max);
    let least = colours.into_iter().fold(DVec3::ONE, DVec3::min);
    255.0 * (most - least).max_element()
}
