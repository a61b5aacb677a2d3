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

pub(crate) use highlight::{Highlight, MAX_HIGHLIGHTS};
pub(crate) use screen::{Rect, corners, rectangle};
pub(crate) use sides::Region;

use crate::prepare::{GroupSet, MAX_GROUPS, MAX_OBJECTS, ObjectId, VisibleGroups, World};
use crate::scene::{List, MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS, Plane};
use glam::{Vec2, Vec3A};
use object::ObjectBounds;
use screen::{Axes, ScreenBounds};
use sides::Sides;
use view::View;

/// One per object, per image of a solid or light, and per shadow of a solid on a plane by a light.
pub(crate) const MAX_OUTLINES: usize = 2 * MAX_OBJECTS + MAX_PLANES * MAX_LIGHTS * MAX_SOLIDS;

/// A feature with a convex outline in the picture.
#[derive(Clone, Copy)]
pub(crate) enum Outline {
    Object(ObjectId),
    Image(ObjectId),
    /// The shadow of a solid. Plane and light are indices.
    Shadow {
        object: ObjectId,
        plane: u8,
        light: u8,
    },
}

pub(crate) struct Coverage {
    pub axes: Axes,
    /// Bounds of each group's objects, and of their images in the first plane.
    groups: [[ScreenBounds; MAX_GROUPS]; 2],
    pub objects: [ObjectBounds; MAX_OBJECTS],
    eye: View,
    image: View,
    /// By plane and light.
    shadows: [[View; MAX_LIGHTS]; MAX_PLANES],
    pub highlights: List<Highlight, MAX_HIGHLIGHTS>,
    /// All outlines except behind the eye or without finite bounds.
    pub outlines: [Outline; MAX_OUTLINES],
    pub screen: [ScreenBounds; MAX_OUTLINES],
    /// The least width of each outline in pixels, up to 255.
    pub widths: [u8; MAX_OUTLINES],
    pub outlined: usize,
}

zero! { Outline = Self::Object(ObjectId::FIRST); }

zero! {
    Coverage {
        axes, groups, objects, eye, image, shadows, highlights, outlines, screen, widths, outlined
    }
}

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

    /// `width` is the outline's least width at distance 1.
    fn list(&mut self, outline: Outline, screen: ScreenBounds, width: f32) {
        self.outlines[self.outlined] = outline;
        self.screen[self.outlined] = screen;
        self.widths[self.outlined] = (width / self.axes.pixel) as u8;
        self.outlined += usize::from(screen != ScreenBounds::NONE);
    }

    #[inline(never)]
    pub fn region(&self, world: World<'_>, number: usize) -> Region {
        // `receiver`: the plane with the image or shadow, and its viewer.
        let (id, view, receiver) = match self.outlines[number] {
            Outline::Object(id) => (id, &self.eye, None),
            Outline::Image(id) => (id, &self.image, Some((0, world.eye))),
            Outline::Shadow { object, plane, light } => {
                let plane = usize::from(plane);
                let view = &self.shadows[plane][usize::from(light)];
                (object, view, Some((plane, view.from)))
            }
        };
        let sides = match id.index().checked_sub(world.first_plane()) {
            Some(plane) => Sides::of_rectangle(&view.axes, view.from, &world.planes()[plane]),
            None => {
                let node = &world.tree.nodes()[usize::from(self.objects[id.index()].node)];
                view.sides(node, &world.object(id).0)
            }
        };
        let mut region = Region::new(&self.axes, self.screen[number], sides, view.rounding);
        if let Some((plane, viewer)) = receiver {
            let [min, max] = self.heights(id, &world.planes()[plane], viewer);
            // The outline includes the part of the object beyond the plane, which has no image or shadow. So no corner is certainly inside,
            // except in a sphere's image: a sphere mostly on the eye's side hides all points inside that show no image.
            let is_image_of_sphere = view.side == 0.0 && self.objects[id.index()].power.is_some();
            let lowest = if is_image_of_sphere { min + max } else { min };
            if lowest < 0.0 {
                region.margin = f32::INFINITY;
            }
        }
        region
    }

    /// The viewer is the light for a shadow, and the eye for an image. Returns the object's least and greatest height above the plane,
    /// positive on the viewer's side, each plus a margin for rounding.
    fn heights(&self, id: ObjectId, plane: &Plane, viewer: Vec3A) -> [f32; 2] {
        let object = &self.objects[id.index()];
        let (error, [min, max]) = (object.hit_error(), object.above(plane.centre.y));
        if viewer.y > plane.centre.y {
            [min + error, max + error]
        } else {
            [error - max, error - min]
        }
    }

    /// Returns the groups that rays through a rectangle can meet.
    pub fn visible_groups(&self, rect: Rect) -> VisibleGroups {
        let [directly, mirrored] = self.groups.each_ref().map(|bounds| {
            let meeting = bounds.iter().map(|bounds| bounds.meets(rect));
            meeting.rev().fold(0, |groups, meets| groups << 1 | GroupSet::from(meets))
        });
        VisibleGroups { directly, mirrored }
    }
}
