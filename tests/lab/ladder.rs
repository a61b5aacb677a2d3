//! The ladder of named qualities.

use eightfold::Quality;

#[test]
fn every_rung_has_a_name_that_finds_it() {
    let names: Vec<&str> = Quality::NAMES.split(' ').collect();
    assert_eq!(names.len(), Quality::LADDER.len());
    for (rung, name) in names.iter().enumerate() {
        assert_eq!(Quality::rung(name.as_bytes()), Some(rung), "{name}");
    }
    for unknown in ["", " ", "best", "Fine", "fine ", "finest finer"] {
        assert_eq!(Quality::rung(unknown.as_bytes()), None, "{unknown:?}");
    }
}

#[test]
fn what_the_intro_plays_by_is_a_rung_and_so_called() {
    let rung = Quality::rung(b"default").expect("a rung of that name");
    assert_eq!(Quality::LADDER[rung], Quality::DEFAULT);
}
