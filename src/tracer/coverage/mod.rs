//! Conservative bounds of features in the picture. `refine::guard` lists the guarantees that follow
//! from them.
//!
//! | kind | bound |
//! | --- | --- |
//! | object | the cone of rays from the eye that meet it |
//! | image in the first plane | the cone of rays from the mirrored eye |
//! | shadow on a plane | the cone of rays from the light, on the plane |
//! | highlight | the ellipse of a Gaussian |
//!
//! # Best effort
//!
//! - An area light counts as a point light at its centre. A spotlight whose cone may meet a plane
//!   counts as shining on the whole plane.
//! - A capsule's shadow has the bound of its bounding cylinder's shadow, and a cylinder's round end
//!   counts as the hexagon around it. At the rim of a cylinder's end, a corner up to 0.087 radii
//!   outside the shadow may count as dark.
//! - Images of cylinders and capsules have the bounds of prisms, like their shadows.
//! - A highlight's bound is a Gaussian, which is nearly Phong's lobe. The highlight may be missed
//!   if a corner is darker than the Gaussian there: in shadow, or on another face.

mod bounds;
mod highlight;
mod mirror;
mod object;
mod planes;
mod screen;
mod sides;
#[cfg(test)]
mod tests;
mod view;

pub(crate) use bounds::{Coverage, Highlight, MAX_HIGHLIGHTS, MAX_OUTLINES, Outline};
pub(crate) use highlight::VISIBLE;
pub(crate) use screen::{Rect, corners, rectangle};
pub(crate) use sides::{Region, Sides};

use crate::prepare::{MAX_GROUPS, World};
use glam::Vec2;
use screen::{Axes, ScreenBounds};
use view::View;

impl Coverage {
    /// Computes the bounds for samples that are `offset` pixels off the pixels' centres.
    pub fn set(&mut self, world: World<'_>, [width, height]: [usize; 2], offset: Vec2) {
        let raster = world.scene.camera.raster(width, height);
        self.axes = Axes::new(&raster, [width, height], offset);
        self.groups = [[ScreenBounds::NONE; MAX_GROUPS]; 2];
        self.outlined = 0;
        self.eye = View::eye(world.eye, self.axes.rows, self.axes.pixel);
        self.set_objects(world);
        self.set_images(world);
        self.set_shadows(world);
        self.set_highlights(world);
    }
}
