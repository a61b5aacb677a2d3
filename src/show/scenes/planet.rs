//! A banded giant and its moons; the drums move the sun.

use crate::show::environment::{Environment, Now, point};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_sphere, add_stars, around, fraction};
use crate::sound::Track;
use eightfold_tracer::maths::smooth_step;
use eightfold_tracer::scene::{Light, Material, Pattern, Scene, Spot};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.008, 0.01, 0.03),
    sky: vec3(0.0, 0.03, 0.05),
    ambient: vec3(0.001, 0.0016, 0.004),
    vignette: 0.3,
    lights: &[
        Light { diameter: 8.5, ..point([-400.0, 140.0, 40.0], [3.2, 2.9, 2.5]) },
        Light { core: 0.75, glow: 0.25, ..point([0.0; 3], [0.125, 0.25, 0.625]) },
        nebula([110.0, -20.0, -170.0], [0.16, 0.04, 0.12]),
        nebula([-90.0, 30.0, -170.0], [0.01, 0.08, 0.12]),
    ],
    add,
    ..Environment::EMPTY
};

/// A glow that lights no surface: it shines away from the giant.
const fn nebula(position: [f32; 3], colour: [f32; 3]) -> Light {
    let spot = Spot { aim: Vec3::NEG_Z, inner_angle: 0.0, outer_angle: 1.0 };
    Light { glow: 45.0, spot: Some(spot), ..point(position, colour) }
}

/// In units of the giant's radius.
const MOON: [f32; 3] = [-1.15, 0.28, 1.2];

static SHOTS: &[Shot] = &[
    shot(
        3,
        &[
            view([0.0, 0.0, 9.0], [0.0; 3]),
            view([0.6, 0.1, 5.8], [0.1, 0.0, 0.0]),
            view([1.0, 0.1, 4.6], [0.3, 0.0, 0.0]),
        ],
    ),
    shot(
        3,
        &[
            view([1.0, -0.4, 3.9], [-0.5, 0.1, 0.4]),
            view([0.4, 0.1, 4.9], [-0.7, 0.2, 0.6]),
            view([-1.05, 0.3, 1.76], MOON),
        ],
    ),
];

pub(super) static GIANT: Material = Material {
    pattern: Pattern {
        waves: vec3(0.0, 2.64, 0.0),
        depth: 1.0,
        edge: 0.9,
        balance: -0.05,
        grain: 1.8,
        swirl: 0.15,
        stretch: 0.8,
        tint: vec3(0.42, 0.17, 0.08),
        ..Pattern::NONE
    },
    ..Material::matt(vec3(0.78, 0.60, 0.38), 1.0)
};
static STONE: Material = Material {
    pattern: Pattern {
        waves: vec3(0.0, 9.0, 0.0),
        depth: 0.6,
        edge: 0.9,
        grain: 9.0,
        swirl: 0.2,
        ..Pattern::NONE
    },
    // Amplifies ambient light only.
    ..Material::matt(vec3(16.0, 15.0, 14.0), 0.03125)
};

fn add(now: Now, scene: &mut Scene) {
    add_sphere(Vec3::ZERO, 1.0, &GIANT, scene);
    add_sphere(Vec3::from_array(MOON), 0.065, &STONE, scene);
    for number in 0..7 {
        let moon = number as f32;
        let out = around(0.21 * moon + 0.012 * now.beat) * (1.75 + 0.16 * moon);
        // Outside the giant's shadow.
        let centre = out + Vec3::Y * (0.3 - 0.07 * out.x - 0.25 * out.z);
        add_sphere(centre, 0.05 + 0.18 * fraction(moon * 0.37), &STONE, scene);
    }
    add_stars(scene);
    let kick = now.cue(Track::Kick);
    let steps = kick.count as f32 - 1.0 + smooth_step(kick.since * 5.0);
    let sun = around(0.87 - 0.005 * steps) * 400.0 + Vec3::Y * 140.0;
    scene.lights[0].position = sun;
    scene.lights[1].spot = Some(Spot { aim: sun, inner_angle: 2.0, outer_angle: 3.0 });
}
