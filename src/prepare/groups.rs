//! Spheres that lie together, so that much can be left out at once; boxes and cylinders count as spheres around them.

use crate::scene::{MAX_LIGHTS, MAX_SOLIDS, Scene};
use core::ops::Range;
use glam::Vec3A;

/// The most solid groups; a power of two. Each of up to that many spheres is a group of its own.
const MOST: usize = 32;

/// The most spheres of a leaf of the [`super::tree`].
const LEAF: usize = 4;

/// Groups of a frame: the solid ones, then one for each light.
pub(crate) const MAX_GROUPS: usize = MOST + MAX_LIGHTS;

/// Some of the groups, a bit each.
pub(crate) type GroupSet = u64;

/// Spheres that lie together, and a sphere around them.
#[derive(Clone, Copy)]
pub(crate) struct Group {
    pub centre: Vec3A,
    pub radius: f32,
}

/// A frame's groups.
pub(crate) struct Groups {
    groups: [Group; MAX_GROUPS],
    count: usize,
    /// The scene's numbers of the spheres, those that lie together one after the other.
    order: [u16; MAX_SOLIDS],
    spheres: usize,
}

impl Group {
    pub const NONE: Self = Self {
        centre: Vec3A::ZERO,
        radius: 0.0,
    };
}

impl Groups {
    pub const NONE: Self = Self {
        groups: [Group::NONE; MAX_GROUPS],
        count: 0,
        order: [0; MAX_SOLIDS],
        spheres: 0,
    };

    /// All groups: those of solid spheres, then the lights, each for itself.
    #[inline(always)]
    pub fn iter(&self) -> core::slice::Iter<'_, Group> {
        self.groups[..self.count.min(MAX_GROUPS)].iter()
    }

    /// The spheres' numbers in the scene, in the order that the kernels have.
    pub fn order(&self) -> &[u16] {
        &self.order[..self.spheres]
    }

    /// How often the spheres are halved for a leaf to hold few: a bound costs a ray as much as a sphere does.
    pub fn levels(&self) -> u32 {
        self.spheres.div_ceil(LEAF).next_power_of_two().ilog2()
    }

    /// The part number `part` of `parts`, as places in the order.
    pub fn part(&self, part: usize, parts: usize) -> Range<usize> {
        let place = |i: usize| self.spheres * i / parts;
        place(part)..place(part + 1)
    }

    /// The groups that some of the spheres are in.
    pub fn holding(&self, places: Range<usize>) -> GroupSet {
        let mut set = 0;
        let solid = self.spheres.min(MOST);
        for i in 0..solid {
            let group = self.part(i, solid);
            set |= GroupSet::from(group.start < places.end && places.start < group.end) << i;
        }
        set
    }

    /// The group of the light number `i`.
    pub fn of_light(&self, i: usize) -> GroupSet {
        1 << (self.spheres.min(MOST) + i)
    }

    /// Groups a scene's spheres.
    pub fn set(&mut self, scene: &Scene) {
        self.spheres = scene.solids();
        for (i, number) in self.order[..self.spheres].iter_mut().enumerate() {
            *number = i as u16;
        }
        // Halve along the longest side until there are enough parts for leaves and for groups.
        let mut levels = self.levels();
        if self.spheres > MOST {
            levels = levels.max(MOST.ilog2());
        }
        for level in 0..levels {
            let parts = 1 << level;
            for part in 0..parts {
                let Range { start, end } = self.part(part, parts);
                let middle = self.part(2 * part, 2 * parts).end;
                halve(scene, &mut self.order[start..end], middle - start);
            }
        }
        self.count = 0;
        let solid = self.spheres.min(MOST);
        for i in 0..solid {
            self.push(self.bound(scene, self.part(i, solid)));
        }
        for light in scene.lights.iter() {
            self.push(Group {
                centre: light.position,
                radius: light.radius,
            });
        }
    }

    fn push(&mut self, group: Group) {
        self.groups[self.count] = group;
        self.count += 1;
    }

    /// A sphere around those with these places in the order; around one, itself.
    pub fn bound(&self, scene: &Scene, places: Range<usize>) -> Group {
        let order = &self.order[places];
        let (low, high) = bounds(scene, order);
        let centre = (low + high) * 0.5;
        let mut radius = 0.0f32;
        for &i in order {
            let (of, its_radius, _) = scene.around(i as usize);
            radius = radius.max(centre.distance(of) + its_radius);
        }
        if order.len() > 1 {
            // The sums above are rounded.
            radius *= 1.0 + 1e-5;
        }
        Group { centre, radius }
    }
}

/// The smallest and the largest coordinates of some spheres' centres.
#[inline(never)]
fn bounds(scene: &Scene, order: &[u16]) -> (Vec3A, Vec3A) {
    let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
    for &i in order {
        let centre = scene.around(i as usize).0;
        low = low.min(centre);
        high = high.max(centre);
    }
    (low, high)
}

/// Puts the spheres that come first along the longest side of the bounds of their centres among the first `middle`.
fn halve(scene: &Scene, order: &mut [u16], middle: usize) {
    let centre = |i: u16| scene.around(i as usize).0;
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
