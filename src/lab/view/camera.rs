//! The rays of a picture's pixels, and a camera that is moved by hand.
//!
//! Places in the picture are in pixels from its upper left corner, (0, 0); a pixel's sample is at its centre.

use crate::arguments::Size;
use eightfold_tracer::glam::{DQuat, DVec2, DVec3, dvec2};
use eightfold_tracer::scene::Camera;

/// The view of a camera: what it sees through each place of a picture.
pub struct View {
    pub eye: DVec3,
    /// Of length 1, perpendicular to each other.
    pub forward: DVec3,
    pub right: DVec3,
    pub up: DVec3,
    /// The side of a pixel at a distance of 1, in scene units.
    pub pixel: f64,
    middle: DVec2,
}

impl View {
    pub fn of(camera: &Camera, size: Size) -> Self {
        let eye = camera.eye.as_dvec3();
        let forward = (camera.look_at.as_dvec3() - eye).normalize();
        let right = forward.cross(camera.up.as_dvec3()).normalize();
        let angle = f64::from(camera.field_of_view);
        Self {
            eye,
            forward,
            right,
            up: right.cross(forward),
            pixel: 2.0 * (0.5 * angle).tan() / size.height as f64,
            middle: dvec2(size.width as f64, size.height as f64) * 0.5,
        }
    }

    /// The direction of the ray through a place, whose part along the camera's is of length 1.
    pub fn ray(&self, at: DVec2) -> DVec3 {
        let from_middle = (at - self.middle) * self.pixel;
        self.forward + self.right * from_middle.x - self.up * from_middle.y
    }

    /// How far a point is along the camera's direction.
    pub fn depth(&self, point: DVec3) -> f64 {
        (point - self.eye).dot(self.forward)
    }

    /// Where a point is seen; `None` if it is not before the camera.
    pub fn place(&self, point: DVec3) -> Option<DVec2> {
        let depth = self.depth(point);
        let away = point - self.eye;
        let from_middle = dvec2(away.dot(self.right), -away.dot(self.up));
        (depth > 0.0).then(|| self.middle + from_middle / (depth * self.pixel))
    }

    /// Where the ray through a place meets the plane through a point that is perpendicular to a direction; `None` if it does not, or
    /// so far away that a pixel more would be a leap.
    pub fn on_plane(&self, at: DVec2, point: DVec3, normal: DVec3) -> Option<DVec3> {
        let ray = self.ray(at);
        let t = (point - self.eye).dot(normal) / ray.dot(normal);
        let most = MOST_TIMES_AWAY * self.depth(point);
        (t > 0.0 && t < most).then(|| self.eye + ray * t)
    }
}

/// How many times as far away as it was an object may be dragged.
const MOST_TIMES_AWAY: f64 = 10.0;

/// How near to the camera's `up` its direction may come, as the cosine of the angle between: at 0 degrees there is no picture.
const STEEPEST: f64 = 0.998;

/// Turns a camera about the point that it looks at, by angles in radians: to the left, and upwards.
pub fn orbit(camera: &mut Camera, left: f64, upwards: f64) {
    let (target, up) = (camera.look_at.as_dvec3(), camera.up.as_dvec3().normalize());
    let around = DQuat::from_axis_angle(up, -left) * (camera.eye.as_dvec3() - target);
    let right = up.cross(around).normalize();
    let over = DQuat::from_axis_angle(right, -upwards) * around;
    let is_too_steep = over.normalize().dot(up).abs() > STEEPEST;
    let away = if is_too_steep { around } else { over };
    camera.eye = (target + away).as_vec3a();
}

/// Moves a camera and what it looks at by so many pixels, so that what is at the distance of that follows the pointer.
pub fn pan(camera: &mut Camera, size: Size, by: DVec2) {
    let view = View::of(camera, size);
    let distance = view.depth(camera.look_at.as_dvec3());
    let way = (view.up * by.y - view.right * by.x) * (view.pixel * distance);
    camera.eye += way.as_vec3a();
    camera.look_at += way.as_vec3a();
}

/// Moves a camera towards what it looks at, by so many notches of the wheel.
pub fn zoom(camera: &mut Camera, notches: f64) {
    let (eye, target) = (camera.eye.as_dvec3(), camera.look_at.as_dvec3());
    camera.eye = (target + (eye - target) * NOTCH.powf(-notches)).as_vec3a();
}

/// The factor of a notch of the wheel.
const NOTCH: f64 = 1.1;
