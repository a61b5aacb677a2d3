//! How the light of a frame is gathered: over its pixels, the time that the shutter is open, the lens, and the lamps.
//!
//! A frame is the mean of pictures that the library draws, each from another point of the lens at another time. So it works with
//! every quality. The points are those of one sampler, the same for every frame: what stands still in the picture does not flicker.

use crate::sampler::{MAX_POINTS, Sampler, Sequence, disc};
use eightfold_tracer::glam::{DVec2, Vec2, Vec3A, vec2};
use eightfold_tracer::scene::{Camera, Light, MAX_LIGHTS, Scene, Spot};

/// The most pictures of a frame.
pub const MAX_SAMPLES: usize = 4096;
const _: () = assert!(MAX_SAMPLES <= MAX_POINTS);

/// The share of a lamp's size that is left to it where its place is sampled: it must stay above 0 for shadows to have tints.
const REST: f32 = 1e-3;

/// How a frame is exposed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// The number of pictures, up to [`MAX_SAMPLES`].
    pub samples: usize,
    /// The share of the time between two frames that the shutter is open, from the frame's time on, 0 to 1.
    pub shutter: f32,
    /// The diameter of the lens, in scene units; 0 for a pinhole.
    pub aperture: f32,
    /// The distance along the line of sight at which things are sharp, in scene units; by default that of the point that the camera
    /// looks at.
    pub focus: Option<f32>,
    /// Whether each picture has the lamps with a size at other points of it.
    pub samples_lamps: bool,
}

/// One picture of a frame.
pub struct Shot {
    /// The share of the time between two frames that has passed since the frame's.
    pub delay: f32,
    /// Where in the pixel the sample is, in pixels from its centre.
    pixel: Vec2,
    /// Where on the lens, a disc of radius 1.
    lens: Vec2,
    /// Where on each lamp, a disc of radius 1.
    lamps: [Vec2; MAX_LIGHTS],
}

impl Exposure {
    /// Picture number `index`.
    pub fn shot(&self, index: usize) -> Shot {
        let mut sampler = Sampler::new(Sequence::Sobol, index, 0);
        let pixel = sampler.next_2d() - DVec2::splat(0.5);
        let lens = disc(sampler.next_2d());
        let delay = self.shutter * sampler.next_1d() as f32;
        Shot {
            delay,
            pixel: pixel.as_vec2(),
            lens: lens.as_vec2(),
            lamps: [(); MAX_LIGHTS].map(|()| disc(sampler.next_2d()).as_vec2()),
        }
    }

    /// Changes a scene to what a shot sees of it. Returns how far its samples have to be moved, in pixels of a picture so many
    /// pixels high.
    pub fn aim(&self, shot: &Shot, scene: &mut Scene, height: usize) -> Vec2 {
        if self.samples_lamps {
            move_lamps(scene, &shot.lamps);
        }
        shot.pixel + self.move_camera(shot.lens, &mut scene.camera, height)
    }

    /// Moves the camera to a point of the lens. The picture plane is moved back by as much as things in the plane of focus
    /// were: these keep their places.
    fn move_camera(&self, lens: Vec2, camera: &mut Camera, height: usize) -> Vec2 {
        let sight = camera.look_at - camera.eye;
        let forward = sight.normalize();
        let right = forward.cross(camera.up).normalize();
        let at = lens * 0.5 * self.aperture;
        let by = at.x * right + at.y * right.cross(forward);
        camera.eye += by;
        camera.look_at += by;
        let focus = self.focus.unwrap_or(sight.length());
        let pixel = 2.0 * (0.5 * camera.field_of_view).tan() / height as f32;
        // Pixels count down, and the lens's second axis is up.
        vec2(-at.x, at.y) / (focus * pixel)
    }
}

/// Moves each lamp with a size to a point of it, as seen from where the camera looks, and makes it nearly a point.
///
/// Where a lamp is drawn, what is drawn keeps its place: a second one without light stands in for it. If there is no room for
/// that among the scene's lights, the lamp stays as it is.
fn move_lamps(scene: &mut Scene, at: &[Vec2; MAX_LIGHTS]) {
    let target = scene.camera.look_at;
    for (i, at) in at.iter().enumerate().take(scene.lights.len()) {
        let light = scene.lights[i];
        if light.diameter == 0.0
            || (light.drawn_radius > 0.0 && scene.lights.try_push(unlit(&light, target)).is_err())
        {
            continue;
        }
        let axis = (light.position - target).normalize_or(Vec3A::Y);
        let (u, v) = axis.any_orthonormal_pair();
        scene.lights[i] = Light {
            position: light.position + 0.5 * light.diameter * (at.x * u + at.y * v),
            drawn_radius: 0.0,
            diameter: REST * light.diameter,
            ..light
        };
    }
}

/// A light that lights nothing: it is drawn, shining into a cone away from the scene that is as narrow as can be.
fn unlit(light: &Light, target: Vec3A) -> Light {
    Light {
        spot: Some(Spot {
            aim: (light.position - target).normalize_or(Vec3A::Y),
            cos_outer: 1.0 - 1e-6,
            cos_inner: 1.0,
        }),
        diameter: 0.0,
        ..*light
    }
}
