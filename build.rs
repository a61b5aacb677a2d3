//! The intro's build: see `src/pack`, which packs it.

fn main() {
    eightfold_pack::build::main("eightfold");
}
