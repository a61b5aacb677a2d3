//! Computes, once per frame, everything that does not change from ray to ray.

mod air;
mod cone;
mod film;
mod highlight;
mod lamp;
mod object;
mod outline;
mod screen;
mod shadow;
mod surface;
mod tree;

pub(crate) use air::Air;
#[cfg(test)]
pub(crate) use film::ROUND;
pub(crate) use film::{Dither, Film, Four};
use highlight::Highlights;
pub(crate) use highlight::{Highlight, MAX_HIGHLIGHTS};
pub(crate) use lamp::{Lamp, ShadowCone};
pub(crate) use object::{Object, ObjectId, is_crowd};
use outline::Outline;
pub(crate) use outline::SeenOutline;
use screen::ScreenBounds;
pub(crate) use screen::{Axes, Rect, rectangle};
use shadow::Shadows;
pub(crate) use surface::{PerLane, SURFACE_NUMBERS, Surface, SurfaceNumbers, SurfaceTable};
use tree::MAX_GROUPS;
pub(crate) use tree::{BvhNode, GroupSet, Tree};

use crate::scene::{MAX_LIGHTS, MAX_PLANES, MAX_SOLIDS, Material, Scene, camera::Raster};
use crate::shapes::plane::Rectangle;
use core::ops::Deref;
use glam::{Vec2, Vec3A};

/// The most objects that rays can hit: solids, lights (shown as spheres), planes, and the background.
pub(crate) const MAX_OBJECTS: usize = MAX_SOLIDS + MAX_LIGHTS + MAX_PLANES + 1;

/// The most outlines of objects, and of their mirror images in the first plane.
const MAX_IMAGES: usize = 2 * MAX_OBJECTS;

/// The most outlines: those, and one for the shadow of each solid on each plane by each light.
pub(crate) const MAX_OUTLINES: usize = MAX_IMAGES + MAX_PLANES * MAX_LIGHTS * MAX_SOLIDS;

/// The content of a frame: the scene, and what is computed of it once.
///
/// Objects are numbered: spheres come first, then boxes and cylinders, lights, planes, and the background.
#[derive(Clone, Copy)]
pub(crate) struct World<'a> {
    pub scene: &'a Scene,
    pub prepared: &'a Prepared,
}

impl Deref for World<'_> {
    type Target = Prepared;

    #[inline(always)]
    fn deref(&self) -> &Prepared {
        self.prepared
    }
}

impl<'a> World<'a> {
    /// An object and its material.
    pub fn object(self, id: ObjectId) -> (Object<'a>, &'a Material) {
        object::of(self.scene, id)
    }
}

/// All that is computed of the scene of one frame for the kernels.
pub(crate) struct Prepared {
    pub air: Air,
    pub film: Film,
    pub eye: Vec3A,
    pub raster: Raster,
    pub tree: Tree,
    /// For each group of the tree, a rectangle around it in the picture, and one around its image in the first plane.
    bounds: [[ScreenBounds; MAX_GROUPS]; 2],
    /// The groups that have an object.
    used_groups: GroupSet,
    pub axes: Axes,
    /// The outline of each object in the picture, by its number, the background's empty; then, if the first plane is a mirror,
    /// those of the images of solids and lights in it, in the same order.
    outlines: [Outline; MAX_IMAGES],
    /// A rectangle around each outline in the picture, by its number.
    pub screen: [ScreenBounds; MAX_OUTLINES],
    /// The shadows on planes. Their outlines have the numbers from `first_shadow` up.
    shadows: Shadows,
    pub first_shadow: usize,
    /// The number of outlines.
    pub outlined: usize,
    highlights: Highlights,
    /// The number of spheres and blocks.
    pub solids: usize,
    lamps: [Lamp; MAX_LIGHTS],
    pub lamp_count: usize,
    planes: [Rectangle; MAX_PLANES],
    pub plane_count: usize,
    surfaces: [SurfaceNumbers; MAX_OBJECTS],
    /// For each object, whether its pattern has edges.
    has_edges: [bool; MAX_OBJECTS],
    /// See [`object::glitters`].
    glitters: [bool; MAX_OBJECTS],
    /// Whether any object has a pattern.
    has_patterns: bool,
    /// Whether any object is a block, or has a pattern or grooves.
    has_details: bool,
    /// The weight of primary rays: the exposure.
    pub weight: f32,
}

/// The groups of the tree that rays through a part of the picture can meet.
#[derive(Clone, Copy, Default)]
pub(crate) struct VisibleGroups {
    /// Those that primary rays can meet.
    pub directly: GroupSet,
    /// Those that the reflections of primary rays in the first plane can meet.
    pub mirrored: GroupSet,
}

impl Prepared {
    /// All zeros: memory before a frame is prepared.
    pub const fn new() -> Self {
        Self {
            air: Air::ZERO,
            film: Film::ZERO,
            eye: Vec3A::ZERO,
            raster: Raster::ZERO,
            tree: Tree::ZERO,
            bounds: [[ScreenBounds::ZERO; MAX_GROUPS]; 2],
            used_groups: 0,
            axes: Axes::NONE,
            outlines: [Outline::NONE; MAX_IMAGES],
            screen: [ScreenBounds::ZERO; MAX_OUTLINES],
            shadows: Shadows::ZERO,
            first_shadow: 0,
            outlined: 0,
            highlights: Highlights::NONE,
            solids: 0,
            lamps: [const { Lamp::ZERO }; MAX_LIGHTS],
            lamp_count: 0,
            planes: [Rectangle::ZERO; MAX_PLANES],
            plane_count: 0,
            surfaces: [Surface::ZERO; MAX_OBJECTS],
            has_edges: [false; MAX_OBJECTS],
            glitters: [false; MAX_OBJECTS],
            has_patterns: false,
            has_details: false,
            weight: 0.0,
        }
    }

    /// The lamps.
    #[inline(always)]
    pub fn lamps(&self) -> &[Lamp] {
        &self.lamps[..self.lamp_count]
    }

    /// The planes.
    #[inline(always)]
    pub fn planes(&self) -> &[Rectangle] {
        &self.planes[..self.plane_count]
    }

    /// The surface of an object.
    #[inline(always)]
    pub fn surface(&self, id: ObjectId) -> &SurfaceNumbers {
        &self.surfaces[id.index()]
    }

    /// Whether any object is a block, or has a pattern or grooves.
    #[inline(always)]
    pub fn has_details(&self) -> bool {
        self.has_details
    }

    /// Whether any object has a pattern.
    #[inline(always)]
    pub fn has_patterns(&self) -> bool {
        self.has_patterns
    }

    /// Whether the pattern of an object has edges.
    #[inline(always)]
    pub fn has_edges(&self, id: ObjectId) -> bool {
        self.has_edges[id.index()]
    }

    /// Whether two points of an object tell nothing of what it shows between them.
    #[inline(always)]
    pub fn glitters(&self, id: ObjectId) -> bool {
        self.glitters[id.index()]
    }

    /// The object number of the first plane.
    pub fn first_plane(&self) -> usize {
        self.solids + self.lamp_count
    }

    /// The object number of the background.
    pub fn background(&self) -> usize {
        self.first_plane() + self.plane_count
    }

    /// The groups that rays through a rectangle of the picture can meet.
    pub fn visible_groups(&self, rect: Rect) -> VisibleGroups {
        let mut groups = VisibleGroups::default();
        let mut rest = self.used_groups;
        while rest != 0 {
            let i = rest.trailing_zeros() as usize % MAX_GROUPS;
            rest &= rest - 1;
            groups.directly |= GroupSet::from(self.bounds[0][i].meets(rect)) << i;
            groups.mirrored |= GroupSet::from(self.bounds[1][i].meets(rect)) << i;
        }
        groups
    }

    /// Prepares a scene for a picture of so many pixels along x and y, whose samples are off the centres of their pixels by so
    /// many pixels.
    pub fn prepare<'a>(
        &'a mut self,
        scene: &'a Scene,
        [width, height]: [usize; 2],
        offset: Vec2,
    ) -> World<'a> {
        self.air = Air::of(scene);
        self.film = Film::of(&scene.film, width, height);
        self.eye = scene.camera.eye.into();
        self.raster = scene.camera.raster(width, height);
        self.axes.set(&self.raster, width, height);
        self.move_samples(offset);
        self.solids = scene.solids();
        self.weight = scene.exposure;
        self.lamp_count = scene.lights.len();
        self.plane_count = scene.planes.len();
        self.tree.set(scene);
        self.has_patterns = false;
        self.has_details = !scene.blocks.is_empty();
        for i in 0..=self.background() {
            let (object, material) = object::of(scene, ObjectId::new(i));
            self.has_patterns |= material.pattern.depth != 0.0;
            self.has_details |= self.has_patterns || material.anisotropy > 0.0;
            self.has_edges[i] = object::has_edges(material);
            self.glitters[i] = object::glitters(scene, &object, material);
            self.surfaces[i] = Surface::numbers(&object, material, scene);
        }
        for (lamp, light) in self.lamps.iter_mut().zip(scene.lights.iter()) {
            lamp.set(light, self.tree.solid_nodes(), scene.spheres.len());
        }
        for (rectangle, plane) in self.planes.iter_mut().zip(scene.planes.iter()) {
            *rectangle = Rectangle {
                centre: plane.centre.into(),
                half_x: plane.half_x,
                half_z: plane.half_z,
            };
        }
        self.set_outlines(scene);
        self.set_highlights(scene);
        World {
            scene,
            prepared: self,
        }
    }

    /// Prepares the outlines, after the objects.
    fn set_outlines(&mut self, scene: &Scene) {
        self.bounds = [[ScreenBounds::NONE; MAX_GROUPS]; 2];
        self.used_groups = 0;
        let (first_plane, background) = (self.first_plane(), self.background());
        let first = scene.planes.first();
        let mirrors = usize::from(first.is_some_and(|plane| plane.material.is_specular()));
        // Images in waves may be anywhere.
        let is_calm = scene.water.are_calm();
        let mirrors = mirrors * usize::from(is_calm);
        self.first_shadow = background + 1 + mirrors * first_plane;
        let (mut eye, mut axes) = (self.eye, self.axes.clone());
        for (i, groups) in self.bounds[..=mirrors].iter_mut().enumerate() {
            for node in self.tree.nodes() {
                if node.is_bound {
                    continue;
                }
                let to = node.centre - eye;
                let number = i * (background + 1) + node.object.index();
                let outline = &mut self.outlines[number];
                let bounds = outline.set_sphere(&axes, to, node);
                self.used_groups |= node.groups;
                groups[node.groups.trailing_zeros() as usize].join(bounds);
                if let Object::Block(block) = object::of(scene, node.object).0 {
                    outline.set_block(&axes, to, block);
                }
                self.screen[number] = if outline.is_finite() {
                    bounds
                } else {
                    ScreenBounds::NONE
                };
            }
            // An image in a plane is what the eye's own image sees of the object.
            eye.y = 2.0 * self.planes[0].centre.y - eye.y;
            axes.mirror();
        }
        if !is_calm {
            self.bounds[1] = [ScreenBounds::ALL; MAX_GROUPS];
        }
        self.screen[first_plane..background].fill(ScreenBounds::ALL);
        self.screen[background] = ScreenBounds::NONE;
        let planes = &self.planes[..self.plane_count];
        for (outline, plane) in self.outlines[first_plane..].iter_mut().zip(planes) {
            outline.set_rectangle(&self.axes, self.eye, plane);
        }
        self.set_shadows();
    }

    /// Shifts the samples by an offset in pixels.
    fn move_samples(&mut self, offset: Vec2) {
        let Raster { corner, dx, dy } = &mut self.raster;
        *corner += *dx * offset.x + *dy * offset.y;
        self.axes.move_middle(-offset);
    }
}
