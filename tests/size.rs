//! The intro's size.

mod stage;

use std::fs;

#[test]
fn the_intro_is_stripped() {
    let program = fs::read(stage::intro()).expect("the intro can be read");
    let file = object::File::parse(&*program).expect("it is an ELF file");
    assert!(
        object::Object::symbols(&file).next().is_none(),
        "it is stripped"
    );
}
