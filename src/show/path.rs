use eightfold_tracer::maths::{cos, sin};
use eightfold_tracer::scene::{Camera, Method, Scene};
use glam::{FloatExt, Vec3, Vec4, vec3, vec4};

/// The camera, relative to its target, and the overlay at a time of a shot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Keyframe {
    /// In scene units.
    look_at: Vec3,
    /// The angle about the y axis in radians, where 0 looks along z; the horizontal distance and the height in scene units; the
    /// roll as the slope of the horizon, positive if lower on the left.
    away: Vec4,
    /// Points, squares, picture and coarseness of a [`Method`].
    overlay: Vec4,
    front: f32,
}

pub(super) const fn keyframe(
    look_at: [f32; 3],
    angle: f32,
    distance: f32,
    height: f32,
) -> Keyframe {
    Keyframe {
        look_at: Vec3::from_array(look_at),
        away: vec4(angle, distance, height, 0.0),
        overlay: Vec4::Z,
        front: 0.0,
    }
}

impl Keyframe {
    pub const fn overlaid(self, points: f32, squares: f32, picture: f32, coarse: f32) -> Self {
        Self { overlay: vec4(points, squares, picture, coarse), ..self }
    }

    pub const fn swept(self, front: f32) -> Self {
        Self { front, ..self }
    }

    pub const fn rolled(self, roll: f32) -> Self {
        let [angle, distance, height, _] = self.away.to_array();
        Self { away: vec4(angle, distance, height, roll), ..self }
    }
}

/// Sets camera and overlay to a shot at `time`, 0 to 1 from its start to its end. `push` is the fraction by which the camera moves
/// closer to its target.
///
/// Keyframes are evenly spaced in time, on a Catmull-Rom spline with continuous speed. The first and last keyframes count twice:
/// the camera starts and arrives at about half of its speed, and does not stand still at a cut. Overlay and front change linearly.
pub(super) fn move_camera(keyframes: &[Keyframe], time: f32, push: f32, scene: &mut Scene) {
    let last = keyframes.len() - 1;
    let time = time * last as f32;
    let from = (time as usize).min(last - 1);
    let u = time - from as f32;
    let four = [from.saturating_sub(1), from, from + 1, (from + 2).min(last)];
    let [a, b, c, d] = four.map(|number| &keyframes[number]);
    let [wa, wb, wc, wd] = catmull_rom(u);
    let look_at = a.look_at * wa + b.look_at * wb + c.look_at * wc + d.look_at * wd;
    let away = a.away * wa + b.away * wb + c.away * wc + d.away * wd;
    scene.camera = orbit(look_at, away.x, away.y * (1.0 - push), away.z);
    scene.camera.up += vec3(cos(away.x), 0.0, sin(away.x)) * away.w;
    let overlay = b.overlay.lerp(c.overlay, u);
    scene.method = Method {
        points: overlay.x,
        squares: overlay.y,
        picture: overlay.z,
        coarse: overlay.w,
        front: b.front.lerp(c.front, u),
    };
}

/// Returns the weights of four consecutive keyframes of the uniform Catmull-Rom spline at `u`, 0 to 1 between the second and the
/// third. The cubic passes through these two; its slope at each is half the difference of its neighbours.
fn catmull_rom(u: f32) -> [f32; 4] {
    [
        ((2.0 - u) * u - 1.0) * u * 0.5,
        (3.0 * u - 5.0) * u * u * 0.5 + 1.0,
        ((4.0 - 3.0 * u) * u + 1.0) * u * 0.5,
        (u - 1.0) * u * u * 0.5,
    ]
}

/// Returns a camera with a [`Keyframe`]'s angle, distance and height.
pub(super) fn orbit(look_at: Vec3, angle: f32, distance: f32, height: f32) -> Camera {
    let away = vec3(distance * sin(angle), height, -distance * cos(angle));
    Camera::new(look_at + away, look_at, core::f32::consts::FRAC_PI_4)
}

#[cfg(test)]
mod tests {
    use super::{Keyframe, catmull_rom, keyframe, move_camera, orbit};
    use eightfold_tracer::scene::{Camera, Method, Scene};
    use proptest::array::uniform5;
    use proptest::prelude::*;

    fn keyframes() -> impl Strategy<Value = [Keyframe; 5]> {
        let coordinate = || -5.0_f32..5.0;
        let target = (coordinate(), coordinate(), coordinate(), -3.0_f32..3.0);
        let any = (target, 1.0_f32..20.0, 0.0_f32..5.0, -0.2_f32..0.2);
        let any = any.prop_map(|((x, y, z, angle), distance, height, roll)| {
            keyframe([x, y, z], angle, distance, height).rolled(roll).overlaid(
                roll.abs(),
                0.5,
                1.0,
                0.0,
            )
        });
        uniform5(any)
    }

    fn at(keyframes: &[Keyframe], time: f32) -> (Camera, Method) {
        let mut scene = Scene::default();
        move_camera(keyframes, time, 0.0, &mut scene);
        (scene.camera, scene.method)
    }

    proptest! {
        #[test]
        fn camera_passes_through_keyframes(keyframes in keyframes(), count in 2_usize..6) {
            let keyframes = &keyframes[..count];
            for (number, keyframe) in keyframes.iter().enumerate() {
                let (camera, method) = at(keyframes, number as f32 / (keyframes.len() - 1) as f32);
                let wanted = orbit(keyframe.look_at, keyframe.away.x, keyframe.away.y, keyframe.away.z);
                prop_assert!(camera.eye.abs_diff_eq(wanted.eye, 1e-3));
                prop_assert!(camera.look_at.abs_diff_eq(wanted.look_at, 1e-3));
                prop_assert!((method.points - keyframe.away.w.abs()).abs() < 1e-3);
                // The picture's right has the slope of the roll.
                let forward = (camera.look_at - camera.eye).with_y(0.0);
                let right = forward.cross(camera.up).normalize();
                let slope = right.y / right.with_y(0.0).length();
                prop_assert!((slope.abs() - keyframe.away.w.abs()).abs() < 1e-3);
            }
        }
    }

    #[test]
    fn camera_speed_is_continuous() {
        const STEP: f32 = 1.0 / 1024.0;
        let slope = |u: f32| {
            let (from, to) = (catmull_rom(u), catmull_rom(u + STEP));
            core::array::from_fn::<f32, 4, _>(|i| (to[i] - from[i]) / STEP)
        };
        let (arriving, leaving) = (slope(1.0 - STEP), slope(0.0));
        // When the camera passes the third keyframe, the first one drops out and a fifth comes in.
        assert!(arriving[0].abs() < 0.01 && leaving[3].abs() < 0.01);
        for i in 1..4 {
            assert!((arriving[i] - leaving[i - 1]).abs() < 0.01, "keyframe {i}");
        }
    }
}
