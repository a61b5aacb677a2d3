//! Lists the skipped tests of `cargo test`.

use eightfold_stage::missing;
use std::{collections::BTreeMap, env, fs, path::Path};

fn count(folder: &Path, reasons: &mut BTreeMap<String, usize>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            count(&path, reasons);
        } else if path.extension().is_some_and(|end| end == "rs") {
            let text = fs::read_to_string(&path).expect("text");
            let lines = text.lines().map(str::trim_start);
            for reason in lines.filter_map(|line| line.strip_prefix("#[ignore = \"")) {
                let reason = reason.trim_end_matches("\"]").to_owned();
                *reasons.entry(reason).or_default() += 1;
            }
        }
    }
}

fn main() {
    if env::args().len() > 1 {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut reasons = BTreeMap::new();
    for folder in ["src", "tests"] {
        count(&root.join(folder), &mut reasons);
    }
    println!("Skipped tests, by reason:");
    for (reason, tests) in reasons {
        println!("    {tests:3}  {reason}");
    }
    for (tool, package) in missing() {
        println!("         {tool} is missing: apt-get install {package}");
    }
    println!("`tests/run` installs the tools and runs these tests.\n");
}
