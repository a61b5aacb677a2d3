//! Spheres, boxes and cylinders that stand in rows, and how they move. Coordinates are the scene's.

use crate::maths::{cos, round, sin, smooth_step};
use crate::scene::{self, Block, Material, Scene, Sphere};
use core::f32::consts::TAU;
use glam::{Mat3A, Vec3A, vec3a};

/// One object, or a grid of objects that are alike.
pub(super) struct Prop {
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
pub(super) enum Motion {
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

/// A sphere.
pub(super) const fn sphere(material: &'static Material, centre: [f32; 3], diameter: f32) -> Prop {
    let size = [diameter, diameter, diameter];
    prop(Shape::Sphere, material, centre, size)
}

/// A box, aligned with the scene's axes.
pub(super) const fn cuboid(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Block(scene::Shape::Box), material, centre, size)
}

/// An upright cylinder.
pub(super) const fn cylinder(
    material: &'static Material,
    centre: [f32; 3],
    size: [f32; 3],
) -> Prop {
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

impl Prop {
    /// The same objects in a grid: `count` along x and z, `spacing` scene units apart.
    pub const fn repeat(self, count: [u8; 2], spacing: [f32; 2]) -> Self {
        Self {
            count,
            spacing,
            ..self
        }
    }

    /// Several objects in one position, which their motion spreads out.
    pub const fn copies(self, count: u8) -> Self {
        self.repeat([count, 1], [0.0, 0.0])
    }

    /// The same objects with another material for every other one along x.
    pub const fn alternating(self, every_other: &'static Material) -> Self {
        Self {
            every_other,
            ..self
        }
    }

    /// The same objects, in motion.
    pub const fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    /// Adds the objects to a scene, as they are `beat` beats after the set was first shown.
    pub fn add_all(&self, beat: f32, scene: &mut Scene) {
        let [columns, rows] = self.count;
        for row in 0..rows {
            for column in 0..columns {
                self.add(column, row, beat, scene);
            }
        }
    }

    /// Adds the object in a column and a row of the grid.
    fn add(&self, column: u8, row: u8, beat: f32, scene: &mut Scene) {
        let number = f32::from(column);
        let [dx, dz] = self.spacing;
        let mut centre = self.centre + vec3a(number * dx, 0.0, f32::from(row) * dz);
        let mut axes = Mat3A::IDENTITY;
        match self.motion {
            Motion::Still => {}
            Motion::Bouncing { phase } => {
                let sine = sin(beat * 0.5 + phase);
                centre.y += 0.4 * sine * sine;
            }
            Motion::Striking => {
                let since = beat + 4.0 - number;
                let since = since - 4.0 * whole(since * 0.25);
                // Up in the three beats after the strike, down in the last quarter before the next.
                centre.y += 0.9 * (smooth_step(since / 3.0) - smooth_step((since - 3.75) * 4.0));
            }
            Motion::Turning { radius } => {
                let whole = whole(beat);
                let turns = number * 0.125 + 0.25 * (whole + smooth_step((beat - whole) * 1.6));
                let out = around(turns);
                let up = vec3a(-out.x, out.z, 0.0);
                axes = Mat3A::from_cols(vec3a(out.z, out.x, 0.0), up, Vec3A::Z);
                centre += up * radius;
            }
            Motion::Circling { radius } => centre += around(number * 0.125 + beat * 0.02) * radius,
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
