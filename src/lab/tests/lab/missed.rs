use super::printed;
use eightfold_lab::arguments::Size;
use eightfold_lab::missed::effects::{Count, Counts, EffectCounter, Kind};
use eightfold_scenes::{Hidden, Random};
use eightfold_tracer::Quality;

fn counts(hidden: Hidden, quality: Quality) -> Counts {
    let mut counter = EffectCounter::new(1, Size::new(200, 150));
    let mut counts = Counts::new();
    for seed in 0..3 {
        counter.count(&hidden.scene(&mut Random::new(seed)), quality, &mut counts);
    }
    counts
}

#[test]
#[ignore = "many random scenes"]
fn random_scenes_have_effects_of_their_kind() {
    // The largest missed share; 1 for kinds that the guard ignores.
    for (hidden, kind, most) in [
        (Hidden::POINT, Kind::PlaneShadow, 0.0),
        (Hidden::AREA, Kind::PlaneShadow, 0.04),
        (Hidden::SUN, Kind::PlaneShadow, 0.01),
        (Hidden::BLOCKS, Kind::PlaneShadow, 0.03),
        (Hidden::BALLS, Kind::SolidShadow, 1.0),
        (Hidden::MIRROR, Kind::PlaneImage, 0.0),
        (Hidden::MIRRORS, Kind::OtherImage, 1.0),
        (Hidden::GLASS, Kind::OtherImage, 1.0),
    ] {
        for seed in 0..20 {
            let scene = hidden.scene(&mut Random::new(seed));
            scene.validate().expect("it is valid");
        }
        let counts = counts(hidden, Quality::DEFAULT);
        let of = |kind| counts.get(&kind).copied().unwrap_or_default();
        let Count { small, missed } = of(kind);
        assert!(small >= 10, "{small} of {kind:?} in {counts:?}");
        let share = missed[0] as f64 / small as f64;
        assert!(share <= most, "{missed:?} of {small} {kind:?}");
        if most < 1.0 {
            assert!(2 * missed[1] > small, "{missed:?} of {small} {kind:?}");
        } else if hidden == Hidden::GLASS {
            assert!(2 * missed[0] > small, "{missed:?} of {small} {kind:?}");
        }
        if [Hidden::POINT, Hidden::BLOCKS].contains(&hidden) {
            // 22 of 50 are missed without the guard for POINT.
            let Count { small, missed } = of(Kind::Object);
            assert!(missed[0] == 0 && 3 * missed[1] > small, "{counts:?}");
        }
    }
}

#[test]
fn exhaustive_misses_nothing() {
    let counts = counts(Hidden::GLASS, Quality::EXHAUSTIVE);
    let mut missed = counts.values().map(|count| count.missed);
    assert!(missed.all(|missed| missed == [0, 0]), "{counts:?}");
}

#[test]
fn table_has_row_per_kind_and_group_columns() {
    let text = printed("missed --scene field:40 --size 80x60 --frames 1");
    let rows: Vec<&str> = text.lines().filter(|line| line.starts_with('|')).collect();
    assert_eq!(rows.len(), 2 + Kind::ALL.len(), "{text}");
    let end = "| field:40 | missed | unguarded |";
    assert!(rows[0].ends_with(end), "{text}");
    let mut bars = rows.iter().map(|row| row.matches('|').count());
    assert!(bars.all(|bars| bars == 5), "{text}");
    let objects = rows.iter().find(|row| row.starts_with("| objects |"));
    let cells: Vec<&str> = objects.expect("a row").split('|').map(str::trim).collect();
    assert!(cells[2].parse::<usize>().unwrap() > 5, "{text}");
    assert_eq!(cells[3], "0", "{text}");
}
