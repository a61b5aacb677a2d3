use eightfold_scene_file::SceneFile;
use eightfold_scenes::text::Text;
use eightfold_scenes::{Kinds, Random, cases};
use eightfold_tracer::presentation::{Caption, Presentation};
use eightfold_tracer::scene::{List, Scene};
use eightfold_tracer::{Quality, RangeError};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::fmt::Debug;
use std::fs;
use std::path::Path;

fn captioned() -> Presentation {
    let caption = Caption { letters: List::of(b"\"8\\\x7f\n#"), ..Caption::default() };
    Presentation { captions: List::of(&[caption]), ..Presentation::default() }
}

fn place(message: &str) -> Option<(usize, usize)> {
    let mut parts = message.strip_prefix("a.ron:")?.split(':');
    Some((parts.next()?.parse().ok()?, parts.next()?.parse().ok()?))
}

/// Refuses the numbers of a value beyond their ranges. Returns the number of ranges' ends.
fn refuse<T: Serialize + DeserializeOwned>(
    value: &T,
    validate: fn(&T) -> Result<(), RangeError>,
) -> usize {
    let (text, mut count) = (Text::of(value), 0);
    for i in 0..text.numbers.len() {
        let error = |number| validate(&text.value_with(i, number).0).err();
        let range = |number| error(number).map(|error| error.range);
        let (start, name) = text.field(i);
        let refusal = error(f32::NAN).expect(name);
        assert!(refusal.to_string().contains(name), "{name}: {refusal}");
        let fault = SceneFile::parse("a.ron", &text.with(i, f32::NAN)).expect_err(name);
        let (line, column) = place(&fault).expect(&fault);
        let is_at = (start..=text.numbers[i].start).contains(&(column - 1));
        assert!(line == 1 && is_at, "{name}: {fault}");
        let Some((min, max)) = refusal.range.split_once(" to ") else { continue };
        if let (Ok(min), Ok(max)) = (min.parse::<f32>(), max.parse::<f32>()) {
            for (end, beyond) in [(min, min.next_down()), (max, max.next_up())] {
                assert_eq!(range(beyond), Some(refusal.range), "{name} {beyond}");
                assert_ne!(range(end), Some(refusal.range), "{name} {end}");
                count += 1;
            }
        }
    }
    count
}

#[test]
fn number_beyond_its_range_is_refused_at_its_place() {
    let count = refuse(&Kinds::RICH.scene(&mut Random::new(2008)), Scene::validate);
    assert!(count > 90, "{count}");
    assert_eq!(refuse(&captioned(), Presentation::validate), 18);
}

fn assert_written<T: Debug>(read: &T, written: &T, random: &Random) {
    assert_eq!(format!("{read:?}"), format!("{written:?}"), "case {}", random.seed);
}

#[test]
fn scene_is_read_as_it_was_written() {
    let presentation = captioned();
    let end = ron::to_string(&presentation).expect("RON");
    for mut random in cases(8) {
        let scene = Kinds::EXTREME.scene(&mut random);
        let ron = ron::to_string(&scene).expect("RON");
        let json = serde_json::to_string(&scene).expect("JSON");
        assert_written(&ron::from_str(&ron).expect("a scene"), &scene, &random);
        assert_written(&serde_json::from_str(&json).expect(&json), &scene, &random);
        // A file has the fields of both.
        let text = format!("{},{}", ron.trim_end_matches(')'), &end[1..]);
        let read = SceneFile::parse("a.ron", &text).expect("a scene file").at(0.0);
        assert_written(&read.scene, &scene, &random);
        assert_written(&read.presentation, &presentation, &random);
    }
}

#[test]
fn missing_fields_of_a_quality_are_default() {
    let read = serde_json::from_str::<Quality>;
    let square = 4;
    assert_eq!(read(r#"{"square":4}"#).ok(), Some(Quality { square, ..Quality::DEFAULT }));
    assert!(read(r#"{"squares":4}"#).is_err());
}

#[test]
fn mutated_text_gives_a_line_and_a_column() {
    const PIECES: &str = " ( ) ] { \" , : /* // - 0,5 -2 9 1e40 NaN é None Some(() r# #![ \x1b[31m \u{202e} \u{7f} \r\n\t";
    let (long, deep) = ("long".repeat(99), "[".repeat(200));
    let mut pieces: Vec<&str> = PIECES.split(' ').collect();
    pieces.extend([long.as_str(), &deep, "\n", "\r", " "]);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
    let mut refused = 0;
    for name in ["motion.ron", "blocks.ron", "lights.ron"] {
        let example = fs::read_to_string(folder.join(name)).expect("an example");
        let mut random = Random::new(2008);
        for case in 0..300 {
            let mut text: Vec<char> = example.chars().collect();
            for _ in 0..=random.below(3) {
                let at = random.below(text.len());
                let end = text.len().min(at + random.below(3));
                text.splice(at..end, pieces[random.below(pieces.len())].chars());
            }
            let text: String = text.into_iter().collect();
            let fault = match SceneFile::parse("a.ron", &text) {
                Err(fault) => fault,
                Ok(file) => {
                    let time = file.length * random.unit() as f32;
                    assert_eq!(file.check(time), Ok(()), "{name}, case {case}: {text}");
                    continue;
                }
            };
            let (line, column) = place(&fault).expect(&fault);
            let line = text.split('\n').nth(line - 1).expect(&fault);
            let is_there = (1..=line.chars().count() + 1).contains(&column);
            let is_printable = !fault.contains(|letter: char| {
                letter.is_control() || letter == '\u{202e}' || letter == '\u{feff}'
            });
            assert!(
                is_there && is_printable && fault.chars().count() <= 200,
                "{name}, case {case}: {fault:?}"
            );
            refused += 1;
        }
    }
    assert!(refused > 500, "{refused}");
}

/// Text | place and message.
const EXPLAINED: &str = include_str!("mistakes.txt");

#[test]
fn mistake_is_explained_at_its_place() {
    let (deep, long) = ("[".repeat(3000), "A B ".repeat(300));
    for row in EXPLAINED.trim().lines() {
        let (text, says) = row.split_once(" | ").expect("two columns");
        let text = text.replace("\\n", "\n").replace("\\e", "\x1b");
        let text = text.replace("DEEP", &deep).replace("LONG", &format!("{long:?}"));
        // A byte order mark has no column.
        let text = format!("\u{feff}{}", text.replace("WORD", &"LONG".repeat(99)));
        let fault = SceneFile::parse("a.ron", &text).expect_err(says);
        assert!(fault.contains(says), "{fault}");
        assert!(place(&fault).is_some() && fault.len() <= 200, "{fault}");
    }
}

#[test]
fn long_or_odd_name_is_escaped_and_cut() {
    let name = format!("{}\x1b[31m/\n{}.ron", "folder/".repeat(30), "x".repeat(30));
    let fault = SceneFile::parse(&name, &"x ".repeat(200)).expect_err("not a scene");
    let end = format!("\\u{{1b}}[31m/ {}.ron:1:3: text is 'x'", "x".repeat(30));
    assert!(fault.starts_with("...") && fault.contains(&end), "{fault}");
    assert!(fault.chars().count() <= 200, "{fault}");
}

#[test]
fn byte_outside_utf_8_has_line_and_column() {
    let fault = SceneFile::decode("a.ron", b"()\n// caf\xe9".to_vec());
    let fault = fault.expect_err("not UTF-8");
    assert_eq!(fault, "a.ron:2:7: byte is 0xe9; must be UTF-8");
    let text = "(haze: 1) // \u{e9}".to_owned();
    assert_eq!(SceneFile::decode("a.ron", text.clone().into_bytes()), Ok(text));
}
