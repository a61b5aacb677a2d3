use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

const TRACER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/tracer");

/// Returns a file's text without comments and tests.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("text");
    let text = text.split("#[cfg(all(test").next().expect("a part");
    let text = text.split("#[cfg(test)]\nmod tests {").next().expect("a part");
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let paths = paths.filter(|path| path.file_stem().is_none_or(|name| name != "tests"));
    let files = paths.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] });
    files.filter(|path| path.extension().is_some_and(|end| end == "rs")).collect()
}

/// Returns the first names of all paths after `root`, also of those in braces.
fn imports(code: &str, root: &str) -> BTreeSet<String> {
    let paths = code.split(root).skip(1).flat_map(|path| {
        let group = path.strip_prefix('{').and_then(|group| group.split("};").next());
        group.map_or(vec![path], |group| group.split(", ").collect())
    });
    let is_name = |c: char| c.is_ascii_lowercase() || c == '_';
    let names = paths.filter_map(|path| path.split(|c| !is_name(c)).next());
    names.filter(|name| !name.is_empty()).map(str::to_owned).collect()
}

/// A file imports only from modules that ARCHITECTURE.md lists before its own. Each is listed once.
#[test]
fn tracer_modules_import_only_from_lower_floors() {
    let page = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/ARCHITECTURE.md"));
    let page = page.expect("text");
    let chain = page.lines().find(|line| line.contains("◀─ maths ◀─")).expect("the chain");
    let floors = chain.split("◀─").enumerate();
    let floors =
        floors.flat_map(|(floor, names)| names.split(',').map(move |it| (it.trim(), floor)));
    let floors: BTreeMap<&str, usize> = floors.collect();
    let lib = code(&Path::new(TRACER).join("lib.rs"));
    let modules =
        lib.lines().filter_map(|line| line.trim_start_matches("pub ").strip_prefix("mod "));
    let modules: BTreeSet<&str> = modules.map(|line| line.trim_end_matches(';')).collect();
    assert!(floors.keys().eq(&modules), "{floors:?}");
    let mut count = 0;
    for path in files(Path::new(TRACER)) {
        let module = path.strip_prefix(TRACER).expect("a path").with_extension("");
        let module = module.iter().next().and_then(|name| name.to_str()).expect("a name");
        if module == "lib" {
            continue;
        }
        for used in imports(&code(&path), "crate::") {
            let is_below = used == module || floors[used.as_str()] < floors[module];
            assert!(is_below, "{path:?} imports from {used}");
            count += 1;
        }
    }
    assert!(count > 150, "{count} imports");
}

/// Files of a folder import each other in one direction. Their `mod.rs` is above or below all of them.
#[test]
fn tracer_files_do_not_import_in_circles() {
    let mut folders: BTreeMap<PathBuf, BTreeMap<String, BTreeSet<String>>> = BTreeMap::new();
    for path in files(Path::new(TRACER)) {
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name");
        let imported = imports(&code(&path), "super::");
        let folder = folders.entry(path.with_file_name("")).or_default();
        folder.insert(name.to_owned(), imported);
    }
    for (folder, mut files) in folders {
        while !files.is_empty() {
            let left: BTreeSet<String> = files.keys().cloned().collect();
            files
                .retain(|name, imported| imported.iter().any(|it| it != name && left.contains(it)));
            assert!(files.len() < left.len(), "{folder:?}: a circle in {files:?}");
        }
    }
}
