//! The best instruction set that the processor and the system have.

pub use fearless_simd::Level;

/// The best level that the intro has code for: AVX2 with FMA (x86-64-v3), or the least that the program
/// was compiled for.
///
/// Like `Level::new()`, which needs std and 3 KB, but without AVX-512.
#[must_use]
pub fn level() -> Level {
    #[cfg(target_arch = "x86_64")]
    if has_avx2() {
        // SAFETY: the processor and the system have every feature that the type stands for.
        return Level::Avx2(unsafe { fearless_simd::x86::Avx2::assume_supported() });
    }
    Level::baseline()
}

/// The name of a [level], as people write it.
#[must_use]
pub fn name(level: Level) -> &'static str {
    #[cfg(target_arch = "x86_64")]
    return match level {
        Level::Avx2(_) => "AVX2",
        _ => "SSE2",
    };
    #[cfg(not(target_arch = "x86_64"))]
    if level.is_fallback() {
        "scalar"
    } else {
        "SIMD"
    }
}

/// A word with these bits set.
#[cfg(target_arch = "x86_64")]
const fn bits(mut numbers: &[u32]) -> u32 {
    let mut word = 0;
    while let [number, rest @ ..] = numbers {
        word |= 1 << *number;
        numbers = rest;
    }
    word
}

/// Whether there is x86-64-v3: avx, avx2, bmi1, bmi2, cmpxchg16b, f16c, fma, lzcnt, movbe, popcnt, sse3 to sse4.2, xsave, and
/// YMM registers that the system saves.
#[cfg(target_arch = "x86_64")]
fn has_avx2() -> bool {
    use core::arch::x86_64::{__cpuid, __cpuid_count};
    /// Of leaf 1 ECX. Processors with these have leaf 7.
    const ONE: u32 = bits(&[0, 9, 12, 13, 19, 20, 22, 23, 26, 27, 28, 29]);
    /// Of leaf 7 EBX.
    const SEVEN: u32 = bits(&[3, 5, 8]);
    /// Of leaf 0x80000001 ECX.
    const MORE: u32 = bits(&[5]);
    /// Of the registers that the system saves (XCR0).
    const SAVED: u32 = bits(&[1, 2]);
    if __cpuid(1).ecx & ONE != ONE {
        return false;
    }
    let saved: u32;
    // SAFETY: bit 27 (OSXSAVE) says that the system has allowed `xgetbv`.
    unsafe {
        core::arch::asm!(
            "xgetbv",
            in("ecx") 0,
            out("eax") saved,
            out("edx") _,
            options(nomem, nostack, preserves_flags),
        );
    }
    saved & SAVED == SAVED
        && __cpuid_count(7, 0).ebx & SEVEN == SEVEN
        && __cpuid(0x8000_0001).ecx & MORE == MORE
}

#[cfg(all(test, target_arch = "x86_64"))]
mod tests {
    use std::arch::is_x86_feature_detected as detected;

    #[test]
    fn the_level_is_the_one_that_std_detects() {
        let avx2 = detected!("avx2")
            && detected!("bmi1")
            && detected!("bmi2")
            && detected!("f16c")
            && detected!("fma")
            && detected!("lzcnt")
            && detected!("movbe")
            && detected!("popcnt");
        let name = super::name(super::level());
        assert_eq!(name, if avx2 { "AVX2" } else { "SSE2" });
    }
}
