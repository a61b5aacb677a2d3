//! The instruction sets of this machine.

use eightfold::Level;

/// An instruction set with its name.
#[derive(Clone, Copy, Debug)]
pub struct Isa {
    pub name: &'static str,
    pub level: Level,
}

/// Those that this machine has, the best first; kernels are made for these alone.
pub fn all() -> impl Iterator<Item = Isa> {
    let best = Level::new();
    let isa = |name, level| Isa { name, level };
    #[cfg(target_arch = "x86_64")]
    let sets = [
        best.as_avx512()
            .map(|simd| isa("avx512", Level::Avx512(simd))),
        best.as_avx2().map(|simd| isa("avx2", Level::Avx2(simd))),
        best.as_sse2().map(|simd| isa("sse2", Level::Sse2(simd))),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let sets = [Some(isa("portable", best))];
    sets.into_iter().flatten()
}

/// The best one.
pub fn best() -> Isa {
    all().next().expect("every machine has its baseline")
}
