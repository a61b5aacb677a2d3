use crate::display::{SIZE, View, bright, rendered};
use eightfold::show;
use eightfold_harness::Size;
use eightfold_harness::threaded_renderer::ThreadedRenderer;
use eightfold_lab::overlay::{draw_error, draw_heat, draw_points, draw_squares};
use eightfold_lab::scenes::SceneName;
use eightfold_lab::view::controls::{Controls, KEYS, MAX_ERROR, MAX_RAYS, Overlay};
use eightfold_lab::view::{frame_viewer::FrameViewer, subject::Subject};
use eightfold_stage::wait_for;
use eightfold_tracer::{Preset, Quality};
use eightfold_window::cpu;
use eightfold_window::input::Press;

#[test]
fn title_has_error_of_show() {
    let Some(view) = View::of("--time 20") else { return };
    let picture = rendered("--scene show --time 20");
    view.assert_shows("the picture", |shot| shot == picture);
    let title = wait_for("the error", || {
        let title = view.title();
        title.ends_with(" ± 0.0 dB to exhaustive").then_some(title)
    });
    let start = "Eightfold: default, picture at 20.00 s, paused; ";
    assert!(title.starts_with(start), "{title}");
}

#[test]
fn keys_select_quality_overlay_time() {
    let Some(view) = View::new() else { return };
    let at = |time: &str, quality: &str| rendered(&format!("--time {time} --quality {quality}"));
    let [thesis, exhaustive, fastest] =
        ["thesis", "exhaustive", "fastest"].map(|name| at("2", name));
    let (level, [width, height]) = (cpu::best().level, SIZE.map(|side| side as usize));
    let (scene, size) = (show::model_scene(2.0), Size::new(width, height));
    let (_, trace) = ThreadedRenderer::new(1).trace(level, &scene, &Quality::THESIS, size);
    let [mut points, mut squares, mut heat, mut error] = [(); 4].map(|()| thesis.clone());
    draw_points(&trace, &mut points);
    draw_squares(&trace, &mut squares);
    draw_heat(&trace, &mut heat, MAX_RAYS);
    draw_error(&mut error, &exhaustive, MAX_ERROR);
    let first = at("0", "thesis");
    for (key, title, picture) in [
        ("1", "exhaustive", &exhaustive),
        ("8", "fastest", &fastest),
        ("9", "thesis", &thesis),
        ("p", "points", &points),
        ("s", "squares", &squares),
        ("h", "heat map", &heat),
        ("e", "error", &error),
        ("e", "picture", &thesis),
        ("Right", "at 2.02 s, paused", &at(&(121.0 / 60.0).to_string(), "thesis")),
        ("Left", "at 2.00 s, paused", &thesis),
        ("Home", "at 0.00 s, paused", &first),
        ("1", "100.0 % traced, exact", &at("0", "exhaustive")),
    ] {
        view.press(key, title);
        view.assert_shows(title, |shot| shot == picture);
    }
    view.press("space", " s; ");
    wait_for("time to go on", || (!view.title().contains("0.00 s")).then_some(()));
    view.press("8", "fastest");
    wait_for("an estimate with its interval", || {
        let title = view.title();
        let (_, margin) = title.strip_suffix(" dB to exhaustive")?.split_once(" ± ")?;
        (margin != "0.0").then_some(())
    });
    view.press("space", " s, paused; ");
    assert!(view.shot() != first);
}

const PAUSED: Controls = Controls {
    frame: 0.0,
    length: 1.0,
    is_paused: true,
    quality: Preset::Thesis,
    overlay: Overlay::None,
};

#[test]
fn digits_without_presets_change_nothing() {
    let mut controls = PAUSED;
    for key in ['0', '٣', ':'] {
        controls.press(Press::Character(key));
        assert_eq!(controls, PAUSED, "{key}");
    }
}

#[test]
fn paused_picture_is_measured_after_drawing() {
    let subject = Subject::new(SceneName::Model);
    let mut viewer = FrameViewer::new(1, cpu::best());
    for (is_new, is_measured) in [(true, false), (true, true), (false, true)] {
        let drawn = viewer.draw(&PAUSED, &subject, Size::new(64, 48));
        assert_eq!((drawn, viewer.figures.psnr.is_some()), (is_new, is_measured));
    }
}

#[test]
fn keys_are_listed_over_picture() {
    let Some(view) = View::new() else { return };
    let picture = rendered("--time 2");
    view.assert_shows("the picture", |shot| shot == picture);
    view.key("question");
    view.assert_shows("white letters on black", |shot| {
        let black = shot.iter().filter(|&&pixel| pixel == 0).count();
        black > shot.len() / 2 && bright(shot) > 500
    });
    view.key("F1");
    view.assert_shows("the picture again", |shot| shot == picture);
    let effect = |key| KEYS.iter().find(|row| row.0 == key).map_or("", |row| row.1);
    assert!(effect("H").contains(&format!("for {MAX_RAYS} and more")));
    assert!(effect("E").contains(&format!("for {MAX_ERROR}/255 and more")));
}

#[test]
fn larger_window_has_larger_picture() {
    let Some(view) = View::new() else { return };
    let size = format!("windowsize {} 400 300", view.id);
    view.server.xdotool(&size);
    wait_for("a picture without black", || {
        let shot = view.server.screenshot(view.place());
        (shot.len() == 120_000 && shot.iter().all(|&pixel| pixel != 0)).then_some(())
    });
}
