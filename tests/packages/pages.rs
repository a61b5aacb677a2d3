use std::{fs, path::Path};

#[test]
fn links_lead_to_files() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["", "docs", "src/tracer"].map(|folder| fs::read_dir(root.join(folder)));
    let entries = folders.into_iter().flat_map(|entries| entries.expect("a folder"));
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut count = 0;
    for page in paths.filter(|path| path.extension().is_some_and(|end| end == "md")) {
        let text = fs::read_to_string(&page).expect("text");
        let targets = text.split("](").skip(1).map(|rest| rest.split(')').next());
        for target in targets.flatten().filter(|link| !link.starts_with("http")) {
            let path = page.with_file_name(target.split('#').next().expect("a part"));
            assert!(target.starts_with('#') || path.exists(), "{page:?}: {target}");
            count += 1;
        }
    }
    assert!(count > 50, "{count} links");
}

#[test]
fn paths_in_architecture_name_files() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let text = fs::read_to_string(root.join("ARCHITECTURE.md")).expect("text");
    let quoted = text.split('`').skip(1).step_by(2);
    let paths: Vec<&str> = quoted.filter(|word| word.ends_with(".rs")).collect();
    for path in &paths {
        let is_there = |folder| root.join(folder).join(path).exists();
        assert!(is_there("") || is_there("src"), "{path}");
    }
    assert!(paths.len() > 30, "{} paths", paths.len());
}

#[test]
fn comments_fit_in_100_columns() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut folders: Vec<_> = ["src", "tests", "examples"].map(|name| root.join(name)).into();
    let mut count = 0;
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() && !path.ends_with("target") {
                folders.push(path);
            } else if path.extension().is_some_and(|end| end == "rs") {
                let text = fs::read_to_string(&path).expect("text");
                let comments = text
                    .lines()
                    .map(str::trim_end)
                    .filter(|line| line.trim_start().starts_with("//") && !line.contains('|'));
                for line in comments {
                    assert!(line.chars().count() <= 100, "{path:?}: {line}");
                    count += 1;
                }
            }
        }
    }
    assert!(count > 1000, "{count} comments");
}
