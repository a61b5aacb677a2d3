//! The places at which round and flat surfaces mirror a lamp to the eye, from the object's centre.

use glam::Vec3A;

/// Newton's steps to where a curved surface mirrors a lamp. Two are enough far from it; the others are for eyes and lamps that are
/// near.
const NEWTON_STEPS: usize = 8;

/// A place of a surface that mirrors a lamp to the eye, from the object's centre.
pub(crate) struct Mirror {
    pub p: Vec3A,
    /// The normal, of length 1.
    pub n: Vec3A,
    /// The curvature across an axis, along which there is none.
    pub curvature: f32,
    pub axis: Vec3A,
}

impl Mirror {
    /// On a sphere, without an axis, or on a cylinder about one, of length 1.
    ///
    /// Across the axis the normal halves the angle between the directions to the eye and the lamp. Unrolled, the way from the one
    /// to the other is straight, which tells the height.
    #[inline(never)]
    pub(super) fn round(eye: Vec3A, lamp: Vec3A, axis: Vec3A, radius: f32) -> Self {
        let heights = [eye, lamp].map(|point| point.dot(axis));
        let [eye, lamp] = [eye - axis * heights[0], lamp - axis * heights[1]];
        let mut n = (eye.normalize() + lamp.normalize()).normalize();
        let mut height = 0.0;
        for _ in 0..NEWTON_STEPS {
            let [near, far] = [eye, lamp].map(|point| point - n * radius);
            let [a, b] = [near, far].map(|way| 1.0 / way.length());
            height = (heights[0] * a + heights[1] * b) / (a + b);
            let half = near * a + far * b;
            let length = half.length();
            // As the normal turns by an angle, what halves the directions turns back by that times this.
            let back = 0.25 * radius * (a + b) * length;
            n = (n + (half / length - n) / (1.0 + back)).normalize();
        }
        Self {
            p: n * radius + axis * height,
            n,
            curvature: 1.0 / radius,
            axis,
        }
    }

    /// On the side towards the eye of two that are so far from the centre, with the normals `axis` and `-axis`.
    pub(super) fn flat(eye: Vec3A, lamp: Vec3A, axis: Vec3A, half: f32) -> Self {
        let n = axis * 1.0_f32.copysign(eye.dot(axis));
        let [above, lamp_above] = [eye, lamp].map(|point| point.dot(n) - half);
        let way = eye.lerp(lamp, above / (above + lamp_above));
        Self {
            p: way + n * (half - way.dot(n)),
            n,
            curvature: 0.0,
            axis,
        }
    }
}
