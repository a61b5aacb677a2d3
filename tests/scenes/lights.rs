use crate::Random;
use eightfold_tracer::scene::{Light, Spot};
use glam::vec3;

pub fn point(random: &mut Random) -> Light {
    let position = random.vector(vec3(-8.0, 0.2, -8.0), vec3(8.0, 9.0, 8.0));
    Light { drawn_radius: random.between(0.05, 0.4), ..Light::new(position, random.colour()) }
}

pub fn any(random: &mut Random) -> Light {
    let position = random.vector(vec3(-9.0, 6.0, -9.0), vec3(9.0, 12.0, 9.0));
    let (outer, soft) = (random.between(0.65, 1.25), random.between(0.1, 0.3));
    let light = Light {
        core: random.zero_or(0.0, 2.0),
        drawn_radius: random.between(0.0, 0.4),
        parallel: random.below(2) == 0,
        diameter: random.zero_or(0.1, 2.0),
        glow: random.zero_or(0.1, 2.0),
        ..Light::new(position, random.colour())
    };
    [light, spotlight(light, outer - soft, outer)][random.below(2)]
}

pub fn spotlight(light: Light, inner_angle: f32, outer_angle: f32) -> Light {
    Light { spot: Some(Spot { aim: -light.position, inner_angle, outer_angle }), ..light }
}
