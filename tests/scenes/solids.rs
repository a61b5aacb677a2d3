use crate::Random;
use eightfold_tracer::scene::{Block, Material, Shape};
use glam::Vec3;

pub const SHAPES: [Shape; 3] = [Shape::Box, Shape::Cylinder, Shape::Capsule];

pub fn fitting(shape: Shape, half: Vec3) -> Vec3 {
    match shape {
        Shape::Box => half,
        Shape::Cylinder => half.with_z(half.x),
        _ => Vec3::new(half.x, half.y.max(half.x), half.x),
    }
}

pub fn block(random: &mut Random, centre: Vec3, half: Vec3, material: Material) -> Block {
    let shape = random.one_of(SHAPES);
    Block { axes: random.turn(), ..Block::new(shape, centre, fitting(shape, half), material) }
}
