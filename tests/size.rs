//! The intro's size: at most 65,536 bytes, stripped and not packed.

mod stage;

use object::{Object, ObjectSection};

/// The limit of a 64 kB intro.
const LIMIT: u64 = 65_536;

#[test]
fn the_intro_is_at_most_64_kib() {
    let path = stage::intro();
    let program = std::fs::read(&path).expect("the intro can be read");
    let size = program.len() as u64;
    let file = object::File::parse(&*program).expect("it is an ELF file");
    println!(
        "{}: {size} bytes, {} left",
        path.display(),
        LIMIT as i64 - size as i64
    );
    for section in file.sections() {
        let (start, stored) = section.file_range().unwrap_or_default();
        let name = section.name().unwrap_or("?");
        println!("{start:8} {stored:8}  {name}");
    }
    assert!(file.symbols().next().is_none(), "it is stripped");
    assert!(size <= LIMIT, "{size} bytes are more than {LIMIT}");
}
