//! The modules of the tracer, and those of the show and its soundtrack, depend on each other without a cycle.
//!
//! The test scans the source text: a module of a `lib.rs` depends on each module that its files name by `crate::`, also through
//! items that the library re-exports. Comments and unit tests do not count. Inside of a folder, files must not depend on each
//! other in a cycle either, apart from the folder's own `mod.rs`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// For each module, the modules that it depends on, each with the file that names it.
type Graph = BTreeMap<String, BTreeMap<String, PathBuf>>;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// The code of a file without comments and without its unit tests, which come last.
fn code(file: &Path) -> String {
    let text = fs::read_to_string(file).unwrap();
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = code.lines().map(|line| line.split("//").next().unwrap());
    lines.collect::<Vec<_>>().join("\n")
}

/// The Rust files of a module in a library's folder: the file of its name, and those in its own folder except tests.
fn files(library: &Path, module: &str) -> Vec<PathBuf> {
    let mut files = vec![library.join(module).with_extension("rs")];
    let mut folders = vec![library.join(module)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten() {
            let path = entry.unwrap().path();
            if path.is_dir() && !path.ends_with("tests") {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                files.push(path);
            }
        }
    }
    files.retain(|file| file.is_file());
    files
}

/// The tokens of a text: words, `::` and single other characters.
fn tokens(text: &str) -> Vec<&str> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let end = if is_word(first) {
            rest.find(|c| !is_word(c)).unwrap_or(rest.len())
        } else if rest.starts_with("::") {
            2
        } else {
            first.len_utf8()
        };
        tokens.push(&rest[..end]);
        rest = rest[end..].trim_start();
    }
    tokens
}

/// The names directly after `path::`, with or without braces.
fn named_after<'a>(path: &str, tokens: &[&'a str]) -> Vec<&'a str> {
    let mut names = Vec::new();
    for (i, window) in tokens.windows(3).enumerate() {
        if window[..2] != [path, "::"] {
            continue;
        }
        if window[2] != "{" {
            names.push(window[2]);
            continue;
        }
        let mut depth = 0;
        for (token, next) in tokens[i + 2..].iter().zip(&tokens[i + 3..]) {
            match *token {
                "{" => depth += 1,
                "}" => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                break;
            }
            if depth == 1 && ["{", ","].contains(token) && *next != "}" {
                names.push(*next);
            }
        }
    }
    names
}

/// The modules that a file declares, and the module of each item that it imports from one of these.
fn declared(file: &Path) -> (BTreeSet<String>, BTreeMap<String, String>) {
    let code = code(file);
    let tokens = tokens(&code);
    let modules: BTreeSet<String> = tokens
        .windows(3)
        .filter(|window| window[0] == "mod" && window[2] == ";")
        .map(|window| window[1].to_owned())
        .collect();
    let mut items = BTreeMap::new();
    for module in &modules {
        for item in named_after(module, &tokens) {
            items.insert(item.to_owned(), module.clone());
        }
    }
    (modules, items)
}

/// The graph of the modules that a file declares. `files` lists a module's files, which name other modules after `path`.
fn graph(root: &Path, path: &str, files: impl Fn(&str) -> Vec<PathBuf>) -> Graph {
    let (modules, items) = declared(root);
    let mut graph = Graph::new();
    for module in &modules {
        let mut all = BTreeMap::new();
        for file in files(module) {
            let code = code(&file);
            for name in named_after(path, &tokens(&code)) {
                let to = modules.get(name).or_else(|| items.get(name));
                if let Some(to) = to.filter(|to| *to != module) {
                    all.insert(to.clone(), file.clone());
                }
            }
        }
        graph.insert(module.clone(), all);
    }
    graph
}

/// The graph of the modules of the library in a folder.
fn library(folder: &Path) -> Graph {
    graph(&folder.join("lib.rs"), "crate", |module| {
        files(folder, module)
    })
}

/// The graph of the tracer's modules.
fn tracer() -> Graph {
    library(&source().join("tracer"))
}

/// The graph of the files in a folder, which name each other after `super`.
fn folder(folder: &Path) -> Graph {
    let file = |module: &str| vec![folder.join(module).with_extension("rs")];
    let is_file = |module: &str| {
        file(module)
            .into_iter()
            .filter(|file| file.is_file())
            .collect()
    };
    graph(&folder.join("mod.rs"), "super", is_file)
}

/// The steps between modules that depend on themselves, or on others that do, a line for each; none where no module does.
fn find_cycle(graph: &Graph) -> Option<String> {
    let mut left = graph.clone();
    while let Some(module) = left
        .iter()
        .find(|(_, needs)| !needs.keys().any(|need| left.contains_key(need)))
        .map(|(module, _)| module.clone())
    {
        left.remove(&module);
    }
    let steps = left.iter().flat_map(|(module, needs)| {
        let needs = needs.iter().filter(|(need, _)| left.contains_key(*need));
        needs.map(move |(need, file)| format!("{module} needs {need} in {}", file.display()))
    });
    let lines: Vec<String> = steps.collect();
    (!lines.is_empty()).then(|| lines.join("\n"))
}

#[test]
fn no_module_depends_on_itself_by_way_of_others() {
    for graph in [library(&source()), tracer()] {
        assert!(graph.len() > 2, "{graph:?}");
        if let Some(cycle) = find_cycle(&graph) {
            panic!("a cycle of modules:\n{cycle}");
        }
    }
}

/// The folders of modules below a folder.
fn folders(below: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(below)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut all: Vec<PathBuf> = entries.filter(|path| path.is_dir()).collect();
    for inner in all.clone() {
        all.extend(folders(&inner));
    }
    all.retain(|path| path.join("mod.rs").is_file() || path == below);
    all
}

#[test]
fn no_file_of_a_folder_depends_on_itself_by_way_of_others() {
    let all = folders(&source());
    assert!(all.len() > 10, "{all:?}");
    for path in all {
        if let Some(cycle) = find_cycle(&folder(&path)) {
            panic!("a cycle of files:\n{cycle}");
        }
    }
}

#[test]
fn leaves_depend_on_no_other_module() {
    let graph = tracer();
    for leaf in ["flaw", "font", "lanes"] {
        assert!(graph[leaf].is_empty(), "{leaf} needs {:?}", graph[leaf]);
    }
    assert!(graph["maths"].keys().eq(["lanes"]));
}

#[test]
fn a_cycle_is_found_whatever_form_its_imports_have() {
    let code = "use crate::{a::{B, c}, d}; fn f() { crate::e::g() }";
    assert_eq!(named_after("crate", &tokens(code)), ["a", "d", "e"]);
    let needs = |to: &str| BTreeMap::from([(to.to_owned(), PathBuf::from("file.rs"))]);
    let mut graph = Graph::from([("a".into(), needs("b")), ("b".into(), needs("c"))]);
    assert_eq!(find_cycle(&graph), None);
    graph.insert("c".into(), needs("b"));
    let cycle = find_cycle(&graph).unwrap();
    let steps = ["a needs b", "b needs c", "c needs b"];
    assert_eq!(
        cycle,
        steps.map(|step| format!("{step} in file.rs")).join("\n")
    );
}
