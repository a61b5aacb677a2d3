//! `lab missed` counts what a quality misses.

use super::printed;
use eightfold_lab::missed::chance::{Setting, scene};
use eightfold_lab::missed::effects::{Count, Counts, EffectCounter, Kind};
use eightfold_tracer::Quality;

/// The counts of some scenes of a setting, by a quality.
fn counts(setting: Setting, quality: Quality) -> Counts {
    let mut counter = EffectCounter::new(1, 200, 150);
    let mut counts = Counts::new();
    for seed in 0..3 {
        counter.count(&scene(setting, seed), quality, &mut counts);
    }
    counts
}

#[test]
#[ignore = "many scenes by chance"]
fn every_sort_of_scene_has_small_things_of_its_kind_and_the_guarded_ones_are_not_missed() {
    for (setting, kind, is_guarded) in [
        (Setting::Point, Kind::PointShadow, true),
        (Setting::SizedLamp, Kind::SizedShadow, false),
        (Setting::Sun, Kind::SunShadow, false),
        (Setting::Blocks, Kind::BlockShadow, false),
        (Setting::Spheres, Kind::SolidShadow, false),
        (Setting::Mirror, Kind::PlaneImage, true),
        (Setting::Mirrors, Kind::OtherImage, false),
        (Setting::Glass, Kind::Glass, false),
    ] {
        for seed in 0..20 {
            scene(setting, seed).validate().expect("it is valid");
        }
        let counts = counts(setting, Quality::DEFAULT);
        let of = |kind| counts.get(&kind).copied().unwrap_or_default();
        let Count { small, missed } = of(kind);
        assert!(small >= 10, "{small} of {kind:?} in {counts:?}");
        if is_guarded {
            assert_eq!(missed[0], 0, "{kind:?} of {setting:?}");
            assert!(2 * missed[1] > small, "{missed:?} of {small} {kind:?}");
        } else if [Kind::SizedShadow, Kind::Glass].contains(&kind) {
            assert!(2 * missed[0] > small, "{missed:?} of {small} {kind:?}");
        }
        if [Setting::Point, Setting::Blocks].contains(&setting) {
            let Count { small, missed } = of(Kind::Object);
            assert!(missed[0] == 0 && 2 * missed[1] > small, "{counts:?}");
        }
    }
}

#[test]
fn exhaustive_frames_miss_nothing() {
    let counts = counts(Setting::Glass, Quality::EXHAUSTIVE);
    assert!(
        counts.values().all(|count| count.missed == [0, 0]),
        "{counts:?}"
    );
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
