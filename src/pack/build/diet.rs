//! The diet: std's functions that the intro does not need are replaced.
//!
//! A program of std brings with it what it needs to explain a panic: formatting, a backtrace, a reader of debugging information, a
//! demangler. They are most of its bytes, packed as well. The functions that lead there are found by their names in the sysroot's
//! archives; assembly in the intro's own object defines each anew, ahead of the archives; the linker takes the first definition,
//! and drops all that only the second one needed. What they do instead is in `src/window/abort.rs`.
//!
//! The bytes that each measure saves of the packed file, found by leaving it out, of 53,456 bytes (of others where that is said):
//!
//! | measure | where | bytes |
//! | --- | --- | ---: |
//! | `rust_begin_unwind` and what is below, together | [`INSTEAD`] | 83,356 |
//! | `str::slice_error_fail`, which formats what was to be cut | [`INSTEAD`] | 3,433 |
//! | `handle_alloc_error`, which prints | [`INSTEAD`] | 2,122 |
//! | `rust_eh_personality`, which reads unwind tables | [`INSTEAD`] | 936 |
//! | the other ways to a panic, with the arguments of their messages | [`INSTEAD`] | 975 |
//! | `str::count::do_count_chars`, which counts eight bytes at a time (of 64,400) | [`INSTEAD`] | 405 |
//! | C's `main`, not Rust's (of 59,633) | `main!` in `src/window/arguments.rs` | 9,564 |
//! | C's arguments, not std's (of 59,633) | the same | 432 |
//! | `opt-level = 2`, as fast as 3 (of 72,726) | `Cargo.toml` | 6,566 |
//!
//! Tried, and not worth it: an allocator by `malloc` alone saves 105 bytes, `Display::fmt` redirected 1,587, and then nothing can be
//! formatted; the window's crates at `opt-level = "s"` 104.

use std::{collections::HashSet, fmt::Write, fs, path::PathBuf};

use object::{Object, ObjectSymbol, SymbolKind, read::archive::ArchiveFile};

use super::toolchain::{TARGET, Toolchain};
use crate::{Error, panics::ABORT};

/// The crates that functions are redirected in. The last three have functions of the others compiled in.
const CRATES: [&str; 6] = [
    "core",
    "alloc",
    "std",
    "gimli",
    "addr2line",
    "rustc_demangle",
];

/// Replacements for functions of std, and those functions: parts of paths. One that std does not have is a warning.
const INSTEAD: [(&str, &[&str]); 2] = [
    (
        ABORT,
        &[
            "__rustc::rust_begin_unwind",
            "alloc::alloc::handle_alloc_error",
            "alloc::raw_vec::handle_error",
            "core::option::unwrap_failed",
            "core::panicking",
            "core::slice::index::slice_index_fail",
            "core::str::slice_error_fail",
            "rust_eh_personality",
        ],
    ),
    (
        "eightfold_count_chars",
        &["core::str::count::do_count_chars"],
    ),
];

/// Assembly that defines functions of std anew, for `main!` to include, and those that std does not have.
pub fn redirections(toolchain: &Toolchain) -> Result<(String, Vec<&'static str>), Error> {
    let symbols = symbols(&libraries(toolchain)?)?;
    let (mut assembly, mut missing) = (String::new(), Vec::new());
    let mut done = HashSet::new();
    for (target, paths) in INSTEAD {
        writeln!(assembly, ".section .text.{target}_instead, \"ax\"")?;
        for path in paths {
            let part = mangled(path);
            let is_named = |symbol: &&String| {
                **symbol == part || path.contains("::") && symbol.contains(&part)
            };
            if !symbols.iter().any(|symbol| is_named(&symbol)) {
                missing.push(*path);
            }
            for symbol in symbols.iter().filter(is_named) {
                if done.insert(symbol) {
                    writeln!(assembly, ".globl {symbol}\n.hidden {symbol}\n{symbol}:")?;
                }
            }
        }
        writeln!(assembly, "jmp {target}")?;
    }
    Ok((assembly, missing))
}

/// The archives of [`CRATES`] that programs are linked with.
fn libraries(toolchain: &Toolchain) -> Result<Vec<PathBuf>, Error> {
    let directory = toolchain
        .sysroot
        .join("lib/rustlib")
        .join(TARGET)
        .join("lib");
    let mut libraries = Vec::new();
    for entry in fs::read_dir(directory)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_of =
            |name_of: &&str| name.starts_with(&format!("lib{name_of}-")) && name.ends_with(".rlib");
        if CRATES.iter().any(is_of) {
            libraries.push(path);
        }
    }
    // In an order that does not depend on the file system.
    libraries.sort();
    Ok(libraries)
}

/// Names of the global functions in archives.
fn symbols(libraries: &[PathBuf]) -> Result<Vec<String>, Error> {
    let mut names = Vec::new();
    for library in libraries {
        let data = fs::read(library)?;
        for member in ArchiveFile::parse(&*data)?.members() {
            let member = member?;
            if !member.name().ends_with(b".o") {
                continue;
            }
            let object = object::File::parse(member.data(&*data)?)?;
            let is_function = |symbol: &object::Symbol<'_, '_>| {
                symbol.is_global() && (symbol.kind() == SymbolKind::Text || symbol.is_undefined())
            };
            let functions = object.symbols().filter(is_function);
            names.extend(functions.filter_map(|symbol| symbol.name().ok().map(String::from)));
        }
    }
    Ok(names)
}

/// A path as it is found in mangled names: `std::io::_print` is `3std2io7__print`. A name without a path isn't mangled.
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
