//! The bounds of a frame's features.

use super::screen::{Axes, Rect, ScreenBounds};
use super::sides::{Region, Sides};
use super::view::View;
use crate::prepare::{GroupSet, MAX_GROUPS, MAX_OBJECTS, ObjectId, VisibleGroups, World};
use crate::scene::{List, MAX_BLOCKS, MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS, MAX_SPHERES, Plane};
use glam::{Vec2, Vec3A, Vec4};

/// One per object, per image of a solid or light, and per shadow of a solid on a plane by a light.
pub(crate) const MAX_OUTLINES: usize = 2 * MAX_OBJECTS + MAX_PLANES * MAX_LIGHTS * MAX_SOLIDS;

/// For each light: one on each sphere and plane, three on each block.
pub(crate) const MAX_HIGHLIGHTS: usize = MAX_LIGHTS * (MAX_SPHERES + 3 * MAX_BLOCKS + MAX_PLANES);

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

pub(crate) struct ObjectBounds {
    /// The index of its node in the tree, for solids and lights.
    pub node: u16,
    pub screen: ScreenBounds,
    /// Bounds of the eye's power with respect to a sphere: distance squared minus radius squared,
    /// or infinity if the eye is inside. `None` for blocks, and if rounding decides whether the eye
    /// is inside. The plane of equal powers separates the visible parts of two spheres: the sphere
    /// of smaller power is in front (Aurenhammer: Power Diagrams, SIAM Journal on Computing, 1987).
    pub power: Option<[f32; 2]>,
    /// Half of the least extent.
    pub thickness: f32,
    /// The extent along the scene's axes, and forward from the eye.
    pub(super) min: Vec4,
    pub(super) max: Vec4,
}

#[derive(Clone, Copy, Default)]
pub(crate) struct Highlight {
    pub object: ObjectId,
    /// In pixels.
    pub middle: Vec2,
    /// In pixels: the least x and y, and the negated greatest x and y.
    pub bounds: Vec4,
    pub decay: [f32; 3],
    /// The peak, in 255ths.
    pub strength: f32,
}

pub(crate) struct Coverage {
    pub axes: Axes,
    /// Bounds of each group's objects, and of their images in the first plane.
    pub(super) groups: [[ScreenBounds; MAX_GROUPS]; 2],
    pub objects: [ObjectBounds; MAX_OBJECTS],
    pub(super) eye: View,
    pub(super) image: View,
    /// By plane and light.
    pub(super) shadows: [[View; MAX_LIGHTS]; MAX_PLANES],
    pub highlights: List<Highlight, MAX_HIGHLIGHTS>,
    /// All outlines, except behind the eye or of non-finite objects.
    pub outlines: [Outline; MAX_OUTLINES],
    pub screen: [ScreenBounds; MAX_OUTLINES],
    /// The least width of each outline in pixels, up to 255.
    pub widths: [u8; MAX_OUTLINES],
    pub outlined: usize,
}

zero! { Outline = Self::Object(ObjectId::FIRST); }

zero! {
    ObjectBounds { node, screen, power, thickness, min, max }
    Highlight { object, middle, bounds, decay, strength }
    Coverage {
        axes, groups, objects, eye, image, shadows, highlights, outlines, screen, widths, outlined
    }
}

impl Coverage {
    /// `width` is the outline's least width at distance 1.
    pub(super) fn list(&mut self, outline: Outline, screen: ScreenBounds, width: f32) {
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
            // The outline includes the part of the object beyond the plane, which has no image or
            // shadow. So no corner is certainly inside, except in a sphere's image: if its centre
            // is on the eye's side, the sphere hides the points inside that show no image.
            let is_image_of_sphere = view.side == 0.0 && self.objects[id.index()].power.is_some();
            let lowest = if is_image_of_sphere { min + max } else { min };
            if lowest < 0.0 {
                region.margin = f32::INFINITY;
            }
        }
        region
    }

    /// The viewer is the light for a shadow, and the eye for an image. Returns the object's least
    /// and greatest height above the plane, positive on the viewer's side, each plus a margin for
    /// rounding.
    pub(super) fn heights(&self, id: ObjectId, plane: &Plane, viewer: Vec3A) -> [f32; 2] {
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
