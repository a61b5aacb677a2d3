//! Sound through ALSA itself, with devices of the tests' own: its plug-ins `file` and `null` need no hardware.
//!
//! A process reads ALSA's configuration once, so each scene is this program, started again.

use eightfold_stage::{allocations::Counting, needs};
use eightfold_window::sound::{Player, RATE, Source};
use std::{
    env, fs,
    path::Path,
    process::{Command, Output},
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

/// The output of a scene.
struct Scene {
    /// The player's time as a share of the wall's.
    pace: f64,
    allocations: usize,
    /// Lines on standard error.
    errors: String,
}

/// This program, with a configuration of ALSA's in a folder, through a command that ends in `"$0"`.
fn scene(folder: &Path, configuration: &str, command: &str) -> Scene {
    let file = folder.join("asound.conf");
    fs::write(&file, configuration).unwrap();
    let Output {
        status,
        stdout,
        stderr,
    } = Command::new("sh")
        .args(["-c", command])
        .arg(env::current_exe().unwrap())
        .env("ALSA_CONFIG_PATH", &file)
        .env("EIGHTFOLD_SOUND_SCENE", "1")
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&stderr).into_owned();
    assert!(status.success(), "{errors}");
    let said = String::from_utf8_lossy(&stdout).into_owned();
    let (pace, allocations) = said.trim().split_once(' ').expect("two numbers");
    let scene = Scene {
        pace: pace.parse().unwrap(),
        allocations: allocations.parse().unwrap(),
        errors,
    };
    assert_eq!(scene.allocations, 0, "allocations while it plays");
    scene
}

/// A test and its name.
type Named = (&'static str, fn(&Path));

/// Holds what is said to the one line of a show that goes on without sound, and why.
fn says_silent(scene: &Scene, why: &str) {
    assert_eq!(
        scene.errors,
        format!("eightfold: {why}; playing silently\n")
    );
}

const PLAIN: &str = "exec \"$0\"";

fn a_device_gets_every_sample_in_order(folder: &Path) {
    let out = folder.join("out.raw");
    let configuration = format!(
        "pcm.default {{ type file, slave.pcm {{ type null }}, file \"{}\", format raw }}",
        out.display()
    );
    let scene = scene(folder, &configuration, PLAIN);
    assert_eq!(scene.errors, "");
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
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
    let scene = scene(folder, "pcm.default { type null }", PLAIN);
    assert_eq!(scene.errors, "");
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
}

fn time_goes_on_without_a_device(folder: &Path) {
    let scene = scene(folder, "", PLAIN);
    says_silent(&scene, "no sound device");
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
}

fn time_goes_on_without_the_library(folder: &Path) {
    fs::write(folder.join("libasound.so.2"), "not a library").unwrap();
    let command = format!("LD_LIBRARY_PATH='{}' exec \"$0\"", folder.display());
    let scene = scene(folder, "pcm.default { type null }", &command);
    let path = folder.join("libasound.so.2");
    says_silent(&scene, &format!("{}: file too short", path.display()));
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
}

fn time_goes_on_when_the_device_disappears(folder: &Path) {
    // Half a second fits in the file; the signal that would end the program is ignored.
    let configuration = format!(
        "pcm.default {{ type file, slave.pcm {{ type null }}, file \"{}\", format raw }}",
        folder.join("short.raw").display()
    );
    let scene = scene(
        folder,
        &configuration,
        "trap '' XFSZ; ulimit -f 375; exec \"$0\"",
    );
    says_silent(&scene, "sound device lost");
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
    let played = fs::metadata(folder.join("short.raw")).unwrap().len();
    assert!(played > 100_000, "{played} bytes before it disappeared");
}

fn time_goes_on_with_a_device_that_refuses_48_khz(folder: &Path) {
    // It opens, and then ALSA says "Rate doesn't match (requested 48000Hz, get 44100Hz)".
    let configuration = "pcm.nothing { type null }
        pcm.default { type share, slave { pcm nothing, rate 44100, channels 2 }, bindings { 0 0, 1 1 } }";
    let scene = scene(folder, configuration, PLAIN);
    says_silent(&scene, "sound device refuses 48 kHz stereo");
    assert!((0.98..1.02).contains(&scene.pace), "{}", scene.pace);
}

fn main() {
    if env::var_os("EIGHTFOLD_SOUND_SCENE").is_some() {
        return play();
    }
    needs!(&["libasound.so.2"]);
    let folder = env::temp_dir().join(format!("eightfold-sound-{}", std::process::id()));
    fs::create_dir(&folder).unwrap();
    let scenes: [Named; 6] = [
        (
            "a device gets every sample in order",
            a_device_gets_every_sample_in_order,
        ),
        (
            "a device that plays nothing keeps time",
            a_device_that_plays_nothing_keeps_time,
        ),
        (
            "time goes on without a device",
            time_goes_on_without_a_device,
        ),
        (
            "time goes on when the device disappears",
            time_goes_on_when_the_device_disappears,
        ),
        (
            "time goes on with a device that refuses 48 kHz",
            time_goes_on_with_a_device_that_refuses_48_khz,
        ),
        (
            "time goes on without the library",
            time_goes_on_without_the_library,
        ),
    ];
    for (name, run) in scenes {
        run(&folder);
        println!("{name}: ok");
    }
    fs::remove_dir_all(&folder).unwrap();
}
