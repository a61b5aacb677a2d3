use eightfold_scene_file::SceneFile;
use eightfold_scenes::text::Text;
use eightfold_scenes::{Kinds, Random, cases};
use eightfold_tracer::scene::{Caption, CopperBar, List, Scene};
use std::fs;
use std::path::Path;

fn written(kinds: Kinds, random: &mut Random) -> Scene {
    let mut scene = kinds.scene(random);
    scene.captions.push(Caption::default());
    scene.captions[0].letters = List::of(b"\"8\\\x7f\n#");
    scene.copper_bars.push(CopperBar::default());
    scene
}

fn place(message: &str) -> Option<(usize, usize)> {
    let mut parts = message.strip_prefix("a.ron:")?.split(':');
    Some((parts.next()?.parse().ok()?, parts.next()?.parse().ok()?))
}

#[test]
fn number_beyond_its_range_is_refused_at_its_place() {
    let text = Text::of(&written(Kinds::RICH, &mut Random::new(2008)));
    let mut count = 0;
    for i in 0..text.numbers.len() {
        let error = |number| text.scene_with(i, number).0.validate().err();
        let range = |number| error(number).map(|error| error.range);
        let (start, name) = text.field(i);
        let refusal = error(f32::NAN).expect(name);
        assert!(refusal.to_string().contains(name), "{name}: {refusal}");
        let fault = SceneFile::parse("a.ron", &text.with(i, f32::NAN)).expect_err(name);
        let (line, column) = place(&fault).expect(&fault);
        let is_at = (start..=text.numbers[i].start).contains(&(column - 1));
        assert!(line == 1 && is_at, "{name}: {fault}");
        let Some((least, most)) = refusal.range.split_once(" to ") else {
            continue;
        };
        if let (Ok(least), Ok(most)) = (least.parse::<f32>(), most.parse::<f32>()) {
            for (end, beyond) in [(least, least.next_down()), (most, most.next_up())] {
                assert_eq!(range(beyond), Some(refusal.range), "{name} {beyond}");
                assert_ne!(range(end), Some(refusal.range), "{name} {end}");
                count += 1;
            }
        }
    }
    assert!(count > 400, "{count}");
}

#[test]
fn scene_is_read_as_it_was_written() {
    let contents = |scene: &Scene| format!("{scene:?}");
    for mut random in cases(8) {
        let scene = written(Kinds::EXTREME, &mut random);
        let ron = ron::to_string(&scene).expect("RON");
        let json = serde_json::to_string(&scene).expect("JSON");
        let file = SceneFile::parse("a.ron", &ron).expect("a scene file");
        let read = ron::from_str(&ron).expect("a scene");
        for read in [
            file.at(0.0),
            read,
            serde_json::from_str(&json).expect(&json),
        ] {
            assert_eq!(contents(&read), contents(&scene), "case {}", random.seed);
        }
    }
}

#[test]
fn mutated_text_gives_a_line_and_a_column() {
    const PIECES: &str = " ( ) ] { \" , : /* - 1e40 NaN é None";
    let pieces: Vec<&str> = PIECES.split(' ').collect();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
    let mut refused = 0;
    for name in ["motion.ron", "blocks.ron", "lights.ron"] {
        let example = fs::read_to_string(folder.join(name)).expect("an example");
        let mut random = Random::new(2008);
        for case in 0..150 {
            let mut text: Vec<char> = example.chars().collect();
            for _ in 0..=random.below(3) {
                let at = random.below(text.len());
                let end = text.len().min(at + random.below(3));
                text.splice(at..end, pieces[random.below(pieces.len())].chars());
            }
            let text: String = text.into_iter().collect();
            let Err(fault) = SceneFile::parse("a.ron", &text) else {
                continue;
            };
            let (line, column) = place(&fault).expect(&fault);
            let line = text.split('\n').nth(line - 1).expect(&fault);
            let is_there = (1..=line.chars().count() + 1).contains(&column);
            assert!(
                is_there && !fault.contains('\n'),
                "{name}, case {case}: {fault}"
            );
            refused += 1;
        }
    }
    assert!(refused > 220, "{refused}");
}
