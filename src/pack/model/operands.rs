/// Returns the bytes after an opcode: 0 nothing, 1 a byte, 2 four bytes, 3 an offset of four bytes;
/// plus 4 with ModRM.
#[expect(clippy::match_same_arms, reason = "each map has its own rows")]
const fn operands(map: u32, opcode: u32) -> u32 {
    match (map, opcode) {
        (0, 0..0x40) => match opcode & 7 {
            0..4 => 4,
            4 => 1,
            5 => 2,
            _ => 0,
        },
        (0, 0x63 | 0x84..=0x8f | 0xd0..=0xd3 | 0xd8..=0xdf | 0xf6 | 0xf7 | 0xfe | 0xff) => 4,
        (0, 0x69 | 0x81 | 0xc7) => 6,
        (0, 0x6b | 0x80 | 0x82 | 0x83 | 0xc0 | 0xc1 | 0xc6) => 5,
        (0, 0x68 | 0xa9 | 0xb8..=0xbf) => 2,
        (0, 0xe8 | 0xe9) | (1, 0x80..=0x8f) => 3,
        (0, 0x6a | 0x70..=0x7f | 0xa8 | 0xb0..=0xb7 | 0xeb) => 1,
        (0, _) => 0,
        (1, 5..0x10 | 0x77 | 0xa0..=0xa2 | 0xa8..=0xaa | 0xc8..=0xcf) => 0,
        (1, 0x70..=0x73 | 0xa4 | 0xac | 0xba | 0xc2 | 0xc4..=0xc6) => 5,
        (3, _) => 5,
        _ => 4,
    }
}

/// Below this opcode, map 0 repeats every eight opcodes.
const REPEATING: u32 = 0x40;

/// A run-length code of [`operands`] (length times 8, plus value) for opcodes 0 to 7 and from
/// [`REPEATING`] on of map 0, and maps 1 to 3: a quarter of a table's size.
static RUNS: [u8; RUN_COUNT] = runs().0;
const RUN_COUNT: usize = runs::<256>().1;

const fn runs<const N: usize>() -> ([u8; N], usize) {
    let mut runs = [0; N];
    let (mut count, mut last, mut length) = (0, u32::MAX, 0);
    let mut opcode = 0;
    while opcode < 4 << 8 {
        let operands = operands(opcode >> 8, opcode & 0xff);
        if opcode < 8 || opcode >= REPEATING {
            if operands == last && length < 31 {
                length += 1;
            } else {
                (last, length) = (operands, 1);
                count += 1;
            }
            runs[count - 1] = (length * 8 + operands) as u8;
        }
        opcode += 1;
    }
    (runs, count)
}

pub fn operands_by_runs(map_and_opcode: u32, byte: u32) -> u32 {
    let mut left = if map_and_opcode < REPEATING {
        (byte & 7) as i32
    } else {
        (map_and_opcode - REPEATING + 8) as i32
    };
    for &run in &RUNS {
        left -= i32::from(run >> 3);
        if left < 0 {
            return (run & 7).into();
        }
    }
    0
}

#[cfg(test)]
mod tests {
    use super::{REPEATING, operands, operands_by_runs};

    #[test]
    fn runs_match_operands() {
        for opcode in 0..4 << 8 {
            let repeated = if opcode < REPEATING { opcode & 7 } else { opcode };
            let expected = operands(repeated >> 8, repeated & 0xff);
            assert_eq!(operands_by_runs(opcode, opcode & 0xff), expected, "{opcode:#x}");
        }
    }
}
