//! The intro's build script.
//!
//! It compiles the stub, and makes rustc's C compiler call a copy of the script in `OUT_DIR/linker`
//! as the linker. Under this name, the script runs the real linker, and packs the output in place.
//! A file `*.unpacked` next to it keeps the symbols for debuggers and [`costs`](crate::costs). A
//! program that cannot be packed is left as linked, with a warning; for Windows this is an error.

mod linker;
mod order;
mod redirect;
mod toolchain;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};

use crate::Error;
use linker::{LINKER_VARIABLE, STUB, SYSTEM_VARIABLE};
use toolchain::Toolchain;

const LINKER: &str = "ld.bfd";

const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

pub fn main(program: &str) {
    let arguments: Vec<_> = env::args_os().collect();
    if let [own, rest @ ..] = &arguments[..]
        && Path::new(own).file_name() == Some(LINKER.as_ref())
    {
        std::process::exit(linker::run(rest));
    }
    println!("cargo::rerun-if-changed={SOURCE}");
    // Only release builds without minifb, which exceeds the limit, are packed.
    let is_portable = env::var_os("CARGO_FEATURE_PORTABLE").is_some()
        || ["TARGET_OS", "TARGET_ARCH"].map(|part| env::var(format!("CARGO_CFG_{part}")).ok())
            != ["linux", "x86_64"].map(|name| Some(name.to_owned()));
    if is_portable || env::var("PROFILE").is_ok_and(|profile| profile != "release") {
        return;
    }
    if let Err(error) = prepare(program) {
        println!("cargo::warning={program} is not packed, and contains all of std: {error}");
    }
}

fn at<T>(path: impl AsRef<Path>, done: io::Result<T>) -> Result<T, Error> {
    done.map_err(|why| format!("{}: {why}", path.as_ref().display()).into())
}

fn variable(name: &str) -> Result<String, Error> {
    env::var(name).map_err(|_| format!("{name} is unset or not UTF-8").into())
}

fn prepare(program: &str) -> Result<(), Error> {
    let toolchain = Toolchain::find()?;
    let output = PathBuf::from(variable("OUT_DIR")?);
    let is_for_windows = env::var_os("CARGO_FEATURE_WINDOWS").is_some();
    let system = if is_for_windows { "windows" } else { "linux" };
    let directory = output.join("linker");
    at(&directory, fs::create_dir_all(&directory))?;
    let linker = directory.join(LINKER);
    at(&linker, fs::copy(env::current_exe()?, &linker))?;
    compile_stub(&toolchain, system, &directory.join(STUB))?;
    println!("cargo::rustc-env={LINKER_VARIABLE}={}", toolchain.linker);
    println!("cargo::rustc-env={SYSTEM_VARIABLE}={system}");
    let for_system: &[&str] = if is_for_windows {
        &[
            "-Wl,--no-dynamic-linker",
            // Leaves space for the packed file, which begins at 0x400000.
            &format!("-Wl,{}=0x420000", toolchain.base()),
        ]
    } else {
        // Binds functions at the start, without the code for lazy binding.
        &["-Wl,-z,now"]
    };
    let for_all = [
        "-nostartfiles",
        "-Wl,--entry=eightfold_start",
        // Fixed addresses need no relocations.
        "-no-pie",
        // Pages of 4 KB keep the gaps between segments short.
        "-Wl,-z,max-page-size=4096",
        "-Wl,--build-id=none",
        &format!("-B{}", directory.display()),
        // The last option selects the linker by its suffix.
        &format!("-fuse-ld={}", &LINKER[3..]),
    ];
    for argument in for_all.iter().chain(for_system) {
        println!("cargo::rustc-link-arg-bin={program}={argument}");
    }
    Ok(())
}

fn compile_stub(toolchain: &Toolchain, system: &str, object: &Path) -> Result<(), Error> {
    let source = Path::new(SOURCE).join("stub").join(system).join("main.rs");
    let done = Command::new(&toolchain.rustc)
        .args("--edition=2024 --crate-type=bin --crate-name=stub --emit=obj".split(' '))
        .args(["--target", toolchain::TARGET])
        .args(
            "-Cpanic=abort -Cjump-tables=no -Crelocation-model=static -Ccodegen-units=1".split(' '),
        )
        // `s` inlines loops over iterators, which `z` does not.
        .arg("-Copt-level=s")
        // Windows may overwrite memory below the stack pointer.
        .args((system == "windows").then_some("-Cno-redzone=yes"))
        .arg("-o")
        .args([object, &source])
        .status();
    let status = at(&toolchain.rustc, done)?;
    if !status.success() {
        return Err(format!("{}: rustc failed: {status}", source.display()).into());
    }
    Ok(())
}
