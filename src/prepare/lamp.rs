//! Lights as shadow rays want them.

use super::hit_error;
use super::surface::bounded;
use super::tree::{BvhNode, MARGIN, MAX_NODES};
use crate::maths::sqrt;
use crate::scene::{Light, Spot};
use glam::{Vec3, Vec3A};

/// A point light.
pub(crate) struct Lamp {
    pub position: Vec3A,
    pub colour: Vec3A,
    is_plain: bool,
    /// Whether it is a cone.
    pub is_cone: bool,
    /// Its cone, or one that is bright all around.
    pub cone: Spot,
    /// Its diameter, and the widest that a penumbra is taken to be at what throws it.
    pub diameter: f32,
    pub max_penumbra: f32,
    /// Whether it is no more than a point.
    pub is_point: bool,
    /// The solid nodes of the [`super::Tree`].
    pub shadow_cones: [ShadowCone; MAX_NODES],
}

/// A sphere as shadow rays want it: what it shades of points without is in a cone around it, a little wider than it needs
/// be, and not nearer to the lamp than it. (Its vectors are not aligned: so it is 64 bytes, and it is most of a frame's memory.)
#[derive(Clone, Copy)]
pub(crate) struct ShadowCone {
    /// The lamp's direction, seen from the centre.
    pub axis: Vec3,
    /// The square of the chord between the axis and the cone's side on the sphere of radius 1.
    pub chord2: f32,
    /// Nothing nearer to the lamp than this is shaded.
    pub from: f32,
    pub is_bound: bool,
    /// How many nodes to go on by where it is missed.
    pub skip: u16,
    /// The solid's number.
    pub number: u16,
    /// Whether the lamp is inside.
    pub around_lamp: bool,
    /// The lamp seen from the centre.
    pub from_lamp: Vec3,
    /// The radius squared, less what rounding can add to the discriminant of a ray that leaves the sphere; where the
    /// lamp is inside, more by as much.
    pub r2: f32,
    /// What a box or a cylinder shades lies between two planes through the lamp: the normal of that which holds its longer
    /// axis, of any length, and the square of the sine of the angle from there to both, as many times as large as the
    /// normal's. 0 of what is none.
    pub side: Vec3,
    pub sine2: f32,
    /// The radius, and what rounding adds to it.
    pub radius: f32,
}

/// More than rounding makes of a scalar product of directions.
const ROUNDING: f32 = 1e-6;

/// A cone that everything is well within.
const ALL_BRIGHT: Spot = Spot {
    aim: Vec3A::ZERO,
    dark: -2.0,
    bright: -1.0,
};

/// More than the square of any chord of the sphere of radius 1.
const ALL_AROUND: f32 = 5.0;

impl Lamp {
    pub const NONE: Self = Self {
        position: Vec3A::ZERO,
        colour: Vec3A::ZERO,
        is_plain: false,
        is_cone: false,
        cone: Spot {
            aim: Vec3A::ZERO,
            dark: 0.0,
            bright: 0.0,
        },
        diameter: 0.0,
        max_penumbra: 0.0,
        is_point: false,
        shadow_cones: [ShadowCone::NONE; MAX_NODES],
    };

    /// Whether it is a point, and all solids are spheres: then its shadows are hard.
    #[inline(always)]
    pub fn is_plain(&self) -> bool {
        self.is_plain
    }

    /// Takes a light in, and the nodes that can shade it.
    pub fn set(&mut self, light: &Light, nodes: &[BvhNode], has_blocks: bool) {
        self.position = light.shadow_position();
        self.colour = Vec3A::from_array(light.colour.to_array().map(bounded));
        self.is_point = light.is_point();
        self.is_plain = self.is_point && !has_blocks;
        self.is_cone = light.spot.is_some();
        self.cone = light.spot.unwrap_or(ALL_BRIGHT);
        self.diameter = light.diameter();
        // Below 0 a sphere would shade what its bound does not.
        self.max_penumbra = light.max_penumbra().max(0.0);
        for (cone, node) in self.shadow_cones.iter_mut().zip(nodes) {
            // A sphere's penumbra is wider, and a bound shades from its nearest point on.
            let radius = if !node.is_block {
                node.radius + 0.5 * self.max_penumbra
            } else {
                node.radius
            };
            cone.set(self.position - node.centre, radius, node);
        }
    }
}

impl ShadowCone {
    const NONE: Self = Self {
        axis: Vec3::ZERO,
        chord2: 0.0,
        from: 0.0,
        is_bound: false,
        skip: 0,
        number: 0,
        around_lamp: false,
        from_lamp: Vec3::ZERO,
        r2: 0.0,
        side: Vec3::ZERO,
        sine2: 0.0,
        radius: 0.0,
    };

    fn set(&mut self, from_lamp: Vec3A, radius: f32, node: &BvhNode) {
        let far2 = from_lamp.length_squared();
        // The roundings of the sphere's place and of the way from the lamp.
        let way = hit_error(from_lamp, 0.0);
        let r2_error = 2.0 * node.radius * (node.hit_error + way);
        let wide = radius * (1.0 + MARGIN) + way;
        // 2 - 2 cos, by the sine of the angle, which loses no digits.
        let sine2 = wide * wide / far2;
        let chord2 = 2.0 * sine2 / (1.0 + sqrt(1.0 - sine2));
        self.around_lamp = far2 < node.r2;
        // Nearer to the lamp than `from` there is none of it.
        let from = sqrt(far2) * (1.0 - MARGIN) - wide;
        let sine = sqrt(node.thin2) / from.max(0.0) + ROUNDING;
        let side = node.axis.cross(from_lamp);
        *self = Self {
            axis: from_lamp.normalize_or(Vec3A::Y).into(),
            // Not a number where there is no angle.
            chord2: chord2.min(ALL_AROUND),
            from,
            is_bound: node.is_bound,
            skip: node.skip,
            number: node.number,
            around_lamp: self.around_lamp,
            from_lamp: from_lamp.into(),
            side: side.into(),
            sine2: side.length_squared() * sine * sine,
            radius: node.radius * (1.0 + MARGIN) + way,
            r2: node.r2
                + if self.around_lamp {
                    r2_error
                } else {
                    -r2_error
                },
        }
    }
}
