//! The diet: std's functions that the intro does not need are replaced.
//!
//! A program of std brings with it what it needs to explain a panic: formatting, a backtrace, a reader of debugging information, a
//! demangler. They are most of its bytes, packed as well. The functions that lead there are found by their names in the archives
//! that the intro is linked with; an object defines each anew, ahead of the archives; the linker takes the first definition, and
//! drops all that only the second one needed. What they do instead is in `src/window/abort.rs`.
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

use std::{collections::HashSet, ffi::OsString, fs, path::PathBuf};

use object::{
    Architecture, BinaryFormat, Endianness, Object, ObjectSymbol, RelocationEncoding,
    RelocationFlags, RelocationKind, SectionKind, SymbolFlags, SymbolKind, SymbolScope,
    read::archive::ArchiveFile, write,
};

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

/// An object that defines functions of std anew, for the arguments of a link, and those that its std does not have.
pub fn redirections(words: &[OsString]) -> Result<(Vec<u8>, Vec<&'static str>), Error> {
    let names = symbols(&libraries(words))?;
    let mut object =
        write::Object::new(BinaryFormat::Elf, Architecture::X86_64, Endianness::Little);
    // Linkers take from this that it needs no stack that is executable.
    object.add_section(Vec::new(), b".note.GNU-stack".into(), SectionKind::Other);
    let mut missing = Vec::new();
    let mut done = HashSet::new();
    for (target, paths) in INSTEAD {
        // A section of its own, with a jump.
        let name = format!(".text.{target}_instead").into_bytes();
        let section = object.add_section(Vec::new(), name, SectionKind::Text);
        object.append_section_data(section, &[0xe9, 0, 0, 0, 0], 1);
        let symbol = |name: &str, section, scope| write::Symbol {
            name: name.into(),
            value: 0,
            size: 0,
            kind: SymbolKind::Text,
            scope,
            weak: false,
            section,
            flags: SymbolFlags::None,
        };
        let to = object.add_symbol(symbol(
            target,
            write::SymbolSection::Undefined,
            SymbolScope::Unknown,
        ));
        let jump = write::Relocation {
            offset: 1,
            symbol: to,
            addend: -4,
            flags: RelocationFlags::Generic {
                kind: RelocationKind::Relative,
                encoding: RelocationEncoding::X86Branch,
                size: 32,
            },
        };
        object.add_relocation(section, jump)?;
        for path in paths {
            let part = mangled(path);
            let is_named = |symbol: &&String| {
                **symbol == part || path.contains("::") && symbol.contains(&part)
            };
            if !names.iter().any(|name| is_named(&name)) {
                missing.push(*path);
            }
            for name in names.iter().filter(is_named) {
                if done.insert(name) {
                    let here = write::SymbolSection::Section(section);
                    object.add_symbol(symbol(name, here, SymbolScope::Linkage));
                }
            }
        }
    }
    Ok((object.write()?, missing))
}

/// The archives of [`CRATES`] among the arguments of a link.
fn libraries(words: &[OsString]) -> Vec<PathBuf> {
    let mut libraries: Vec<_> = words.iter().map(PathBuf::from).collect();
    libraries.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_of = |name_of: &&str| name.starts_with(&format!("lib{name_of}-"));
        name.ends_with(".rlib") && CRATES.iter().any(is_of)
    });
    libraries
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
