use crate::sound::{self, Cue, Track};
use eightfold_tracer::presentation::Presentation;
use eightfold_tracer::scene::{Ambience, Film, Light, Material, Plane, Scene, Softbox, Waves};
use glam::Vec3;

/// The environment of one or two consecutive scenes. The first fields are as in [`Scene`]; colours
/// are linear.
pub(super) struct Environment {
    pub background: Vec3,
    pub sky: Vec3,
    pub ambient: Vec3,
    pub ambience: Ambience,
    pub haze: f32,
    pub haze_fall: f32,
    pub scatter: f32,
    /// See [`Film::vignette`].
    pub vignette: f32,
    /// The floor is endless, at y = 0.
    pub floor: Option<&'static Material>,
    pub lights: &'static [Light],
    pub softboxes: &'static [Softbox],
    /// In radians, see [`Camera::field_of_view`](eightfold_tracer::scene::Camera::field_of_view).
    pub field_of_view: f32,
    pub add: fn(Now, &mut Scene),
    /// Mirrors the picture or marks its squares.
    pub present: fn(Now, &mut Presentation),
}

impl Environment {
    /// Black, in clear air, without a floor.
    pub const EMPTY: Self = Self {
        background: Vec3::ZERO,
        sky: Vec3::ZERO,
        ambient: Vec3::ZERO,
        ambience: Ambience::UNIFORM,
        haze: 0.0,
        haze_fall: 0.0,
        scatter: 0.0,
        vignette: 0.0,
        floor: None,
        lights: &[],
        softboxes: &[],
        field_of_view: 0.6,
        add: |_, _| {},
        present: |_, _| {},
    };
}

#[derive(Clone, Copy)]
pub(super) struct Now {
    /// The bar of the show in which the environment was first shown.
    pub first: u32,
    pub beat: f32,
}

impl Now {
    pub fn cue(self, track: Track) -> Cue {
        sound::cue(track, self.first, self.beat)
    }
}

/// Half the side of a floor that seems endless: haze hides its edge.
const FAR: f32 = 400.0;

pub(super) const fn point(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light::new(Vec3::from_array(position), Vec3::from_array(colour))
}

/// `sizes` are half the width, half the height and the softness at distance 1.
pub(super) const fn softbox(aim: [f32; 3], sizes: [f32; 3], colour: [f32; 3]) -> Softbox {
    let [half_width, half_height, softness] = sizes;
    let [aim, colour] = [Vec3::from_array(aim), Vec3::from_array(colour)];
    Softbox { aim, half_width, half_height, softness, colour }
}

impl Environment {
    pub fn apply(&self, now: Now, scene: &mut Scene) {
        scene.background = self.background;
        scene.sky = self.sky;
        scene.ambient = self.ambient;
        scene.ambience = self.ambience;
        scene.haze = self.haze;
        scene.haze_fall = self.haze_fall;
        scene.scatter = self.scatter;
        scene.exposure = 1.0;
        scene.black_beyond = false;
        scene.film = Film { filmic: true, vignette: self.vignette, dither: 1.0 };
        scene.planes.clear();
        if let Some(&material) = self.floor {
            scene.planes.push(Plane::new(Vec3::ZERO, FAR, FAR, material));
        }
        scene.water = Waves::CALM;
        scene.lights.clear();
        for &light in self.lights {
            scene.lights.push(light);
        }
        scene.softboxes.clear();
        for &softbox in self.softboxes {
            scene.softboxes.push(softbox);
        }
        scene.spheres.clear();
        scene.blocks.clear();
        (self.add)(now, scene);
    }
}
