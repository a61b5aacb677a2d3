//! Reads x86-64 machine code byte by byte, so that the model knows what the next byte is: an opcode, a part of an address, ...
//!
//! It follows the length of instructions and no more. Bytes that are no instructions are read as some, which does no harm: whatever
//! it says is only a context to predict by, and both sides say the same.

/// What the model predicts a byte by, each a number; contexts are sets of them.
pub const FEATURES: usize = 24;
/// What the next byte is; see the kinds below. (Features 0 to 7 are the last bytes, the newest first.)
pub const KIND: usize = 8;
/// The opcode of this instruction so far, plus 0x100 times its map. Those of the three instructions before follow it in steps of
/// [`STEP`], as those of the two features after it do.
pub const OPCODE: usize = 9;
/// The ModRM byte, which names a register and an operand.
pub const MODRM: usize = 10;
/// All prefixes, 8 bits each.
pub const PREFIXES: usize = 11;
/// Features that are kept of each instruction.
const STEP: usize = 3;
/// The end of those.
const HISTORY_END: usize = OPCODE + 4 * STEP;
/// The place modulo 4: data has rows of words.
pub const PLACE: usize = HISTORY_END;
/// The ModRM byte's operand, and what the SIB byte adds to it.
pub const OPERAND: usize = 22;
/// The last two bytes that were of this kind behind the same opcode, the newer in the lower bits.
pub const SAME_FIELD: usize = 23;

/// A feature of an earlier instruction.
pub const fn before(feature: usize, instructions: usize) -> usize {
    feature + instructions * STEP
}

// Kinds of bytes. Where a field has several bytes, the kind counts down to the last of them.
/// Prefixes or an opcode.
const START: u32 = 0;
/// An opcode that a prefix was before.
const AFTER_PREFIX: u32 = 1;
const IS_MODRM: u32 = 2;
const IS_SIB: u32 = 3;
/// What follows the first byte of a VEX or EVEX prefix: at most three bytes.
const VEX: u32 = 4;
const DISPLACEMENT: u32 = 8;
/// A displacement from the next instruction.
const RELATIVE_DISPLACEMENT: u32 = 12;
const IMMEDIATE: u32 = 16;
/// The offset of a jump or call.
const RELATIVE_JUMP: u32 = 20;
/// More than the highest kind, and a power of two.
pub const KINDS: usize = 32;

/// What follows an opcode: 0 nothing, 1 a byte, 2 four bytes, 3 an offset of four bytes; and 4 more if a ModRM byte comes before it.
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

/// The opcodes below this one of map 0 repeat every eight.
const REPEATING: u32 = 0x40;

/// [`operands`] of opcodes 0 to 7 and from [`REPEATING`] on of map 0, and of maps 1 to 3, in runs: 8 times a length, and what it is
/// of. That is a quarter of a table with an entry for each.
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

/// [`operands`] as the runs have it.
fn operands_by_runs(map_and_opcode: u32, byte: u32) -> u32 {
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

/// Fields of all instructions: for each map and opcode, each kind.
const FIELDS: usize = 4 << 8 << KINDS.ilog2();

/// The state of reading, all zero to begin with. Its largest part comes last: instructions reach the others by offsets of one byte.
#[repr(C)]
pub struct Reader {
    features: [u32; FEATURES],
    /// The field of the next byte.
    field: usize,
    /// Bytes read so far.
    place: usize,
    /// Where the offset of this instruction is, behind its opcode; 0 if it has none.
    offset: usize,
    /// The kind of the displacement that follows a SIB byte.
    displacement: u32,
    /// The kind of what follows ModRM, SIB and displacement; 0 for nothing.
    operand: u32,
    /// The last two bytes of each field.
    fields: [u16; FIELDS],
}

impl Default for Reader {
    fn default() -> Reader {
        Reader {
            features: [0; FEATURES],
            fields: [0; FIELDS],
            field: 0,
            place: 0,
            offset: 0,
            displacement: 0,
            operand: 0,
        }
    }
}

impl Reader {
    /// A feature of the next byte.
    #[inline(always)]
    pub fn feature(&self, number: usize) -> u32 {
        self.features.get(number).copied().unwrap_or_default()
    }

    /// Whether the next byte begins an instruction.
    pub fn is_between_instructions(&self) -> bool {
        self.feature(KIND) == START
    }

    /// Where an instruction that has just ended has the four bytes of an offset from its end to something else.
    #[inline(always)]
    pub fn ended_offset(&self) -> Option<usize> {
        (self.offset != 0 && self.feature(KIND) == START).then_some(self.offset)
    }

    /// Reads the next byte.
    #[inline(never)]
    pub fn read(&mut self, byte: u32) {
        let features = &mut self.features;
        features.copy_within(0..7, 1);
        features[0] = byte;
        features[PLACE] = (features[PLACE] + 1) & 3;
        let kind = features[KIND];
        if kind == START {
            self.offset = 0;
        } else if kind == RELATIVE_DISPLACEMENT + 3 || kind == RELATIVE_JUMP + 3 {
            self.offset = self.place;
        }
        self.place += 1;
        let mut next = match kind {
            START | AFTER_PREFIX => self.read_opcode(byte),
            IS_MODRM => self.read_modrm(byte),
            IS_SIB => self.read_sib(byte),
            VEX..DISPLACEMENT => self.read_vex(byte, kind),
            // The last byte of a field: the operand's, or that before it.
            _ if kind & 3 == 0 => START,
            _ => kind - 1,
        };
        if next == START && kind < IMMEDIATE {
            next = self.operand;
            self.operand = START;
        }
        if next == START {
            self.end_instruction();
        }
        self.features[KIND] = next;
        let field = &mut self.fields[self.field & (FIELDS - 1)];
        *field = *field << 8 | byte as u16;
        self.field = (self.features[OPCODE] << KINDS.ilog2() | next) as usize;
        self.features[SAME_FIELD] = self.fields[self.field & (FIELDS - 1)].into();
    }

    /// Reads a prefix or an opcode. Returns what kind of byte follows, as all of these do.
    #[inline(always)]
    fn read_opcode(&mut self, byte: u32) -> u32 {
        let features = &mut self.features;
        if features[OPCODE] == 0 {
            let escape = match byte {
                0x0f => AFTER_PREFIX,
                0xc5 => VEX,
                0xc4 => VEX + 1,
                0x62 => VEX + 2,
                _ => 0,
            };
            if escape != 0 {
                // Map 1, unless VEX says another.
                features[OPCODE] = 0x100;
                return escape;
            }
            if byte & 0xf0 == 0x40 || matches!(byte, 0x64 | 0x66 | 0x2e | 0xf0 | 0xf2 | 0xf3) {
                features[PREFIXES] = features[PREFIXES] << 8 | byte;
                return AFTER_PREFIX;
            }
        }
        features[OPCODE] += byte;
        let operands = operands_by_runs(features[OPCODE], byte);
        let after = match operands & 3 {
            0 => START,
            1 => IMMEDIATE,
            // Two bytes of it, where a prefix says so.
            2 if features[PREFIXES] & 0xff == 0x66 || features[PREFIXES] >> 8 == 0x66 => {
                IMMEDIATE + 1
            }
            2 => IMMEDIATE + 3,
            _ => RELATIVE_JUMP + 3,
        };
        if features[OPCODE] & !7 == 0xb8 && features[PREFIXES] & 0xf8 == 0x48 {
            // `mov` of a number of 8 bytes: as a displacement and an immediate value.
            self.operand = after;
            return DISPLACEMENT + 3;
        }
        if operands & 4 == 0 {
            return after;
        }
        self.operand = after;
        IS_MODRM
    }

    #[inline(always)]
    fn read_modrm(&mut self, byte: u32) -> u32 {
        let features = &mut self.features;
        features[MODRM] = byte;
        features[OPERAND] = byte & 0xc7;
        // Of what 0xf6 and 0xf7 do, only `test` has an immediate operand.
        if features[OPCODE] & !1 == 0xf6 && byte & 0x30 == 0 {
            self.operand = IMMEDIATE + 3 * (features[OPCODE] & 1);
        }
        let displacement = match (byte >> 6, byte & 7) {
            (0, 5) => RELATIVE_DISPLACEMENT + 3,
            (1, _) => DISPLACEMENT,
            (2, _) => DISPLACEMENT + 3,
            _ => START,
        };
        if byte < 0xc0 && byte & 7 == 4 {
            self.displacement = displacement;
            return IS_SIB;
        }
        displacement
    }

    #[inline(always)]
    fn read_sib(&mut self, byte: u32) -> u32 {
        let features = &mut self.features;
        features[OPERAND] += byte << 8;
        if features[MODRM] < 0x40 && byte & 7 == 5 {
            return DISPLACEMENT + 3;
        }
        self.displacement
    }

    /// Reads a byte of a VEX or EVEX prefix; the first of three or two says the opcode's map.
    #[inline(always)]
    fn read_vex(&mut self, byte: u32, kind: u32) -> u32 {
        let features = &mut self.features;
        if features[PREFIXES] == 0 && kind != VEX {
            features[OPCODE] = (byte & 3) << 8;
        }
        features[PREFIXES] = features[PREFIXES] << 8 | byte;
        if kind == VEX { AFTER_PREFIX } else { kind - 1 }
    }

    #[inline(always)]
    fn end_instruction(&mut self) {
        let features = &mut self.features;
        features.copy_within(OPCODE..HISTORY_END - STEP, OPCODE + STEP);
        features[OPCODE] = 0;
        features[MODRM] = 0;
        features[PREFIXES] = 0;
        features[OPERAND] = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::{KIND, REPEATING, Reader, START, operands, operands_by_runs};

    /// Instructions with every kind of field, as an assembler writes them; the second is how many bytes each has.
    const CODE: [(&[u8], &str); 16] = [
        (&[0xc3], "ret"),
        (&[0x48, 0x89, 0xd8], "mov rax, rbx"),
        (&[0x8b, 0x44, 0x24, 0x08], "mov eax, [rsp + 8]"),
        (&[0x48, 0x8d, 0x05, 1, 2, 3, 4], "lea rax, [rip + ...]"),
        (&[0xe8, 1, 2, 3, 4], "call"),
        (&[0x0f, 0x84, 1, 2, 3, 4], "je"),
        (
            &[0x81, 0x3c, 0x25, 1, 2, 3, 4, 5, 6, 7, 8],
            "cmp dword ptr [...], ...",
        ),
        (&[0xf7, 0xc1, 1, 2, 3, 4], "test ecx, ..."),
        (&[0xf7, 0xd9], "neg ecx"),
        (&[0x49, 0xb8, 1, 2, 3, 4, 5, 6, 7, 8], "movabs r8, ..."),
        (&[0x66, 0xb8, 1, 2], "mov ax, ..."),
        (&[0x66, 0x41, 0xc7, 0x07, 1, 2], "mov word ptr [r15], ..."),
        (&[0xf0, 0x48, 0x0f, 0xc1, 0x07], "lock xadd [rdi], rax"),
        (&[0xc5, 0xf8, 0x28, 0xc1], "vmovaps xmm0, xmm1"),
        (
            &[0xc4, 0xe3, 0x79, 0x0f, 0xc1, 4],
            "vpalignr xmm0, xmm0, xmm1, 4",
        ),
        (
            &[0x62, 0xf1, 0x7c, 0x48, 0x58, 0x05, 1, 2, 3, 4],
            "vaddps zmm0, zmm0, [rip + ...]",
        ),
    ];

    #[test]
    fn instructions_end_where_an_assembler_ends_them() {
        let mut reader = Reader::default();
        for (bytes, name) in CODE {
            for (i, &byte) in bytes.iter().enumerate() {
                reader.read(byte.into());
                let has_ended = reader.feature(KIND) == START;
                assert_eq!(has_ended, i + 1 == bytes.len(), "{name}, byte {i}");
            }
        }
    }

    #[test]
    fn offsets_are_where_an_assembler_puts_them() {
        let mut reader = Reader::default();
        let mut offsets = Vec::new();
        for &byte in CODE.iter().flat_map(|(bytes, _)| bytes.iter()) {
            reader.read(byte.into());
            offsets.extend(reader.ended_offset());
        }
        assert_eq!(offsets, [11, 16, 22, 86]);
    }

    #[test]
    fn runs_hold_what_follows_every_opcode() {
        for opcode in 0..4 << 8 {
            let repeated = if opcode < REPEATING {
                opcode & 7
            } else {
                opcode
            };
            assert_eq!(
                operands_by_runs(opcode, opcode & 0xff),
                operands(repeated >> 8, repeated & 0xff),
                "{opcode:#x}"
            );
        }
    }
}
