mod allocation;
mod ending;
mod keys;
mod pixels;
mod shared_memory;
mod shown;

use eightfold_stage::{Process, Server};
use std::time::Duration;

/// Larger than the window, with another aspect ratio.
const SCREEN: [i32; 4] = [0, 0, 1280, 800];

fn on_screen(start: fn(usize, usize) -> Server) -> Server {
    let [_, _, width, height] = SCREEN.map(|side| side as usize);
    start(width, height)
}

fn servers() -> [(&'static str, Server); 2] {
    [("no window manager", on_screen(Server::start)), ("openbox", on_screen(Server::start_managed))]
}

/// Ends the intro by a key, given by its name or code. Returns its standard output.
fn end_by_key(key: &str, server: &Server, intro: Process) -> String {
    let [x, y, ..] = server.window().expect("a window");
    server.xdotool(&format!("mousemove {x} {y}"));
    server.xdotool(&format!("key {key}"));
    let (time, code, output, errors) = intro.end();
    assert_eq!(code, Some(0), "{output}{errors}");
    assert_eq!(errors, "");
    assert!(time < Duration::from_secs(2), "it took {time:?}");
    output
}
