//! The intro's build.

fn main() {
    println!("cargo::rustc-check-cfg=cfg(diet)");
}
