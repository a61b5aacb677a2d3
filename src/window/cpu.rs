pub use fearless_simd::Level;

#[derive(Clone, Copy, Debug)]
pub struct Isa {
    pub name: &'static str,
    pub level: Level,
}

/// Whether the intro has kernels for the baseline instruction set, for processors without AVX2.
pub const HAS_BASELINE: bool = cfg!(any(
    feature = "sse2",
    feature = "portable",
    not(all(target_os = "linux", target_arch = "x86_64"))
));

/// Returns this machine's instruction sets with kernels in the library, best first.
pub fn instruction_sets() -> impl Iterator<Item = Isa> {
    #[cfg(target_arch = "x86_64")]
    let wide =
        Level::new().as_avx512().map(|simd| Isa { name: "avx512", level: Level::Avx512(simd) });
    #[cfg(not(target_arch = "x86_64"))]
    let wide = None;
    wide.into_iter().chain(avx2()).chain([baseline()])
}

/// Returns this machine's instruction sets with kernels in the intro, best first; `docs/size.md`
/// has the cost of others.
pub fn shipped() -> impl Iterator<Item = Isa> {
    let baseline = if HAS_BASELINE { Some(baseline()) } else { None };
    avx2().into_iter().chain(baseline)
}

#[must_use]
pub fn named(name: &[u8]) -> Option<Isa> {
    shipped().find(|isa| isa.name.as_bytes() == name)
}

/// Returns the instruction set that measurements use: AVX2, as the intro, or the baseline.
#[must_use]
pub fn best() -> Isa {
    avx2().unwrap_or(baseline())
}

fn avx2() -> Option<Isa> {
    #[cfg(target_arch = "x86_64")]
    return x86_64::avx2().map(|simd| Isa { name: "avx2", level: Level::Avx2(simd) });
    #[cfg(not(target_arch = "x86_64"))]
    None
}

fn baseline() -> Isa {
    Isa {
        name: cfg_select! {
            target_arch = "x86_64" => "sse2",
            target_arch = "aarch64" => "neon",
            _ => "portable",
        },
        level: Level::baseline(),
    }
}

/// Returns a word with these bits.
pub(crate) const fn bits(mut numbers: &[i32]) -> u64 {
    let mut word = 0;
    while let [number, rest @ ..] = numbers {
        word |= 1 << *number;
        numbers = rest;
    }
    word
}

/// Features of x86-64 processors, from CPUID. `Level::new()` asks std, for 1,499 packed bytes.
#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use core::arch::x86_64::{__cpuid, __cpuid_count, _xgetbv};
    use fearless_simd::x86::Avx2;

    use super::bits;

    fn has(word: u32, bits: u64) -> bool {
        word & bits as u32 == bits as u32
    }

    /// Returns AVX2 if the machine has all of x86-64-v3, and the system saves YMM registers.
    pub fn avx2() -> Option<Avx2> {
        /// SSE3, SSSE3, FMA, CMPXCHG16B, SSE4.1, SSE4.2, MOVBE, POPCNT, XSAVE, OSXSAVE, AVX and
        /// F16C. Processors with these have leaf 7.
        const LEAF_1_ECX: u64 = bits(&[0, 9, 12, 13, 19, 20, 22, 23, 26, 27, 28, 29]);
        /// BMI1, AVX2 and BMI2.
        const LEAF_7_EBX: u64 = bits(&[3, 5, 8]);
        /// LZCNT.
        const EXTENDED_ECX: u64 = bits(&[5]);
        /// XMM and YMM.
        const SAVED: u64 = bits(&[1, 2]);
        let is_there = has(__cpuid(1).ecx, LEAF_1_ECX)
            // SAFETY: OSXSAVE allows it.
            && has(unsafe { _xgetbv(0) } as u32, SAVED)
            && has(__cpuid_count(7, 0).ebx, LEAF_7_EBX)
            && has(__cpuid(0x8000_0001).ecx, EXTENDED_ECX);
        // SAFETY: the processor and the system have all features of the type.
        is_there.then(|| unsafe { Avx2::assume_supported() })
    }

    #[cfg(test)]
    mod tests {
        use fearless_simd::Level;

        #[test]
        fn avx2_matches_std_detection() {
            assert_eq!(super::avx2().is_some(), Level::new().as_avx2().is_some());
        }
    }
}
