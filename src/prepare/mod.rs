//! What every ray of a frame uses, computed once a frame.

mod groups;
mod outline;
mod screen;
mod surface;

pub(crate) use groups::{GroupSet, Groups, MAX_GROUPS};
use outline::{Axes, Outline};
pub(crate) use screen::Window;
pub(crate) use surface::{FIELDS, Spread};

use crate::lanes::MAX_LANES;
use crate::scene::{MAX_LENGTH, MAX_LIGHTS, MAX_PLANES, MAX_SPHERES, Scene, camera::Raster};
use glam::Vec3;

/// How far rounding takes a point that was computed to be on a sphere from it, as a share of the sphere's largest
/// coordinate.
///
/// In roundings of 2^-24: 1.7 of the point's coordinates (the root of 3), 2.5 of its distance from the centre, 1.5 of the
/// ray's length, and 2.8 of the way from the centre, its square and the discriminant when the next ray is held against
/// the sphere: at most 8.5. Rays by the hundred million get as far as 5 (`rays_that_leave_a_sphere_do_not_hit_it_again`).
const SLACK: f32 = 10.0 / (1 << 24) as f32;

/// Objects a ray can hit: spheres, lights (drawn as spheres), planes, and the background.
pub(crate) const MAX_OBJECTS: usize = MAX_SPHERES + MAX_LIGHTS + MAX_PLANES + 1;

/// One frame's scene in the order the kernels want it.
///
/// Objects are numbered: spheres (as [`Groups`] order them), lights, planes, background.
pub(crate) struct Prepared {
    pub eye: Vec3,
    pub raster: Raster,
    /// Rows of the picture.
    pub height: usize,
    /// The solid spheres, then the lights' spheres.
    pub balls: [Ball; MAX_SPHERES + MAX_LIGHTS],
    pub groups: Groups,
    /// What each group covers of the picture.
    pub windows: [Window; MAX_GROUPS],
    pub axes: Axes,
    /// What each object covers of the picture.
    pub outlines: [Outline; MAX_OBJECTS],
    pub solids: usize,
    pub lamps: [Lamp; MAX_LIGHTS],
    pub lamp_count: usize,
    pub planes: [Rectangle; MAX_PLANES],
    pub plane_count: usize,
    pub surfaces: [Spread; MAX_OBJECTS],
    /// Where samples are, from the centres of their pixels, in pixels.
    #[cfg(feature = "lab")]
    pub offset: glam::Vec2,
}

/// A sphere as its intersection wants it.
#[derive(Clone, Copy)]
pub(crate) struct Ball {
    pub centre: Vec3,
    /// The radius squared.
    pub r2: f32,
    /// How far rounding takes a point on it from it, see [`SLACK`].
    pub slack: f32,
    /// What [`Ball::r2`] changes by where the radius changes by that.
    pub slack2: f32,
}

/// A horizontal rectangle.
#[derive(Clone, Copy)]
pub(crate) struct Rectangle {
    pub centre: Vec3,
    pub half_x: f32,
    pub half_z: f32,
}

/// A point light.
pub(crate) struct Lamp {
    pub position: Vec3,
    pub colour: Vec3,
    /// The solid spheres as shadow rays want them.
    pub casters: [Caster; MAX_SPHERES],
    /// The bounds of [`Groups::clusters`].
    pub cluster_casters: [Caster; MAX_GROUPS],
}

/// A sphere as shadow rays want it.
#[derive(Clone, Copy)]
pub(crate) struct Caster {
    /// The lamp seen from the centre.
    pub from_lamp: Vec3,
    /// The radius squared, less what rounding can add to the discriminant of a ray that leaves the sphere; where the
    /// lamp is inside, more by as much.
    pub r2: f32,
    /// Whether the lamp is inside.
    pub around_lamp: bool,
}

impl Prepared {
    /// An empty frame, all zeros.
    pub const fn new() -> Self {
        Self {
            eye: Vec3::ZERO,
            raster: Raster::NONE,
            height: 0,
            balls: [Ball::NONE; MAX_SPHERES + MAX_LIGHTS],
            groups: Groups::NONE,
            windows: [Window::ZERO; MAX_GROUPS],
            axes: Axes::NONE,
            outlines: [Outline::NONE; MAX_OBJECTS],
            solids: 0,
            lamps: [const { Lamp::NONE }; MAX_LIGHTS],
            lamp_count: 0,
            planes: [Rectangle::NONE; MAX_PLANES],
            plane_count: 0,
            surfaces: [[[0.0; MAX_LANES]; FIELDS]; MAX_OBJECTS],
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

    /// The groups that primary rays through the points of a rectangle of the picture can meet.
    #[inline(never)]
    pub fn seen(&self, left: usize, top: usize, right: usize, bottom: usize) -> GroupSet {
        let mut set = 0;
        for (i, _) in self.groups.iter().enumerate() {
            let meets =
                self.windows[i].meets([left as f32, top as f32, right as f32, bottom as f32]);
            set |= GroupSet::from(meets) << i;
        }
        set
    }

    /// Takes a scene in, for pictures of `width` by `height` pixels.
    pub fn set(&mut self, scene: &Scene, width: usize, height: usize) {
        self.eye = scene.camera.eye;
        self.raster = scene.camera.raster(width, height);
        self.height = height;
        self.solids = scene.spheres.len();
        self.lamp_count = scene.lights.len();
        self.plane_count = scene.planes.len();
        self.groups.set(scene);
        for (i, &number) in self.groups.order().iter().enumerate() {
            let sphere = &scene.spheres[number as usize];
            self.balls[i] = Ball::new(sphere.centre, sphere.radius);
            let surface = surface::solid(
                sphere.centre,
                1.0 / sphere.radius,
                &sphere.material,
                scene.ambient,
            );
            surface::spread(&surface, &mut self.surfaces[i]);
        }
        for (i, light) in scene.lights.iter().enumerate() {
            let i = self.solids + i;
            self.balls[i] = Ball::new(light.position, light.radius);
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
        for i in 0..scene.lights.len() {
            self.set_lamp(scene, i);
        }
    }

    /// Takes in what each object covers of the picture; the objects and groups are in already.
    #[inline(never)]
    fn set_outlines(&mut self, width: usize, height: usize) {
        self.axes = Axes::of(&self.raster, width, height);
        let (first_plane, nothing) = (self.first_plane(), self.nothing());
        let window = |centre: Vec3, radius: f32| {
            Window::of(centre, radius, self.eye, &self.raster, width, height)
        };
        for (window_of, group) in self.windows.iter_mut().zip(self.groups.iter()) {
            *window_of = window(group.centre, group.radius);
        }
        for i in 0..nothing {
            self.outlines[i] = if i < first_plane {
                let ball = &self.balls[i];
                let window = window(ball.centre, libm::sqrtf(ball.r2));
                Outline::sphere(&self.axes, self.eye, ball, window)
            } else {
                Outline::rectangle(&self.axes, self.eye, &self.planes[i - first_plane])
            };
        }
    }

    /// Moves the samples to their offset, and what each group covers of them the other way.
    #[cfg(feature = "lab")]
    fn move_samples(&mut self) {
        let Raster { corner, dx, dy } = &mut self.raster;
        *corner += *dx * self.offset.x + *dy * self.offset.y;
        self.axes.move_middle(-self.offset);
        let outlines = self.outlines.iter_mut().map(|outline| &mut outline.window);
        for window in self.windows.iter_mut().chain(outlines) {
            window.left -= self.offset.x;
            window.right -= self.offset.x;
            window.top -= self.offset.y;
            window.bottom -= self.offset.y;
        }
    }

    /// Takes the light number `i` in; the spheres and planes are in already.
    fn set_lamp(&mut self, scene: &Scene, i: usize) {
        let light = &scene.lights[i];
        let lamp = &mut self.lamps[i];
        lamp.position = light.position;
        let [_, _, _, red, green, blue, ..] = self.surfaces[self.solids + i];
        lamp.colour = Vec3::new(red[0], green[0], blue[0]);
        for (caster, ball) in lamp.casters.iter_mut().zip(&self.balls[..self.solids]) {
            let from_lamp = light.position - ball.centre;
            let around_lamp = from_lamp.length_squared() < ball.r2;
            // The roundings of the sphere's place and of the way from the lamp.
            let slack2 = ball.slack2 / ball.slack * (ball.slack + slack(from_lamp, 0.0));
            *caster = Caster {
                from_lamp,
                r2: ball.r2 + if around_lamp { slack2 } else { -slack2 },
                around_lamp,
            };
        }
        for (caster, cluster) in lamp.cluster_casters.iter_mut().zip(self.groups.clusters()) {
            let from_lamp = light.position - cluster.centre;
            let radius = cluster.radius + slack(from_lamp, cluster.radius);
            *caster = Caster {
                from_lamp,
                r2: radius * radius,
                // Its spheres may be between the lamp and whatever.
                around_lamp: false,
            };
        }
    }
}

impl Ball {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        r2: 0.0,
        slack: 0.0,
        slack2: 0.0,
    };

    /// A radius out of its range, or that is no number, counts as 0.
    fn new(centre: Vec3, radius: f32) -> Self {
        let is_length = (0.0..=MAX_LENGTH).contains(&radius);
        let radius = if is_length { radius } else { 0.0 };
        let slack = slack(centre, radius);
        Self {
            centre,
            r2: radius * radius,
            slack,
            slack2: 2.0 * radius * slack,
        }
    }
}

/// What rounding takes a point of a sphere off it by.
fn slack(centre: Vec3, radius: f32) -> f32 {
    SLACK * (centre.abs().max_element() + radius)
}

impl Rectangle {
    const NONE: Self = Self {
        centre: Vec3::ZERO,
        half_x: 0.0,
        half_z: 0.0,
    };
}

impl Lamp {
    const NONE: Self = Self {
        position: Vec3::ZERO,
        colour: Vec3::ZERO,
        casters: [Caster::NONE; MAX_SPHERES],
        cluster_casters: [Caster::NONE; MAX_GROUPS],
    };
}

impl Caster {
    const NONE: Self = Self {
        from_lamp: Vec3::ZERO,
        r2: 0.0,
        around_lamp: false,
    };
}
