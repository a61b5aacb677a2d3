//! Spheres, boxes and cylinders that stand in rows, and how they move.

use super::Set;
use super::material::{self, Stuff};
use super::path::smooth;
use super::steps::{TENTHS, numbers, steps};
use crate::scene::{Scene, Sphere};
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::{Mat3A, Vec3A, vec3a};

/// Some things alike.
struct Row {
    set: Set,
    shape: Shape,
    motion: Motion,
    stuff: Stuff,
    /// How many side by side along x, and of these rows along z.
    columns: u8,
    rows: u8,
    /// In tenths: the first one's centre, the extent along its own axes (of a sphere the diameter is the first), and from
    /// each to the next along x and along z.
    numbers: [i8; 8],
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Ball,
    Box,
    /// A cylinder that stands on an end.
    Round,
}

#[derive(Clone, Copy)]
enum Motion {
    Still,
    /// Bounces, later by what it would be from row to row.
    Bouncing,
    /// Strikes, each on its own beat of the bar.
    Striking,
    /// Blocks: on a wheel about z, as far from the axle as it would be from row to row. The wheel makes a quarter of a turn on each
    /// beat, in a jerk.
    Turning,
    /// Spheres: on a wheel about y, slowly.
    Circling,
}

use Motion::*;
use Shape::{Ball, Box, Round};

#[rustfmt::skip]
static ROWS: [Row; 23] = [
    //                                          columns, rows  centre       extents          to the next
    row(Set::Model, Ball, Still,    Stuff::Red,    1, 1, [-2.2, 1.0, 0.5,   2.0, 0.0, 0.0,   0.0, 0.0]),
    row(Set::Model, Ball, Still,    Stuff::Mirror, 1, 1, [0.0, 1.2, 1.8,    2.4, 0.0, 0.0,   0.0, 0.0]),
    row(Set::Model, Ball, Still,    Stuff::Blue,   1, 1, [2.2, 1.0, 0.3,    2.0, 0.0, 0.0,   0.0, 0.0]),
    row(Set::Model, Ball, Bouncing, Stuff::Glass,  1, 1, [0.6, 0.5, -1.6,   1.0, 0.0, 0.0,   0.0, 0.0]),
    // Columns from the floor up, and the beams on them.
    row(Set::Colonnade, Box,   Still, Stuff::Marble, 2, 7, [-2.6, 0.2, -6.0,  1.5, 0.4, 1.5,   5.2, 3.2]),
    row(Set::Colonnade, Round, Still, Stuff::Marble, 2, 7, [-2.6, 2.7, -6.0,  0.9, 4.6, 0.9,   5.2, 3.2]),
    row(Set::Colonnade, Box,   Still, Stuff::Marble, 2, 7, [-2.6, 5.2, -6.0,  1.4, 0.4, 1.4,   5.2, 3.2]),
    row(Set::Colonnade, Box,   Still, Stuff::Marble, 2, 2, [-2.6, 5.7, -2.6,  1.1, 0.6, 11.2,  5.2, 11.2]),
    // What floats between them.
    row(Set::Colonnade, Ball, Bouncing, Stuff::Crystal, 1, 1, [0.0, 1.7, 6.0,   1.8, 0.0, 0.0,  0.0, 0.0]),
    row(Set::Colonnade, Ball, Bouncing, Stuff::Gold,    1, 1, [-0.9, 0.7, 1.4,  1.0, 0.0, 0.0,  0.0, 1.0]),
    row(Set::Colonnade, Ball, Bouncing, Stuff::Scarlet, 1, 1, [0.9, 1.0, 3.2,   0.9, 0.0, 0.0,  0.0, 2.0]),
    row(Set::Colonnade, Ball, Bouncing, Stuff::Silver,  1, 1, [-0.2, 3.2, 9.0,  1.4, 0.0, 0.0,  0.0, 3.0]),
    // The wheel: axle, hub, spokes, rim.
    row(Set::Machine, Box,  Turning, Stuff::Steel,   1, 1, [0.0, 2.2, 1.2,  0.4, 0.4, 5.2,  0.0, 0.0]),
    row(Set::Machine, Ball, Still,   Stuff::Gold,    1, 1, [0.0, 2.2, 1.2,  1.2, 0.0, 0.0,  0.0, 0.0]),
    row(Set::Machine, Box,  Turning, Stuff::Steel,   8, 1, [0.0, 2.2, 1.2,  0.2, 1.7, 0.2,  0.0, 1.0]),
    row(Set::Machine, Box,  Turning, Stuff::Scarlet, 8, 1, [0.0, 2.2, 1.2,  1.2, 0.3, 0.6,  0.0, 1.9]),
    // The frame it is in.
    row(Set::Machine, Box,  Still, Stuff::Striped, 2, 1, [-3.4, 2.1, 1.2,  0.7, 4.2, 1.2,  6.8, 0.0]),
    row(Set::Machine, Ball, Still, Stuff::Gold,    2, 1, [-3.4, 4.6, 1.2,  1.0, 0.0, 0.0,  6.8, 0.0]),
    // Pistons: anvils, heads, rods.
    row(Set::Machine, Box,   Still,    Stuff::Steel, 4, 1, [-2.2, 0.3, -1.6,  1.1, 0.6, 1.1,  1.5, 0.0]),
    row(Set::Machine, Round, Striking, Stuff::Scarlet, 4, 1, [-2.2, 0.9, -1.6,  0.8, 0.6, 0.8,  1.5, 0.0]),
    row(Set::Machine, Round, Striking, Stuff::Steel, 4, 1, [-2.2, 2.2, -1.6,  0.3, 2.0, 0.3,  1.5, 0.0]),
    // A ball of glass, and balls around it.
    row(Set::Finale, Ball, Still,    Stuff::Glass,   1, 1, [0.0, 1.3, 0.0,  2.6, 0.0, 0.0,  0.0, 0.0]),
    row(Set::Finale, Ball, Circling, Stuff::Scarlet, 8, 1, [0.0, 0.4, 0.0,  0.8, 0.0, 0.0,  0.0, 3.2]),
];

const fn row(
    set: Set,
    shape: Shape,
    motion: Motion,
    stuff: Stuff,
    columns: u8,
    rows: u8,
    numbers: [f32; 8],
) -> Row {
    Row {
        set,
        shape,
        motion,
        stuff,
        columns,
        rows,
        numbers: steps(numbers, TENTHS),
    }
}

/// Adds the things of a set to a scene as they are so many beats after its begin.
#[inline(never)]
pub(super) fn add(set: Set, beat: f32, scene: &mut Scene) {
    for row in &ROWS {
        if row.set != set {
            continue;
        }
        for line in 0..row.rows {
            for column in 0..row.columns {
                row.add(column, line, beat, scene);
            }
        }
    }
}

impl Row {
    /// Adds one of them.
    #[inline(never)]
    fn add(&self, column: u8, line: u8, beat: f32, scene: &mut Scene) {
        let [x, y, z, width, height, depth, dx, dz, ..] = numbers(&self.numbers, TENTHS);
        let half = vec3a(width, height, depth) * 0.5;
        let number = f32::from(column);
        let mut centre = vec3a(x + number * dx, y, z + f32::from(line) * dz);
        let mut turns = 0.0;
        match self.motion {
            Still => {}
            Bouncing => {
                let sine = sin(beat * 0.5 + dz);
                centre.y += 0.4 * sine * sine;
            }
            Striking => {
                let since = beat + 4.0 - number;
                let since = since - 4.0 * whole(since * 0.25);
                // Down at once, up in three beats.
                centre.y += 0.9 * (smooth(since / 3.0) - smooth((since - 3.75) * 4.0));
            }
            Turning => {
                let whole = whole(beat);
                turns = number * 0.125 + 0.25 * (whole + smooth((beat - whole) * 1.6));
            }
            Circling => turns = number * 0.125 + beat * 0.02,
        }
        let out = around(turns);
        let up = vec3a(-out.x, out.z, 0.0);
        let axes = Mat3A::from_cols(vec3a(out.z, out.x, 0.0), up, Vec3A::Z);
        if turns > 0.0 {
            let way = if self.shape == Ball { out } else { up };
            centre += way * dz;
        }
        // Every other scarlet thing is golden.
        let stuff = if column & 1 != 0 && self.stuff == Stuff::Scarlet {
            Stuff::Gold
        } else {
            self.stuff
        };
        if self.shape == Ball {
            sphere(scene, centre, half.x, stuff);
        } else {
            let block = scene.blocks.grow();
            block.centre = centre;
            block.half = half;
            block.axes = axes;
            block.round = self.shape == Round;
            material::set(&mut block.material, stuff);
        }
    }
}

/// Adds a sphere.
#[inline(never)]
pub(super) fn sphere(scene: &mut Scene, centre: Vec3A, radius: f32, stuff: Stuff) -> &mut Sphere {
    let sphere = scene.spheres.grow();
    sphere.centre = centre;
    sphere.radius = radius;
    material::set(&mut sphere.material, stuff);
    sphere
}

/// The level direction that makes so many turns from the z axis to the x axis.
#[inline(never)]
pub(super) fn around(turns: f32) -> Vec3A {
    vec3a(sin(TAU * turns), 0.0, cos(TAU * turns))
}

/// The whole beats of a time before the end of the show, and one less at the beat itself, when all that is done on it is
/// about to begin.
#[inline(never)]
fn whole(beat: f32) -> f32 {
    // Adding 1.5 * 2^23 leaves the nearest whole number.
    const ROUND: f32 = 12_582_912.0;
    (beat - 0.5 + ROUND) - ROUND
}
