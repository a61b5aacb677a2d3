//! Viewpoints (eye, mirrored eye, lights), and the bounds of spheres from there.

use super::screen::ScreenBounds;
use super::sides::Sides;
use crate::maths::sqrt;
use crate::prepare::{BvhNode, Object, PreparedLight};
use crate::rounding::{
    CONE_RADIUS_FACTOR, CORNER, CORNER_BY_LIGHT, MIN_HEIGHT, USUAL_SIDE_SHARE, hit_error,
    within_pixel,
};
use crate::scene::Plane;
use crate::zero::Zero;
use glam::{Vec3A, Vec4};

/// A viewpoint: the eye, its image in the first plane, or a light whose shadows the eye sees on a
/// plane.
///
/// For a shadow, the eye's ray d meets the plane in a point x, and the tests need `m (x - light)`
/// with `m = -d.y`. This vector is the sum of `m (x - c)` and `m (c - light)`, where c is the
/// object's centre. The first term is `H d + (c - eye) d.y`, where H is the eye's height. It lacks
/// the light's position, so distant lights add no error. The eye's own view sets H to 1 and m to 0,
/// which leaves d.
#[derive(Clone, Copy)]
pub(super) struct View {
    pub from: Vec3A,
    pub eye: Vec3A,
    pub axes: [Vec3A; 3],
    /// The vector from the eye to the light, and the light's height above the plane, divided by a
    /// common length; for the eye 0 and 1.
    pub to_light: Vec3A,
    pub above: f32,
    /// The plane's height, the eye's distance from it, and the sign of the eye's side. For the
    /// eye's own view 0, 1 and 0.
    pub ground: f32,
    pub height: f32,
    pub side: f32,
    pub corner: f32,
    /// The factor on `SIDE`: 1 for eyes and point lights, [`USUAL_SIDE_SHARE`] for other lights.
    pub rounding: f32,
}

zero! { View { from, eye, axes, to_light, above, ground, height, side, corner, rounding } }

impl View {
    pub fn eye(eye: Vec3A, axes: [Vec3A; 3], pixel: f32) -> Self {
        let corner = within_pixel(CORNER, pixel);
        Self { from: eye, eye, axes, above: 1.0, height: 1.0, corner, rounding: 1.0, ..Self::ZERO }
    }

    /// Returns the view from a light whose shadows on `plane` the eye sees.
    pub fn light(light: &PreparedLight, plane: &Plane, eye: &Self) -> Self {
        let (height, to_light) = (eye.eye.y - plane.centre.y, light.position - eye.eye);
        // Negative if the eye is below the plane, so that `above` is positive if the light is on
        // the eye's side.
        let scale = (1.0 / to_light.extend(height).length()).copysign(height);
        Self {
            from: light.position,
            to_light: to_light * scale,
            above: (light.position.y - plane.centre.y) * scale,
            ground: plane.centre.y,
            height: height.abs(),
            side: 1.0_f32.copysign(height),
            corner: CORNER_BY_LIGHT,
            rounding: if light.is_point { 1.0 } else { USUAL_SIDE_SHARE },
            ..*eye
        }
    }

    pub fn reach(&self, centre: Vec3A, radius: f32) -> f32 {
        (centre - self.from).length() + radius
    }

    /// Returns the bounds of a node's sphere or of its shadow.
    ///
    /// A bound `u = k` is a plane through the viewpoint that touches the sphere: its distance from
    /// the sphere's centre is the radius (Mara and McGuire: 2D Polyhedral Bounds of a Clipped,
    /// Perspective-Projected 3D Sphere, JCGT 2013; their axes are orthogonal, those of shadows are
    /// not). Its normal is `right - k forward`, and `down - k forward` for a bound of v.
    ///
    /// A light at the height L above the plane casts the shadow of a point p, at the height h, on a
    /// point x of the plane: `(L - h) n . (x - eye) = L n . (p - eye) - h n . (light - eye)`. The
    /// factor `L - h` is the same for all axes n, so it cancels in u and v. So a shadow has a
    /// sphere's tests with this equation's right side for `n . (p - eye)`: its gradient in p for
    /// the axis n, its value at the sphere's centre for `n . (centre - eye)`.
    #[inline(never)]
    pub fn screen(&self, node: &BvhNode, pixel: f32) -> ScreenBounds {
        let &Self { to_light, above, .. } = self;
        if above <= MIN_HEIGHT {
            return ScreenBounds::ALL;
        }
        let radius = (node.radius + node.hit_error) * CONE_RADIUS_FACTOR;
        let to = (node.centre - self.eye) * above - to_light * (node.centre.y - self.ground);
        let [right, down, (forward, ahead)] =
            self.axes.map(|n| (n * above - Vec3A::Y * n.dot(to_light), n.dot(to)));
        if ahead < -radius * forward.length() {
            return ScreenBounds::NONE;
        }
        let [u, v] = [right, down].map(|(normal, across)| {
            let between = forward * across - normal * ahead;
            let shared = normal.cross(forward) * radius;
            // Inside the sphere this is NaN, which sets no bound.
            let apart = sqrt(between.length_squared() - shared.length_squared());
            let [a, c] = [normal, forward].map(|normal| normal.dot(between) * radius);
            Vec4::new(a, apart * across, c, apart * ahead)
        });
        ScreenBounds::around(u, v, pixel)
    }

    /// Returns the rays that meet an object, or for a light the rays to the object's shadow on the
    /// plane.
    pub fn sides(&self, node: &BvhNode, object: &Object<'_>) -> Sides {
        let (to, by_eye) = (node.centre - self.from, node.centre - self.eye);
        let aside = by_eye * self.side;
        let scale = 1.0 / aside.extend(self.height).length();
        let rays =
            self.axes.map(|d| (d * self.height + aside * d.y).extend(-self.side * d.y) * scale);
        if let Object::Block(block) = object {
            let reach = by_eye.abs() + Vec3A::from(block.half);
            let slack = self.corner * reach.element_sum() + hit_error(node.centre, 0.0);
            return Sides::of_block(&rays, to, block, slack);
        }
        Sides::of_sphere(&rays, to, node)
    }
}
