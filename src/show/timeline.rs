//! The sequence of shots, on the grid of bars.

use super::path::{Keyframe, interpolate, key};
use super::{Set, captions, environment, props, swarm, title};
use crate::grid::{BAR, BEAT, BEATS_PER_BAR, SHOW_LENGTH};
use crate::maths::smooth_step;
use crate::scene::Scene;
use crate::sound::pulse;

/// One uninterrupted movement of the camera.
struct Shot {
    set: Set,
    /// Its length in bars.
    bars: u8,
    /// The bars since the set was first shown: the set's movements go on from shot to shot.
    since: u8,
    /// The camera at the beginning and at the end.
    keyframes: [Keyframe; 2],
}

#[rustfmt::skip]
static SHOTS: [Shot; 14] = [
    //             bars since   looks at           angle distance height
    shot(Set::Title,     6, 0, key([4.0, 1.0, 0.0],   0.9,  9.0, 0.4), key([0.0, 1.2, 0.0], -0.2, 14.6, 1.8)),
    shot(Set::Model,     4, 0, key([0.0, 0.9, 0.0],  -1.2,  8.0, 1.3), key([0.0, 0.9, 0.0],  0.9,  7.0, 1.3)),
    shot(Set::Model,     4, 4, key([0.4, 0.8, -0.6],  0.5,  4.0, 0.3), key([0.2, 0.9, 0.2], -0.9,  6.0, 2.6)),
    // The method: traced points, then filled squares, then both over the picture, then the picture alone.
    shot(Set::Model,     2, 8, key([0.0, 0.9, 0.0], -1.0, 7.0, 1.8).overlaid(0.0, 0.0, 0.0), key([0.0, 0.9, 0.0], -0.5, 7.0, 1.6).overlaid(1.0, 0.0, 0.0)),
    shot(Set::Model,     2, 10, key([0.0, 0.9, 0.0], -0.5, 7.0, 1.6).overlaid(0.5, 0.3, 0.0), key([0.0, 0.9, 0.0], 0.0, 7.0, 1.3).overlaid(0.2, 0.5, 0.0)),
    shot(Set::Model,     2, 12, key([0.0, 0.9, 0.0], 0.0, 7.0, 1.3).overlaid(0.2, 0.4, 0.2), key([0.0, 0.9, 0.0], 0.5, 7.0, 1.0).overlaid(0.2, 0.4, 0.5)),
    shot(Set::Model,     2, 14, key([0.0, 0.9, 0.0], 0.5, 7.0, 1.0).overlaid(0.2, 0.3, 0.7), key([0.0, 0.9, 0.0], 1.0, 7.0, 0.7).overlaid(0.0, 0.0, 1.0)),
    shot(Set::Colonnade, 5, 0, key([-0.4, 1.6, -3.0], -0.4, 9.0, 0.1), key([0.1, 1.8, 2.0],   0.0,  7.8, 0.9)),
    shot(Set::Colonnade, 3, 5, key([0.0, 1.9, 5.0],    0.2, 6.0, 1.4), key([0.0, 1.9, 6.0],  -0.3,  5.0, 0.4)),
    shot(Set::Machine,   3, 0, key([-1.0, 1.6, 0.0],  -0.9, 7.0, 0.8), key([0.0, 1.7, 0.0],   0.0,  9.0, 2.0)),
    shot(Set::Machine,   3, 3, key([-0.4, 1.2, -1.0],  0.8, 6.0, 1.0), key([0.0, 1.7, 0.0],   0.5,  9.0, 2.6)),
    shot(Set::Swarm,     3, 0, key([0.0, 0.8, 0.0],    0.6, 12.0, 5.5), key([0.0, 2.0, 0.0], -1.2, 10.0, 3.4)),
    shot(Set::Swarm,     3, 3, key([0.0, 2.6, 0.0],   -1.2, 8.0, 0.4), key([0.0, 2.6, 0.0],   0.4,  9.0, 0.4)),
    shot(Set::Finale,    6, 0, key([0.0, 1.9, 0.0],   -0.3, 9.0, 0.2), key([0.0, 2.6, 0.0],   0.3, 15.0, 1.6)),
];

const fn shot(set: Set, bars: u8, since: u8, from: Keyframe, to: Keyframe) -> Shot {
    Shot {
        set,
        bars,
        since,
        keyframes: [from, to],
    }
}

/// Seconds in which the show fades in at its start.
const FADE_IN: f32 = 1.0;
/// Seconds in which it fades out at its end.
const FADE_OUT: f32 = 2.0;

/// The share by which the lights of the machine and the swarm get brighter on a kick: visible, but not dazzling.
const FLASH: f32 = 0.3;

/// Sets a scene to that of the show at `time` seconds, 0 to [`SHOW_LENGTH`].
pub fn at(time: f32, scene: &mut Scene) {
    let mut bar = time / BAR;
    let mut shot = &SHOTS[0];
    for next in &SHOTS {
        shot = next;
        let left = bar - f32::from(shot.bars);
        if left < 0.0 {
            break;
        }
        bar = left;
    }
    let beat = (bar + f32::from(shot.since)) * BEATS_PER_BAR as f32;
    environment::apply(shot.set, scene);
    if matches!(shot.set, Set::Machine | Set::Swarm) {
        let brighter = 1.0 + FLASH * pulse(time).kick;
        for light in scene.lights.iter_mut() {
            light.colour *= brighter;
        }
    }
    interpolate(&shot.keyframes, bar / f32::from(shot.bars), scene);
    scene.fade =
        1.0 - smooth_step(time / FADE_IN) + smooth_step((time - SHOW_LENGTH) / FADE_OUT + 1.0);
    captions::apply(time / BEAT, scene);
    scene.spheres.clear();
    scene.blocks.clear();
    props::add(shot.set, beat, scene);
    match shot.set {
        Set::Title => title::add(beat, scene),
        Set::Swarm => swarm::add(beat, scene),
        _ => {}
    }
}
