//! Bars of one to five pixels in any direction, single, crossing, in front of patterns and behind
//! other objects.

use crate::kinds::add;
use crate::materials::numbered;
use crate::{Random, View, coloured, solids};
use eightfold_tracer::scene::{Block, Camera, Light, Material, Pattern, Plane, Scene, Sphere};
use glam::{Mat3, Quat, Vec2, Vec3, vec2, vec3};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BarView {
    Directly,
    AsShadows,
    AsImages,
}

impl BarView {
    pub const ALL: [Self; 3] = [Self::Directly, Self::AsShadows, Self::AsImages];

    /// Returns a view with bars, and the same one without them.
    pub fn view(self, random: &mut Random) -> [View; 2] {
        let eye = vec3(0.0, random.power(-0.3, 0.8), 6.0);
        let look_at = random.vector(vec3(-2.0, -1.5, -2.0), vec3(2.0, 0.5, 0.5));
        let camera = Camera::new(eye, look_at, random.between(0.3, 1.4));
        let mut others = View::new(Scene { camera, ..Scene::default() }, [320, 240]);
        let light = random.vector(vec3(-6.0, 3.0, -6.0), vec3(6.0, 9.0, 6.0));
        let floor = match self {
            Self::Directly => random.one_of([None, Some(numbered(0, 28))]),
            Self::AsShadows => Some(Material::matt(Vec3::splat(0.8), 0.9)),
            Self::AsImages => Some(Material::mirror(0.7)),
        };
        let floor = floor.map(|material| Plane::new(Vec3::ZERO, 50.0, 50.0, material));
        others.scene.planes.extend(floor);
        for _ in 0..random.one_of([0, 0, 4]) {
            let centre = random.vector(vec3(-3.0, 0.0, -3.0), vec3(3.0, 3.0, 4.0));
            let radius = random.power(-1.0, 0.0);
            others.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
        }
        let mut all = others.clone();
        for _ in 0..random.one_of([1, 3, 10, 25]) {
            self.add_bar(&mut all, random, light);
        }
        let checkers = Pattern::checkers(random.power(-1.0, 0.5), random.zero_or(0.3, 0.3));
        [all, others].map(|mut view| {
            view.scene = coloured(&view.scene, 28);
            if let Some(Plane { mut material, .. }) = floor {
                if self == Self::Directly {
                    material.pattern = checkers;
                }
                view.scene.planes[0].material = material;
            }
            view.scene.background = Vec3::splat(0.5);
            match self {
                Self::AsShadows => {
                    view.scene.ambient = Vec3::splat(0.2);
                    view.scene.lights.push(Light::new(light, Vec3::ONE));
                }
                Self::AsImages => view.scene.background = Vec3::ZERO,
                Self::Directly => {}
            }
            view
        })
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
            0 if self == Self::Directly => {
                let [x, z] = random.one_of([[radius, 0.5 * length], [0.5 * length, radius]]);
                add(&mut scene.planes, Plane::new(centre, x, z, Material::BLACK));
            }
            1 => {
                let count = (length / (1.5 * radius)).min(60.0) as usize;
                for i in 0..count {
                    let centre = from + along * (1.5 * radius * i as f32);
                    add(&mut scene.spheres, Sphere::new(centre, radius, Material::BLACK));
                }
            }
            kind => {
                let shape = solids::SHAPES[kind % 3];
                let wide = [1.0, random.power(0.0, 1.5)][random.below(2)];
                let half = vec3(radius, 0.5 * length, radius * wide);
                let turn = Quat::from_axis_angle(along, random.between(0.0, 3.1));
                let across = along.any_orthonormal_vector();
                let axes = Mat3::from_cols(across, along, across.cross(along));
                let axes = Mat3::from_quat(turn) * axes;
                let half = solids::fitting(shape, half);
                let bar = Block::new(shape, centre, half, Material::BLACK);
                add(&mut scene.blocks, Block { axes, ..bar });
            }
        }
    }
}
