use crate::{Random, View, lights, materials, scaled, solids};
use eightfold_tracer::presentation::{Caption, Moment};
use eightfold_tracer::scene::{
    Ambience, Block, Camera, Film, Light, List, MAX_BLOCKS, MAX_LIGHTS, MAX_SOFTBOXES, MAX_SPHERES,
    Material, Plane, Scene, Shape, Softbox, Sphere, Waves,
};
use glam::{Mat3, Vec3, vec3};

/// A function from a [`Random`] to a part of a scene.
pub type Draw<T> = fn(&mut Random) -> T;

#[derive(Clone, Copy)]
pub enum Place {
    Within([Vec3; 2]),
    /// Where a pixel shows distances of these powers of 10: radii are in pixels.
    AtPixel([f32; 2]),
}

/// Scattered objects. Two numbers or vectors are the ends of a range.
#[derive(Clone, Copy)]
pub struct Kinds {
    pub spheres: usize,
    pub planes: usize,
    pub blocks: usize,
    pub lights: usize,
    /// Whether these are the numbers of objects and lights, or their maximums.
    pub exact: bool,
    pub size: [usize; 2],
    /// The eye's place before it turns around the y axis by up to `turn`.
    pub eye: [Vec3; 2],
    pub turn: f32,
    pub look_at: [Vec3; 2],
    pub angle: [f32; 2],
    pub place: Place,
    /// Of spheres, and of blocks, as powers of 10.
    pub radius: [[f32; 2]; 2],
    /// The half extents of blocks, in radii.
    pub half: [Vec3; 2],
    pub plane: [Vec3; 2],
    /// The half extents of planes, as powers of 10.
    pub side: [f32; 2],
    pub material: Draw<Material>,
    pub light: Draw<Light>,
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
        exact: false,
        size: [320, 240],
        eye: [vec3(0.0, 0.5, 7.0), vec3(0.0, 6.0, 14.0)],
        turn: 6.3,
        look_at: [vec3(-1.0, 0.2, -1.0), Vec3::ONE],
        angle: [0.3, 1.6],
        place: Place::Within([vec3(-4.0, 0.2, -4.0), vec3(4.0, 3.0, 4.0)]),
        radius: [[-0.7, 0.2], [0.0; 2]],
        half: [Vec3::splat(0.2), Vec3::splat(1.5)],
        plane: [vec3(0.3, -2.0, -0.2), vec3(0.3, 0.0, -0.2)],
        side: [0.0, 1.3],
        material: materials::plain,
        light: lights::point,
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
        eye: [vec3(-9.0, -1.0, -9.0), vec3(9.0, 7.0, 9.0)],
        look_at: [Vec3::NEG_ONE, Vec3::ONE],
        angle: [0.1, 2.5],
        radius: [[-3.0, 0.2], [0.0; 2]],
        material: materials::extreme,
        groups: true,
        decades: 5.0,
        ..Self::RICH
    };

    pub fn scene(&self, random: &mut Random) -> Scene {
        self.view(random).scene
    }

    pub fn view(&self, random: &mut Random) -> View {
        let turn = Mat3::from_rotation_y(random.between(0.0, self.turn));
        let [eye, look_at] = [self.eye, self.look_at].map(|[low, high]| random.vector(low, high));
        let scene = Scene {
            camera: Camera::new(turn * eye, look_at, random.between(self.angle[0], self.angle[1])),
            background: random.colour(),
            ambient: 0.2 * random.colour(),
            ..Scene::default()
        };
        let mut view = View::new(scene, self.size);
        for _ in 0..self.count(random, self.spheres) {
            let (centre, radius) = self.place(random, &view, self.radius[0]);
            let material = (self.material)(random);
            view.scene.spheres.push(Sphere::new(centre, radius, material));
        }
        for _ in 0..self.count(random, self.planes) {
            let centre = random.vector(self.plane[0], self.plane[1]);
            let [x, z] = [0; 2].map(|_| random.power(self.side[0], self.side[1]));
            let material = (self.material)(random);
            view.scene.planes.push(Plane::new(centre, x, z, material));
        }
        for _ in 0..self.count(random, self.blocks) {
            let (centre, radius) = self.place(random, &view, self.radius[1]);
            let half = radius * random.vector(self.half[0], self.half[1]);
            let material = (self.material)(random);
            let block = solids::block(random, centre, half, material);
            let axes = random.one_of([block.axes, block.axes, Mat3::IDENTITY]);
            view.scene.blocks.push(Block { axes, ..block });
        }
        let scene = &mut view.scene;
        for _ in 0..self.count(random, self.lights) {
            scene.lights.push((self.light)(random));
        }
        if self.air {
            add_air(scene, random);
        }
        if self.groups {
            add_groups(scene, random);
        }
        *scene = scaled(scene, random.power(-self.decades, self.decades));
        view
    }

    pub fn place(&self, random: &mut Random, view: &View, [low, high]: [f32; 2]) -> (Vec3, f32) {
        let radius = random.power(low, high);
        match self.place {
            Place::Within([low, high]) => (random.vector(low, high), radius),
            Place::AtPixel([near, far]) => {
                let [x, y] = [view.width, view.height].map(|side| random.below(side) as f32);
                view.at([x, y], random.power(near, far), radius)
            }
        }
    }

    /// Returns a number up to `max`, often a small one.
    fn count(&self, random: &mut Random, max: usize) -> usize {
        if self.exact {
            return max;
        }
        let max = random.one_of([4, 12, 40, max]).min(max);
        random.below(max + 1)
    }
}

fn add_air(scene: &mut Scene, random: &mut Random) {
    scene.sky = random.colour() - scene.background;
    scene.haze = random.zero_or(0.01, 0.1);
    scene.haze_fall = random.zero_or(0.1, 10.0);
    scene.scatter = random.zero_or(0.1, 1.0);
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
