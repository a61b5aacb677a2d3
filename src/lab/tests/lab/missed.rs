//! `lab missed` counts what a quality misses.

use super::{assert_one_line, lab, printed};
use eightfold_lab::missed::chance::{SETTINGS, Setting, scene};
use eightfold_lab::missed::effects::{Count, Counts, EffectCounter, Kind};
use eightfold_tracer::Quality;

/// The counts of some scenes of a setting, by a quality.
fn counts(setting: Setting, quality: Quality) -> Counts {
    let mut counter = EffectCounter::new(1, 320, 240);
    let mut counts = Counts::new();
    for seed in 0..3 {
        counter.count(&scene(setting, seed), quality, &mut counts);
    }
    counts
}

#[test]
fn every_sort_of_scene_has_its_kind_of_small_things() {
    let kinds = [
        Kind::PointShadow,
        Kind::SizedShadow,
        Kind::SunShadow,
        Kind::BlockShadow,
        Kind::SolidShadow,
        Kind::PlaneImage,
        Kind::OtherImage,
        Kind::Glass,
    ];
    for (setting, kind) in SETTINGS.into_iter().zip(kinds) {
        for seed in 0..20 {
            scene(setting, seed).validate().expect("it is valid");
        }
        let counts = counts(setting, Quality::DEFAULT);
        let small = counts.get(&kind).map_or(0, |count| count.small);
        assert!(small >= 10, "{small} of {kind:?} in {counts:?}");
    }
}

#[test]
fn what_is_guarded_is_not_missed_and_the_bare_rules_miss_it() {
    for (setting, kind) in [
        (Setting::Point, Kind::Object),
        (Setting::Blocks, Kind::Object),
        (Setting::Point, Kind::PointShadow),
        (Setting::Mirror, Kind::PlaneImage),
    ] {
        let Count { small, missed } = counts(setting, Quality::DEFAULT)[&kind];
        assert_eq!(missed[0], 0, "{kind:?} of {setting:?}");
        assert!(2 * missed[1] > small, "{missed:?} of {small} {kind:?}");
    }
}

#[test]
fn what_is_not_guarded_is_missed_but_by_exhaustive_frames() {
    for (setting, kind) in [
        (Setting::SizedLamp, Kind::SizedShadow),
        (Setting::Glass, Kind::Glass),
    ] {
        let Count { small, missed } = counts(setting, Quality::DEFAULT)[&kind];
        assert!(2 * missed[0] > small, "{missed:?} of {small} {kind:?}");
        let none = counts(setting, Quality::EXHAUSTIVE);
        assert!(
            none.values().all(|count| count.missed == [0, 0]),
            "{none:?}"
        );
    }
}

#[test]
fn the_table_has_a_row_for_each_kind_and_three_columns_for_each_group_of_scenes() {
    let text = printed("missed --scene field:40 --size 80x60 --frames 1");
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with('|')).collect();
    assert_eq!(rows.len(), 2 + Kind::ALL.len(), "{text}");
    assert!(
        rows[0].ends_with("| field:40 | missed | unguarded |"),
        "{text}"
    );
    assert!(
        rows.iter().all(|row| row.matches('|').count() == 5),
        "{text}"
    );
    let objects = rows.iter().find(|row| row.starts_with("| objects |"));
    let cells: Vec<&str> = objects.expect("a row").split('|').map(str::trim).collect();
    assert!(cells[2].parse::<usize>().unwrap() > 5, "{text}");
    assert_eq!(cells[3], "0", "{text}");
}

#[test]
fn bad_input_is_named_in_one_line() {
    for (flag, value, takes) in [
        ("--size", "640", "WIDTHxHEIGHT"),
        ("--seeds", "0", "1 to"),
        ("--quality", "best", "exhaustive, thesis, finest"),
        ("--scene", "field:0", "field:N"),
    ] {
        assert_one_line(&lab(&["missed", flag, value]), 2, &[flag, value, takes]);
    }
}
