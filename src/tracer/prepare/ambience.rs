//! Solids that occlude ambient light, see [`scene::Ambience`].

use super::light::PreparedLight;
use super::object::{self, Object, ObjectId};
use super::surface::bounded;
use super::tree::BvhNode;
use crate::lanes::MAX_LANES;
use crate::scene::{self, Block, MAX_LIGHTS, MAX_SOLIDS, Scene};
use glam::{Mat3A, Vec3A};

pub(crate) const CAPACITY: usize = MAX_SOLIDS.next_multiple_of(MAX_LANES);

pub(crate) struct Ambience {
    pub is_on: bool,
    pub bounces: bool,
    pub sky: Vec3A,
    pub ground: Vec3A,
    pub floor: f32,
    /// The height above the floor at which half of the ground's light arrives.
    pub contact: f32,
    pub neighbours: [Neighbour; CAPACITY],
    pub bounds: Bounds,
    pub count: usize,
}

#[derive(Clone, Copy)]
pub(crate) struct Neighbour {
    pub object: ObjectId,
    pub centre: Vec3A,
    pub per_radius: f32,
    pub per_reach2: f32,
    pub opacity: f32,
    /// Of blocks.
    pub taps: [Tap; TAPS.len()],
    /// The reflected ambient light.
    pub ambient: Vec3A,
    /// The direction to each light, along a block's own axes, and the reflected light of a side
    /// that faces it.
    pub lights: [[Vec3A; 2]; MAX_LIGHTS],
}

#[derive(Clone, Copy)]
pub(crate) struct Tap {
    pub height: f32,
    /// At the distance `range` from the tap, the block covers nothing.
    pub range: f32,
    pub weight: f32,
}

/// The taps' heights as shares of the reach, and their weights, fitted to three taps. The first is
/// the highest: a block farther from it than this height is out of range of all taps.
const TAPS: [[f32; 2]; 2] = [[0.9, 0.584], [0.22, 0.522]];

/// Slightly below 1, so that a convex block is out of range of its own points.
const RANGE: f32 = 0.98;

/// A sphere's reach in radii: beyond, it covers less than a twentieth.
const SPHERE_REACH: f32 = 5.0;

/// A block's reach, as a multiple of its middle extent.
const BLOCK_REACH: f32 = 2.5;

/// The share of the ambient light that arrives at a solid's near side: the rest is occluded.
const AMBIENT_SHARE: f32 = 0.6;

/// Boxes of the points that solids darken, a lane per solid.
#[derive(Clone, Copy)]
pub(crate) struct Bounds {
    pub low: [[f32; CAPACITY]; 3],
    pub high: [[f32; CAPACITY]; 3],
    /// The distance by which points are moved along their normals before the comparison.
    pub ahead: [f32; CAPACITY],
}

zero! {
    Ambience { is_on, bounces, sky, ground, floor, contact, neighbours, bounds, count }
    Neighbour { object, centre, per_radius, per_reach2, opacity, taps, ambient, lights }
    Tap { height, range, weight }
    Bounds { low, high, ahead }
}

impl Ambience {
    pub fn set(&mut self, scene: &Scene, nodes: &[BvhNode], lights: &[PreparedLight]) {
        let ambience = &scene.ambience;
        self.is_on = ambience.occlusion > 0.0;
        self.count = 0;
        if !self.is_on {
            return;
        }
        self.bounces = ambience.bounce > 0.0;
        self.sky = scene.ambient.into();
        self.ground = ambience.ground.into();
        self.floor = scene.planes.first().map_or(f32::MIN, |plane| plane.centre.y);
        self.contact = CONTACT * ambience.reach;
        for node in nodes.iter().filter(|node| !node.is_bound) {
            self.add(scene, node, lights);
        }
        let padded = self.count.next_multiple_of(MAX_LANES);
        self.bounds.low[0][self.count..padded].fill(f32::INFINITY);
    }

    fn add(&mut self, scene: &Scene, node: &BvhNode, lights: &[PreparedLight]) {
        let scene::Ambience { occlusion, reach, bounce, .. } = scene.ambience;
        let (object, material) = object::of(scene, node.object);
        let i = self.count % CAPACITY;
        self.count = i + 1;
        let farthest = node.radius + reach.min((SPHERE_REACH - 1.0) * node.radius);
        let neighbour = &mut self.neighbours[i];
        neighbour.object = node.object;
        neighbour.centre = node.centre;
        neighbour.per_radius = 1.0 / node.radius;
        neighbour.per_reach2 = 1.0 / (farthest * farthest);
        // Infinity or NaN would spoil lanes that the solid does not cover.
        neighbour.opacity = bounded((1.0 - material.kt).max(0.0) * occlusion);
        let (mut half, mut ahead, mut turn) = (Vec3A::splat(farthest), 0.0, Mat3A::IDENTITY);
        if let Object::Block(block) = object {
            neighbour.taps = taps(block, reach);
            let Tap { height, .. } = neighbour.taps[0];
            let axes = Mat3A::from(block.axes);
            turn = axes.transpose();
            ahead = height;
            half = axes.x_axis.abs() * block.half.x
                + axes.y_axis.abs() * block.half.y
                + axes.z_axis.abs() * block.half.z
                + height;
        }
        let (low, high) = (node.centre - half, node.centre + half);
        for axis in 0..3 {
            self.bounds.low[axis][i] = low[axis];
            self.bounds.high[axis][i] = high[axis];
        }
        self.bounds.ahead[i] = ahead;
        let colour = Vec3A::from(material.colour) * (bounce * material.kd);
        neighbour.ambient = finite(colour * self.sky * AMBIENT_SHARE);
        for (to, light) in neighbour.lights.iter_mut().zip(lights) {
            let l = (light.position - node.centre).normalize_or(Vec3A::Y);
            *to = [turn * l, colour * light.colour * light.cone.share(-l)].map(finite);
        }
    }
}

/// See [`Ambience::contact`], as a share of the reach.
const CONTACT: f32 = 0.2;

fn finite(v: Vec3A) -> Vec3A {
    Vec3A::from_array(v.to_array().map(bounded))
}

fn taps(block: &Block, reach: f32) -> [Tap; TAPS.len()] {
    let own = block.half;
    let middle = own.x.min(own.y).max(own.x.max(own.y).min(own.z));
    let reach = reach.min(BLOCK_REACH * middle);
    TAPS.map(|[share, weight]| {
        let height = reach * share;
        Tap {
            height,
            range: RANGE * height,
            // Narrow blocks cover less.
            weight: weight * middle / (middle + 0.4 * height),
        }
    })
}
