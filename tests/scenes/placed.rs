use crate::{Random, View, coloured, scaled, solids};
use eightfold_tracer::scene::{Camera, Light, Material, Plane, Scene, Shape, Sphere};
use glam::{Mat3, Vec3, vec3};

/// Returns the point that a pixel shows at a distance, and the length of `pixels` there.
fn at(view: &View, [x, y]: [f32; 2], distance: f32, pixels: f32) -> (Vec3, f32) {
    // At the pixel's centre, so that a ray hits even small objects.
    let (d, pixel) = view.ray(x.floor(), y.floor());
    (view.scene.camera.eye + d * distance, pixels * pixel * distance)
}

fn anywhere(random: &mut Random, view: &View, far: [f32; 2], pixels: [f32; 2]) -> (Vec3, f32) {
    let [x, y] = [view.width, view.height].map(|side| random.between(0.0, side as f32));
    let distance = random.power(far[0], far[1]);
    at(view, [x, y], distance, random.power(pixels[0], pixels[1]))
}

fn among(random: &mut Random) -> View {
    let eye = random.vector(vec3(-3.0, -2.0, -3.0), vec3(3.0, 2.0, 3.0));
    let any = random.vector(Vec3::NEG_ONE, Vec3::ONE);
    let direction = random.one_of([any, any, any, Vec3::X, Vec3::NEG_Z, Vec3::NEG_Y]);
    let ahead = eye + direction + vec3(0.01, 0.0, 1e-3);
    let scene =
        Scene { camera: Camera::new(eye, ahead, random.between(0.2, 2.0)), ..Scene::default() };
    View::new(scene, [160, 120].map(|side| 1 + random.below(side)))
}

fn add_planes(view: &mut View, random: &mut Random) {
    for _ in 0..random.below(3) {
        let centre = random.vector(vec3(-6.0, -3.0, -6.0), vec3(6.0, 3.0, 6.0));
        let [x, z] = [0; 2].map(|_| random.power(-1.5, 1.5));
        view.scene.planes.push(Plane::new(centre, x, z, Material::BLACK));
    }
}

fn add_around(view: &mut View, random: &mut Random) {
    if random.below(4) == 0 {
        let radius = random.between(0.05, 20.0);
        let share = [random.between(0.0, 0.99), random.between(1.001, 2.0), 1.0];
        let share = random.one_of(share);
        let centre = view.scene.camera.eye + vec3(0.6, 0.0, 0.8) * (radius * share);
        view.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
    }
}

fn finished(mut view: View, random: &mut Random) -> View {
    let coloured = coloured(&view.scene, random.one_of([1, 28]));
    let decades = random.one_of([0.0, 4.0]);
    view.scene = scaled(&coloured, random.power(-decades, decades));
    view
}

/// Returns spheres from a tenth of a pixel to half the picture, planes, a few blocks and lights.
pub fn placed(random: &mut Random) -> View {
    let mut view = among(random);
    for _ in 0..1 + random.below(63) {
        let (centre, radius) = anywhere(random, &view, [-0.3, 1.6], [-1.0, 1.6]);
        view.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
    }
    add_around(&mut view, random);
    add_planes(&mut view, random);
    for _ in 0..random.one_of([0, 0, 12]) {
        add_block(&mut view, random, [-0.3, 1.6], [-1.0, 1.6], 1.0);
    }
    for _ in 0..random.below(3) {
        let (position, drawn_radius) = anywhere(random, &view, [-0.3, 1.6], [-1.0, 1.6]);
        view.scene.lights.push(Light { drawn_radius, ..Light::new(position, Vec3::ZERO) });
    }
    finished(view, random)
}

/// Returns blocks from half a pixel to far larger than the picture, some around the eye, some very thin.
pub fn placed_blocks(random: &mut Random) -> View {
    let mut view = among(random);
    for _ in 0..1 + random.below(31) {
        let thin = [1.0, 1.0, random.between(1e-3, 0.1)];
        let thin = random.one_of(thin);
        add_block(&mut view, random, [-1.5, 1.5], [-0.3, 3.5], thin);
    }
    add_around(&mut view, random);
    add_planes(&mut view, random);
    finished(view, random)
}

/// Adds a block in a random bounding sphere; `thin` scales its thin sides.
fn add_block(view: &mut View, random: &mut Random, far: [f32; 2], pixels: [f32; 2], thin: f32) {
    let (centre, radius) = anywhere(random, view, far, pixels);
    let shares = [0; 3].map(|_| [1.0, random.between(0.02, 1.0)][random.below(2)]);
    let mut block = solids::block(random, centre, Vec3::from(shares), Material::BLACK);
    block.half *= radius / block.half.length();
    block.half *= match block.shape {
        Shape::Box => vec3(1.0, thin, 1.0),
        _ => vec3(thin, 1.0, thin),
    };
    block.axes = random.one_of([Mat3::IDENTITY, block.axes, block.axes]);
    view.scene.blocks.push(block);
}

pub fn between_corners() -> View {
    let mut view = View::new(Scene::default(), [320, 240]);
    for row in 0..15 {
        for column in 0..20 {
            let pixel = [16 * column + 4, 16 * row + 4].map(|at| at as f32 + 0.1);
            let (centre, radius) = at(&view, pixel, 10.0, 0.3 + 0.15 * column as f32);
            view.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
        }
    }
    view.scene = coloured(&view.scene, 28);
    view
}
