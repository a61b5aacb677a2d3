//! When what is seen, and from where: shots on the grid of bars.

use super::path::{Keyframe, go, key};
use super::{Set, captions, environment, props, swarm, title};
use crate::grid::{BAR, BEAT, BEATS_PER_BAR, LENGTH};
use crate::maths::smooth_step;
use crate::scene::Scene;
use crate::sound::pulse;

/// A way of the camera through a scene.
struct Shot {
    set: Set,
    /// Bars it takes.
    bars: u8,
    /// Bars of its scene that are over when it begins.
    before: u8,
    way: [Keyframe; 2],
}

#[rustfmt::skip]
static SHOTS: [Shot; 14] = [
    //             bars before  looks at           angle distance height
    shot(Set::Title,     6, 0, key([4.0, 1.0, 0.0],   0.9,  9.0, 0.4), key([0.0, 1.2, 0.0], -0.2, 14.6, 1.8)),
    shot(Set::Model,     4, 0, key([0.0, 0.9, 0.0],  -1.2,  8.0, 1.3), key([0.0, 0.9, 0.0],  0.9,  7.0, 1.3)),
    shot(Set::Model,     4, 4, key([0.4, 0.8, -0.6],  0.5,  4.0, 0.3), key([0.2, 0.9, 0.2], -0.9,  6.0, 2.6)),
    // The method: traced points, filled squares, then both with the picture, then the picture.
    shot(Set::Model,     2, 8, key([0.0, 0.9, 0.0], -1.0, 7.0, 1.8).marked(0.0, 0.0, 0.0), key([0.0, 0.9, 0.0], -0.5, 7.0, 1.6).marked(1.0, 0.0, 0.0)),
    shot(Set::Model,     2, 10, key([0.0, 0.9, 0.0], -0.5, 7.0, 1.6).marked(0.5, 0.3, 0.0), key([0.0, 0.9, 0.0], 0.0, 7.0, 1.3).marked(0.2, 0.5, 0.0)),
    shot(Set::Model,     2, 12, key([0.0, 0.9, 0.0], 0.0, 7.0, 1.3).marked(0.2, 0.4, 0.2), key([0.0, 0.9, 0.0], 0.5, 7.0, 1.0).marked(0.2, 0.4, 0.5)),
    shot(Set::Model,     2, 14, key([0.0, 0.9, 0.0], 0.5, 7.0, 1.0).marked(0.2, 0.3, 0.7), key([0.0, 0.9, 0.0], 1.0, 7.0, 0.7).marked(0.0, 0.0, 1.0)),
    shot(Set::Colonnade, 5, 0, key([-0.4, 1.6, -3.0], -0.4, 9.0, 0.1), key([0.1, 1.8, 2.0],   0.0,  7.8, 0.9)),
    shot(Set::Colonnade, 3, 5, key([0.0, 1.9, 5.0],    0.2, 6.0, 1.4), key([0.0, 1.9, 6.0],  -0.3,  5.0, 0.4)),
    shot(Set::Machine,   3, 0, key([-1.0, 1.6, 0.0],  -0.9, 7.0, 0.8), key([0.0, 1.7, 0.0],   0.0,  9.0, 2.0)),
    shot(Set::Machine,   3, 3, key([-0.4, 1.2, -1.0],  0.8, 6.0, 1.0), key([0.0, 1.7, 0.0],   0.5,  9.0, 2.6)),
    shot(Set::Swarm,     3, 0, key([0.0, 0.8, 0.0],    0.6, 12.0, 5.5), key([0.0, 2.0, 0.0], -1.2, 10.0, 3.4)),
    shot(Set::Swarm,     3, 3, key([0.0, 2.6, 0.0],   -1.2, 8.0, 0.4), key([0.0, 2.6, 0.0],   0.4,  9.0, 0.4)),
    shot(Set::Finale,    6, 0, key([0.0, 1.9, 0.0],   -0.3, 9.0, 0.2), key([0.0, 2.6, 0.0],   0.3, 15.0, 1.6)),
];

const fn shot(set: Set, bars: u8, before: u8, from: Keyframe, to: Keyframe) -> Shot {
    Shot {
        set,
        bars,
        before,
        way: [from, to],
    }
}

/// Seconds in which the show comes out of the dark, and goes back to it.
const DAWN: f32 = 1.0;
const DUSK: f32 = 2.0;

/// By what share the lamps of the machine and the field get brighter on a kick: seen, and not dazzling.
const FLASH: f32 = 0.3;

/// Makes a scene that of the show at `time` seconds, 0 to [`LENGTH`].
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
    let beat = (bar + f32::from(shot.before)) * BEATS_PER_BAR as f32;
    environment::apply(shot.set, scene);
    if matches!(shot.set, Set::Machine | Set::Swarm) {
        let brighter = 1.0 + FLASH * pulse(time).kick;
        for light in scene.lights.iter_mut() {
            light.colour *= brighter;
        }
    }
    go(&shot.way, bar / f32::from(shot.bars), scene);
    scene.fade = 1.0 - smooth_step(time / DAWN) + smooth_step((time - LENGTH) / DUSK + 1.0);
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
