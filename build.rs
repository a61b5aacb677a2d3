//! The intro's build: see `src/pack`, which packs it.

fn main() {
    #[cfg(feature = "intro")]
    eightfold_pack::build::main("eightfold");
}
