//! Without a display and without a terminal the intro plays, says so, and ends with the right exit code.

use eightfold::sound::Synthesizer;
use eightfold_stage::{DISPLAY, Process, Server, headless, intro, needs, qualities, run, texts};
use std::{
    fs,
    path::Path,
    process::Command,
    thread::sleep,
    time::{Duration, Instant},
};

/// What is said where there is neither a display nor a terminal.
const NO_SCREEN: &str = "eightfold: no X display; playing without a screen\n";

#[test]
fn without_display_and_terminal_it_plays_without_a_screen() {
    let start = Instant::now();
    let (output, _) = run(&mut headless("--seconds 0.5 --size 320x200 --threads 3"));
    let (said, errors) = texts(&output);
    assert_eq!(output.status.code(), Some(0), "{errors}");
    assert!(start.elapsed() >= Duration::from_millis(500));
    assert_eq!(errors, NO_SCREEN);
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(said.contains("320x200, threads 3"), "{said}");
}

#[test]
fn the_soundtrack_is_played() {
    needs!(&["libasound.so.2"]);
    let folder = tempfile::tempdir().unwrap();
    let (configuration, out) = (
        folder.path().join("asound.conf"),
        folder.path().join("out.raw"),
    );
    let device = format!(
        "pcm.default {{ type file, slave.pcm {{ type null }}, file \"{}\", format raw }}",
        out.display()
    );
    fs::write(&configuration, device).unwrap();
    let mut command = Command::new(intro());
    let command = command.args(["--seconds", "2", "--size", "64x48"]);
    let (output, _) = run(command
        .env_remove("DISPLAY")
        .env("ALSA_CONFIG_PATH", &configuration));
    assert_eq!(texts(&output).1, NO_SCREEN);
    let heard = fs::read(out).unwrap();
    let mut samples = vec![[0.0; 2]; heard.len() / 8];
    assert!(
        (85_000..120_000).contains(&samples.len()),
        "{} samples",
        samples.len()
    );
    Box::<Synthesizer>::default().play(&mut samples);
    let bytes: Vec<u8> = samples
        .as_flattened()
        .iter()
        .flat_map(|channel| channel.to_le_bytes())
        .collect();
    assert!(
        heard[..bytes.len()] == bytes,
        "the song's samples, to the bit"
    );
}

#[test]
fn without_a_sound_device_it_says_so_in_one_line() {
    let mut command = Command::new(intro());
    let command = command.args(["--seconds", "0.2", "--size", "64x48"]);
    let (output, _) = run(command
        .env_remove("DISPLAY")
        .env("ALSA_CONFIG_PATH", "/dev/null"));
    assert_eq!(output.status.code(), Some(0));
    let (_, errors) = texts(&output);
    assert_eq!(errors.lines().count(), 2, "{errors}");
    let silent = "eightfold: no sound device; playing silently\n";
    assert!(errors.ends_with(silent), "{errors}");
}

#[test]
fn a_display_that_cannot_be_opened_counts_as_none() {
    for display in ["", ":54321", "nonsense", "localhost:54321"] {
        let (output, _) = run(headless("--seconds 0.1").env("DISPLAY", display));
        let (_, errors) = texts(&output);
        assert_eq!(output.status.code(), Some(0), "{display}: {errors}");
        assert!(
            errors.contains("no X display; playing without a screen"),
            "{display}: {errors}"
        );
    }
}

#[test]
fn a_library_that_can_not_be_loaded_is_told_as_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("libX11.so.6");
    fs::write(&library, "not a library").unwrap();
    let mut intro = headless("--seconds 0.1 --size 64x48");
    let (output, _) = run(intro.env("LD_LIBRARY_PATH", folder.path()));
    let why = format!("{}: file too short", library.display());
    assert_eq!(
        texts(&output).1,
        format!("eightfold: {why}; playing without a screen\n")
    );
}

/// Runs a script in which `INTRO` stands for the intro. Returns its exit code and its standard error.
fn shell(script: &str) -> (Option<i32>, String) {
    let script = script.replace("INTRO", &intro().display().to_string());
    let mut bash = Command::new("bash");
    let (output, _) = run(bash.env_remove("DISPLAY").args(["-c", &script]));
    (output.status.code(), texts(&output).1)
}

#[test]
fn a_standard_output_that_takes_nothing_is_an_error() {
    for options in ["--seconds 0.1", "--help", "--version"] {
        for output in [">&-", "> /dev/full"] {
            let (code, errors) = shell(&format!("INTRO {options} {output}"));
            assert_eq!(code, Some(1), "{options} {output}: {errors}");
            let told = errors.matches("can't write").count();
            assert_eq!(told, 1, "{options} {output}: {errors}");
        }
        // A pipe without a reader.
        let (code, errors) = shell(&format!("INTRO {options} | true; exit ${{PIPESTATUS[0]}}"));
        let written_before = options != "--seconds 0.1" && code == Some(0);
        assert!(
            code == Some(1) || written_before,
            "{options}: {code:?} {errors}"
        );
    }
}

#[test]
fn what_opens_the_display_takes_no_number_of_a_closed_stream() {
    needs!(DISPLAY);
    let server = Server::start(320, 240);
    let (code, _) = shell(&format!(
        "DISPLAY={} INTRO --seconds 0.2 <&- >&- 2>&-",
        server.display
    ));
    assert_eq!(code, Some(1), "the report cannot be written");
}

#[test]
fn it_reserves_little_address_space() {
    let folder = tempfile::tempdir().unwrap();
    let configuration = folder.path().join("asound.conf");
    fs::write(&configuration, "pcm.default { type null }").unwrap();
    // In units of 1,024 bytes. Memory for the largest frames and the most threads is the larger part. A device that plays nothing
    // is opened on a thread of its own, by libraries of its own.
    for (limit, sound) in [(118_000, "--silent"), (140_000, "")] {
        let (code, errors) = shell(&format!(
            "ulimit -v {limit}; ALSA_CONFIG_PATH={} INTRO {sound} --seconds 0.2 --threads 2 > /dev/null",
            configuration.display()
        ));
        assert_eq!(errors, NO_SCREEN);
        assert_eq!(code, Some(0));
    }
}

#[test]
fn the_report_says_how_long_each_rung_was_used() {
    let names = qualities();
    // The rungs in the report, and the time for which each was used.
    let used = |options: &str| {
        let (_, said) = run(&mut headless(options));
        let names = names.split(' ');
        let rungs = names.filter_map(|name| {
            let (_, rest) = said.split_once(&format!(", {name} "))?;
            let (time, _) = rest.split_once(" s").expect("a unit");
            Some((name, time.parse::<f64>().expect("a time")))
        });
        rungs.collect::<Vec<_>>()
    };
    let small = used("--seconds 1 --size 16x12 --fps 30");
    assert_eq!(small[0].0, "finest", "it begins with the best");
    for (options, expected) in [
        ("--quality faster", "faster"),
        ("--uncapped", "default"),
        ("--uncapped --quality fine", "fine"),
        ("--uncapped --quality thesis", "thesis"),
        ("--exhaustive", "exhaustive"),
    ] {
        let rungs = used(&format!("--seconds 0.5 --size 64x48 {options}"));
        let [(name, time)] = rungs[..] else {
            panic!("{options}: {rungs:?}");
        };
        assert_eq!(name, expected, "{options}");
        assert!((0.3..=0.7).contains(&time), "{options}: {time}");
    }
    // No machine reaches this frame rate, so the governor has to step down to the fastest rung.
    let hurried = used("--seconds 3 --size 1920x1080 --threads 1 --fps 1000");
    let sum: f64 = hurried.iter().map(|(_, time)| time).sum();
    let (last, time) = hurried[hurried.len() - 1];
    assert_eq!(last, "fastest");
    assert!(time > 0.5 * sum, "{hurried:?}");
}

#[test]
fn it_uses_no_time_while_it_waits_for_the_next_frame() {
    let intro = Process::start(&mut headless("--seconds 5 --size 16x16"));
    let stat = Path::new("/proc").join(intro.0.id().to_string());
    // User time and system time, in hundredths of a second.
    let used = || -> u32 {
        let stat = fs::read_to_string(stat.join("stat")).expect("it runs");
        let (_, fields) = stat.rsplit_once(") ").expect("a name and fields");
        let fields: Vec<&str> = fields.split(' ').collect();
        let numbers = fields[11..13].iter().map(|field| field.parse::<u32>());
        numbers.map(|number| number.expect("a number")).sum()
    };
    // By then it has unpacked itself.
    sleep(Duration::from_secs(2));
    let before = used();
    sleep(Duration::from_secs(2));
    let ticks = used() - before;
    assert!(ticks < 60, "{ticks} hundredths of a second of 200");
}

#[test]
fn a_small_stack_is_enough_or_told_in_one_line() {
    for (kilobytes, expected) in [(110, 0), (96, 0), (95, 1), (64, 1)] {
        for options in ["--still 62.5", "--seconds 0.2"] {
            let limited =
                format!("ulimit -s {kilobytes}; exec INTRO --silent {options} --size 64x48");
            let (code, errors) = shell(&format!("{limited} > /dev/null"));
            assert_eq!(code, Some(expected), "{limited}: {errors}");
            let is_told = errors.contains("of stack");
            assert_eq!(is_told, expected != 0, "{limited}: {errors}");
        }
    }
}
