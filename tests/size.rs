//! The intro's size: at most 65,536 bytes, stripped and not packed; without its soundtrack, at most 61,440.

mod stage;

use object::{
    Object, ObjectSection, ObjectSymbol, RelocationTarget,
    read::{archive::ArchiveFile, elf::ElfFile64},
};
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

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
    let map = stage::intro_map();
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

/// What the show may take without its soundtrack, which has the rest.
const LIMIT_SILENT: u64 = 61_440;

#[test]
fn the_show_without_its_soundtrack_is_at_most_60_kib() {
    let silent = stage::intro_with(&["--no-default-features", "--features", "avx2,details"]);
    let size = |path: &Path| fs::metadata(path).expect("the intro").len();
    let (all, silent) = (size(&stage::intro()), size(&silent));
    println!(
        "the show: {silent} bytes, {} left; its soundtrack: {}",
        LIMIT_SILENT as i64 - silent as i64,
        all as i64 - silent as i64
    );
    assert!(
        silent <= LIMIT_SILENT,
        "{silent} bytes are more than {LIMIT_SILENT}"
    );
    assert!(
        silent < all,
        "{silent} bytes without a soundtrack, {all} with it"
    );
}

/// The linker leaves out parts of libraries by their names (`.unsaid` in `src/window/program.ld`): they may be nothing but
/// the places of panics, 24 bytes that begin with the address of a file's name, and those names.
#[test]
fn nothing_is_left_unsaid_but_where_panics_were() {
    let map = stage::intro_map();
    let mut places: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let mut texts = 0;
    let lines = map.lines().skip_while(|line| !line.ends_with(" .unsaid"));
    for line in lines
        .skip(1)
        .take_while(|line| !line.ends_with("= 0x400000"))
    {
        // The names of functions are on lines of their own.
        let Some((part, section)) = line.rsplit_once(":(") else {
            continue;
        };
        let [_, _, size, _, of] = part.split_whitespace().collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        if of == "<internal>" {
            assert_eq!(section, ".rodata.str1.1)");
            texts += usize::from_str_radix(size, 16).expect("a size");
        } else if of.contains("/libminifb-") && !section.starts_with(".data.rel.ro") {
            // What it says of errors, and what it does with that.
            let known = [".rodata..Lanon", "to_vec", "RawVecInner", "drop_in_place"];
            assert!(known.iter().any(|part| section.contains(part)), "{line}");
        } else if !section.starts_with(".rodata.str") {
            assert_eq!(size, "18", "{line}: a size of 24");
            let (archive, _) = of.split_once('(').expect("a member of an archive");
            let section = section.strip_suffix(')').expect("an end");
            places.entry(archive).or_default().insert(section);
        }
    }
    let count: usize = places.values().map(BTreeSet::len).sum();
    println!("{count} places of panics");
    // Only the library's texts are left out, and each of them once.
    let is_library = |path: &str| path.contains("/libeightfold-");
    let mut files = BTreeSet::new();
    for (path, sections) in &places {
        let found = files_of_places(Path::new(path), sections);
        assert_eq!(found.len(), sections.len(), "{path}: places of panics");
        if is_library(path) {
            files.extend(found);
        }
    }
    assert!(places.keys().any(|path| is_library(path)));
    let said: usize = files.iter().map(|file| file.len() + 1).sum();
    // And what minifb would print of a title with a NUL in it.
    let printed = "\u{12}Unable to convert \u{c0}\u{c} to c_string\n\0".chars();
    assert_eq!(
        said + printed.count(),
        texts,
        "{files:?} is all that is left out"
    );
}

/// The names of source files that these sections of an archive begin with the address of.
fn files_of_places(path: &Path, sections: &BTreeSet<&str>) -> Vec<Vec<u8>> {
    let data = fs::read(path).expect("the archive can be read");
    let members = ArchiveFile::parse(&*data).expect("an archive").members();
    let mut files = Vec::new();
    for member in members.map(|member| member.expect("a member")) {
        if let Ok(file) = Elf::parse(member.data(&*data).expect("its bytes")) {
            let wanted = file
                .sections()
                .filter(|section| section.name().is_ok_and(|name| sections.contains(name)));
            files.extend(wanted.filter_map(|section| file_of_place(&file, &section)));
        }
    }
    files
}

/// The text that ends with `.rs` and a NUL whose address is at the beginning of a section, and nothing else is.
fn file_of_place<'a>(file: &Elf<'a>, section: &impl ObjectSection<'a>) -> Option<Vec<u8>> {
    let relocations: Vec<_> = section.relocations().collect();
    let [(0, relocation)] = &relocations[..] else {
        return None;
    };
    let RelocationTarget::Symbol(symbol) = relocation.target() else {
        return None;
    };
    let symbol = file.symbol_by_index(symbol).ok()?;
    let texts = file.section_by_index(symbol.section_index()?).ok()?;
    let start = symbol.address().checked_add_signed(relocation.addend())?;
    let texts = texts.data().ok()?.get(start as usize..)?;
    let text = texts.split(|&byte| byte == 0).next()?;
    text.ends_with(b".rs").then(|| text.to_vec())
}
