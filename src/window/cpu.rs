//! The instruction sets that the processor and the system have.

pub use fearless_simd::Level;

/// An instruction set that the tracer has kernels for.
#[derive(Clone, Copy, Debug)]
pub struct Isa {
    /// Its name on a command line.
    pub name: &'static str,
    /// What kernels are chosen by.
    pub level: Level,
}

/// The names of all instruction sets that there are kernels for on this kind of processor, the best first.
#[cfg(target_arch = "x86_64")]
pub const NAMES: &[&str] = &["avx512", "avx2", "sse2"];
/// The names of all instruction sets that there are kernels for on this kind of processor, the best first.
#[cfg(not(target_arch = "x86_64"))]
pub const NAMES: &[&str] = &["portable"];

/// The instruction sets that this machine has, the best first.
pub fn instruction_sets() -> impl Iterator<Item = Isa> {
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

/// The instruction set with a name, if this machine has it.
#[must_use]
pub fn named(name: &str) -> Option<Isa> {
    instruction_sets().find(|isa| isa.name == name)
}

/// The best instruction set that this machine has.
#[must_use]
pub fn best() -> Isa {
    instruction_sets().next().unwrap_or(Isa {
        name: "portable",
        level: Level::baseline(),
    })
}
