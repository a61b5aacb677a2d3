//! The guard's bounds: regions of the picture where an object, a shadow on a plane, an image in the first plane or a highlight may be
//! visible between the corners of a square.
//!
//! Each frame, everything that may be visible gets a conservative bound in the picture. A guarded square (see
//! [`Quality::guarded`](crate::Quality::guarded)) is split while it meets a bound whose object its corners do not show. The parts of a
//! cleared square stay cleared. An outline wider than the square covers a corner of every part that it crosses, so one such corner clears
//! the square. An outline thinner than one and a half sides keeps the square open down to pixels, unless all four corners show it.
//!
//! | kind | bound | a square may be filled if | file |
//! | --- | --- | --- | --- |
//! | object | the cone of rays from the eye that meet it | a corner shows it (all, if it is thin), or the corners show an occluder that hides it | `object` |
//! | image | the same from the eye's mirror image | no corner shows the plane, or a corner that shows the plane is inside the bound (all, if it is thin) | `image` |
//! | shadow | the cone of rays from the light, projected onto the plane | the same | `shadow` |
//! | highlight | the ellipse of a Gaussian | its brightness nowhere visibly exceeds the corners that show the object | `highlight` |
//!
//! `guard` tests a tile's squares against the bounds, level by level. `view` bounds spheres as seen from the eye or a light. `sides` bounds
//! blocks and planes, and tests points and rectangles against all bounds. `screen` has bounding rectangles; `mirror` finds the points where
//! surfaces mirror a light.
//!
//! # Guarantees
//!
//! - Objects: every object in an exhaustive frame has at least one pixel. A square with a pixel of the object meets its outline, so it is
//!   filled only if a corner in the picture shows the object, or if all corners show an occluder that covers the square. An averaged point
//!   counts as showing the object that both ends show.
//! - Shadows of spheres on planes by point lights: the same. A square that shows the plane and meets a shadow is filled only if a corner
//!   that shows the plane lies in this shadow, or if all corners lie in another shadow by the same light ([`rounding`](crate::rounding)
//!   derives the margins). The corner may be as dark without the shadow, see [`limits`](crate::limits).
//! - Images in the first plane: the same, for images of 2x2 pixels or more that no other image covers in part. A corner inside an image's
//!   outline shows this image or another one in front of it.
//! - Thin things: in a bar 1 to 5 pixels wide, in its shadow on a plane by a point light, and in its image in the first plane, no hole
//!   reaches 4 connected pixels at a named quality (`tests/image/thin.rs`). An outline's width is the least extent of the object at its
//!   farthest distance: a lower bound. Antialiasing keeps at least an eighth of such a pixel.
//!
//! # Best effort
//!
//! - Other shadows on planes: a capsule counts as the cylinder around it, a cylinder from above as a box, an area light as its centre, and
//!   a spotlight also where it does not shine. Few are missed.
//! - Slits of light between two shadows by one light: a square stays open if two shadows each cover some of its corners. Otherwise dark
//!   corners would fill it, and the slit would flicker.
//! - Images of cylinders and capsules, whose outlines are boxes. Images in waves (see [`Scene::water`](crate::scene::Scene::water)) have no
//!   outlines.
//! - Highlights in direct view: around the point that mirrors the light, Phong's lobe is a Gaussian in the picture. The lobe is only nearly
//!   Gaussian, and a corner may be in shadow or on another face. Of thousands of highlights of five pixels or more whose centre is visible
//!   the guard missed 0 (`docs/accuracy.md`).
//! - Wider things can have holes, of up to 8 pixels in tests: at a corner, and in a narrow visible strip such as the back of a sunken log.
//!
//! The guard ignores gaps between objects, shadows on spheres and blocks, highlights in mirrors, other reflections, and refractions. `cargo
//! lab missed` counts these. Guaranteed shadows can be too small: up to 0.4 % of the pixels of small spheres' shadows are lit
//! (`few_pixels_of_shadows_are_lit`). `cargo lab bench` measures wrong pixels and pops.

mod guard;
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

pub(crate) use guard::{Guard, Squares};
pub(crate) use screen::{Rect, rectangle};

use crate::prepare::{GroupSet, MAX_GROUPS, MAX_OBJECTS, ObjectId, VisibleGroups, World};
use crate::scene::{List, MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS, Plane};
use glam::{Vec2, Vec3A};
use highlight::{Highlight, MAX_HIGHLIGHTS};
use object::ObjectBounds;
use screen::{Axes, ScreenBounds};
use sides::{Region, Sides};
use view::View;

/// The maximum number of outlines: one per object, per image of a solid or light, and per shadow of a solid on a plane by a light.
const MAX_OUTLINES: usize = 2 * MAX_OBJECTS + MAX_PLANES * MAX_LIGHTS * MAX_SOLIDS;

/// Something with a convex outline in the picture.
#[derive(Clone, Copy)]
enum Outline {
    /// An object in direct view.
    Object(ObjectId),
    Image(ObjectId),
    /// The shadow of a solid, by the indices of plane and light.
    Shadow {
        object: ObjectId,
        plane: u8,
        light: u8,
    },
}

/// Conservative bounds of everything that may be visible in a picture.
pub(crate) struct Coverage {
    pub axes: Axes,
    /// For each group of the tree, bounds of its objects, and bounds of their images in the first plane.
    groups: [[ScreenBounds; MAX_GROUPS]; 2],
    /// Indexed by object.
    objects: [ObjectBounds; MAX_OBJECTS],
    eye: View,
    image: View,
    /// The lights' views, by plane and light.
    shadows: [[View; MAX_LIGHTS]; MAX_PLANES],
    highlights: List<Highlight, MAX_HIGHLIGHTS>,
    /// All outlines that may meet the picture, with their bounding rectangles.
    outlines: [Outline; MAX_OUTLINES],
    screen: [ScreenBounds; MAX_OUTLINES],
    /// The least width of each in pixels, up to 255.
    widths: [u8; MAX_OUTLINES],
    outlined: usize,
}

impl Coverage {
    /// Returns zeroed memory.
    pub const fn new() -> Self {
        Self {
            axes: Axes::ZERO,
            groups: [[ScreenBounds::ZERO; MAX_GROUPS]; 2],
            objects: [const { ObjectBounds::ZERO }; MAX_OBJECTS],
            eye: View::ZERO,
            image: View::ZERO,
            shadows: [[View::ZERO; MAX_LIGHTS]; MAX_PLANES],
            highlights: List::over(Highlight::ZERO),
            outlines: [Outline::Object(ObjectId::FIRST); MAX_OUTLINES],
            screen: [ScreenBounds::ZERO; MAX_OUTLINES],
            widths: [0; MAX_OUTLINES],
            outlined: 0,
        }
    }

    /// Computes the bounds for a picture of `width` by `height` pixels, whose samples are `offset` pixels off the pixels' centres.
    pub fn set(&mut self, world: World<'_>, [width, height]: [usize; 2], offset: Vec2) {
        let raster = world.scene.camera.raster(width, height);
        self.axes = Axes::new(&raster, [width, height], offset);
        self.groups = [[ScreenBounds::NONE; MAX_GROUPS]; 2];
        self.outlined = 0;
        self.eye = View::eye(world.eye, self.axes.rows);
        self.set_objects(world);
        self.set_images(world);
        self.set_shadows(world);
        self.set_highlights(world);
    }

    /// Adds an outline with its bounds. `width` is its least width at distance 1.
    fn list(&mut self, outline: Outline, screen: ScreenBounds, width: f32) {
        self.outlines[self.outlined] = outline;
        self.screen[self.outlined] = screen;
        self.widths[self.outlined] = (width / self.axes.pixel) as u8;
        self.outlined += usize::from(screen != ScreenBounds::NONE);
    }

    #[inline(never)]
    fn outline(&self, world: World<'_>, number: usize) -> (Outline, Region) {
        let outline = self.outlines[number];
        // The object, the view, and the plane and viewer of an image or shadow.
        let (id, view, shown) = match outline {
            Outline::Object(id) => (id, &self.eye, None),
            Outline::Image(id) => (id, &self.image, Some((0, world.eye))),
            Outline::Shadow {
                object,
                plane,
                light,
            } => {
                let plane = usize::from(plane);
                let view = &self.shadows[plane][usize::from(light)];
                (object, view, Some((plane, view.from)))
            }
        };
        let sides = match id.index().checked_sub(world.first_plane()) {
            Some(plane) => Sides::of_rectangle(&view.rays, view.from, &world.planes()[plane]),
            None => {
                let node = &world.tree.nodes()[usize::from(self.objects[id.index()].node)];
                view.sides(node, &world.object(id).0)
            }
        };
        let mut region = Region::new(&self.axes, self.screen[number], sides, view.rounding);
        // The part beyond the plane has no image or shadow, yet its rays meet the plane.
        if let Some((plane, viewer)) = shown
            && self.heights(id, &world.planes()[plane], viewer)[0] < 0.0
        {
            region.margin = f32::INFINITY;
        }
        (outline, region)
    }

    /// Returns the least and greatest height of an object above a plane, on the viewer's side, with a margin for rounding. The viewer is
    /// the shadow's light, or the eye for an image.
    fn heights(&self, id: ObjectId, plane: &Plane, viewer: Vec3A) -> [f32; 2] {
        let object = &self.objects[id.index()];
        let (error, [least, most]) = (object.hit_error(), object.above(plane.centre.y));
        if viewer.y > plane.centre.y {
            [least + error, most + error]
        } else {
            [error - most, error - least]
        }
    }

    /// Returns the groups that rays through a rectangle can meet.
    pub fn visible_groups(&self, rect: Rect) -> VisibleGroups {
        let [directly, mirrored] = self.groups.each_ref().map(|bounds| {
            let meeting = bounds.iter().map(|bounds| bounds.meets(rect));
            meeting
                .rev()
                .fold(0, |groups, meets| groups << 1 | GroupSet::from(meets))
        });
        VisibleGroups { directly, mirrored }
    }
}
