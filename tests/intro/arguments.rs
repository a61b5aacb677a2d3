use eightfold::show;
use eightfold_stage::{headless, qualities, run, texts};
use eightfold_window::cpu;

#[test]
#[ignore = "the intro is started many times"]
fn bad_argument_is_named_in_one_line() {
    let qualities = qualities();
    let length = show::LENGTH.to_string();
    let bad: &[(&[&str], &str)] = &[
        (&["--bogus"], "--bogus"),
        (&[""], "--help"),
        (&["--sizes", "10x10"], "--sizes"),
        (&["--loop=1"], "--loop"),
        (&["--loop\x1b[31m"], "--loop?[31m"),
        (&["--size"], "--size WxH"),
        (&["--size", "0x10"], "--size WxH"),
        (&["--size", "3841x10"], "--size WxH"),
        (&["--size", "+10x10"], "--size WxH"),
        (&["--size=10x"], "--size WxH"),
        (&["--size", "99999999999999999999999x1"], "--size WxH"),
        (&["--threads", "65"], "--threads N"),
        (&["--seconds", "0.0"], "--seconds S"),
        (&["--seconds", "."], "--seconds S"),
        (&["--seconds", "1.2.3"], "--seconds S"),
        (&["--seconds", "0.0000000001"], "--seconds S"),
        // 2^64 ns, and 2^64 s.
        (&["--seconds", "18446744073.709551616"], "--seconds S"),
        (&["--seconds", "18446744073709551616"], "--seconds S"),
        (&["--fps", "1001"], "--fps N"),
        (&["--fps", "59.9"], "--fps N"),
        (&["--psnr", "100"], "--psnr DB"),
        (&["--quality", "best"], "--quality NAME"),
        (&["--quality"], &qualities),
        (&["--exhaustive", "--quality=fast"], "more than one quality"),
        (&["--isa", "neon"], "avx2 sse2"),
        (&["--still", &length], "--still S"),
        (&["--loop", "--seconds", "1", "--size", "1x"], "--size WxH"),
    ];
    for (arguments, named) in bad {
        let (output, _) = run(headless("").args(*arguments));
        let (said, errors) = texts(&output);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}: {errors}");
        assert_eq!(said, "", "{arguments:?}");
        assert_eq!(errors.lines().count(), 1, "{arguments:?}: {errors}");
        assert!(errors.starts_with("eightfold: "), "{arguments:?}: {errors}");
        assert!(errors.contains(named), "{arguments:?}: {errors}");
    }
}

#[test]
fn help_and_version_are_printed() {
    let (output, help) = run(&mut headless("--help"));
    assert_eq!(output.status.code(), Some(0));
    let flags = "--size --fullscreen --threads --isa --seconds --loop --fps --psnr --quality --exhaustive --uncapped \
                 --silent --hud --still --help --version";
    let length = format!("({}, the show)", show::LENGTH);
    let last = format!("from 0 to below {},", show::LENGTH);
    for text in flags.split(' ').chain([&qualities()[..], &length, &last]) {
        assert!(help.contains(text), "{text}: {help}");
    }
    assert_eq!(run(&mut headless("-h")).1, help);
    let (output, version) = run(&mut headless("--version"));
    assert_eq!(output.status.code(), Some(0));
    let expected = concat!("eightfold ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(version, expected);
}

#[test]
fn option_has_its_effect() {
    let said = |options: &str| run(&mut headless(options)).1;
    assert!(said("--seconds 0.3 --threads 1").contains("threads 1"));
    assert!(said("--seconds=.3 --size=2x3").contains(", 2x3,"));
    assert!(said("--seconds 0.1 --seconds 0.3 --size 2x3").contains("in 0.3"));
    assert!(said("--fps 1 --seconds 0.2 --size 16x12").contains("in 0.2"));
    let frames = |options: &str| {
        let said = said(options);
        let (frames, _) = said.split_once(' ').expect("a number and more");
        frames.parse::<u32>().expect("a number")
    };
    assert!(frames("--seconds 1 --size 64x48") <= 61);
    assert!(frames("--seconds 1 --size 64x48 --uncapped") > 120);
    assert!(frames("--seconds 1 --size 64x48 --fps 24") <= 25);
}

#[test]
fn instruction_set_of_another_cpu_is_refused() {
    let here: Vec<&str> = cpu::shipped().map(|isa| isa.name).collect();
    let (_, help) = run(&mut headless("--help"));
    let line = format!("instruction sets of this CPU: {}\n", here.join(" "));
    assert!(help.contains(&line), "{help}");
    for &name in cpu::NAMES {
        let options = format!("--isa {name} --seconds 0.2 --size 64x48");
        let (output, said) = run(&mut headless(&options));
        let (_, errors) = texts(&output);
        if here.contains(&name) {
            assert!(said.contains(&format!(", {name}, ")), "{said}");
        } else {
            assert_eq!(output.status.code(), Some(2));
            assert_eq!(errors, format!("eightfold: this CPU has no {name}\n"));
        }
    }
}
