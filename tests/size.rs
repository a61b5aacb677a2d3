//! The intro's size: at most 65,536 bytes, stripped and not packed.

mod stage;

use object::{Object, read::elf::ElfFile64};

/// The limit of a 64 kB intro.
const LIMIT: u64 = 65_536;

#[test]
fn the_intro_is_at_most_64_kib() {
    let path = stage::intro();
    let program = std::fs::read(&path).expect("the intro can be read");
    let size = program.len() as u64;
    println!(
        "{}: {size} bytes, {} left",
        path.display(),
        LIMIT as i64 - size as i64
    );
    // The linker's map tells what is in it; the program has no headers that would. In columns: the address, twice, the
    // size, the alignment, and what it is of; a name with a point is a section's, with its parts below it. `.bss` is
    // memory and not in the file.
    let map = std::fs::read_to_string(path.with_extension("map")).expect("the linker's map");
    for line in map.lines() {
        if let [address, _, size, _, name] = line.split_whitespace().collect::<Vec<_>>()[..]
            && address != "0"
            && name.starts_with('.')
            && name != ".bss"
        {
            let size = u64::from_str_radix(size, 16).expect("a size");
            println!("{size:12}  {name}");
        }
    }
    let file = ElfFile64::<object::Endianness>::parse(&*program).expect("it is an ELF file");
    assert!(file.symbols().next().is_none(), "it is stripped");
    assert!(size <= LIMIT, "{size} bytes are more than {LIMIT}");
}
