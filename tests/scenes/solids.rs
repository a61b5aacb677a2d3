use crate::Random;
use crate::artists::matt;
use crate::kinds::add;
use eightfold_tracer::scene::{Block, Material, Scene, Shape};
use glam::{Mat3, Quat, Vec3, vec3};

pub const SHAPES: [Shape; 3] = [Shape::Box, Shape::Cylinder, Shape::Capsule];

pub fn fitting(shape: Shape, half: Vec3) -> Vec3 {
    match shape {
        Shape::Box => half,
        Shape::Cylinder => half.with_z(half.x),
        _ => vec3(half.x, half.y.max(half.x), half.x),
    }
}

pub fn block(random: &mut Random, centre: Vec3, half: Vec3, material: Material) -> Block {
    let shape = random.one_of(SHAPES);
    Block { axes: random.turn(), ..Block::new(shape, centre, fitting(shape, half), material) }
}

/// Bars of one shape, radius and material.
pub struct Bars {
    pub shape: Shape,
    pub radius: f32,
    pub material: Material,
}

impl Bars {
    pub fn any(random: &mut Random) -> Self {
        let matt = matt(random);
        Self {
            shape: random.one_of(SHAPES),
            radius: random.one_of([0.005, 0.01, 0.02, 0.04, 0.08]),
            material: random.one_of([Material::BLACK, matt]),
        }
    }

    /// Adds a bar from each point to the next.
    pub fn stroke(&self, scene: &mut Scene, points: impl IntoIterator<Item = Vec3>) {
        let mut points = points.into_iter();
        let mut from = points.next().unwrap_or_default();
        for to in points {
            self.add(scene, from, to);
            from = to;
        }
    }

    /// Adds vertical bars at `columns`, as high as `rows` from 0 up, and horizontal ones at `rows`,
    /// as wide as the columns.
    pub fn grid(
        &self,
        scene: &mut Scene,
        at: impl Fn(f32, f32) -> Vec3,
        columns: &[f32],
        rows: &[f32],
        [wide, high]: [f32; 2],
    ) {
        columns.iter().for_each(|&x| self.add(scene, at(x, 0.0), at(x, high)));
        rows.iter().for_each(|&y| self.add(scene, at(-wide, y), at(wide, y)));
    }

    pub fn add(&self, scene: &mut Scene, from: Vec3, to: Vec3) {
        let along = to - from;
        // A letter's stroke, or a net's last bar, may be a point.
        if along == Vec3::ZERO {
            return;
        }
        let half = vec3(self.radius, 0.5 * along.length(), self.radius);
        let half = fitting(self.shape, half);
        let turn = Quat::from_rotation_arc(Vec3::Y, along.normalize_or(Vec3::Y));
        let bar = Block::new(self.shape, 0.5 * (from + to), half, self.material);
        add(&mut scene.blocks, Block { axes: Mat3::from_quat(turn), ..bar });
    }
}
