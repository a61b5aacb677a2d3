//! Scattered objects for one purpose each.

use crate::kinds::Place::{AtPixel, Within};
use crate::materials::bright;
use crate::{Kinds, Random, View, coloured, materials_of, scaled};
use eightfold_tracer::scene::{Light, Material, Pattern, Scene, Sphere};
use glam::{Vec3, vec3};

/// Small objects above a floor, which are easily missed.
const HIDDEN: Kinds = Kinds {
    planes: 1,
    lights: 1,
    exact: true,
    eye: [vec3(-6.0, 2.0, 11.0), vec3(6.0, 8.0, 11.0)],
    look_at: [Vec3::ZERO; 2],
    angle: [0.6, 1.0],
    place: Within([vec3(-5.0, 0.5, -5.0), vec3(5.0, 3.0, 5.0)]),
    radius: [[-2.0, -0.3]; 2],
    half: [vec3(0.06, 2.0, 0.06), vec3(0.6, 2.0, 0.6)],
    plane: [Vec3::ZERO; 2],
    side: [1.3; 2],
    light: |random| {
        Light::new(random.vector(vec3(-6.0, 5.0, -6.0), vec3(6.0, 9.0, 6.0)), Vec3::ONE)
    },
    ..Kinds::SPHERES
};

/// Spheres from a tenth of a pixel to half the picture, planes, and blocks.
const PLACED: Kinds = Kinds {
    lights: 0,
    exact: true,
    turn: 0.0,
    angle: [0.2, 2.0],
    place: AtPixel([-0.3, 1.6]),
    radius: [[-1.0, 1.6]; 2],
    half: [Vec3::splat(0.02), Vec3::ONE],
    plane: [vec3(-6.0, -3.0, -6.0), vec3(6.0, 3.0, 6.0)],
    side: [-1.5, 1.5],
    ..Kinds::SPHERES
};

pub const GREY: Material = Material::matt(Vec3::splat(0.8), 0.9);

/// Returns a view whose materials are [`bright`] ones by number, in the order of [`materials_of`],
/// except the floor's.
pub fn hidden(random: &mut Random, [spheres, blocks]: [usize; 2], floor: Material) -> View {
    let mut view = Kinds { spheres, blocks, ..HIDDEN }.view(random);
    let scene = &mut view.scene;
    (scene.background, scene.ambient) = (Vec3::splat(0.1), Vec3::splat(0.2));
    materials_of(scene).into_iter().enumerate().for_each(|(i, material)| *material = bright(i));
    scene.planes[0].material = floor;
    view
}

fn crowded(random: &mut Random, [glass, mirrors]: [f32; 2]) -> Material {
    let kind = random.between(0.0, 1.0);
    let mut plastic = Material {
        colour: random.vector(Vec3::splat(0.05), Vec3::ONE),
        ks: random.between(0.0, 1.0),
        exponent: 60.0,
        ..Material::BLACK
    };
    let (kd, kr, kt) = if kind < glass {
        plastic.index = random.between(1.1, 1.6);
        (0.1, 0.1, 0.8)
    } else if kind < glass + mirrors {
        (0.2, random.between(0.3, 0.8), 0.0)
    } else {
        (0.8, 0.0, 0.0)
    };
    Material { kd, kr, kt, ..plastic }
}

/// Returns a crowd with these shares of glass and mirrors, over checkers or a plain floor. Up to
/// sixteen objects are large, and large glass spheres contain up to three others.
pub fn crowd(random: &mut Random, [spheres, blocks]: [usize; 2], shares: [f32; 2]) -> Scene {
    let is_large = spheres + blocks <= 16;
    let kinds = Kinds {
        spheres,
        blocks,
        lights: 1 + random.below(3),
        eye: [vec3(0.0, 0.6, 5.0), vec3(0.0, 8.0, 11.0)],
        look_at: [0.5 * Vec3::Y, 2.5 * Vec3::Y],
        angle: [0.5, 1.2],
        place: Within([vec3(-5.0, 0.0, -5.0), Vec3::splat(5.0)]),
        radius: [if is_large { [-0.5, 0.1] } else { [-1.0, -0.4] }; 2],
        half: [vec3(0.3, 1.5, 0.3), vec3(1.0, 6.0, 1.5)],
        ..HIDDEN
    };
    let mut scene = Scene { ambient: Vec3::splat(0.2), ..kinds.scene(random) };
    materials_of(&mut scene).into_iter().for_each(|it| *it = crowded(random, shares));
    let floor = &mut scene.planes[0].material;
    *floor = crowded(random, [0.0, shares[1]]);
    if random.below(2) == 0 {
        floor.pattern = Pattern::checkers(random.between(0.3, 1.5), 0.7);
    }
    scene.lights.iter_mut().for_each(|light| light.colour *= random.between(0.3, 1.0));
    for mut sphere in scene.spheres.clone().iter().copied().filter(|it| it.material.kt > 0.0) {
        for _ in 0..random.below(4) * usize::from(is_large) {
            sphere.radius *= random.one_of([0.999, 0.95, 0.8, 0.5]);
            sphere.material = crowded(random, shares);
            scene.spheres.push(sphere);
        }
    }
    scene
}

/// Returns a view along any direction or an axis, some from within a sphere, in distinct colours.
fn completed(random: &mut Random, kinds: Kinds) -> View {
    let eye = random.vector(vec3(-3.0, -2.0, -3.0), vec3(3.0, 2.0, 3.0));
    let any = random.vector(Vec3::NEG_ONE, Vec3::ONE);
    let direction = random.one_of([any, any, any, Vec3::X, Vec3::NEG_Z, Vec3::NEG_Y]);
    let kinds = Kinds {
        planes: random.below(3),
        size: [160, 120].map(|side| 1 + random.below(side)),
        eye: [eye; 2],
        look_at: [eye + direction + vec3(0.01, 0.0, 1e-3); 2],
        ..kinds
    };
    let mut view = kinds.view(random);
    if random.below(4) == 0 {
        let radius = random.between(0.05, 20.0);
        let share = [random.between(0.0, 0.99), random.between(1.001, 2.0), 1.0];
        let centre = eye + vec3(0.6, 0.0, 0.8) * (radius * random.one_of(share));
        view.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
    }
    for _ in 0..random.below(3) {
        let (position, drawn_radius) = PLACED.place(random, &view, PLACED.radius[0]);
        view.scene.lights.push(Light { drawn_radius, ..Light::new(position, Vec3::ZERO) });
    }
    let coloured = coloured(&view.scene, random.one_of([1, 28]));
    let decades = random.one_of([0.0, 4.0]);
    view.scene = scaled(&coloured, random.power(-decades, decades));
    view
}

pub fn placed(random: &mut Random) -> View {
    let (spheres, blocks) = (1 + random.below(63), random.one_of([0, 0, 12]));
    completed(random, Kinds { spheres, blocks, ..PLACED })
}

/// Returns blocks from half a pixel to far larger than the picture, some around the eye, some very
/// thin.
pub fn placed_blocks(random: &mut Random) -> View {
    let (blocks, thick) = (1 + random.below(31), random.one_of([1.0, 1.0, 0.1]));
    let (place, radius) = (AtPixel([-1.5, 1.5]), [[-0.3, 3.5]; 2]);
    let half = [vec3(1e-3, 0.02, 0.02), vec3(thick, 1.0, 1.0)];
    completed(random, Kinds { spheres: 0, blocks, place, radius, half, ..PLACED })
}

/// Returns spheres between the corners of squares, 0.3 to 3.15 pixels wide.
pub fn between_corners() -> View {
    let mut view = View::new(Scene::default(), [320, 240]);
    for row in 0..15 {
        for column in 0..20 {
            let pixel = [16 * column + 4, 16 * row + 4].map(|at| at as f32);
            let (centre, radius) = view.at(pixel, 10.0, 0.3 + 0.15 * column as f32);
            view.scene.spheres.push(Sphere::new(centre, radius, Material::BLACK));
        }
    }
    view.scene = coloured(&view.scene, 28);
    view
}
