use eightfold_tracer::scene::{Material, Pattern};
use glam::{Vec3, vec3};

const MATT: Material = Material { index: 1.5, ..Material::BLACK };

/// Returns the shadow tint of bluish glass with transmission coefficient `kt`.
const fn tint(kt: f32) -> Vec3 {
    vec3(0.65 * kt, 0.88 * kt, 1.1 * kt)
}

pub(super) static PAPER: Material =
    Material { colour: vec3(0.55, 0.55, 0.6), kd: 0.8, ks: 0.1, exponent: 10.0, kr: 0.25, ..MATT };

pub(super) static RED: Material =
    Material { colour: vec3(0.9, 0.15, 0.12), kd: 0.7, ks: 0.5, exponent: 40.0, kr: 0.25, ..MATT };

pub(super) static MIRROR: Material =
    Material { colour: vec3(0.9, 0.9, 0.95), kd: 0.2, ks: 0.8, exponent: 80.0, kr: 0.7, ..MATT };

pub(super) static BLUE: Material =
    Material { colour: vec3(0.15, 0.35, 0.9), kd: 0.7, ks: 0.5, exponent: 40.0, kr: 0.2, ..MATT };

pub(super) static GLASS: Material = Material {
    colour: vec3(0.95, 0.95, 0.95),
    kd: 0.05,
    ks: 0.8,
    exponent: 100.0,
    kr: 0.1,
    kt: 0.85,
    tint: tint(0.85),
    ..MATT
};

/// Glass without reflections, which would be faint and take a fifth of the time of a frame that the sphere fills.
pub(super) static CRYSTAL: Material = Material {
    colour: vec3(0.95, 0.95, 0.95),
    kd: 0.05,
    ks: 0.8,
    exponent: 100.0,
    kt: 0.9,
    tint: tint(0.9),
    ..MATT
};

pub(super) static GOLD: Material = Material {
    colour: vec3(0.98, 0.73, 0.38),
    kd: 0.45,
    ks: 0.9,
    exponent: 25.0,
    metallic: 1.0,
    kr: 0.2,
    ..MATT
};

/// Brushed brass. Reflections on thin or small objects would be hardly visible.
pub(super) static BRASS: Material =
    Material { kd: 0.4, ks: 0.75, exponent: 6.0, kr: 0.0, anisotropy: 0.95, ..GOLD };

pub(super) static SILVER: Material =
    Material { colour: vec3(0.85, 0.88, 0.95), kd: 0.4, ks: 0.8, exponent: 60.0, kr: 0.32, ..MATT };

/// Turned steel. Reflections would be hardly visible.
pub(super) static STEEL: Material = Material {
    colour: vec3(0.55, 0.62, 0.75),
    kd: 0.4,
    ks: 0.35,
    exponent: 10.0,
    metallic: 0.5,
    anisotropy: 0.9,
    ..MATT
};

pub(super) static SCARLET: Material =
    Material { colour: vec3(0.8, 0.11, 0.08), kd: 0.8, ks: 0.25, exponent: 25.0, ..MATT };

pub(super) static STRIPED: Material = Material {
    colour: vec3(0.9, 0.62, 0.1),
    kd: 0.8,
    ks: 0.4,
    exponent: 40.0,
    pattern: Pattern { waves: vec3(0.0, 2.0, 0.0), depth: 0.7, edge: 30.0, ..Pattern::NONE },
    ..MATT
};

pub(super) static MARBLE: Material = Material {
    colour: vec3(0.92, 0.86, 0.78),
    kd: 0.8,
    ks: 0.15,
    exponent: 20.0,
    pattern: Pattern {
        waves: vec3(1.0, 0.0, 0.0),
        depth: 0.5,
        edge: 3.0,
        balance: 0.85,
        warp: 0.75,
        grain: 0.9,
        ..Pattern::NONE
    },
    ..MATT
};

pub(super) static SANDSTONE: Material =
    Material { colour: vec3(0.62, 0.52, 0.44), kd: 0.8, ks: 0.2, exponent: 30.0, ..MATT };

/// Dark water that reflects lights and sky: the floor of the title, the machine and the finale.
pub(super) static WATER: Material = Material {
    colour: vec3(0.2, 0.2, 0.27),
    kd: 0.8,
    ks: 0.6,
    exponent: 60.0,
    kr: 0.45,
    fresnel: 0.6,
    ..MATT
};

pub(super) static NIGHT: Material =
    Material { colour: vec3(0.22, 0.24, 0.34), kd: 0.8, ks: 0.1, exponent: 20.0, kr: 0.24, ..MATT };
