use eightfold_lab::overlay::{draw_error, heat};

#[test]
fn error_is_drawn_from_black_to_white() {
    let exhaustive = [0x0010_2030, 0x0010_2030, 0x0010_2030];
    let mut pixels = [0x0010_2030, 0x0010_2130, 0x00ff_2030];
    draw_error(&mut pixels, &exhaustive, 32);
    assert_eq!(pixels, [0.0, 1.0 / 32.0, 1.0].map(heat));
}
