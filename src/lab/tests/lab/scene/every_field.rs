//! Made of every_field.ron by `cargo lab scene --rust`.
#[allow(unused, reason = "not every scene needs all of it")]
use eightfold_tracer::{glam::*, scene::*};
use keys::*;
/// How long the scene plays, in seconds.
pub const LENGTH: f32 = 9.0;
/// The scene at a time in seconds.
pub fn scene(time: f32) -> Scene {
    let material_material_001 = Material {
        colour: hold(
            &[(0.0, vec3a(2.0, 5.0, 9.0)), (1.0, vec3a(9.0, 8.0, 2.0))],
            time.rem_euclid(1.0),
        ),
        kd: 0.60648966,
        ks: 0.3009168,
        exponent: 8.158096,
        metallic: 0.4897712,
        anisotropy: 0.18419841,
        kr: 0.67862564,
        fresnel: 0.3730528,
        kt: 0.86748004,
        index: 5.8381186,
        tint: vec3a(0.2563344, 0.7507616, 0.44518882),
        pattern: Pattern {
            waves: vec3a(1.39616, 6.3404326, 3.2847042),
            depth: 0.8228976,
            edge: 5.1732483,
            balance: -0.576496,
            warp: 7.061792,
            grain: 4.006064,
        },
    };
    let material_material_002 = Material {
        colour: vec3a(1.671696, 6.615968, 3.56024),
        kd: 0.85045123,
        ks: 0.5448784,
        exponent: 3.1537504,
        metallic: 0.7337328,
        anisotropy: 0.42816,
        kr: 0.122587204,
        fresnel: 0.61701447,
        kt: 0.3114416,
        index: 8.155754,
        tint: vec3a(0.50029606, 0.1947232, 0.6891504),
        pattern: Pattern {
            waves: vec3a(3.835776, 8.780048, 5.72432),
            depth: 0.2668592,
            edge: 7.6128645,
            balance: -0.0885728,
            warp: 1.5014079,
            grain: 6.44568,
        },
    };
    let material_material_003 = Material {
        colour: vec3a(4.386848, 1.33112, 6.275392),
        kd: 0.3219664,
        ks: 0.8163937,
        exponent: 5.5973873,
        metallic: 0.205248,
        anisotropy: 0.6996752,
        kr: 0.3941024,
        fresnel: 0.8885296,
        kt: 0.5829568,
        index: 3.135148,
        tint: vec3a(0.77181125, 0.4662384, 0.1606656),
        pattern: Pattern {
            waves: vec3a(6.550928, 3.4952, 8.439472),
            depth: 0.53837436,
            edge: 2.3280163,
            balance: 0.45445764,
            warp: 4.21656,
            grain: 1.160832,
        },
    };
    Scene {
        camera: Camera {
            eye: spline(
                &[
                    (0.0, vec3a(4.0, -2.0, -8.0)),
                    (3.0, vec3a(5.0, 2.0, 6.0)),
                    (6.0, vec3a(2.0, 4.0, 7.0)),
                ],
                time,
            ),
            look_at: vec3a(1.9192972, -4.1921597, 5.6963844),
            up: vec3a(5.0528407, linear(&[(0.0, 1.0), (4.0, 2.0)], time), 6.846958),
            field_of_view: 1.1389152,
        },
        background: vec3a(8.569552, 5.5138245, 2.458096),
        sky: vec3a(7.53225, 4.629308, 1.7263664),
        haze: 6.2351847,
        exposure: 3.179456,
        film: Film {
            shoulder: 0.8123728,
            vignette: 0.5068,
            dither: 0.2012272,
            tolerance: 0.69565445,
        },
        ambient: vec3a(3.900816, 8.845089, 5.7893605),
        method: Method {
            points: 0.2733632,
            squares: 0.76779044,
            picture: 0.4622176,
            coarse: 1.566448,
            front: 0.651072,
        },
        spheres: List::of(
            &[
                Sphere {
                    centre: smooth(
                        &[
                            (0.0, vec3a(0.0, 0.0, 1.0)),
                            (0.5, vec3a(0.0, 2.0, 0.0)),
                            (1.0, vec3a(0.0, 0.0, 1.0)),
                        ],
                        time.rem_euclid(1.0),
                    ),
                    radius: 2.287808,
                    material: material_material_001,
                },
            ],
        ),
        planes: List::of(
            &[
                Plane {
                    centre: vec3a(7.900673, 1.789216, -4.32224),
                    half_x: 7.7831526,
                    half_z: 4.7274237,
                    material: material_material_002,
                },
            ],
        ),
        water: Waves {
            slope: 0.03389952,
            length: 8.334225,
            phase: 0.55699253,
        },
        blocks: List::of(
            &[
                Block {
                    shape: Shape::Cylinder,
                    centre: vec3a(-5.554464, 4.3340797, -1.7773762),
                    half: vec3a(1.0555841, 5.999856, 1.0555841),
                    axes: {
                        let turn = linear(
                            &[(0.0, vec3a(0.0, 0.5, 0.0)), (8.0, vec3a(0.0, 13.0, 0.0))],
                            time,
                        );
                        Mat3A::from_cols(
                            vec3a(0.6712122, 0.72380745, -0.15992814),
                            vec3a(-0.56535417, 0.639409, 0.5210862),
                            vec3a(0.47942555, -0.2593434, 0.83838665),
                        ) * Mat3A::from_euler(EulerRot::YXZ, turn.y, turn.x, turn.z)
                    },
                    material: material_material_003,
                },
            ],
        ),
        lights: List::of(
            &[
                Light {
                    position: vec3a(2.210208, -3.901248, 5.987297),
                    colour: vec3a(4.93792, 1.882192, 6.8264647),
                    radius: 3.7707357,
                    parallel: true,
                    size: 8.715008,
                    glow: 5.65928,
                    spot: Some(Spot {
                        aim: vec3a(-0.6780256, 0.7208545, -0.14370094),
                        bright: 0.75,
                        dark: 0.25,
                    }),
                },
            ],
        ),
        captions: List::of(
            &[
                Caption {
                    letters: List::of(b"\"8\\\x7f\n#"),
                    middle: 0.33249122,
                    size: 0.8269184,
                    brightness: 0.5213456,
                },
            ],
        ),
        copper_bars: List::of(
            &[
                CopperBar {
                    middle: 0.21577281,
                    height: 0.7102001,
                    colour: vec3a(0.4046272, 0.8990544, 0.5934816),
                    brightness: 0.28790882,
                },
            ],
        ),
    }
}
#[allow(unused, reason = "not every scene needs all of it")]
#[path = "../../../../scene_file/keys.rs"]
mod keys;
