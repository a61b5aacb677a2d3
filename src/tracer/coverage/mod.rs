//! Conservative bounds of the features that a square may show between its corners: objects, shadows on planes, images in the first plane,
//! and highlights. `docs/guard.md` has a picture of each.
//!
//! A square is split, down to pixels, while it may show a feature that too few of its corners show. One corner is enough if the feature's
//! outline is wide. An outline thinner than one and a half sides may pass between corners, so all four must show its feature.
//!
//! | kind | bound | the square may be filled if | file |
//! | --- | --- | --- | --- |
//! | object | the cone of rays from the eye that meet it | enough corners show it, or an occluder that all corners show hides it | `object` |
//! | image | the cone of rays from the mirrored eye | no corner shows the plane, or enough that show it are inside the bound | `image` |
//! | shadow | the cone of rays from the light, on the plane | the rule for images holds, or another shadow covers the square | `shadow` |
//! | highlight | the ellipse of a Gaussian | no corner shows the object, or one that does is nearly as bright as any point | `highlight` |
//!
//! Images and shadows have two exceptions, see `refine::guard::planes`.
//!
//! # Guarantees
//!
//! - Each visible object has at least one pixel: a square that meets its outline is filled only if a corner shows the object, or if an
//!   occluder hides the object in the whole square. An untraced pixel may get the mean colour of two traced points; it counts as showing
//!   the objects of both.
//! - A square that shows a plane and meets a sphere's shadow from a point light is filled only if a corner that shows the plane is inside
//!   that shadow, or all corners are inside another shadow from the same light. `rounding` derives the error margins. The shadow may still
//!   be lost if that corner would be as dark without the shadow.
//! - A frame shows every image of a sphere or a box in a flat first plane if the image has 2x2 pixels or more and no other image covers a
//!   part of it. A corner that shows the plane and is inside the outline shows this image or a nearer one.
//! - Thin bars, their shadows from a point light on a plane, and their images have holes of at most 3 pixels (`tests/image/thin.rs`). A
//!   lower bound of an outline's width decides whether it is thin: the object's least extent, seen at its farthest distance.
//!
//! # Best effort
//!
//! - An area light counts as a point light at its centre. A spotlight whose cone may meet a plane counts as shining on the whole plane.
//! - A capsule's shadow has the bound of its bounding cylinder's shadow, and a cylinder's round end counts as the hexagon around it. At the
//!   rim of a cylinder's end, a corner up to 0.087 radii outside the shadow may count as dark.
//! - A square is split for a slit of light if two shadows from one light each cover some of its corners, or if a shadow covers some corners
//!   and an object hides all others.
//! - Images of cylinders and capsules have the bounds of prisms, like their shadows.
//! - A highlight's bound is a Gaussian, which is nearly Phong's lobe. The highlight may be missed if a corner is darker than the Gaussian
//!   there: in shadow, or on another face.
//!
//! # Light without a bound
//!
//! `Quality::unguarded_weight` also splits squares with light that has no bound, see `refine::guard::unguarded`. `limits` lists all
//! exceptions.

mod bounds;
mod highlight;
mod image;
mod mirror;
mod object;
mod screen;
mod shadow;
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
