//! Keys select time, quality and overlay.

use crate::stage::{View, bright, rendered as rendered_by, window};
use eightfold_lab::view::controls::{KEYS, MOST_ERROR, MOST_RAYS};
use eightfold_stage::wait_for;

/// The picture of the model scene that `lab render` draws.
fn rendered(time: &str, quality: &str) -> Vec<u32> {
    rendered_by(&format!("--time {time} --quality {quality}"))
}

/// The percentage in front of a word of the title, as a fraction.
fn number(title: &str, unit: &str) -> f64 {
    let (before, _) = title.split_once(unit).expect(unit);
    let word = before.split([' ', ',']).rfind(|word| !word.is_empty());
    word.expect("a number").parse().expect("a number")
}

#[test]
fn picture_and_title_belong_to_the_moment() {
    let Some(view) = View::new("") else { return };
    let picture = rendered("2", "default");
    view.assert_shows("the picture", |shot| shot == picture);
    view.wait(" dB");
    let title = view.title();
    for words in ["default", "picture", "2.00 s", "paused"] {
        assert!(title.contains(words), "{title}");
    }
    let traced = number(&title, " % traced");
    assert!(traced > 1.0 && traced < 50.0, "{title}");
    let psnr = number(&title, " dB");
    assert!(psnr > 20.0 && psnr < 90.0, "{title}");
}

#[test]
fn default_scene_is_the_show() {
    let Some(view) = View::of("--time 20") else {
        return;
    };
    let picture = rendered_by("--scene show --time 20");
    assert!(picture != rendered("20", "default"));
    view.assert_shows("the picture", |shot| shot == picture);
}

#[test]
fn time_is_paused_stepped_and_reset() {
    let Some(view) = View::new("") else {
        return;
    };
    let before = rendered("2", "default");
    view.assert_shows("the picture", |shot| shot == before);
    view.press("Right", "at 2.02 s, paused");
    let next = rendered(&(121.0_f64 / 60.0).to_string(), "default");
    assert!(before != next);
    view.assert_shows("the next frame", |shot| shot == next);
    view.press("Left", "at 2.00 s");
    view.assert_shows("the frame before", |shot| shot == before);
    view.press("Home", "at 0.00 s, paused");
    let first = rendered("0", "default");
    view.assert_shows("the first frame", |shot| shot == first);
    view.server.xdotool("key space");
    wait_for("time to go on", || {
        let title = view.title();
        (!title.contains("paused") && number(&title, " s;") > 0.3).then_some(())
    });
    view.press("space", "paused");
    assert!(view.shot() != first);
}

#[test]
fn digits_select_qualities() {
    let Some(view) = View::new("") else { return };
    for (key, quality) in [("2", "thesis"), ("1", "exhaustive"), ("9", "fastest")] {
        view.press(key, quality);
        let picture = rendered("2", quality);
        view.assert_shows(quality, |shot| shot == picture);
    }
    view.press("1", "exhaustive");
    view.wait("100.0 % traced, exact");
}

#[test]
fn letters_select_overlays() {
    let Some(view) = View::new("--quality thesis") else {
        return;
    };
    let picture = rendered("2", "thesis");
    let exhaustive = rendered("2", "exhaustive");
    let pixels = picture.len();
    let share = |shot: &[u32], is: &dyn Fn(u32) -> bool| {
        shot.iter().filter(|&&pixel| is(pixel)).count() as f64 / pixels as f64
    };

    view.press("p", "points");
    view.assert_shows("the corners, white on dark", |shot| {
        let corner = shot.iter().step_by(8).take(40);
        corner.clone().all(|&pixel| pixel == 0x00ff_ffff) && shot[1] == (picture[1] >> 2) & 0x3f3f3f
    });
    let traced = number(&view.title(), " % traced") / 100.0;
    let white = share(&view.shot(), &|pixel| pixel == 0x00ff_ffff);
    // Some traced points lie outside of the picture.
    assert!(
        white <= traced + 1e-3 && white > 0.9 * traced,
        "{white} of {traced}"
    );

    view.press("s", "squares");
    view.assert_shows("squares of 8, each with its edge", |shot| {
        shot[0] == shot[1]
            && shot[8] == shot[0]
            && shot[8 * 320 + 8] == shot[0]
            && shot[321] != shot[0]
    });
    view.press("h", "heat map");
    view.assert_shows("black where no ray began", |shot| {
        let black = share(shot, &|pixel| pixel & 0x00f0_f0f0 == 0 && pixel & 0xff < 8);
        shot[1] == shot[2] && black > 0.5 && black < 1.0
    });
    view.press("e", "error");
    view.assert_shows("black where nothing is wrong", |shot| {
        let black = shot[0];
        let mut pixels = shot.iter().zip(picture.iter().zip(&exhaustive));
        pixels.all(|(&shot, (picture, exhaustive))| (shot == black) == (picture == exhaustive))
    });
    view.press("1", "exhaustive");
    view.assert_shows("no error", |shot| {
        shot.iter().all(|&pixel| pixel == shot[0])
    });
    view.press("2", "thesis");
    view.press("e", "picture");
    view.assert_shows("the picture again", |shot| shot == picture);
}

#[test]
fn keys_are_listed_over_the_picture() {
    let Some(view) = View::new("") else { return };
    let picture = rendered("2", "default");
    view.assert_shows("the picture", |shot| shot == picture);
    view.key("question");
    view.assert_shows("white letters on dark", |shot| {
        let is_dark = |pixel: &&u32| pixel.to_be_bytes().iter().all(|&channel| channel < 64);
        let dark = shot.iter().filter(is_dark).count();
        dark > shot.len() / 2 && bright(shot) > 500
    });
    view.key("F1");
    view.assert_shows("the picture again", |shot| shot == picture);
    let effect = |key| KEYS.iter().find(|row| row.0 == key).map_or("", |row| row.1);
    assert!(effect("H").contains(&format!("for {MOST_RAYS} and more")));
    assert!(effect("E").contains(&format!("for {MOST_ERROR}/255 and more")));
}

#[test]
fn larger_window_has_larger_picture() {
    let Some(view) = View::new("") else { return };
    let size = format!("windowsize {} 400 300", view.id());
    view.server.xdotool(&size);
    wait_for("the size", || {
        let [.., width, height] = window(&view.server)?;
        ([width, height] == [400, 300]).then_some(())
    });
    wait_for("a picture without black", || {
        let shot = view.server.screenshot(window(&view.server)?);
        (shot.len() == 120_000 && shot.iter().all(|&pixel| pixel != 0)).then_some(())
    });
}
