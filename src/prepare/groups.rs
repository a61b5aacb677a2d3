//! Spheres that lie together, so that rays can pass by many at once.

use crate::scene::{MAX_LIGHTS, MAX_SPHERES, Scene};
use core::ops::Range;
use glam::Vec3;

/// Solid groups; a power of two. Each of up to that many spheres is a group of its own.
const LEAVES: usize = 32;

/// Groups of a frame: the solid ones, then one for each light.
pub(crate) const MAX_GROUPS: usize = LEAVES + MAX_LIGHTS;

/// Some of the groups, a bit each.
pub(crate) type GroupSet = u64;

/// Spheres of successive numbers, and a sphere around them.
#[derive(Clone, Copy)]
pub(crate) struct Group {
    pub centre: Vec3,
    pub radius: f32,
    first: u16,
    end: u16,
}

/// A frame's groups.
pub(crate) struct Groups {
    groups: [Group; MAX_GROUPS],
    all_in_one: Group,
    solid: usize,
    count: usize,
    /// The scene's numbers of the spheres, group after group.
    order: [u16; MAX_SPHERES],
    spheres: usize,
}

impl Group {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        radius: 0.0,
        first: 0,
        end: 0,
    };

    /// The numbers of its balls.
    #[inline(always)]
    pub fn balls(&self) -> Range<usize> {
        self.first as usize..self.end as usize
    }

    /// Whether it is one sphere, its own bound.
    #[inline(always)]
    pub fn is_single(&self) -> bool {
        self.end - self.first == 1
    }
}

impl Groups {
    pub const NONE: Self = Self {
        groups: [Group::NONE; MAX_GROUPS],
        all_in_one: Group::NONE,
        solid: 0,
        count: 0,
        order: [0; MAX_SPHERES],
        spheres: 0,
    };

    /// All groups.
    #[inline(always)]
    pub fn iter(&self) -> core::slice::Iter<'_, Group> {
        self.groups[..self.count.min(MAX_GROUPS)].iter()
    }

    /// The group number `i`.
    #[inline(always)]
    pub fn get(&self, i: usize) -> &Group {
        &self.groups[i]
    }

    /// All of them.
    pub fn all(&self) -> GroupSet {
        (1 << self.count) - 1
    }

    /// The solid spheres as shadow rays look at them: by groups, or all in one where each is a group of its own.
    #[inline(always)]
    pub fn clusters(&self) -> &[Group] {
        if self.solid == self.spheres {
            core::slice::from_ref(&self.all_in_one)
        } else {
            &self.groups[..self.solid]
        }
    }

    /// The spheres' numbers in the scene, in the order that the balls have.
    pub fn order(&self) -> &[u16] {
        &self.order[..self.spheres]
    }

    /// Groups a scene's spheres.
    pub fn set(&mut self, scene: &Scene) {
        self.spheres = scene.spheres.len();
        for (i, number) in self.order[..self.spheres].iter_mut().enumerate() {
            *number = i as u16;
        }
        self.count = 0;
        self.push(scene, 0..self.spheres);
        self.all_in_one = self.groups[0];
        self.count = 0;
        if self.spheres <= LEAVES {
            for i in 0..self.spheres {
                self.push(scene, i..i + 1);
            }
        } else {
            // Halve along the longest side until there are enough.
            let mut parts = 1;
            while parts < LEAVES {
                for part in 0..parts {
                    let range = |i: usize| self.spheres * i / parts;
                    let (first, end) = (range(part), range(part + 1));
                    let middle = self.spheres * (2 * part + 1) / (2 * parts);
                    halve(scene, &mut self.order[first..end], middle - first);
                }
                parts *= 2;
            }
            for part in 0..LEAVES {
                let range = |i: usize| self.spheres * i / LEAVES;
                self.push(scene, range(part)..range(part + 1));
            }
        }
        self.solid = self.count;
        for (i, light) in scene.lights.iter().enumerate() {
            let first = (self.spheres + i) as u16;
            self.groups[self.count] = Group {
                centre: light.position,
                radius: light.radius,
                first,
                end: first + 1,
            };
            self.count += 1;
        }
    }

    /// Makes a group of the spheres with these places in the order.
    fn push(&mut self, scene: &Scene, range: Range<usize>) {
        let (low, high) = bounds(scene, &self.order[range.clone()]);
        let centre = (low + high) * 0.5;
        let mut radius = 0.0f32;
        for &i in &self.order[range.clone()] {
            let sphere = &scene.spheres[i as usize];
            radius = radius.max(centre.distance(sphere.centre) + sphere.radius);
        }
        if range.len() > 1 {
            // The sums above are rounded.
            radius *= 1.0 + 1e-5;
        }
        self.groups[self.count] = Group {
            centre,
            radius,
            first: range.start as u16,
            end: range.end as u16,
        };
        self.count += 1;
    }
}

/// The smallest and the largest coordinates of some spheres' centres.
#[inline(never)]
fn bounds(scene: &Scene, order: &[u16]) -> (Vec3, Vec3) {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for &i in order {
        let centre = scene.spheres[i as usize].centre;
        low = low.min(centre);
        high = high.max(centre);
    }
    (low, high)
}

/// Puts the spheres that come first along the longest side of the bounds of their centres among the first `middle`.
fn halve(scene: &Scene, order: &mut [u16], middle: usize) {
    let centre = |i: u16| scene.spheres[i as usize].centre;
    let (low, high) = bounds(scene, order);
    let axis = (high - low).max_position();
    // Quickselect; numbers break ties, so that the order is total and the ends always move.
    let before = |a: u16, b: u16| (centre(a)[axis], a) < (centre(b)[axis], b);
    let (mut first, mut end) = (0, order.len());
    while end - first > 1 {
        order.swap((first + end) / 2, end - 1);
        let pivot = order[end - 1];
        let mut split = first;
        for i in first..end - 1 {
            if before(order[i], pivot) {
                order.swap(i, split);
                split += 1;
            }
        }
        order.swap(split, end - 1);
        if split < middle {
            first = split + 1;
        } else {
            end = split;
        }
    }
}
