//! Scenes of the library as descriptions, and descriptions as scenes.

use super::description::{
    Block, Camera, Caption, Description, Film, Light, Material, Method, Pattern, Plane, Sphere,
    Spot, Waves,
};
use eightfold::glam::{EulerRot, Mat3A};
use eightfold::scene::{self, List, Scene};
use std::collections::BTreeMap;

/// Conversions to and from the type of the same name in the library, field by field. Fields after a semicolon are
/// options.
macro_rules! same_fields {
    ($name:ident, $($field:ident),* $(; $($option:ident),*)?) => {
        impl From<scene::$name> for $name {
            fn from(from: scene::$name) -> Self {
                Self {
                    $($field: from.$field.into(),)*
                    $($($option: from.$option.map(Into::into),)*)?
                }
            }
        }

        impl From<$name> for scene::$name {
            fn from(from: $name) -> Self {
                Self {
                    $($field: from.$field.into(),)*
                    $($($option: from.$option.map(Into::into),)*)?
                }
            }
        }
    };
}

same_fields!(Camera, eye, look_at, up, field_of_view);
same_fields!(Film, shoulder, vignette, dither, tolerance);
same_fields!(Method, points, squares, picture, coarse, front);
same_fields!(Pattern, waves, depth, edge, balance, warp, grain);
same_fields!(
    Material, colour, kd, ks, exponent, metallic, anisotropy, kr, fresnel, kt, index, tint, pattern
);
same_fields!(Waves, slope, length, phase);
same_fields!(Spot, aim, dark, bright);
same_fields!(Light, position, colour, radius, parallel, size, glow; spot);

impl From<scene::Caption> for Caption {
    fn from(caption: scene::Caption) -> Self {
        Self {
            letters: String::from_utf8_lossy(&caption.letters).into_owned(),
            middle: caption.middle,
            size: caption.size,
            brightness: caption.brightness,
        }
    }
}

impl From<Caption> for scene::Caption {
    fn from(caption: Caption) -> Self {
        Self {
            letters: List::of(caption.letters.as_bytes()),
            middle: caption.middle,
            size: caption.size,
            brightness: caption.brightness,
        }
    }
}

impl Description {
    /// A scene as it stands, without motion.
    pub fn of(scene: &Scene) -> Self {
        let mut names = material_names(std::slice::from_ref(scene)).into_iter();
        Self::named(scene, || names.next().unwrap_or_default())
    }

    /// Scenes that have the same objects, as they stand. Objects share a material if it is the same in all scenes; materials are
    /// numbered in the order in which objects first have them.
    pub fn of_each(scenes: &[Scene]) -> Vec<Self> {
        let names = material_names(scenes);
        scenes
            .iter()
            .map(|scene| {
                let mut names = names.iter();
                Self::named(scene, || names.next().cloned().unwrap_or_default())
            })
            .collect()
    }

    /// A scene whose materials have names, one for each object: spheres, then planes, then blocks.
    fn named(scene: &Scene, mut name: impl FnMut() -> String) -> Self {
        let mut materials = BTreeMap::new();
        let mut material = |material: scene::Material| {
            let name = name();
            materials.insert(name.clone(), material.into());
            name
        };
        let spheres = scene.spheres.iter().map(|sphere| Sphere {
            centre: sphere.centre.into(),
            radius: sphere.radius,
            material: material(sphere.material),
        });
        let spheres = spheres.collect();
        let planes = scene.planes.iter().map(|plane| Plane {
            centre: plane.centre.into(),
            half_x: plane.half_x,
            half_z: plane.half_z,
            material: material(plane.material),
        });
        let planes = planes.collect();
        let blocks = scene.blocks.iter().map(|block| Block {
            shape: block.shape,
            centre: block.centre.into(),
            half: block.half.into(),
            axes: block.axes.to_cols_array_2d(),
            turn: [0.0; 3],
            material: material(block.material),
        });
        let blocks = blocks.collect();
        Self {
            length: 0.0,
            camera: scene.camera.into(),
            background: scene.background.into(),
            sky: scene.sky.into(),
            haze: scene.haze,
            fade: scene.fade,
            film: scene.film.into(),
            ambient: scene.ambient.into(),
            method: scene.method.into(),
            materials,
            spheres,
            planes,
            water: scene.water.into(),
            blocks,
            lights: scene.lights.iter().map(|&light| light.into()).collect(),
            captions: scene
                .captions
                .iter()
                .map(|&caption| caption.into())
                .collect(),
            motions: Vec::new(),
        }
    }

    /// The scene, without its motions. Objects whose material has no entry are black.
    pub fn scene(self) -> Scene {
        let materials: BTreeMap<String, scene::Material> = self
            .materials
            .into_iter()
            .map(|(name, material)| (name, material.into()))
            .collect();
        let material = |name: &str| {
            materials
                .get(name)
                .copied()
                .unwrap_or(scene::Material::BLACK)
        };
        let mut scene = Scene {
            camera: self.camera.into(),
            background: self.background.into(),
            sky: self.sky.into(),
            haze: self.haze,
            fade: self.fade,
            film: self.film.into(),
            ambient: self.ambient.into(),
            method: self.method.into(),
            water: self.water.into(),
            ..Scene::default()
        };
        for sphere in self.spheres {
            scene.spheres.push(scene::Sphere {
                centre: sphere.centre.into(),
                radius: sphere.radius,
                material: material(&sphere.material),
            });
        }
        for plane in self.planes {
            scene.planes.push(scene::Plane {
                centre: plane.centre.into(),
                half_x: plane.half_x,
                half_z: plane.half_z,
                material: material(&plane.material),
            });
        }
        for block in self.blocks {
            scene.blocks.push(scene::Block {
                centre: block.centre.into(),
                half: block.half.into(),
                axes: turned(&block),
                shape: block.shape,
                material: material(&block.material),
            });
        }
        for light in self.lights {
            scene.lights.push(light.into());
        }
        for caption in self.captions {
            scene.captions.push(caption.into());
        }
        scene
    }
}

/// A block's axes after its turn. Without one they are as they are written, to the bit.
fn turned(block: &Block) -> Mat3A {
    let axes = Mat3A::from_cols_array_2d(&block.axes);
    if block.turn == [0.0; 3] {
        return axes;
    }
    let [x, y, z] = block.turn;
    let turn = Mat3A::from_euler(EulerRot::YXZ, y, x, z);
    // A product with the identity would lose the signs of zeros.
    if axes == Mat3A::IDENTITY {
        turn
    } else {
        axes * turn
    }
}

/// The name of each object's material: of spheres, then planes, then blocks, as many as the first scene has.
fn material_names(scenes: &[Scene]) -> Vec<String> {
    let series: Vec<Vec<scene::Material>> = scenes.iter().map(materials).collect();
    let objects = series.first().map_or(0, Vec::len);
    let mut known: Vec<usize> = Vec::new();
    (0..objects)
        .map(|object| {
            let is_same = |&other: &usize| {
                series
                    .iter()
                    .all(|scene| scene.get(object) == scene.get(other))
            };
            let number = known.iter().position(is_same).unwrap_or_else(|| {
                known.push(object);
                known.len() - 1
            });
            // As many digits for all, so that they are in order.
            format!("material {:03}", number + 1)
        })
        .collect()
}

/// The materials of a scene's spheres, planes and blocks.
fn materials(scene: &Scene) -> Vec<scene::Material> {
    let spheres = scene.spheres.iter().map(|sphere| sphere.material);
    let planes = scene.planes.iter().map(|plane| plane.material);
    let blocks = scene.blocks.iter().map(|block| block.material);
    spheres.chain(planes).chain(blocks).collect()
}
