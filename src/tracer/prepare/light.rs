use super::object::ObjectId;
use super::surface::bounded;
use super::tree::{BvhNode, MAX_NODES};
use crate::maths::{sin, smooth_step, sqrt, unit};
use crate::rounding::{BOUND, COSINE, hit_error};
use crate::scene::{Block, Light, Spot};
use glam::{Mat3A, Vec3, Vec3A};

/// A light for shading and shadow rays. Lengths are in scene units, multiplied by [`Light::far`].
pub(crate) struct PreparedLight {
    pub position: Vec3A,
    pub colour: Vec3A,
    pub is_cone: bool,
    pub cone: SpotCone,
    pub diameter: f32,
    /// The squared radius of the glow.
    pub glow2: f32,
    pub core: f32,
    pub max_penumbra: f32,
    pub is_point: bool,
    /// The first object that shadow rays list as an occluder. Spheres before it cast hard shadows:
    /// a faster test.
    pub listed_from: ObjectId,
    /// In the order of the tree's solid nodes.
    pub shadow_cones: [ShadowCone; MAX_NODES],
}

pub(crate) struct SpotCone {
    pub aim: Vec3,
    /// The squared chords of the angles on the unit sphere: their difference is exact for narrow
    /// cones, too.
    pub inner2: f32,
    pub outer2: f32,
}

impl SpotCone {
    /// All directions, with a margin.
    const ALL_BRIGHT: Self = Self { aim: Vec3::ZERO, inner2: 2.0, outer2: 3.0 };

    fn new(spot: Spot) -> Self {
        let chord2 = |angle: f32| 4.0 * sin(0.5 * angle) * sin(0.5 * angle);
        Self {
            aim: unit(spot.aim.into()).into(),
            inner2: chord2(spot.inner_angle),
            outer2: chord2(spot.outer_angle),
        }
    }

    /// Returns whether a horizontal plane gets no light. `height` is the light's height above the
    /// plane, negative below it.
    pub fn misses_plane(&self, height: f32) -> bool {
        let rise2 = self.aim.y * self.aim.y;
        // The squared chord from `aim` to the nearest horizontal direction; 2 - 2 sqrt(1 - rise2)
        // would cancel.
        let off2 = 2.0 * rise2 / (1.0 + sqrt(1.0 - rise2));
        self.aim.y * height > 0.0 && off2 >= self.outer2
    }

    /// `d` has the length 1.
    pub fn share(&self, d: Vec3A) -> f32 {
        let off2 = d.distance_squared(self.aim.into());
        smooth_step((self.outer2 - off2) / (self.outer2 - self.inner2))
    }
}

/// The shadow of a node's sphere: a cone from the light, from the sphere's near side on. Unaligned
/// vectors make it fit a cache line of 64 bytes; a frame has up to 2,316 cones.
#[derive(Clone, Copy)]
pub(crate) struct ShadowCone {
    /// The direction from the centre to the light, of length 1.
    pub axis: Vec3,
    /// The squared chord between the axis and the side of the cone, on the unit sphere; -1 without
    /// a shadow.
    pub chord2: f32,
    /// The least distance of the shadow from the light.
    pub from: f32,
    pub solids: u8,
    pub skip: u16,
    pub object: ObjectId,
    /// Whether the light is inside: the sphere shadows its outside.
    pub around_light: bool,
    pub to_light: Vec3,
    /// The squared radius minus the discriminant's rounding error (plus it if the light is inside):
    /// a ray that leaves the sphere is not in its shadow.
    pub r2: f32,
    /// A normal, of any length, of the plane through the light and the block's longer axis. The
    /// block's shadow is between two planes through the light, at equal angles to this plane.
    pub side: Vec3,
    /// The squared sine of these angles, times the squared length of `side`.
    pub sine2: f32,
    /// Enlarged for rounding.
    pub radius: f32,
}

zero! {
    PreparedLight {
        position, colour, is_cone, cone, diameter, glow2, core, max_penumbra, is_point, listed_from,
        shadow_cones
    }
    SpotCone { aim, inner2, outer2 }
    ShadowCone {
        axis, chord2, from, solids, skip, object, around_light, to_light, r2, side, sine2, radius
    }
}

/// Larger than the squared chord of any cone.
const ALL_AROUND: f32 = 5.0;

impl PreparedLight {
    pub fn set(&mut self, light: &Light, nodes: &[BvhNode], spheres: usize) {
        let far = light.far();
        self.position = Vec3A::from(light.position) * far;
        self.colour = Vec3A::from_array(light.colour.to_array().map(bounded));
        self.is_point = light.is_point();
        self.listed_from = ObjectId::new(spheres * usize::from(self.is_point));
        self.is_cone = light.spot.is_some();
        self.cone = light.spot.map_or(SpotCone::ALL_BRIGHT, SpotCone::new);
        self.diameter = light.diameter * far;
        self.glow2 = (light.glow * far) * (light.glow * far);
        self.core = light.core * far;
        // Below 0, a sphere's shadow would extend beyond its bound's shadow.
        self.max_penumbra = light.max_penumbra().max(0.0);
        for (cone, node) in self.shadow_cones.iter_mut().zip(nodes) {
            let penumbra = 0.5 * self.max_penumbra;
            cone.set(self.position, self.diameter, penumbra, node);
        }
    }

    #[inline(always)]
    pub fn is_soft_around(&self, block: &Block) -> bool {
        let own = Mat3A::from(block.axes).transpose() * (self.position - Vec3A::from(block.centre));
        self.diameter > 0.0 && own.abs().cmpgt(block.half.into()).any()
    }
}

impl ShadowCone {
    /// `penumbra` is the largest width of the penumbra outside the node.
    fn set(&mut self, light: Vec3A, diameter: f32, penumbra: f32, node: &BvhNode) {
        let (to_light, radius) = (light - node.centre, node.radius + penumbra);
        let distance2 = to_light.length_squared();
        // Rounding of the sphere's centre and of the vector to the light.
        let error = hit_error(to_light, 0.0);
        let r2_error = 2.0 * node.radius * (node.hit_error + error);
        let wide = radius * (1.0 + BOUND) + error;
        // The squared chord, 2 - 2 cos, computed from the sine loses no digits.
        let sine2 = wide * wide / distance2;
        let chord2 = 2.0 * sine2 / (1.0 + sqrt(1.0 - sine2));
        let room = node.radius - 0.5 * diameter;
        let power = diameter * (0.25 * diameter - node.radius);
        self.around_light = !node.is_block && room > 0.0 && node.power(light) < power;
        let from = sqrt(distance2) * (1.0 - BOUND) - wide;
        let sine = (sqrt(node.thin2) + penumbra) / from.max(0.0) + COSINE;
        let side = node.axis.cross(to_light);
        *self = Self {
            axis: to_light.normalize_or(Vec3A::Y).into(),
            // `min` replaces NaN: the light is inside.
            chord2: if node.is_shadowless(diameter) { -1.0 } else { chord2.min(ALL_AROUND) },
            from,
            solids: node.solids,
            skip: node.skip,
            object: node.object,
            around_light: self.around_light,
            to_light: to_light.into(),
            side: side.into(),
            sine2: side.length_squared() * sine * sine,
            radius: node.radius * (1.0 + BOUND) + error,
            r2: node.r2 + if self.around_light { r2_error } else { -r2_error },
        }
    }
}
