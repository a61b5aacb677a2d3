use core::f32::consts::TAU;
use eightfold_tracer::maths::{cos, round, sin, smooth_step};
use eightfold_tracer::scene::{self, Block, Material, Scene, Sphere};
use glam::{Mat3, Vec3, vec3};

pub(super) struct Prop {
    shape: Shape,
    material: &'static Material,
    motion: Motion,
    /// Of the first object, in scene units.
    centre: Vec3,
    /// Extents along the object's axes in scene units; a sphere's are its diameter.
    size: Vec3,
    count: [u8; 2],
    /// Along x and z, in scene units.
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
}

pub(super) const fn sphere(material: &'static Material, centre: [f32; 3], diameter: f32) -> Prop {
    let size = [diameter, diameter, diameter];
    prop(Shape::Sphere, material, centre, size)
}

pub(super) const fn cuboid(material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    prop(Shape::Block(scene::Shape::Box), material, centre, size)
}

pub(super) const fn cylinder(
    material: &'static Material,
    centre: [f32; 3],
    size: [f32; 3],
) -> Prop {
    prop(Shape::Block(scene::Shape::Cylinder), material, centre, size)
}

const fn prop(shape: Shape, material: &'static Material, centre: [f32; 3], size: [f32; 3]) -> Prop {
    Prop {
        shape,
        material,
        motion: Motion::Still,
        centre: Vec3::from_array(centre),
        size: Vec3::from_array(size),
        count: [1, 1],
        spacing: [0.0, 0.0],
    }
}

impl Prop {
    /// Repeats the object in a grid of `count` along x and z, `spacing` scene units apart.
    pub const fn repeat(self, count: [u8; 2], spacing: [f32; 2]) -> Self {
        Self { count, spacing, ..self }
    }

    pub const fn moving(self, motion: Motion) -> Self {
        Self { motion, ..self }
    }

    pub fn add_all(&self, beat: f32, scene: &mut Scene) {
        let [columns, rows] = self.count;
        for row in 0..rows {
            for column in 0..columns {
                self.add(column, row, beat, scene);
            }
        }
    }

    fn add(&self, column: u8, row: u8, beat: f32, scene: &mut Scene) {
        let [dx, dz] = self.spacing;
        let mut centre = self.centre + vec3(f32::from(column) * dx, 0.0, f32::from(row) * dz);
        if let Motion::Bouncing { phase } = self.motion {
            let sine = sin(beat * 0.5 + phase);
            centre.y += 0.4 * sine * sine;
        }
        let half = self.size * 0.5;
        match self.shape {
            Shape::Sphere => add_sphere(centre, half.x, self.material, scene),
            Shape::Block(shape) => {
                add_block(shape, centre, half, Mat3::IDENTITY, self.material, scene);
            }
        }
    }
}

#[inline(never)]
pub(super) fn add_sphere(centre: Vec3, radius: f32, material: &Material, scene: &mut Scene) {
    scene.spheres.push(Sphere::new(centre, radius, *material));
}

/// Adds a capsule with its axis between two points; `side` is perpendicular to it.
pub(super) fn add_rod(
    [from, to]: [Vec3; 2],
    side: Vec3,
    radius: f32,
    material: &Material,
    scene: &mut Scene,
) {
    let axis = to - from;
    let length = axis.length();
    let y = axis * (1.0 / length);
    let half = vec3(radius, 0.5 * length + radius, radius);
    let axes = Mat3::from_cols(y.cross(side), y, side);
    let middle = (from + to) * 0.5;
    add_block(scene::Shape::Capsule, middle, half, axes, material, scene);
}

#[inline(never)]
pub(super) fn add_block(
    shape: scene::Shape,
    centre: Vec3,
    half: Vec3,
    axes: Mat3,
    material: &Material,
    scene: &mut Scene,
) {
    scene.blocks.push(Block { centre, half, axes, shape, material: *material });
}

/// Returns the number of ticks after `beat` beats. Each begins on a beat and takes 0.625 beats.
pub(super) fn ticks(beat: f32) -> f32 {
    // Rounding to even may give the previous beat at a beat itself: both agree there.
    let whole = round(beat - 0.5);
    whole + smooth_step((beat - whole) * 1.6)
}

/// Returns the horizontal direction at an angle in turns, from z towards x.
pub(super) fn around(turns: f32) -> Vec3 {
    vec3(sin(TAU * turns), 0.0, cos(TAU * turns))
}
