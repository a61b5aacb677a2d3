//! Replaces the functions of std that explain a panic, which are most of a program's bytes.
//!
//! The functions are found by name in the archives on the linker's command line. An object in front of these archives defines them
//! as jumps to `src/window/abort.rs`; the linker keeps the first definition, and drops code that only the second one needs.
//!
//! Packed bytes that each measure saves, of 53,456:
//!
//! | measure | bytes |
//! | --- | ---: |
//! | `rust_begin_unwind` and all of [`REPLACED`] | 83,356 |
//! | `str::slice_error_fail`, which formats the string | 3,433 |
//! | `handle_alloc_error`, which prints | 2,122 |
//! | `rust_eh_personality`, which reads unwind tables | 936 |
//! | the other functions, with their messages' arguments | 975 |

use std::{collections::HashSet, ffi::OsString, fs, path::PathBuf};

use object::{
    Architecture, BinaryFormat, Endianness, Object, ObjectSymbol, RelocationEncoding,
    RelocationFlags, RelocationKind, SectionKind, SymbolFlags, SymbolKind, SymbolScope,
    read::archive::ArchiveFile, write,
};

use super::at;
use crate::{Error, panics::ABORT};

/// The last three have inlined copies of functions of std.
const CRATES: [&str; 6] = ["core", "alloc", "std", "gimli", "addr2line", "rustc_demangle"];

/// Parts of the paths of the functions that [`ABORT`] replaces. The linker warns of missing ones.
const REPLACED: [&str; 8] = [
    "__rustc::rust_begin_unwind",
    "alloc::alloc::handle_alloc_error",
    "alloc::raw_vec::handle_error",
    "core::option::unwrap_failed",
    "core::panicking",
    "core::slice::index::slice_index_fail",
    "core::str::slice_error_fail",
    "rust_eh_personality",
];

pub fn redirections(words: &[OsString]) -> Result<(Vec<u8>, Vec<&'static str>), Error> {
    let names = symbols(&libraries(words))?;
    let mut object =
        write::Object::new(BinaryFormat::Elf, Architecture::X86_64, Endianness::Little);
    object.add_section(Vec::new(), b".note.GNU-stack".into(), SectionKind::Other);
    let section = object.add_section(Vec::new(), b".text.abort".into(), SectionKind::Text);
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
    let undefined = write::SymbolSection::Undefined;
    let abort = object.add_symbol(symbol(ABORT, undefined, SymbolScope::Unknown));
    let jump = write::Relocation {
        offset: 1,
        symbol: abort,
        addend: -4,
        flags: RelocationFlags::Generic {
            kind: RelocationKind::Relative,
            encoding: RelocationEncoding::X86Branch,
            size: 32,
        },
    };
    object.add_relocation(section, jump)?;
    let mut missing = Vec::new();
    let mut done = HashSet::new();
    for path in REPLACED {
        let part = mangled(path);
        let is_named =
            |symbol: &&String| **symbol == part || path.contains("::") && symbol.contains(&part);
        if !names.iter().any(|name| is_named(&name)) {
            missing.push(path);
        }
        for name in names.iter().filter(is_named) {
            if done.insert(name) {
                let here = write::SymbolSection::Section(section);
                object.add_symbol(symbol(name, here, SymbolScope::Linkage));
            }
        }
    }
    Ok((object.write()?, missing))
}

fn libraries(words: &[OsString]) -> Vec<PathBuf> {
    let mut libraries: Vec<_> = words.iter().map(PathBuf::from).collect();
    libraries.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_of = |name_of: &&str| name.starts_with(&format!("lib{name_of}-"));
        name.ends_with(".rlib") && CRATES.iter().any(is_of)
    });
    libraries
}

fn symbols(libraries: &[PathBuf]) -> Result<Vec<String>, Error> {
    let mut names = Vec::new();
    for library in libraries {
        let data = at(library, fs::read(library))?;
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

/// Mangles a path: `std::io::_print` becomes `3std2io7__print`. Names without a path are not mangled.
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
