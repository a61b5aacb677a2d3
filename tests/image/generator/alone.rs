//! Scenes of a plane that shows the shadow or the image of a single thing: thin ones, in grazing views, cut by the plane, or far
//! from the origin. Some are known to have been missed, others random.

use super::near::{Near, empty, one_of, place, power, tilt};
use super::seeded::Random;
use eightfold_tracer::scene::{
    Block, Camera, Light, List, MIN_LENGTH, Material, Plane, Scene, Shape, Sphere,
};
use glam::{Mat3, Quat, Vec3, vec3};

/// The material of things that have an image.
const IMAGED: Material = Material {
    colour: vec3(1.0, 0.8, 0.6),
    ..Material::BLACK
};

impl Near {
    /// Adds a sphere and a lamp, and has the floor show its shadow.
    fn light(&mut self, centre: Vec3, radius: f32, lamp: Vec3) {
        let matt = Material::matt(Vec3::splat(0.7), 1.0);
        let scene = &mut self.scene;
        scene.ambient = Vec3::splat(0.1);
        scene.background = vec3(0.1, 0.15, 0.3);
        scene.planes[0].material = matt;
        scene.spheres.push(Sphere::new(
            centre,
            radius.max(MIN_LENGTH),
            Material {
                colour: Vec3::X,
                ..matt
            },
        ));
        scene.lights.push(Light::new(lamp, Vec3::splat(0.73)));
    }

    /// Makes the floor a mirror that is black but for images.
    fn mirror(&mut self) {
        self.scene.ambient = Vec3::ONE;
        self.scene.background = Vec3::ZERO;
        self.scene.planes[0].material = Material::mirror(0.5);
    }

    /// The floor, without what throws shadows on it.
    pub fn without_spheres(&self) -> Scene {
        Scene {
            spheres: List::of(&[]),
            ..self.scene
        }
    }

    /// The same by lamps so bright that a shadow is seen wherever it falls.
    pub fn glaring(mut self) -> Self {
        for light in self.scene.lights.iter_mut() {
            light.colour *= 1e6;
        }
        self
    }

    /// The same with a box that the floor hides, and whose shadow, too.
    pub fn with_box(mut self) -> Self {
        let (eye, floor) = (self.scene.camera.eye, self.scene.planes[0].centre);
        let below = vec3(0.0, 100.0 * (floor.y - eye.y).signum(), 0.0);
        self.scene.blocks.push(Block {
            centre: floor + below,
            half: Vec3::ONE,
            material: Material::BLACK,
            ..Block::default()
        });
        self
    }
}

/// A floor that a lamp lights, and a sphere whose shadow is a few pixels wide, or thin and long, or mostly hidden.
pub fn shadow(random: &mut Random) -> Near {
    let (mut near, floor) = empty(random);
    let side = (near.scene.camera.eye.y - floor).signum();
    let pixels = power(random, -0.3, 1.5);
    let Some((at, size)) = place(random, &near, floor, pixels) else {
        return near;
    };
    let eye = near.scene.camera.eye;
    let way = random
        .vector(vec3(-1.0, 0.0, -1.0), vec3(1.0, 1.0, 1.0))
        .normalize_or(Vec3::Y);
    let way = way * vec3(1.0, side * one_of(random, [1.0, 0.1, 0.01]), 1.0);
    let lamp_at = (eye - at).length() * power(random, -1.5, 1.5);
    let share = random.between(0.02, 0.98);
    let (centre, radius) = if random.below(3) == 0 {
        // Sunk, so that its tip alone casts a shadow, or touching the floor.
        let radius = size * power(random, 0.0, 3.0);
        let sunk = one_of(random, [0.0, 1e-5, 1e-3, 0.1, 1.0]);
        (
            at + Vec3::Y * (side * radius * (1.0 - 2.0 * sunk * random.between(0.0, 1.0))),
            radius,
        )
    } else {
        (at + way * (lamp_at * share), size * (1.0 - share))
    };
    near.light(centre, radius, at + way * lamp_at);
    near
}

/// A mirror that is black but for the image of a sphere or a box above it, or half in it.
pub fn image(random: &mut Random) -> Near {
    let (mut near, floor) = empty(random);
    let side = (near.scene.camera.eye.y - floor).signum();
    near.mirror();
    let pixels = power(random, 0.0, 1.5);
    let Some((at, size)) = place(random, &near, floor, pixels) else {
        return near;
    };
    let eye = near.scene.camera.eye;
    let d = at - eye;
    let back = d * vec3(1.0, -1.0, 1.0) * power(random, -2.0, 1.0);
    let size = size * (1.0 + back.length() / d.length());
    let centre = if random.below(3) == 0 {
        at + Vec3::Y * (side * size * one_of(random, [1.0, 0.999, 0.5, -0.9, -0.999]))
    } else {
        at + back
    };
    let material = IMAGED;
    if random.below(2) == 0 {
        near.scene
            .spheres
            .push(Sphere::new(centre, size.max(MIN_LENGTH), material));
    } else {
        let thin = power(random, -2.0, 0.0);
        let turn = [Quat::IDENTITY, tilt(random)][random.below(2)];
        near.scene.blocks.push(Block {
            centre,
            half: (size * vec3(thin, 1.0, 1.0)).max(Vec3::splat(MIN_LENGTH)),
            axes: Mat3::from_quat(turn),
            shape: Shape::Box,
            material,
        });
    }
    near
}

/// A camera that looks along -z, a step to the side and a step up.
fn ahead(eye: Vec3, right: f32, up: f32, field_of_view: f32) -> Camera {
    Camera::new(eye, eye + vec3(right, up, -1.0), field_of_view)
}

/// A sphere whose shadow on a plane at some height is thin or a few pixels wide.
fn cast(
    camera: Camera,
    (plane, half_x, half_z): (f32, f32, f32),
    (centre, radius): (Vec3, f32),
    lamp: Vec3,
    [width, height]: [usize; 2],
) -> Near {
    let mut near = Near {
        scene: Scene {
            camera,
            planes: List::of(&[Plane {
                centre: vec3(0.0, plane, -20.0),
                half_x,
                half_z,
                ..Plane::default()
            }]),
            ..Scene::default()
        },
        width,
        height,
    };
    near.light(centre, radius, lamp);
    near
}

/// Shadows of spheres that are little larger than rounding moves their points, and some of which only the picture's last rows show.
pub fn thin_shadows() -> [Near; 4] {
    [
        cast(
            ahead(-35.802_895 * Vec3::Y, 0.512_459_9, 0.084_797, 0.618_702_65),
            (-35.167_92, 183.116_8, 260.027_65),
            (vec3(6.220_267_3, -36.842_022, -5.657_632), 0.000_581_008_1),
            vec3(6.482_078, -36.925_404, -5.875_787),
            [200, 160],
        ),
        cast(
            ahead(-82.842_57 * Vec3::Y, 0.602_064_85, -1.035_055, 0.183_533_79),
            (-82.908_67, 103.407_52, 246.170_4),
            (
                vec3(-0.688_367_6, -82.750_56, -1.238_729_6),
                0.000_212_292_89,
            ),
            vec3(-1.229_534, -82.591_44, -2.289_907),
            [1031, 40],
        ),
        cast(
            ahead(82.175_31 * Vec3::Y, -0.208_782_2, -0.105_29, 0.203_248_1),
            (69.482_315, 83.615_86, 396.585_4),
            (vec3(6.848_16, 77.529_28, -23.261_833), 0.002_642_829),
            vec3(5.269_199_4, 77.700_59, -21.935_068),
            [640, 40],
        ),
        cast(
            ahead(-43.877_266 * Vec3::Y, 0.476_505_28, -0.081_047, 2.212_955_5),
            (-53.467_705, 130.611_7, 266.219_9),
            (vec3(108.019_88, -50.470_207, 46.806_44), 0.515_072),
            vec3(-1.477_199, 4.221_737, -3.184_710_3),
            [640, 40],
        ),
    ]
}

/// A shadow that crosses a low lamp's patch of light beside a corner that is as good as dark, shadow or not.
pub fn shadow_beside_a_dark_corner() -> Near {
    let eye = 69.381_966 * Vec3::Y;
    cast(
        Camera::new(eye, vec3(0.627_962_1, 69.081_96, 0.738_625_3), 0.6),
        (0.0, 1e5, 1e5),
        (vec3(129.031_11, 0.025_655_242, 175.488_1), 0.018_169),
        vec3(129.063_11, 0.025_757_164, 175.602_97),
        [97, 203],
    )
}

/// The image of a thin box in the corner of a picture that is nearly all around.
pub fn wide_image() -> Near {
    let mut near = cast(
        ahead(-35.823_78 * Vec3::Y, -0.695_287_1, -0.103_523, 2.682_118_4),
        (-38.373_173, 563.665_7, 61.342_262),
        (Vec3::ZERO, 1.0),
        Vec3::ZERO,
        [255, 255],
    );
    near.mirror();
    near.scene.spheres = List::of(&[]);
    near.scene.lights = List::of(&[]);
    near.scene.blocks.push(Block {
        centre: vec3(11.895_88, -26.310_272, -11.920_961),
        half: vec3(0.020_078_469, 0.179_375_59, 0.179_375_59),
        material: IMAGED,
        ..Block::default()
    });
    near
}
