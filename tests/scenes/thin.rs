//! Bars of one to five pixels in any direction, single, crossing, in front of patterns and behind other objects.

use crate::materials::numbered;
use crate::{Random, View, coloured, solids};
use eightfold_tracer::scene::{
    Block, Camera, Light, MAX_BLOCKS, MAX_PLANES, MAX_SPHERES, Material, Pattern, Plane, Scene,
    Sphere,
};
use glam::{Mat3, Quat, Vec2, Vec3, vec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BarView {
    Directly,
    AsShadows,
    AsImages,
}

impl BarView {
    pub const ALL: [Self; 3] = [Self::Directly, Self::AsShadows, Self::AsImages];

    pub fn view(self, random: &mut Random) -> [View; 2] {
        let eye = vec3(0.0, random.power(-0.3, 0.8), 6.0);
        let look_at = random.vector(vec3(-2.0, -1.5, -2.0), vec3(2.0, 0.5, 0.5));
        let scene = Scene {
            camera: Camera::new(eye, look_at, random.between(0.3, 1.4)),
            ambient: Vec3::ONE,
            ..Scene::default()
        };
        let mut bars = View::new(scene, [320, 240]);
        let light = random.vector(vec3(-6.0, 3.0, -6.0), vec3(6.0, 9.0, 6.0));
        for _ in 0..random.one_of([1, 3, 10, 25]) {
            self.add_bar(&mut bars, random, light);
        }
        let mut others =
            Scene { camera: bars.scene.camera, background: Vec3::splat(0.5), ..Scene::default() };
        let is_floored = self != Self::Directly || random.below(2) == 0;
        if is_floored {
            let floor = match self {
                Self::Directly => numbered(0, 28),
                Self::AsShadows => Material::matt(Vec3::splat(0.8), 0.9),
                Self::AsImages => Material::mirror(0.7),
            };
            others.planes.push(Plane::new(Vec3::ZERO, 50.0, 50.0, floor));
        }
        for _ in 0..random.one_of([0, 0, 4]) {
            let centre = random.vector(vec3(-3.0, 0.0, -3.0), vec3(3.0, 3.0, 4.0));
            let radius = random.power(-1.0, 0.0);
            others.spheres.push(Sphere::new(centre, radius, Material::BLACK));
        }
        let checkers = Pattern::checkers(random.power(-1.0, 0.5), 0.3);
        let is_patterned = self == Self::Directly && random.below(2) == 0;
        let mut all = others.clone();
        all.spheres.extend(bars.scene.spheres.iter().copied());
        all.planes.extend(bars.scene.planes.iter().copied());
        all.blocks.extend(bars.scene.blocks.iter().copied());
        [all, others].map(|scene| {
            let mut scene = self.finished(&scene, is_floored, light);
            if is_patterned && let Some(plane) = scene.planes.iter_mut().next() {
                plane.material.pattern = checkers;
            }
            View::new(scene, [320, 240])
        })
    }

    fn finished(self, scene: &Scene, is_floored: bool, light: Vec3) -> Scene {
        let mut coloured = coloured(scene, 28);
        if is_floored {
            coloured.planes[0].material = scene.planes[0].material;
        }
        coloured.background = scene.background;
        match self {
            Self::AsShadows => {
                coloured.ambient = Vec3::splat(0.2);
                coloured.lights.push(Light::new(light, Vec3::ONE));
            }
            Self::AsImages => coloured.background = Vec3::ZERO,
            Self::Directly => {}
        }
        coloured
    }

    fn add_bar(self, view: &mut View, random: &mut Random, light: Vec3) {
        let size = vec2(view.width as f32, view.height as f32);
        let from = size * vec2(random.between(0.0, 1.0), random.between(0.0, 1.0));
        let angle = random.between(0.0, 6.3);
        let slope = random.between(-0.1, 0.1);
        let directions = [Vec2::from_angle(angle), vec2(1.0, slope), vec2(slope, 1.0)];
        let to = from + random.one_of(directions) * random.power(0.5, 2.3);
        let width = 1.0 + 0.3 * random.below(14) as f32;
        let far = random.power(0.0, 1.0);
        let nearer = [1.0, random.power(-0.7, 0.7)][random.below(2)];
        let share = random.between(0.02, 0.7);
        let ends = [(from, far), (to, far * nearer)].map(|(at, far)| {
            let eye = view.scene.camera.eye;
            let (d, pixel) = view.ray(at.x, at.y);
            let t = -eye.y / d.y.min(-0.02);
            match self {
                Self::Directly => (eye + d * far, pixel * far),
                Self::AsShadows => ((eye + d * t).lerp(light, share), pixel * t * (1.0 - share)),
                Self::AsImages => {
                    let back = d * vec3(1.0, -1.0, 1.0) * (0.2 * far);
                    (eye + d * t + back, pixel * (t + 0.2 * far))
                }
            }
        });
        let [(from, near), (to, far)] = ends;
        let radius = 0.25 * width * (near + far);
        let (centre, length) = (0.5 * (from + to), (to - from).length());
        let along = (to - from) / length;
        let scene = &mut view.scene;
        match random.below(8) {
            0 if self == Self::Directly && scene.planes.len() + 1 < MAX_PLANES => {
                let [x, z] = random.one_of([[radius, 0.5 * length], [0.5 * length, radius]]);
                scene.planes.push(Plane::new(centre, x, z, Material::BLACK));
            }
            1 => {
                let count = (length / (1.5 * radius)).min(60.0) as usize;
                for i in 0..count {
                    if scene.spheres.len() + 4 < MAX_SPHERES {
                        let centre = from + along * (1.5 * radius * i as f32);
                        scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
                    }
                }
            }
            kind if scene.blocks.len() < MAX_BLOCKS => {
                let shape = solids::SHAPES[kind % 3];
                let wide = [1.0, random.power(0.0, 1.5)][random.below(2)];
                let half = vec3(radius, 0.5 * length, radius * wide);
                let turn = Quat::from_axis_angle(along, random.between(0.0, 3.1));
                let across = along.any_orthonormal_vector();
                let axes = Mat3::from_cols(across, along, across.cross(along));
                scene.blocks.push(Block {
                    axes: Mat3::from_quat(turn) * axes,
                    ..Block::new(shape, centre, solids::fitting(shape, half), Material::BLACK)
                });
            }
            _ => {}
        }
    }
}
