use eightfold::show;
use eightfold_stage::{ended, headless, qualities, run, succeed};
use eightfold_window::cpu;

#[test]
#[ignore = "the intro is started many times"]
fn bad_argument_is_named_in_one_line() {
    let qualities = qualities();
    let length = show::LENGTH.to_string();
    for row in include_str!("bad_arguments.txt").lines() {
        let row = row.replace("LENGTH", &length).replace("QUALITIES", &qualities);
        let row = row.replace("\\e", "\x1b");
        let (arguments, named) = row.split_once(" | ").expect("two columns");
        let words = arguments.split(' ').map(|word| word.trim_matches('"'));
        let (code, said, errors) = ended(headless("").args(words));
        assert_eq!((code, &*said), (Some(2), ""), "{arguments}: {errors}");
        assert_eq!(errors.lines().count(), 1, "{arguments}: {errors}");
        assert!(errors.starts_with("eightfold: "), "{arguments}: {errors}");
        assert!(errors.contains(named), "{arguments}: {errors}");
    }
}

#[test]
fn help_and_version_are_printed() {
    let help = succeed(&mut headless("--help"));
    let flags = "--size --fullscreen --threads --isa --seconds --loop --fps --psnr --quality --exhaustive --uncapped \
                 --silent --hud --still --help --version";
    let length = format!("({}; endless with --loop)", show::LENGTH);
    let last = format!(" 0 to below {}\n", show::LENGTH);
    for text in flags.split(' ').chain([&qualities()[..], &length, &last]) {
        assert!(help.contains(text), "{text}: {help}");
    }
    assert_eq!(run(&mut headless("-h")).1, help);
    let expected = concat!("eightfold ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(succeed(&mut headless("--version")), expected);
}

#[test]
fn options_have_their_effects() {
    let said = |options: &str| run(&mut headless(options)).1;
    assert!(said("--seconds 0.3 --threads 1 --size 64x48").contains("threads 1"));
    assert!(said("--seconds=.3 --size=2x3").contains(", 2x3,"));
    assert!(said("--seconds 0.1 --seconds 0.3 --size 2x3").contains("in 0.3"));
    assert!(said("--fps 1 --seconds 0.2 --size 16x12").contains("in 0.2"));
    let frames = |options: &str| {
        let said = said(options);
        let (frames, _) = said.split_once(' ').expect("a number and more");
        frames.parse::<u32>().expect("a number")
    };
    assert!(frames("--seconds 1 --size 64x48") <= 61);
    assert!(frames("--seconds 0.5 --size 64x48 --threads 1 --uncapped") > 60);
    assert!(frames("--seconds 1 --size 64x48 --fps 24") <= 25);
}

#[test]
fn instruction_set_of_another_cpu_is_refused() {
    let here: Vec<&str> = cpu::shipped().map(|isa| isa.name).collect();
    let (_, help) = run(&mut headless("--help"));
    let list = format!("instruction set (best by default): {}\n", here.join(" "));
    assert!(help.contains(&list), "{help}");
    for name in ["avx2", "sse2", "neon", "portable"] {
        let options = format!("--isa {name} --seconds 0.2 --size 64x48");
        let (code, said, errors) = ended(&mut headless(&options));
        if here.contains(&name) {
            assert!(said.contains(&format!(", {name}, ")), "{said}");
        } else {
            let line = format!("eightfold: --isa is '{name}'; must be NAME: {list}");
            assert_eq!((code, errors), (Some(2), line));
        }
    }
}
