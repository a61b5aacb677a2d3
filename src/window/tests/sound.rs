//! Sound through ALSA itself, with devices of the tests' own: its plug-ins `file` and `null` need no hardware.
//!
//! A process reads ALSA's configuration once, so each scene is this program, started again.

use eightfold_stage::{allocations::Counting, needs};
use eightfold_window::sound::{Player, RATE, Source};
use std::{
    env, fs,
    path::Path,
    process::Command,
    thread,
    time::{Duration, Instant},
};

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

/// Sound that says which sample it is.
struct Numbers {
    next: u32,
    block: [[f32; 2]; 48],
}

/// One of many samples, both sides of it different, all exact.
fn sample(number: u32) -> [f32; 2] {
    let value = (number % 65_536) as f32 / 65_536.0;
    [value, -value]
}

impl Source for Numbers {
    fn block(&mut self) -> &[[f32; 2]] {
        for place in &mut self.block {
            *place = sample(self.next);
            self.next += 1;
        }
        &self.block
    }
}

/// Plays for a second. Says how long that was by the player, and how many allocations there were.
fn play() {
    let numbers = Box::leak(Box::new(Numbers {
        next: 0,
        block: [[0.0; 2]; 48],
    }));
    let mut player = Player::start(c"default", numbers);
    // The player's time began before its device was opened, which may take a while.
    let (start, begun) = (Instant::now(), player.time());
    let before = ALLOCATOR.count();
    let mut last = 0;
    while start.elapsed() < Duration::from_secs(1) {
        let time = player.time();
        assert!(time >= last, "time goes forward");
        last = time;
        thread::sleep(Duration::from_millis(10));
    }
    let allocations = ALLOCATOR.count() - before;
    let wall = start.elapsed().as_nanos() as f64;
    let played = (player.time() - begun) as f64;
    println!("{} {allocations}", played / wall);
}

/// Runs this program, with a configuration of ALSA's in a folder, through a command that ends in `"$0"`. Holds its time to the wall's,
/// and what it says to nothing, or to the one line of a show that goes on without sound, and why.
fn hold(folder: &Path, configuration: &str, command: &str, why_silent: Option<&str>) {
    let file = folder.join("asound.conf");
    fs::write(&file, configuration).unwrap();
    let output = Command::new("sh")
        .args(["-c", command])
        .arg(env::current_exe().unwrap())
        .env("ALSA_CONFIG_PATH", &file)
        .env("EIGHTFOLD_SOUND_SCENE", "1")
        .output()
        .unwrap();
    let [said, errors] =
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{errors}");
    let expected = why_silent.map(|why| format!("eightfold: {why}; playing silently\n"));
    assert_eq!(errors, expected.unwrap_or_default());
    let (pace, allocations) = said.trim().split_once(' ').expect("two numbers");
    assert_eq!(allocations, "0", "allocations while it plays");
    assert!((0.98..1.02).contains(&pace.parse().unwrap()), "{pace}");
}

const PLAIN: &str = "exec \"$0\"";

fn a_device_gets_every_sample_in_order(folder: &Path) {
    let out = folder.join("out.raw");
    let configuration = format!(
        "pcm.default {{ type file, slave.pcm {{ type null }}, file \"{}\", format raw }}",
        out.display()
    );
    hold(folder, &configuration, PLAIN, None);
    let bytes = fs::read(out).unwrap();
    let sides: Vec<f32> = bytes
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes(b.try_into().unwrap()))
        .collect();
    let count = sides.len() / 2;
    let second = RATE as usize;
    assert!(
        (second * 9 / 10..second * 13 / 10).contains(&count),
        "{count} samples"
    );
    for (number, sides) in (0..).zip(sides.chunks_exact(2)) {
        assert_eq!(sides, sample(number), "sample {number}");
    }
}

fn a_device_that_plays_nothing_keeps_time(folder: &Path) {
    hold(folder, "pcm.default { type null }", PLAIN, None);
}

fn time_goes_on_without_a_device(folder: &Path) {
    hold(folder, "", PLAIN, Some("no sound device"));
}

fn time_goes_on_without_the_library(folder: &Path) {
    fs::write(folder.join("libasound.so.2"), "not a library").unwrap();
    let command = format!("LD_LIBRARY_PATH='{}' exec \"$0\"", folder.display());
    let why = format!("{}/libasound.so.2: file too short", folder.display());
    hold(folder, "pcm.default { type null }", &command, Some(&why));
}

fn time_goes_on_when_the_device_disappears(folder: &Path) {
    // Half a second fits in the file; the signal that would end the program is ignored.
    let configuration = format!(
        "pcm.default {{ type file, slave.pcm {{ type null }}, file \"{}\", format raw }}",
        folder.join("short.raw").display()
    );
    let command = "trap '' XFSZ; ulimit -f 375; exec \"$0\"";
    hold(folder, &configuration, command, Some("sound device lost"));
    let played = fs::metadata(folder.join("short.raw")).unwrap().len();
    assert!(played > 100_000, "{played} bytes before it disappeared");
}

fn time_goes_on_with_a_device_that_refuses_48_khz(folder: &Path) {
    // It opens, and then ALSA says "Rate doesn't match (requested 48000Hz, get 44100Hz)".
    let configuration = "pcm.nothing { type null }
        pcm.default { type share, slave { pcm nothing, rate 44100, channels 2 }, bindings { 0 0, 1 1 } }";
    let why = "sound device refuses 48 kHz stereo";
    hold(folder, configuration, PLAIN, Some(why));
}

fn main() {
    if env::var_os("EIGHTFOLD_SOUND_SCENE").is_some() {
        return play();
    }
    needs!(&["libasound.so.2"]);
    let folder = env::temp_dir().join(format!("eightfold-sound-{}", std::process::id()));
    fs::create_dir(&folder).unwrap();
    for test in [
        a_device_gets_every_sample_in_order,
        a_device_that_plays_nothing_keeps_time,
        time_goes_on_without_a_device,
        time_goes_on_when_the_device_disappears,
        time_goes_on_with_a_device_that_refuses_48_khz,
        time_goes_on_without_the_library,
    ] {
        test(&folder);
    }
    fs::remove_dir_all(&folder).unwrap();
}
