//! `lab truth` writes whole files, whose bytes depend on nothing but its arguments, and goes on where it was interrupted.

use crate::{assert_one_line, command, lab, printed, said};
use eightfold_lab::arguments::{Part, Size};
use eightfold_lab::sampler::Sequence;
use eightfold_lab::scenes::SceneName;
use eightfold_lab::truth::effects::Effects;
use eightfold_lab::truth::estimate::Estimate;
use eightfold_lab::truth::film::{Film, Sampling};
use eightfold_lab::truth::render::Picture;
use eightfold_lab::truth::state;
use eightfold_stage::reader::read_png;
use eightfold_tracer::scene::Scene;
use rayon::ThreadPoolBuilder;
use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};

/// The size of the pictures.
const SIZE: Size = Size::new(24, 18);

/// The truth of a scene by so many samples of each replication.
fn picture(scene: &Scene, count: usize) -> Picture<'_> {
    Picture {
        scene,
        size: SIZE,
        effects: Effects::TRUTH,
        sampling: Sampling {
            count,
            sequence: Sequence::Sobol,
            seed: 9,
            is_antialiased: true,
        },
    }
}

/// `lab truth` of a small picture of the model scene.
fn truth(out: &Path, more: &str) -> Output {
    let out = out.display();
    lab(&format!(
        "truth --size 24x18 --samples 16 --out {out} {more}"
    ))
}

#[test]
fn it_writes_a_picture_its_radiance_and_its_intervals() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    let (exr, interval) = (path("truth.exr"), path("interval.png"));
    let more = format!("--exr {} --interval {}", exr.display(), interval.display());
    let output = truth(&path("truth.png"), &more);
    let said = said(&output);
    assert!(output.status.success(), "{said}");
    assert!(
        said.contains("16 samples a pixel: 95 % intervals of +-"),
        "{said}"
    );
    let (width, pixels) = read_png(&fs::read(path("truth.png")).expect("a file"));
    assert_eq!((width, pixels.len()), (24, 24 * 18));
    let (_, intervals) = read_png(&fs::read(&interval).expect("a file"));
    assert!(intervals.iter().any(|&pixel| pixel != intervals[0]));
    // The file of floats has the same picture.
    let image = exr::prelude::read_first_flat_layer_from_file(&exr).expect("OpenEXR");
    let channels = image.layer_data.channel_data.list;
    let names: Vec<String> = channels.iter().map(|it| it.name.to_string()).collect();
    assert_eq!(
        names,
        ["B", "G", "R", "interval.B", "interval.G", "interval.R"]
    );
    for (shift, channel) in [0, 8, 16].into_iter().zip(&channels) {
        let numbers = channel.sample_data.values_as_f32();
        let bytes = numbers.map(|number| (number.clamp(0.0, 1.0) * 255.0).round() as u32);
        assert!(bytes.eq(pixels.iter().map(|pixel| pixel >> shift & 255)));
    }
    assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 3);
}

#[test]
fn the_bytes_depend_on_seed_and_samples_and_not_on_threads() {
    let picture = |more: &str| {
        // Photons take most of the time, and have no part in this.
        let output = truth(Path::new("-"), &format!("{more} --without caustics"));
        assert!(output.status.success());
        output.stdout
    };
    let plain = picture("--threads 1");
    assert_eq!(plain, picture("--threads 3"));
    assert_ne!(plain, picture("--seed 1"));
    assert_ne!(plain, picture("--time 1"));
    for effect in ["indirect", "soft-shadows", "surfaces"] {
        assert_ne!(plain, picture(&format!("--without {effect}")));
    }
    assert_ne!(plain, picture("--with falloff"));
}

#[test]
fn a_film_that_was_saved_goes_on_to_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let name = folder.path().join("film");
    let scene = SceneName::Model.without_overlay(1.0);
    let subject = picture(&scene, 4).subject();
    let expose = |film: &mut Film, count| film.expose(&subject, count, &|| {});
    let mut whole = Film::new(SIZE, Part::WHOLE);
    (1..=4).for_each(|count| expose(&mut whole, count));
    let mut part = Film::new(SIZE, Part::WHOLE);
    expose(&mut part, 1);
    // It was interrupted when some rows had a second sample.
    let mut ahead = part.clone();
    expose(&mut ahead, 2);
    part.rows[3..9].clone_from_slice(&ahead.rows[3..9]);
    state::save(&name, "it", &part).expect("it is saved");
    let empty = Film::new(SIZE, Part::WHOLE);
    let load = |made, count| state::load(&name, made, &empty, count).expect("it is whole");
    let mut loaded = load("it", 4).expect("it is there");
    assert!(loaded == part);
    (2..=4).for_each(|count| expose(&mut loaded, count));
    assert!(loaded == whole);
    // What is of another picture or has too many samples is not taken.
    assert!(load("another", 4).is_none() && load("it", 1).is_none());
}

#[test]
fn a_damaged_film_is_refused_in_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("truth.png");
    let name = state::beside(&out, None);
    state::save(&name, "it", &Film::new(SIZE, Part::WHOLE)).expect("it is saved");
    let whole = fs::read(&name).expect("a file");
    // Foreign bytes in its middle or its first line, and a lost end.
    let changed = |from: usize, to: usize| {
        let mut bytes = whole.clone();
        (from..to).for_each(|i| bytes[i] ^= (i % 255) as u8 + 1);
        bytes
    };
    let middle = whole.len() / 2;
    let last = whole.len() - 1;
    for damaged in [
        changed(middle, middle + 800),
        changed(middle, middle + 1),
        changed(9, 10),
        whole[..last].to_vec(),
        Vec::new(),
    ] {
        fs::write(&name, &damaged).expect("it is written");
        assert_one_line(
            &truth(&out, ""),
            1,
            &["truth.png.unfinished is damaged", "delete it"],
        );
        // It is left as it is, for whoever can mend it.
        assert!(fs::read(&name).expect("a file") == damaged && !out.exists());
    }
}

#[test]
fn a_film_of_another_scene_does_not_go_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("truth.png");
    let pool = ThreadPoolBuilder::new().build().expect("threads");
    let calm = SceneName::Model.without_overlay(1.0);
    let mut rough = calm;
    (rough.water.slope, rough.water.length) = (0.1, 1.0);
    let [calm, rough] = [&calm, &rough].map(|scene| {
        let picture = picture(scene, 1);
        let kept = picture.draw_resumably(&pool, &out, None, true);
        let kept = kept.expect("it is drawn").estimates();
        assert!(pixels(&kept) == pixels(&picture.draw(&pool)));
        pixels(&kept)
    });
    assert!(calm != rough);
}

/// The pixels of estimates.
fn pixels(estimates: &[Estimate]) -> Vec<u32> {
    estimates.iter().map(Estimate::pixel).collect()
}

#[cfg(unix)]
#[test]
fn after_ctrl_c_the_same_command_goes_on() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("truth.png");
    // Without photons, most of the time goes to what is drawn row by row.
    let line = "truth --size 64x48 --samples 128 --without caustics --out";
    let kept = state::beside(&out, None);
    let mut runs = 0;
    loop {
        let run = command(line)
            .arg(&out)
            .stderr(Stdio::piped())
            .spawn()
            .expect("the lab starts");
        // Interrupted a little later each time, until it comes to its end before that.
        let pause = std::time::Duration::from_millis(100 + 100 * runs);
        std::thread::sleep(pause);
        assert!(crate::signal(&run.id().to_string(), "INT"));
        let output = run.wait_with_output().expect("it ends");
        if output.status.success() {
            break;
        }
        runs += 1;
        // Before it listens, Ctrl-C ends it at once.
        if output.status.code().is_some() {
            assert_one_line_with(&output, 130, &["truth.png.unfinished", "goes on"]);
            assert!(kept.exists() && !out.exists());
        }
    }
    assert!(!kept.exists());
    let whole = lab(&format!("{line} -"));
    assert!(fs::read(&out).expect("a file") == whole.stdout);
}

/// Asserts on the last line of what was said.
#[cfg(unix)]
#[track_caller]
fn assert_one_line_with(output: &Output, code: i32, words: &[&str]) {
    let said = said(output);
    assert_eq!(output.status.code(), Some(code), "{said}");
    let last = said.lines().last().expect("a line");
    assert!(words.iter().all(|word| last.contains(word)), "{said}");
}

#[test]
fn effects_are_a_table_and_pictures_and_squares_cost_little() {
    let folder = tempfile::tempdir().expect("a folder");
    let table = printed(&format!(
        "truth --size 48x36 --samples 8 --effects {}",
        folder.path().display()
    ));
    let psnr = |title: &str| -> f64 {
        let row = table.lines().find(|line| line.contains(title));
        let number = row.and_then(|row| row.split('|').nth(2)?.strip_suffix(" dB "));
        let number = number.unwrap_or_else(|| panic!("{title} is not in {table}"));
        number.trim().parse().expect("a number")
    };
    // Both pictures have smooth edges, or it would be jagged edges that cost.
    assert!(psnr("adaptive squares") > 36.0, "{table}");
    assert!(psnr("one sample a pixel") < 34.0, "{table}");
    let names =
        "truth real-time indirect caustics soft-shadows surfaces falloff edges squares sheet";
    for name in names.split(' ') {
        let picture = folder.path().join(format!("{name}.png"));
        assert!(picture.exists(), "{name}");
    }
}
