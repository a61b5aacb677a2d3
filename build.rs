//! The intro's build: see `src/pack`, which packs it.

fn main() {
    #[cfg(all(feature = "intro", target_arch = "x86_64"))]
    eightfold_pack::build::main("eightfold");
}
