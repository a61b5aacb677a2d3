//! What varies the colour of a surface from place to place.

use glam::Vec3A;

/// A procedural texture: the colour is darkened where a pattern of waves says so.
///
/// At a place `p`, in scene units from the object's centre along its own axes (a sphere and a plane have the scene's),
/// each axis has a triangle wave of height 1 that is highest at 0 and repeats `waves` times a unit; the pattern has the
/// sign of their product and the height of the lowest of them, steepened and cut to -1 to 1. So waves along one axis are stripes, along two or three checkers: fields
/// of half a wave's length. Noise that bends the first axis makes marble of stripes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pattern {
    /// Waves in a scene unit along x, y and z; 0 where nothing changes along an axis.
    pub waves: Vec3A,
    /// Share of the colour that the darkest places lose, 0 to 1; 0 is no pattern.
    pub depth: f32,
    /// How steep edges are, above 0: 1 is the wave itself, which has none, large is black and white. At a distance edges are
    /// at most as steep as a pixel is wide, and what is finer than pixels is even.
    pub edge: f32,
    /// Waves by which the coarsest noise shifts the pattern along x, at most. Finer ones follow, each of half the size and
    /// strength, down to [`Pattern::LEAST_WARP`]; at that or below there is none.
    pub warp: f32,
    /// Cells of the coarsest noise in a scene unit.
    pub grain: f32,
}

impl Pattern {
    /// Noise of this strength and below is left out.
    pub const LEAST_WARP: f32 = 0.2;

    /// An even colour.
    pub const NONE: Self = Self {
        waves: Vec3A::ZERO,
        depth: 0.0,
        edge: 0.0,
        warp: 0.0,
        grain: 0.0,
    };
}
