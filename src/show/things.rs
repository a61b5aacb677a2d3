//! Spheres, boxes and cylinders that stand in rows, and how they move.

use super::Set;
use super::material::{self, Stuff};
use super::path::smooth;
use super::steps::{TENTHS, TWENTIETHS, at, half, number, steps, vector};
use crate::scene::{Scene, Sphere};
use crate::trigonometry::{cos, sin};
use core::f32::consts::TAU;
use glam::{Mat3A, Vec3A};

/// Some things alike, in bytes.
struct Row {
    set: Set,
    shape: Shape,
    motion: Motion,
    stuff: Stuff,
    /// Centre of the first one.
    centre: [i8; 3],
    /// Half its extent along its own axes; of a sphere the radius.
    half: [i8; 3],
    /// How many side by side along x, and from each to the next, in tenths.
    columns: (u8, i8),
    /// The same along z.
    rows: (u8, i8),
}

#[derive(Clone, Copy, PartialEq)]
enum Shape {
    Sphere,
    Box,
    /// A cylinder that stands on an end.
    Round,
}

#[derive(Clone, Copy)]
enum Motion {
    Still,
    /// Its y axis is along z.
    Lying,
    /// Bounces, later by what it would be from row to row.
    Floating,
    /// Strikes, each on its own beat of the bar.
    Striking,
    /// On a wheel about z, as far from the axle as it would be from row to row.
    Turning,
    /// The same about y.
    Circling,
}

use Motion::*;
use Shape::{Box, Round};

#[rustfmt::skip]
static ROWS: [Row; 24] = [
    row(Set::Model, Shape::Sphere, Still,    Stuff::Red,    at(-2.2, 1.0, 0.5), half(1.0, 0.0, 0.0), (1, 0.0), (1, 0.0)),
    row(Set::Model, Shape::Sphere, Still,    Stuff::Mirror, at(0.0, 1.2, 1.8),  half(1.2, 0.0, 0.0), (1, 0.0), (1, 0.0)),
    row(Set::Model, Shape::Sphere, Still,    Stuff::Blue,   at(2.2, 1.0, 0.3),  half(1.0, 0.0, 0.0), (1, 0.0), (1, 0.0)),
    row(Set::Model, Shape::Sphere, Floating, Stuff::Glass,  at(0.6, 0.5, -1.6), half(0.5, 0.0, 0.0), (1, 0.0), (1, 0.0)),
    // Columns from the floor up, and the beams on them.
    row(Set::Colonnade, Box,   Still, Stuff::Marble, at(-2.6, 0.1, -6.0), half(0.75, 0.2, 0.75),  (2, 5.2), (7, 3.2)),
    row(Set::Colonnade, Round, Still, Stuff::Marble, at(-2.6, 0.4, -6.0), half(0.6, 0.1, 0.6),    (2, 5.2), (7, 3.2)),
    row(Set::Colonnade, Round, Still, Stuff::Marble, at(-2.6, 2.7, -6.0), half(0.45, 2.2, 0.45),  (2, 5.2), (7, 3.2)),
    row(Set::Colonnade, Box,   Still, Stuff::Marble, at(-2.6, 5.0, -6.0), half(0.7, 0.15, 0.7),   (2, 5.2), (7, 3.2)),
    row(Set::Colonnade, Box,   Still, Stuff::Marble, at(-2.6, 5.5, -2.6), half(0.55, 0.35, 5.6),  (2, 5.2), (2, 11.2)),
    // What floats between them.
    row(Set::Colonnade, Shape::Sphere, Floating, Stuff::Glass,   at(0.0, 1.7, 6.0),  half(0.9, 0.0, 0.0),  (1, 0.0), (1, 0.0)),
    row(Set::Colonnade, Shape::Sphere, Floating, Stuff::Gold,    at(-0.9, 0.7, 1.4), half(0.5, 0.0, 0.0),  (1, 0.0), (1, 1.0)),
    row(Set::Colonnade, Shape::Sphere, Floating, Stuff::Scarlet, at(0.9, 1.0, 3.2),  half(0.45, 0.0, 0.0), (1, 0.0), (1, 2.0)),
    row(Set::Colonnade, Shape::Sphere, Floating, Stuff::Silver,  at(-0.2, 3.2, 9.0), half(0.7, 0.0, 0.0),  (1, 0.0), (1, 3.0)),
    // The wheel: axle, hub, spokes, rim.
    row(Set::Machine, Round, Lying,   Stuff::Steel, at(0.0, 2.2, 1.2), half(0.2, 2.6, 0.2),    (1, 0.0), (1, 0.0)),
    row(Set::Machine, Round, Lying,   Stuff::Gold,  at(0.0, 2.2, 1.2), half(0.55, 0.3, 0.55),  (1, 0.0), (1, 0.0)),
    row(Set::Machine, Box,   Turning, Stuff::Steel, at(0.0, 2.2, 1.2), half(0.1, 0.85, 0.1),   (8, 0.0), (1, 1.0)),
    row(Set::Machine, Box,   Turning, Stuff::Scarlet, at(0.0, 2.2, 1.2), half(0.6, 0.15, 0.3), (8, 0.0), (1, 1.9)),
    // The frame it is in.
    row(Set::Machine, Box,    Still, Stuff::Striped, at(-3.4, 2.0, 1.2), half(0.35, 2.0, 0.6), (2, 6.8), (1, 0.0)),
    row(Set::Machine, Shape::Sphere, Still, Stuff::Gold,    at(-3.4, 4.5, 1.2), half(0.5, 0.0, 0.0),  (2, 6.8), (1, 0.0)),
    // Pistons: anvils, heads, rods.
    row(Set::Machine, Box,   Still,    Stuff::Steel, at(-2.2, 0.2, -1.6), half(0.55, 0.3, 0.55),  (4, 1.5), (1, 0.0)),
    row(Set::Machine, Round, Striking, Stuff::Gold,  at(-2.2, 0.9, -1.6), half(0.4, 0.35, 0.4),   (4, 1.5), (1, 0.0)),
    row(Set::Machine, Round, Striking, Stuff::Steel, at(-2.2, 2.2, -1.6), half(0.15, 1.0, 0.15),  (4, 1.5), (1, 0.0)),
    // A ball of glass, and balls around it.
    row(Set::Finale, Shape::Sphere, Still,    Stuff::Glass,   at(0.0, 1.3, 0.0), half(1.3, 0.0, 0.0), (1, 0.0), (1, 0.0)),
    row(Set::Finale, Shape::Sphere, Circling, Stuff::Scarlet, at(0.0, 0.4, 0.0), half(0.4, 0.0, 0.0), (8, 0.0), (1, 3.2)),
];

#[allow(clippy::too_many_arguments, reason = "columns of a table")]
const fn row(
    set: Set,
    shape: Shape,
    motion: Motion,
    stuff: Stuff,
    centre: [i8; 3],
    half: [i8; 3],
    columns: (u8, f32),
    rows: (u8, f32),
) -> Row {
    Row {
        set,
        shape,
        motion,
        stuff,
        centre,
        half,
        columns: (columns.0, steps(columns.1, TENTHS)),
        rows: (rows.0, steps(rows.1, TENTHS)),
    }
}

/// Adds the things of a set to a scene as they are so many beats after its begin.
pub(super) fn add(set: Set, beat: f32, scene: &mut Scene) {
    for row in ROWS.iter().filter(|row| row.set == set) {
        for line in 0..row.rows.0 {
            for column in 0..row.columns.0 {
                row.add(f32::from(column), f32::from(line), beat, scene);
            }
        }
    }
}

impl Row {
    /// Adds one of them.
    #[inline(always)]
    fn add(&self, column: f32, line: f32, beat: f32, scene: &mut Scene) {
        let (dx, dz) = (number(self.columns.1, TENTHS), number(self.rows.1, TENTHS));
        let mut centre = vector(self.centre, TENTHS) + Vec3A::new(column * dx, 0.0, line * dz);
        let mut axes = Mat3A::IDENTITY;
        match self.motion {
            Still => {}
            Lying => axes = Mat3A::from_cols(Vec3A::X, Vec3A::Z, Vec3A::NEG_Y),
            Floating => {
                let sine = sin(beat * 0.5 + dz);
                centre.y += 0.4 * sine * sine;
            }
            Striking => {
                let since = beat + 4.0 - column;
                let since = since - 4.0 * whole(since * 0.25);
                // Down at once, up in three beats.
                centre.y += 0.9 * (smooth(since / 3.0) - smooth((since - 3.75) * 4.0));
            }
            Turning => {
                let whole = whole(beat);
                // A quarter of a turn on each beat, in a jerk.
                let turns = 0.25 * (whole + smooth((beat - whole) * 1.6));
                let (s, c) = self.angle(column, turns);
                axes = Mat3A::from_cols(Vec3A::new(c, s, 0.0), Vec3A::new(-s, c, 0.0), Vec3A::Z);
                centre += axes.y_axis * dz;
            }
            Circling => {
                let (s, c) = self.angle(column, beat * 0.02);
                centre += Vec3A::new(s, 0.0, c) * dz;
            }
        }
        let is_odd = column as i32 & 1 != 0;
        let stuff = if is_odd && self.stuff == Stuff::Scarlet {
            Stuff::Gold
        } else {
            self.stuff
        };
        let half = vector(self.half, TWENTIETHS);
        if self.shape == Shape::Sphere {
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

    /// Sine and cosine of the angle of one on a wheel that has made so many turns.
    #[inline(never)]
    fn angle(&self, column: f32, turns: f32) -> (f32, f32) {
        let angle = TAU * (column / f32::from(self.columns.0) + turns);
        (sin(angle), cos(angle))
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

/// The whole beats of a time.
fn whole(beat: f32) -> f32 {
    (beat as i32) as f32
}
