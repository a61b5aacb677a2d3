use eightfold::show;
use eightfold_stage::{intro, needs, run, still, tool};

#[test]
fn frame_has_the_size_of_the_options() {
    let last = format!("--still {}.999999999 --size 8x6", show::LENGTH - 1.0);
    for (options, size) in [
        ("--still 2", (1024, 768)),
        ("--still 0 --size 1x1", (1, 1)),
        ("--size=333x77 --still=90", (333, 77)),
        ("--still .5 --size 3840x2160", (3840, 2160)),
        (&last, (8, 6)),
    ] {
        let (width, pixels) = still(options);
        assert_eq!((width, pixels.len() / width), size, "{options}");
        assert!(width < 9 || pixels.iter().any(|&pixel| pixel > 0));
    }
}

#[test]
fn still_without_quality_is_default() {
    let exhaustive = still("--still 33.7 --size 320x200 --quality exhaustive");
    assert!(exhaustive == still("--still 33.7 --size 320x200 --exhaustive"));
    let default = still("--still 33.7 --size 320x200 --quality default");
    assert!(default == still("--still 33.7 --size 320x200"));
}

#[test]
fn terminal_is_refused() {
    needs!(&["script"]);
    let command = format!("{} --still 2; echo code $?", intro().display());
    let (_, said) = run(tool("script").args(["-q", "-c", &command, "/dev/null"]));
    let told = "eightfold: standard output is a terminal; must be ";
    assert!(said.starts_with(told), "{said}");
    assert_eq!(said.lines().nth(1).map(str::trim_end), Some("code 2"));
}
