//! The library's modules depend on each other without a cycle.
//!
//! A plain scan of the text: a module of `src/lib.rs` depends on each module that its files name by `crate::`, be it by way
//! of an item that the library re-exports. Comments and tests do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each module depends on, with the file that says so.
type Graph = BTreeMap<String, BTreeMap<String, PathBuf>>;

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// A file's code without comments and without its tests, which come last.
fn code(file: &Path) -> String {
    let text = fs::read_to_string(file).unwrap();
    let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap();
    let lines = code.lines().map(|line| line.split("//").next().unwrap());
    lines.collect::<Vec<_>>().join("\n")
}

/// The Rust files of a module: one of its name, and those in its folder but for tests.
fn files(module: &str) -> Vec<PathBuf> {
    let mut files = vec![source().join(module).with_extension("rs")];
    let mut folders = vec![source().join(module)];
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

/// The words of a text, and what stands between them.
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

/// The names that directly follow `path::`, in braces or not.
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

/// The modules of the library, and where the items are from that it re-exports.
fn modules() -> (BTreeSet<String>, BTreeMap<String, String>) {
    let library = code(&source().join("lib.rs"));
    let tokens = tokens(&library);
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

fn graph() -> Graph {
    let (modules, items) = modules();
    let mut graph = Graph::new();
    for module in &modules {
        let mut all = BTreeMap::new();
        for file in files(module) {
            let code = code(&file);
            for name in named_after("crate", &tokens(&code)) {
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

/// A cycle that begins and ends with the last module of the way, if there is one.
fn cycle(graph: &Graph, way: &mut Vec<String>, done: &mut BTreeSet<String>) -> Option<Vec<String>> {
    let module = way.last()?.clone();
    for next in graph.get(&module).into_iter().flat_map(BTreeMap::keys) {
        if let Some(start) = way.iter().position(|passed| passed == next) {
            let mut cycle = way[start..].to_vec();
            cycle.push(next.clone());
            return Some(cycle);
        }
        if done.contains(next) {
            continue;
        }
        way.push(next.clone());
        if let Some(cycle) = cycle(graph, way, done) {
            return Some(cycle);
        }
        way.pop();
    }
    done.insert(module);
    None
}

/// A cycle of a graph, a line for each of its steps.
fn find_cycle(graph: &Graph) -> Option<String> {
    let mut done = BTreeSet::new();
    let found = graph
        .keys()
        .find_map(|module| cycle(graph, &mut vec![module.clone()], &mut done))?;
    let lines = found.windows(2).map(|step| {
        let file = graph[&step[0]][&step[1]].display();
        format!("{} needs {} in {file}", step[0], step[1])
    });
    Some(lines.collect::<Vec<_>>().join("\n"))
}

#[test]
fn no_module_depends_on_itself_by_way_of_others() {
    if let Some(cycle) = find_cycle(&graph()) {
        panic!("a cycle of modules:\n{cycle}");
    }
}

#[test]
fn leaves_depend_on_no_other_module() {
    let graph = graph();
    for leaf in ["font", "grid", "lanes", "maths"] {
        assert!(graph[leaf].is_empty(), "{leaf} needs {:?}", graph[leaf]);
    }
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
    assert_eq!(cycle, "b needs c in file.rs\nc needs b in file.rs");
}
