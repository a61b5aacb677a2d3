use crate::maths::unit;
use crate::scene;
use glam::{Vec2, Vec3, Vec3A};

/// A softbox in units of its softness.
#[derive(Clone, Copy)]
pub(crate) struct Softbox {
    pub aim: Vec3,
    pub along: [Vec3; 2],
    pub half: Vec2,
    pub colour: Vec3,
}

zero! { Softbox { aim, along, half, colour } }

impl Softbox {
    pub fn of(softbox: &scene::Softbox) -> Self {
        let aim = unit(softbox.aim.into());
        let right = Vec3A::Y.cross(aim).normalize_or(Vec3A::X);
        let scale = 1.0 / softbox.softness;
        Self {
            aim: aim.into(),
            along: [right, aim.cross(right)].map(|side| (side * scale).into()),
            half: Vec2::new(softbox.half_width, softbox.half_height) * scale,
            colour: softbox.colour,
        }
    }
}
