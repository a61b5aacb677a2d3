//! Lights as shadow rays want them.

use super::slack;
use super::tree::{MARGIN, MAX_NODES, Node};
use glam::Vec3A as Vec3;

/// A point light.
pub(crate) struct Lamp {
    pub position: Vec3,
    pub colour: Vec3,
    /// The solid nodes of the [`super::Tree`].
    pub casters: [Caster; MAX_NODES],
}

/// A sphere as shadow rays want it: what it shades of points without is in the cone around it and farther away than where
/// the cone touches it.
#[derive(Clone, Copy)]
pub(crate) struct Caster {
    /// The lamp's direction, seen from the centre.
    pub axis: Vec3,
    /// The square of the chord between the axis and the cone's side on the sphere of radius 1.
    pub chord2: f32,
    /// Nothing nearer to the lamp than this is shaded.
    pub from: f32,
    /// Whether the cone is all that there is to know: whatever is within the cone and far enough is shaded.
    pub is_cone: bool,
    pub is_bound: bool,
    /// How many nodes to go on by where it is missed.
    pub skip: u16,
    /// Whether the lamp is inside.
    pub around_lamp: bool,
    /// The lamp seen from the centre.
    pub from_lamp: Vec3,
    /// The radius squared, less what rounding can add to the discriminant of a ray that leaves the sphere; where the
    /// lamp is inside, more by as much.
    pub r2: f32,
}

/// More than the square of any chord of the sphere of radius 1.
const ALL_AROUND: f32 = 5.0;

impl Lamp {
    pub const NONE: Self = Self {
        position: Vec3::ZERO,
        colour: Vec3::ZERO,
        casters: [Caster::NONE; MAX_NODES],
    };

    /// Takes a light in, and the nodes that can shade it.
    pub fn set(&mut self, position: Vec3, colour: Vec3, nodes: &[Node]) {
        self.position = position;
        self.colour = colour;
        for (caster, node) in self.casters.iter_mut().zip(nodes) {
            *caster = Caster::new(position, node);
        }
    }
}

impl Caster {
    const NONE: Self = Self {
        axis: Vec3::ZERO,
        chord2: 0.0,
        from: 0.0,
        is_cone: false,
        is_bound: false,
        skip: 0,
        around_lamp: false,
        from_lamp: Vec3::ZERO,
        r2: 0.0,
    };

    fn new(position: Vec3, node: &Node) -> Self {
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
            axis: from_lamp.normalize_or(Vec3::Y),
            chord2,
            from,
            is_cone,
            is_bound: node.is_bound,
            skip: node.skip,
            around_lamp,
            from_lamp,
            r2: node.r2 + if around_lamp { slack2 } else { -slack2 },
        }
    }
}
