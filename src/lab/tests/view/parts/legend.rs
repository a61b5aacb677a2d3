//! The words beside the picture.

use eightfold_lab::view::controls::{MOST_ERROR, MOST_RAYS, Overlay};
use eightfold_lab::view::legend::{KEYS, colours};

#[test]
fn the_words_have_the_numbers_of_the_overlays() {
    let words = |key| KEYS.iter().find(|row| row.0 == key).map_or("", |row| row.1);
    assert!(words("H").contains(&format!("for {MOST_RAYS} and more")));
    assert!(words("E").contains(&format!("for {MOST_ERROR} of 255")));
    let last = |overlay| colours(overlay).pop().map(|row| row.words);
    assert_eq!(last(Overlay::Heat), Some("24 rays and more".to_owned()));
    assert_eq!(last(Overlay::Error), Some("32/255 and more".to_owned()));
    assert_eq!(colours(Overlay::None), []);
}
