//! The diet: how the intro gets under 64 KiB on stable Rust.
//!
//! A program of std brings with it what it needs to explain a panic: formatting, a backtrace, a reader of
//! debugging information, a demangler. They are not asked for here, and they are most of the bytes. This
//! script finds the functions that lead there, by their names in the sysroot's archives, and has `main!`
//! define each anew in the intro's own object, ahead of the archives; the linker takes the first
//! definition and drops all that only the second one needed. The substitutes are in
//! `src/window/abort.rs`.
//!
//! For a look inside by `objdump` or `nm`, `EIGHTFOLD_SECTIONS=1 CARGO_PROFILE_RELEASE_STRIP=none cargo build --release`
//! makes a file with section headers and symbols, which does not run; `cargo lab size` tells the same from the linker's map,
//! which lies where this script writes.
//!
//! What each step saves, measured by leaving it out of the whole program (60,765 bytes; those with a star when it was
//! 61,216, laid out by the linker):
//!
//! | step | where | bytes |
//! | --- | --- | ---: |
//! | functions of std redirected * | [`INSTEAD`] | 276,448 |
//! | ... of these, formatting | | 2,629 |
//! | ... of these, vectors | | 704 |
//! | `x11-dl` with 26 functions instead of 826 (in a 30-line program) | `src/window/x11-dl` | 115,056 |
//! | no unwind tables: nothing unwinds * | `src/window/program.ld` | 84,808 |
//! | compiled for size, not for speed | `Cargo.toml` | 26,944 |
//! | few sections, not one per function * | `src/window/program.ld` | 19,384 |
//! | `minifb` makes the window and no more, Xlib does no more than needed | `src/window/window.rs`, `x11-dl/answers.rs` | 7,870 |
//! | addresses fixed when linked (`-no-pie`) * | | 4,688 |
//! | headers and the functions of libc in our own way | `src/window/program.s` | 2,280 |
//! | places of panics in the library are not said | `src/window/program.ld` | 1,808 |
//! | one codegen unit | `Cargo.toml` | 1,280 |
//! | panics abort * | `Cargo.toml` | 1,032 |
//! | no start files but our own * | `src/window/program.s` | 880 |
//! | messages, report and terminal as forms, options and qualities as rows of bytes | `src/window/line.rs`, `src/options.rs` | 1,700 |
//! | no panics in the window's crate, and errors of `minifb` left out | `src/window/program.ld` | 800 |
//! | one window, one memory that is zero | `src/window/window.rs`, `src/main.rs` | 500 |
//! | system calls by number, not by name * | `src/window/system.rs` | 620 |
//! | memory by `malloc` and no more * | `src/window/allocator.rs` | 504 |
//! | functions know what registers others use (`-enable-ipra`) | `.cargo/config.toml` | 1,520 |
//! | numbers masked, lists cut to length, where a check would end in a panic | `src/prepare`, `src/show` | 860 |
//! | square roots in place, not by a call into `libm` | `src/trigonometry.rs` | 520 |
//! | every pixel's rows without chunks that are divided for | `src/refine/refiner.rs` | 500 |
//! | constants loaded where they are used (`-disable-machine-licm`) | `.cargo/config.toml` | 960 |
//! | functions called by their own addresses (`-Crelro-level=off`) | `.cargo/config.toml` | 896 |
//! | vectors in registers, by `Vec3A` | | 816 |
//! | names in an unused program header, constants by alignment | `src/window/program.s`, `program.ld` | 276 |
//! | work counted for the lab alone, bands made in their place | `src/trace`, `src/render.rs` | 214 |
//! | numbers of pixels by way of `i32` | `src/scene/camera.rs` | 448 |
//! | code that occurs several times is called, shorter spills (`-enable-machine-outliner`, `-split-spill-mode=size`) | `.cargo/config.toml` | 276 |
//! | identical functions folded (`--icf=all`) | | 176 |
//!
//! What the tracer gave up, one step after the other:
//!
//! | step | where | bytes |
//! | --- | --- | ---: |
//! | squares refined in SSE2 lanes, not once per instruction set | `src/refine` | 26,256 |
//! | AVX-512 left to the lab; rays packed by bits, not by a table | `src/lanes` | 15,896 |
//! | sines and roots of our own | `src/trigonometry.rs` | 8,096 |
//! | a loop where it was unrolled, one place where there were two | `src/trace` | 3,664 |
//! | no list of who can shadow whom (3 % of the time) | `src/prepare` | 1,904 |
//! | surfaces made as rows of numbers | `src/prepare` | 800 |
//! | the SSE2 kernel without what only saves time | `src/trace` | 436 |
//! | sums made samples in SSE2 lanes, not once per instruction set (0.3 % of the time) | `src/trace` | 331 |
//!
//! What std's parts cost, which the intro has by libc instead (measured in that 30-line program): starting
//! a thread 32,000, counting processors 24,000, parking a thread 6,700, Rust's own `main` 19,000.
//!
//! Tried, and not kept: link-time optimisation makes std's functions one with the rest, so they can't be
//! redirected (`lto = "fat"`), or without std's inlines 12,500 bytes more (`-C linker-plugin-lto`). All of the library at
//! `opt-level = "z"`: the kernels get larger (SSE2 by 2,500, AVX2 by 3,300), and little else gets much smaller (`main` by 290).
//! `-C relocation-model=static` saved 110 once and costs 540 now, and goes to procedural macros too, which it breaks.
//! Of LLVM's own options `-enable-newgvn` saves 460, but is not finished; others save less
//! than 100, or they cost (`-jump-threading-threshold=0` 5,500).
//! Structures with their small fields first: 50.

use std::{
    collections::HashSet,
    env,
    error::Error,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use object::{Object, ObjectSymbol, SymbolKind, read::archive::ArchiveFile};

/// The crates of the sysroot that functions are redirected in. (The last three have functions of the others compiled in.)
const CRATES: [&str; 6] = [
    "core",
    "alloc",
    "std",
    "gimli",
    "addr2line",
    "rustc_demangle",
];

/// What is called instead of functions of std, and those functions: parts of paths, each of which has
/// to be there. (`*` is any text.)
const INSTEAD: [(&str, &[&str]); 5] = [
    // All ways to a panic, and vectors: nobody makes one.
    (
        "eightfold_abort",
        &[
            "_Unwind_Resume",
            "__rustc::rust_begin_unwind",
            "alloc::alloc::handle_alloc_error",
            "alloc::raw_vec::capacity_overflow",
            "alloc::raw_vec::handle_error",
            "core::option::expect_failed",
            "core::option::unwrap_failed",
            "core::panicking",
            "core::result::unwrap_failed",
            "core::slice::copy_from_slice_impl::len_mismatch_fail",
            "core::slice::index::slice_index_fail",
            "core::str::slice_error_fail",
            "rust_eh_personality",
            "std::alloc::rust_oom",
            "std::panicking::panic_with_hook",
            // In mangled names, a length is before each part.
            "11RawVecInner15try_allocate_in",
            "7reserve21do_reserve_and_handle",
        ],
    ),
    // Formatting, printing, and giving back memory before the process ends.
    (
        "eightfold_ignore",
        &[
            "Debug::fmt",
            "Display::fmt",
            "std::io::stdio::_print",
            "11RawVecInner10deallocate",
            // (`h` is `u8`.)
            "6RawVechE*4Drop4drop",
        ],
    ),
    ("eightfold_format", &["alloc::fmt::format::format_inner"]),
    // (`Re` is `::<&str>`.)
    ("eightfold_c_string", &["7CString3newRe"]),
    ("eightfold_now", &["Instant::now"]),
];

/// The functions of libc that the intro calls, but for `dlsym`. It looks them up itself, see `src/window/program.s`.
const C_FUNCTIONS: [&str; 14] = [
    "__errno_location",
    "__libc_start_main",
    "abort",
    "bcmp",
    "clock_gettime",
    "dlopen",
    "free",
    "malloc",
    "memcpy",
    "memset",
    "pthread_create",
    "sigaction",
    "strlen",
    "syscall",
];

fn main() {
    println!("cargo::rustc-check-cfg=cfg(diet)");
    for file in ["build.rs", "src/window/program.s", "src/window/program.ld"] {
        println!("cargo::rerun-if-changed={file}");
    }
    println!("cargo::rerun-if-env-changed=EIGHTFOLD_SECTIONS");
    if let Some(reason) = no_diet() {
        println!("cargo::warning=the intro is not put on its diet: {reason}");
        return;
    }
    if let Err(error) = diet() {
        println!("cargo::error=the intro's diet: {error}");
        std::process::exit(1);
    }
}

/// Why this build has to do without.
fn no_diet() -> Option<&'static str> {
    let is = |name, value| env::var(name).is_ok_and(|is| is == value);
    if !is("TARGET", "x86_64-unknown-linux-gnu") {
        return Some("it is made for x86_64-unknown-linux-gnu");
    }
    if !is("PROFILE", "release") {
        return Some("it needs --release");
    }
    let flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    if env::var_os("RUSTC_LINKER").is_some()
        || ["linker", "fuse-ld"]
            .iter()
            .any(|word| flags.contains(word))
    {
        return Some("it is made for rustc's own linker, rust-lld");
    }
    None
}

fn diet() -> Result<(), Box<dyn Error>> {
    let source = Path::new("src/window").canonicalize()?;
    let mut assembly = fs::read_to_string(source.join("program.s"))?;
    for name in C_FUNCTIONS {
        writeln!(assembly, "c_function {name}")?;
    }
    writeln!(assembly, ".section .rodata.c_names\nc_names_end:")?;
    assembly += &redirections(&symbols(&libraries()?)?)?;
    let output = PathBuf::from(env::var("OUT_DIR")?);
    let sections = env::var_os("EIGHTFOLD_SECTIONS").is_some();
    fs::write(output.join("diet.s"), assembly)?;
    let script = source.join("program.ld");
    for argument in [
        "-no-pie",
        "-nostartfiles",
        &format!("-Wl,-T,{}", script.display()),
        // Functions that are redirected have two definitions; the first counts.
        "-Wl,-z,muldefs",
        // The file is what the script says, without a header for each section. What is in it is told apart by this map.
        if sections {
            "-Wl,--oformat=elf"
        } else {
            "-Wl,--oformat=binary"
        },
        // Here and not beside the program: there, builds of other features would leave theirs.
        &format!("-Wl,-Map={}", output.join("eightfold.map").display()),
        "-Wl,--build-id=none",
        "-Wl,--icf=all",
    ] {
        println!("cargo::rustc-link-arg-bin=eightfold={argument}");
    }
    println!("cargo::rustc-cfg=diet");
    Ok(())
}

/// Assembly that defines functions of std anew, for `main!` to include.
fn redirections(symbols: &[String]) -> Result<String, Box<dyn Error>> {
    let mut assembly = String::new();
    let mut done = HashSet::new();
    for (target, paths) in INSTEAD {
        writeln!(assembly, ".section .text.{target}_instead, \"ax\"")?;
        for path in paths {
            let part = mangled(path);
            let mut found = false;
            for symbol in symbols {
                let named = *symbol == part
                    || part.starts_with(|c: char| c.is_ascii_digit())
                        && part.split('*').all(|part| symbol.contains(part));
                found |= named;
                if named && done.insert(symbol) {
                    writeln!(assembly, ".globl {symbol}\n.hidden {symbol}\n{symbol}:")?;
                }
            }
            if !found {
                return Err(format!("std has no {path}; the diet is for rustc 1.95").into());
            }
        }
        writeln!(assembly, "jmp {target}")?;
    }
    Ok(assembly)
}

/// The archives of [`CRATES`] that programs are linked with.
fn libraries() -> Result<Vec<PathBuf>, Box<dyn Error>> {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(rustc).args(["--print", "sysroot"]).output()?;
    let directory = Path::new(String::from_utf8(output.stdout)?.trim())
        .join("lib/rustlib")
        .join(env::var("TARGET")?)
        .join("lib");
    let files: Vec<PathBuf> = fs::read_dir(&directory)?
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<_, std::io::Error>>()?;
    CRATES
        .iter()
        .map(|name| {
            let start = format!("lib{name}-");
            files
                .iter()
                .find(|file| {
                    let name = file.file_name().unwrap_or_default().to_string_lossy();
                    name.starts_with(&start) && name.ends_with(".rlib")
                })
                .cloned()
                .ok_or_else(|| format!("no {start}*.rlib in {}", directory.display()).into())
        })
        .collect()
}

/// Names of the global functions in archives.
fn symbols(libraries: &[PathBuf]) -> Result<Vec<String>, Box<dyn Error>> {
    let mut names = Vec::new();
    for library in libraries {
        let data = fs::read(library)?;
        for member in ArchiveFile::parse(&*data)?.members() {
            let member = member?;
            if !member.name().ends_with(b".o") {
                continue;
            }
            let object = object::File::parse(member.data(&*data)?)?;
            names.extend(
                object
                    .symbols()
                    .filter(|symbol| {
                        symbol.is_global()
                            && (symbol.kind() == SymbolKind::Text || symbol.is_undefined())
                    })
                    .filter_map(|symbol| symbol.name().ok().map(String::from)),
            );
        }
    }
    Ok(names)
}

/// A path as it is found in mangled names: `std::io::_print` is `3std2io7__print`. A name without a path
/// isn't mangled.
fn mangled(path: &str) -> String {
    if !path.contains("::") {
        return path.into();
    }
    let word = |word: &str| {
        let separator = if word.starts_with('_') { "_" } else { "" };
        format!("{}{separator}{word}", word.len())
    };
    path.split("::").map(word).collect()
}
