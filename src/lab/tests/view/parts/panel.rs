//! Panels over the picture.

use eightfold_lab::arguments::Size;
use eightfold_lab::view::panel::{Corner, Mark, Panel, Row, over, wrapped};

#[test]
fn lines_break_between_words_where_the_room_ends() {
    let lines = wrapped("one two three four", 9, str::len);
    assert_eq!(lines, ["one two", "three", "four"]);
    assert_eq!(wrapped("incomprehensible", 9, str::len).len(), 1);
}

#[test]
fn a_panel_darkens_its_corner_alone_and_shows_its_colours() {
    let size = Size::new(200, 100);
    let rows = [Row {
        mark: Mark::Colour(0x00ff_0000),
        words: "red".to_owned(),
    }];
    for (corner, dark, light) in [
        (Corner::UpperLeft, 0, 199),
        (Corner::LowerLeft, 99 * 200, 0),
        (Corner::LowerRight, 99 * 200 + 199, 0),
    ] {
        let mut picture = vec![0x0080_8080; size.area()];
        Panel::default().show(&rows, corner, &mut picture, size);
        assert_eq!(picture[dark], over(0x0080_8080, 0), "{corner:?}");
        assert_eq!(picture[light], 0x0080_8080, "{corner:?}");
        let count = |is: fn(u32) -> bool| picture.iter().filter(|pixel| is(**pixel)).count();
        assert!(count(|pixel| pixel & 0x00ff_f0f0 == 0x00ff_0000) > 100);
        let is_bright = |pixel: u32| pixel.to_be_bytes()[1..].iter().all(|&c| c > 180);
        assert!(count(is_bright) > 10, "letters");
    }
}
