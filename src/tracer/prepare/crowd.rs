//! Crowds of mirrors and glass, see [`Quality::crowds`]: their images are too small and narrow to
//! interpolate.

use super::object::{self, Object, ObjectId};
use crate::quality::Quality;
use crate::scene::{Material, Scene};

/// The number of strong mirrors and glass solids that makes a crowd. With fewer, one in fifty
/// random scenes of 16 blocks is below 42 dB at the default quality.
const CROWD: usize = 12;

/// The least `kr + kt` of strong mirrors and glass: their images are in the presets' keys.
const STRONG: f32 = Quality::DEFAULT.key_weight;

/// The largest side of squares in a crowd, in pixels.
const SQUARE: usize = 4;

/// The sine of half the viewing angle above which a glass sphere's images are large enough.
const LARGE: f32 = 0.2;

impl Quality {
    /// Returns the quality for a scene. If it has a crowd, squares are smaller; otherwise
    /// [`Quality::crowds`] is false.
    pub(crate) fn in_scene(self, scene: &Scene) -> Self {
        let crowds = self.crowds && is_crowd(scene);
        let square = if crowds { self.square.min(SQUARE) } else { self.square };
        Self { square, crowds, ..self }
    }
}

fn is_crowd(scene: &Scene) -> bool {
    let solids = (0..scene.solids()).map(ObjectId::new);
    let strong = solids.filter(|&id| is_strong(object::of(scene, id).1));
    strong.count() >= CROWD
}

fn is_strong(material: &Material) -> bool {
    // Films reflect no objects, and glass with an index of 1 leaves the objects behind it in place.
    let mirrored = if material.film_thickness > 0.0 { 0.0 } else { material.kr };
    let bent = if material.index == 1.0 { 0.0 } else { material.kt };
    mirrored + bent >= STRONG
}

/// See [`Prepared::glitters`](super::Prepared::glitters).
pub(super) fn glitters(scene: &Scene, object: &Object<'_>, material: &Material) -> bool {
    let is_small = match object {
        Object::Sphere(sphere) => {
            let reach = LARGE * (sphere.centre - scene.camera.eye).length();
            material.kt == 0.0 || sphere.radius < reach
        }
        Object::Block(_) => true,
        Object::Plane(_) | Object::Light(_) | Object::Background => false,
    };
    is_small && is_strong(material)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{List, Sphere};
    use glam::Vec3;

    fn spheres<const N: usize>(material: Material) -> Scene {
        let spheres = List::of(&[Sphere::new(Vec3::ZERO, 1.0, material); N]);
        Scene { spheres, ..Scene::default() }
    }

    #[test]
    fn films_do_not_make_a_crowd() {
        let film = Material { kr: 0.9, kt: 0.9, film_thickness: 300.0, ..Material::BLACK };
        assert!(!is_crowd(&spheres::<CROWD>(film)));
        assert!(is_crowd(&spheres::<CROWD>(Material { index: 1.3, ..film })));
    }

    #[test]
    fn only_quality_with_crowds_has_small_squares() {
        let mirror = Material { kr: STRONG, ..Material::BLACK };
        let [few, many] = [spheres::<11>(mirror), spheres::<12>(mirror)];
        let square = |crowds, scene| Quality { crowds, ..Quality::DEFAULT }.in_scene(scene).square;
        assert_eq!([square(true, &few), square(false, &many), square(true, &many)], [8, 8, 4]);
    }
}
