//! A scene's file beside an editor that writes it, too.

use eightfold_lab::view::disk::SceneOnDisk;
use std::fs;

#[test]
fn an_answer_is_to_what_was_there_when_it_was_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.ron");
    let write = |text: &str| fs::write(&path, text).expect("it is written");
    let read = || fs::read_to_string(&path).expect("it is there");
    write("one");
    let mut disk = SceneOnDisk::open(&path).expect("it is there");
    write("two");
    let mut save = |told| disk.write("mine", told, || Ok(()));
    let question = save(None).expect_err("a question");
    write("six");
    for told in [Some(&*question), None] {
        assert_eq!(save(told), Err(question.clone()));
        assert_eq!(read(), "six");
    }
    assert_eq!(save(Some(&question)), Ok(()));
    assert_eq!(read(), "mine");
    // What is seen later is as it was written.
    assert_eq!(disk.write("more", None, || Ok(())), Ok(()));
}

#[test]
fn a_file_is_written_in_place_only_if_the_text_is_kept_elsewhere() {
    let folder = tempfile::tempdir().expect("a folder");
    let [path, name] = ["scene.ron", "name.ron"].map(|name| folder.path().join(name));
    fs::write(&path, "one and more").expect("it is written");
    fs::hard_link(&path, &name).expect("a link");
    let mut disk = SceneOnDisk::open(&path).expect("it is there");
    let read = || fs::read_to_string(&name).expect("it is there");
    let full = || Err("full".to_owned());
    assert_eq!(disk.write("mine", None, full), full());
    assert_eq!(read(), "one and more");
    assert_eq!(disk.write("mine", None, || Ok(())), Ok(()));
    assert_eq!(read(), "mine");
}
