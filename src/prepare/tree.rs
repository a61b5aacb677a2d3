//! Solids within bounds within bounds: a row of nodes that rays go along, past the solids of the bounds that they miss.
//! Boxes and cylinders count as spheres around them.

use super::hit_error;
use super::object::{self, Object};
use crate::scene::{Block, MAX_LENGTH, MAX_LIGHTS, MAX_SOLIDS, Scene, Shape};
use glam::Vec3A;

/// Groups of solids, of which a part of the picture shows some: up to that many each are a group of their own.
const SOLID_GROUPS: usize = 32;

/// Groups of a frame: those of solids, which lie together, then one for each light.
pub(crate) const MAX_GROUPS: usize = SOLID_GROUPS + MAX_LIGHTS;

/// Some of the groups, a bit each.
pub(crate) type GroupSet = u64;

/// The most spheres of a leaf: a bound costs a ray as much as a sphere does.
const LEAF: usize = 4;

/// Bounds of the largest tree, whose leaves are of two at least, and its solids and lights.
pub(crate) const MAX_NODES: usize = 255 + MAX_SOLIDS + MAX_LIGHTS;

/// A sphere of the scene or one around some of them, as its intersection wants it.
#[derive(Clone, Copy)]
pub(crate) struct BvhNode {
    pub centre: Vec3A,
    /// The radius squared; below 0 of a light that is not drawn.
    pub r2: f32,
    /// Larger than that by a share of [`MARGIN`]: rays are held against this one first, with less exact arithmetic.
    pub cull2: f32,
    /// How far rounding takes a point on it from it, see [`super::HIT_ERROR`].
    pub hit_error: f32,
    /// What [`BvhNode::r2`] changes by where the radius changes by that.
    pub r2_error: f32,
    pub radius: f32,
    /// Groups that it holds a part of.
    pub groups: GroupSet,
    /// The object's number.
    pub number: u16,
    /// How many nodes to go on by where it is missed.
    pub skip: u16,
    pub is_bound: bool,
    /// Whether it is around a box or a cylinder.
    pub is_block: bool,
    /// The longer of that one's own y and z axes, of length 1, and the square of how far from there it reaches.
    pub axis: Vec3A,
    pub thin2: f32,
}

/// A solid, or a sphere around it.
#[derive(Clone, Copy)]
struct Ball {
    centre: Vec3A,
    radius: f32,
    /// The number in the scene.
    number: u16,
}

/// The nodes: a bound around all solids, its parts after it, and so on down to the solids; then the lights.
pub(crate) struct Tree {
    /// The solids, those that lie together one after the other.
    balls: [Ball; MAX_SOLIDS],
    solid_count: usize,
    nodes: [BvhNode; MAX_NODES],
    len: usize,
    /// The end of the nodes of solids: those of the lights follow.
    solid_node_end: usize,
}

/// What a bound is larger by than its spheres need, as a share: more than rounding makes of a ray that comes from a
/// thousand radii away, so that no ray hits a sphere and misses its bound.
pub(super) const MARGIN: f32 = 1e-3;

/// A radius far beyond [`MAX_LENGTH`], whose square is finite.
const EVERYTHING: f32 = 1e18;

impl Tree {
    pub const NONE: Self = Self {
        balls: [Ball {
            centre: Vec3A::ZERO,
            radius: 0.0,
            number: 0,
        }; MAX_SOLIDS],
        solid_count: 0,
        nodes: [BvhNode::NONE; MAX_NODES],
        len: 0,
        solid_node_end: 0,
    };

    /// All nodes.
    #[inline(always)]
    pub fn nodes(&self) -> &[BvhNode] {
        &self.nodes[..self.len]
    }

    /// Where to begin with rays that meet none but these groups: the bound around all says nothing more.
    #[inline(always)]
    pub fn start(&self, groups: GroupSet) -> usize {
        if self.nodes[0].groups & groups != 0 {
            1
        } else {
            self.solid_node_end
        }
    }

    /// Those of solids.
    #[inline(always)]
    pub fn solid_nodes(&self) -> &[BvhNode] {
        &self.nodes[..self.solid_node_end]
    }

    /// Takes a scene in.
    pub fn set(&mut self, scene: &Scene) {
        self.solid_count = scene.solids();
        for (number, ball) in self.balls.iter_mut().enumerate().take(self.solid_count) {
            let (centre, radius) = match object::of(scene, number).0 {
                Object::Sphere(sphere) => (sphere.centre, sphere.radius),
                // A little larger, so that what rounding adds is covered.
                Object::Block(block) => (block.centre, block.half.length() * (1.0 + 1e-4)),
                _ => (Vec3A::ZERO, 0.0),
            };
            *ball = Ball {
                centre,
                radius: length(radius),
                number: number as u16,
            };
        }
        self.len = 0;
        self.divide(0, self.solid_count, scene);
        self.solid_node_end = self.len;
        for (i, light) in scene.lights.iter().enumerate() {
            let groups = 1 << (SOLID_GROUPS + i);
            let node = self.push(light.position, length(light.radius), groups);
            node.number = (scene.solids() + i) as u16;
            // What is not drawn no ray comes near to.
            if light.parallel || light.radius == 0.0 {
                node.r2 = -1.0;
                node.cull2 = -1.0;
            }
        }
    }

    /// Adds the bound around the solids from number `first` to below `end` of a scene, and what is in it.
    fn divide(&mut self, first: usize, end: usize, scene: &Scene) {
        let at = self.len;
        let balls = &mut self.balls[first..end];
        let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
        for ball in balls.iter() {
            low = low.min(ball.centre);
            high = high.max(ball.centre);
        }
        let mut centre = (low + high) * 0.5;
        let mut radius = 0.0f32;
        for ball in balls.iter() {
            radius = radius.max(centre.distance(ball.centre) + ball.radius);
        }
        radius *= 1.0 + MARGIN;
        // A bound that is no number is around everything: whatever it holds that is one is found.
        if !(centre.abs().element_sum() + radius).is_finite() {
            (centre, radius) = (Vec3A::ZERO, EVERYTHING);
        }
        let middle = balls.len() / 2;
        let is_leaf = balls.len() <= LEAF;
        if !is_leaf {
            halve(balls, middle, (high - low).max_position());
        }
        // Bits of the groups of the first and the last solid, and all between.
        let group = |i: usize| i * SOLID_GROUPS / self.solid_count.max(SOLID_GROUPS);
        let groups = (2 << group(end.max(1) - 1)) - (1 << group(first));
        let bound = self.push(centre, radius, groups);
        bound.is_bound = true;
        if is_leaf {
            for place in first..end {
                let ball = self.balls[place];
                let group = 1 << (place * SOLID_GROUPS / self.solid_count.max(SOLID_GROUPS));
                let node = self.push(ball.centre, ball.radius, group);
                node.number = ball.number;
                if let Object::Block(block) = object::of(scene, ball.number as usize).0 {
                    node.set_block(block);
                }
            }
        } else {
            self.divide(first, first + middle, scene);
            self.divide(first + middle, end, scene);
        }
        self.nodes[at].skip = (self.len - at) as u16;
    }

    /// Adds a sphere.
    fn push(&mut self, centre: Vec3A, radius: f32, groups: GroupSet) -> &mut BvhNode {
        let node = &mut self.nodes[self.len];
        self.len += 1;
        let hit_error = hit_error(centre, radius);
        *node = BvhNode {
            centre,
            r2: radius * radius,
            cull2: radius * radius * (1.0 + MARGIN),
            hit_error,
            r2_error: 2.0 * radius * hit_error,
            radius,
            groups,
            skip: 1,
            ..BvhNode::NONE
        };
        node
    }
}

/// What is longer than the radius around the largest box.
const LONGEST: f32 = 2.0 * MAX_LENGTH;

/// A radius; one out of its range, or that is no number, counts as 0.
fn length(radius: f32) -> f32 {
    if (0.0..LONGEST).contains(&radius) {
        radius
    } else {
        0.0
    }
}

/// Puts the balls that come first along an axis among the first `middle` (Hoare: Find, Communications of the ACM, 1961).
fn halve(balls: &mut [Ball], middle: usize, axis: usize) {
    let place = |ball: &Ball| ball.centre.as_ref()[axis];
    let (mut first, mut end) = (0, balls.len());
    while first + 1 < end {
        let pivot = place(&balls[middle]);
        let (mut i, mut j) = (first, end);
        while i < j {
            while place(&balls[i]) < pivot {
                i += 1;
            }
            while pivot < place(&balls[j - 1]) {
                j -= 1;
            }
            if i < j {
                j -= 1;
                balls.swap(i, j);
                i += 1;
            }
        }
        if j <= middle {
            first = i;
        }
        if middle < i {
            end = j;
        }
    }
}

impl BvhNode {
    const NONE: Self = Self {
        centre: Vec3A::ZERO,
        r2: 0.0,
        cull2: 0.0,
        hit_error: 0.0,
        r2_error: 0.0,
        radius: 0.0,
        groups: 0,
        number: 0,
        skip: 0,
        is_bound: false,
        is_block: false,
        axis: Vec3A::ZERO,
        thin2: 0.0,
    };

    /// Takes in what it is around: what is long stands or lies.
    #[inline(always)]
    fn set_block(&mut self, block: &Block) {
        self.is_block = true;
        let half2 = block.half * block.half;
        let mut thin2 = half2.x;
        if half2.y < half2.z {
            self.axis = block.axes.z_axis;
            thin2 += half2.y;
        } else {
            self.axis = block.axes.y_axis;
            thin2 += if block.shape == Shape::Cylinder {
                0.0
            } else {
                half2.z
            };
        }
        self.thin2 = thin2 * (1.0 + 2.0 * MARGIN);
    }

    /// How many nodes to go on by.
    #[inline(always)]
    pub fn step(&self, is_met: bool) -> usize {
        if is_met { 1 } else { self.skip as usize }
    }
}
