//! What every ray of a frame uses, computed once a frame.

mod details;
mod groups;
mod lamp;
mod outline;
mod screen;
mod surface;
mod tree;

pub(crate) use details::{Details, Object};
pub(crate) use groups::{GroupSet, Groups, MAX_GROUPS};
pub(crate) use lamp::{Caster, Lamp};
use outline::{Axes, Outline};
pub(crate) use screen::Window;
pub(crate) use surface::{FIELDS, Spread};
pub(crate) use tree::{Node, Tree};

use crate::DETAILS;
use crate::lanes::MAX_LANES;
use crate::scene::{
    MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS, Scene,
    camera::{Raster, pixels},
};
use glam::Vec3A;

/// How far rounding takes a point that was computed to be on a sphere from it, as a share of the sphere's largest
/// coordinate.
///
/// In roundings of 2^-24: 1.7 of the point's coordinates (the root of 3), 2.5 of its distance from the centre, 1.5 of the
/// ray's length, and 2.8 of the way from the centre, its square and the discriminant when the next ray is held against
/// the sphere: at most 8.5. Rays by the hundred million get as far as 5 (`rays_that_leave_a_sphere_do_not_hit_it_again`).
const SLACK: f32 = 10.0 / (1 << 24) as f32;

/// Objects a ray can hit: spheres, lights (drawn as spheres), planes, and the background.
pub(crate) const MAX_OBJECTS: usize = MAX_SOLIDS + MAX_LIGHTS + MAX_PLANES + 1;

/// One frame's scene in the order the kernels want it.
///
/// Objects are numbered: spheres (as [`Groups`] order them), lights, planes, background.
pub(crate) struct Prepared {
    pub eye: Vec3A,
    pub raster: Raster,
    /// Rows of the picture.
    pub height: usize,
    pub groups: Groups,
    pub tree: Tree,
    /// What each group covers of the picture.
    pub windows: [Window; MAX_GROUPS],
    /// The same of its mirror image in the first plane.
    pub mirrored: [Window; MAX_GROUPS],
    pub axes: Axes,
    /// What each object covers of the picture.
    pub outlines: [Outline; MAX_OBJECTS],
    pub solids: usize,
    pub lamps: [Lamp; MAX_LIGHTS],
    pub lamp_count: usize,
    pub planes: [Rectangle; MAX_PLANES],
    pub plane_count: usize,
    pub surfaces: [Spread; MAX_OBJECTS],
    pub details: Details,
    /// What primary rays weigh.
    pub weight: f32,
    /// Where samples are, from the centres of their pixels, in pixels.
    #[cfg(feature = "lab")]
    pub offset: glam::Vec2,
}

/// The groups that a part of the picture can show.
#[derive(Clone, Copy, Default)]
pub(crate) struct Seen {
    /// Met by primary rays.
    pub directly: GroupSet,
    /// Met by what the first plane reflects of primary rays.
    pub mirrored: GroupSet,
}

/// A horizontal rectangle.
#[derive(Clone, Copy)]
pub(crate) struct Rectangle {
    pub centre: Vec3A,
    pub half_x: f32,
    pub half_z: f32,
}

impl Prepared {
    /// An empty frame, all zeros.
    pub const fn new() -> Self {
        Self {
            eye: Vec3A::ZERO,
            raster: Raster::NONE,
            height: 0,
            groups: Groups::NONE,
            tree: Tree::NONE,
            windows: [Window::ZERO; MAX_GROUPS],
            mirrored: [Window::ZERO; MAX_GROUPS],
            axes: Axes::NONE,
            outlines: [Outline::NONE; MAX_OBJECTS],
            solids: 0,
            lamps: [const { Lamp::NONE }; MAX_LIGHTS],
            lamp_count: 0,
            planes: [Rectangle::NONE; MAX_PLANES],
            plane_count: 0,
            surfaces: [[[0.0; MAX_LANES]; FIELDS]; MAX_OBJECTS],
            details: Details::NONE,
            weight: 0.0,
            #[cfg(feature = "lab")]
            offset: glam::Vec2::ZERO,
        }
    }

    /// The number of the first plane.
    pub fn first_plane(&self) -> usize {
        self.solids + self.lamp_count
    }

    /// The number of the background.
    pub fn nothing(&self) -> usize {
        self.first_plane() + self.plane_count
    }

    /// The groups that rays through the points of a rectangle of the picture can meet.
    #[inline(never)]
    pub fn seen(&self, left: usize, top: usize, right: usize, bottom: usize) -> Seen {
        let rectangle = [left, top, right, bottom].map(pixels);
        let set = |windows: &[Window]| {
            let mut set = 0;
            for (i, (_, window)) in self.groups.iter().zip(windows).enumerate() {
                set |= GroupSet::from(window.meets(rectangle)) << i;
            }
            set
        };
        Seen {
            directly: set(&self.windows),
            mirrored: set(&self.mirrored),
        }
    }

    /// Takes a scene in, for pictures of `width` by `height` pixels.
    pub fn set(&mut self, scene: &Scene, width: usize, height: usize) {
        self.eye = scene.camera.eye;
        self.raster = scene.camera.raster(width, height);
        self.height = height;
        self.solids = scene.solids();
        self.weight = if DETAILS { 1.0 - scene.fade } else { 1.0 };
        self.details.set(scene, self.raster.dx.length());
        self.lamp_count = scene.lights.len();
        self.plane_count = scene.planes.len();
        self.groups.set(scene);
        self.tree.set(scene, &self.groups);
        for (i, &number) in self.groups.order().iter().enumerate() {
            let number = number as usize;
            let (centre, radius, material) = scene.around(number);
            // Of boxes and cylinders the details know more.
            let inverse_radius = if number < scene.spheres.len() {
                1.0 / radius
            } else {
                0.0
            };
            let surface = surface::solid(centre, inverse_radius, material, scene.ambient);
            surface::spread(&surface, &mut self.surfaces[i]);
        }
        for (i, light) in scene.lights.iter().enumerate() {
            let i = self.solids + i;
            surface::spread(&surface::emitting(light.colour), &mut self.surfaces[i]);
        }
        let first_plane = self.first_plane();
        for (i, plane) in scene.planes.iter().enumerate() {
            self.planes[i] = Rectangle {
                centre: plane.centre,
                half_x: plane.half_x,
                half_z: plane.half_z,
            };
            let surface = surface::solid(plane.centre, 0.0, &plane.material, scene.ambient);
            surface::spread(&surface, &mut self.surfaces[first_plane + i]);
        }
        let nothing = self.nothing();
        let background = surface::emitting(scene.background);
        surface::spread(&background, &mut self.surfaces[nothing]);
        self.set_outlines(width, height);
        #[cfg(feature = "lab")]
        self.move_samples();
        for (i, light) in scene.lights.iter().enumerate() {
            let [_, _, _, red, green, blue, ..] = self.surfaces[self.solids + i];
            let colour = Vec3A::new(red[0], green[0], blue[0]);
            let has_blocks = !scene.blocks.is_empty();
            self.lamps[i].set(light, colour, has_blocks, self.tree.solid());
        }
    }

    /// Takes in what each object covers of the picture; the objects and groups are in already.
    #[inline(never)]
    fn set_outlines(&mut self, width: usize, height: usize) {
        self.axes = Axes::of(&self.raster, width, height);
        let (first_plane, nothing) = (self.first_plane(), self.nothing());
        let window = |centre: Vec3A, radius: f32| {
            Window::of(centre, radius, self.eye, &self.raster, width, height)
        };
        let floor = self.planes[0].centre.y;
        for (i, group) in self.groups.iter().enumerate() {
            let mut centre = group.centre;
            self.windows[i] = window(centre, group.radius);
            centre.y = 2.0 * floor - centre.y;
            self.mirrored[i] = window(centre, group.radius);
        }
        for node in self.tree.nodes().iter().filter(|node| !node.is_bound) {
            let window = window(node.centre, node.radius);
            let outline = Outline::sphere(&self.axes, self.eye, node, window);
            self.outlines[node.number as usize] = outline;
        }
        for i in first_plane..nothing {
            let plane = &self.planes[i - first_plane];
            self.outlines[i] = Outline::rectangle(&self.axes, self.eye, plane);
        }
    }

    /// Moves the samples to their offset, and what each group covers of them the other way.
    #[cfg(feature = "lab")]
    fn move_samples(&mut self) {
        let Raster { corner, dx, dy } = &mut self.raster;
        *corner += *dx * self.offset.x + *dy * self.offset.y;
        self.axes.move_middle(-self.offset);
        let outlines = self.outlines.iter_mut().map(|outline| &mut outline.window);
        let windows = self.windows.iter_mut().chain(&mut self.mirrored);
        for window in windows.chain(outlines) {
            window.left -= self.offset.x;
            window.right -= self.offset.x;
            window.top -= self.offset.y;
            window.bottom -= self.offset.y;
        }
    }
}

/// What rounding takes a point of a sphere off it by.
fn slack(centre: Vec3A, radius: f32) -> f32 {
    SLACK * (centre.abs().max_element() + radius)
}

impl Rectangle {
    const NONE: Self = Self {
        centre: Vec3A::ZERO,
        half_x: 0.0,
        half_z: 0.0,
    };
}
