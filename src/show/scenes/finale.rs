//! The finale: the sun slips behind a glass ball and, with its reflection in the sea, becomes an 8.

use crate::show::captions::Cue;
use crate::show::environment::{Environment, Now, point, softbox};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere};
use crate::sound::Track;
use eightfold_tracer::maths::{sin, smooth_step};
use eightfold_tracer::scene::{
    Ambience, Light, Material, Method, Presentation, Scene, Shape, Waves,
};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene =
    ShowScene { captions: CAPTIONS, ..ShowScene::new(&ENVIRONMENT, SHOTS) };

const SUN: [f32; 3] = [0.0, 36.0, -140.0];

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.87, 0.207, 0.042),
    sky: vec3(-0.82, -0.191, 0.057),
    ambient: vec3(0.4, 0.2, 0.35),
    ambience: Ambience { occlusion: 1.0, reach: 0.5, ground: vec3(0.1, 0.025, 0.01), bounce: 0.0 },
    haze: 0.007,
    vignette: 0.25,
    floor: Some(&WATER),
    swell: Waves { slope: 0.0015, length: 10.0, phase: 0.1 },
    lights: &[
        Light { drawn_radius: 21.0, glow: 11.0, ..point(SUN, [5.0, 2.9, 1.3]) },
        point([0.0, 28.0, -60.0], [7.0, 3.6, 1.5]),
    ],
    // The blue night behind the camera.
    softboxes: &[softbox([-3.0, 5.0, 8.0], [0.9, 0.8, 2.5], [1.6, 2.4, 4.0])],
    field_of_view: 0.75,
    add,
    present,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[shot(
    6,
    &[
        view([0.0, 1.2, 19.0], SUN),
        view([-0.9, 1.1, 15.5], [0.0, 33.0, -140.0]),
        view([-0.9, 1.0, 12.5], [0.0, 5.4, -10.0]),
        view([0.0, 0.9, 10.8], [0.0, 2.2, 0.8]),
        view([0.0, 0.9, 10.8], [0.0, 2.2, 0.8]),
    ],
)];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 2.0, beats: 6.0, middle: 0.1, size: 0.03, text: "GREETINGS TO HEAVEN SEVEN" },
    Cue { first: 9.0, beats: 6.0, middle: 0.1, size: 0.03, text: "REALSTORM AND THE 2008 THESIS" },
];

static WATER: Material =
    Material { kr: 0.35, fresnel: 0.9, ..Material::matt(vec3(0.0112, 0.0062, 0.063), 0.0) };
static GLASS: Material = Material {
    ks: 0.9,
    exponent: 200.0,
    fresnel: 0.35,
    kt: 0.96,
    index: 1.5,
    tint: vec3(0.8, 0.75, 0.8),
    ..Material::BLACK
};
/// A film, no mirror: images of the sun in the balls would be thinner than a square.
static PLUM: Material = Material {
    ks: 0.25,
    exponent: 10.0,
    kr: 0.5,
    fresnel: 0.3,
    film_thickness: 210.0,
    ..Material::matt(vec3(0.476, 0.125, 0.193), 0.95)
};

/// The light of the gold square at the end, relative to the ambient light.
const GOLD: Vec3 = vec3(5.25, 4.7, 0.34);

const BALL: Vec3 = vec3(0.0, 2.2, 0.8);

fn add(now: Now, scene: &mut Scene) {
    let last = now.cue(Track::Marimba);
    if last.count > 0 {
        return end(last.since, scene);
    }
    // The sun sinks behind the ball until bar 4.
    scene.lights[0].position.y -= 14.0 * smooth_step(now.beat / 16.0);
    add_sphere(BALL, 2.2, &GLASS, scene);
    for row in 0..4 {
        let row = row as f32;
        let float = 0.06 * sin(now.beat * 0.8 + row);
        for side in [-1.0, 1.0] {
            let centre = vec3((2.0 + 0.62 * row) * side, 0.47 + float, 0.8 + 1.3 * row);
            add_sphere(centre, 0.38, &PLUM, scene);
        }
    }
}

fn present(now: Now, presentation: &mut Presentation) {
    if now.cue(Track::Marimba).count == 0 {
        // Squares grow on every second sixteenth of the last row of notes.
        let side = (1 << now.cue(Track::Square).count.div_ceil(2) & !1) as f32;
        presentation.method = Method { coarse: side, squares: side / 64.0, ..Method::PLAIN };
    }
}

/// Leaves one gold square until the last note.
fn end(beats: f32, scene: &mut Scene) {
    scene.planes.clear();
    scene.lights.clear();
    (scene.background, scene.sky) = (Vec3::ZERO, Vec3::ZERO);
    scene.ambience.occlusion = 0.0;
    let gold = Material::matt(GOLD * (1.0 - 2.0 * beats).max(0.0), 1.0);
    add_block(Shape::Box, BALL, Vec3::splat(0.3), Mat3::IDENTITY, &gold, scene);
}
