//! Parses x86-64 machine code byte by byte, only for the lengths and fields of instructions; data
//! is parsed like code.

use super::operands::operands_by_runs;

/// The number of features, a power of two; some are unused. Features 0 to 3 are the last bytes,
/// newest first.
pub const FEATURES: usize = 32;
const LAST: usize = 4;
pub const KIND: usize = 4;
/// The opcode as far as it is parsed, plus 0x100 times its map, plus 0x400 times its prefix.
/// Prefixes have the numbers of VEX's `pp`, so an operation has the same value in SSE2 and AVX2.
/// The features after this one have the opcodes of the three previous instructions, newest first,
/// one every [`STEP`] features; between them are ModRM, prefixes and destination.
pub const OPCODE: usize = 5;
pub const MODRM: usize = 6;
pub const PREFIXES: usize = 7;
/// The destination operand, of previous instructions only.
pub const DESTINATION: usize = 8;
const STEP: usize = 4;
const HISTORY_END: usize = OPCODE + 3 * STEP + 1;
/// The position modulo 4, for tables of 32-bit words.
pub const PLACE: usize = HISTORY_END;
/// The distance to the next target of an earlier jump or call, at most [`FAR`].
pub const TARGET: usize = 19;
pub const OPERAND: usize = 20;
/// The register extension bits of prefixes: 8 for ModRM's register, 2 for its operand.
pub const EXTENSION: usize = 21;
/// The instruction's first byte, without the bits that may extend registers.
pub const FIRST: usize = 22;
pub const LENGTH: usize = 23;
/// 0x100 times the number of newest bytes, at most [`LONGEST_MATCH`], that also precede the byte in
/// [`AFTER_MATCH`].
pub const MATCH: usize = 24;
/// The two newest bytes of the next byte's kind in instructions with the same opcode. The newer is
/// in the lower bits.
pub const SAME_OPCODE: usize = 25;
/// The last two bytes after the same operand.
pub const SAME_OPERAND: usize = 26;
/// The byte that followed the newest bytes at their previous occurrence.
pub const AFTER_MATCH: usize = 27;

pub const fn before(feature: usize, instructions: usize) -> usize {
    feature + instructions * STEP
}

// Kinds of bytes. In a field of several bytes the kind counts down.
const START: u32 = 0;
const AFTER_PREFIX: u32 = 1;
const IS_MODRM: u32 = 2;
const IS_SIB: u32 = 3;
/// One or two bytes after the first of a VEX prefix. The intro has no EVEX prefixes.
const VEX: u32 = 4;
const DISPLACEMENT: u32 = 8;
const RELATIVE_DISPLACEMENT: u32 = 12;
const IMMEDIATE: u32 = 16;
const RELATIVE_JUMP: u32 = 20;
pub const MORE_KINDS: u32 = RELATIVE_JUMP + 4;
pub const KINDS: usize = 32;

/// Features that, with the kind, identify a field.
const FIELD_FEATURES: [usize; 2] = [OPCODE, OPERAND];
/// The number of fields: one per kind and 12-bit value of a feature. [`OPCODE`] has 12 bits; of
/// [`OPERAND`] the upper bits of SIB are dropped.
const FIELDS: usize = 0x1000 << KINDS.ilog2();

const FAR: u32 = 7;
/// The maximum distance of remembered jumps.
const TARGETS: usize = 1 << 16;

/// The size of the byte history; the intro has 200 kB. Longer programs wrap around.
const BYTES: usize = 1 << 18;
const PLACES: u32 = 16;
const LONGEST_MATCH: u32 = 15;

/// The parser's state, initially zero. Small fields are first, for 8-bit offsets.
#[repr(C)]
pub struct Reader {
    place: u32,
    /// The position of the instruction's relative offset; 0 without one.
    offset: u32,
    displacement: u32,
    /// The kind of the immediate after ModRM, SIB and displacement; 0 without one.
    operand: u32,
    next: [u32; FIELD_FEATURES.len()],
    matching: u32,
    features: [u32; FEATURES],
    /// The byte history, by position modulo its size.
    bytes: [u8; BYTES],
    /// The last position of each three-byte hash.
    places: [u32; 1 << PLACES],
    /// 1 for jump targets, by position modulo the size.
    targets: [u8; TARGETS],
    fields: [[u16; FIELDS]; FIELD_FEATURES.len()],
}

impl Reader {
    #[inline(always)]
    pub fn feature(&self, number: usize) -> u32 {
        self.features[number % FEATURES]
    }

    /// Returns the position of the four-byte relative offset in the instruction that has just
    /// ended. A second call returns `None`.
    #[inline(always)]
    pub fn ended_offset(&mut self) -> Option<usize> {
        if self.feature(KIND) != START {
            return None;
        }
        let offset = core::mem::take(&mut self.offset);
        (offset != 0).then_some(offset as usize)
    }

    #[inline(never)]
    pub fn read(&mut self, byte: u32) {
        let features = &mut self.features;
        features.copy_within(0..LAST - 1, 1);
        features[0] = byte;
        features[LENGTH] += 1;
        let kind = features[KIND];
        // The first byte of a relative displacement or jump.
        if kind & 7 == (RELATIVE_DISPLACEMENT + 3) & (RELATIVE_JUMP + 3) {
            self.offset = self.place;
        }
        self.targets[self.place as usize % TARGETS] = 0;
        self.place += 1;
        features[PLACE] = self.place & 3;
        let mut next = match kind {
            START | AFTER_PREFIX => self.read_opcode(byte),
            IS_MODRM => self.read_modrm(byte),
            IS_SIB => self.read_sib(byte),
            VEX..DISPLACEMENT => self.read_vex(byte, kind),
            // In a field, kinds count down to a multiple of 4.
            _ if kind & 3 == 0 => START,
            _ => kind - 1,
        };
        if next == START && kind < IMMEDIATE {
            next = self.operand;
            self.operand = START;
        }
        if next == START {
            self.mark_target(byte, kind);
            self.end_instruction();
        }
        self.features[KIND] = next;
        let mut distance = 0;
        while distance < FAR && self.targets[(self.place + distance) as usize % TARGETS] == 0 {
            distance += 1;
        }
        self.features[TARGET] = distance;
        self.find_match(byte);
        for (i, &feature) in FIELD_FEATURES.iter().enumerate() {
            let field = &mut self.fields[i][self.next[i] as usize % FIELDS];
            *field = *field << 8 | byte as u16;
            self.next[i] = self.feature(feature) << KINDS.ilog2() | next;
            self.features[SAME_OPCODE + i] = self.fields[i][self.next[i] as usize % FIELDS].into();
        }
    }

    /// Parses a prefix or an opcode. Returns the next byte's kind, like the functions below.
    #[inline(always)]
    fn read_opcode(&mut self, byte: u32) -> u32 {
        let features = &mut self.features;
        if features[FIRST] == 0 {
            features[FIRST] = byte & 0xf8;
        }
        if features[OPCODE] & 0x300 == 0 {
            let escape = match byte {
                0x0f => AFTER_PREFIX,
                0xc5 => VEX,
                0xc4 => VEX + 1,
                _ => 0,
            };
            if escape != 0 {
                // Map 1, unless VEX overrides it.
                features[OPCODE] += 0x100;
                return escape;
            }
            // `lock`, `rep`, segments, 0x66.
            let is_other = byte & 0xfc == 0xf0 || byte & 0xfd == 0x64 || byte == 0x2e;
            if byte & 0xf0 == 0x40 || is_other {
                features[PREFIXES] = features[PREFIXES] << 8 | byte;
                if byte & 0xf0 == 0x40 {
                    features[EXTENSION] = (byte & 7) << 1;
                } else {
                    // 1, 2 and 3 for 0x66, 0xf3 and 0xf2; rare segment prefixes get wrong numbers.
                    features[OPCODE] = 0x10b0 >> ((byte & 7) * 2) << 10 & 0xc00;
                }
                return AFTER_PREFIX;
            }
        }
        features[OPCODE] += byte;
        let opcode = features[OPCODE] & 0x3ff;
        let operands = operands_by_runs(opcode, byte);
        let after = match operands & 3 {
            0 => START,
            1 => IMMEDIATE,
            // Two bytes with prefix 0x66.
            2 if features[OPCODE] & 0xc00 == 0x400 => IMMEDIATE + 1,
            2 => IMMEDIATE + 3,
            _ => RELATIVE_JUMP + 3,
        };
        if opcode & !7 == 0xb8 && features[PREFIXES] & 0xf8 == 0x48 {
            // Parse the 8-byte constant of `mov` as a displacement and an immediate.
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
        // In group 0xf6 and 0xf7, only `test` has an immediate.
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

    #[inline(always)]
    fn read_vex(&mut self, byte: u32, kind: u32) -> u32 {
        let features = &mut self.features;
        if kind == VEX {
            if features[PREFIXES] == 0 {
                features[EXTENSION] = !byte >> 4 & 8;
            }
            features[OPCODE] |= (byte & 3) << 10;
        } else {
            features[EXTENSION] = !byte >> 4 & 15;
            features[OPCODE] = (byte & 3) << 8;
        }
        features[PREFIXES] = features[PREFIXES] << 8 | byte;
        if kind == VEX { AFTER_PREFIX } else { kind - 1 }
    }

    #[inline(always)]
    fn find_match(&mut self, byte: u32) {
        let is_expected = self.features[AFTER_MATCH] == byte;
        self.bytes[self.place.wrapping_sub(1) as usize % BYTES] = byte as u8;
        let [a, b, c, ..] = self.features;
        let hash = (a | b << 8 | c << 16).wrapping_mul(0x9e37_79b1) >> (u32::BITS - PLACES);
        let last = &mut self.places[hash as usize];
        if is_expected {
            self.matching = self.matching.wrapping_add(1);
            self.features[MATCH] = (self.features[MATCH] + 0x100).min(LONGEST_MATCH << 8);
        } else {
            self.matching = *last;
            self.features[MATCH] = 0;
            let (mut there, mut here) = (*last, self.place);
            while self.features[MATCH] < LONGEST_MATCH << 8 {
                (there, here) = (there.wrapping_sub(1), here.wrapping_sub(1));
                if self.bytes[there as usize % BYTES] != self.bytes[here as usize % BYTES] {
                    break;
                }
                self.features[MATCH] += 0x100;
            }
        }
        *last = self.place;
        self.features[AFTER_MATCH] = self.bytes[self.matching as usize % BYTES].into();
    }

    #[inline(always)]
    fn mark_target(&mut self, byte: u32, kind: u32) {
        let features = &self.features;
        let distance = if kind == RELATIVE_JUMP {
            let [a, b, c, d, ..] = *features;
            (a << 24 | b << 16 | c << 8 | d).wrapping_sub(self.place)
        } else if features[OPCODE] & !0xf == 0x70 || features[OPCODE] == 0xeb {
            byte as i8 as u32
        } else {
            return;
        };
        if distance < TARGETS as u32 {
            self.targets[(self.place + distance) as usize % TARGETS] = 1;
        }
    }

    #[inline(always)]
    fn end_instruction(&mut self) {
        let features = &mut self.features;
        features[DESTINATION] =
            if features[OPCODE] < 0x100 && !matches!(features[OPCODE], 0x8b | 0x8d) {
                features[MODRM] & 0xc7 | (features[EXTENSION] & 2) << 2
            } else {
                features[MODRM] >> 3 & 7 | 0xc0 | features[EXTENSION] & 8
            };
        features.copy_within(OPCODE..HISTORY_END - STEP, OPCODE + STEP);
        features[OPCODE..OPCODE + STEP].fill(0);
        features[OPERAND..MATCH].fill(0);
    }
}

#[cfg(test)]
mod tests {
    use super::{KIND, START};
    use crate::new_model;

    /// Instructions with every kind of field, as an assembler encodes them.
    #[rustfmt::skip]
    const CODE: [(&[u8], &str); 15] = [
        (&[0xc3], "ret"),
        (&[0x48, 0x89, 0xd8], "mov rax, rbx"),
        (&[0x8b, 0x44, 0x24, 0x08], "mov eax, [rsp + 8]"),
        (&[0x48, 0x8d, 0x05, 1, 2, 3, 4], "lea rax, [rip + ...]"),
        (&[0xe8, 1, 2, 3, 4], "call"),
        (&[0x0f, 0x84, 1, 2, 3, 4], "je"),
        (&[0x81, 0x3c, 0x25, 1, 2, 3, 4, 5, 6, 7, 8], "cmp dword ptr [...], ..."),
        (&[0xf7, 0xc1, 1, 2, 3, 4], "test ecx, ..."),
        (&[0xf7, 0xd9], "neg ecx"),
        (&[0x49, 0xb8, 1, 2, 3, 4, 5, 6, 7, 8], "movabs r8, ..."),
        (&[0x66, 0xb8, 1, 2], "mov ax, ..."),
        (&[0x66, 0x41, 0xc7, 0x07, 1, 2], "mov word ptr [r15], ..."),
        (&[0xf0, 0x48, 0x0f, 0xc1, 0x07], "lock xadd [rdi], rax"),
        (&[0xc5, 0xf8, 0x28, 0xc1], "vmovaps xmm0, xmm1"),
        (&[0xc4, 0xe3, 0x79, 0x0f, 0xc1, 4], "vpalignr xmm0, xmm0, xmm1, 4"),
    ];

    #[test]
    fn instruction_lengths_and_offsets_match_assembler() {
        let reader = &mut new_model().reader;
        let mut offsets = Vec::new();
        for (bytes, name) in CODE {
            for (i, &byte) in bytes.iter().enumerate() {
                reader.read(byte.into());
                let has_ended = reader.feature(KIND) == START;
                assert_eq!(has_ended, i + 1 == bytes.len(), "{name}, byte {i}");
                offsets.extend(reader.ended_offset());
            }
        }
        assert_eq!(offsets, [11, 16, 22]);
    }
}
