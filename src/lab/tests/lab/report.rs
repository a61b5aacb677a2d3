//! `docs/report` replaces the output of commands in these pages.

use eightfold_stage::texts;
use std::fs;
use std::path::Path;
use std::process::Command;

const README: &str = "# A title\n\n<!-- report picture -->\n\n![A](a.png)\n\n    echo drawn > a.png\n\n<!-- report end -->\nThe end\n";
const PAGE: &str = "Text\n<!-- report table -->\n\n    echo '| 1 |'\n    echo '| 2 |'\n\nold\n\n<!-- report end -->\nBy hand\n";

/// Returns the two pages, whether the picture was drawn, and the last line of an error.
fn report(page: &str, names: &str) -> ([String; 2], bool, String) {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    fs::create_dir(at("docs")).unwrap();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/report");
    fs::copy(script, at("docs/report")).unwrap();
    fs::write(at("README.md"), README).unwrap();
    fs::write(at("docs/page.md"), page).unwrap();
    let mut bash = Command::new("bash");
    let output = bash.arg(at("docs/report")).args(names.split_whitespace());
    let output = output.output().expect("bash runs");
    let pages = ["README.md", "docs/page.md"].map(|name| fs::read_to_string(at(name)).unwrap());
    let message = texts(&output).1;
    let last = message.lines().last().unwrap_or_default();
    let last = if output.status.success() { "" } else { last };
    (pages, at("a.png").exists(), last.to_owned())
}

#[test]
fn parts_show_results_of_their_commands() {
    let page = PAGE.replace("old", "| 1 |\n| 2 |");
    for (names, new, is_drawn) in
        [("", &*page, true), ("table", &page, false), ("picture", PAGE, true)]
    {
        let expected = ([README, new].map(str::to_owned), is_drawn, String::new());
        assert_eq!(report(PAGE, names), expected, "{names}");
    }
}
