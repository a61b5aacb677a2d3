use super::{assert_one_line, lab, stderr};
use eightfold_stage::reader::read_png;
use std::fs;
use std::process::Output;
use tempfile::TempDir;

const README: &str = "# A title\n\n<!-- lab report picture -->\n\n![A picture](docs/a.png)\n\n    \
                      cargo lab render --size 9x7 --out docs/a.png\n\n<!-- lab report end -->\nThe end";
const PAGE: &str = "Text\n<!-- lab report table -->\n\n    cargo lab missed --scene model --size 16x12 --frames 1\n\nold\n\n\
                    <!-- lab report end -->\nBy hand\n";

fn folder(readme: &str, page: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("docs")).unwrap();
    fs::write(folder.path().join("README.md"), readme).unwrap();
    fs::write(folder.path().join("docs/page.md"), page).unwrap();
    folder
}

fn report(folder: &TempDir, names: &str) -> Output {
    lab(&format!(
        "report {names} --folder {}",
        folder.path().display()
    ))
}

#[test]
fn parts_show_results_of_their_commands() {
    let folder = folder(README, PAGE);
    let output = report(&folder, "");
    assert!(output.status.success(), "{}", stderr(&output));
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    assert_eq!(read("README.md"), README);
    let picture = fs::read(folder.path().join("docs/a.png")).unwrap();
    assert_eq!(read_png(&picture).0, 9);
    let (command, rest) = PAGE.split_once("\n\nold\n").unwrap();
    let page = read("docs/page.md");
    let table = page
        .strip_prefix(command)
        .and_then(|page| page.strip_suffix(rest));
    let table = table.expect("the rest of the page is as before");
    assert!(table.starts_with("\n\ndefault quality, 16x12"), "{table}");
    assert!(table.ends_with(" |\n"), "{table}");
}

#[test]
fn only_named_parts_are_updated() {
    let folder = folder(README, PAGE);
    assert!(report(&folder, "picture").status.success());
    assert_eq!(
        fs::read_to_string(folder.path().join("docs/page.md")).unwrap(),
        PAGE
    );
    assert!(folder.path().join("docs/a.png").exists());
    let known = "part is tables; must be one of picture, table";
    assert_one_line(&report(&folder, "tables"), 2, &[known]);
}

#[test]
fn failing_part_keeps_all_pages() {
    for (page, why) in [
        (
            "\n<!-- lab report a -->\n",
            "page.md: part a: <!-- lab report end --> is missing",
        ),
        (
            "\n<!-- lab report a -->\n    exit 3\n<!-- lab report end -->",
            "part a: command failed: exit status: 3",
        ),
    ] {
        let folder = folder(&PAGE.replace("old", ""), page);
        let output = report(&folder, "");
        assert_eq!(output.status.code(), Some(1));
        assert!(stderr(&output).contains(why), "{}", stderr(&output));
        let text = fs::read_to_string(folder.path().join("README.md")).unwrap();
        assert_eq!(text, PAGE.replace("old", ""));
    }
    let empty = tempfile::tempdir().unwrap();
    assert_one_line(&report(&empty, ""), 1, &["README.md: cannot read: "]);
}
