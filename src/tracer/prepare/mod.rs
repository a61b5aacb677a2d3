//! Prepares a scene for tracing: a BVH, and lights and surfaces for packets.

mod ambience;
mod crowd;
mod film;
mod light;
mod object;
mod softbox;
mod surface;
mod tree;

pub(crate) use ambience::{Ambience, Bounds, CAPACITY, Neighbour, Tap};
#[cfg(test)]
pub(crate) use film::ROUND;
pub(crate) use film::{Colours, Dither, Film};
pub(crate) use light::{PreparedLight, ShadowCone, SpotCone};
pub(crate) use object::{Object, ObjectId};
pub(crate) use softbox::Softbox;
pub(crate) use surface::{Parameter, PerLane, SurfaceNumbers, SurfaceTable};
pub(crate) use tree::{BvhNode, GroupSet, MAX_GROUPS, Tree, VisibleGroups};

use crate::scene::{
    MAX_BLOCKS, MAX_LIGHTS, MAX_PLANES, MAX_SOFTBOXES, MAX_SOLIDS, Material, Plane, Scene,
    camera::Raster,
};
use crate::shapes::block;
use core::ops::Deref;
use glam::{Vec2, Vec3, Vec3A};

pub(crate) const MAX_OBJECTS: usize = MAX_SOLIDS + MAX_LIGHTS + MAX_PLANES + 1;

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
    pub fn planes(self) -> &'a [Plane] {
        &self.scene.planes
    }

    pub fn object(self, id: ObjectId) -> (Object<'a>, &'a Material) {
        object::of(self.scene, id)
    }
}

pub(crate) struct Prepared {
    pub is_clear: bool,
    pub haze: f32,
    pub haze_fall: f32,
    /// The direction and the colour of the light that the sky scatters.
    pub scattered: [Vec3A; 2],
    pub glows: bool,
    pub film: Film,
    pub eye: Vec3A,
    pub raster: Raster,
    pub pixel: f32,
    pub tree: Tree,
    pub ambience: Ambience,
    pub solids: usize,
    lights: [PreparedLight; MAX_LIGHTS],
    pub light_count: usize,
    softboxes: [Softbox; MAX_SOFTBOXES],
    softbox_count: usize,
    pub plane_count: usize,
    pub surfaces: [SurfaceNumbers; MAX_OBJECTS],
    /// By object: whether all its points have different keys in a crowd.
    pub glitters: [bool; MAX_OBJECTS],
    /// See [`block::hit_error`].
    pub block_errors: [f32; MAX_BLOCKS],
    pub has_patterns: bool,
    /// Whether any object is a block, or has a pattern or grooves.
    pub has_details: bool,
    /// The weight of primary rays: the exposure.
    pub weight: f32,
}

zero! { Film = Self::ZERO; }

zero! {
    Prepared {
        is_clear, haze, haze_fall, scattered, glows, film, eye, raster, pixel, tree, ambience, solids,
        lights, light_count, softboxes, softbox_count, plane_count, surfaces, glitters, block_errors,
        has_patterns, has_details, weight
    }
    Raster { corner, dx, dy }
}

impl Prepared {
    pub fn lights(&self) -> &[PreparedLight] {
        &self.lights[..self.light_count]
    }

    pub fn softboxes(&self) -> &[Softbox] {
        &self.softboxes[..self.softbox_count]
    }

    pub fn first_plane(&self) -> usize {
        self.solids + self.light_count
    }

    pub fn background(&self) -> usize {
        self.first_plane() + self.plane_count
    }

    /// Samples are `offset` pixels off the pixels' centres.
    pub fn prepare<'a>(
        &'a mut self,
        scene: &'a Scene,
        [width, height]: [usize; 2],
        offset: Vec2,
    ) -> World<'a> {
        self.is_clear = scene.haze == 0.0 && scene.sky == Vec3::ZERO && scene.scatter == 0.0;
        self.haze = surface::bounded(scene.haze);
        self.haze_fall = surface::bounded(scene.haze_fall);
        self.glows = scene.lights.iter().any(|light| light.glow > 0.0);
        self.film = Film::of(&scene.film, width, height);
        self.eye = scene.camera.eye.into();
        self.raster = scene.camera.raster(width, height);
        self.pixel = self.raster.dx.length();
        let Raster { corner, dx, dy } = &mut self.raster;
        *corner += *dx * offset.x + *dy * offset.y;
        self.solids = scene.solids();
        self.weight = scene.exposure;
        self.light_count = scene.lights.len();
        self.plane_count = scene.planes.len();
        self.tree.set(scene);
        self.has_patterns = false;
        self.has_details = !scene.blocks.is_empty();
        for i in 0..=self.background() {
            let (object, material) = object::of(scene, ObjectId::new(i));
            self.has_patterns |= material.pattern.depth != 0.0;
            self.has_details |= self.has_patterns || material.anisotropy > 0.0;
            self.glitters[i] = crowd::glitters(scene, &object, material);
            self.surfaces[i] = surface::surface(&object, material, scene);
        }
        for (error, block) in self.block_errors.iter_mut().zip(scene.blocks.iter()) {
            *error = block::hit_error(block, self.eye);
        }
        for (prepared, light) in self.lights.iter_mut().zip(scene.lights.iter()) {
            prepared.set(light, self.tree.solid_nodes(), scene.spheres.len());
        }
        self.softbox_count = scene.softboxes.len();
        for (prepared, softbox) in self.softboxes.iter_mut().zip(scene.softboxes.iter()) {
            *prepared = Softbox::of(softbox);
        }
        let lights = &self.lights[..self.light_count];
        self.scattered = lights.first().map_or([Vec3A::ZERO; 2], |sun| {
            [sun.position.normalize_or_zero(), sun.colour * scene.scatter]
        });
        self.ambience.set(scene, self.tree.solid_nodes(), lights);
        World { scene, prepared: self }
    }
}
