//! Letters as strokes on a grid of 3 by 5 points, for text of any size and for letters built of things.

use glam::{Vec2, vec2};

/// Grid units from a letter's left side to the next one's.
pub(crate) const ADVANCE: f32 = 3.0;

/// The letters from A to Z, then the digits: points from the lowest four bits up, numbered from 0 to 14 row after row
/// from the upper left; 15 lifts the pen.
static STROKES: [u32; 36] = [
    0x86fe_513c, // A
    0x6bdc_0156, // B
    0xffed_9312, // C
    0xf0cd_b510, // D
    0xf76f_ec02, // E
    0xff76_fc02, // F
    0x78ed_9312, // G
    0xe2f8_6fc0, // H
    0xffff_ffd1, // I
    0xffff_9db2, // J
    0xffe6_2fc0, // K
    0xffff_fec0, // L
    0xfffe_270c, // M
    0xffff_2e0c, // N
    0xf15b_d931, // O
    0xff67_510c, // P
    0xe15b_d931, // Q
    0xfe67_510c, // R
    0xffcd_b312, // S
    0xfffd_1f20, // T
    0xfff2_bd90, // U
    0xffff_f2d0, // V
    0xfff2_e7c0, // W
    0xfffc_2fe0, // X
    0xffd7_f270, // Y
    0xffff_ec20, // Z
    0xf15b_d931, // 0
    0xffff_fd13, // 1
    0xfffe_c513, // 2
    0xffcd_b720, // 3
    0xffff_b62e, // 4
    0xfcdb_4302, // 5
    0xf68b_d931, // 6
    0xffff_fd20, // 7
    0x13bd_3951, // 8
    0xf683_15bd, // 9
];

/// Calls `stroke` with the ends of each straight stroke of a line of text: grid units right and down from the upper left
/// of the first letter. What is no capital and no digit is a space.
pub(crate) fn strokes(text: &str, mut stroke: impl FnMut(Vec2, Vec2)) {
    for (place, letter) in text.bytes().enumerate() {
        let number = match letter {
            b'A'..=b'Z' => letter - b'A',
            b'0'..=b'9' => letter - b'0' + 26,
            _ => continue,
        };
        let mut points = STROKES[number as usize];
        let mut last = None;
        for _ in 0..8 {
            let point = points & 15;
            points >>= 4;
            let at = vec2(
                (point % 3) as f32 + place as f32 * ADVANCE,
                (point / 3) as f32,
            );
            let is_down = point < 15;
            if let (Some(from), true) = (last, is_down) {
                stroke(from, at);
            }
            last = is_down.then_some(at);
        }
    }
}
