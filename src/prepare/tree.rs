//! Spheres within bounds within bounds: a row of nodes that rays go along, past the spheres of the bounds that they miss.

use super::groups::{Group, GroupSet, Groups};
use super::slack;
use crate::DETAILS;
use crate::scene::{Light, MAX_LENGTH, MAX_LIGHTS, MAX_SOLIDS, Scene};
use glam::Vec3A;

/// Bounds of the largest tree, and its spheres and lights.
pub(crate) const MAX_NODES: usize = 255 + MAX_SOLIDS + MAX_LIGHTS;

/// A sphere of the scene or one around some of them, as its intersection wants it.
#[derive(Clone, Copy)]
pub(crate) struct Node {
    pub centre: Vec3A,
    /// The radius squared.
    pub r2: f32,
    /// How far rounding takes a point on it from it, see [`super::SLACK`].
    pub slack: f32,
    /// What [`Node::r2`] changes by where the radius changes by that.
    pub slack2: f32,
    /// What is surely ahead of a ray that does not start on it: half of the slack, and nothing for a bound.
    pub least: f32,
    pub radius: f32,
    /// Groups that it holds a part of.
    pub groups: GroupSet,
    /// The sphere's number.
    pub number: u16,
    /// How many nodes to go on by where it is missed.
    pub skip: u16,
    pub is_bound: bool,
    /// Whether it is around a box or a cylinder.
    pub is_block: bool,
    /// Whether no other object's points are within the sphere.
    pub is_apart: bool,
}

/// The nodes: a bound around all solid spheres, its parts after it, and so on down to the spheres; then the lights.
pub(crate) struct Tree {
    nodes: [Node; MAX_NODES],
    len: usize,
    solid: usize,
}

/// What a bound is larger by than its spheres need, as a share: more than rounding makes of a ray that comes from a
/// thousand radii away, so that no ray hits a sphere and misses its bound.
pub(super) const MARGIN: f32 = 1e-3;

/// A radius far beyond [`MAX_LENGTH`], whose square is finite.
const EVERYTHING: f32 = 1e18;

/// What two spheres or a sphere and a plane that touch may have in common of the radius, by rounding.
const TOUCH: f32 = 1.0 - 1e-4;

impl Tree {
    pub const NONE: Self = Self {
        nodes: [Node::NONE; MAX_NODES],
        len: 0,
        solid: 0,
    };

    /// All nodes.
    #[inline(always)]
    pub fn nodes(&self) -> &[Node] {
        &self.nodes[..self.len.min(MAX_NODES)]
    }

    /// Where to begin with rays that meet none but these groups: the bound around all says nothing more.
    #[inline(always)]
    pub fn start(&self, groups: GroupSet) -> usize {
        if self.nodes[0].groups & groups != 0 {
            1
        } else {
            self.solid
        }
    }

    /// Those of solid spheres.
    #[inline(always)]
    pub fn solid(&self) -> &[Node] {
        &self.nodes[..self.solid.min(MAX_NODES)]
    }

    /// Takes a scene in.
    pub fn set(&mut self, scene: &Scene, groups: &Groups) {
        self.len = 0;
        let levels = groups.levels();
        let leaves = 1 << levels;
        for leaf in 0..leaves {
            // The bounds that begin here, the widest first.
            for level in 0..=levels {
                let width = leaves >> level;
                if leaf % width == 0 {
                    let places = groups.part(leaf / width, 1 << level);
                    let bound = groups.bound(scene, places.clone());
                    self.push(Node {
                        skip: (2 * width - 1 + places.len()) as u16,
                        is_bound: true,
                        least: 0.0,
                        groups: groups.holding(places),
                        ..Node::bound(bound)
                    });
                }
            }
            for place in groups.part(leaf, leaves) {
                let number = groups.order()[place] as usize;
                let (centre, radius, _) = scene.around(number);
                self.push(Node {
                    number: place as u16,
                    groups: groups.holding(place..place + 1),
                    is_block: DETAILS && number >= scene.spheres.len(),
                    ..Node::of_sphere(centre, radius)
                });
            }
        }
        self.solid = self.len;
        for i in 0..self.solid {
            let Node {
                is_bound, is_block, ..
            } = self.nodes[i];
            self.nodes[i].is_apart = !is_bound && !is_block && self.is_apart(scene, i);
        }
        for (i, light) in scene.lights.iter().enumerate() {
            self.push(Node {
                number: (scene.solids() + i) as u16,
                groups: groups.of_light(i),
                ..Node::lamp(light)
            });
        }
    }

    fn push(&mut self, node: Node) {
        self.nodes[self.len] = node;
        self.len += 1;
    }

    /// Whether nothing reaches into the sphere of a node.
    fn is_apart(&self, scene: &Scene, i: usize) -> bool {
        let node = &self.nodes[i];
        let mut planes = scene.planes.iter();
        if planes.any(|plane| (plane.centre.y - node.centre.y).abs() < TOUCH * node.radius) {
            return false;
        }
        let mut other = 0;
        while let Some(o) = self.solid().get(other) {
            let reach = TOUCH * (node.radius + o.radius);
            let meets = node.centre.distance_squared(o.centre) < reach * reach;
            if meets && !o.is_bound && other != i {
                return false;
            }
            other += o.step(meets);
        }
        true
    }
}

impl Node {
    const NONE: Self = Self {
        centre: Vec3A::ZERO,
        r2: 0.0,
        slack: 0.0,
        slack2: 0.0,
        least: 0.0,
        radius: 0.0,
        groups: 0,
        number: 0,
        skip: 0,
        is_bound: false,
        is_block: false,
        is_apart: false,
    };

    /// A bound that is no number is around everything: whatever it holds that is one is found.
    fn bound(Group { centre, radius }: Group) -> Self {
        if centre.is_finite() && radius.is_finite() {
            Self::new(centre, radius * (1.0 + MARGIN))
        } else {
            Self::new(Vec3A::ZERO, EVERYTHING)
        }
    }

    /// A radius out of its range, or that is no number, counts as 0.
    fn of_sphere(centre: Vec3A, radius: f32) -> Self {
        let is_length = (0.0..=MAX_LENGTH).contains(&radius);
        Self::new(centre, if is_length { radius } else { 0.0 })
    }

    fn new(centre: Vec3A, radius: f32) -> Self {
        let slack = slack(centre, radius);
        Self {
            centre,
            r2: radius * radius,
            slack,
            slack2: 2.0 * radius * slack,
            least: 0.5 * slack,
            radius,
            skip: 1,
            ..Self::NONE
        }
    }

    /// What a light is drawn as: where it is not drawn, what no ray comes near to.
    fn lamp(light: &Light) -> Self {
        let mut node = Self::of_sphere(light.position, light.radius);
        if DETAILS && (light.parallel || light.radius == 0.0) {
            node.r2 = -1.0;
        }
        node
    }

    /// How many nodes to go on by.
    #[inline(always)]
    pub fn step(&self, is_met: bool) -> usize {
        if is_met { 1 } else { self.skip as usize }
    }
}
