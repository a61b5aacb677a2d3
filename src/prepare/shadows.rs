//! Which groups can throw a shadow on what.

use super::groups::{Group, GroupSet, Groups};
use crate::scene::{Plane, Scene};
use glam::Vec3;

/// The groups that can stand between a lamp and the spheres of a group.
pub(super) fn on_group(scene: &Scene, groups: &Groups, receiver: &Group, lamp: Vec3) -> GroupSet {
    let receives = Cone::new(receiver, lamp);
    let mut set = 0;
    for (i, caster) in groups.solid().iter().enumerate() {
        let itself = caster.balls() == receiver.balls();
        let possible = if itself {
            !receiver.is_single() || has_inside(scene, groups, receiver)
        } else {
            receives.meets(&Cone::new(caster, lamp))
        };
        set |= GroupSet::from(possible) << i;
    }
    set
}

/// The groups that can stand between a lamp and a plane.
pub(super) fn on_plane(groups: &Groups, plane: &Plane, lamp: Vec3) -> GroupSet {
    let height = plane.centre.y;
    let mut set = 0;
    for (i, caster) in groups.solid().iter().enumerate() {
        let (low, high) = (
            caster.centre.y - caster.radius,
            caster.centre.y + caster.radius,
        );
        let possible = high >= height.min(lamp.y) && low <= height.max(lamp.y);
        set |= GroupSet::from(possible) << i;
    }
    set
}

/// Whether rays can be inside the one sphere of a group, where it shadows itself: it is glass, or something is in it.
#[inline(never)]
fn has_inside(scene: &Scene, groups: &Groups, single: &Group) -> bool {
    let number = groups.order()[single.balls().start] as usize;
    let reaches = |p: Vec3, radius: f32| single.centre.distance(p) < single.radius + radius;
    // Spheres that rest on a plane touch it within rounding.
    let depth = single.radius * (1.0 - 1e-3);
    scene.spheres[number].material.kt > 0.0
        || reaches(scene.camera.eye, 0.0)
        || scene
            .spheres
            .iter()
            .enumerate()
            .any(|(i, s)| i != number && reaches(s.centre, s.radius))
        || scene
            .planes
            .iter()
            .any(|p| (p.centre.y - single.centre.y).abs() < depth)
}

/// What a lamp sees of a sphere.
struct Cone {
    to_centre: Vec3,
    distance: f32,
    radius: f32,
}

impl Cone {
    #[inline(never)]
    fn new(group: &Group, lamp: Vec3) -> Self {
        let to_centre = group.centre - lamp;
        Self {
            to_centre,
            distance: to_centre.length(),
            radius: group.radius,
        }
    }

    /// Whether the other sphere can stand between the lamp and this one.
    #[inline(never)]
    fn meets(&self, caster: &Self) -> bool {
        if self.distance <= self.radius || caster.distance <= caster.radius {
            return true;
        }
        if caster.distance - caster.radius > self.distance + self.radius {
            return false;
        }
        // The cones meet where the angle between their axes is at most the sum of their half angles.
        let (s1, s2) = (self.radius / self.distance, caster.radius / caster.distance);
        let cosine = |s: f32| libm::sqrtf((1.0 - s * s).max(0.0));
        let (c1, c2) = (cosine(s1), cosine(s2));
        let between = self.to_centre.dot(caster.to_centre) / (self.distance * caster.distance);
        // The margin is far above the rounding of these few operations.
        between >= c1 * c2 - s1 * s2 - 1e-4
    }
}
