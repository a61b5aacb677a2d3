//! Errors as a viewer sees them: views that differ, pixels that pop, FLIP over all of them together.

use eightfold::show;
use eightfold_lab::arguments::Size;
use eightfold_lab::error::worst_channel;
use eightfold_lab::flip::{Flip, Flips};
use eightfold_lab::scenes::SceneName;
use eightfold_lab::threaded_renderer::{ThreadedRenderer, drawn};
use eightfold_lab::views::{Seen, Viewer, pops, views};
use eightfold_lab::way::Way;
use eightfold_tracer::Quality;
use eightfold_window::cpu;

const SIZE: Size = Size::new(96, 72);

/// A frame of the model scene.
fn model(time: f32, quality: &Quality) -> Vec<u32> {
    drawn(1, &show::model_scene(time), quality, SIZE)
}

/// The share of pixels that can be told apart.
fn share_that_differs(a: &[u32], b: &[u32]) -> f64 {
    let pairs = a.iter().zip(b);
    let differing = pairs.filter(|&(&a, &b)| worst_channel(a, b) > 8).count();
    differing as f64 / a.len() as f64
}

#[test]
fn all_views_of_the_model_scene_differ() {
    let views = views(0.0, show::MODEL_LENGTH, 9, None);
    assert_eq!(views.len(), 9);
    let frames: Vec<Vec<u32>> = views
        .iter()
        .map(|view| model(view[0], &Quality::EXHAUSTIVE))
        .collect();
    for (i, a) in frames.iter().enumerate() {
        for (j, b) in frames[..i].iter().enumerate() {
            let share = share_that_differs(a, b);
            assert!(share > 0.2, "views {i} and {j} differ in {share}");
        }
    }
    // Why the last moment has no view of its own.
    let last = model(show::MODEL_LENGTH, &Quality::EXHAUSTIVE);
    assert!(share_that_differs(&frames[0], &last) < 0.01);
}

#[test]
fn a_view_is_followed_by_frames_in_a_row_as_long_as_its_scene_lasts() {
    let all = views(2.0, 8.0, 3, None);
    let firsts: Vec<f32> = all.iter().map(|view| view[0]).collect();
    assert_eq!(firsts, [2.0, 4.0, 6.0]);
    for view in &all {
        assert_eq!(view.len(), 11);
        for pair in view.windows(2) {
            assert!((pair[1] - pair[0] - 1.0 / 60.0).abs() < 1e-6);
        }
    }
    let cut = views(2.0, 8.0, 3, Some(6.04));
    assert_eq!(cut[..2], all[..2]);
    assert_eq!(cut[2], all[2][..3]);
    // One moment is one view, however many are asked for.
    assert_eq!(views(2.0, 2.0, 9, Some(1.0)), [[2.0]]);
}

#[test]
fn a_pixel_pops_that_jumps_while_its_reference_stays() {
    let count = |references: [u32; 2], frames: [u32; 2]| {
        pops(
            [&[0, references[0]], &[0, references[1]]],
            [&[0, frames[0]], &[0, frames[1]]],
        )
    };
    let (dark, light) = (0x0040_4040, 0x0040_5140);
    assert_eq!(count([dark, dark], [dark, light]), 1);
    assert_eq!(count([dark, dark], [light, dark]), 1);
    // An error that stays, however large.
    assert_eq!(count([dark, dark], [light, light]), 0);
    // No more than 16 of 255.
    assert_eq!(count([dark, dark], [dark, light - 0x100]), 0);
    // What moves may jump, from a change of more than 4 on.
    assert_eq!(count([dark, dark + 4], [dark, light]), 1);
    assert_eq!(count([dark, dark + 5], [dark, light]), 0);
    assert_eq!(count([dark, light], [dark, light]), 0);
}

/// Returns what is seen of two qualities of the model scene, the first of which is the reference, while time goes on or stands still.
fn seen_of(qualities: [Quality; 2], is_still: bool) -> [Seen; 2] {
    let ways = qualities.map(|quality| Way::new("", quality));
    let mut seen = [Seen::default(), Seen::default()];
    let mut renderer = ThreadedRenderer::new(2);
    let mut viewer = Viewer::new(&mut renderer, cpu::best(), SIZE, true);
    for mut view in views(2.0, 8.0, 2, None) {
        if is_still {
            view.fill(2.0);
        }
        viewer.look(&view, SceneName::Model, &ways, &mut seen);
    }
    seen
}

#[test]
fn nothing_pops_in_a_still_picture_or_where_every_pixel_is_traced() {
    let coarse = Quality {
        tolerance_agreeing: 64.0,
        ..Quality::THESIS
    };
    let [_, still] = seen_of([Quality::EXHAUSTIVE, coarse], true);
    assert_eq!(still.pops(), Some(0.0));
    let [exact, moving] = seen_of([Quality::EXHAUSTIVE, coarse], false);
    assert_eq!(exact.pops(), Some(0.0));
    assert!(moving.pops().is_some_and(|pops| pops > 0.1));
    assert_eq!(Seen::default().pops(), None);
}

#[test]
fn many_samples_are_nearer_to_antialiased_frames_and_equal_to_none() {
    let antialiased = Quality {
        antialias: true,
        ..Quality::EXHAUSTIVE
    };
    let [jagged, smooth] = seen_of([Quality::EXHAUSTIVE, antialiased], false);
    assert_eq!(jagged.flips.mean(), Some(0.0));
    let psnr = [&jagged, &smooth].map(|seen| seen.psnr_to_64_db().expect("two views"));
    assert!(psnr[0] > 25.0 && psnr[1] > psnr[0] + 2.0, "{psnr:?}");
    let flip = [&jagged, &smooth].map(|seen| seen.flips_to_64.mean().expect("two views"));
    assert!(0.0 < flip[1] && flip[1] < flip[0], "{flip:?}");
}

#[test]
fn flip_of_pictures_together_is_that_of_all_their_pixels() {
    let mut flips = Flips::default();
    assert_eq!(flips.mean(), None);
    for (error, count) in [(0.25, 99), (1.0, 1)] {
        let errors = vec![error; count];
        flips.add(&Flip { errors });
    }
    assert_eq!(flips.mean(), Some(0.2575));
}
