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
        kd: 0.3730528,
        ks: 0.86748004,
        exponent: 6.057165,
        metallic: 0.2563344,
        anisotropy: 0.7507616,
        kr: 0.44518882,
        fresnel: 0.139616,
        kt: 0.6340433,
        index: 3.6204689,
        tint: vec3a(0.8228976, 0.5173248, 0.211752),
        pattern: Pattern {
            waves: vec3a(7.061792, 4.006064, 8.950336),
            depth: 0.5894608,
            edge: 2.83888,
            balance: 0.5566305,
            warp: 4.7274237,
            grain: 1.671696,
            ..Pattern::default()
        },
        ..Material::default()
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
            look_at: vec3a(-2.7494402, 7.139105, 1.0276489),
            up: vec3a(2.8351912, linear(&[(0.0, 1.0), (4.0, 2.0)], time), 4.629308),
            field_of_view: 0.40555197,
        },
        background: vec3a(6.2351847, 3.179456, 8.123728),
        sky: vec3a(5.3146, 2.4116583, 7.1087174),
        haze: 3.900816,
        exposure: 8.845089,
        film: Film {
            shoulder: 0.57893604,
            vignette: 0.2733632,
            dither: 0.76779044,
            tolerance: 0.4622176,
        },
        ambient: vec3a(1.566448, 6.5107203, 3.4549923),
        method: Method {
            points: 0.8399264,
            squares: 0.5343536,
            picture: 0.2287808,
            coarse: 7.23208,
            front: 0.4176352,
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
                    radius: 7.9534407,
                    material: material_material_001,
                },
            ],
        ),
        planes: List::of(
            &[
                Plane {
                    centre: vec3a(3.2319365, -2.87952, 7.0090256),
                    half_x: 5.4487844,
                    half_z: 2.3930562,
                    material: material_material_001,
                },
            ],
        ),
        water: Waves {
            slope: 0.01055584,
            length: 5.999856,
            phase: -4.1117435,
        },
        blocks: List::of(
            &[
                Block {
                    shape: Shape::Cylinder,
                    centre: vec3a(5.776801, -0.33465576, -6.4461117),
                    half: vec3a(6.721216, 3.665488, 6.721216),
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
                    material: material_material_001,
                },
            ],
        ),
        lights: List::of(
            &[
                Light {
                    position: vec3a(-2.4585285, 7.4300156, 1.3185596),
                    colour: vec3a(2.603552, 7.5478244, 4.492096),
                    drawn_radius: 1.436368,
                    parallel: true,
                    diameter: 6.38064,
                    glow: 3.324912,
                    spot: Some(Spot {
                        aim: vec3a(0.7537479, 0.04921478, -0.6553183),
                        cos_inner: 0.75,
                        cos_outer: 0.25,
                    }),
                    ..Light::default()
                },
            ],
        ),
        captions: List::of(
            &[
                Caption {
                    letters: List::of(b"\"8\\\x7f\n#"),
                    middle: 0.8990544,
                    size: 0.5934816,
                    brightness: 0.28790882,
                },
            ],
        ),
        copper_bars: List::of(
            &[
                CopperBar {
                    middle: 0.78233606,
                    height: 0.4767632,
                    colour: vec3a(0.17119041, 0.66561764, 0.36004478),
                    brightness: 0.85447204,
                },
            ],
        ),
        ..Scene::default()
    }
}
#[allow(unused, reason = "not every scene needs all of it")]
#[path = "../../../../scene_file/keys.rs"]
mod keys;
