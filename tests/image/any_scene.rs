//! Random scenes are drawn as the oracle draws them, by every instruction set. `PROPTEST_CASES` sets the number of scenes.

use crate::accuracy::assert_as_traced;
use crate::cpu;
use crate::drawn::draw;
use crate::generator::{config, rich, sketch, sphere};
use crate::refinement::{assert_as_refined, bare};
use eightfold::show;
use eightfold_oracle::frame::Frame;
use eightfold_tracer::Quality;
use proptest::collection::vec;
use proptest::prelude::*;

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn any_scene_is_as_the_oracle_sees_it(scene in sketch(vec(sphere(), 0..12), 2)) {
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 96, 72);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 96, 72);
            assert_as_traced(&drawn, &frame, isa.name);
        }
    }

    #[test]
    fn any_rich_scene_is_as_the_oracle_sees_it(scene in rich()) {
        scene.validate().unwrap();
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, 96, 72);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 1, &scene, &Quality::EXHAUSTIVE, 96, 72);
            assert_as_traced(&drawn, &frame, isa.name);
        }
    }

    #[test]
    fn any_scene_is_refined_by_the_rules(scene in sketch(vec(sphere(), 0..12), 2)) {
        for quality in [Quality::THESIS, Quality::DEFAULT].map(bare) {
            assert_as_refined(&scene, &quality, [96, 72], "any scene");
        }
    }

    #[test]
    fn the_model_scene_is_right_at_any_time_and_size(
        time in 0.0..show::MODEL_LENGTH,
        width in 1_usize..200,
        height in 1_usize..200,
    ) {
        let scene = show::model_scene(time);
        let frame = Frame::new(&scene, &Quality::EXHAUSTIVE, width, height);
        for isa in cpu::instruction_sets() {
            let drawn = draw(isa, 2, &scene, &Quality::EXHAUSTIVE, width, height);
            assert_as_traced(&drawn, &frame, isa.name);
        }
        assert_as_refined(&scene, &bare(Quality::THESIS), [width, height], "the model scene");
    }
}
