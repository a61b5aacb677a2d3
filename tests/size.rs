//! The intro's size: at most 65,536 bytes, stripped and not packed.

mod stage;

use object::{
    Object, ObjectSection, ObjectSymbol, RelocationTarget,
    read::{archive::ArchiveFile, elf::ElfFile64},
};
use std::{collections::BTreeSet, fs, path::Path};

type Elf<'a> = ElfFile64<'a, object::Endianness>;

/// The limit of a 64 kB intro.
const LIMIT: u64 = 65_536;

#[test]
fn the_intro_is_at_most_64_kib() {
    let path = stage::intro();
    let program = fs::read(&path).expect("the intro can be read");
    let size = program.len() as u64;
    println!(
        "{}: {size} bytes, {} left",
        path.display(),
        LIMIT as i64 - size as i64
    );
    // The linker's map tells what is in it; the program has no headers that would. In columns: the address, twice, the
    // size, the alignment, and what it is of; a name with a point is a section's, with its parts below it. `.bss` and
    // `.unsaid` are not in the file.
    let map = fs::read_to_string(path.with_extension("map")).expect("the linker's map");
    for line in map.lines() {
        if let [address, _, size, _, name] = line.split_whitespace().collect::<Vec<_>>()[..]
            && address != "0"
            && name.starts_with('.')
            && ![".bss", ".unsaid"].contains(&name)
        {
            let size = u64::from_str_radix(size, 16).expect("a size");
            println!("{size:12}  {name}");
        }
    }
    let file = Elf::parse(&*program).expect("it is an ELF file");
    assert!(file.symbols().next().is_none(), "it is stripped");
    assert!(size <= LIMIT, "{size} bytes are more than {LIMIT}");
}

/// The linker leaves out parts of the library by their names (`.unsaid` in `src/window/program.ld`): they may be nothing
/// but the places of panics, 24 bytes that begin with the address of a file's name, and those names.
#[test]
fn nothing_is_left_unsaid_but_where_panics_were() {
    let map = fs::read_to_string(stage::intro().with_extension("map")).expect("the linker's map");
    let mut parts = 0;
    let mut archives = BTreeSet::new();
    let lines = map.lines().skip_while(|line| !line.ends_with(" .unsaid"));
    for line in lines
        .skip(1)
        .take_while(|line| !line.ends_with("= 0x400000"))
    {
        let (archive, section) = line.rsplit_once(":(").expect("a part of an archive");
        if section.starts_with(".rodata.str") || line.contains("<internal>") {
            continue;
        }
        assert_eq!(
            line.split_whitespace().nth(2),
            Some("18"),
            "{line}: a size of 24"
        );
        parts += 1;
        let (archive, _) = archive.split_once('(').expect("a member of an archive");
        let path = archive.split_whitespace().last().expect("a path");
        if archives.insert(path.to_string()) {
            assert_places_of_panics(Path::new(path), path.contains("/libeightfold-"));
        }
    }
    println!("{parts} places of panics, {archives:?}");
    assert!(archives.iter().any(|path| path.contains("/libeightfold-")));
}

/// All that the linker leaves out of an archive begins with the name of a source file, and is 24 bytes; and of the
/// library, all texts that end with a NUL are such names.
fn assert_places_of_panics(path: &Path, is_library: bool) {
    let data = fs::read(path).expect("the archive can be read");
    let members = ArchiveFile::parse(&*data).expect("an archive").members();
    for member in members.map(|member| member.expect("a member")) {
        let Ok(file) = Elf::parse(member.data(&*data).expect("its bytes")) else {
            continue;
        };
        for section in file.sections() {
            let name = section.name().expect("a name");
            if is_library && name.starts_with(".rodata.str") {
                for text in section
                    .data()
                    .expect("bytes")
                    .split_inclusive(|&byte| byte == 0)
                {
                    assert!(text.ends_with(b".rs\0"), "{name}: {text:?}");
                }
            }
            if is_library && name.starts_with(".data.rel.ro..Lanon.") {
                assert_eq!(section.size(), 24, "{name}");
                assert!(begins_with_a_file_name(&file, &section), "{name}");
            }
        }
    }
}

/// Whether what is at the beginning of a section is the address of a text that ends with `.rs` and a NUL.
fn begins_with_a_file_name<'a>(file: &Elf<'a>, section: &impl ObjectSection<'a>) -> bool {
    let relocations: Vec<_> = section.relocations().collect();
    let [(0, relocation)] = &relocations[..] else {
        return false;
    };
    let RelocationTarget::Symbol(symbol) = relocation.target() else {
        return false;
    };
    let symbol = file.symbol_by_index(symbol).expect("a symbol");
    let texts = file
        .section_by_index(symbol.section_index().expect("a section"))
        .expect("a section");
    let start = symbol.address() as i64 + relocation.addend();
    let text = &texts.data().expect("bytes")[start as usize..];
    text.split(|&byte| byte == 0)
        .next()
        .is_some_and(|text| text.ends_with(b".rs"))
}
