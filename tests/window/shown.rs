use super::{end_by_key, servers};
use eightfold::show;
use eightfold_harness::{error::Difference, threaded_renderer::ThreadedRenderer};
use eightfold_stage::{DISPLAY, Process, Server, headless, needs, run, try_for, wait_for};
use eightfold_tracer::{Quality, presentation::Moment};
use eightfold_window::cpu;
use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

#[test]
fn window_has_title_and_size_and_shows_a_frame() {
    needs!(DISPLAY);
    for (manager, server) in servers() {
        let intro = assert_shows_a_frame(&server, manager, 0.2);
        assert_eq!(server.window().expect("a window")[2..], [200, 150], "{manager}");
        let property =
            |names: &[&str]| run(server.tool("xprop").args(["-name", "Eightfold"]).args(names)).1;
        let titles = property(&["WM_NAME", "_NET_WM_NAME"]);
        assert_eq!(titles.matches("\"Eightfold\"").count(), 2, "{manager}: {titles}");
        // EWMH asks for both the process and the machine.
        let (_, host) = run(&mut Command::new("hostname"));
        for (name, value) in [
            ("WM_CLASS", "\"eightfold\", \"Eightfold\"".to_owned()),
            ("_NET_WM_PID", intro.0.id().to_string()),
            ("WM_CLIENT_MACHINE", format!("\"{}\"", host.trim())),
        ] {
            let property = property(&[name]);
            assert!(property.trim().ends_with(&format!("= {value}")), "{property}");
        }
    }
}

#[test]
#[ignore = "many X servers are started"]
fn pixels_of_any_depth_show_the_colours() {
    needs!(DISPLAY);
    // Screenshots round 10 bits to 8. A step of 5 bits is 8/255.
    for (depth, tolerance) in [(30, 1.2), (16, 3.0), (15, 3.0)] {
        let screen = format!("1280x800x{depth}");
        let server = Server::start_with(1280, 800, &["-screen", "0", &screen]);
        assert_shows_a_frame(&server, &screen, tolerance);
    }
}

#[test]
fn environment_variables_do_not_block_the_window() {
    needs!(DISPLAY);
    let server = Server::start(320, 240);
    // Xlib reads HOME only without XAUTHORITY.
    for authority in [("XAUTHORITY", "/nowhere"), ("HOME", "")] {
        let mut command = headless("--seconds 0.2 --size 64x48");
        let command = command.env("DISPLAY", &server.display).env_remove("XAUTHORITY").envs([
            ("XMODIFIERS", "@im=nobody"),
            ("LC_ALL", "xx_XX.nothing"),
            ("TERM", ""),
            ("WAYLAND_DISPLAY", "nobody"),
            authority,
        ]);
        let (_, code, output, errors) = Process::start(command).end();
        assert_eq!((code, &*errors), (Some(0), ""), "{authority:?}: {output}");
    }
}

/// Compares a small window with the frames since the first second. `tolerance` limits the mean
/// difference, of 255.
fn assert_shows_a_frame(server: &Server, which: &str, tolerance: f64) -> Process {
    let start = Instant::now();
    let intro = server.play("--size 200x150 --seconds 60");
    sleep(Duration::from_millis(1500));
    let shot = server.window_screenshot();
    let difference = difference_to_show(&shot, 200, start.elapsed());
    assert!(difference < tolerance, "{which}: the nearest frame differs by {difference} of 255");
    intro
}

/// Unless its size is given.
#[test]
fn default_window_fits_a_small_display() {
    needs!(DISPLAY);
    for (width, height) in [(800, 600), (600, 900), (1920, 1080)] {
        for start in [Server::start, Server::start_managed] {
            let server = start(width as usize, height as usize);
            let intro = server.play("--fps 2 --seconds 60");
            // openbox moves the window, and takes the borders of its frame off one as wide as the
            // screen.
            let fits = |[x, y, w, h]: [i32; 4]| {
                let is_inside = x >= 0 && y >= 0 && x + w <= width && y + h <= height;
                let is_large = w == 1024 || w > width - 4 || h > height - 40;
                is_inside && is_large && (w * 3 - h * 4).abs() <= 8
            };
            let found = try_for(|| server.window().filter(|&window| fits(window)));
            assert!(found.is_some(), "{width}x{height}: {:?}", server.window());
            drop(intro);
        }
    }
    let server = Server::start(800, 600);
    let _intro = server.play("--size 1000x700 --fps 2 --seconds 60");
    assert_eq!(server.window().expect("a window")[2..], [1000, 700]);
}

#[test]
fn window_of_any_size_is_filled() {
    needs!(DISPLAY);
    for (manager, server) in servers() {
        let intro = server.play("--seconds 60");
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
        let output = end_by_key("Escape", &server, intro);
        assert_eq!(output.lines().count(), 1, "{manager}: {output}");
        for word in ["frames in", "fps", "worst second", "640x480", "threads"] {
            assert!(output.contains(word), "{manager}: {output}");
        }
    }
}

#[test]
fn window_beyond_largest_picture_is_filled() {
    needs!(DISPLAY);
    let server = Server::start(4100, 2200);
    let intro = server.play("--fullscreen --fps 5 --seconds 60");
    server.wait_for_window([0, 0, 4100, 2200]);
    sleep(Duration::from_millis(1000));
    let shot = server.screenshot([0, 0, 4100, 2200]);
    for [x, y] in [[0, 0], [4099, 0], [0, 2199], [4099, 2199], [2000, 1100]] {
        assert_ne!(shot[y * 4100 + x], 0, "pixel {x},{y}");
    }
    let output = end_by_key("Escape", &server, intro);
    assert!(output.contains("3840x2060"), "of the window's shape: {output}");
}

#[test]
fn display_with_colour_table_is_skipped() {
    needs!(DISPLAY);
    // Pixels of 8 bits are indices of a colour table.
    let server = Server::start_with(320, 240, &["-screen", "0", "320x240x8"]);
    let mut intro = headless("--seconds 0.3 --size 64x48");
    let intro = intro.env("DISPLAY", &server.display);
    let (_, code, output, errors) = Process::start(intro).end();
    assert_eq!(code, Some(0), "{output}{errors}");
    assert_eq!(errors, "eightfold: X display lacks colours; playing without a screen\n");
}

fn difference_to_show(shot: &[u32], width: usize, time: Duration) -> f64 {
    let mut renderer = ThreadedRenderer::new(1);
    let mut pixels = vec![0; shot.len()];
    let mut scene = Box::new(Moment::ZEROED);
    let mut difference = |milliseconds: u128| {
        show::at(milliseconds as f32 / 1000.0, &mut scene);
        let level = cpu::best().level;
        renderer.draw(level, &*scene, &Quality::THESIS, width, &mut pixels);
        Difference::between(shot, &pixels).mean
    };
    let rough = (1000..=time.as_millis()).step_by(10);
    let rough = rough.map(|at| (difference(at), at));
    let (_, at) = rough.min_by(|a, b| a.0.total_cmp(&b.0)).expect("a time");
    let fine = (at.saturating_sub(9)..at + 10).map(difference);
    fine.fold(f64::INFINITY, f64::min)
}
