//! Objects of a scene file that are picked: where they are, how large, and what their numbers are in the file.

use super::camera::View;
use eightfold_oracle::Object;
use eightfold_scene_file::SceneFile;
use eightfold_tracer::glam::{DVec2, DVec3, Vec3A};
use eightfold_tracer::scene::Scene;

/// An object, by its list in the file and its index there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Picked {
    pub kind: Kind,
    pub index: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Sphere,
    Plane,
    Block,
    Light,
}

impl Picked {
    /// The object that a picture shows; `None` for the background.
    pub fn of(object: Object) -> Option<Self> {
        let (kind, index) = match object {
            Object::Sphere(index) => (Kind::Sphere, index),
            Object::Plane(index) => (Kind::Plane, index),
            Object::Block(index) => (Kind::Block, index),
            Object::Light(index) => (Kind::Light, index),
            Object::Background => return None,
        };
        Some(Self { kind, index })
    }

    pub fn is_plane(self) -> bool {
        self.kind == Kind::Plane
    }

    /// The name of its list in the file.
    pub fn list(self) -> &'static str {
        match self.kind {
            Kind::Sphere => "spheres",
            Kind::Plane => "planes",
            Kind::Block => "blocks",
            Kind::Light => "lights",
        }
    }

    /// Its path in the file.
    pub fn path(self) -> String {
        format!("{}[{}]", self.list(), self.index)
    }

    /// The path of its place in the file.
    pub fn centre_path(self) -> String {
        let field = match self.kind {
            Kind::Light => "position",
            _ => "centre",
        };
        format!("{}.{field}", self.path())
    }

    /// The paths of the lengths that are its size in the file.
    pub fn size_paths(self) -> Vec<String> {
        let fields: &[&str] = match self.kind {
            Kind::Sphere => &["radius"],
            Kind::Light => &["drawn_radius"],
            Kind::Plane => &["half_x", "half_z"],
            Kind::Block => &["half"],
        };
        let path = self.path();
        fields
            .iter()
            .map(|field| format!("{path}.{field}"))
            .collect()
    }

    /// The name of its material in the file; lights have none.
    pub fn material(self, file: &SceneFile) -> Option<&str> {
        file.value(&format!("{}.material", self.path()))?.as_str()
    }

    /// Its centre and half its extent along each axis in a scene; `None` if the scene does not have it.
    pub fn bounds(self, scene: &Scene) -> Option<(DVec3, DVec3)> {
        let (centre, half) = match self.kind {
            Kind::Sphere => {
                let sphere = scene.spheres.get(self.index)?;
                (sphere.centre, Vec3A::splat(sphere.radius))
            }
            Kind::Plane => {
                let plane = scene.planes.get(self.index)?;
                (plane.centre, Vec3A::new(plane.half_x, 0.0, plane.half_z))
            }
            Kind::Block => {
                let block = scene.blocks.get(self.index)?;
                let axes = [block.axes.x_axis, block.axes.y_axis, block.axes.z_axis];
                let half = block.half.to_array();
                let sum = |sum: Vec3A, (axis, half): (Vec3A, f32)| sum + axis.abs() * half;
                let half = axes.into_iter().zip(half).fold(Vec3A::ZERO, sum);
                (block.centre, half)
            }
            Kind::Light => {
                let light = scene.lights.get(self.index)?;
                (light.position, Vec3A::splat(light.drawn_radius))
            }
        };
        Some((centre.as_dvec3(), half.as_dvec3()))
    }

    /// The rectangle of the picture around it, as its upper left and its lower right corner; `None` if a part of it is behind the
    /// camera.
    pub fn frame(self, scene: &Scene, view: &View) -> Option<[DVec2; 2]> {
        let (centre, half) = self.bounds(scene)?;
        // A ball is as wide from everywhere.
        let axes = match self.kind {
            Kind::Sphere | Kind::Light => [view.right, view.up, DVec3::ZERO].map(|v| v * half.x),
            Kind::Plane | Kind::Block => [DVec3::X * half, DVec3::Y * half, DVec3::Z * half],
        };
        let mut frame = [DVec2::INFINITY, DVec2::NEG_INFINITY];
        for corner in 0..8 {
            let side = |bit: usize| axes[bit] * if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
            let at = view.place(centre + side(0) + side(1) + side(2))?;
            frame = [frame[0].min(at), frame[1].max(at)];
        }
        Some(frame)
    }

    /// Its name and its numbers, in words; `None` if the scene does not have it.
    pub fn words(self, file: &SceneFile, scene: &Scene) -> Option<String> {
        let (centre, half) = self.bounds(scene)?;
        let point = |point: DVec3| {
            let [x, y, z] = point.to_array().map(|number| number as f32);
            format!("({x}, {y}, {z})")
        };
        let size = match self.kind {
            Kind::Sphere | Kind::Light => format!("radius {}", half.x as f32),
            Kind::Plane => format!("half {} by {}", half.x as f32, half.z as f32),
            Kind::Block => {
                let half = scene.blocks.get(self.index)?.half;
                format!("half {}", point(half.as_dvec3()))
            }
        };
        let material = self.material(file);
        let material = material
            .map(|name| format!(" {name:?}"))
            .unwrap_or_default();
        let moves = if file.is_moved(&self.path()) {
            ", moves"
        } else {
            ""
        };
        let (path, centre) = (self.path(), point(centre));
        Some(format!("{path}{material}: centre {centre}, {size}{moves}"))
    }
}
