//! Executables of 64 bits as Windows has them, as far as they are written.

use std::ops::Range;

use object::{
    pe::{
        self, IMAGE_SCN_CNT_CODE, IMAGE_SCN_CNT_UNINITIALIZED_DATA, IMAGE_SCN_MEM_EXECUTE,
        IMAGE_SCN_MEM_READ, IMAGE_SCN_MEM_WRITE, SectionFlags,
    },
    write::pe::{NtHeaders, Writer},
};

use crate::{
    Error,
    elf::{PAGE, number},
};

/// What the beginning of an image in memory is a multiple of.
pub const BASE_ALIGNMENT: u64 = 1 << 16;
/// What each part of a file is filled to.
const FILE_ALIGNMENT: usize = 512;

// What may be done with a section.
pub const CODE: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_CODE.0 | IMAGE_SCN_MEM_EXECUTE.0 | IMAGE_SCN_MEM_READ.0);
pub const MEMORY: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_UNINITIALIZED_DATA.0 | IMAGE_SCN_MEM_READ.0 | IMAGE_SCN_MEM_WRITE.0);

/// A section, by the page where it begins in the image. It goes on up to the next one; what is not in the file is zero.
pub struct Section {
    pub name: &'static str,
    pub flags: SectionFlags,
    pub address: u64,
    pub bytes: Vec<u8>,
}

/// An executable: addresses are counted from where the image begins.
pub struct Executable {
    pub base: u64,
    /// Where it ends.
    pub end: u64,
    pub entry: u64,
    pub sections: Vec<Section>,
    /// Kinds of directories, and where they are.
    pub directories: Vec<(usize, Range<u64>)>,
}

/// A program that runs in windows: no console opens for it.
const SUBSYSTEM: pe::Subsystem = pe::IMAGE_SUBSYSTEM_WINDOWS_GUI;

/// Memory for the stack of the first thread, as on Linux where threads of the pool have theirs, and how much of it is there at once:
/// more than any function takes before it calls another one.
const STACK: u64 = 1 << 20;
const STACK_AT_ONCE: u64 = 1 << 17;

/// Kinds of directories.
const DIRECTORIES: usize = 16;

/// Where the checksum is: in the optional header, behind a DOS header and that of COFF.
const CHECKSUM: usize = 64 + 4 + 20 + 64;

impl Executable {
    /// Writes the file, with a record as the last bytes of its headers.
    pub fn to_bytes(&self, record: &[u8]) -> Result<Vec<u8>, Error> {
        let mut file = Vec::new();
        let alignment = FILE_ALIGNMENT as u32;
        let mut writer = Writer::new(true, PAGE as u32, alignment, &mut file);
        // Lay out the headers and the sections.
        writer.reserve_dos_header();
        writer.reserve_nt_headers(DIRECTORIES);
        writer.reserve_section_headers(self.sections.len() as u16);
        let head = writer.reserved_len() as usize;
        let ends = self.sections.iter().skip(1).map(|next| next.address);
        let mut places = Vec::new();
        for (section, end) in self.sections.iter().zip(ends.chain([self.end])) {
            let size = end.checked_sub(section.address);
            let size = size.filter(|&size| size >= section.bytes.len() as u64);
            let size = size.ok_or("its segments share a page")?;
            let mut name = [0; 8];
            name[..section.name.len()].copy_from_slice(section.name.as_bytes());
            let length = section.bytes.len() as u32;
            let place = writer.reserve_section(name, section.flags, size as u32, length);
            if u64::from(place.virtual_address) != section.address {
                return Err("its segments are not at pages".into());
            }
            places.push(place.file_offset);
        }
        for (directory, range) in &self.directories {
            let size = range.end - range.start;
            writer.set_data_directory(*directory, range.start as u32, size as u32);
        }
        // Write them.
        writer.write_empty_dos_header()?;
        writer.write_nt_headers(self.headers());
        writer.write_section_headers();
        for (section, place) in self.sections.iter().zip(places) {
            writer.write_section(place, &section.bytes);
        }
        file[head - record.len()..head].copy_from_slice(record);
        set_checksum(&mut file);
        Ok(file)
    }

    fn headers(&self) -> NtHeaders {
        NtHeaders {
            machine: pe::IMAGE_FILE_MACHINE_AMD64,
            // Of no time, so that the same program gives the same bytes.
            time_date_stamp: 0,
            characteristics: pe::IMAGE_FILE_RELOCS_STRIPPED
                | pe::IMAGE_FILE_EXECUTABLE_IMAGE
                | pe::IMAGE_FILE_LARGE_ADDRESS_AWARE,
            major_linker_version: 0,
            minor_linker_version: 0,
            address_of_entry_point: self.entry as u32,
            image_base: self.base,
            // 6.0, the first on x86-64 that has all of this: nothing newer is asked for.
            major_operating_system_version: 6,
            minor_operating_system_version: 0,
            major_image_version: 0,
            minor_image_version: 0,
            major_subsystem_version: 6,
            minor_subsystem_version: 0,
            subsystem: SUBSYSTEM,
            // Data is not executed, and no exceptions are handled.
            dll_characteristics: pe::IMAGE_DLLCHARACTERISTICS_NX_COMPAT
                | pe::IMAGE_DLLCHARACTERISTICS_NO_SEH
                | pe::IMAGE_DLLCHARACTERISTICS_TERMINAL_SERVER_AWARE,
            size_of_stack_reserve: STACK,
            size_of_stack_commit: STACK_AT_ONCE,
            size_of_heap_reserve: 1 << 20,
            size_of_heap_commit: PAGE,
        }
    }
}

/// Computes the checksum that a header has: the sum of all numbers of 16 bits, with what goes beyond added again, and the length.
fn set_checksum(file: &mut [u8]) {
    let sum = file.chunks(2).fold(0, |sum, pair| {
        let sum = sum + number(pair, 0, pair.len()) as u32;
        (sum & 0xffff) + (sum >> 16)
    });
    let sum = sum + file.len() as u32;
    file[CHECKSUM..CHECKSUM + 4].copy_from_slice(&sum.to_le_bytes());
}

/// What Windows reads of functions that are imported of one library.
pub struct Imports {
    /// What is in the place of the functions' addresses before Windows has put these there.
    pub addresses: Vec<u8>,
    /// The directory, and the names.
    pub names: Vec<u8>,
}

impl Imports {
    /// Bytes of the directory: one library, and none.
    pub const DIRECTORY: u64 = 2 * 20;

    /// The imports for where in the image both are.
    pub fn new(library: &str, functions: &[&str], addresses: u64, names: u64) -> Imports {
        let library_at = (names + Imports::DIRECTORY) as u32;
        let descriptors = [0, 0, 0, library_at, addresses as u32, 0, 0, 0, 0, 0];
        let mut imports = Imports {
            addresses: Vec::new(),
            names: descriptors.map(u32::to_le_bytes).concat(),
        };
        let bytes = &mut imports.names;
        bytes.extend(library.as_bytes());
        bytes.push(0);
        for name in functions {
            bytes.resize(bytes.len().next_multiple_of(2), 0);
            let address = names + bytes.len() as u64;
            imports.addresses.extend(address.to_le_bytes());
            // No hint of where it may be found.
            bytes.extend([0, 0]);
            bytes.extend(name.as_bytes());
            bytes.push(0);
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        imports.addresses.extend([0; 8]);
        imports
    }
}
