use eightfold::sound::Synthesizer;
use eightfold_stage::{
    DISPLAY, Process, Server, ended, headless, intro, linked_intro, needs, qualities, run, tool,
    wait_for,
};
use std::{fs, net::TcpListener, path::Path, process::Command, thread::sleep, time::Duration};

const NO_SCREEN: &str = "eightfold: X display is missing; playing without a screen\n";

#[test]
fn soundtrack_is_played() {
    needs!(&["libasound.so.2"]);
    let folder = tempfile::tempdir().unwrap();
    let [configuration, out] = ["asound.conf", "out.raw"].map(|name| folder.path().join(name));
    let out_name = out.display();
    let slave = format!("type file, slave.pcm {{ type null }}, file \"{out_name}\", format raw");
    fs::write(&configuration, format!("pcm.default {{ {slave} }}")).unwrap();
    let mut command = Command::new(intro());
    command.args(["--seconds", "2", "--size", "64x48"]);
    command.env_remove("DISPLAY");
    let (_, _, errors) = ended(command.env("ALSA_CONFIG_PATH", &configuration));
    assert_eq!(errors, NO_SCREEN);
    let heard = fs::read(out).unwrap();
    let mut samples = vec![[0.0; 2]; heard.len() / 8];
    assert!((85_000..130_000).contains(&samples.len()));
    Box::<Synthesizer>::default().play(&mut samples);
    let samples = samples.as_flattened().iter();
    let bytes: Vec<u8> = samples.flat_map(|channel| channel.to_le_bytes()).collect();
    assert!(heard[..bytes.len()] == bytes, "other bits");
}

#[test]
fn processor_without_avx2_gets_one_line() {
    needs!(&["qemu-x86_64-static"]);
    for (options, code, line) in [
        ("--still 5 --size 64x48", 1, "eightfold: this processor lacks AVX2; "),
        ("--silent", 1, "; build with: cargo build --release -p eightfold --features sse2\n"),
        ("--isa avx2", 2, "eightfold: --isa is 'avx2'; must be NAME: "),
        ("--version", 0, ""),
    ] {
        let mut command = tool("qemu-x86_64-static");
        // The packed program unpacks itself for seconds in qemu.
        let program = if code == 0 { intro() } else { linked_intro() };
        command.args(["-cpu", "Nehalem"]).arg(program);
        command.args(options.split(' ')).env_remove("DISPLAY");
        let (status, _, errors) = ended(&mut command);
        assert_eq!(status, Some(code), "{options}: {errors}");
        assert!(errors.contains(line), "{options}: {errors}");
        assert_eq!(errors.lines().count(), usize::from(code > 0), "{errors}");
    }
}

/// The PulseAudio plugin accepts more samples at once than hardware.
#[test]
#[ignore = "a sound server is started"]
fn pulseaudio_plays_at_normal_speed() {
    needs!(&["pulseaudio", "alsa-lib/libasound_module_pcm_pulse.so"]);
    let folder = tempfile::tempdir().unwrap();
    let [configuration, socket] = ["asound.conf", "native"].map(|name| folder.path().join(name));
    fs::write(&configuration, "pcm.default { type pulse }").unwrap();
    let protocol = format!("module-native-protocol-unix socket={}", socket.display());
    let mut server = tool("pulseaudio");
    server.args(["-n", "--daemonize=no", "--exit-idle-time=-1"]);
    server.args(["--load=module-null-sink", "--load", &protocol]);
    for name in ["HOME", "PULSE_RUNTIME_PATH"] {
        server.env(name, folder.path());
    }
    let _server = Process::start(&mut server);
    wait_for("the sound server", || socket.exists().then_some(()));
    let mut command = Command::new(intro());
    command.args(["--seconds", "4", "--size", "64x48"]);
    command.env("PULSE_SERVER", format!("unix:{}", socket.display()));
    command.env_remove("DISPLAY");
    let (_, said, errors) = ended(command.env("ALSA_CONFIG_PATH", &configuration));
    assert_eq!(errors, NO_SCREEN);
    // With the plugin's buffer it took at least 5 s. A busy machine is late by less.
    let seconds = said.split(" in ").nth(1).and_then(|rest| rest.split(' ').next());
    let seconds: f32 = seconds.expect("the report").parse().expect("seconds");
    assert!((3.9..4.9).contains(&seconds), "{said}");
}

#[test]
fn unresponsive_display_is_skipped_within_8_s() {
    // A server that never answers. The port of display 0 is 6000.
    let mut displays = 500..600_u16;
    let bound = displays.find_map(|display| {
        let listener = TcpListener::bind(("127.0.0.1", 6000 + display)).ok()?;
        Some((listener, display))
    });
    let (_listener, display) = bound.expect("a port is free");
    let mut intro = headless("--seconds 0.1 --size 64x48");
    let intro = intro.env("DISPLAY", format!("127.0.0.1:{display}"));
    let (time, code, _, errors) = Process::start(intro).end();
    let silent = "eightfold: X display does not answer; playing without a screen\n";
    assert_eq!((code, &*errors), (Some(0), silent));
    assert!(time < Duration::from_secs(8), "{time:?}");
}

#[test]
fn missing_linker_or_descriptors_print_one_line() {
    let told = "eightfold: dynamic linker cannot be loaded\n";
    let folder = tempfile::tempdir().unwrap();
    let copied = Command::new("install").arg(intro()).arg(folder.path()).status();
    assert!(copied.unwrap().success());
    let mut alone = Command::new("chroot");
    let (code, _, errors) = ended(alone.arg(folder.path()).arg("/eightfold"));
    // Only root can use chroot.
    if !errors.starts_with("chroot: cannot change root") {
        assert_eq!((code, &*errors), (Some(1), told));
    }
    let few = shell("ulimit -n 3; exec PACKED --version");
    assert_eq!(few, (Some(1), told.to_owned()));
}

#[test]
fn unavailable_display_is_skipped() {
    for display in ["", ":54321", "nonsense", "localhost:54321"] {
        let mut intro = headless("--seconds 0.1 --size 64x48");
        let (code, _, errors) = ended(intro.env("DISPLAY", display));
        assert_eq!(code, Some(0), "{display}: {errors}");
        assert!(errors.contains(NO_SCREEN), "{display}: {errors}");
    }
}

#[test]
fn library_that_cannot_be_loaded_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let library = folder.path().join("libX11.so.6");
    fs::write(&library, "not a library").unwrap();
    let mut intro = headless("--seconds 0.1 --size 64x48");
    let (_, _, errors) = ended(intro.env("LD_LIBRARY_PATH", folder.path()));
    let why = format!("{}: file too short", library.display());
    let expected = format!("eightfold: {why}; playing without a screen\n");
    assert_eq!(errors, expected);
}

/// `INTRO` in the script is the linked intro, `PACKED` the packed file. Returns the exit code and
/// the standard error.
fn shell(script: &str) -> (Option<i32>, String) {
    let script = script.replace("INTRO", &linked_intro().display().to_string());
    let script = script.replace("PACKED", &intro().display().to_string());
    let mut bash = Command::new("bash");
    let (code, _, errors) = ended(bash.env_remove("DISPLAY").args(["-c", &script]));
    (code, errors)
}

#[test]
fn output_that_cannot_be_written_is_an_error() {
    for options in ["--seconds 0.1 --size 64x48", "--help", "--version", "--still 2 --size 64x48"] {
        for output in [">&-", "> /dev/full"] {
            let (code, errors) = shell(&format!("INTRO --silent {options} {output}"));
            assert_eq!(code, Some(1), "{options} {output}: {errors}");
            let line = "eightfold: standard output: cannot write\n";
            assert!(errors.ends_with(line), "{options} {output}: {errors}");
        }
    }
    for reader in ["true", "head -c 1000 > /dev/null"] {
        let (code, errors) = shell(&format!("INTRO --still 2 | {reader}; exit ${{PIPESTATUS[0]}}"));
        assert_eq!(code, Some(1), "{reader}: {errors}");
    }
}

#[test]
fn closed_streams_do_not_become_the_display() {
    needs!(DISPLAY);
    let server = Server::start(320, 240);
    let streams = "<&- >&- 2>&-";
    let (code, _) = shell(&format!("DISPLAY={} PACKED --seconds 0.2 {streams}", server.display));
    assert_eq!(code, Some(1), "the report cannot be written");
}

#[test]
fn address_space_of_118000_kib_is_enough() {
    let folder = tempfile::tempdir().unwrap();
    let configuration = folder.path().join("asound.conf");
    fs::write(&configuration, "pcm.default { type null }").unwrap();
    let configuration = configuration.display();
    // In KiB, mostly for the largest frames and all threads. A null sound device adds a thread and
    // libraries.
    for (limit, sound) in [(118_000, "--silent"), (140_000, "")] {
        let play = format!("PACKED {sound} --seconds 0.2 --threads 2 > /dev/null");
        let limited = format!("ulimit -v {limit}; ALSA_CONFIG_PATH={configuration} {play}");
        assert_eq!(shell(&limited), (Some(0), NO_SCREEN.to_owned()));
    }
}

#[test]
fn report_has_the_time_of_each_preset() {
    let names = qualities();
    let used = |options: &str| {
        let (_, said) = run(&mut headless(options));
        let presets = names.split(' ').filter_map(|name| {
            let (_, rest) = said.split_once(&format!(", {name} "))?;
            let (time, _) = rest.split_once(" s").expect("a unit");
            Some((name, time.parse::<f64>().expect("a time")))
        });
        presets.collect::<Vec<_>>()
    };
    let small = used("--seconds 1 --size 16x12 --fps 30");
    assert_eq!(small[0].0, "finest", "it begins with the best");
    for (options, expected) in [
        ("--quality faster", "faster"),
        ("--uncapped", "default"),
        ("--uncapped --quality thesis", "thesis"),
        ("--exhaustive", "exhaustive"),
    ] {
        let presets = used(&format!("--seconds 0.2 --size 64x48 {options}"));
        let [(name, time)] = presets[..] else {
            panic!("{options}: {presets:?}");
        };
        assert_eq!(name, expected, "{options}");
        assert!(time > 0.0, "{options}: {time}");
    }
    // No machine reaches this frame rate, so the governor selects the fastest preset.
    let hurried = used("--seconds 2.5 --size 1280x720 --threads 1 --fps 1000");
    let sum: f64 = hurried.iter().map(|(_, time)| time).sum();
    let (last, time) = hurried[hurried.len() - 1];
    assert_eq!(last, "fastest");
    assert!(time > 0.5 * sum, "{hurried:?}");
}

/// Large frames start small, and no machine reaches 1000 frames per second with one thread.
#[test]
fn report_has_the_size_drawn() {
    let play = |options: &str| {
        let options = format!("--seconds 0.1 --threads 1 {options}");
        run(&mut headless(&options)).1
    };
    for (size, drawn) in
        [("3840x2160", "1280x720"), ("3839x1079", "1280x360"), ("1001x2160", "334x720")]
    {
        let said = play(&format!("--fps 1000 --size {size}"));
        let sizes = format!(", at {drawn} of {size}, threads 1, ");
        assert!(said.contains(&sizes) && said.contains(", thirds "), "{said}");
    }
    // A fixed quality and a target accuracy keep the size.
    for options in ["--fps 1000 --quality fastest", "--uncapped", "--psnr 30"] {
        let said = play(&format!("--size 3840x2160 {options}"));
        assert!(said.contains(", 3840x2160, threads 1, "), "{said}");
        assert!(!said.contains("thirds"), "{said}");
    }
}

#[test]
fn waiting_for_a_frame_uses_no_processor() {
    let intro = Process::start(&mut headless("--seconds 5 --size 16x16"));
    let stat = Path::new("/proc").join(intro.0.id().to_string()).join("stat");
    let used = || -> u32 {
        let stat = fs::read_to_string(&stat).expect("it runs");
        let (_, fields) = stat.rsplit_once(") ").expect("a name and fields");
        let times = fields.split(' ').skip(11).take(2);
        times.map(|time| time.parse::<u32>().expect("a number")).sum()
    };
    // The start takes processor time.
    sleep(Duration::from_secs(1));
    let before = used();
    sleep(Duration::from_secs(2));
    let ticks = used() - before;
    assert!(ticks < 60, "{ticks} hundredths of a second of 200");
}

#[test]
fn intro_runs_with_a_stack_of_96_kib() {
    for (kilobytes, expected) in [(96, 0), (95, 1)] {
        for options in ["--still 62.5", "--seconds 0.2"] {
            let play = format!("exec PACKED --silent {options} --size 64x48 > /dev/null");
            let (code, errors) = shell(&format!("ulimit -s {kilobytes}; {play}"));
            assert_eq!(code, Some(expected), "{kilobytes} {options}: {errors}");
            let is_told = errors.contains("stack limit");
            assert_eq!(is_told, expected != 0, "{kilobytes} {options}: {errors}");
        }
    }
}
