use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

type Modules = BTreeMap<String, BTreeSet<String>>;

/// Returns the modules of a folder, such as "crate::scene" for `scene/mod.rs`, and all paths in
/// their code.
fn modules(folder: &Path, parent: &str) -> Modules {
    let mut modules = Modules::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().and_then(|name| name.to_str()).expect("a name");
        let module = format!("{parent}::{name}");
        let module = module.trim_end_matches("::mod").trim_end_matches("::lib").to_owned();
        if name != "tests" && path.is_dir() {
            modules.extend(self::modules(&path, &module));
        } else if name != "tests" && path.extension().is_some_and(|end| end == "rs") {
            let text = fs::read_to_string(path).expect("text");
            let parent = module.rsplit_once("::").map_or("", |(parent, _)| parent);
            let absolute = |path: String| match path.split_once("::") {
                Some(("crate", _)) => path,
                Some(("super", rest)) => format!("{parent}::{rest}"),
                _ => format!("{module}::{path}"),
            };
            let paths = paths(&text).into_iter().map(absolute).collect();
            modules.insert(module, paths);
        }
    }
    modules
}

/// Returns all paths from "use", "crate" or "super" on, except in comments, in tests, and from
/// inline modules to their file.
fn paths(text: &str) -> Vec<String> {
    let text = text.split("#[cfg(all(test").next().expect("a part");
    let text = text.split("#[cfg(test)]\nmod tests {").next().expect("a part");
    let mut is_inline = false;
    let is_code = |line: &&str| {
        let is_start =
            line.starts_with(|c| c != ' ') && line.contains("mod ") && line.ends_with('{');
        is_inline = (is_inline || is_start) && *line != "}";
        let is_to_file = is_inline && line.starts_with("    use super::");
        !line.trim_start().starts_with("//") && !is_to_file
    };
    let code = text.lines().filter(is_code).collect::<Vec<_>>().join("\n");
    let starts = ["use ", "crate::", "super::"].into_iter().flat_map(|it| code.match_indices(it));
    let starts = starts.filter(|&(at, _)| !code[..at].ends_with("(in "));
    let paths = starts.flat_map(|(at, _)| {
        let text = code[at..].trim_start_matches("use ");
        let is_end = |c: char| !c.is_ascii_alphanumeric() && !"_:*".contains(c);
        let (path, rest) = text.split_at(text.find(is_end).expect("an end"));
        let names = rest.strip_prefix('{').map_or("", |rest| rest.split("};").next().expect("it"));
        assert!(!names.contains('{'), "braces in braces: {names}");
        names.split(',').map(move |name| format!("{path}{}", name.trim()))
    });
    let paths = paths.filter(|path| !path.ends_with("::"));
    paths.map(|path| path.trim_end_matches("::self").to_owned()).collect()
}

#[test]
fn import_in_a_function_is_a_path() {
    let text = "fn f() {\n    use super::a::B;\n}\nmod m {\n    use super::C;\n}\n";
    assert!(paths(text).iter().collect::<BTreeSet<_>>().into_iter().eq(["super::a::B"]));
}

/// Returns the module that defines the last name of a path, through imports and exports.
fn home<'a>(modules: &'a Modules, path: &'a str) -> &'a str {
    let (module, name) = path.rsplit_once("::").unwrap_or(("", path));
    let is_same = |it: &&String| *it != path && name != "*" && it.rsplit("::").next() == Some(name);
    match modules.get(module) {
        _ if modules.contains_key(path) => path,
        None => home(modules, module),
        Some(paths) => paths.iter().find(is_same).map_or(module, |path| home(modules, path)),
    }
}

/// Returns the modules from which each module of the tracer imports, and its children.
fn arrows() -> Modules {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/src/tracer");
    let modules = modules(Path::new(folder), "crate");
    let arrows = modules.iter().map(|(module, paths)| {
        let is_child = |it: &&String| it.rsplit_once("::").is_some_and(|(it, _)| it == module);
        let used = paths.iter().map(|path| home(&modules, path).to_owned());
        let used = used.chain(modules.keys().filter(is_child).cloned());
        (module.clone(), used.filter(|used| used != module).collect())
    });
    arrows.collect()
}

/// A file imports only from modules that ARCHITECTURE.md lists before its own. Each is listed once.
#[test]
fn tracer_modules_import_only_from_lower_floors() {
    let mut lines = include_str!("../../ARCHITECTURE.md").lines();
    let chain = lines.find(|line| line.contains("◀─ maths ◀─")).expect("the chain");
    let floors = chain
        .split("◀─")
        .enumerate()
        .flat_map(|(floor, names)| names.split(',').map(move |name| (name.trim(), floor)));
    let floors: BTreeMap<&str, usize> = floors.collect();
    let mut arrows = arrows();
    arrows.remove("crate");
    let top = |module: &String| module.split("::").nth(1).expect("a name").to_owned();
    let all: BTreeSet<String> = arrows.keys().map(top).collect();
    assert!(floors.keys().eq(&all), "{floors:?}");
    for (module, imports) in &arrows {
        for used in imports {
            let [to, from] = [used, module].map(top);
            let is_below = to == from || floors[to.as_str()] < floors[from.as_str()];
            assert!(is_below, "{module} imports from {used}");
        }
    }
    assert!(arrows.values().map(BTreeSet::len).sum::<usize>() > 400, "{arrows:?}");
}

/// A `mod.rs` is above the files that it declares: they import nothing that it defines.
#[test]
fn tracer_files_do_not_import_in_circles() {
    let arrows = arrows();
    let (mut below, mut next) = (Modules::new(), arrows.clone());
    while below != next {
        below = next;
        let further = |used: &BTreeSet<String>| {
            used.iter().flat_map(|it| &below[it]).chain(used).cloned().collect()
        };
        next = below.iter().map(|(module, used)| (module.clone(), further(used))).collect();
    }
    let mut circles = arrows;
    circles.retain(|module, _| below[module].contains(module));
    assert!(circles.is_empty(), "{circles:#?}");
}
