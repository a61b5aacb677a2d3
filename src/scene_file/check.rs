//! Checks a moving scene at all times. A field's extremes are at keys and at the extremes of
//! splines. Rules for several fields, or for a vector's length, can be broken between them: a
//! search finds the closest approaches.

use super::motion::Motion;
use super::moving::Moving;
use super::node::{Kind, Mistake, Node, steps};
use eightfold_tracer::glam::Vec3;
use eightfold_tracer::scene::{Scene, Shape};
use std::collections::BTreeMap;

/// Samples between two keys or extremes, where a distance of two splines has few minima.
const STEPS: u8 = 8;
/// Commands draw at most this many seconds after a scene's length.
const AFTER: f32 = 1.0;

/// Returns the end and the start of each direction, which must not vanish.
fn directions(scene: &mut Scene) -> Vec<(&mut Vec3, Vec3)> {
    let camera = &mut scene.camera;
    let mut ends = vec![(&mut camera.look_at, camera.eye), (&mut camera.up, Vec3::ZERO)];
    let spots = scene.lights.iter_mut().filter_map(|it| it.spot.as_mut());
    ends.extend(spots.map(|spot| (&mut spot.aim, Vec3::ZERO)));
    ends.extend(scene.softboxes.iter_mut().map(|it| (&mut it.aim, Vec3::ZERO)));
    ends
}

/// Returns how far each rule for several fields is from being broken, lengths of directions first.
fn distances(scene: &mut Scene) -> Vec<f32> {
    let ends = directions(scene).into_iter();
    let mut distances: Vec<f32> = ends.map(|(end, start)| end.distance(start)).collect();
    let camera = &scene.camera;
    let sight = (camera.look_at - camera.eye).normalize_or_zero();
    distances.push(sight.cross(camera.up.normalize_or_zero()).length());
    distances.push((scene.background + scene.sky).min_element());
    let spots = scene.lights.iter().filter_map(|light| light.spot);
    distances.extend(spots.map(|spot| spot.outer_angle - spot.inner_angle));
    let capsules = scene.blocks.iter();
    let capsules = capsules.filter(|block| block.shape == Shape::Capsule);
    distances.extend(capsules.map(|block| block.half.y - block.half.x));
    distances
}

impl Moving {
    pub fn check(&self, length: f32) -> Result<(), Mistake> {
        self.valid(0.0)?;
        self.parts().values().try_for_each(|part| part.check_alone(length))
    }

    /// Returns each moving object or material with its motions, and a part for all other fields.
    fn parts(&self) -> BTreeMap<[String; 2], Self> {
        let mut parts = BTreeMap::new();
        for motion in &self.motions {
            let part = self.part(&motion.of);
            let same = parts.entry(part.alias.clone()).or_insert(part);
            same.motions.push(motion.clone());
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
        let mut part = Self { tree: self.tree.clone(), ..Self::default() };
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
            part.alias = ["spheres[0].material".to_owned(), format!("{list}[{name:?}]")];
        }
        part
    }

    fn check_alone(&self, length: f32) -> Result<(), Mistake> {
        let sample = |time| Ok((time, distances(&mut self.valid(time)?)));
        let mut samples: Vec<_> = self.times(length).map(sample).collect::<Result<_, _>>()?;
        for i in 0..samples[0].1.len() {
            samples.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut more = Vec::new();
            for three in samples.windows(3) {
                let [a, b, c] = [0, 1, 2].map(|j| three[j].1[i]);
                // A minimum at 0 has a side at least this steep.
                let fall = (a - b).max(c - b);
                if b <= a && b <= c && b <= 2.0 * fall && fall > 0.0 {
                    let (from, to) = (three[0].0, three[2].0);
                    let time = self.closest(i, from, to, a.max(c))?;
                    // Where one distance is small, others change quickly.
                    let steps = (1..12).map(|k| (to - from) * 0.25_f32.powi(k));
                    more.extend(steps.flat_map(|step| [time - step, time + step]));
                }
            }
            for time in more {
                samples.push(sample(time)?);
            }
        }
        Ok(())
    }

    /// Returns the times of keys and extremes, then times between them.
    fn times(&self, length: f32) -> impl Iterator<Item = f32> {
        let ends = self.motions.iter().map(Motion::end);
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
            (1..STEPS).map(move |i| start + f32::from(i) * step).chain([last])
        };
        let between: Vec<f32> = times.windows(2).flat_map(between).collect();
        times.into_iter().chain(between)
    }

    /// Returns the time of a distance's minimum. `size` is the distance at the ends.
    fn closest(&self, i: usize, mut from: f32, mut to: f32, size: f32) -> Result<f32, Mistake> {
        let window = to - from;
        let distance = |time| Ok(distances(&mut self.valid(time)?)[i]);
        loop {
            let third = (to - from) / 3.0;
            let [a, b] = [from + third, to - third];
            if !(from < a && a < b && b < to) {
                self.check_turn(i, a, window, size)?;
                return Ok(a);
            }
            if distance(a)? < distance(b)? {
                to = b;
            } else {
                from = a;
            }
        }
    }

    /// Refuses a direction that reverses between two times around `time`: up to rounding it passes
    /// 0. They are `time` plus and minus 1e-5 of `window`, or 4 roundings of `time` if more, all in
    /// seconds.
    fn check_turn(&self, i: usize, time: f32, window: f32, size: f32) -> Result<(), Mistake> {
        let step = (1e-5 * window).max(4.0 * time.abs() * f32::EPSILON);
        let direction = |time| {
            let mut scene = self.valid(time)?;
            let ends = directions(&mut scene).into_iter().nth(i);
            Ok(ends.map_or(Vec3::ZERO, |(end, start)| *end - start))
        };
        let (before, after) = (direction(time - step)?, direction(time + step)?);
        let turns = before.normalize_or_zero().dot(after.normalize_or_zero()) < 0.0;
        let mut scene = self.valid(time)?;
        // Motions may jump.
        if turns
            && before.distance(after) <= 0.01 * size
            && let Some((end, start)) = directions(&mut scene).into_iter().nth(i)
        {
            *end = start;
        }
        let checked = scene.validate();
        checked.map_err(|error| self.mistake(time, &error))
    }
}
