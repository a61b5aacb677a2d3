use eightfold::show::{self, grid};
use eightfold_stage::{intro, needs, tool};

const FPS: usize = 10;
const SHOW: usize = show::LENGTH as usize * FPS;

const SECONDS: usize = 14;

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

/// The sound repeats, too: `seeking_gives_the_same_samples_as_playing`.
#[test]
#[ignore = "two minutes"]
fn second_round_repeats_the_picture() {
    needs!(&["script"]);
    let length = SHOW / FPS + SECONDS;
    let options = "--loop --silent --threads 1 --quality fastest";
    let play = format!("{} {options} --seconds {length} --fps {FPS}", intro().display());
    let script =
        format!("stty cols 40 rows 12; unset DISPLAY STY; LC_ALL=C.UTF-8 TERM=xterm exec {play}");
    let output = tool("script").args(["-qec", &script, "/dev/null"]).output().expect("it starts");
    let text = String::from_utf8(output.stdout).expect("text");
    assert!(output.status.success(), "{text}");
    let frames: Vec<&str> = text.split("\x1b[1;1H").skip(1).collect();
    assert!(frames.len() + FPS >= SHOW + SECONDS * FPS, "{} frames", frames.len());
    assert!(grid::BAR * show::cut("still-life") as f32 + 1.0 < SECONDS as f32);
    for at in (FPS..(SECONDS - 1) * FPS).step_by(3) {
        let [first, second, before] =
            [at, SHOW + at, SHOW + at - FPS].map(|frame| colours(frames[frame]));
        let (same, other) = (difference(&first, &second), difference(&first, &before));
        // A busy machine may be a frame late.
        assert!(same < other / 2.0, "frame {at}: {same}, {other}");
    }
}
