//! Scenes as text: any scene is read as it was written, and every mistake has a line and a column.

use crate::extremes::rich;
use crate::generator::seeded::{Random, scene};
use eightfold_scene_file::SceneFile;
use eightfold_tracer::scene::{Caption, CopperBar, List, Scene};
use std::fs;
use std::ops::Range;
use std::path::Path;

/// A scene in RON, with the places of its numbers.
pub struct Text {
    ron: String,
    pub numbers: Vec<Range<usize>>,
}

impl Text {
    pub fn of(scene: &Scene) -> Self {
        let ron = ron::to_string(scene).expect("a scene has a text");
        let (mut numbers, mut at) = (Vec::new(), 0);
        for word in ron.split(['(', ')', '[', ']', ',', ':']) {
            if word.parse::<f32>().is_ok() {
                numbers.push(at..at + word.len());
            }
            at += word.len() + 1;
        }
        Self { ron, numbers }
    }

    /// Returns where the value of a number's field begins, and the name of the field.
    fn field(&self, i: usize) -> (usize, &str) {
        let before = &self.ron[..self.numbers[i].start];
        let colon = before.rfind(':').expect("a number is in a field");
        let name = before[..colon].rsplit(['(', ',']).next();
        (colon + 1, name.expect("a name"))
    }

    /// Returns the text with another number.
    fn with(&self, i: usize, number: f32) -> String {
        let Range { start, end } = self.numbers[i];
        format!("{}{number:?}{}", &self.ron[..start], &self.ron[end..])
    }

    /// Returns the scene with another number, and the name of the field.
    pub fn scene_with(&self, i: usize, number: f32) -> (Scene, &str) {
        let scene = ron::from_str(&self.with(i, number)).expect("it is a number");
        (scene, self.field(i).1)
    }
}

#[test]
fn number_beyond_its_range_is_refused_at_its_place() {
    let text = Text::of(&rich());
    let mut count = 0;
    for i in 0..text.numbers.len() {
        let flaw = |number| text.scene_with(i, number).0.validate().err();
        let (start, name) = text.field(i);
        let refusal = flaw(f32::NAN).expect(name);
        assert!(refusal.to_string().contains(name), "{name}: {refusal}");
        let fault = SceneFile::parse("a.ron", &text.with(i, f32::NAN)).expect_err(name);
        let mut parts = fault.split(':');
        let place = [parts.next(), parts.next()];
        let column: usize = parts
            .next()
            .and_then(|part| part.parse().ok())
            .expect("a column");
        assert_eq!(place, [Some("a.ron"), Some("1")], "{fault}");
        assert!(
            (start..=text.numbers[i].start).contains(&(column - 1)),
            "{name}: {fault}"
        );
        // Other rules have other words.
        let ends = refusal.range.split_once(" to ");
        let ends = ends.and_then(|(a, b)| Some([a.parse::<f32>().ok()?, b.parse().ok()?]));
        for (end, beyond) in ends
            .into_iter()
            .flat_map(|[a, b]| [(a, a.next_down()), (b, b.next_up())])
        {
            assert_eq!(
                flaw(beyond).map(|flaw| flaw.range),
                Some(refusal.range),
                "{name} {beyond}"
            );
            assert_ne!(
                flaw(end).map(|flaw| flaw.range),
                Some(refusal.range),
                "{name} {end}"
            );
            count += 1;
        }
    }
    assert!(count > 400, "{count}");
}

#[test]
fn scene_is_read_as_it_was_written() {
    let contents = |scene: &Scene| format!("{scene:?}");
    for seed in 0..200 {
        let mut scene = scene(&mut Random(seed));
        scene.captions.push(Caption {
            letters: List::of(b"\"8\\\x7f\n#"),
            ..Caption::default()
        });
        scene.copper_bars.push(CopperBar::default());
        let ron = ron::to_string(&scene).expect("RON");
        let json = serde_json::to_string(&scene).expect("JSON");
        let file = SceneFile::parse("a.ron", &ron).expect("a scene file");
        for read in [
            file.at(0.0),
            ron::from_str(&ron).expect("RON"),
            serde_json::from_str(&json).expect("JSON"),
        ] {
            assert_eq!(contents(&read), contents(&scene), "seed {seed}");
        }
    }
}

#[test]
fn mutated_text_gives_a_line_and_a_column() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    let mut refused = 0;
    for name in ["motion", "blocks", "lights"] {
        let text = fs::read_to_string(folder.join(name).with_extension("ron")).expect("an example");
        let mut random = Random(2008);
        for case in 0..400 {
            let mut text: Vec<char> = text.chars().collect();
            for _ in 0..=random.below(3) {
                let (at, count) = (random.below(text.len()), random.below(3));
                let pieces = [
                    "", "(", ")", "]", "{", "\"", ",", ":", "/*", "-", "1e40", "NaN", "é", "None",
                ];
                let end = text.len().min(at + count);
                text.splice(at..end, pieces[random.below(pieces.len())].chars());
            }
            let text: String = text.into_iter().collect();
            let Err(fault) = SceneFile::parse("a.ron", &text) else {
                continue;
            };
            let what = format!("case {case} of {name}: {fault}");
            let mut parts = fault.splitn(4, ':').skip(1);
            let mut number = || {
                parts
                    .next()
                    .and_then(|part| part.parse::<usize>().ok())
                    .expect(&what)
            };
            let line = text.split('\n').nth(number() - 1).expect(&what);
            assert!(number() <= line.chars().count() + 1, "{what}");
            assert!(!fault.contains('\n') && parts.next().is_some(), "{what}");
            refused += 1;
        }
    }
    assert!(refused > 600, "{refused}");
}
