//! Bubbles that divide and burst.

use super::planet::GIANT;
use crate::show::environment::{Environment, Now, point, softbox};
use crate::show::path::view;
use crate::show::scene::{Shot, ShowScene, shot};
use crate::show::solids::{add_sphere, fraction};
use crate::sound::Track;
use eightfold_tracer::maths::{sin, smooth_step};
use eightfold_tracer::scene::{Light, Material, Pattern, Scene};
use glam::{Vec3, vec3};

pub(in crate::show) const SCENE: ShowScene = ShowScene::new(&ENVIRONMENT, SHOTS);

static ENVIRONMENT: Environment = Environment {
    background: vec3(0.19, 0.042, 0.06),
    sky: vec3(-0.18, -0.038, -0.03),
    ambient: vec3(0.2, 0.17, 0.2),
    vignette: 0.4,
    lights: &[
        Light { parallel: true, glow: 0.2, ..point([0.0, 0.06, -1.0], [1.0, 0.42, 0.26]) },
        Light { diameter: 0.5, ..point([-6.0, 3.0, 6.0], [2.0, 1.75, 1.5]) },
    ],
    softboxes: &[
        // Daylight, evening sun, and a pale sky above.
        softbox([-9.0, 2.0, 5.0], [0.6, 2.4, 2.4], [32.0, 28.0, 21.0]),
        softbox([9.0, -1.0, 5.0], [0.6, 2.4, 2.4], [16.0, 7.0, 4.0]),
        softbox([0.0, 1.0, 0.2], [2.5, 2.5, 2.5], [1.2, 1.0, 1.1]),
    ],
    add,
    ..Environment::EMPTY
};

static SHOTS: &[Shot] = &[
    shot(
        4,
        &[
            view([0.0, -1.5, 6.6], [0.0; 3]),
            view([0.8, -1.2, 7.2], [0.1, 0.0, 0.0]),
            view([0.5, -0.9, 8.2], [0.3, 0.0, 0.0]),
        ],
    ),
    shot(
        2,
        &[
            view([1.0, -0.3, 2.7], [0.5, 0.1, 0.0]),
            view([0.3, -0.8, 7.4], [0.2, 0.0, 0.0]),
            view([0.0, -0.7, 6.6], [0.0; 3]),
        ],
    ),
];

const FILM: Material =
    Material { kr: 0.22, fresnel: 0.9, kt: 0.97, tint: Vec3::ONE, ..Material::BLACK };

/// Through films, stronger swirls would tear.
static WORLD: Material = Material { pattern: Pattern { swirl: 0.08, ..GIANT.pattern }, ..GIANT };
static SPECK: Material = Material::matt(vec3(4.0, 2.4, 1.6), 0.9);

/// The bubbles' centres, at rest, and radii.
static BUBBLES: [(Vec3, f32); 8] = [
    (vec3(0.0, 0.0, 0.0), 0.78),
    (vec3(2.0, -0.95, 0.5), 0.6),
    (vec3(-2.6, 1.1, -0.6), 0.65),
    (vec3(-0.9, -1.6, 1.0), 0.3),
    (vec3(3.3, 1.4, -2.0), 0.55),
    (vec3(1.3, 1.8, -4.0), 0.4),
    (vec3(-4.5, -0.9, -3.0), 0.45),
    (vec3(3.6, -0.4, -1.0), 0.3),
];

fn add(now: Now, scene: &mut Scene) {
    // Dusk falls.
    scene.lights[0].colour *= 1.0 - 0.02 * now.beat;
    // One near the camera, and specks that rise far behind. The guard has no bounds of specks seen
    // in bubbles, so they are tiny.
    add_bubble(vec3(-2.0, -1.5, 3.2), 0.8, 3.0, now, scene);
    for number in 0..16 {
        let spread = (number * number) as f32 * 0.618_034;
        let up = fraction(now.beat * 0.02 + (number * number) as f32 * 0.754_877);
        let centre = vec3(14.0 * fraction(spread) - 7.0, 8.0 * up - 3.4, -8.0);
        add_sphere(centre, 0.013, &SPECK, scene);
    }
    // A world grows in the first bubble, from the size of a square.
    let world = smooth_step((now.beat - 14.0) / 8.5);
    if world > 0.06 {
        // Off the bubble's centre, the guard would miss that the bubble hides the world.
        add_sphere(float(0.0, now), 0.68 * world, &WORLD, scene);
    }
    let pop = now.cue(Track::Pop);
    for (number, &(centre, radius)) in BUBBLES.iter().enumerate() {
        // Bubble 1 divides from bubble 0 in bar 1, 2 and 3 from them in bar 2, and so on, on a note
        // each.
        let bar = usize::BITS - number.leading_zeros();
        let count = 1 << bar;
        let parent = number.saturating_sub(count / 2);
        let first = 4.0 * (bar as f32 + number as f32 / count as f32);
        let grown = smooth_step((now.beat - first) * 1.2).max(if number == 0 { 1.0 } else { 0.0 });
        // From beat 18 each note bursts one.
        let is_burst = now.beat >= 18.0 && number + usize::from(pop.digit) >= BUBBLES.len();
        if grown == 0.0 || is_burst {
            continue;
        }
        let centre = BUBBLES[parent].0.lerp(centre, grown) + float(number as f32, now) * grown;
        add_bubble(centre, radius * (0.2 + 0.8 * grown), number as f32, now, scene);
    }
}

/// Returns the offset of a floating bubble from its place at rest. Not inlined: saves 29 packed
/// bytes.
#[inline(never)]
fn float(number: f32, now: Now) -> Vec3 {
    Vec3::Y * (0.07 * sin(now.beat * 0.7 + 2.0 * number))
}

fn add_bubble(centre: Vec3, radius: f32, number: f32, now: Now, scene: &mut Scene) {
    let film_thickness = 220.0 + 70.0 * sin(0.4 * now.beat + 2.0 * number);
    add_sphere(centre, radius, &Material { film_thickness, ..FILM }, scene);
}
