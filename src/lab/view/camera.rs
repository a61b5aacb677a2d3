use eightfold_tracer::glam::{Quat, Vec2};
use eightfold_tracer::scene::Camera;

/// The largest cosine between the view and `up`; at 1 there is no right vector.
const STEEPEST: f32 = 0.998;

const NOTCH: f32 = 1.1;

pub fn orbit(camera: &mut Camera, left: f32, upwards: f32) {
    let up = camera.up.normalize();
    let around = Quat::from_axis_angle(up, -left) * (camera.eye - camera.look_at);
    let right = up.cross(around).normalize();
    let over = Quat::from_axis_angle(right, -upwards) * around;
    let [before, after] = [around, over].map(|away| away.normalize().dot(up).abs());
    let is_too_steep = after > STEEPEST.max(before);
    camera.eye = camera.look_at + if is_too_steep { around } else { over };
}

/// Moves the camera sideways by pixels of a picture of this size, so that the target follows the pointer.
pub fn pan(camera: &mut Camera, by: Vec2, (width, height): (usize, usize)) {
    let picture = camera.raster(width, height);
    let distance = (camera.look_at - camera.eye).length();
    let offset = (picture.dx * by.x + picture.dy * by.y) * -distance;
    camera.eye += offset;
    camera.look_at += offset;
}

pub fn zoom(camera: &mut Camera, notches: i32) {
    let away = camera.eye - camera.look_at;
    camera.eye = camera.look_at + away * NOTCH.powi(-notches);
}

/// Formats the scene file's field, exact to the bit.
pub fn ron(camera: &Camera) -> String {
    format!("camera: {},\n", ron::to_string(camera).expect("numbers"))
}
