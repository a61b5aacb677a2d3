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
    0xd1fe_cf20, // I
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
    0xf13b_d951, // 8
    0xf683_15bd, // 9
];

/// What is left of a letter's points.
pub(crate) struct Strokes(u32);

/// The straight strokes of a capital or a digit; anything else is a space.
pub(crate) fn strokes(letter: u8) -> Strokes {
    let letter = letter.wrapping_sub(b'0');
    let number = if letter < 10 {
        letter + 26
    } else {
        letter.wrapping_sub(b'A' - b'0')
    };
    Strokes(*STROKES.get(usize::from(number)).unwrap_or(&!0))
}

impl Iterator for Strokes {
    /// Its ends in grid units right and down from the letter's upper left.
    type Item = (Vec2, Vec2);

    #[inline(never)]
    fn next(&mut self) -> Option<(Vec2, Vec2)> {
        let place = |point: u32| vec2((point % 3) as i32 as f32, (point / 3) as i32 as f32);
        while self.0 != !0 {
            let from = self.0 & 15;
            self.0 = self.0 >> 4 | 15 << 28;
            let to = self.0 & 15;
            if from < 15 && to < 15 {
                return Some((place(from), place(to)));
            }
        }
        None
    }
}
