//! The picture's time is the time of what is heard, on devices that are simulated: fast ones, slow ones, and one that runs
//! out of samples.

mod simulated;

use eightfold_window::{
    clock::{Clock, SECOND},
    sound::{Player, RATE, Source},
};
use simulated::Played;
use std::{env, fs, path::Path, process::Command};

/// Samples that are made at once.
const BLOCK: usize = 48;

/// Seconds that are played: as long as the show.
const LENGTH: u64 = 96;

/// The most that the picture may be from the sound, in nanoseconds.
const DRIFT: u64 = SECOND / 50;

/// Nothing that happens.
const NOTHING: (&str, u64) = ("SIMULATED_STOP", 0);

/// A device that does not open within 1,000 s.
const NEVER_OPEN: (&str, u64) = ("SIMULATED_SLOW", 1000 * SECOND);

/// How long a writer sleeps that is late, in nanoseconds.
const LATE: u64 = 3 * SECOND / 10;

/// How long a program that is stopped stays so, in nanoseconds.
const STOP: u64 = 3 * SECOND / 2;

/// Sound that says which sample it is.
struct Numbers {
    next: u32,
    block: [[f32; 2]; BLOCK],
}

impl Source for Numbers {
    fn block(&mut self) -> &[[f32; 2]] {
        for place in &mut self.block {
            // Exact: there are fewer than 2^24.
            *place = [self.next as f32; 2];
            self.next += 1;
        }
        &self.block
    }
}

/// Plays. Says at every frame the clock's time and the player's.
fn play() {
    let numbers = Box::leak(Box::new(Numbers {
        next: 0,
        block: [[0.0; 2]; BLOCK],
    }));
    let clock = Clock::start();
    let mut player = Player::start(c"default", numbers);
    for frame in 0..LENGTH * 60 {
        clock.sleep_until(frame * SECOND / 60);
        println!("{} {}", clock.time(), player.time());
    }
}

/// The times of the clock and of the player, and what was heard, on a device that is fast by so many parts per million, with
/// one more variable that says what happens to it, and the nanosecond or the length of that.
fn scene(library: &Path, fast: i64, (event, time): (&str, u64)) -> (Vec<(u64, u64)>, Played) {
    let mut program = Command::new(env::current_exe().expect("this program"));
    program
        .env("EIGHTFOLD_SOUND_SCENE", "1")
        .env("SIMULATED_FAST", fast.to_string())
        .env(event, time.to_string());
    let (output, played) = simulated::run(library, &mut program);
    let errors = String::from_utf8_lossy(&output.stderr);
    let expected = if (event, time) == NEVER_OPEN {
        "eightfold: sound device does not open; playing silently\n"
    } else {
        ""
    };
    assert!(output.status.success() && errors == expected, "{errors}");
    let said = String::from_utf8(output.stdout).expect("text");
    let times = said.lines().map(|line| {
        let (clock, player) = line.split_once(' ').expect("two numbers");
        (
            clock.parse().expect("a time"),
            player.parse().expect("a time"),
        )
    });
    (times.collect(), played)
}

/// Nanoseconds of the sound that is heard at a time.
fn heard(played: &Played, time: u64) -> u64 {
    let next = played.partition_point(|&(start, _)| start <= time);
    let (start, block) = &played[next - 1];
    let first = block[0][0] as u64 * SECOND / u64::from(RATE);
    first + (time - start).min(BLOCK as u64 * SECOND / u64::from(RATE))
}

fn the_picture_is_at_most_20_ms_from_the_sound(library: &Path) {
    for fast in [-500, -20, 0, 20, 500] {
        let (times, played) = scene(library, fast, NOTHING);
        assert_eq!(times.len() as u64, LENGTH * 60);
        let mut worst = 0;
        for pair in times.windows(2) {
            assert!(pair[0].1 < pair[1].1, "{pair:?}: time goes forward");
        }
        for (clock, player) in times {
            worst = worst.max(player.abs_diff(heard(&played, clock)));
        }
        println!("{fast} ppm: at most {} us", worst / 1000);
        assert!(worst <= DRIFT, "{fast} ppm: {worst} ns");
        for (block, (_, samples)) in played.iter().enumerate() {
            assert_eq!(samples[0][0] as usize, block * BLOCK, "nothing is left out");
        }
    }
}

fn a_device_that_has_run_out_goes_on(library: &Path) {
    let late = 30 * SECOND;
    let (times, played) = scene(library, 20, ("SIMULATED_LATE", late));
    let gap = |pair: &[(u64, Vec<[f32; 2]>)]| pair[1].0 - pair[0].0;
    let holes: Vec<_> = played
        .windows(2)
        .filter(|pair| gap(pair) > SECOND / 500)
        .collect();
    assert_eq!(holes.len(), 1, "silent once");
    assert!(holes[0][0].0.abs_diff(late) < SECOND / 10);
    assert!(gap(holes[0]) < LATE, "no longer than it was late");
    // The block that came too late is dropped.
    let missing = holes[0][1].1[0][0] - holes[0][0].1[0][0];
    assert_eq!(missing as usize, 2 * BLOCK, "one block is missing");
    for (clock, player) in times {
        // The picture has gone on meanwhile, and waits for the sound as long again.
        if !(late..late + 2 * LATE).contains(&clock) {
            let drift = player.abs_diff(heard(&played, clock));
            assert!(drift <= DRIFT, "{drift} ns at {clock} ns");
        }
    }
}

fn a_program_that_was_stopped_goes_on_where_it_was(library: &Path) {
    let stop = 30 * SECOND;
    let (times, played) = scene(library, 20, ("SIMULATED_STOP", stop));
    let stopped = times
        .windows(2)
        .find(|pair| pair[1].0 - pair[0].0 >= STOP)
        .expect("it was stopped");
    assert!(stopped[0].0.abs_diff(stop) < SECOND / 20);
    for (clock, player) in times {
        let drift = player.abs_diff(heard(&played, clock));
        assert!(drift <= DRIFT, "{drift} ns at {clock} ns");
    }
}

fn time_begins_when_the_device_is_open(library: &Path) {
    let (times, played) = scene(library, 20, ("SIMULATED_SLOW", 2 * SECOND));
    assert!(times[0].0 >= 2 * SECOND && times[0].1 <= DRIFT);
    for (clock, player) in times {
        let drift = player.abs_diff(heard(&played, clock));
        assert!(drift <= DRIFT, "{drift} ns at {clock} ns");
    }
}

fn a_device_that_does_not_open_is_given_up(library: &Path) {
    let (times, played) = scene(library, 20, NEVER_OPEN);
    assert!(played.is_empty());
    let (start, _) = times[0];
    assert!((3 * SECOND..4 * SECOND).contains(&start), "{start} ns");
    for (clock, player) in times {
        assert_eq!(player, clock - start);
    }
}

fn main() {
    if env::var_os("EIGHTFOLD_SOUND_SCENE").is_some() {
        return play();
    }
    let folder = env::temp_dir().join(format!("eightfold-heard-{}", std::process::id()));
    fs::create_dir(&folder).expect("a folder");
    let library = simulated::build(&folder);
    for test in [
        the_picture_is_at_most_20_ms_from_the_sound,
        a_device_that_has_run_out_goes_on,
        a_program_that_was_stopped_goes_on_where_it_was,
        time_begins_when_the_device_is_open,
        a_device_that_does_not_open_is_given_up,
    ] {
        test(&library);
    }
    fs::remove_dir_all(&folder).expect("it goes");
}
