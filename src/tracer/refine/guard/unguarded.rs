//! Tests for light without a bound: reflections, refractions, and shadows on spheres and blocks.

use super::squares::Squares;
use crate::coverage::corners;
use crate::grid::Bits;
use crate::maths::sqrt;
use crate::picture::TILE_HEIGHT;
use crate::prepare::{BvhNode, ObjectId, PreparedLight};
use crate::trace::{Sample, surface_points};
use glam::Vec3A;

impl Squares<'_> {
    /// Opens squares with light that has no bound.
    #[inline(never)]
    pub(super) fn look_for_unguarded(&self, all: &[Bits; TILE_HEIGHT], open: &mut [Bits]) {
        for (y, open) in open.iter_mut().enumerate() {
            all[y].without(*open).for_each(|x| {
                if self.may_show_unguarded(x, y) {
                    open.set(x);
                }
            });
        }
    }

    /// Returns whether a square may show light without a bound.
    fn may_show_unguarded(&self, x: usize, y: usize) -> bool {
        let row = &self.grid[y * self.stride + x..];
        let samples = [row[0], row[1], row[self.stride], row[self.stride + 1]].map(Sample);
        if samples.iter().any(|sample| sample.0 & Sample::UNGUARDED != 0) {
            return true;
        }
        let [first, others @ ..] = samples;
        // The verdict splits squares of several objects.
        let is_alike = others.map(Sample::object) == [first.object(); 3];
        is_alike && first.object().is_some_and(|id| self.may_be_shadowed(id, x, y))
    }

    /// Returns whether a shadow without an outline may fall on the part of the object `id` that a
    /// square shows.
    fn may_be_shadowed(&self, id: ObjectId, x: usize, y: usize) -> bool {
        let world = self.world;
        // Sharp shadows on planes have outlines.
        let is_plane = id.index() >= world.first_plane();
        let is_unknown = |light: &&PreparedLight| !is_plane || light.diameter > 0.0;
        let mut lights = world.lights().iter().filter(is_unknown).peekable();
        if id.index() >= world.background() || lights.peek().is_none() {
            return false;
        }
        let (d, t) = surface_points(world, &world.object(id).0, corners(self.pixels(x, y)));
        let [x, y, z] = [d.x * t, d.y * t, d.z * t].map(<[f32; 4]>::from);
        let points = [0, 1, 2, 3].map(|i| Vec3A::new(x[i], y[i], z[i]));
        let middle = points.iter().sum::<Vec3A>() * 0.25;
        let reach = points.map(|point| point.distance_squared(middle));
        let radius = BULGE * sqrt(reach.into_iter().fold(0.0, f32::max));
        let nodes = world.tree.solid_nodes();
        lights.any(|light| {
            let beam = Beam::to_light(world.eye + middle, radius, light);
            let mut i = 0;
            while let Some(node) = nodes.get(i) {
                let may_shade = node.object != id && !node.is_shadowless(light.diameter);
                let is_met = (node.is_bound || may_shade) && beam.meets(node);
                if is_met && !node.is_bound {
                    return true;
                }
                i += node.step(is_met);
            }
            false
        })
    }
}

/// The radius of a sphere around the surface between four corners, relative to their greatest
/// distance from their middle. An edge at which the surface turns by a right angle is up to 1.42
/// times as far from the middle as the corners.
const BULGE: f32 = 1.5;

/// A bound of the shadow rays from a square to a light.
struct Beam {
    from: Vec3A,
    /// Of length 1.
    d: Vec3A,
    length: f32,
    radius: f32,
    /// Half the light's diameter per unit of distance.
    growth: f32,
}

impl Beam {
    fn to_light(from: Vec3A, radius: f32, light: &PreparedLight) -> Self {
        let to_light = light.position - from;
        let length = to_light.length();
        Self { from, d: to_light / length, length, radius, growth: 0.5 * light.diameter / length }
    }

    /// Returns whether the beam may meet a node's bounding sphere and, for a block, the capsule
    /// around its bounding cylinder (Ericson: Real-Time Collision Detection, 2005, 5.1.9).
    fn meets(&self, node: &BvhNode) -> bool {
        let from = self.from - node.centre;
        let along = from.dot(self.d);
        let within = |t: f32| t.max(0.0).min(self.length);
        let mut t = within(-along);
        let reach = self.radius + self.growth * (t + node.radius);
        let is_near = |between: Vec3A, radius: f32| {
            between.length_squared() <= (radius + reach) * (radius + reach)
        };
        if !is_near(from + self.d * t, node.radius) {
            return false;
        }
        if !node.is_block {
            return true;
        }
        let half = sqrt((node.radius * node.radius - node.thin2).max(0.0));
        let (across, beside) = (self.d.dot(node.axis), from.dot(node.axis));
        t = within((across * beside - along) / (1.0 - across * across).max(1e-6));
        let mut u = 0.0;
        for _ in 0..2 {
            u = (across * t + beside).max(-half).min(half);
            t = within(across * u - along);
        }
        is_near(from + self.d * t - node.axis * u, sqrt(node.thin2))
    }
}
