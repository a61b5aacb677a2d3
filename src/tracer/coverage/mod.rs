//! What squares may show although none of their corners does: objects, shadows on planes, images in the first plane, and highlights.
//!
//! Corners do not see what lies between them. Here everything that may be visible has a conservative bound of where in the picture it
//! is, set once a frame. A guarded square (see [`Quality::guarded`](crate::Quality::guarded)) is split as long as it meets such a bound
//! and its corners do not show what the bound is around. What a square is cleared of, its parts are, too. A corner clears a square of an
//! outline that is wider than the square: such an outline covers a corner of every part that it crosses. An outline that is thinner than
//! one and a half sides leaves the square open down to pixels, unless all four corners show it.
//!
//! | kind | bound | a square may be filled if | file |
//! | --- | --- | --- | --- |
//! | object | the cone of rays from the eye that meet it | a corner shows it (all, if it is thin), or all corners show one occluder | `object` |
//! | image | the same from the eye's mirror image | no corner shows the plane, or one of those that do is inside of the bound (all, if it is thin) | `image` |
//! | shadow | the cone of rays from the light, as the eye sees it on the plane | the same | `shadow` |
//! | highlight | the ellipse of a Gaussian | it is not visibly brighter anywhere than at the corners that show the object | `highlight` |
//!
//! `guard` goes through the bounds that meet a tile, level by level. `view` bounds spheres seen from the eye or a light, `sides` bounds
//! blocks and planes, and tests points and rectangles of the picture against all these bounds, `screen` has rectangles around them, and
//! `mirror` finds the places where highlights are.
//!
//! # What is not missed
//!
//! Every object that tracing every pixel shows is shown in one pixel at least: an object that has a pixel p is in its outline around each
//! square with p, so a square with p is filled only where one of its corners that are pixels shows the object, or where all corners
//! show an occluder that covers the square. Averaged points count as showing what both their ends show.
//!
//! The same holds for the shadows that spheres throw on planes by the light of lights that are points. A square that shows the plane at a
//! corner, and may show a shadow, is filled only where one of its corners lies in the shadow on the plane, or where all lie in another
//! one by the same light ([`rounding`](crate::rounding) derives why errors spoil neither). That corner is dark. It may be as dark
//! without the shadow: see [`limits`](crate::limits).
//!
//! Shadows of blocks on planes, and by all other lights, are looked for in the same way, but not as exactly: a capsule counts as the
//! cylinder around it, a cylinder that is seen from above as the box, and an area light as its middle. A spotlight counts where it
//! does not shine, too. So few of them are missed.
//!
//! Slits of light between two shadows by one light are looked for as well: a square is left open if two of the shadows hold some of its
//! corners each, and none holds all. Corners that are all dark would fill it otherwise, and the slit would come and go from frame to
//! frame.
//!
//! And it holds for the images in the first plane. A corner inside of an image's outline shows the image, or another one in front of it:
//! an image that is partly hidden by others in the mirror can be missed. So can an image smaller than 2x2 pixels, as corners have to be
//! well inside of a block's outline, and, if rarely, the image of a cylinder or a capsule, whose outline is the outline of the box around
//! it. Images in a first plane with waves (see [`Scene::water`](crate::scene::Scene::water)) have no outlines: they can be missed as in
//! any other mirror.
//!
//! Highlights in the eye's own sight are guarded by what they look like. About the place where a light is mirrored, Phong's lobe is a
//! Gaussian of the picture. A square that shows the object is left open if the lobe is visibly brighter anywhere in it than at the
//! corners that show the object. That is no proof: the lobe is only nearly a Gaussian, and such a corner may be in shadow or on another
//! face. Of thousands of highlights of five pixels or more that show their middles none was missed, and few parts of others
//! (`docs/accuracy.md`).
//!
//! # What has no holes
//!
//! What an exhaustive frame shows of a thing 1 to 5 pixels wide in the eye's sight, of its shadow on a plane by a point of light, and
//! of its image in the first plane, at every pixel of it, no named quality leaves out in a hole of 4 connected pixels or more
//! (`tests/image/thin.rs`). An outline's width is the least extent of the object where it is farthest from the eye: at most the true one.
//! Of wider things two parts can have holes, of 8 pixels as far as was seen: a corner, and a narrow strip that others leave of a wide
//! thing, such as the back of a log that is sunk in the ground.
//!
//! Antialiasing leaves a pixel an eighth of what it shows at least.
//!
//! That is all that is guaranteed. Gaps between objects, shadows on other objects than planes, highlights in mirrors, and what is seen in
//! other mirrors or through glass can be missed where they fall between corners; `cargo lab missed` counts how many are. A guaranteed
//! shadow may be smaller than it is, too: of the pixels of small spheres' shadows on a plane up to 0.4 % are lit
//! (`few_pixels_of_shadows_are_lit`). The lab's bench measures how much of the picture is
//! wrong, and how many pixels pop.

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

/// The most outlines: of each object, of the images of solids and lights, and of the shadow of each solid on each plane by each light.
const MAX_OUTLINES: usize = 2 * MAX_OBJECTS + MAX_PLANES * MAX_LIGHTS * MAX_SOLIDS;

/// Something with a convex outline that a square may show although no corner does.
#[derive(Clone, Copy)]
enum Outline {
    /// An object in the eye's own sight.
    Object(ObjectId),
    /// The image of a solid or a light in the first plane.
    Image(ObjectId),
    /// The shadow of a solid on a plane by a light, by their numbers.
    Shadow {
        object: ObjectId,
        plane: u8,
        light: u8,
    },
}

/// Conservative bounds of everything that may be seen in a picture.
pub(crate) struct Coverage {
    pub axes: Axes,
    /// For each group of the tree, a rectangle around it in the picture, and one around its image in the first plane.
    groups: [[ScreenBounds; MAX_GROUPS]; 2],
    /// By the numbers of the objects.
    objects: [ObjectBounds; MAX_OBJECTS],
    eye: View,
    /// The eye's mirror image in the first plane.
    image: View,
    /// The lights, as each plane shows their light.
    shadows: [[View; MAX_LIGHTS]; MAX_PLANES],
    highlights: List<Highlight, MAX_HIGHLIGHTS>,
    /// All outlines that may meet the picture, and a rectangle around each.
    outlines: [Outline; MAX_OUTLINES],
    screen: [ScreenBounds; MAX_OUTLINES],
    /// The least width of each in pixels, up to 255.
    widths: [u8; MAX_OUTLINES],
    outlined: usize,
}

impl Coverage {
    /// Returns memory for bounds, all zeros.
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

    /// Sets the bounds for a picture, given by its width and height in pixels, whose samples are `offset` pixels off the pixels' centres.
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

    /// Adds an outline, with its bounds in the picture and its least width in units of distance 1.
    fn list(&mut self, outline: Outline, screen: ScreenBounds, width: f32) {
        self.outlines[self.outlined] = outline;
        self.screen[self.outlined] = screen;
        self.widths[self.outlined] = (width / self.axes.pixel) as u8;
        self.outlined += usize::from(screen != ScreenBounds::NONE);
    }

    /// Returns an outline, by its number, and its region of the picture.
    #[inline(never)]
    fn outline(&self, world: World<'_>, number: usize) -> (Outline, Region) {
        let outline = self.outlines[number];
        // The object, the view that shows it, and the plane that shows its image or its shadow to a viewer.
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
        // Rays to a part beyond the plane meet the plane as well, but it shows neither the image nor the shadow there.
        if let Some((plane, viewer)) = shown
            && self.heights(id, &world.planes()[plane], viewer)[0] < 0.0
        {
            region.margin = f32::INFINITY;
        }
        (outline, region)
    }

    /// Returns how far an object reaches towards the viewer from a plane that may show its shadow or its image, least and most, and a
    /// bound on rounding more. The viewer is the shadow's light or, of an image, the eye.
    fn heights(&self, id: ObjectId, plane: &Plane, viewer: Vec3A) -> [f32; 2] {
        let object = &self.objects[id.index()];
        let (error, [least, most]) = (object.hit_error(), object.above(plane.centre.y));
        if viewer.y > plane.centre.y {
            [least + error, most + error]
        } else {
            [error - most, error - least]
        }
    }

    /// Returns the groups that rays through a rectangle of the picture can meet.
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
