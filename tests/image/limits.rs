//! Every test that the documentation of `limits` names exists.

use std::fs;
use std::path::Path;

/// The text of all files in a folder and in those below it.
fn sources(folder: &Path) -> String {
    let mut text = String::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            text += &sources(&path);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            text += &fs::read_to_string(path).unwrap();
        }
    }
    text
}

#[test]
fn every_test_that_the_limits_name_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let all = sources(&root.join("src")) + &sources(&root.join("tests"));
    let page = fs::read_to_string(root.join("src/tracer/limits.rs")).unwrap();
    // Quoted words with at least three underscores are names of tests.
    let is_test = |word: &&str| word.matches('_').count() >= 3 && !word.contains(['/', ' ', '(']);
    let named: Vec<&str> = page.split('`').skip(1).step_by(2).filter(is_test).collect();
    for test in &named {
        assert!(all.contains(&format!("fn {test}(")), "there is no {test}");
    }
    assert!(named.len() > 20, "{named:?}");
}
