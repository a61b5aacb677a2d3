//! `--loop` repeats the same pictures and sound. Sound device and clock are simulated.

#[path = "../../src/window/tests/simulated/mod.rs"]
mod simulated;

use eightfold::show::{self, grid};
use eightfold::sound::{RATE, SONG_LENGTH, Synthesizer};
use eightfold_stage::intro;
use std::process::{Command, Stdio};

const FPS: usize = 10;
const SHOW: usize = show::LENGTH as usize * FPS;

const SECONDS: usize = 14;

const SECOND: u64 = 1_000_000_000;

/// Parses a frame of a terminal into the colours of each cell: upper half, lower half.
fn colours(frame: &str) -> Vec<[u8; 6]> {
    let mut both = [0; 6];
    let mut cells = Vec::new();
    for code in frame.split("\x1b[") {
        let Some((colour, cell)) = code.split_once('m') else {
            continue;
        };
        let numbers: Vec<u8> = colour.split(';').map(|n| n.parse().unwrap_or(0)).collect();
        match numbers[..] {
            [38, 2, r, g, b] => both[..3].copy_from_slice(&[r, g, b]),
            [48, 2, r, g, b] => both[3..].copy_from_slice(&[r, g, b]),
            _ => {}
        }
        cells.extend(cell.matches('\u{2580}').map(|_| both));
    }
    cells
}

fn difference(a: &[[u8; 6]], b: &[[u8; 6]]) -> f64 {
    assert_eq!((a.len(), b.len()), (40 * 12, 40 * 12));
    let both = a.as_flattened().iter().zip(b.as_flattened());
    let sum: u32 = both.map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
    f64::from(sum) / (40 * 12 * 6) as f64
}

#[test]
fn second_round_repeats_sound_and_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let library = simulated::build(folder.path());
    let length = (SHOW / FPS + SECONDS).to_string();
    let mut intro = Command::new(intro());
    intro
        .args(["--loop", "--threads", "1", "--quality", "fastest"])
        .args(["--seconds", &length, "--fps", &FPS.to_string()])
        .env_remove("DISPLAY")
        .env_remove("STY")
        .env("TERM", "xterm")
        .env("LC_ALL", "C.UTF-8")
        .stdin(Stdio::null());
    let (output, played) = simulated::run(&library, &mut intro);
    let errors = String::from_utf8_lossy(&output.stderr);
    let line = "eightfold: X display is missing; playing in the terminal\n";
    assert!(output.status.success() && errors == line, "{errors}");

    let mut song = vec![[0.0; 2]; SONG_LENGTH as usize];
    Box::<Synthesizer>::default().play(&mut song);
    let wanted = song.iter().cycle();
    let heard = played.iter().flat_map(|(_, block)| block);
    assert!(played.len() * 48 >= (SHOW / FPS + SECONDS) * RATE as usize);
    for (number, (heard, wanted)) in heard.zip(wanted).enumerate() {
        assert_eq!(heard, wanted, "sample {number}");
    }
    let (start, _) = played[SONG_LENGTH as usize / 48];
    let drift = start.abs_diff(show::LENGTH as u64 * SECOND);
    assert!(drift <= SECOND / FPS as u64, "{start} ns");

    let text = String::from_utf8(output.stdout).expect("text");
    let frames: Vec<&str> = text.split("\x1b[1;1H").skip(1).collect();
    assert!(frames.len() >= SHOW + SECONDS * FPS);
    assert!(grid::BAR * show::cut("model") as f32 + 1.0 < SECONDS as f32);
    for at in (FPS..SECONDS * FPS).step_by(3) {
        let [first, second, before] =
            [at, SHOW + at, SHOW + at - FPS].map(|frame| colours(frames[frame]));
        let (same, other) = (difference(&first, &second), difference(&first, &before));
        assert!(same < 1.0 && same < other / 2.0, "frame {at}: {same}, {other}");
    }
}
