//! The camera as the viewer moves it.

use eightfold_lab::arguments::Size;
use eightfold_lab::view::camera::{View, orbit, pan, zoom};
use eightfold_tracer::glam::{DVec3, dvec2};
use eightfold_tracer::scene::Scene;

const SIZE: Size = Size::new(320, 240);

fn camera() -> eightfold_tracer::scene::Camera {
    eightfold::show::model_scene(2.0).camera
}

#[test]
fn rays_and_places_belong_together_and_are_those_of_the_tracer() {
    let view = View::of(&camera(), SIZE);
    for at in [dvec2(0.5, 0.5), dvec2(100.0, 200.0), dvec2(319.0, 17.0)] {
        let seen = view
            .place(view.eye + view.ray(at) * 3.0)
            .expect("before it");
        assert!((seen - at).length() < 1e-9, "{seen} at {at}");
    }
    assert!(view.place(view.eye - view.forward).is_none());
    // The middle of each sphere that is seen is seen where it is.
    let scene: Scene = eightfold::show::model_scene(2.0);
    let quality = eightfold_tracer::Quality::EXHAUSTIVE;
    let oracle = eightfold_oracle::Oracle::new(&scene, &quality, SIZE.width, SIZE.height);
    let mut found = 0;
    for (i, sphere) in scene.spheres.iter().enumerate() {
        let Some(at) = view.place(sphere.centre.as_dvec3()) else {
            continue;
        };
        let object = oracle.object_at(at.x as isize, at.y as isize);
        found += usize::from(object == eightfold_oracle::Object::Sphere(i));
    }
    assert!(found >= 2, "{found}");
}

#[test]
fn a_camera_goes_round_and_keeps_its_distance() {
    let mut moved = camera();
    let distance =
        |camera: &eightfold_tracer::scene::Camera| (camera.eye - camera.look_at).length();
    orbit(&mut moved, 0.3, 0.2);
    assert!((distance(&moved) - distance(&camera())).abs() < 1e-4);
    assert!(moved.eye.y > camera().eye.y, "upwards");
    let before = View::of(&camera(), SIZE);
    let to_left = (moved.eye - camera().eye).as_dvec3().dot(before.right);
    assert!(to_left < 0.0, "to the left");
    // It never stands on its head.
    for _ in 0..50 {
        orbit(&mut moved, 0.0, 0.1);
    }
    let view = View::of(&moved, SIZE);
    assert!(view.up.y > 0.0 && view.forward.is_finite());
}

#[test]
fn a_pan_follows_the_pointer_and_a_zoom_keeps_the_middle() {
    let mut moved = camera();
    let target: DVec3 = camera().look_at.as_dvec3();
    let before = View::of(&camera(), SIZE).place(target).expect("seen");
    pan(&mut moved, SIZE, dvec2(30.0, -20.0));
    let after = View::of(&moved, SIZE).place(target).expect("seen");
    assert!((after - before - dvec2(30.0, -20.0)).length() < 0.01);
    let mut nearer = camera();
    zoom(&mut nearer, 3.0);
    let [near, far] = [&nearer, &camera()].map(|camera| (camera.eye - camera.look_at).length());
    assert!((f64::from(far / near) - 1.331).abs() < 1e-3);
}
