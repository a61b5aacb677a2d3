use crate::View;
use crate::materials::numbered;
use eightfold_tracer::scene::{Block, Camera, Light, List, Material, Plane, Scene, Shape, Sphere};
use glam::{Mat3, Vec3, vec3};

fn floor(camera: Camera, centre: Vec3, [half_x, half_z]: [f32; 2], size: [usize; 2]) -> View {
    let scene = Scene {
        camera,
        ambient: Vec3::ONE,
        planes: List::of(&[Plane::new(centre, half_x, half_z, numbered(0, 28))]),
        ..Scene::default()
    };
    View::new(scene, size)
}

fn ahead(height: f32, right: f32, up: f32, field_of_view: f32) -> Camera {
    let eye = Vec3::Y * height;
    Camera::new(eye, eye + vec3(right, up, -1.0), field_of_view)
}

/// Shadows of spheres barely larger than the rounding error of their points, some only in the last rows of the picture, and one
/// that was missed next to a box.
pub fn thin_shadows() -> [View; 4] {
    let steep = vec3(228.479_63, -511.928_6, -0.008_108_735);
    let low = vec3(0.627_962_1, 69.081_96, 0.738_625_3);
    // Camera, height and sides of the floor, size, sphere and light. The last is in the patch of a low light, next to a corner that is
    // dark with or without the shadow.
    [
        (
            ahead(-35.802_895, 0.512_459_9, 0.084_797, 0.618_702_65),
            vec3(0.0, -35.167_92, -20.0),
            [183.116_8, 260.027_65],
            [200, 160],
            (vec3(6.220_267_3, -36.842_022, -5.657_632), 0.000_581_008_1),
            vec3(6.482_078, -36.925_404, -5.875_787),
        ),
        (
            ahead(-43.877_266, 0.476_505_28, -0.081_047, 2.212_955_5),
            vec3(0.0, -53.467_705, -20.0),
            [130.611_7, 266.219_9],
            [640, 40],
            (vec3(108.019_88, -50.470_207, 46.806_44), 0.515_072),
            vec3(-1.477_199, 4.221_737, -3.184_710_3),
        ),
        (
            Camera::new(vec3(228.576_81, -512.928_6, 0.0), steep, 1.2),
            vec3(0.0, -512.7, 0.0),
            [1e5, 1e5],
            [320, 240],
            (vec3(231.831_54, -515.163_76, 0.525_486_23), 0.001_199_768),
            vec3(232.048_89, -515.318_5, 0.493_072_1),
        ),
        (
            Camera::new(69.381_966 * Vec3::Y, low, 0.6),
            vec3(0.0, 0.0, -20.0),
            [1e5, 1e5],
            [97, 203],
            (vec3(129.031_11, 0.025_655_242, 175.488_1), 0.018_169),
            vec3(129.063_11, 0.025_757_164, 175.602_97),
        ),
    ]
    .map(|(camera, middle, sides, size, (centre, radius), light)| {
        let mut view = floor(camera, middle, sides, size);
        view.light(centre, radius, light);
        view
    })
}

/// The image of a thin box in the corner of a very wide picture.
pub fn wide_image() -> View {
    let camera = ahead(-35.823_78, -0.695_287_1, -0.103_523, 2.682_118_4);
    let centre = vec3(0.0, -38.373_173, -20.0);
    let mut view = floor(camera, centre, [563.665_7, 61.342_262], [255, 255]);
    view.mirror();
    view.scene.blocks.push(Block::new(
        Shape::Box,
        vec3(11.895_88, -26.310_272, -11.920_961),
        vec3(0.020_078_469, 0.179_375_59, 0.179_375_59),
        Material::matt(vec3(1.0, 0.8, 0.6), 0.0),
    ));
    view
}

/// Objects that barely rise from a floor: marks of 6 pixels by 2e-6 of the eye's height, the tip of a ball, and a rod.
pub fn slivers() -> [View; 3] {
    let above = |height: f32, field_of_view: f32| Camera {
        up: Vec3::NEG_Z,
        ..Camera::new(Vec3::Y * height, Vec3::ZERO, field_of_view)
    };
    let low = vec3(0.351_313, 0.002_777_457_2, -2.0);
    let low = Camera::new(0.824_372_23 * Vec3::Y, low, 0.585_265_76);
    let mut views =
        [(above(600.0, 0.35), [320, 240]), (above(100.0, 0.8), [320, 240]), (low, [517, 61])]
            .map(|(camera, size)| floor(camera, Vec3::ZERO, [500.0, 500.0], size));
    let place = |i: usize| -52.600_563 + 28.289_38 * i as f32;
    for i in 0..25 {
        let centre = vec3(place(i / 5), 0.0005, place(i % 5));
        let half = vec3(2.652_129_2, 0.0005, 2.652_129_2);
        let mark = Block::new(Shape::Box, centre, half, numbered(1 + i, 28));
        views[0].scene.blocks.push(mark);
    }
    let centre = vec3(-32.237_984, -999.999_44, -32.237_984);
    let ball = Sphere::new(centre, 1000.0, numbered(1, 28));
    views[1].scene.spheres.push(ball);
    let centre = vec3(-2.462_177, -7.497_565_3, -1.566_425);
    let half = vec3(0.009_698_613, 7.497_571_5, 0.009_698_613);
    let rod = Block::new(Shape::Box, centre, half, numbered(1, 28));
    views[2].scene.blocks.push(rod);
    views
}

pub fn thin_highlights() -> [Scene; 2] {
    let tilted = Mat3::from_cols(
        vec3(0.665_042_4, 0.052_484_63, -0.744_959),
        vec3(-0.514_360_6, -0.691_017_5, -0.507_866),
        vec3(-0.541_434_94, 0.720_930_04, -0.432_559_9),
    );
    let block = |shape, centre, half, [grey, kd, ks, exponent, metallic]: [f32; 5]| {
        let material = Material { ks, exponent, metallic, ..Material::matt(Vec3::splat(grey), kd) };
        Block::new(shape, centre, half, material)
    };
    let leaning = Block {
        axes: tilted,
        ..block(
            Shape::Cylinder,
            vec3(4.340_268, 3.141_35, 0.792_119_5),
            vec3(0.090_269_424, 2.392_547_6, 0.090_269_424),
            [0.161_272_26, 0.477_772_47, 0.3373, 709.5888, 0.502_438_07],
        )
    };
    let standing = block(
        Shape::Capsule,
        vec3(2.033_094_4, 2.886_908, 3.929_962_2),
        vec3(0.172_525_03, 0.364_133_95, 0.172_525_03),
        [0.042_877_94, 0.125_820_68, 0.251_299_44, 170.442_4, 0.081_142_78],
    );
    let eye = vec3(-5.150_400_6, 2.655_453_2, 8.467_52);
    let look_at = vec3(1.782_630_9, -0.352_265_6, 0.849_080_3);
    let beside = Camera::new(eye, look_at, 0.808_121_7);
    let eye = vec3(2.343_061_4, 0.732_903_4, 9.006_272);
    let look_at = vec3(0.363_096_7, -0.290_949_23, -0.251_359_22);
    let before = Camera::new(eye, look_at, 1.092_614_2);
    let low = vec3(-2.492_057_8, 0.069_704_95, 6.166_302_7);
    let high = vec3(13.445_171, 7.541_676, -2.100_769);
    [
        (beside, leaning, Light::new(low, Vec3::splat(1.207_306_9))),
        (before, standing, Light::new(high, Vec3::splat(0.721_556_84))),
    ]
    .map(|(camera, block, light)| Scene {
        camera,
        background: Vec3::splat(0.05),
        ambient: Vec3::splat(0.3),
        blocks: List::of(&[block]),
        lights: List::of(&[light]),
        ..Scene::default()
    })
}

/// A picture of a colour half-way between two steps: 204.49998 of 255.
pub fn tie() -> Scene {
    Scene { background: vec3(0.801_960_7, 0.0, 0.0), ..Scene::default() }
}

/// A box where a ray at an edge hit the back face.
pub fn mirror_box(material: Material) -> Scene {
    let centre = vec3(-2.898_021, -0.397_971, -0.665_652_7);
    let half = vec3(0.741_517_96, 0.575_814_25, 0.917_006_7);
    let eye = vec3(1.619_298_6, -6.583_688_3, -3.228_574_5);
    Scene {
        camera: Camera { up: vec3(0.1, 1.0, 0.05), ..Camera::new(eye, centre, 0.391_123_4) },
        background: Vec3::ONE,
        blocks: List::of(&[Block::new(Shape::Box, centre, half, material)]),
        ..Scene::default()
    }
}
