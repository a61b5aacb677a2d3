//! Sound through ALSA: with its plug-ins `file` and `null`.
//!
//! A process reads ALSA's configuration once, so each case starts this program again.

use eightfold_stage::{allocations::Counting, lacks};
use eightfold_window::clock::{Clock, SECOND};
use eightfold_window::sound::{Player, RATE, Source};
use std::{env, fs, path::Path, process::Command};

#[global_allocator]
static ALLOCATOR: Counting = Counting::new();

const CHUNK: usize = 48;

const FPS: u64 = 60;

const SCENE: &str = "EIGHTFOLD_SOUND_SCENE";

/// Sound whose left samples count from 0, and whose right ones are negative. All are exact: there
/// are fewer than 2^24.
struct Numbers {
    next: u32,
    chunk: [[f32; 2]; CHUNK],
}

impl Source for Numbers {
    fn chunk(&mut self) -> &[[f32; 2]] {
        for place in &mut self.chunk {
            *place = [self.next as f32, -(self.next as f32)];
            self.next += 1;
        }
        &self.chunk
    }
}

/// Prints the number of allocations while it plays, then the clock's and the player's time for each
/// frame.
fn play(seconds: u64) {
    let numbers = Box::leak(Box::new(Numbers { next: 0, chunk: [[0.0; 2]; CHUNK] }));
    let frames = seconds * FPS;
    let mut times = Vec::with_capacity(frames as usize);
    let clock = Clock::start();
    let mut player = Player::start(numbers);
    let before = ALLOCATOR.count();
    for frame in 0..frames {
        clock.sleep_until(frame * SECOND / FPS);
        times.push((clock.time(), player.time()));
    }
    println!("{}", ALLOCATOR.count() - before);
    for (clock, player) in times {
        println!("{clock} {player}");
    }
}

/// Plays for a second with an ALSA configuration, from a command that ends in `"$0"`.
fn play_on(
    folder: &Path,
    configuration: &str,
    command: &str,
    why_silent: Option<&str>,
) -> Vec<(u64, u64)> {
    let file = folder.join("asound.conf");
    fs::write(&file, configuration).expect("it is written");
    let output = Command::new("sh")
        .args(["-c", command])
        .arg(env::current_exe().expect("this program"))
        .env("ALSA_CONFIG_PATH", &file)
        .env(SCENE, "1")
        .output()
        .expect("a shell");
    let [said, errors] =
        [output.stdout, output.stderr].map(|text| String::from_utf8(text).expect("text"));
    assert!(output.status.success(), "{errors}");
    let expected = why_silent.map(|why| format!("eightfold: {why}; playing silently\n"));
    assert_eq!(errors, expected.unwrap_or_default());
    let mut lines = said.lines();
    assert_eq!(lines.next(), Some("0"), "allocations while it plays");
    let numbers = |line: &str| {
        let (clock, player) = line.split_once(' ')?;
        Some((clock.parse().ok()?, player.parse().ok()?))
    };
    let times: Vec<_> = lines.map(|line| numbers(line).expect("two times")).collect();
    assert!(times.is_sorted_by_key(|&(_, player)| player), "time goes forward");
    times
}

fn assert_pace(folder: &Path, configuration: &str, command: &str, why_silent: Option<&str>) {
    let times = play_on(folder, configuration, command, why_silent);
    let ((first, start), (last, end)) = (times[0], times[times.len() - 1]);
    let pace = (end - start) as f64 / (last - first) as f64;
    assert!((0.98..1.02).contains(&pace), "{pace}");
}

const PLAIN: &str = "exec \"$0\"";

fn to_file(file: &Path) -> String {
    let file = file.display();
    format!("pcm.default {{ type file, slave.pcm {{ type null }}, file \"{file}\", format raw }}")
}

fn device_plays_samples_in_order(folder: &Path) {
    let out = folder.join("out.raw");
    assert_pace(folder, &to_file(&out), PLAIN, None);
    let bytes = fs::read(out).expect("it was played");
    let sides: Vec<f32> = bytes
        .chunks_exact(4)
        .map(|b| f32::from_le_bytes(b.try_into().expect("four bytes")))
        .collect();
    let (count, second) = (sides.len() / 2, RATE as usize);
    assert!((second * 9 / 10..second * 13 / 10).contains(&count));
    for (number, sides) in (0_u32..).zip(sides.chunks_exact(2)) {
        assert_eq!(sides, [number as f32, -(number as f32)]);
    }
}

/// Without the definition of `plug`, which every system's configuration has.
fn device_of_16_bits_plays_rounded_samples(folder: &Path) {
    let out = folder.join("short.raw");
    let slave =
        format!("type file, slave.pcm {{ type null }}, file \"{}\", format raw", out.display());
    let device = format!("type linear, slave {{ pcm {{ {slave} }}, format S16_LE }}");
    assert_pace(folder, &format!("pcm.default {{ {device} }}"), PLAIN, None);
    let bytes = fs::read(&out).expect("it was played");
    fs::remove_file(out).expect("it goes");
    let sides = bytes.chunks_exact(2);
    let sides: Vec<i16> = sides.map(|b| i16::from_le_bytes([b[0], b[1]])).collect();
    // From the third on, samples are beyond full scale.
    assert_eq!(sides[..4], [0, 0, 32767, -32767]);
    let rest = sides[4..].chunks_exact(2);
    assert!(rest.clone().all(|sides| sides == [32767, -32768]));
    assert!(rest.len() > RATE as usize * 9 / 10);
}

fn device_of_another_format_is_converted(folder: &Path) {
    let system = "</usr/share/alsa/alsa.conf>\npcm.nothing { type null }\n";
    let integers = ["S16_LE", "S24_3LE", "S32_LE", "U8"]
        .map(|format| format!("type linear, slave {{ pcm nothing, format {format} }}"));
    let others = [(44_100, 2), (96_000, 2), (48_000, 1), (44_100, 1), (48_000, 8)];
    let others = others.map(|(rate, channels)| {
        let pairs: String = (0..channels).map(|number| format!("{number} {number} ")).collect();
        let slave = format!("pcm nothing, rate {rate}, channels {channels}");
        format!("type share, slave {{ {slave} }}, bindings {{ {pairs} }}")
    });
    for device in integers.iter().chain(&others) {
        let configuration = format!("{system}pcm.!default {{ {device} }}");
        play_on(folder, &configuration, PLAIN, None);
    }
}

fn null_device_keeps_time(folder: &Path) {
    assert_pace(folder, "pcm.default { type null }", PLAIN, None);
}

fn time_continues_without_sound(folder: &Path) {
    assert_pace(folder, "", PLAIN, Some("sound device is missing"));
    // It opens, and then ALSA reports "Rate doesn't match (requested 48000Hz, get 44100Hz)".
    let other_rate = "pcm.nothing { type null }
        pcm.default { type share, slave { pcm nothing, rate 44100, channels 2 }, bindings { 0 0, 1 1 } }";
    let why = "sound device lacks 48 kHz stereo";
    assert_pace(folder, other_rate, PLAIN, Some(why));
    let integers = "pcm.nothing { type null }
        pcm.default { type share, slave { pcm nothing, format S32_LE, channels 2 }, bindings { 0 0, 1 1 } }";
    let why = "sound device lacks floats and 16-bit integers";
    assert_pace(folder, integers, PLAIN, Some(why));
    // The file limit is half a second of sound; the signal for it is ignored.
    let short = folder.join("short.raw");
    let command = "trap '' XFSZ; ulimit -f 375; exec \"$0\"";
    assert_pace(folder, &to_file(&short), command, Some("sound device is lost"));
    let played = fs::metadata(short).expect("it was played").len();
    assert!(played > 100_000, "{played} bytes before it disappeared");
    fs::write(folder.join("libasound.so.2"), "not a library").expect("it is written");
    let command = format!("LD_LIBRARY_PATH='{}' exec \"$0\"", folder.display());
    let why = format!("{}/libasound.so.2: file too short", folder.display());
    assert_pace(folder, "", &command, Some(&why));
}

/// A named pipe opens when somebody reads it.
fn time_starts_with_the_device(folder: &Path) {
    let pipe = folder.join("pipe");
    let name = pipe.display();
    let command = format!("mkfifo '{name}'; (sleep 1; exec cat '{name}') >/dev/null & {PLAIN}");
    let times = play_on(folder, &to_file(&pipe), &command, None);
    assert!(times[0].0 >= SECOND * 9 / 10 && times[0].1 < times[0].0 / 2, "{:?}", times[0]);
    let times = play_on(folder, &to_file(&pipe), PLAIN, Some("sound device does not answer"));
    assert!(times[0].0 >= 3 * SECOND && times[0].1 < SECOND, "{:?}", times[0]);
}

fn main() {
    if let Ok(seconds) = env::var(SCENE) {
        return play(seconds.parse().expect("a number"));
    }
    let folder = env::temp_dir().join(format!("eightfold-sound-{}", std::process::id()));
    fs::create_dir(&folder).expect("a folder");
    if !lacks(&["libasound.so.2"]) {
        for test in [
            device_plays_samples_in_order,
            device_of_16_bits_plays_rounded_samples,
            device_of_another_format_is_converted,
            null_device_keeps_time,
            time_continues_without_sound,
            time_starts_with_the_device,
        ] {
            test(&folder);
        }
    }
    fs::remove_dir_all(&folder).expect("it goes");
}
