//! Made of motion.ron by `cargo lab scene --rust`.
use eightfold_tracer::glam::{EulerRot, Mat3A, vec3a};
use eightfold_tracer::scene::{
    Block, Camera, Light, List, Material, Plane, Scene, Sphere,
};
use keys::{hold, linear, smooth, spline};
/// How long the scene plays, in seconds.
pub const LENGTH: f32 = 8.0;
/// The scene at a time in seconds.
pub fn scene(time: f32) -> Scene {
    let material_ball = Material {
        colour: vec3a(0.9, 0.3, 0.1),
        kd: 0.8,
        ks: 0.5,
        exponent: 40.0,
        ..Material::default()
    };
    let material_floor = Material {
        colour: vec3a(0.6, 0.6, 0.6),
        kd: 0.7,
        kr: 0.2,
        ..Material::default()
    };
    let material_lamp = Material {
        colour: hold(
            &[
                (0.0, vec3a(0.2, 0.5, 0.9)),
                (1.0, vec3a(0.9, 0.8, 0.2)),
                (2.0, vec3a(0.2, 0.5, 0.9)),
            ],
            time.rem_euclid(2.0),
        ),
        kd: 0.8,
        ..Material::default()
    };
    Scene {
        camera: Camera {
            eye: spline(
                &[
                    (0.0, vec3a(0.0, 3.0, 8.0)),
                    (3.0, vec3a(5.0, 2.0, 6.0)),
                    (6.0, vec3a(2.0, 4.0, 7.0)),
                    (8.0, vec3a(0.0, 3.0, 8.0)),
                ],
                time,
            ),
            look_at: vec3a(0.0, 0.8, 0.0),
            up: vec3a(linear(&[(0.0, 0.0), (4.0, 0.1), (8.0, 0.0)], time), 1.0, 0.0),
            ..Camera::default()
        },
        background: vec3a(0.1, 0.1, 0.15),
        ambient: vec3a(0.15, 0.15, 0.15),
        spheres: List::of(
            &[
                Sphere {
                    centre: smooth(
                        &[
                            (0.0, vec3a(0.0, 0.5, 0.0)),
                            (0.5, vec3a(0.0, 1.8, 0.0)),
                            (1.0, vec3a(0.0, 0.5, 0.0)),
                        ],
                        time.rem_euclid(1.0),
                    ),
                    radius: 0.5,
                    material: material_ball,
                },
                Sphere {
                    centre: vec3a(-2.5, 0.5, -1.0),
                    radius: 0.5,
                    material: material_lamp,
                },
            ],
        ),
        planes: List::of(
            &[
                Plane {
                    centre: vec3a(0.0, 0.0, 0.0),
                    half_x: 12.0,
                    half_z: 12.0,
                    material: material_floor,
                },
            ],
        ),
        blocks: List::of(
            &[
                Block {
                    centre: vec3a(2.5, 0.7, -1.0),
                    half: vec3a(0.5, 0.5, 0.5),
                    axes: {
                        let turn = linear(
                            &[
                                (0.0, vec3a(0.0, 0.5, 0.0)),
                                (8.0, vec3a(0.0, 13.066371, 0.0)),
                            ],
                            time,
                        );
                        Mat3A::from_euler(EulerRot::YXZ, turn.y, turn.x, turn.z)
                    },
                    material: material_lamp,
                    ..Block::default()
                },
            ],
        ),
        lights: List::of(
            &[
                Light {
                    position: vec3a(-4.0, 6.0, 4.0),
                    colour: vec3a(0.9, 0.9, 0.9),
                    size: 0.5,
                    ..Light::default()
                },
            ],
        ),
        ..Scene::default()
    }
}
#[allow(dead_code, reason = "not every scene needs all of it")]
mod keys {
    //! Values between keys: times in seconds, in order, each with the value that it has then. Before the first key and after the last
    //! one a value keeps still.
    use std::ops::{Add, Mul, Sub};
    /// A value that can be interpolated.
    pub trait Value: Copy + Add<
            Output = Self,
        > + Sub<Output = Self> + Mul<f32, Output = Self> {}
    impl<T: Copy + Add<Output = T> + Sub<Output = T> + Mul<f32, Output = T>> Value
    for T {}
    /// At a constant speed from key to key.
    pub fn linear<T: Value>(keys: &[(f32, T)], time: f32) -> T {
        let (i, share) = position(keys, time);
        blend(keys, i, share)
    }
    /// Leaving each key slowly, and coming slowly to the next, by Hermite's smooth step.
    pub fn smooth<T: Value>(keys: &[(f32, T)], time: f32) -> T {
        let (i, share) = position(keys, time);
        blend(keys, i, share * share * (3.0 - 2.0 * share))
    }
    /// As the last key says, up to the next.
    pub fn hold<T: Value>(keys: &[(f32, T)], time: f32) -> T {
        keys[position(keys, time).0].1
    }
    /// Through the keys without a corner, by a Catmull-Rom spline: it passes a key at the mean speed between its neighbours.
    pub fn spline<T: Value>(keys: &[(f32, T)], time: f32) -> T {
        let (i, s) = position(keys, time);
        let start = keys[i];
        if s <= 0.0 {
            return start.1;
        }
        let end = keys[i + 1];
        let slope = |a: (f32, T), b: (f32, T)| {
            (b.1 - a.1) * ((end.0 - start.0) / (b.0 - a.0))
        };
        let leaving = slope(keys[i.saturating_sub(1)], end);
        let coming = slope(start, keys[(i + 2).min(keys.len() - 1)]);
        let (s2, s3) = (s * s, s * s * s);
        start.1 * (2.0 * s3 - 3.0 * s2 + 1.0) + end.1 * (3.0 * s2 - 2.0 * s3)
            + leaving * (s3 - 2.0 * s2 + s) + coming * (s3 - s2)
    }
    /// The index of the last key up to a time, and how far the time is from this key to the next, 0 to 1. Before the first key and after
    /// the last one that is 0.
    fn position<T>(keys: &[(f32, T)], time: f32) -> (usize, f32) {
        let next = keys.partition_point(|(at, _)| *at <= time);
        let i = next.saturating_sub(1);
        if next == 0 || next == keys.len() {
            return (i, 0.0);
        }
        let (from, to) = (keys[i].0, keys[next].0);
        (i, (time - from) / (to - from))
    }
    /// The value a share of the way from a key to the next. At the key it is the key's own to the bit, -0 included.
    fn blend<T: Value>(keys: &[(f32, T)], i: usize, share: f32) -> T {
        let start = keys[i].1;
        if share > 0.0 { start + (keys[i + 1].1 - start) * share } else { start }
    }
}
