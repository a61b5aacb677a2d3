//! In a window the intro shows the frames of the show, and obeys keys and the window manager.

use eightfold::{Quality, scene::Scene, show};
use eightfold_lab::{error::Difference, threaded_renderer::ThreadedRenderer};
use eightfold_stage::{DISPLAY, Process, Server, intro, lacks, run, wait_for};
use eightfold_window::cpu;
use std::{
    process::Command,
    thread::sleep,
    time::{Duration, Instant},
};

/// The size of the screen: larger than the window, with another aspect ratio.
const SCREEN: [i32; 4] = [0, 0, 1280, 800];

fn servers() -> [(&'static str, Server); 2] {
    let [_, _, width, height] = SCREEN.map(|side| side as usize);
    [
        ("no window manager", Server::start(width, height)),
        ("openbox", Server::start_managed(width, height)),
    ]
}

#[test]
fn the_window_has_its_title_and_size_and_shows_the_frame() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--seconds", "60"]);
        let window = server.window().expect("a window");
        assert_eq!(window[2..], [1024, 768], "{manager}");
        let mut xprop = server.tool("xprop");
        let (_, properties) = run(xprop.args(["-name", "Eightfold", "WM_NAME", "_NET_WM_NAME"]));
        assert_eq!(
            properties.matches("\"Eightfold\"").count(),
            2,
            "{manager}: {properties}"
        );
        let (_, class) = run(server
            .tool("xprop")
            .args(["-name", "Eightfold", "WM_CLASS"]));
        assert!(class.contains("\"eightfold\", \"Eightfold\""), "{class}");
        drop(intro);

        assert_shows_a_frame(&server, manager, 0.2);
    }
}

#[test]
fn the_frame_has_its_colours_by_ten_bits_as_well() {
    if lacks(DISPLAY) {
        return;
    }
    let server = Server::start_with(1280, 800, &["-screen", "0", "1280x800x30"]);
    // The screenshot rounds ten bits down to eight.
    assert_shows_a_frame(&server, "30 bits", 1.2);
}

/// Plays in a small window, and looks for what is seen among the frames of the time it can be of; when the show is out of the
/// dark, which changes much from one to the next. The mean difference may be so much of 255.
fn assert_shows_a_frame(server: &Server, which: &str, tolerance: f64) {
    let start = Instant::now();
    let words = "--size 200x150 --seconds 60 --quality default";
    let intro = server.play(&words.split(' ').collect::<Vec<_>>());
    sleep(Duration::from_millis(1500));
    let shot = server.screenshot(server.window().expect("a window"));
    let difference = difference_to_show(&shot, 200, start.elapsed());
    assert!(
        difference < tolerance,
        "{which}: the nearest frame differs by {difference} of 255"
    );
    drop(intro);
}

#[test]
fn taps_on_f_and_w_go_to_the_whole_screen_and_back() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--size", "640x400", "--seconds", "60"]);
        server.xdotool("search --name Eightfold windowmove 123 77");
        sleep(Duration::from_millis(300));
        let window = server.window().expect("a window");
        server.xdotool(&format!("mousemove {} {}", window[0] + 20, window[1] + 20));
        for _ in 0..3 {
            server.xdotool("key f");
            server.wait_for_window(SCREEN);
            assert_covered(&server, manager);
            server.xdotool("key w");
            server.wait_for_window(window);
        }
        // Of keys pressed at once the last counts.
        server.xdotool("key --delay 0 f w f w");
        sleep(Duration::from_millis(300));
        server.wait_for_window(window);
        drop(intro);
    }
}

#[test]
fn keys_are_where_the_layout_has_them_and_without_latin_letters_where_they_are_in_the_usa() {
    if lacks(DISPLAY) || lacks(&["setxkbmap"]) {
        return;
    }
    let [_, _, width, height] = SCREEN.map(|side| side as usize);
    let server = Server::start(width, height);
    // Places of keys, by their numbers: those of F and W in the USA, and that of W in France; right Alt, and left Ctrl.
    let [f, usual_w, french_w, alt, control] = [41, 25, 52, 108, 37];
    let tap = |place: u32| server.xdotool(&format!("key {place}"));
    for (layout, w) in [
        ("us", usual_w),
        ("ru", usual_w),
        ("gr", usual_w),
        ("il", usual_w),
        ("ara", usual_w),
        ("fr", french_w),
        ("fr,us", usual_w),
    ] {
        run(server
            .tool("setxkbmap")
            .args(["-layout", layout, "-option", "grp:switch"]));
        let intro = server.play(&["--size", "640x400", "--seconds", "60"]);
        let window = server.window().expect("a window");
        server.xdotool(&format!("mousemove {} {}", window[0] + 20, window[1] + 20));
        server.xdotool(&format!("keydown {control} key {f} keyup {control}"));
        sleep(Duration::from_millis(300));
        assert_eq!(server.window(), Some(window), "{layout}: Ctrl+F is no F");
        tap(f);
        server.wait_for_window(SCREEN);
        if layout.contains(',') {
            // The second layout is in use as long as right Alt is held.
            server.xdotool(&format!("keydown {alt} key {w} keyup {alt}"));
        } else {
            tap(w);
        }
        server.wait_for_window(window);
        drop(intro);
    }
}

#[test]
fn a_window_manager_that_never_heard_of_fullscreen_does_not_keep_it_from_the_whole_screen() {
    if lacks(DISPLAY) || lacks(&["twm"]) {
        return;
    }
    let [_, _, width, height] = SCREEN.map(|side| side as usize);
    let server = Server::start_with_twm(width, height);
    let intro = server.play(&["--size", "640x400", "--seconds", "60"]);
    let window = server.window().expect("a window");
    server.xdotool(&format!("mousemove {} {}", window[0] + 20, window[1] + 20));
    for _ in 0..2 {
        server.xdotool("key f");
        server.wait_for_window(SCREEN);
        assert_covered(&server, "twm");
        server.xdotool("key w");
        server.wait_for_window(window);
    }
    end_by_escape(&server, intro);
}

#[test]
fn it_can_start_over_the_whole_screen() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--fullscreen", "--size", "640x400", "--seconds", "60"]);
        server.wait_for_window(SCREEN);
        assert_covered(&server, manager);
        server.xdotool("key w");
        wait_for("the window", || {
            let [_, _, width, height] = server.window()?;
            ([width, height] == [640, 400]).then_some(())
        });
        drop(intro);
    }
}

#[test]
fn the_window_can_have_any_size() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--seconds", "60"]);
        for [width, height] in [[1, 1], [333, 77], [2, 500], [701, 3], [640, 480]] {
            let size = format!("search --name Eightfold windowsize {width} {height}");
            server.xdotool(&size);
            wait_for("the size", || {
                let [_, _, w, h] = server.window()?;
                ([w, h] == [width, height]).then_some(())
            });
            sleep(Duration::from_millis(200));
        }
        let window = server.window().expect("a window");
        let shot = server.screenshot(window);
        assert!(shot.iter().all(|&pixel| pixel != 0), "{manager}: no black");
        let output = end_by_escape(&server, intro);
        assert!(output.contains("640x480"), "{manager}: {output}");
    }
}

#[test]
fn a_window_beyond_the_largest_picture_is_filled() {
    if lacks(DISPLAY) {
        return;
    }
    let server = Server::start(4100, 2200);
    let intro = server.play(&["--fullscreen", "--seconds", "60"]);
    server.wait_for_window([0, 0, 4100, 2200]);
    sleep(Duration::from_millis(1000));
    for [x, y] in [[0, 0], [4099, 0], [0, 2199], [4099, 2199], [2000, 1100]] {
        assert_ne!(server.screenshot([x, y, 1, 1]), [0], "pixel {x},{y}");
    }
    let output = end_by_escape(&server, intro);
    assert!(
        output.contains("3840x2060"),
        "of the window's shape: {output}"
    );
}

#[test]
fn escape_ends_it_at_once() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--seconds", "60"]);
        let output = end_by_escape(&server, intro);
        assert_eq!(output.lines().count(), 1, "{manager}: {output}");
        for word in ["frames in", "fps", "worst second", "1024x768", "threads"] {
            assert!(output.contains(word), "{manager}: {output}");
        }
    }
}

#[test]
fn closing_the_window_ends_it_at_once() {
    if lacks(DISPLAY) {
        return;
    }
    let [_, _, width, height] = SCREEN.map(|side| side as usize);
    let server = Server::start_managed(width, height);
    // By the window manager's message, and by force.
    for (tool, words) in [
        ("wmctrl", "-c Eightfold"),
        ("xdotool", "search --name Eightfold windowclose"),
    ] {
        let intro = server.play(&["--seconds", "60"]);
        sleep(Duration::from_millis(300));
        run(server.tool(tool).args(words.split(' ')));
        let (time, code, output, errors) = intro.end();
        assert_eq!(code, Some(0), "{tool}: {output}{errors}");
        assert_eq!(errors, "");
        assert_eq!(output.lines().count(), 1, "{tool}: {output}");
        assert!(time < Duration::from_millis(500), "{tool}: {time:?}");
    }
}

#[test]
fn the_end_of_the_server_is_an_error_and_no_crash() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, mut server) in servers() {
        let intro = server.play(&["--seconds", "60"]);
        sleep(Duration::from_millis(300));
        server.kill();
        let (_, code, output, errors) = intro.end();
        assert_eq!(code, Some(1), "{manager}: {output}{errors}");
        assert_eq!(errors, "eightfold: the display is gone\n");
    }
}

#[test]
fn a_display_without_pixels_of_32_bits_is_as_good_as_none() {
    if lacks(DISPLAY) {
        return;
    }
    let server = Server::start_with(320, 240, &["-screen", "0", "320x240x16"]);
    let intro = Process::start(
        Command::new(intro())
            .args(["--seconds", "0.3", "--silent"])
            .env("DISPLAY", &server.display),
    );
    let (_, code, output, errors) = intro.end();
    assert_eq!(code, Some(0), "{output}{errors}");
    let why = "X display without pixels of 32 bits";
    assert_eq!(
        errors,
        format!("eightfold: {why}; playing without a screen\n")
    );
}

#[test]
fn it_ends_by_itself() {
    if lacks(DISPLAY) {
        return;
    }
    for (manager, server) in servers() {
        let intro = server.play(&["--seconds", "1.5", "--size", "64x48"]);
        let (time, code, output, errors) = intro.end();
        assert_eq!(code, Some(0), "{manager}: {errors}");
        assert!(time > Duration::from_millis(500), "{manager}: {time:?}");
        assert!(output.contains(" in 1.5"), "{manager}: {output}");
    }
}

#[test]
fn the_show_waits_while_the_process_is_stopped() {
    if lacks(DISPLAY) {
        return;
    }
    /// How long it is stopped, in seconds.
    const STOP: f64 = 2.0;
    let server = Server::start(320, 240);
    let intro = server.play(&["--size", "64x48", "--seconds", "3"]);
    let tell = |signal: &str| {
        let (output, _) = run(Command::new("sh")
            .arg("-c")
            .arg(format!("kill -{signal} {}", intro.0.id())));
        assert!(output.status.success(), "{output:?}");
    };
    tell("STOP");
    sleep(Duration::from_secs_f64(STOP));
    tell("CONT");
    let (_, code, output, errors) = intro.end();
    assert_eq!(code, Some(0), "{errors}");
    let (_, time) = output.split_once(" in ").expect("a report");
    let time: f64 = time
        .split(' ')
        .next()
        .expect("a time")
        .parse()
        .expect("a number");
    assert!(time >= 3.0 + STOP, "{output}");
}

#[test]
fn frames_are_at_most_sixty_a_second_unless_uncapped() {
    if lacks(DISPLAY) {
        return;
    }
    let server = Server::start(320, 240);
    let frames = |options: &[&str]| {
        let intro = server.play(&[&["--size", "64x48", "--seconds", "2"], options].concat());
        let (_, _, output, _) = intro.end();
        let frames = output.split(' ').next().expect("a number of frames");
        frames.parse::<u32>().expect("a number")
    };
    let capped = frames(&[]);
    assert!(capped <= 121, "{capped} frames in 2 s");
    let uncapped = frames(&["--uncapped"]);
    // On a machine that is too slow for 60 frames per second the test proves nothing.
    assert!(uncapped > 121 || capped < 110, "{uncapped} frames in 2 s");
}

/// Ends the intro with Esc. Returns its standard output.
fn end_by_escape(server: &Server, intro: Process) -> String {
    let [x, y, ..] = server.window().expect("a window");
    server.xdotool(&format!("mousemove {x} {y}"));
    server.xdotool("key Escape");
    let (time, code, output, errors) = intro.end();
    assert_eq!(code, Some(0), "{output}{errors}");
    assert_eq!(errors, "");
    assert!(time < Duration::from_millis(500), "it took {time:?}");
    output
}

/// Asserts that the picture fills the screen: its background is not black.
fn assert_covered(server: &Server, manager: &str) {
    let shot = server.screenshot(SCREEN);
    let black = shot.iter().filter(|&&pixel| pixel == 0).count();
    assert_eq!(black, 0, "{manager}: black pixels");
}

/// The mean difference, over all channels, between a screenshot and the closest frame of the show up to a given time.
fn difference_to_show(shot: &[u32], width: usize, time: Duration) -> f64 {
    let mut renderer = ThreadedRenderer::new(1);
    let mut pixels = vec![0; shot.len()];
    let mut scene = Box::new(Scene::ZEROED);
    let mut difference = |milliseconds: u128| {
        show::at(milliseconds as f32 / 1000.0, &mut scene);
        let level = cpu::best().level;
        renderer.draw(level, &scene, &Quality::DEFAULT, width, &mut pixels);
        Difference::between(shot, &pixels).mean
    };
    // By hundredths of a second first, and then by thousandths about the best.
    let rough = (0..=time.as_millis()).step_by(10);
    let rough = rough.map(|at| (difference(at), at));
    let (_, at) = rough.min_by(|a, b| a.0.total_cmp(&b.0)).expect("a time");
    let fine = (at.saturating_sub(9)..at + 10).map(difference);
    fine.fold(f64::INFINITY, f64::min)
}
