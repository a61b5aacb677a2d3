//! `lab view` shows in its window what the keys select.

use eightfold_stage::{DISPLAY, Process, Server, lacks, reader::read_png, run, wait_for};
use std::process::Command;

/// The window's size.
const SIZE: [i32; 2] = [320, 240];

/// A running `lab view` on its own X server.
struct View {
    server: Server,
    process: Process,
}

impl View {
    /// Starts the model scene with a pause after 2 s: time has no part in what is seen.
    fn start(options: &[&str]) -> View {
        View::of(&[&["--scene", "model", "--time", "2", "--paused"], options].concat())
    }

    fn of(options: &[&str]) -> View {
        let server = Server::start(640, 480);
        let mut lab = Command::new(env!("CARGO_BIN_EXE_lab"));
        lab.args(["view", "--size", "320x240"]);
        let process = server.open(lab.args(options), || window(&server));
        let [x, y, ..] = window(&server).expect("a window");
        server.xdotool(&format!("mousemove {} {}", x + 9, y + 9));
        View { server, process }
    }

    fn title(&self) -> String {
        let id = id(&self.server).expect("a window");
        let mut xprop = self.server.tool("xprop");
        let (_, text) = run(xprop.args(["-id", &id, "_NET_WM_NAME"]));
        text.split('"').nth(1).unwrap_or_default().to_owned()
    }

    /// Presses a key and waits until the title contains some words. The title is set after the frame is shown.
    #[track_caller]
    fn press(&self, key: &str, words: &str) {
        self.server.xdotool(&format!("key {key}"));
        self.wait(words);
    }

    fn wait(&self, words: &str) {
        wait_for(words, || self.title().contains(words).then_some(()));
    }

    /// Waits until the window shows the given picture.
    #[track_caller]
    fn assert_shows(&self, what: &str, is_wanted: impl Fn(&[u32]) -> bool) {
        wait_for(what, || is_wanted(&self.shot()).then_some(()));
    }

    fn shot(&self) -> Vec<u32> {
        let [x, y, width, height] = window(&self.server).expect("a window");
        assert_eq!([width, height], SIZE);
        self.server.screenshot([x, y, width, height])
    }
}

/// The window's id, for X tools.
fn id(server: &Server) -> Option<String> {
    let found = server.xdotool("search --onlyvisible --name ^Eightfold");
    found.lines().next().map(str::to_owned)
}

fn window(server: &Server) -> Option<[i32; 4]> {
    server.geometry(&["-id", &id(server)?])
}

/// The picture that `lab render` draws.
fn rendered(time: &str, quality: &str) -> Vec<u32> {
    let (output, _) = run(Command::new(env!("CARGO_BIN_EXE_lab"))
        .args(["render", "--size", "320x240", "--out", "-"])
        .args(["--time", time, "--quality", quality]));
    read_png(&output.stdout).1
}

/// The percentage in front of a word of the title, as a fraction.
fn number(title: &str, unit: &str) -> f64 {
    let (before, _) = title.split_once(unit).expect(unit);
    let word = before.split([' ', ',']).rfind(|word| !word.is_empty());
    word.expect("a number").parse().expect("a number")
}

#[test]
fn it_shows_the_picture_of_the_moment_and_says_how_right_it_is() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&[]);
    let picture = rendered("2", "default");
    view.assert_shows("the picture", |shot| shot == picture);
    view.wait("fps, ");
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
fn it_is_the_show_unless_asked_otherwise() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::of(&["--time", "20", "--paused"]);
    let (output, _) = run(Command::new(env!("CARGO_BIN_EXE_lab"))
        .args(["render", "--size", "320x240", "--out", "-"])
        .args(["--scene", "show", "--time", "20"]));
    let picture = read_png(&output.stdout).1;
    assert!(picture != rendered("20", "default"));
    view.assert_shows("the picture", |shot| shot == picture);
}

#[test]
fn time_is_under_control() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&["--fps", "50"]);
    let before = rendered("2", "default");
    view.assert_shows("the picture", |shot| shot == before);
    view.press("Right", "at 2.02 s, paused");
    let next = rendered("2.02", "default");
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
fn digits_choose_qualities() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&[]);
    for (key, quality) in [("2", "thesis"), ("1", "exhaustive"), ("9", "fastest")] {
        view.press(key, quality);
        let picture = rendered("2", quality);
        view.assert_shows(quality, |shot| shot == picture);
    }
    view.press("1", "exhaustive");
    view.wait("100.0 % traced, exact");
}

#[test]
fn letters_show_what_a_frame_is_made_of() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&["--quality", "thesis"]);
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
fn the_keys_are_listed_and_escape_ends_it() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&[]);
    view.server.xdotool("key question");
    // The title of a later frame was set after that of an earlier one.
    view.press("1", "exhaustive");
    view.server.xdotool("key Escape");
    let (_, code, output, errors) = view.process.end();
    assert_eq!((code, output.as_str()), (Some(0), ""));
    for key in [
        "Space", "Left", "Home", "1 to 9", "P ", "S ", "H ", "E ", "Esc",
    ] {
        assert!(errors.contains(key), "no {key} in {errors}");
    }
}

#[test]
fn a_larger_window_has_a_larger_picture() {
    if lacks(DISPLAY) {
        return;
    }
    let view = View::start(&[]);
    let size = format!("windowsize {} 400 300", id(&view.server).expect("a window"));
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

#[test]
fn bad_input_and_no_display_are_named_in_one_line() {
    for (options, code, words) in [
        (["--time", "-1"], 2, ["--time", "from 0"]),
        (["--fps", "none"], 2, ["--fps", "60"]),
        (["--quality", "9"], 2, ["--quality", "exhaustive"]),
        (["--size", "9"], 2, ["--size", "3840x2160"]),
        (["--threads", "2"], 1, ["view", "no X display"]),
    ] {
        let (output, _) = run(Command::new(env!("CARGO_BIN_EXE_lab"))
            .arg("view")
            .args(options)
            .env_remove("DISPLAY"));
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{errors}");
        assert_eq!(errors.lines().count(), 1, "{errors}");
        for word in words {
            assert!(errors.contains(word), "no {word} in {errors}");
        }
    }
}
