//! Spheres, boxes and cylinders that stand in rows, and how they move.

use super::Set;
use super::material;
use crate::maths::{cos, round, sin, smooth_step};
use crate::scene::{Block, Material, Scene, Sphere};
use core::f32::consts::TAU;
use glam::{Mat3A, Vec3A, vec3a};

/// Some things alike.
struct Prop {
    shape: Shape,
    material: &'static Material,
    /// What every other one along x is made of.
    every_other: &'static Material,
    motion: Motion,
    /// The centre of the first one, in scene units.
    centre: Vec3A,
    /// The extent along its own axes, in scene units; of a sphere, the diameter.
    size: Vec3A,
    /// How many side by side along x, and of these rows along z.
    count: [u8; 2],
    /// From each to the next along x, and from row to row along z.
    spacing: [f32; 2],
}

#[derive(Clone, Copy)]
enum Shape {
    Ball,
    Box,
    /// Stands on an end.
    Cylinder,
}

#[derive(Clone, Copy)]
enum Motion {
    Still,
    /// Floats up and down, by a phase in radians.
    Bouncing {
        phase: f32,
    },
    /// Strikes, each of a row on its own beat of the bar.
    Striking,
    /// Blocks on a wheel about z, so far from the axle. The wheel makes a quarter of a turn on each beat, in a jerk.
    Turning {
        radius: f32,
    },
    /// Spheres on a wheel about y, so far from its middle, slowly.
    Circling {
        radius: f32,
    },
}

use Motion::{Bouncing, Circling, Striking, Turning};

#[rustfmt::skip]
static MODEL: [Prop; 4] = [
    ball(&material::RED, [-2.2, 1.0, 0.5], 2.0),
    ball(&material::MIRROR, [0.0, 1.2, 1.8], 2.4),
    ball(&material::BLUE, [2.2, 1.0, 0.3], 2.0),
    ball(&material::GLASS, [0.6, 0.5, -1.6], 1.0).moving(Bouncing { phase: 0.0 }),
];

#[rustfmt::skip]
static COLONNADE: [Prop; 8] = [
    // Columns from the floor up, and the beams on them.
    cuboid(&material::MARBLE, [-2.6, 0.2, -6.0], [1.5, 0.4, 1.5]).repeat([2, 7], [5.2, 3.2]),
    cylinder(&material::MARBLE, [-2.6, 2.7, -6.0], [0.9, 4.6, 0.9]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.2, -6.0], [1.4, 0.4, 1.4]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.7, -2.6], [1.1, 0.6, 11.2]).repeat([2, 2], [5.2, 11.2]),
    // What floats between them.
    ball(&material::CRYSTAL, [0.0, 1.7, 6.0], 1.8).moving(Bouncing { phase: 0.0 }),
    ball(&material::GOLD, [-0.9, 0.7, 1.4], 1.0).moving(Bouncing { phase: 1.0 }),
    ball(&material::SCARLET, [0.9, 1.0, 3.2], 0.9).moving(Bouncing { phase: 2.0 }),
    ball(&material::SILVER, [-0.2, 3.2, 9.0], 1.4).moving(Bouncing { phase: 3.0 }),
];

#[rustfmt::skip]
static MACHINE: [Prop; 9] = [
    // The wheel: axle, hub, spokes, rim.
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.4, 0.4, 5.2]).moving(Turning { radius: 0.0 }),
    ball(&material::GOLD, [0.0, 2.2, 1.2], 1.2),
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.2, 1.7, 0.2]).repeat([8, 1], [0.0, 0.0]).moving(Turning { radius: 1.0 }),
    cuboid(&material::SCARLET, [0.0, 2.2, 1.2], [1.2, 0.3, 0.6]).repeat([8, 1], [0.0, 0.0]).alternating(&material::GOLD).moving(Turning { radius: 1.9 }),
    // The frame it is in.
    cuboid(&material::STRIPED, [-3.4, 2.1, 1.2], [0.7, 4.2, 1.2]).repeat([2, 1], [6.8, 0.0]),
    ball(&material::GOLD, [-3.4, 4.6, 1.2], 1.0).repeat([2, 1], [6.8, 0.0]),
    // Pistons: anvils, heads, rods.
    cuboid(&material::STEEL, [-2.2, 0.3, -1.6], [1.1, 0.6, 1.1]).repeat([4, 1], [1.5, 0.0]),
    cylinder(&material::SCARLET, [-2.2, 0.9, -1.6], [0.8, 0.6, 0.8]).repeat([4, 1], [1.5, 0.0]).alternating(&material::GOLD).moving(Striking),
    cylinder(&material::STEEL, [-2.2, 2.2, -1.6], [0.3, 2.0, 0.3]).repeat([4, 1], [1.5, 0.0]).moving(Striking),
];

#[rustfmt::skip]
static FINALE: [Prop; 2] = [
    // A ball of glass, and balls around it.
    ball(&material::GLASS, [0.0, 1.3, 0.0], 2.6),
    ball(&material::SCARLET, [0.0, 0.4, 0.0], 0.8).repeat([8, 1], [0.0, 0.0]).alternating(&material::GOLD).moving(Circling { radius: 3.2 }),
];

/// A ball of a diameter.
const fn ball(material: &'static Material, centre: [f32; 3], diameter: f32) -> Prop {
    prop(
        Shape::Ball,
        material,
        centre,
        [diameter, diameter, diameter],
    )
}

/// A box of an extent.
const fn cuboid(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Box, material, centre, size)
}

/// A cylinder of an extent.
const fn cylinder(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Cylinder, material, centre, size)
}

/// One thing that stands still.
const fn prop(shape: Shape, material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    Prop {
        shape,
        material,
        every_other: material,
        motion: Motion::Still,
        centre: Vec3A::from_array(centre),
        size: Vec3A::from_array(size),
        count: [1, 1],
        spacing: [0.0, 0.0],
    }
}

/// Adds the props of a set to a scene as they are so many beats after its begin.
pub(super) fn add(set: Set, beat: f32, scene: &mut Scene) {
    let props: &[Prop] = match set {
        Set::Model => &MODEL,
        Set::Colonnade => &COLONNADE,
        Set::Machine => &MACHINE,
        Set::Finale => &FINALE,
        Set::Title | Set::Swarm => &[],
    };
    for prop in props {
        let [columns, rows] = prop.count;
        for row in 0..rows {
            for column in 0..columns {
                prop.add(column, row, beat, scene);
            }
        }
    }
}

impl Prop {
    /// The same, so many along x and z, so far apart.
    const fn repeat(self, count: [u8; 2], spacing: [f32; 2]) -> Self {
        Self {
            count,
            spacing,
            ..self
        }
    }

    /// The same, but for the material of every other one along x.
    const fn alternating(self, every_other: &'static Material) -> Self {
        Self {
            every_other,
            ..self
        }
    }

    /// The same, in motion.
    const fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// Adds one of them.
    fn add(&self, column: u8, row: u8, beat: f32, scene: &mut Scene) {
        let number = f32::from(column);
        let [dx, dz] = self.spacing;
        let mut centre = self.centre + vec3a(number * dx, 0.0, f32::from(row) * dz);
        let mut axes = Mat3A::IDENTITY;
        match self.motion {
            Motion::Still => {}
            Bouncing { phase } => {
                let sine = sin(beat * 0.5 + phase);
                centre.y += 0.4 * sine * sine;
            }
            Striking => {
                let since = beat + 4.0 - number;
                let since = since - 4.0 * whole(since * 0.25);
                // Down at once, up in three beats.
                centre.y += 0.9 * (smooth_step(since / 3.0) - smooth_step((since - 3.75) * 4.0));
            }
            Turning { radius } => {
                let whole = whole(beat);
                let turns = number * 0.125 + 0.25 * (whole + smooth_step((beat - whole) * 1.6));
                let out = around(turns);
                let up = vec3a(-out.x, out.z, 0.0);
                axes = Mat3A::from_cols(vec3a(out.z, out.x, 0.0), up, Vec3A::Z);
                centre += up * radius;
            }
            Circling { radius } => centre += around(number * 0.125 + beat * 0.02) * radius,
        }
        let material = if column.is_multiple_of(2) {
            *self.material
        } else {
            *self.every_other
        };
        let half = self.size * 0.5;
        if let Shape::Ball = self.shape {
            scene.spheres.push(Sphere {
                centre,
                radius: half.x,
                material,
            });
        } else {
            scene.blocks.push(Block {
                centre,
                half,
                axes,
                round: matches!(self.shape, Shape::Cylinder),
                material,
            });
        }
    }
}

/// The level direction that makes so many turns from the z axis to the x axis.
pub(super) fn around(turns: f32) -> Vec3A {
    vec3a(sin(TAU * turns), 0.0, cos(TAU * turns))
}

/// The whole beats of a time, and one less at the beat itself, when all that is done on it is about to begin: for times
/// between half beats it is the floor, and there a tie rounds to even.
fn whole(beat: f32) -> f32 {
    round(beat - 0.5)
}
