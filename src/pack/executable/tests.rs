use object::read::pe::{ImageNtHeaders, Import, PeFile64};
use object::{Architecture, BinaryFormat, Endianness, LittleEndian as LE, SectionKind, pe, write};

use super::{System, pack_executable, strip, unpack_executable, windows};
use crate::checksum;
use crate::elf::{self, EXECUTE, HEADER_SIZE, READ, Segment, WRITE};

const BASE: u64 = 0x41_0000;

fn program() -> Vec<u8> {
    let code: Vec<u8> = (0..3000).map(|i| [0xc3, 0x89, 0x8b, i as u8][i % 4]).collect();
    let parts = [
        (READ, vec![7; 600], 600),
        (READ | EXECUTE, code, 3000),
        (READ | WRITE, vec![1, 2, 3], 30 << 20),
    ];
    let kinds = [elf::INTERPRETER, elf::PROGRAM_HEADERS];
    let head = HEADER_SIZE + (parts.len() + kinds.len()) * Segment::SIZE;
    let mut segments =
        kinds.map(|kind| Segment { kind, address: BASE, ..Segment::default() }).to_vec();
    let mut bytes = vec![0; head];
    for (i, (flags, part, size)) in parts.into_iter().enumerate() {
        let offset = if i == 0 { 0 } else { bytes.len() };
        bytes.extend(part);
        let file_size = (bytes.len() - offset) as u64;
        segments.push(Segment {
            kind: elf::LOAD,
            flags,
            offset: offset as u64,
            address: BASE + (i as u64) * 0x1_0000 + offset as u64 % elf::PAGE,
            file_size,
            size: file_size.max(size),
            ..Segment::default()
        });
    }
    let headers: Vec<_> = segments.iter().flat_map(|part| part.to_bytes()).collect();
    bytes[..HEADER_SIZE].copy_from_slice(&elf::header(BASE + 0x1_0300, segments.len() as u16));
    bytes[HEADER_SIZE..head].copy_from_slice(&headers);
    bytes
}

fn stub() -> Vec<u8> {
    let mut object =
        write::Object::new(BinaryFormat::Elf, Architecture::X86_64, Endianness::Little);
    for name in [".text.first", ".text.stage", ".text.loader"] {
        let section = object.add_section(Vec::new(), name.into(), SectionKind::Text);
        object.append_section_data(section, &[0x90, 0xc3], 16);
    }
    object.write().expect("an object")
}

fn packed(system: &System) -> Vec<u8> {
    pack_executable(&program(), &stub(), system).expect("it is packed")
}

#[test]
fn executable_unpacks_to_stripped_program() {
    let stripped = strip(&program()).expect("it is a program");
    for system in [System::Linux, System::Windows] {
        assert!(unpack_executable(&packed(&system)).expect("it is packed") == stripped);
    }
}

/// Changes bytes behind the stub's first section, except padding, and cuts the file anywhere.
#[test]
fn damaged_files_are_refused() {
    for (system, checked) in [(System::Linux, 178), (System::Windows, 512 + 80 + 2)] {
        let packed = packed(&system);
        let end = packed.iter().rposition(|&byte| byte != 0).expect("bytes") + 1;
        for place in (checked..end).step_by(7).chain([end - 1]) {
            let mut damaged = packed.clone();
            damaged[place] ^= 0x10;
            assert!(unpack_executable(&damaged).is_err(), "byte {place}");
        }
        for length in (0..end).step_by(7).chain([end - 1]) {
            let cut = unpack_executable(&packed[..length]);
            assert!(cut.is_err(), "{length} bytes");
        }
    }
}

#[test]
fn executable_packing_is_reproducible() {
    let sums = [System::Linux, System::Windows].map(|system| checksum(&packed(&system)));
    assert_eq!(sums, [256_219_033, 30_417_414]);
}

/// Checks Windows' requirements, with another reader of PE files.
#[test]
fn windows_file_is_valid() {
    let file = packed(&System::Windows);
    let parsed = PeFile64::parse(&*file).expect("it is a PE file");
    let optional = parsed.nt_headers().optional_header();
    assert_eq!(file.len() % 512, 0);
    let mut next = 0x1000;
    for section in parsed.section_table().iter() {
        let flags = section.characteristics.get(LE);
        let is_both = flags.contains(pe::IMAGE_SCN_MEM_WRITE | pe::IMAGE_SCN_MEM_EXECUTE);
        assert!(!is_both, "memory for both writing and executing");
        let (address, size) = section.pe_address_range();
        assert_eq!(address, next, "a gap between sections");
        next = (address + size).next_multiple_of(0x1000);
        assert!(section.pe_data(&*file).is_ok(), "bytes that are not there");
    }
    assert_eq!(optional.size_of_image.get(LE), next);
    let base = optional.image_base.get(LE);
    assert!(base % 0x1_0000 == 0 && base + u64::from(next) >= BASE + 0x2_0000 + (30 << 20));
    let entry = optional.address_of_entry_point.get(LE);
    let is_code = |section: &pe::ImageSectionHeader| section.contains_rva(entry);
    assert!(parsed.section_table().iter().position(is_code) == Some(0));
    let table = parsed.import_table().expect("a table").expect("imports");
    let mut libraries = table.descriptors().expect("libraries");
    let library = libraries.next().expect("a library").expect("one at least");
    let name = table.name(library.name.get(LE)).expect("a name");
    assert_eq!(name, b"kernel32.dll");
    assert!(libraries.next().expect("an end").is_none());
    let mut thunks = table.thunks(library.first_thunk.get(LE)).expect("functions");
    for function in windows::FUNCTIONS {
        let thunk = thunks.next::<pe::ImageNtHeaders64>().expect("a function");
        let import = table.import::<pe::ImageNtHeaders64>(thunk.expect("enough thunks"));
        let is_it = |import| matches!(import, Import::Name(_, name) if name == function.as_bytes());
        assert!(import.is_ok_and(is_it), "{function}");
    }
}

#[test]
fn programs_without_header_space_are_refused() {
    // No room before it; too high for the stub.
    for base in [0, 0x1000, 1 << 31] {
        let mut program = program();
        let mut segments = elf::segments(&program).expect("segments");
        segments.iter_mut().for_each(|it| it.address = it.address - BASE + base);
        elf::set_segments(&mut program, &segments).expect("the same number of segments");
        let packed = pack_executable(&program, &stub(), &System::Windows);
        assert!(packed.is_err(), "{base:#x}");
    }
}
