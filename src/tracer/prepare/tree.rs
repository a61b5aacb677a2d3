//! The bounding volume hierarchy of solids (spheres and blocks): bounding spheres in depth-first
//! order. A ray skips the descendants of missed nodes.

use super::object::{self, Object, ObjectId};
use crate::rounding::{BOUND, hit_error};
use crate::scene::{Block, MAX_LENGTH, MAX_LIGHTS, MAX_SOLIDS, Scene};
use crate::shapes::block;
use crate::zero::Zero;
use glam::{Vec3, Vec3A};

/// Each tile has the set of groups that may be visible in it.
const SOLID_GROUPS: usize = 32;

/// The solids' groups, in the tree's order, then one per light.
pub(crate) const MAX_GROUPS: usize = SOLID_GROUPS + MAX_LIGHTS;

pub(crate) type GroupSet = u64;

/// The groups that primary rays, and their reflections in the first plane, can meet in a tile.
#[derive(Clone, Copy, Default)]
pub(crate) struct VisibleGroups {
    pub directly: GroupSet,
    pub mirrored: GroupSet,
}

/// The largest number of solids in a leaf.
///
/// Shadow rays test all solids of a leaf without a branch: a mispredicted branch takes as long as
/// four tests. With 4 solids a scene of letters on water takes 8 % longer, with 16 a field of 64
/// spheres 7 %.
const LEAF: usize = 10;

const UNSORTED: usize = 4;

const MAX_BOUNDS: usize = 2 * MAX_SOLIDS.div_ceil(LEAF).next_power_of_two() - 1;

pub(super) const MAX_NODES: usize = MAX_BOUNDS + MAX_SOLIDS + MAX_LIGHTS;

/// A sphere, or the bounding sphere of a block, a light or several nodes.
#[derive(Clone, Copy)]
pub(crate) struct BvhNode {
    pub centre: Vec3A,
    pub r2: f32,
    /// Enlarged by [`BOUND`], for a conservative first test.
    pub cull2: f32,
    /// See [`hit_error`].
    pub hit_error: f32,
    /// The change of `r2` due to `hit_error`.
    pub r2_error: f32,
    pub radius: f32,
    pub groups: GroupSet,
    /// Meaningless for a bound.
    pub object: ObjectId,
    /// The number of nodes to advance by if this one is missed.
    pub skip: u16,
    pub is_bound: bool,
    /// The number of a leaf's solids, which are the next nodes.
    pub solids: u8,
    pub is_block: bool,
    /// Whether the solid lets all light of area lights pass.
    pub is_clear: bool,
    /// Whether the eye is too near to a sphere to be classified in f32 as inside or outside.
    pub is_at_eye: bool,
    pub axis: Vec3A,
    /// The squared radius of the block's bounding cylinder around `axis`.
    pub thin2: f32,
}

#[derive(Clone, Copy)]
struct Ball {
    centre: Vec3A,
    radius: f32,
    object: ObjectId,
}

pub(crate) struct Tree {
    eye: Vec3A,
    balls: [Ball; MAX_SOLIDS],
    solid_count: usize,
    nodes: [BvhNode; MAX_NODES],
    len: usize,
    solid_node_end: usize,
}

zero! {
    BvhNode {
        centre, r2, cull2, hit_error, r2_error, radius, groups, object, skip, is_bound, solids,
        is_block, is_clear, is_at_eye, axis, thin2
    }
    Ball { centre, radius, object }
    Tree { eye, balls, solid_count, nodes, len, solid_node_end }
}

/// Far larger than [`MAX_LENGTH`], with a finite square.
const UNBOUNDED: f32 = 1e18;

impl Tree {
    pub fn nodes(&self) -> &[BvhNode] {
        &self.nodes[..self.len]
    }

    /// Returns the first node for rays that only meet `groups`, without the root, which they
    /// probably meet.
    pub fn start(&self, groups: GroupSet) -> usize {
        if self.nodes[0].groups & groups != 0 { 1 } else { self.solid_node_end }
    }

    pub fn solid_nodes(&self) -> &[BvhNode] {
        &self.nodes[..self.solid_node_end]
    }

    pub fn objects(&self) -> impl Iterator<Item = (usize, &BvhNode)> {
        let nodes = self.nodes().iter().enumerate();
        nodes.filter(|(_, node)| !node.is_bound)
    }

    pub fn solids(&self) -> impl Iterator<Item = (usize, &BvhNode)> {
        let end = self.solid_node_end;
        self.objects().take_while(move |&(i, _)| i < end)
    }

    pub fn set(&mut self, scene: &Scene) {
        self.eye = scene.camera.eye.into();
        self.solid_count = scene.solids();
        for (number, ball) in self.balls.iter_mut().enumerate().take(self.solid_count) {
            let id = ObjectId::new(number);
            let (centre, radius) = match object::of(scene, id).0 {
                Object::Sphere(sphere) => (sphere.centre, sphere.radius),
                Object::Block(block) => (block.centre, block::bounding_radius(block)),
                Object::Light(_) | Object::Plane(_) | Object::Background => (Vec3::ZERO, 0.0),
            };
            *ball = Ball { centre: centre.into(), radius: valid_radius(radius), object: id };
        }
        sort(&mut self.balls[..self.solid_count]);
        self.len = 0;
        self.add_bound(0, self.solid_count, scene);
        self.solid_node_end = self.len;
        for (i, light) in scene.lights.iter().enumerate() {
            let groups = 1 << (SOLID_GROUPS + i);
            let node = self.push(light.position.into(), valid_radius(light.drawn_radius), groups);
            node.object = ObjectId::new(scene.solids() + i);
            if light.parallel || light.drawn_radius == 0.0 {
                node.r2 = -1.0;
                node.cull2 = -1.0;
            }
        }
    }

    fn add_bound(&mut self, first: usize, end: usize, scene: &Scene) {
        let at = self.len;
        let balls = &self.balls[first..end];
        let [low, high] = extent(balls);
        let mut centre = (low + high) * 0.5;
        let mut radius = 0.0f32;
        for ball in balls {
            radius = radius.max(centre.distance(ball.centre) + ball.radius);
        }
        radius *= 1.0 + BOUND;
        // If a ball has NaN or infinity, rays must still find the others.
        if !(centre.abs().element_sum() + radius).is_finite() {
            (centre, radius) = (Vec3A::ZERO, UNBOUNDED);
        }
        let middle = balls.len() / 2;
        let is_leaf = balls.len() <= LEAF;
        let count = self.solid_count.max(SOLID_GROUPS);
        let group = |i: usize| i * SOLID_GROUPS / count;
        let groups = (2 << group(end.max(1) - 1)) - (1 << group(first));
        let bound = self.push(centre, radius, groups);
        bound.is_bound = true;
        if is_leaf {
            bound.solids = (end - first) as u8;
            for i in first..end {
                let ball = self.balls[i];
                let node = self.push(ball.centre, ball.radius, 1 << group(i));
                node.object = ball.object;
                let (object, material) = object::of(scene, ball.object);
                node.is_clear = material.tint.cmpge(Vec3::ONE).all();
                if let Object::Block(block) = object {
                    node.set_block(block);
                }
            }
        } else {
            self.add_bound(first, first + middle, scene);
            self.add_bound(first + middle, end, scene);
        }
        self.nodes[at].skip = (self.len - at) as u16;
    }

    #[inline(never)]
    fn push(&mut self, centre: Vec3A, radius: f32, groups: GroupSet) -> &mut BvhNode {
        let node = &mut self.nodes[self.len];
        self.len += 1;
        let hit_error = hit_error(centre, radius);
        *node = BvhNode {
            centre,
            r2: radius * radius,
            cull2: radius * radius * (1.0 + BOUND),
            hit_error,
            r2_error: 2.0 * radius * hit_error,
            radius,
            groups,
            skip: 1,
            ..BvhNode::ZERO
        };
        let power = node.power(self.eye);
        node.is_at_eye = power != 0.0 && power.abs() < 2.0 * node.r2_error;
        node
    }
}

const MAX_RADIUS: f32 = 2.0 * MAX_LENGTH;

fn valid_radius(radius: f32) -> f32 {
    if (0.0..MAX_RADIUS).contains(&radius) { radius } else { 0.0 }
}

fn extent(balls: &[Ball]) -> [Vec3A; 2] {
    let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
    for ball in balls {
        low = low.min(ball.centre);
        high = high.max(ball.centre);
    }
    [low, high]
}

fn sort(balls: &mut [Ball]) {
    if balls.len() <= UNSORTED {
        return;
    }
    let [low, high] = extent(balls);
    let middle = balls.len() / 2;
    partition(balls, middle, (high - low).max_position());
    let (first, rest) = balls.split_at_mut(middle);
    sort(first);
    sort(rest);
}

/// Partitions balls at `middle` along an axis (Hoare: Algorithm 65, Find, Communications of the
/// ACM, 1961).
fn partition(balls: &mut [Ball], middle: usize, axis: usize) {
    let coordinate = |ball: &Ball| ball.centre.as_ref()[axis];
    let (mut first, mut end) = (0, balls.len());
    while first + 1 < end {
        let pivot = coordinate(&balls[middle]);
        let (mut i, mut j) = (first, end);
        while i < j {
            while coordinate(&balls[i]) < pivot {
                i += 1;
            }
            while pivot < coordinate(&balls[j - 1]) {
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
    pub fn is_shadowless(&self, diameter: f32) -> bool {
        self.is_clear && diameter > 0.0
    }

    fn set_block(&mut self, block: &Block) {
        self.is_block = true;
        let (axis, radius2) = block::bounding_cylinder(block);
        self.axis = axis;
        self.thin2 = radius2 * (1.0 + 2.0 * BOUND);
    }

    #[inline(never)]
    pub fn power(&self, point: Vec3A) -> f32 {
        let from = point.as_dvec3() - self.centre.as_dvec3();
        let radius = f64::from(self.radius);
        (from.length_squared() - radius * radius) as f32
    }

    /// Not inlined: rarely called.
    #[inline(never)]
    pub fn powers(&self, [x, y, z]: [&[f32]; 3], powers: &mut [f32]) {
        for (power, ((&x, &y), &z)) in powers.iter_mut().zip(x.iter().zip(y).zip(z)) {
            *power = self.power(Vec3A::new(x, y, z));
        }
    }

    pub fn group(&self) -> usize {
        self.groups.trailing_zeros() as usize
    }

    pub fn step(&self, is_met: bool) -> usize {
        if is_met { 1 } else { self.skip as usize }
    }
}
