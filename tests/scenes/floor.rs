//! A floor, steep or grazing, near or far from the origin.

use crate::materials::numbered;
use crate::{Random, View, solids};
use eightfold_tracer::scene::{
    Block, Camera, Light, List, MIN_LENGTH, Material, Plane, Scene, Shape, Sphere,
};
use glam::{Mat3, Vec3, vec3};

const IMAGED: Material = Material::matt(vec3(1.0, 0.8, 0.6), 0.0);

impl View {
    pub fn glaring(mut self) -> Self {
        let lights = self.scene.lights.iter_mut();
        lights.for_each(|light| light.colour *= 1e6);
        self
    }

    pub fn with_box(mut self) -> Self {
        let centre = self.scene.planes[0].centre - Vec3::Y * (100.0 * self.side());
        self.scene.blocks.push(Block::new(Shape::Box, centre, Vec3::ONE, Material::BLACK));
        self
    }

    fn side(&self) -> f32 {
        (self.scene.camera.eye.y - self.scene.planes[0].centre.y).signum()
    }

    /// Returns a visible point of a floor at a height, and the length of `pixels` there.
    fn place(&self, random: &mut Random, height: f32, pixels: f32) -> Option<(Vec3, f32)> {
        let eye = self.scene.camera.eye;
        let [x, y] = [self.width, self.height].map(|side| random.between(0.0, side as f32));
        let (d, pixel) = self.ray(x, y);
        let t = (height - eye.y) / d.y;
        (t > 0.0 && t * d.length() < 1e6).then(|| (eye + d * t, pixels * pixel * t))
    }
}

fn empty(random: &mut Random) -> View {
    let floor = random.one_of([0.0, 0.0, 1.0, 37.3, -512.7]);
    let distance = random.power(-1.0, 3.0);
    let side = random.one_of([1.0, 1.0, -1.0]);
    let steep = random.one_of([1.0, 0.3, 0.03]);
    let across = random.vector(vec3(-1.0, 0.0, -1.0), vec3(1.0, 0.0, 1.0));
    let away = random.one_of([0.0, 0.0, 30.0, 1000.0]) * distance;
    let eye = vec3(away, floor + side * distance, 0.0);
    let ahead = eye + across + vec3(0.01, -side * steep, 0.0);
    let plane = Plane::new(vec3(0.0, floor, 0.0), 1e5, 1e5, numbered(0, 28));
    let sizes = [[200, 160], [320, 240], [517, 61], [640, 40], [97, 203]];
    let size = random.one_of(sizes);
    let scene = Scene {
        camera: Camera::new(eye, ahead, random.one_of([0.2, 0.6, 1.2, 2.6])),
        background: Vec3::splat(10.0 / 255.0),
        ambient: Vec3::ONE,
        planes: List::of(&[plane]),
        ..Scene::default()
    };
    View::new(scene, size)
}

/// Returns a floor with the shadow of a sphere: a few pixels wide, or thin and long, or mostly
/// hidden, often after others.
pub fn shadow(random: &mut Random) -> View {
    let mut view = empty(random);
    let side = view.side();
    let pixels = random.power(-0.3, 1.5);
    let height = view.scene.planes[0].centre.y;
    let Some((at, size)) = view.place(random, height, pixels) else { return view };
    let direction = random.vector(vec3(-1.0, 0.0, -1.0), Vec3::ONE);
    let steep = side * random.one_of([1.0, 0.1, 0.01]);
    let direction = direction.normalize_or(Vec3::Y) * vec3(1.0, steep, 1.0);
    let light_at = (view.scene.camera.eye - at).length() * random.power(-1.5, 1.5);
    let share = random.between(0.02, 0.98);
    let (centre, radius) = if random.below(3) == 0 {
        let radius = size * random.power(0.0, 3.0);
        let sunk = random.one_of([0.0, 1e-5, 1e-3, 0.1, 1.0]) * random.between(0.0, 1.0);
        let above = side * radius * (1.0 - 2.0 * sunk);
        (at + Vec3::Y * above, radius)
    } else {
        (at + direction * (light_at * share), size * (1.0 - share))
    };
    let scene = &mut view.scene;
    (scene.ambient, scene.background) = (Vec3::splat(0.1), vec3(0.1, 0.15, 0.3));
    scene.planes[0].material = Material::matt(Vec3::splat(0.7), 1.0);
    scene.lights.push(Light::new(at + direction * light_at, Vec3::splat(0.73)));
    let sphere = Sphere::new(centre, radius.max(MIN_LENGTH), Material::matt(Vec3::X, 1.0));
    for _ in 0..random.one_of([0, 0, 40]) {
        let pixels = random.power(-0.3, 1.0);
        let Some((at, size)) = view.place(random, height, pixels) else { continue };
        let centre = at + Vec3::Y * (side * size * random.between(1.0, 9.0));
        view.scene.spheres.push(Sphere { centre, radius: size.max(MIN_LENGTH), ..sphere });
    }
    view.scene.spheres.push(sphere);
    view
}

/// Returns a black mirror with the image of a sphere or a box above it, or half in it.
pub fn image(random: &mut Random) -> View {
    let mut view = empty(random);
    let side = view.side();
    (view.scene.ambient, view.scene.background) = (Vec3::ONE, Vec3::ZERO);
    view.scene.planes[0].material = Material::mirror(0.5);
    let pixels = random.power(0.0, 1.5);
    let height = view.scene.planes[0].centre.y;
    let Some((at, size)) = view.place(random, height, pixels) else { return view };
    let d = at - view.scene.camera.eye;
    let back = d * vec3(1.0, -1.0, 1.0) * random.power(-2.0, 1.0);
    let size = size * (1.0 + back.length() / d.length());
    let sunk = random.one_of([1.0, 0.999, 0.5, -0.9, -0.999]);
    let above = [back, back, Vec3::Y * (side * size * sunk)][random.below(3)];
    let sphere = Sphere::new(at + above, size.max(MIN_LENGTH), IMAGED);
    if random.below(2) == 0 {
        view.scene.spheres.push(sphere);
    } else {
        let half = size * vec3(random.power(-2.0, 0.0), 1.0, 1.0);
        let half = half.max(Vec3::splat(MIN_LENGTH));
        view.scene.blocks.push(Block {
            axes: [Mat3::IDENTITY, random.turn()][random.below(2)],
            ..Block::new(Shape::Box, sphere.centre, half, IMAGED)
        });
    }
    view
}

/// Returns objects that rise from a floor or a slab by a tenth of their size down to a rounding
/// error.
pub fn contact(random: &mut Random) -> View {
    let mut view = empty(random);
    let side = view.side();
    let mut height = view.scene.planes[0].centre.y;
    if random.below(3) == 0 {
        let half = vec3(1e5, random.one_of([0.01, 1.0, 100.0]), 1e5);
        let plane = view.scene.planes[0];
        view.scene.blocks.push(Block::new(Shape::Box, plane.centre, half, plane.material));
        view.scene.planes = List::default();
        height += side * half.y;
        view.scene.camera.eye.y += side * half.y;
        view.scene.camera.look_at.y += side * half.y;
    }
    for number in 1..2 + random.below(40) {
        let pixels = random.power(-0.2, 1.5);
        let Some((at, size)) = view.place(random, height, pixels) else { continue };
        let share = random.one_of([0.1, 1e-2, 1e-3, 1e-4, 1e-5, 0.0]);
        let rise = size * share * random.between(0.2, 1.0);
        let material = numbered(number, 28);
        let kind = random.below(4);
        if kind < 2 {
            let flat = (size * size + rise * rise) / (2.0 * rise.max(1e-6 * size));
            let radius = [flat, size][kind];
            let centre = at + Vec3::Y * (side * (rise - radius));
            view.scene.spheres.push(Sphere::new(centre, radius, material));
            continue;
        }
        let mut block = solids::block(random, at, Vec3::splat(size), material);
        block.axes = [Mat3::IDENTITY, block.axes][random.below(2)];
        if kind == 2 && block.shape != Shape::Capsule {
            block.half.y = 0.5 * rise;
            block.axes = Mat3::from_rotation_y(random.between(0.0, 3.0));
        }
        let up = block.axes.transpose() * Vec3::Y;
        block.centre += Vec3::Y * (side * (rise - up.abs().dot(block.half)));
        block.half = block.half.max(Vec3::splat(MIN_LENGTH));
        view.scene.blocks.push(block);
    }
    view
}
