//! Spheres, boxes and cylinders that stand in rows, and how they move. Coordinates are the scene's.

use super::Set;
use super::material;
use crate::maths::{cos, round, sin, smooth_step};
use crate::scene::{self, Block, Material, Scene, Sphere};
use core::f32::consts::TAU;
use glam::{Mat3A, Vec3A, vec3a};

/// One object, or a grid of objects that are alike.
struct Prop {
    shape: Shape,
    material: &'static Material,
    /// The material of every other object along x.
    every_other: &'static Material,
    motion: Motion,
    /// The centre of the first object, in scene units.
    centre: Vec3A,
    /// The extent along the object's own axes, in scene units. A sphere's three extents are its diameter.
    size: Vec3A,
    /// The number of objects along x, and of such rows along z.
    count: [u8; 2],
    /// The distance between neighbours along x and along z, in scene units.
    spacing: [f32; 2],
}

#[derive(Clone, Copy)]
enum Shape {
    Sphere,
    Block(scene::Shape),
}

#[derive(Clone, Copy)]
enum Motion {
    Still,
    /// Floats up and down; `phase` is in radians.
    Bouncing {
        phase: f32,
    },
    /// Strikes down on the beat; the objects of a row take turns, one on each beat of the bar.
    Striking,
    /// Sits on a wheel about the z axis at `radius` scene units from the axle, eight objects to a full circle. The wheel jerks
    /// on by a quarter of a turn on each beat.
    Turning {
        radius: f32,
    },
    /// Circles slowly about the y axis at `radius` scene units from it, eight objects to a full circle.
    Circling {
        radius: f32,
    },
}

use Motion::{Bouncing, Circling, Striking, Turning};

#[rustfmt::skip]
static MODEL: [Prop; 4] = [
    sphere(&material::RED, [-2.2, 1.0, 0.5], 2.0),
    sphere(&material::MIRROR, [0.0, 1.2, 1.8], 2.4),
    sphere(&material::BLUE, [2.2, 1.0, 0.3], 2.0),
    sphere(&material::GLASS, [0.6, 0.5, -1.6], 1.0).moving(Bouncing { phase: 0.0 }),
];

#[rustfmt::skip]
static COLONNADE: [Prop; 8] = [
    // The columns: plinths, shafts, capitals, and the beams on them.
    cuboid(&material::MARBLE, [-2.6, 0.2, -6.0], [1.5, 0.4, 1.5]).repeat([2, 7], [5.2, 3.2]),
    cylinder(&material::MARBLE, [-2.6, 2.7, -6.0], [0.9, 4.6, 0.9]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.2, -6.0], [1.4, 0.4, 1.4]).repeat([2, 7], [5.2, 3.2]),
    cuboid(&material::MARBLE, [-2.6, 5.7, -2.6], [1.1, 0.6, 11.2]).repeat([2, 2], [5.2, 11.2]),
    // Spheres that float between the columns.
    sphere(&material::CRYSTAL, [0.0, 1.7, 6.0], 1.8).moving(Bouncing { phase: 0.0 }),
    sphere(&material::GOLD, [-0.9, 0.7, 1.4], 1.0).moving(Bouncing { phase: 1.0 }),
    sphere(&material::SCARLET, [0.9, 1.0, 3.2], 0.9).moving(Bouncing { phase: 2.0 }),
    sphere(&material::SILVER, [-0.2, 3.2, 9.0], 1.4).moving(Bouncing { phase: 3.0 }),
];

#[rustfmt::skip]
static MACHINE: [Prop; 9] = [
    // The wheel: axle, hub, spokes, rim.
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.4, 0.4, 5.2]).moving(Turning { radius: 0.0 }),
    sphere(&material::GOLD, [0.0, 2.2, 1.2], 1.2),
    cuboid(&material::STEEL, [0.0, 2.2, 1.2], [0.2, 1.7, 0.2]).copies(8).moving(Turning { radius: 1.0 }),
    cuboid(&material::SCARLET, [0.0, 2.2, 1.2], [1.2, 0.3, 0.6]).copies(8).alternating(&material::GOLD).moving(Turning { radius: 1.9 }),
    // The posts that carry the axle, each with a knob.
    cuboid(&material::STRIPED, [-3.4, 2.1, 1.2], [0.7, 4.2, 1.2]).repeat([2, 1], [6.8, 0.0]),
    sphere(&material::GOLD, [-3.4, 4.6, 1.2], 1.0).repeat([2, 1], [6.8, 0.0]),
    // The pistons: anvils, heads, rods.
    cuboid(&material::STEEL, [-2.2, 0.3, -1.6], [1.1, 0.6, 1.1]).repeat([4, 1], [1.5, 0.0]),
    cylinder(&material::SCARLET, [-2.2, 0.9, -1.6], [0.8, 0.6, 0.8]).repeat([4, 1], [1.5, 0.0]).alternating(&material::GOLD).moving(Striking),
    cylinder(&material::STEEL, [-2.2, 2.2, -1.6], [0.3, 2.0, 0.3]).repeat([4, 1], [1.5, 0.0]).moving(Striking),
];

#[rustfmt::skip]
static FINALE: [Prop; 2] = [
    // A large glass sphere, and small spheres that circle it.
    sphere(&material::GLASS, [0.0, 1.3, 0.0], 2.6),
    sphere(&material::SCARLET, [0.0, 0.4, 0.0], 0.8).copies(8).alternating(&material::GOLD).moving(Circling { radius: 3.2 }),
];

/// A sphere.
const fn sphere(material: &'static Material, centre: [f32; 3], diameter: f32) -> Prop {
    let size = [diameter, diameter, diameter];
    prop(Shape::Sphere, material, centre, size)
}

/// A box, aligned with the scene's axes.
const fn cuboid(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Block(scene::Shape::Box), material, centre, size)
}

/// An upright cylinder.
const fn cylinder(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Block(scene::Shape::Cylinder), material, centre, size)
}

/// One object that does not move.
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

/// Adds a set's props to the scene, as they are `beat` beats after the set's first bar.
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
    /// The same objects in a grid: `count` along x and z, `spacing` scene units apart.
    const fn repeat(self, count: [u8; 2], spacing: [f32; 2]) -> Self {
        Self {
            count,
            spacing,
            ..self
        }
    }

    /// Several objects in one position, which their motion spreads out.
    const fn copies(self, count: u8) -> Self {
        self.repeat([count, 1], [0.0, 0.0])
    }

    /// The same objects with another material for every other one along x.
    const fn alternating(self, every_other: &'static Material) -> Self {
        Self {
            every_other,
            ..self
        }
    }

    /// The same objects, in motion.
    const fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// Adds the object in a column and a row of the grid.
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
                // Up in the three beats after the strike, down in the last quarter before the next.
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
        match self.shape {
            Shape::Sphere => scene.spheres.push(Sphere {
                centre,
                radius: half.x,
                material,
            }),
            Shape::Block(shape) => scene.blocks.push(Block {
                centre,
                half,
                axes,
                shape,
                material,
            }),
        };
    }
}

/// The horizontal direction at an angle, in turns, from the z axis towards the x axis.
pub(super) fn around(turns: f32) -> Vec3A {
    vec3a(sin(TAU * turns), 0.0, cos(TAU * turns))
}

/// The floor of a time in beats, but one less on the beat itself, when the movement that it triggers is about to begin; a tie
/// half-way between two beats rounds to even.
fn whole(beat: f32) -> f32 {
    round(beat - 0.5)
}
