//! Reads x86-64 machine code byte by byte, so that the model knows what the next byte is: an opcode, a part of an address, ...
//!
//! It follows the length of instructions and no more. Bytes that are no instructions are read as some, which does no harm: whatever
//! it says is only a context to predict by, and both sides say the same.

use super::operands::operands_by_runs;

/// The number of features by which the model predicts a byte. Contexts are sets of features. Features 0 to 3 are the last bytes, the
/// newest first. There is room for some more: a power of two.
pub const FEATURES: usize = 32;
/// How many of the last bytes are kept.
const LAST: usize = 4;
/// The feature that is the kind of the next byte; see the kinds below.
pub const KIND: usize = 4;
/// The opcode of this instruction so far, plus 0x100 times its map, plus 0x400 times what `pp` is in VEX, by whatever prefixes that
/// is said: so an operation has one number in SSE2, AVX2 and AVX-512. Those of the three instructions before follow it in steps of
/// [`STEP`], as those of the three features after it do of two.
pub const OPCODE: usize = 5;
/// The ModRM byte, which names a register and an operand.
pub const MODRM: usize = 6;
/// All prefixes, 8 bits each.
pub const PREFIXES: usize = 7;
/// The operand that is written to: known of earlier instructions only.
pub const DESTINATION: usize = 8;
/// Features that are kept of each instruction.
const STEP: usize = 4;
/// The end of those.
const HISTORY_END: usize = OPCODE + 3 * STEP + 1;
/// The place modulo 4: data has rows of words.
pub const PLACE: usize = HISTORY_END;
/// Which 256 bytes the place is in: many jumps end nearby.
pub const PAGE: usize = 19;
/// How many bytes ahead the next place is that a jump or call led to, at most [`FAR`]: an instruction begins there, and the one
/// before often is a jump.
pub const TARGET: usize = 20;
/// The ModRM byte's operand, and what the SIB byte adds to it.
pub const OPERAND: usize = 21;
/// The bits of prefixes that extend the numbers of registers: 8 that of ModRM's register, 2 that of its operand.
pub const EXTENSION: usize = 22;
/// The first byte of this instruction, without the bits that may extend registers.
pub const FIRST: usize = 23;
/// Bytes of this instruction so far.
pub const LENGTH: usize = 24;
/// The register that VEX and EVEX name.
pub const SOURCE: usize = 25;
/// How many of the last bytes were the same before what [`AFTER_MATCH`] is, at most [`LONGEST_MATCH`], as a multiple of 0x100.
pub const MATCH: usize = 26;
/// The last two bytes that were of this kind behind the same opcode, the newer in the lower bits.
pub const SAME_OPCODE: usize = 27;
/// The same behind the same operand.
pub const SAME_OPERAND: usize = 28;
/// The byte that followed when the last bytes were here before.
pub const AFTER_MATCH: usize = 29;

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
/// A byte behind the first one of a VEX or EVEX prefix: there are at most three.
const VEX: u32 = 4;
const DISPLACEMENT: u32 = 8;
/// A displacement from the next instruction.
const RELATIVE_DISPLACEMENT: u32 = 12;
const IMMEDIATE: u32 = 16;
/// The offset of a jump or call.
const RELATIVE_JUMP: u32 = 20;
/// More than the highest kind.
pub const MORE_KINDS: u32 = RELATIVE_JUMP + 4;
/// A power of two above that.
pub const KINDS: usize = 32;

/// The features by which fields of instructions are told apart, besides their kinds.
const FIELD_FEATURES: [usize; 2] = [OPCODE, OPERAND];
/// Fields of all instructions: for each map, `pp` and opcode, each kind. (Of operands, the upper bits of SIB are left out.)
const FIELDS: usize = 0x1000 << KINDS.ilog2();

/// The most that [`TARGET`] is.
const FAR: u32 = 7;
/// How far jumps lead to places that are remembered. (Offsets of four bytes are addresses here.)
const TARGETS: usize = 1 << 16;

/// How many bytes are kept, as the intro has 200 kB; of a longer program, some are taken for others.
const BYTES: usize = 1 << 18;
/// Bits of a hash of three bytes.
const PLACES: u32 = 16;
/// Whether as many bytes or more were the same is of no matter.
const LONGEST_MATCH: u32 = 15;

/// The state of reading, all zero to begin with. Its largest part comes last: instructions reach the others by offsets of one byte.
#[repr(C)]
pub struct Reader {
    /// Bytes read so far.
    place: u32,
    /// Where the offset of this instruction is, behind its opcode; 0 if it has none.
    offset: u32,
    /// The kind of the displacement that follows a SIB byte.
    displacement: u32,
    /// The kind of what follows ModRM, SIB and displacement; 0 for nothing.
    operand: u32,
    /// The fields of the next byte.
    next: [u32; FIELD_FEATURES.len()],
    /// Where [`AFTER_MATCH`] was.
    matching: u32,
    features: [u32; FEATURES],
    /// All bytes, at their place modulo their number.
    bytes: [u8; BYTES],
    /// Behind three bytes, by a hash of these: where that was last.
    places: [u32; 1 << PLACES],
    /// Where jumps lead to, for each place modulo their number: 1 or 0.
    targets: [u8; TARGETS],
    /// The last two bytes of each field.
    fields: [[u16; FIELDS]; FIELD_FEATURES.len()],
}

impl Reader {
    /// A feature of the next byte.
    #[inline(always)]
    pub fn feature(&self, number: usize) -> u32 {
        self.features[number % FEATURES]
    }

    /// Where an instruction that has just ended has the four bytes of an offset from its end to something else. It says so once.
    #[inline(always)]
    pub fn ended_offset(&mut self) -> Option<usize> {
        if self.feature(KIND) != START {
            return None;
        }
        let offset = core::mem::take(&mut self.offset);
        (offset != 0).then_some(offset as usize)
    }

    /// Reads the next byte.
    #[inline(never)]
    pub fn read(&mut self, byte: u32) {
        // Take the byte, and go on by one place.
        let features = &mut self.features;
        features.copy_within(0..LAST - 1, 1);
        features[0] = byte;
        features[LENGTH] += 1;
        let kind = features[KIND];
        // The first byte of either.
        if kind & 7 == (RELATIVE_DISPLACEMENT + 3) & (RELATIVE_JUMP + 3) {
            self.offset = self.place;
        }
        self.targets[self.place as usize % TARGETS] = 0;
        self.place += 1;
        features[PLACE] = self.place & 3;
        features[PAGE] = self.place >> 8;
        // Find the kind of the byte that follows.
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
            self.mark_target(byte, kind);
            self.end_instruction();
        }
        self.features[KIND] = next;
        // Find how far the next target of a jump is.
        let mut distance = 0;
        while distance < FAR && self.targets[(self.place + distance) as usize % TARGETS] == 0 {
            distance += 1;
        }
        self.features[TARGET] = distance;
        // Find where the last bytes were before, and what followed in the same fields.
        self.find_match(byte);
        for (i, &feature) in FIELD_FEATURES.iter().enumerate() {
            let field = &mut self.fields[i][self.next[i] as usize % FIELDS];
            *field = *field << 8 | byte as u16;
            self.next[i] = self.feature(feature) << KINDS.ilog2() | next;
            self.features[SAME_OPCODE + i] = self.fields[i][self.next[i] as usize % FIELDS].into();
        }
    }

    /// Reads a prefix or an opcode. Returns what kind of byte follows, as all of these do.
    #[inline(always)]
    fn read_opcode(&mut self, byte: u32) -> u32 {
        let features = &mut self.features;
        if features[FIRST] == 0 {
            features[FIRST] = byte & 0xf8;
        }
        // Note escapes and prefixes, behind which an opcode follows.
        if features[OPCODE] & 0x300 == 0 {
            let escape = match byte {
                0x0f => AFTER_PREFIX,
                0xc5 => VEX,
                0xc4 => VEX + 1,
                0x62 => VEX + 2,
                _ => 0,
            };
            if escape != 0 {
                // Map 1, unless VEX says another.
                features[OPCODE] += 0x100;
                return escape;
            }
            // `lock` and the like, `fs`, 0x66, `cs`.
            let is_other = byte & 0xfc == 0xf0 || byte & 0xfd == 0x64 || byte == 0x2e;
            if byte & 0xf0 == 0x40 || is_other {
                features[PREFIXES] = features[PREFIXES] << 8 | byte;
                if byte & 0xf0 == 0x40 {
                    features[EXTENSION] = (byte & 7) << 1;
                } else {
                    // 1, 2 and 3 for 0x66, 0xf3 and 0xf2.
                    features[OPCODE] = 0x10b0 >> ((byte & 7) * 2) << 10 & 0xc00;
                }
                return AFTER_PREFIX;
            }
        }
        // Look up the operands of the opcode.
        features[OPCODE] += byte;
        let opcode = features[OPCODE] & 0x3ff;
        let operands = operands_by_runs(opcode, byte);
        let after = match operands & 3 {
            0 => START,
            1 => IMMEDIATE,
            // Two bytes of it, where a prefix says so.
            2 if features[OPCODE] & 0xc00 == 0x400 => IMMEDIATE + 1,
            2 => IMMEDIATE + 3,
            _ => RELATIVE_JUMP + 3,
        };
        if opcode & !7 == 0xb8 && features[PREFIXES] & 0xf8 == 0x48 {
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

    /// Reads a byte of a VEX or EVEX prefix.
    #[inline(always)]
    fn read_vex(&mut self, byte: u32, kind: u32) -> u32 {
        let features = &mut self.features;
        let is_first = features[PREFIXES] == 0;
        if is_first {
            features[EXTENSION] = !byte >> 4 & if kind == VEX { 8 } else { 15 };
        }
        if is_first && kind != VEX {
            features[OPCODE] = (byte & 3) << 8;
        } else {
            // The last byte of EVEX has no `pp`, but zeros there unless a mask is used.
            features[OPCODE] |= (byte & 3) << 10;
            // The third byte of EVEX has no register, but is nearly always the same.
            features[SOURCE] += byte & 0x78;
        }
        features[PREFIXES] = features[PREFIXES] << 8 | byte;
        if kind == VEX { AFTER_PREFIX } else { kind - 1 }
    }

    /// Finds where the last bytes were before.
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

    /// Remembers where an instruction leads to that ends with this byte.
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
        let reader = &mut new_model().reader;
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
        let reader = &mut new_model().reader;
        let mut offsets = Vec::new();
        for &byte in CODE.iter().flat_map(|(bytes, _)| bytes.iter()) {
            reader.read(byte.into());
            offsets.extend(reader.ended_offset());
        }
        assert_eq!(offsets, [11, 16, 22, 86]);
    }
}
