//! Boxes, cylinders and capsules.

use crate::Random;
use eightfold_tracer::scene::{Block, Material, Shape};
use glam::Vec3;

pub const SHAPES: [Shape; 3] = [Shape::Box, Shape::Cylinder, Shape::Capsule];

/// Returns the nearest valid extent of a shape.
pub fn fitting(shape: Shape, half: Vec3) -> Vec3 {
    match shape {
        Shape::Box => half,
        Shape::Cylinder => half.with_z(half.x),
        Shape::Capsule => Vec3::new(half.x, half.y.max(half.x), half.x),
    }
}

/// Returns a block of any shape and direction.
pub fn block(random: &mut Random, centre: Vec3, half: Vec3, material: Material) -> Block {
    let shape = random.one_of(SHAPES);
    Block {
        axes: random.turn(),
        ..Block::new(shape, centre, fitting(shape, half), material)
    }
}
