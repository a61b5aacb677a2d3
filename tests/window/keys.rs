use super::{SCREEN, end_by_key, on_screen, servers};
use eightfold_stage::{DISPLAY, Server, needs, run, succeed, wait_for};
use std::{thread::sleep, time::Duration};

#[test]
fn f_and_w_switch_fullscreen() {
    needs!(DISPLAY, &["twm", "xrandr"]);
    // twm lacks fullscreen.
    let twm = ("twm", on_screen(Server::start_with_twm));
    for (manager, server) in servers().into_iter().chain([twm]) {
        for monitor in [
            "--setmonitor right 640/1x800/1+640+0 screen",
            "--setmonitor left 640/1x800/1+0+0 none",
        ] {
            run(server.tool("xrandr").args(monitor.split(' ')));
        }
        let intro = server.play("--size 400x300 --seconds 60");
        let mut window = server.window().expect("a window");
        if manager == "no window manager" {
            assert_eq!(window, [760, 250, 400, 300], "centre of the first monitor");
        }
        for (left, monitor) in [(123, 0), (600, 640), (77, 0)] {
            server.xdotool(&format!("search --name Eightfold windowmove {left} 77"));
            sleep(Duration::from_millis(300));
            window = server.window().expect("a window");
            server.xdotool(&format!("mousemove {} {}", window[0] + 200, window[1] + 20));
            server.xdotool("key f");
            server.wait_for_window([monitor, 0, 640, 800]);
            assert_covered(&server, manager);
            server.xdotool("key w");
            server.wait_for_window(window);
        }
        server.xdotool("key --delay 0 f w f w");
        sleep(Duration::from_millis(300));
        server.wait_for_window(window);
        end_by_key("q", &server, intro);
    }
}

#[test]
fn keys_follow_the_layout_or_the_us_keyboard() {
    needs!(DISPLAY, &["setxkbmap"]);
    let server = on_screen(Server::start);
    // Key codes: F, W and Q on a US keyboard, W and Q on a French one, right Alt, left Ctrl.
    let [f, usual_w, usual_q, french_w, french_q, alt, control] = [41, 25, 24, 52, 38, 108, 37];
    let tap = |place: u32| server.xdotool(&format!("key {place}"));
    for (layout, w) in
        [("us", usual_w), ("ru", usual_w), ("ara", usual_w), ("fr", french_w), ("fr,us", usual_w)]
    {
        run(server.tool("setxkbmap").args(["-layout", layout, "-option", "grp:switch"]));
        let intro = server.play("--size 64x48 --fps 5 --seconds 60");
        let window = server.window().expect("a window");
        server.xdotool(&format!("mousemove {} {}", window[0] + 20, window[1] + 20));
        server.xdotool(&format!("keydown {control} key {f} keyup {control}"));
        sleep(Duration::from_millis(300));
        assert_eq!(server.window(), Some(window), "{layout}: Ctrl+F is no F");
        tap(f);
        server.wait_for_window(SCREEN);
        if layout.contains(',') {
            // Right Alt selects the second layout.
            server.xdotool(&format!("keydown {alt} key {w} keyup {alt}"));
        } else {
            tap(w);
        }
        server.wait_for_window(window);
        let q = if layout == "fr" { french_q } else { usual_q };
        let key = if layout.contains(',') {
            format!("--clearmodifiers {french_q}")
        } else {
            q.to_string()
        };
        end_by_key(&key, &server, intro);
    }
}

#[test]
fn h_toggles_the_hud() {
    needs!(DISPLAY);
    let server = on_screen(Server::start);
    let intro = server.play("--size 640x400 --seconds 60");
    let [left, top, ..] = server.window().expect("a window");
    server.xdotool(&format!("mousemove {} {}", left + 20, top + 300));
    let is_written = || {
        let corner = server.screenshot([left, top, 250, 30]);
        corner.iter().any(|&pixel| pixel & 0xff_ff_ff == 0xff_ff_ff)
    };
    sleep(Duration::from_millis(300));
    assert!(!is_written());
    for _ in 0..2 {
        server.xdotool("key h");
        wait_for("numbers", || is_written().then_some(()));
        server.xdotool("key h");
        wait_for("no numbers", || (!is_written()).then_some(()));
    }
    // A held key repeats 25 times a second, and counts once.
    for seconds in ["1.2", "1.1"] {
        server.xdotool(&format!("keydown h sleep {seconds} keyup h"));
        sleep(Duration::from_millis(300));
        assert_eq!(is_written(), seconds == "1.2");
    }
    end_by_key("Escape", &server, intro);
}

#[test]
fn screen_stays_on_while_the_show_plays() {
    needs!(DISPLAY, &["xprintidle"]);
    let server = on_screen(Server::start);
    let idle = || -> u64 {
        let (_, text) = run(&mut server.tool("xprintidle"));
        text.trim().parse().expect("milliseconds")
    };
    sleep(Duration::from_millis(1500));
    assert!(idle() > 1000);
    let intro = server.play("--fullscreen --size 64x48 --seconds 60");
    sleep(Duration::from_millis(1500));
    let time = idle();
    assert!(time < 500, "{time} ms");
    drop(intro);
}

#[test]
fn fullscreen_option_starts_fullscreen() {
    needs!(DISPLAY);
    for (manager, server) in servers() {
        let intro = server.play("--fullscreen --size 640x400 --seconds 60");
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

/// Without a window manager.
#[test]
fn fullscreen_follows_the_mode_of_the_display() {
    needs!(DISPLAY, &["xrandr"]);
    let server = on_screen(Server::start);
    let xrandr = |words: &str| succeed(server.tool("xrandr").args(words.split(' ')));
    xrandr("--newmode small 40 800 840 968 1056 600 601 605 628");
    xrandr("--addmode screen small");
    let intro = server.play("--size 400x300 --seconds 60");
    let window = server.window().expect("a window");
    server.xdotool(&format!("mousemove {} {} key f", window[0] + 20, window[1] + 20));
    server.wait_for_window(SCREEN);
    for (mode, screen) in [("small", [0, 0, 800, 600]), ("1280x800", SCREEN)] {
        xrandr(&format!("--output screen --mode {mode}"));
        server.wait_for_window(screen);
        assert_covered(&server, mode);
    }
    server.xdotool("key w");
    server.wait_for_window(window);
    // A window beyond the edge of a smaller screen could not be reached.
    server.xdotool("search --name Eightfold windowmove 850 300 key f");
    server.wait_for_window(SCREEN);
    xrandr("--output screen --mode small");
    server.wait_for_window([0, 0, 800, 600]);
    server.xdotool("key w");
    server.wait_for_window([0, 0, 400, 300]);
    end_by_key("Escape", &server, intro);
}

fn assert_covered(server: &Server, manager: &str) {
    let shot = server.screenshot(server.window().expect("a window"));
    let black = shot.iter().filter(|&&pixel| pixel == 0).count();
    assert_eq!(black, 0, "{manager}: black pixels");
}
