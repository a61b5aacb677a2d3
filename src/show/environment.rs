use super::props::Prop;
use eightfold_tracer::scene::{Film, Light, Material, Plane, Scene, Waves};
use glam::Vec3;

/// The environment of one scene or of several consecutive ones. The first fields are as in [`Scene`].
pub(super) struct Environment {
    pub background: Vec3,
    pub sky: Vec3,
    pub ambient: Vec3,
    pub haze: f32,
    pub film: Film,
    /// The floor is a square about the origin at y = 0.
    pub floor: &'static Material,
    /// Half its side, in scene units.
    pub floor_half: f32,
    /// See [`Waves::slope`].
    pub swell: f32,
    pub lights: &'static [Light],
    /// The response of lights, copper bars and camera to the kick drum, 0 to 1. At 0 there are no copper bars.
    pub kick_response: f32,
    pub props: &'static [Prop],
    /// Adds procedural objects, by the beats since the environment was first shown.
    pub procedural: Option<fn(f32, &mut Scene)>,
}

/// Highlights above four fifths roll off, and the corners of a wide picture are a quarter darker, which guides the eye to the
/// centre.
pub(super) const SHOW: Film = Film { shoulder: 0.8, vignette: 0.08, dither: 1.0, ..Film::PLAIN };

/// Half the side of a seemingly endless floor, whose edge haze hides.
pub(super) const FAR: f32 = 100.0;

/// The longest waves in scene units: the spectrum includes a letter's size, and lengths that are visible up to the horizon.
const SWELL: f32 = 9.0;
/// The waves' speed, in wavelengths per beat.
const PACE: f32 = 0.1;

pub(super) const fn point(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light::new(Vec3::from_array(position), Vec3::from_array(colour))
}

pub(super) const fn sun(position: [f32; 3], colour: [f32; 3]) -> Light {
    Light::sun(Vec3::from_array(position), Vec3::from_array(colour))
}

impl Environment {
    pub fn apply(&self, beat: f32, scene: &mut Scene) {
        scene.background = self.background;
        scene.sky = self.sky;
        scene.ambient = self.ambient;
        scene.haze = self.haze;
        scene.black_beyond = false;
        scene.film = self.film;
        scene.planes.clear();
        let half = self.floor_half;
        let floor = Plane::new(Vec3::ZERO, half, half, *self.floor);
        scene.planes.push(floor);
        scene.water = Waves::CALM;
        if self.swell > 0.0 {
            scene.water = Waves { slope: self.swell, length: SWELL, phase: PACE * beat };
        }
        scene.lights.clear();
        for &light in self.lights {
            scene.lights.push(light);
        }
        scene.spheres.clear();
        scene.blocks.clear();
        scene.copper_bars.clear();
        for prop in self.props {
            prop.add_all(beat, scene);
        }
        if let Some(add) = self.procedural {
            add(beat, scene);
        }
    }
}
