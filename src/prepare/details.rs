//! What only some scenes have: boxes and cylinders, patterns, air, lamps that are more than points.

use super::object::{self, Object};
use crate::scene::{Material, Method, Scene};
use glam::Vec3A;

/// All of that, for one frame.
pub(crate) struct Details {
    is_there: bool,
    has_patterns: bool,
    /// Whether more than the plain picture is shown.
    pub shows_method: bool,
    /// The scene as it was given, if any of it is there.
    pub scene: Scene,
    /// The side of a pixel at distance 1.
    pub pixel: f32,
}

impl Details {
    /// Nothing, all zeros.
    pub const NONE: Self = Self {
        is_there: false,
        has_patterns: false,
        shows_method: false,
        scene: Scene::NONE,
        pixel: 0.0,
    };

    /// Whether there is any of it but for lamps.
    #[inline(always)]
    pub fn is_there(&self) -> bool {
        self.is_there
    }

    /// Whether any of it is a pattern.
    #[inline(always)]
    pub fn has_patterns(&self) -> bool {
        self.has_patterns
    }

    /// Takes a scene in, which may have patterns, and lamps that are no points.
    pub fn set(&mut self, scene: &Scene, has_patterns: bool, has_lamps: bool) {
        self.has_patterns = has_patterns;
        self.is_there = has_patterns
            || scene.haze != 0.0
            || scene.sky != Vec3A::ZERO
            || !scene.blocks.is_empty();
        let Method {
            points,
            squares,
            picture,
        } = scene.method;
        // Not where the first two are 0 and the last 1: all are in 0 to 1.
        self.shows_method = picture - points - squares != 1.0;
        if self.is_there || has_lamps || self.shows_method {
            self.scene = *scene;
        }
    }

    /// The object number `i`, and its material.
    #[inline(never)]
    pub fn object(&self, i: usize) -> (Object<'_>, &Material) {
        object::of(&self.scene, i)
    }
}
