//! The pages in Markdown: links that lead somewhere, and a README that is read to its end.

use eightfold::show::{self, grid};
use std::{
    fs,
    path::{Path, PathBuf},
};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The pages in a folder.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .filter(|path| path.extension().is_some_and(|end| end == "md"))
        .collect()
}

/// Where the links and the pictures of a text lead.
fn links(text: &str) -> impl Iterator<Item = &str> {
    let parts = text.split("](").skip(1);
    parts.filter_map(|part| part.split_once(')').map(|(link, _)| link))
}

#[test]
fn links_lead_to_files_that_are_there() {
    let all = [pages(root()), pages(&root().join("docs"))].concat();
    assert!(all.len() > 7, "{all:?}");
    for page in all {
        let text = fs::read_to_string(&page).expect("text");
        let folder = page.parent().expect("a folder");
        for link in links(&text).filter(|link| !link.starts_with("http")) {
            let (path, _) = link.split_once('#').unwrap_or((link, ""));
            assert!(folder.join(path).exists(), "{}: {link}", page.display());
        }
    }
    assert_eq!(
        links("[a](b) ![c](d/e.svg)").collect::<Vec<_>>(),
        ["b", "d/e.svg"]
    );
}

#[test]
fn the_architecture_names_files_that_are_there() {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("text");
    let words = text.split('`').skip(1).step_by(2);
    let paths = words.filter(|word| word.starts_with("src/") || word.starts_with("tests/"));
    let mut count = 0;
    for path in paths {
        assert!(root().join(path).exists(), "{path}");
        count += 1;
    }
    assert!(count > 20, "{count} paths");
}

#[test]
fn pages_tell_the_length_of_the_show_and_where_its_scenes_begin() {
    let has = |page: &str, words: &str| {
        let text = fs::read_to_string(root().join(page)).expect("text");
        assert!(text.contains(words), "{page} does not say {words:?}");
    };
    let (seconds, bars) = (show::LENGTH, show::BARS);
    has("README.md", &format!("a show of {seconds} seconds"));
    has("CHANGELOG.md", &format!("The show of {seconds} seconds"));
    has("src/eightfold.nfo", &format!("{seconds} seconds"));
    has(
        "docs/sound.md",
        &format!("{bars} bars of {} seconds", grid::BAR),
    );
    has("docs/intro.md", &format!("the show, {seconds} s |"));
    has("docs/intro.md", &format!("from 0 to below {seconds} s,"));
    for (name, cut) in show::NAMES.iter().zip(show::CUTS) {
        let start = cut as f32 * grid::BAR;
        has("docs/intro.md", &format!("\n| {start} s | {name} |"));
    }
}

#[test]
fn the_spotlight_of_the_page_is_that_of_the_example() {
    let text = |name: &str| fs::read_to_string(root().join(name)).expect("text");
    let (page, example) = (text("docs/lab.md"), text("examples/scenes/lights.ron"));
    let mut spots = page.lines().filter(|line| line.contains("spot: ("));
    assert!(example.contains(spots.next().expect("a spotlight").trim()));
}

/// The cells of a table's row that is for the default quality and, if the row has them, given first cells.
fn default_row(page: &str, first: &[String]) -> Vec<String> {
    let text = fs::read_to_string(root().join(page)).expect("text");
    let cells = |line: &str| -> Vec<String> {
        let cells = line.trim_matches('|').split('|');
        cells.map(|cell| cell.trim().to_owned()).collect()
    };
    let mut rows = text.lines().map(cells);
    rows.find(|row| row.starts_with(first) && row.contains(&"default".to_owned()))
        .expect("a row")
}

#[test]
fn the_readme_has_the_figures_of_the_tables() {
    let readme = fs::read_to_string(root().join("README.md")).expect("text");
    let readme = readme.replace('\n', " ");
    let smooth = default_row("docs/speed.md", &["1024x768".into(), "1".into()]);
    let jagged = default_row("docs/accuracy.md", &["default".into()]);
    let speed = |cell: &str| format!("{:.1} times", cell.parse::<f64>().expect("a number"));
    let psnr = smooth[11].trim_end_matches(" dB").parse::<f64>();
    for figure in [
        format!("{} as fast as tracing every pixel", speed(&smooth[18])),
        format!("a PSNR of {:.0} dB", psnr.expect("a number")),
        format!(
            "with jagged edges, as in the plots, it is {}",
            speed(&jagged[2])
        ),
        format!(
            "traces {} of the pixels, or {} with antialiased edges",
            jagged[3], smooth[7]
        ),
    ] {
        assert!(
            readme.contains(&figure),
            "README.md does not say {figure:?}"
        );
    }
}

/// The share of the pixels of the show that are traced as it is played by the default quality, in percent, by the table of its scenes.
fn traced_share_of_the_show() -> f64 {
    let ends = show::CUTS[1..].iter().chain([&show::BARS]);
    let scenes = show::NAMES.iter().zip(show::CUTS).zip(ends);
    let shares = scenes.map(|((name, start), end)| {
        let row = default_row(
            "docs/speed.md",
            &["1280x720".into(), "2".into(), format!("show:{name}")],
        );
        let traced = row[8].trim_end_matches(" %").parse::<f64>();
        traced.expect("a number") * f64::from(end - start)
    });
    shares.sum::<f64>() / f64::from(show::BARS)
}

#[test]
fn all_texts_say_which_share_of_the_show_is_traced_by_its_table() {
    let numbers = ["six", "seven", "eight", "nine", "ten"];
    let one_in = (100.0 / traced_share_of_the_show()).round() as usize;
    let number = numbers[one_in - 6];
    for name in [
        "README.md",
        "src/tracer/README.md",
        "src/tracer/Cargo.toml",
        "src/web/page/index.html",
    ] {
        let text = fs::read_to_string(root().join(name)).expect("text");
        let text = text.replace('\n', " ");
        let mut told = text.split("one pixel in ").skip(1);
        let said = told
            .next()
            .unwrap_or_else(|| panic!("{name} does not say it"));
        for said in [said].into_iter().chain(told) {
            assert!(said.starts_with(number), "{name} does not say {number}");
        }
    }
}

#[test]
fn the_readme_is_short() {
    let text = fs::read_to_string(root().join("README.md")).expect("text");
    let lines = text.lines().count();
    assert!(lines < 150, "{lines} lines");
}
