use eightfold_tracer::maths::{cos, sin};
use eightfold_tracer::scene::{Camera, Scene};
use glam::{Vec3, vec3};

#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// In scene units.
    eye: Vec3,
    /// The point behind the middle of the disc, see [`DISC`].
    target: Vec3,
    /// The x and z of the upward direction, whose y is 1.
    tilt: [f32; 2],
}

/// The height of the disc's middle above the picture's, in half heights. All scenes begin and end
/// with a disc here.
pub(super) const DISC: f32 = 0.08;

pub(super) const fn view(eye: [f32; 3], target: [f32; 3]) -> View {
    View { eye: Vec3::from_array(eye), target: Vec3::from_array(target), tilt: [0.0, 0.0] }
}

impl View {
    pub const fn tilted(self, x: f32, z: f32) -> Self {
        Self { tilt: [x, z], ..self }
    }
}

/// Sets the camera to a shot at `time`, 0 to 1 from its start to its end.
///
/// Views are evenly spaced in time, on a Catmull-Rom spline. The first and last count twice, so at
/// a cut the camera keeps about half of its speed.
pub(super) fn move_camera(views: &[View], time: f32, field_of_view: f32, scene: &mut Scene) {
    let last = views.len() - 1;
    let time = time * last as f32;
    let from = (time as usize).min(last - 1);
    let weights = catmull_rom(time - from as f32);
    let [mut eye, mut target, mut up] = [Vec3::ZERO, Vec3::ZERO, Vec3::Y];
    for (number, weight) in
        [from.saturating_sub(1), from, from + 1, (from + 2).min(last)].into_iter().zip(weights)
    {
        let View { eye: of, target: to, tilt: [x, z] } = views[number];
        eye += of * weight;
        target += to * weight;
        up += vec3(x, 0.0, z) * weight;
    }
    let ahead = target - eye;
    let right = ahead.cross(up);
    // The factors are perpendicular, so lengths multiply.
    let half_height = sin(0.5 * field_of_view) / cos(0.5 * field_of_view);
    let down = ahead.cross(right) * (DISC * half_height / right.length());
    scene.camera = Camera { up, ..Camera::new(eye, target + down, field_of_view) };
    // Narrower pictures show everything of 4:3.
    scene.camera.min_aspect = 4.0 / 3.0;
}

/// Returns the weights of four consecutive views at `u`, 0 to 1 between the second and the third.
fn catmull_rom(u: f32) -> [f32; 4] {
    [
        ((2.0 - u) * u - 1.0) * u * 0.5,
        (3.0 * u - 5.0) * u * u * 0.5 + 1.0,
        ((4.0 - 3.0 * u) * u + 1.0) * u * 0.5,
        (u - 1.0) * u * u * 0.5,
    ]
}

#[cfg(test)]
mod tests {
    use super::{DISC, View, catmull_rom, move_camera, view};
    use eightfold_tracer::scene::Scene;
    use glam::Vec3;
    use proptest::array::uniform5;
    use proptest::prelude::*;

    const FIELD_OF_VIEW: f32 = 0.6;

    fn views() -> impl Strategy<Value = [View; 5]> {
        let coordinate = || -5.0_f32..5.0;
        let any = (coordinate(), coordinate(), coordinate(), 6.0_f32..20.0, -0.2_f32..0.2);
        let any = any.prop_map(|(x, y, z, away, tilt)| {
            view([x, y + 1.0, z + away], [x, y, z]).tilted(tilt, 0.0)
        });
        uniform5(any)
    }

    proptest! {
        #[test]
        fn camera_passes_through_views(views in views(), count in 2_usize..6) {
            let views = &views[..count];
            for (number, view) in views.iter().enumerate() {
                let mut scene = Scene::default();
                move_camera(views, number as f32 / (count - 1) as f32, FIELD_OF_VIEW, &mut scene);
                prop_assert!(scene.camera.eye.abs_diff_eq(view.eye, 1e-3));
                // The target is where the disc's middle is.
                let raster = scene.camera.raster(1600, 900);
                let middle = raster.corner + raster.dx * 799.5 + raster.dy * (449.5 - 450.0 * DISC);
                let to_target = (view.target - view.eye).normalize();
                prop_assert!(middle.normalize().abs_diff_eq(to_target, 1e-3));
                // The horizon has the slope of the tilt.
                let slope = raster.dx.y / raster.dx.with_y(0.0).length();
                prop_assert!((slope.abs() - view.tilt[0].abs()).abs() < 5e-3);
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
        // At the third view the weight of the first ends, and the fifth's begins.
        assert!(arriving[0].abs() < 0.01 && leaving[3].abs() < 0.01);
        for i in 1..4 {
            assert!((arriving[i] - leaving[i - 1]).abs() < 0.01, "view {i}");
        }
    }

    #[test]
    fn camera_from_above_has_its_own_up() {
        let from_above = [view([0.0, 9.0, 0.0], [0.0, 0.0, 0.0]).tilted(0.0, -1.0); 2];
        let mut scene = Scene::default();
        move_camera(&from_above, 0.5, FIELD_OF_VIEW, &mut scene);
        let raster = scene.camera.raster(160, 90);
        assert!(raster.dx.normalize().abs_diff_eq(Vec3::X, 1e-3));
    }
}
