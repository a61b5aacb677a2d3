//! The check of a moving scene at all times.
//!
//! A field's extremes are at keys and at the extremes of splines. Rules for several fields, or for the length of a vector, can be
//! broken for a moment between them: there the scene is sampled, and a search finds the closest approaches.

use super::moving::Moving;
use super::node::{Kind, Mistake, Node, steps};
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Scene, Shape};

/// Samples between two keys or extremes. Between them, a distance of two splines has few minima.
const STEPS: u8 = 8;
/// Seconds after a scene's length that commands draw, at most.
const AFTER: f32 = 1.0;

/// The directions of a scene, which must not vanish.
fn directions(scene: &Scene) -> impl Iterator<Item = Vec3> {
    let camera = &scene.camera;
    let aims = scene.lights.iter().filter_map(|light| light.spot);
    let fixed = [camera.look_at - camera.eye, camera.up];
    fixed.into_iter().chain(aims.map(|spot| spot.aim))
}

/// Returns numbers near 0 where a rule for several fields is nearly broken. The lengths of directions are the first.
fn distances(scene: &Scene) -> Vec<f32> {
    let camera = &scene.camera;
    let sight = (camera.look_at - camera.eye).normalize_or_zero();
    let spots = scene.lights.iter().filter_map(|light| light.spot);
    let capsules = scene
        .blocks
        .iter()
        .filter(|block| block.shape == Shape::Capsule);
    let others = [
        sight.cross(camera.up.normalize_or_zero()).length(),
        (scene.background + scene.sky).min_element(),
    ];
    directions(scene)
        .map(Vec3::length)
        .chain(others)
        .chain(spots.map(|spot| spot.outer_angle - spot.inner_angle))
        .chain(capsules.map(|block| block.half.y - block.half.x))
        .collect()
}

impl Moving {
    pub fn check(&self, length: f32) -> Result<(), Mistake> {
        self.valid(0.0)?;
        self.parts()
            .iter()
            .try_for_each(|part| part.check_alone(length))
    }

    /// Returns the moving objects and materials, each with its motions, and the other fields together.
    fn parts(&self) -> Vec<Self> {
        let mut parts: Vec<Self> = Vec::new();
        for motion in &self.motions {
            let part = self.part(&motion.of);
            let same = parts.iter_mut().position(|it| it.alias == part.alias);
            let at = same.unwrap_or_else(|| {
                parts.push(part);
                parts.len() - 1
            });
            parts[at].motions.push(motion.clone());
        }
        parts
    }

    fn part(&self, path: &str) -> Self {
        let mut names = steps(path);
        let [list, name] = [(); 2].map(|()| names.next().unwrap_or_default());
        let is_number = |node: &Node| matches!(node.kind, Kind::Number(_));
        let has_items = |node: &Node| {
            node.name == "materials" || node.kind == Kind::List && !node.parts.iter().all(is_number)
        };
        let mut part = Self {
            tree: self.tree.clone(),
            ..Self::default()
        };
        let fields = &mut part.tree.parts;
        if !self.tree.get(list).is_some_and(has_items) {
            fields.retain(|node| !has_items(node));
            return part;
        }
        fields.retain(|node| node.name == list || node.name == "materials");
        let items = fields.iter_mut().filter(|node| node.name == list);
        items.for_each(|items| items.parts.retain(|item| item.name == name));
        part.alias = [format!("{list}[0]"), format!("{list}[{name}]")];
        if list == "materials" {
            let sphere = format!("(spheres: [(centre: (0, 0, 0), radius: 1, material: {name:?})])");
            fields.extend(Node::read(&sphere).unwrap_or_default().parts);
            part.alias = [
                "spheres[0].material".to_owned(),
                format!("{list}[{name:?}]"),
            ];
        }
        part
    }

    fn check_alone(&self, length: f32) -> Result<(), Mistake> {
        let mut samples = Vec::new();
        for time in self.times(length) {
            samples.push((time, distances(&self.valid(time)?)));
        }
        samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        for i in 0..samples[0].1.len() {
            let mut more = Vec::new();
            for three in samples.windows(3) {
                let [a, b, c] = [0, 1, 2].map(|j| three[j].1[i]);
                // The sides of a minimum at 0 are at least as steep.
                let fall = (a - b).max(c - b);
                if b <= a && b <= c && b <= 2.0 * fall && fall > 0.0 {
                    let [from, _, to] = [0, 1, 2].map(|j| three[j].0);
                    let time = self.closest(i, from, to)?;
                    self.check_turn(i, time, to - from, a.max(c))?;
                    // Other distances change quickly near a small one.
                    let steps = (1..12).map(|k| (to - from) * 0.25_f32.powi(k));
                    more.extend(steps.flat_map(|step| [time - step, time + step]));
                }
            }
            for time in more {
                samples.push((time, distances(&self.valid(time)?)));
            }
            samples.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        Ok(())
    }

    /// Returns the times of keys and extremes, then others between them.
    fn times(&self, length: f32) -> Vec<f32> {
        let ends = self.motions.iter().map(|motion| motion.end());
        let until = ends.fold(length + AFTER, f32::max);
        // A single motion repeats itself.
        let until = if self.motions.len() == 1 { 0.0 } else { until };
        let mut times: Vec<f32> = self.motions.iter().flat_map(|it| it.times(until)).collect();
        times.push(0.0);
        times.sort_by(f32::total_cmp);
        times.dedup();
        let between = |pair: &[f32]| {
            let (start, step) = (pair[0], (pair[1] - pair[0]) / f32::from(STEPS));
            let last = pair[1].next_down();
            (1..STEPS)
                .map(move |i| start + f32::from(i) * step)
                .chain([last])
        };
        let between: Vec<f32> = times.windows(2).flat_map(between).collect();
        times.extend(between);
        times
    }

    /// Returns the time of a distance's minimum.
    fn closest(&self, i: usize, mut from: f32, mut to: f32) -> Result<f32, Mistake> {
        loop {
            let third = (to - from) / 3.0;
            let [a, b] = [from + third, to - third];
            if !(from < a && a < b && b < to) {
                return Ok(a);
            }
            let [at_a, at_b] = [a, b].map(|time| Ok(distances(&self.valid(time)?)[i]));
            if at_a? < at_b? {
                to = b;
            } else {
                from = a;
            }
        }
    }

    /// Refuses a direction that turns back within a hundred thousandth of a window in seconds, and so passes 0 up to rounding. `size` is
    /// its length at the window's ends.
    fn check_turn(&self, i: usize, time: f32, window: f32, size: f32) -> Result<(), Mistake> {
        let step = (1e-5 * window).max(4.0 * time.abs() * f32::EPSILON);
        let direction = |time| {
            let scene = self.valid(time)?;
            Ok(directions(&scene).nth(i).unwrap_or_default())
        };
        let (before, after) = (direction(time - step)?, direction(time + step)?);
        let turns = before.normalize_or_zero().dot(after.normalize_or_zero()) < 0.0;
        // Motions may jump.
        if !turns || before.distance(after) > 0.01 * size {
            return Ok(());
        }
        let mut scene = self.valid(time)?;
        match i {
            0 => scene.camera.look_at = scene.camera.eye,
            1 => scene.camera.up = Vec3::ZERO,
            _ => {
                let spots = scene
                    .lights
                    .iter_mut()
                    .filter_map(|light| light.spot.as_mut());
                spots
                    .skip(i - 2)
                    .take(1)
                    .for_each(|spot| spot.aim = Vec3::ZERO);
            }
        }
        let checked = scene.validate();
        checked.map_err(|error| self.mistake(time, &error))
    }
}
