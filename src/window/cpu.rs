//! The instruction sets that the processor and the system have.

pub use fearless_simd::Level;

/// An instruction set that the tracer has kernels for.
#[derive(Clone, Copy, Debug)]
pub struct Isa {
    /// Its name on a command line.
    pub name: &'static str,
    /// The level by which kernels are chosen.
    pub level: Level,
}

/// The names of all instruction sets that the intro has kernels for on this kind of processor, the best first.
#[cfg(target_arch = "x86_64")]
pub const NAMES: &[&str] = &["avx2", "sse2"];
/// The names of all instruction sets that the intro has kernels for on this kind of processor, the best first.
#[cfg(target_arch = "aarch64")]
pub const NAMES: &[&str] = &["neon"];
/// The names of all instruction sets that the intro has kernels for on this kind of processor, the best first.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
pub const NAMES: &[&str] = &["portable"];

/// The instruction sets that this machine has and the library has kernels for, the best first: those of [`shipped`], and AVX-512.
pub fn instruction_sets() -> impl Iterator<Item = Isa> {
    #[cfg(target_arch = "x86_64")]
    let wide = x86_64::avx512().map(|simd| Isa {
        name: "avx512",
        level: Level::Avx512(simd),
    });
    #[cfg(not(target_arch = "x86_64"))]
    let wide = None;
    wide.into_iter().chain(shipped())
}

/// The instruction sets that this machine has and the intro has kernels for, the best first.
///
/// A kernel for AVX-512 would take 5,100 of the intro's bytes, for a sixth of a frame's time.
pub fn shipped() -> impl Iterator<Item = Isa> {
    let isa = |name, level| Isa { name, level };
    #[cfg(target_arch = "x86_64")]
    let sets = [
        x86_64::avx2().map(|simd| isa("avx2", Level::Avx2(simd))),
        Level::baseline()
            .as_sse2()
            .map(|simd| isa("sse2", Level::Sse2(simd))),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let sets = [Some(isa(NAMES[0], Level::baseline()))];
    sets.into_iter().flatten()
}

/// The instruction set of the intro with a name, if this machine has it.
#[must_use]
pub fn named(name: &str) -> Option<Isa> {
    shipped().find(|isa| isa.name == name)
}

/// The best instruction set of the intro that this machine has.
#[must_use]
pub fn best() -> Isa {
    shipped().next().unwrap_or(Isa {
        name: "portable",
        level: Level::baseline(),
    })
}

/// Features of processors of the kind x86-64, asked for by the instruction CPUID.
///
/// `Level::new()` says the same. It asks by way of std for every feature there is, which takes 1,499 packed bytes of the intro.
#[cfg(target_arch = "x86_64")]
mod x86_64 {
    use core::arch::{
        asm,
        x86_64::{__cpuid, __cpuid_count},
    };
    use fearless_simd::x86::{Avx2, Avx512};

    /// A word with these bits set.
    const fn bits(mut numbers: &[u32]) -> u32 {
        let mut word = 0;
        while let [number, rest @ ..] = numbers {
            word |= 1 << *number;
            numbers = rest;
        }
        word
    }

    /// Whether a word has all bits of another.
    fn has(word: u32, bits: u32) -> bool {
        word & bits == bits
    }

    /// The kinds of registers that the system saves (XCR0). The processor has to have OSXSAVE.
    fn saved_registers() -> u32 {
        let saved: u32;
        // SAFETY: OSXSAVE says that the system allows `xgetbv`.
        unsafe {
            asm!(
                "xgetbv",
                in("ecx") 0,
                out("eax") saved,
                out("edx") _,
                options(nomem, nostack, preserves_flags),
            );
        }
        saved
    }

    /// AVX2, where there is all of x86-64-v3: FMA, BMI1 and BMI2, F16C, LZCNT, MOVBE, and YMM registers that the system saves.
    pub fn avx2() -> Option<Avx2> {
        /// SSE3, SSSE3, FMA, CMPXCHG16B, SSE4.1, SSE4.2, MOVBE, POPCNT, XSAVE, OSXSAVE, AVX and F16C. Processors with these
        /// have leaf 7.
        const LEAF_1_ECX: u32 = bits(&[0, 9, 12, 13, 19, 20, 22, 23, 26, 27, 28, 29]);
        /// BMI1, AVX2 and BMI2.
        const LEAF_7_EBX: u32 = bits(&[3, 5, 8]);
        /// LZCNT.
        const EXTENDED_ECX: u32 = bits(&[5]);
        /// XMM and YMM.
        const SAVED: u32 = bits(&[1, 2]);
        let is_there = has(__cpuid(1).ecx, LEAF_1_ECX)
            && has(saved_registers(), SAVED)
            && has(__cpuid_count(7, 0).ebx, LEAF_7_EBX)
            && has(__cpuid(0x8000_0001).ecx, EXTENDED_ECX);
        // SAFETY: the processor and the system have every feature that the type stands for.
        is_there.then(|| unsafe { Avx2::assume_supported() })
    }

    /// AVX-512, where there is all that a server of the kind Ice Lake has, and ZMM registers that the system saves.
    pub fn avx512() -> Option<Avx512> {
        /// PCLMULQDQ, AES and RDRAND.
        const LEAF_1_ECX: u32 = bits(&[1, 25, 30]);
        /// AVX-512 F, DQ, IFMA, CD, BW and VL; RDSEED, ADX and SHA.
        const LEAF_7_EBX: u32 = bits(&[16, 17, 18, 19, 21, 28, 29, 30, 31]);
        /// AVX-512 VBMI, VBMI2, VNNI, BITALG and VPOPCNTDQ; GFNI, VAES and VPCLMULQDQ.
        const LEAF_7_ECX: u32 = bits(&[1, 6, 8, 9, 10, 11, 12, 14]);
        /// XSAVEOPT, XSAVEC and XSAVES.
        const LEAF_13_EAX: u32 = bits(&[0, 1, 3]);
        /// XMM, YMM, the masks, and both halves of ZMM.
        const SAVED: u32 = bits(&[1, 2, 5, 6, 7]);
        avx2()?;
        let leaf_7 = __cpuid_count(7, 0);
        let is_there = has(saved_registers(), SAVED)
            && has(__cpuid(1).ecx, LEAF_1_ECX)
            && has(leaf_7.ebx, LEAF_7_EBX)
            && has(leaf_7.ecx, LEAF_7_ECX)
            && has(__cpuid_count(13, 1).eax, LEAF_13_EAX);
        // SAFETY: the processor and the system have every feature that the type stands for.
        is_there.then(|| unsafe { Avx512::assume_supported() })
    }

    #[cfg(test)]
    mod tests {
        use std::arch::is_x86_feature_detected as detected;

        #[test]
        fn the_instruction_sets_are_those_that_std_detects() {
            let avx2 = detected!("avx2")
                && detected!("bmi1")
                && detected!("bmi2")
                && detected!("cmpxchg16b")
                && detected!("f16c")
                && detected!("fma")
                && detected!("lzcnt")
                && detected!("movbe")
                && detected!("popcnt")
                && detected!("xsave");
            assert_eq!(super::avx2().is_some(), avx2);
            let avx512 = avx2
                && detected!("adx")
                && detected!("aes")
                && detected!("avx512bitalg")
                && detected!("avx512bw")
                && detected!("avx512cd")
                && detected!("avx512dq")
                && detected!("avx512f")
                && detected!("avx512ifma")
                && detected!("avx512vbmi")
                && detected!("avx512vbmi2")
                && detected!("avx512vl")
                && detected!("avx512vnni")
                && detected!("avx512vpopcntdq")
                && detected!("gfni")
                && detected!("pclmulqdq")
                && detected!("rdrand")
                && detected!("rdseed")
                && detected!("sha")
                && detected!("vaes")
                && detected!("vpclmulqdq")
                && detected!("xsavec")
                && detected!("xsaveopt")
                && detected!("xsaves");
            assert_eq!(super::avx512().is_some(), avx512);
        }
    }
}
