//! `lab study` makes one page of all that is measured of a scene.

use super::{command, lab, said};
use base64::{Engine, prelude::BASE64_STANDARD};
use eightfold_stage::reader::read_png;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;

fn scene() -> String {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples/scenes");
    examples.join("first.ron").display().to_string()
}

#[test]
#[ignore = "many frames"]
fn the_page_has_every_measurement_inside_and_the_command_above_it() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("first.html");
    let scene = scene();
    let output = lab(&format!(
        "study {scene} --size 64x48 --frames 2 --out {}",
        out.display()
    ));
    let said = said(&output);
    assert!(
        output.status.success() && output.stdout.is_empty(),
        "{said}"
    );

    let page = fs::read_to_string(&out).unwrap();
    assert!(page.contains(&format!("<title>Study of {scene}</title>")));
    for command in [
        "capture --scene",
        "figures --scene",
        "bench --scene",
        "trade --scene",
    ] {
        assert!(
            page.contains(&format!("<code>cargo lab {command} {}", scene)),
            "{command}"
        );
    }
    for cell in [">speed-up</th>", ">fastest</td>"] {
        assert!(page.contains(cell), "{cell}");
    }
    assert_eq!(page.matches("<table>").count(), 3);
    assert_eq!(page.matches("<svg ").count(), 3);
    assert_eq!(page.matches("</svg>").count(), 3);
    let pictures: Vec<&str> = page.split("data:image/png;base64,").skip(1).collect();
    assert_eq!(pictures.len(), 2);
    for picture in pictures {
        let data = picture.split('"').next().expect("an end");
        let (width, pixels) = read_png(&BASE64_STANDARD.decode(data).unwrap());
        assert!(width >= 2 * 64 && !pixels.is_empty());
    }
    // A colleague has nothing but this file.
    for link in ["src=\"", "href=\""] {
        let links = page.split(link).skip(1);
        assert!(
            links.into_iter().all(|link| link.starts_with("data:")),
            "{link}"
        );
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn a_study_that_is_stopped_leaves_nothing_behind() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("model.html");
    let mut child = command("study model --out")
        .arg(&out)
        .env("TMPDIR", folder.path())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the lab starts");
    let mut said = BufReader::new(child.stderr.take().expect("a pipe")).lines();
    let first = said.next().expect("a line").unwrap();
    assert!(first.starts_with("cargo lab capture"), "{first}");
    assert!(crate::signal(&child.id().to_string(), "INT"));
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let last = said.last().expect("a line").unwrap();
    assert!(last.contains("stopped early"), "{last}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
}
