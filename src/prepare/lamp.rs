//! Lights as shadow rays want them.

use super::slack;
use super::tree::{MARGIN, MAX_NODES, Node};
use crate::DETAILS;
use crate::scene::Light;
use glam::Vec3A;

/// A point light.
pub(crate) struct Lamp {
    pub position: Vec3A,
    pub colour: Vec3A,
    is_plain: bool,
    /// The solid nodes of the [`super::Tree`].
    pub casters: [Caster; MAX_NODES],
}

/// A sphere as shadow rays want it: what it shades of points without is in the cone around it and farther away than where
/// the cone touches it.
#[derive(Clone, Copy)]
pub(crate) struct Caster {
    /// The lamp's direction, seen from the centre.
    pub axis: Vec3A,
    /// The square of the chord between the axis and the cone's side on the sphere of radius 1.
    pub chord2: f32,
    /// Nothing nearer to the lamp than this is shaded.
    pub from: f32,
    /// Whether the cone is all that there is to know: whatever is within the cone and far enough is shaded.
    pub is_cone: bool,
    pub is_bound: bool,
    /// How many nodes to go on by where it is missed.
    pub skip: u16,
    /// The solid's number.
    pub number: u16,
    /// Whether the lamp is inside.
    pub around_lamp: bool,
    /// The lamp seen from the centre.
    pub from_lamp: Vec3A,
    /// The radius squared, less what rounding can add to the discriminant of a ray that leaves the sphere; where the
    /// lamp is inside, more by as much.
    pub r2: f32,
}

/// More than the square of any chord of the sphere of radius 1.
const ALL_AROUND: f32 = 5.0;

impl Lamp {
    pub const NONE: Self = Self {
        position: Vec3A::ZERO,
        colour: Vec3A::ZERO,
        is_plain: false,
        casters: [Caster::NONE; MAX_NODES],
    };

    /// Whether it is a point, and all solids are spheres; else [`super::Details`] know more.
    #[inline(always)]
    pub fn is_plain(&self) -> bool {
        !DETAILS || self.is_plain
    }

    /// Takes a light in, and the nodes that can shade it.
    pub fn set(&mut self, light: &Light, colour: Vec3A, has_blocks: bool, nodes: &[Node]) {
        self.position = light.place();
        self.colour = colour;
        self.is_plain = light.is_plain() && !has_blocks;
        let is_plain = self.is_plain();
        for (caster, node) in self.casters.iter_mut().zip(nodes) {
            let mut node = *node;
            if !is_plain {
                // What may be in the way, and no more.
                node.is_apart = false;
                node.radius += 0.5 * light.size;
            }
            *caster = Caster::new(self.position, &node);
        }
    }
}

impl Caster {
    const NONE: Self = Self {
        axis: Vec3A::ZERO,
        chord2: 0.0,
        from: 0.0,
        is_cone: false,
        is_bound: false,
        skip: 0,
        number: 0,
        around_lamp: false,
        from_lamp: Vec3A::ZERO,
        r2: 0.0,
    };

    fn new(position: Vec3A, node: &Node) -> Self {
        let from_lamp = position - node.centre;
        let far2 = from_lamp.length_squared();
        let around_lamp = far2 < node.r2;
        // The roundings of the sphere's place and of the way from the lamp.
        let slack2 = node.slack2 / node.slack * (node.slack + slack(from_lamp, 0.0));
        let is_cone = node.is_apart && !around_lamp;
        // A bound is wider, and shades from its nearest point on.
        let (r2, from) = if is_cone {
            (node.r2, libm::sqrtf(far2 - node.r2))
        } else {
            let wide = node.radius * (1.0 + MARGIN) + slack(from_lamp, 0.0);
            (wide * wide, libm::sqrtf(far2) * (1.0 - MARGIN) - wide)
        };
        // 2 - 2 cos, by the sine of the angle, which loses no digits.
        let sine2 = r2 / far2;
        let chord2 = if sine2 < 1.0 {
            2.0 * sine2 / (1.0 + libm::sqrtf(1.0 - sine2))
        } else {
            ALL_AROUND
        };
        Self {
            axis: from_lamp.normalize_or(Vec3A::Y),
            chord2,
            from,
            is_cone,
            is_bound: node.is_bound,
            skip: node.skip,
            number: node.number,
            around_lamp,
            from_lamp,
            r2: node.r2 + if around_lamp { slack2 } else { -slack2 },
        }
    }
}
