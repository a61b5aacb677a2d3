use crate::{Random, lights, materials, scaled, solids};
use eightfold_tracer::scene::{
    Ambience, Block, Camera, Caption, Film, Light, List, MAX_BLOCKS, MAX_LIGHTS, MAX_SOFTBOXES,
    MAX_SPHERES, Material, Moment, Plane, Scene, Shape, Softbox, Sphere, Waves,
};
use glam::{Vec3, vec3};

#[derive(Clone, Copy)]
pub struct Kinds {
    pub spheres: usize,
    pub planes: usize,
    pub blocks: usize,
    pub lights: usize,
    /// The smallest radius, as a power of 10.
    pub smallest: f32,
    pub material: fn(&mut Random) -> Material,
    pub light: fn(&mut Random) -> Light,
    pub camera: fn(&mut Random) -> Camera,
    pub air: bool,
    /// Whether objects can touch, overlap, coincide, or form a row.
    pub groups: bool,
    /// The largest scale, as a power of 10; the smallest is its reciprocal.
    pub decades: f32,
}

impl Kinds {
    /// Spheres over planes, lit by points.
    pub const SPHERES: Self = Self {
        spheres: 12,
        planes: 2,
        blocks: 0,
        lights: 4,
        smallest: -0.7,
        material: materials::plain,
        light: lights::point,
        camera: outside,
        air: false,
        groups: false,
        decades: 0.0,
    };

    /// Everything that the oracle draws.
    pub const RICH: Self = Self {
        spheres: 6,
        blocks: 8,
        lights: 3,
        material: materials::painted,
        light: lights::any,
        air: true,
        ..Self::SPHERES
    };

    /// Up to hundreds of objects of all kinds, scaled by 1e-5 to 1e5.
    pub const EXTREME: Self = Self {
        spheres: MAX_SPHERES,
        planes: 4,
        blocks: MAX_BLOCKS,
        lights: MAX_LIGHTS,
        smallest: -3.0,
        material: materials::extreme,
        camera: anywhere,
        groups: true,
        decades: 5.0,
        ..Self::RICH
    };

    pub fn scene(&self, random: &mut Random) -> Scene {
        let mut scene = Scene {
            camera: (self.camera)(random),
            background: random.colour(),
            ambient: 0.2 * random.colour(),
            ..Scene::default()
        };
        for _ in 0..count(random, self.spheres) {
            let radius = random.power(self.smallest, 0.2);
            let material = (self.material)(random);
            scene.spheres.push(Sphere::new(place(random), radius, material));
        }
        for _ in 0..count(random, self.planes) {
            let centre = vec3(0.3, random.between(-2.0, 0.0), -0.2);
            let [x, z] = [0; 2].map(|_| random.between(1.0, 20.0));
            let material = (self.material)(random);
            scene.planes.push(Plane::new(centre, x, z, material));
        }
        for _ in 0..count(random, self.blocks) {
            let half = random.vector(Vec3::splat(0.2), Vec3::splat(1.5));
            let (centre, material) = (place(random), (self.material)(random));
            scene.blocks.push(solids::block(random, centre, half, material));
        }
        for _ in 0..count(random, self.lights) {
            scene.lights.push((self.light)(random));
        }
        if self.air {
            add_air(&mut scene, random);
        }
        if self.groups {
            add_groups(&mut scene, random);
        }
        scaled(&scene, random.power(-self.decades, self.decades))
    }
}

/// Returns a number up to `max`, often a small one.
fn count(random: &mut Random, max: usize) -> usize {
    let max = random.one_of([4, 12, 40, max]).min(max);
    random.below(max + 1)
}

fn place(random: &mut Random) -> Vec3 {
    random.vector(vec3(-4.0, 0.2, -4.0), vec3(4.0, 3.0, 4.0))
}

pub fn outside(random: &mut Random) -> Camera {
    let (angle, distance) = (random.between(0.0, 6.3), random.between(7.0, 14.0));
    let height = random.between(0.5, 6.0);
    let eye = vec3(distance * angle.sin(), height, distance * angle.cos());
    let look_at = random.vector(vec3(-1.0, 0.2, -1.0), Vec3::ONE);
    Camera::new(eye, look_at, random.between(0.3, 1.6))
}

pub fn anywhere(random: &mut Random) -> Camera {
    let eye = random.vector(vec3(-9.0, -1.0, -9.0), vec3(9.0, 7.0, 9.0));
    let look_at = random.vector(Vec3::splat(-1.0), Vec3::ONE);
    Camera::new(eye, look_at, random.between(0.1, 2.5))
}

fn add_air(scene: &mut Scene, random: &mut Random) {
    scene.sky = random.colour() - scene.background;
    scene.haze = random.zero_or(0.01, 0.1);
    let mut more = Random::new(random.clone().bits());
    scene.haze_fall = more.zero_or(0.1, 10.0);
    scene.scatter = more.zero_or(0.1, 1.0);
    scene.exposure = random.between(0.1, 1.2);
    if random.below(2) == 0 {
        scene.film = Film {
            filmic: random.below(3) == 0,
            vignette: random.between(0.0, 0.5),
            dither: random.between(0.0, 1.0),
        };
    }
    if random.below(2) == 0 {
        scene.ambience = Ambience {
            occlusion: random.between(0.1, 1.0),
            reach: random.between(0.1, 3.0),
            ground: random.colour(),
            bounce: random.zero_or(0.1, 1.0),
        };
    }
    if random.below(2) == 0
        && let Some(sphere) = scene.spheres.first_mut()
    {
        sphere.material.film_thickness = random.between(100.0, 1000.0);
    }
    for _ in 0..random.below(MAX_SOFTBOXES + 1) {
        scene.softboxes.push(Softbox {
            aim: random.vector(Vec3::NEG_ONE, Vec3::ONE),
            half_width: random.between(0.3, 2.0),
            half_height: random.between(0.3, 2.0),
            softness: random.between(0.2, 1.0),
            colour: 2.0 * random.colour(),
        });
    }
    if random.below(2) == 0 {
        scene.water = Waves {
            slope: random.between(0.001, 0.1),
            length: random.between(0.5, 10.0),
            phase: random.between(-9.0, 9.0),
        };
    }
}

fn add_groups(scene: &mut Scene, random: &mut Random) {
    let Some(&last) = scene.spheres.last() else { return };
    let beside = |direction: Vec3, radius: f32| Sphere {
        centre: last.centre + direction.normalize_or(Vec3::X) * (last.radius + radius),
        radius: radius.abs(),
        ..last
    };
    let direction = random.vector(Vec3::NEG_ONE, Vec3::ONE);
    match random.below(8) {
        0 => add(&mut scene.spheres, last),
        1 => add(&mut scene.spheres, beside(direction, 0.5 * last.radius)),
        2 => add(&mut scene.spheres, beside(direction, -0.5 * last.radius)),
        3 => {
            let half = random.power(-3.0, -1.0) * vec3(1.0, 0.0, 1.0) + Vec3::Y;
            for i in 0..12 {
                let centre = vec3(0.4 * i as f32 - 2.4, 1.0, 0.0);
                let rod = Block::new(Shape::Cylinder, centre, half, last.material);
                add(&mut scene.blocks, rod);
            }
        }
        _ => {}
    }
}

pub(crate) fn add<T: Copy + Default, const N: usize>(list: &mut List<T, N>, item: T) {
    if list.len() < N {
        list.push(item);
    }
}

/// Returns a scene with a caption in one of four cases.
pub fn presented(scene: Scene, random: &mut Random) -> Moment {
    let mut moment = Moment::from(scene);
    if random.below(4) == 0 {
        moment.presentation.captions.push(Caption {
            letters: List::of(b"EIGHTFOLD"),
            middle: random.between(0.0, 1.0),
            size: random.between(0.01, 0.3),
            brightness: random.between(0.0, 1.0),
        });
    }
    moment
}
