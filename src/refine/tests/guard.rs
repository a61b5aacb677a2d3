//! What the guard looks for.

use super::*;
use crate::prepare::Prepared;
use crate::scene::{List, Plane, Scene};

const WIDTH: usize = 320;
const HEIGHT: usize = 240;

/// The scene, prepared.
fn prepared(scene: &Scene) -> Box<Prepared> {
    let mut prepared = Box::new(Prepared::new());
    prepared.set(scene, WIDTH, HEIGHT);
    prepared
}

/// Planes beyond the first one are looked for as objects, too, and not as images in the first one.
#[test]
fn each_object_has_an_outline_of_its_own() {
    let scene = Scene {
        planes: List::of(&[Plane::default(); 2]),
        ..Scene::default()
    };
    let prepared = prepared(&scene);
    for number in 0..=prepared.background() {
        assert_eq!(prepared.outlined_object(number).index(), number);
    }
}
