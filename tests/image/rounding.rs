//! Scenes in which rounding decides more than the fewest pixels: the library may draw either picture.

use crate::accuracy::assert_as_traced;
use crate::drawn::draw_by_all;
use crate::refinement::{assert_as_refined, bare};
use eightfold_oracle::frame::Frame;
use eightfold_tracer::Quality;
use eightfold_tracer::scene::{Camera, Light, List, Material, Plane, Scene, Sphere};
use glam::vec3;

fn hold(scene: &Scene) {
    let frame = Frame::new(scene, &Quality::EXHAUSTIVE, 96, 72);
    for (isa, drawn) in draw_by_all(scene, &Quality::EXHAUSTIVE, 96, 72) {
        assert_as_traced(&drawn, &frame, isa.name);
    }
    for quality in [Quality::THESIS, Quality::DEFAULT].map(bare) {
        assert_as_refined(scene, &quality, [96, 72], &format!("{quality:?}"));
    }
}

#[test]
fn a_picture_full_of_a_colour_half_way_between_two_steps_may_be_either() {
    // 204.49998 of 255, which is half-way in what sums are counted in.
    hold(&Scene {
        background: vec3(0.801_960_7, 0.0, 0.0),
        ..Scene::default()
    });
}

#[test]
fn a_square_on_the_limit_may_change_what_is_allowed_all_over_a_crowded_tile() {
    // The corners of the square at (8, 56) are 7.502 steps apart, of 7.5 that are allowed.
    let mirror = Material {
        colour: vec3(0.0, 0.453_013_18, 0.0),
        kd: 0.465_792_98,
        kr: 0.517_309_6,
        ..Material::BLACK
    };
    let glass = Material {
        kt: 0.625_025,
        index: 1.05,
        ..Material::BLACK
    };
    let plain = Material {
        colour: vec3(0.863_509_65, 0.832_737_86, 0.0),
        kd: 0.733_752_67,
        kr: 0.072_273_97,
        fresnel: 0.641_559_3,
        ..Material::BLACK
    };
    hold(&Scene {
        camera: Camera::new(
            vec3(11.196_411, 3.599_415_5, 3.818_215_6),
            vec3(0.265_278_37, 0.974_821_2, -0.447_315_5),
            0.978_380_56,
        ),
        background: vec3(0.204_868_7, 0.468_858_1, 0.658_795_7),
        spheres: List::of(&[
            Sphere::new(
                vec3(3.912_933_8, 1.408_549_7, 2.006_606_3),
                1.363_227_5,
                mirror,
            ),
            Sphere::new(vec3(2.370_852_5, 0.2, 2.803_644_7), 1.433_409_2, glass),
        ]),
        planes: List::of(&[
            Plane::new(
                vec3(0.3, -0.066_204_83, -0.2),
                15.633_017,
                7.145_592_7,
                plain,
            ),
            Plane::new(
                vec3(0.3, -1.871_376_3, -0.2),
                14.940_671,
                14.567_095,
                Material::BLACK,
            ),
        ]),
        lights: List::of(&[Light {
            drawn_radius: 0.05,
            ..Light::new(
                vec3(6.236_529, 3.809_735_5, 7.417_129),
                vec3(0.461_459_55, 0.517_563_5, 0.0),
            )
        }]),
        ..Scene::default()
    });
}

#[test]
fn a_corner_on_a_silhouette_may_change_a_square_of_a_small_picture() {
    // What the point at (72, 28) sees through the ball is one sphere or the other.
    let glass = Material {
        colour: vec3(0.0, 0.445_462_88, 0.0),
        kr: 0.396_769_9,
        fresnel: 0.177_279_76,
        kt: 0.536_092_5,
        index: 1.823_721_5,
        ..Material::BLACK
    };
    let mirror = Material {
        colour: vec3(0.0, 0.987_339_26, 0.0),
        kr: 0.483_654_08,
        fresnel: 0.720_138_55,
        ..Material::BLACK
    };
    hold(&Scene {
        camera: Camera::new(
            vec3(1.790_249_8, 4.780_583_4, -10.066_627),
            vec3(0.520_800_6, 0.769_196_7, -0.584_437_67),
            0.441_956_64,
        ),
        background: vec3(0.0, 0.881_862_04, 0.354_252_43),
        ambient: vec3(0.0, 0.139_217_5, 0.0),
        spheres: List::of(&[
            Sphere::new(
                vec3(-2.295_154_6, 2.073_152_3, 3.863_216),
                0.897_744_54,
                Material::BLACK,
            ),
            Sphere::new(
                vec3(-1.590_936_5, 1.594_831_6, 0.343_345_14),
                1.255_829_5,
                glass,
            ),
        ]),
        planes: List::of(&[Plane::new(
            vec3(0.3, 0.0, -0.2),
            4.936_214,
            12.063_99,
            mirror,
        )]),
        ..Scene::default()
    });
}
