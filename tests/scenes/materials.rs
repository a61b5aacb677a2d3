use crate::Random;
use eightfold_tracer::scene::{Material, Pattern};
use glam::{Vec3, vec3};

/// Returns a material with `kr + kt` of at most 1.
pub fn plain(random: &mut Random) -> Material {
    let kt = random.zero_or(0.2, 0.9);
    Material {
        colour: random.colour(),
        kd: random.between(0.0, 1.0),
        ks: random.zero_or(0.1, 1.0),
        exponent: random.between(1.0, 200.0),
        metallic: random.between(0.0, 1.0),
        anisotropy: random.zero_or(0.0, 1.0),
        kr: (1.0 - kt) * random.between(0.0, 1.0),
        fresnel: random.between(0.0, 1.0),
        kt,
        index: [random.between(0.5, 0.95), random.between(1.05, 2.4)][random.below(2)],
        ..Material::BLACK
    }
}

pub fn painted(random: &mut Random) -> Material {
    let material = plain(random);
    Material {
        tint: random.colour() * f32::from(u8::from(material.kt > 0.0)),
        pattern: swirled(random),
        // Grazing reflections in curved mirrors show patterns beyond the precision of f32.
        fresnel: 0.05 * material.fresnel,
        ..material
    }
}

pub fn extreme(random: &mut Random) -> Material {
    let material = painted(random);
    Material {
        exponent: random.power(0.0, 3.0),
        index: random.power(-1.0, 1.0),
        fresnel: random.zero_or(0.0, 1.0),
        tint: random.colour(),
        pattern: Pattern {
            waves: material.pattern.waves * random.power(-1.0, 2.0),
            edge: random.power(-1.0, 3.0),
            warp: random.between(0.0, 3.0),
            ..material.pattern
        },
        ..material
    }
}

/// Returns a pattern: stripes, checkers, marble, veins or spots, from soft to sharp. Half the
/// balances leave thin veins.
pub fn pattern(random: &mut Random) -> Pattern {
    let waves = [0; 3].map(|_| random.zero_or(0.2, 2.0));
    let max = random.one_of([1.0_f32, 0.2]);
    Pattern {
        waves: waves.into(),
        depth: random.between(0.2, 1.0),
        edge: random.power(-0.3, 1.6),
        balance: random.one_of([-1.0, 1.0]) * (1.0 - max * random.between(0.0, 1.0)),
        warp: random.zero_or(0.2, 3.0),
        grain: random.power(-0.5, 1.0),
        ..Pattern::NONE
    }
}

pub fn swirled(random: &mut Random) -> Pattern {
    let mut more = Random::new(random.clone().bits());
    Pattern {
        swirl: more.zero_or(0.02, 0.2),
        stretch: more.zero_or(0.2, 0.9),
        tint: more.colour(),
        ..pattern(random)
    }
}

pub fn shiny(random: &mut Random) -> Material {
    Material {
        colour: Vec3::splat(random.between(0.0, 0.6)),
        kd: random.between(0.0, 0.8),
        ks: random.between(0.1, 1.0),
        exponent: random.power(0.3, 3.0),
        metallic: random.between(-1.0, 1.0).max(0.0),
        ..Material::BLACK
    }
}

/// Colours differ by at least `step` of 255 in a channel.
pub fn numbered(number: usize, step: usize) -> Material {
    let digit = |unit: usize| (number / unit % 8 * step + 20) as f32 / 255.0;
    Material { colour: vec3(digit(1), digit(8), digit(64)), ..Material::BLACK }
}

/// Colours are unique to numbers below 64; channels are at least half of 255.
pub fn bright(number: usize) -> Material {
    let digit = |unit: usize| (128 + 30 * (number / unit % 4)) as f32 / 255.0;
    Material::matt(vec3(digit(1), digit(4), digit(16)), 0.8)
}
