//! The intro's build script: it has the linker called by way of this program.
//!
//! `cargo build --release` compiles the script, which Cargo runs: it compiles the stub, and says how to link the intro. Rust calls
//! a C compiler for that, which is told to take its linker from `OUT_DIR/linker`: there, the script's own executable has the name
//! of one. Called by that name, it runs the linker that would have been called, and packs what came of it in place.
//!
//! In the script's `OUT_DIR` are then
//!
//! | file | what |
//! | --- | --- |
//! | `eightfold-*.unpacked` | the program of that name in `deps`, not packed, with its symbols: [`costs`](crate::costs) tells what its parts take packed |
//! | `eightfold.map` | what the linker has put where in the latest |
//! | `linker/` | the linker that packs, and the stub |
//!
//! Debuggers and profilers take the program that is not packed. Where a program can't be packed, it is linked as any other, and one warning says why.

mod diet;
mod linker;
mod order;
mod toolchain;

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::{Error, System, Version};
use toolchain::Toolchain;

/// The name by which a C compiler finds a linker, and by which this program knows that it is called for one.
const LINKER: &str = "ld.bfd";

/// Where this crate is, with the stub's source.
const SOURCE: &str = env!("CARGO_MANIFEST_DIR");

/// Runs as the build script of a package with a program, or as the linker of that.
pub fn main(program: &str) {
    let arguments: Vec<_> = env::args_os().collect();
    if let [own, rest @ ..] = &arguments[..]
        && Path::new(own).file_name() == Some(LINKER.as_ref())
    {
        std::process::exit(linker::run(rest));
    }
    println!("cargo::rerun-if-changed={SOURCE}");
    // Unoptimised, nobody minds the size; nor where the window is by minifb, which alone is larger.
    let is_portable = env::var_os("CARGO_FEATURE_PORTABLE").is_some()
        || ["TARGET_OS", "TARGET_ARCH"].map(|part| env::var(format!("CARGO_CFG_{part}")).ok())
            != ["linux", "x86_64"].map(|name| Some(name.to_owned()));
    if is_portable || env::var("PROFILE").is_ok_and(|profile| profile != "release") {
        return;
    }
    if let Err(error) = prepare(program) {
        println!(
            "cargo::warning={program} is built with all of std that it does not need, and not packed: {error}"
        );
    }
}

/// Says how the program is linked.
fn prepare(program: &str) -> Result<(), Error> {
    let toolchain = Toolchain::find()?;
    let output = PathBuf::from(env::var("OUT_DIR")?);
    let is_for_windows = env::var_os("CARGO_FEATURE_WINDOWS").is_some();
    let system = if is_for_windows {
        System::Windows(Version {
            name: env::var("CARGO_PKG_DESCRIPTION")?,
            number: env::var("CARGO_PKG_VERSION")?,
        })
    } else {
        System::Linux
    };
    // Put this program where the compiler looks for a linker.
    let directory = output.join("linker");
    fs::create_dir_all(&directory)?;
    let own = env::current_exe()?;
    let linker = directory.join(LINKER);
    if linker.exists() {
        fs::remove_file(&linker)?;
    }
    fs::hard_link(&own, &linker).or_else(|_| fs::copy(&own, &linker).map(|_| ()))?;
    // Write the settings that it reads when it is called, and the stub.
    let text = |path: PathBuf| {
        let path = path.into_os_string().into_string();
        path.map_err(|path| format!("{path:?} is not UTF-8"))
    };
    linker::Settings {
        linker: toolchain.linker.clone(),
        unpacked: text(output.clone())?,
        system,
    }
    .write(&directory)?;
    compile_stub(&toolchain, is_for_windows, &directory.join(linker::STUB))?;
    let map = text(output.join(format!("{program}.map")))?;
    let for_system: &[&str] = if is_for_windows {
        &[
            // Nothing of Linux starts it.
            "-Wl,--no-dynamic-linker",
            // With room before it for the packed file, which begins where programs of Windows did before they had random addresses.
            &format!("-Wl,{}=0x420000", toolchain.base()),
        ]
    } else {
        // All functions of libraries are found when it starts: what would look them up later is left out.
        &["-Wl,-z,now"]
    };
    let for_all = [
        // It has a beginning of its own.
        "-nostartfiles",
        "-Wl,--entry=eightfold_start",
        // At fixed addresses: so it needs no relocations, and the packed file has room for it.
        "-no-pie",
        // Pages of 4 KB: gaps between segments are packed, too.
        "-Wl,-z,max-page-size=4096",
        "-Wl,--build-id=none",
        // Of functions that are redirected there are two; the first counts.
        "-Wl,-z,muldefs",
        &format!("-Wl,-Map={map}"),
        &format!("-B{}", directory.display()),
        // The last one says which linker it is.
        &format!("-fuse-ld={}", &LINKER[3..]),
    ];
    for argument in for_all.iter().chain(for_system) {
        println!("cargo::rustc-link-arg-bin={program}={argument}");
    }
    Ok(())
}

/// Compiles the stub of a system to an object file, without what the user wants of other programs.
fn compile_stub(toolchain: &Toolchain, is_for_windows: bool, object: &Path) -> Result<(), Error> {
    let system = if is_for_windows { "windows" } else { "linux" };
    let source = Path::new(SOURCE).join("stub").join(system).join("main.rs");
    let done = Command::new(&toolchain.rustc)
        .args([
            "--edition=2024",
            "--crate-type=bin",
            "--crate-name=stub",
            "--emit=obj",
        ])
        .args(["--target", toolchain::TARGET])
        .args([
            "-Cpanic=abort",
            // Loops that are called through iterators inline, which `z` would not.
            "-Copt-level=s",
            "-Cjump-tables=no",
            "-Crelocation-model=static",
            "-Ccodegen-units=1",
        ])
        // On Windows memory below the stack pointer may be written to at any time.
        .args(is_for_windows.then_some("-Cno-redzone=yes"))
        .arg("-o")
        .args([object, &source])
        .status()?;
    if done.success() {
        Ok(())
    } else {
        Err("rustc cannot compile the stub".into())
    }
}
