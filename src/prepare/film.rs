//! How light becomes the picture's colours, see [`crate::scene::Film`].

use crate::scene;
use crate::scene::camera::pixels;
use glam::{Vec2, Vec3A, vec2};

/// The film of a frame. Colours are in output steps, 255 the brightest; positions in pixels of the picture.
pub(crate) struct Film {
    /// Whether colours stay as they are.
    pub is_plain: bool,
    shoulder: f32,
    /// From the shoulder to full brightness.
    room: f32,
    vignette: f32,
    middle: Vec2,
    /// 1 / half the picture's height.
    unit: f32,
}

/// The least room above a shoulder, so that it can be divided by: it makes no difference to any output step.
const LEAST_ROOM: f32 = 1e-3;

impl Film {
    /// All zeros: memory before a frame is prepared.
    pub const ZERO: Self = Self {
        is_plain: false,
        shoulder: 0.0,
        room: 0.0,
        vignette: 0.0,
        middle: Vec2::ZERO,
        unit: 0.0,
    };

    /// Prepares the film for a picture of `width` by `height` pixels.
    pub fn of(film: &scene::Film, width: usize, height: usize) -> Self {
        let (width, height) = (pixels(width), pixels(height));
        Self {
            is_plain: *film == scene::Film::PLAIN,
            shoulder: 255.0 * film.shoulder,
            room: (255.0 * (1.0 - film.shoulder)).max(LEAST_ROOM),
            vignette: film.vignette,
            middle: 0.5 * vec2(width - 1.0, height - 1.0),
            unit: 2.0 / height,
        }
    }

    /// The colour that light becomes at a point of the picture.
    pub fn expose(&self, light: Vec3A, at: Vec2) -> Vec3A {
        let r2 = ((at - self.middle) * self.unit).length_squared();
        let light = light / (1.0 + self.vignette * r2);
        let over = (light - self.shoulder).max(Vec3A::ZERO);
        light - over + over * self.room / (self.room + over)
    }
}
