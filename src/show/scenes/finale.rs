//! The finale: the sun slips behind a glass ball and, with its reflection in the sea, becomes an 8.

use crate::show::captions::Cue;
use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_block, add_sphere, around};
use crate::sound::Track;
use eightfold_tracer::maths::{sin, smooth_step};
use eightfold_tracer::presentation::{Method, Presentation};
use eightfold_tracer::scene::{Light, Material, Scene, Shape};
use glam::{Mat3, Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene =
    ShowScene { captions: CAPTIONS, ..ShowScene::new(&ENVIRONMENT, SHOTS) };

const SUN: [f32; 3] = [0.0, 26.0, -140.0];

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.65, 0.13, 0.09),
    sky: vec3(-0.62, -0.125, 0.03),
    ambient: vec3(0.35, 0.22, 0.42),
    haze: 0.0045,
    vignette: 0.25,
    floor: Some(&WATER),
    lights: &[Light { core: 17.0, glow: 3.0, ..point(SUN, [5.0, 2.9, 1.3]) }],
    field_of_view: 0.75,
    add,
    present,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[shot(
    6,
    &[
        view([0.0, 2.2, 19.0], SUN),
        view([-0.9, 2.2, 16.5], [0.0, 25.0, -140.0]),
        view([-0.9, 2.0, 13.5], [0.0, 5.4, -10.0]),
        view([0.0, 1.8, 11.8], [0.0, 2.2, 0.8]),
        view([0.0, 1.8, 11.8], [0.0, 2.2, 0.8]),
    ],
)];

#[rustfmt::skip]
static CAPTIONS: &[Cue] = &[
    Cue { first: 2.0, beats: 6.0, middle: 0.1, size: 0.03, text: "GREETINGS TO HEAVEN SEVEN" },
    Cue { first: 9.0, beats: 6.0, middle: 0.1, size: 0.03, text: "REALSTORM AND THE 2008 THESIS" },
];

static WATER: Material =
    Material { kr: 0.03, fresnel: 0.8, ..Material::matt(vec3(0.003, 0.03, 0.13), 0.0) };
static GLASS: Material = Material {
    ks: 0.9,
    exponent: 200.0,
    fresnel: 0.35,
    kt: 0.96,
    index: 1.5,
    tint: vec3(0.8, 0.75, 0.8),
    ..Material::BLACK
};
/// A film, no mirror, and dim highlights: the sun's would be thinner than a square.
const PLUM: Material = Material {
    ks: 0.05,
    exponent: 10.0,
    kr: 0.4,
    fresnel: 0.3,
    film_thickness: 210.0,
    ..Material::matt(vec3(0.476, 0.125, 0.193), 0.95)
};

/// Thick films make bands.
static PLANET: Material = Material { kd: 0.0, ks: 0.25, film_thickness: 400.0, ..PLUM };

/// The light of the gold square at the end, relative to the ambient light.
const GOLD: Vec3 = vec3(5.25, 4.7, 0.34);

const BALL: Vec3 = vec3(0.0, 2.2, 0.8);

fn add(now: Now, scene: &mut Scene) {
    let last = now.cue(Track::Marimba);
    if last.count > 0 {
        return end(last.since, scene);
    }
    // Sun and planets sink until bar 4.
    let sunk = 8.0 * smooth_step(now.beat / 16.0);
    scene.lights[0].position.y -= sunk;
    add_sphere(vec3(-60.0, 37.0 - sunk, -112.0), 24.0, &PLANET, scene);
    add_sphere(vec3(52.0 - 0.3 * now.beat, 20.0 - sunk, -130.0), 7.0, &PLANET, scene);
    add_sphere(BALL, 2.2, &GLASS, scene);
    // Two spiral arms float around the glass.
    let [mut out, mut radius] = [3.8, 0.4];
    for number in 0..4 {
        let number = number as f32;
        let up = Vec3::Y * radius * (0.55 + 0.15 * sin(now.beat * 0.8 - number));
        for arm in [-0.16, 0.26] {
            let turns = arm - 0.02 * number + 0.003 * now.beat;
            add_sphere(around(turns) * out + up, radius, &PLUM, scene);
        }
        (out, radius) = (1.42 * out, 1.35 * radius);
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
    let gold = Material::matt(GOLD * (1.0 - 2.0 * beats).max(0.0), 1.0);
    add_block(Shape::Box, BALL, Vec3::splat(0.3), Mat3::IDENTITY, &gold, scene);
}
