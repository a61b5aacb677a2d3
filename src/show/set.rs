//! The set of a scene of the show: air, floor, lamps, props.

use super::props::Prop;
use eightfold_tracer::scene::{Film, Light, Material, Plane, Scene, Waves};
use glam::Vec3;

/// The set of an act, or for several in a row.
pub(super) struct Set {
    /// See [`Scene::background`].
    pub background: Vec3,
    /// See [`Scene::sky`].
    pub sky: Vec3,
    /// See [`Scene::ambient`].
    pub ambient: Vec3,
    /// See [`Scene::haze`].
    pub haze: f32,
    /// See [`Scene::film`].
    pub film: Film,
    /// The material of the floor, a square about the origin at y = 0.
    pub floor: &'static Material,
    /// Half the side of the floor, in scene units.
    pub floor_half: f32,
    /// The slope of the waves on the floor, see [`Waves::slope`].
    pub swell: f32,
    /// The lights. Here a spotlight's aim may have any length.
    pub lights: &'static [Light],
    /// How much lights, copper bars and camera follow the kick of the drum, 0 to 1. With 0 no copper bars are seen.
    pub hit: f32,
    /// Objects, alone or in rows.
    pub props: &'static [Prop],
    /// Adds objects that no table describes, as they are so many beats after the set was first shown.
    pub special: Option<fn(f32, &mut Scene)>,
}

/// The film of the show: what is brighter than four fifths rolls off, and the corners of a wide picture are a quarter darker, which
/// leads the eye to the middle.
pub(super) const SHOW: Film = Film {
    shoulder: 0.8,
    vignette: 0.08,
    dither: 1.0,
    ..Film::PLAIN
};

/// Half the side of a floor that seems endless: haze hides its edge.
pub(super) const FAR: f32 = 100.0;

/// The length of the longest waves, in scene units: some of a letter's size are among them, and some that reach the horizon.
const SWELL: f32 = 9.0;
/// How much of their length they go on in a beat.
const PACE: f32 = 0.1;

/// An invisible point light, whose shadows are hard.
pub(super) const fn point(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light::new(Vec3::from_array(position), Vec3::from_array(colour))
}

/// An invisible light whose rays are parallel.
pub(super) const fn sun(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light::sun(Vec3::from_array(position), Vec3::from_array(colour))
}

impl Set {
    /// Replaces a scene's background, haze, lights and objects by those of the set, `beat` beats after it was first shown.
    pub fn apply(&self, beat: f32, scene: &mut Scene) {
        // Set the air and the film.
        scene.background = self.background;
        scene.sky = self.sky;
        scene.ambient = self.ambient;
        scene.haze = self.haze;
        scene.film = self.film;
        // Set the floor, and the waves on it.
        scene.planes.clear();
        let half = self.floor_half;
        let floor = Plane::new(Vec3::ZERO, half, half, *self.floor);
        scene.planes.push(floor);
        scene.water = Waves::CALM;
        if self.swell > 0.0 {
            scene.water = Waves {
                slope: self.swell,
                length: SWELL,
                phase: PACE * beat,
            };
        }
        // Set the lights.
        scene.lights.clear();
        for &light in self.lights {
            scene.lights.push(light);
        }
        // Set the props.
        scene.spheres.clear();
        scene.blocks.clear();
        scene.copper_bars.clear();
        for prop in self.props {
            prop.add_all(beat, scene);
        }
        if let Some(add) = self.special {
            add(beat, scene);
        }
    }
}
