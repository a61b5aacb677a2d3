//! Replaces the functions of std that explain a panic, which are most of a program's bytes.
//!
//! Linker options redefine them, by their names in the archives, as `src/window/abort.rs`; the
//! linker drops unused code. Packed bytes that each measure saves, of 53,456:
//!
//! | measure | bytes |
//! | --- | ---: |
//! | `rust_begin_unwind` and all of [`REPLACED`] | 83,356 |
//! | `str::slice_error_fail`, which formats the string | 3,433 |
//! | `handle_alloc_error`, which prints | 2,122 |
//! | `rust_eh_personality`, which reads unwind tables | 936 |
//! | the other functions, with their messages' arguments | 975 |

use std::{collections::BTreeSet, ffi::OsString, fs};

use object::{Object, ObjectSymbol, SymbolKind, read::archive::ArchiveFile};

use super::at;
use crate::{Error, panics::ABORT};

/// Parts of the paths of the functions that [`ABORT`] replaces; a warning names missing ones.
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

/// Returns the linker's options, and the paths without a function.
pub fn redirections(words: &[OsString]) -> Result<(Vec<OsString>, Vec<&'static str>), Error> {
    let names = symbols(words)?;
    let (mut options, mut missing) = (Vec::new(), Vec::new());
    for path in REPLACED {
        let part = mangled(path);
        let is_named =
            |name: &&String| **name == part || path.contains("::") && name.contains(&part);
        let named: Vec<_> = names.iter().filter(is_named).collect();
        if named.is_empty() {
            missing.push(path);
        }
        options.extend(named.iter().map(|name| format!("--defsym={name}={ABORT}").into()));
    }
    Ok((options, missing))
}

/// Returns the functions that libraries define or call.
fn symbols(words: &[OsString]) -> Result<BTreeSet<String>, Error> {
    let mut names = BTreeSet::new();
    for library in words.iter().filter(|word| word.to_string_lossy().ends_with(".rlib")) {
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

/// Mangles a path: `std::io::_print` becomes `3std2io7__print`. Names without a path are not
/// mangled.
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
