use crate::display::{SCENE, SIZE, View, bright};
use std::fs;

fn ball(radius: &str) -> String {
    SCENE.replace("radius: 1.0", &format!("radius: {radius}"))
}

#[test]
fn written_or_replaced_file_is_shown() {
    let Some(view) = View::of_file() else { return };
    // Texts of the same length in a row.
    for radius in ["1.4", "0.7", "0.8"] {
        view.write(&ball(radius));
    }
    view.assert_shows_file();
    let [new, old] = ["new", "old"].map(|name| view.folder.path().join(name));
    fs::write(&new, ball("1.4")).expect("it is written");
    fs::rename(&new, &view.file).expect("it is replaced");
    view.assert_shows_file();
    // First missing, then an older file.
    fs::rename(&view.file, &old).expect("it is moved away");
    view.write(&ball("0.7"));
    view.assert_shows_file();
    fs::rename(&old, &view.file).expect("it is replaced");
    view.assert_shows_file();
}

#[test]
fn mistake_is_shown_over_picture() {
    let Some(view) = View::of_file() else { return };
    let picture = view.shot();
    // The height of two lines of text.
    let top = 60 * SIZE[0] as usize;
    for faulty in [ball("1.0.0"), ball("-1.0"), SCENE.replace("\"red\")]", "\"gold\")]")] {
        view.write(&faulty);
        view.assert_shows("text over the picture", |shot| {
            bright(&shot[..top]) > 100 && shot[top..] == picture[top..]
        });
        view.write(SCENE);
        view.assert_shows_file();
    }
    fs::remove_file(&view.file).expect("it is removed");
    view.assert_shows("text", |shot| bright(&shot[..top]) > 100);
    view.write(SCENE);
    view.assert_shows_file();
}
