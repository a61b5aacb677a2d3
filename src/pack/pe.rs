//! Writes 64-bit PE files.

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

pub const BASE_ALIGNMENT: u64 = 1 << 16;
const FILE_ALIGNMENT: usize = 512;

pub const CODE: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_CODE.0 | IMAGE_SCN_MEM_EXECUTE.0 | IMAGE_SCN_MEM_READ.0);
pub const MEMORY: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_UNINITIALIZED_DATA.0 | IMAGE_SCN_MEM_READ.0 | IMAGE_SCN_MEM_WRITE.0);

/// A section. It extends to the next one; bytes beyond `bytes` are zero.
pub struct Section {
    pub name: &'static str,
    pub flags: SectionFlags,
    pub address: u64,
    pub bytes: Vec<u8>,
}

/// An executable. Addresses are relative to `base`.
pub struct Executable {
    pub base: u64,
    pub end: u64,
    pub entry: u64,
    pub sections: Vec<Section>,
    pub directories: Vec<(usize, Range<u64>)>,
}

const SUBSYSTEM: pe::Subsystem = pe::IMAGE_SUBSYSTEM_WINDOWS_GUI;

/// The stack's size, and the committed part, which is larger than any function's frame.
const STACK: u64 = 1 << 20;
const STACK_AT_ONCE: u64 = 1 << 17;

const DIRECTORIES: usize = 16;

/// The file offset of the checksum in the optional header, after the DOS and COFF headers.
const CHECKSUM: usize = 64 + 4 + 20 + 64;

impl Executable {
    /// Returns the file. `record` becomes the last bytes of its headers.
    pub fn to_bytes(&self, record: &[u8]) -> Result<Vec<u8>, Error> {
        let mut file = Vec::new();
        let alignment = FILE_ALIGNMENT as u32;
        let mut writer = Writer::new(true, PAGE as u32, alignment, &mut file);
        writer.reserve_dos_header();
        writer.reserve_nt_headers(DIRECTORIES);
        writer.reserve_section_headers(self.sections.len() as u16);
        let head = writer.reserved_len() as usize;
        let ends = self.sections.iter().skip(1).map(|next| next.address);
        let mut places = Vec::new();
        for (section, end) in self.sections.iter().zip(ends.chain([self.end])) {
            let size = end.saturating_sub(section.address);
            let (name, length) = (section.name, section.bytes.len() as u64);
            if size == 0 || length > size {
                return Err(format!("size of {name} is {length}; must be at most {size}").into());
            }
            let mut name = [0; 8];
            name[..section.name.len()].copy_from_slice(section.name.as_bytes());
            let length = section.bytes.len() as u32;
            let place = writer.reserve_section(name, section.flags, size as u32, length);
            if u64::from(place.virtual_address) != section.address {
                return Err("section start is within a page; must be at its start".into());
            }
            places.push(place.file_offset);
        }
        for (directory, range) in &self.directories {
            let size = range.end - range.start;
            writer.set_data_directory(*directory, range.start as u32, size as u32);
        }
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
            // Zero, for reproducible output.
            time_date_stamp: 0,
            characteristics: pe::IMAGE_FILE_RELOCS_STRIPPED
                | pe::IMAGE_FILE_EXECUTABLE_IMAGE
                | pe::IMAGE_FILE_LARGE_ADDRESS_AWARE,
            major_linker_version: 0,
            minor_linker_version: 0,
            address_of_entry_point: self.entry as u32,
            image_base: self.base,
            // Windows 6.0 (Vista). The intro itself reports missing functions.
            major_operating_system_version: 6,
            minor_operating_system_version: 0,
            major_image_version: 0,
            minor_image_version: 0,
            major_subsystem_version: 6,
            minor_subsystem_version: 0,
            subsystem: SUBSYSTEM,
            // Data is not executable, and no exceptions are handled.
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

/// Sets the header's checksum: the one's complement sum of all 16-bit words, plus the length.
fn set_checksum(file: &mut [u8]) {
    let sum = file.chunks(2).fold(0, |sum, pair| {
        let sum = sum + number(pair, 0, pair.len()) as u32;
        (sum & 0xffff) + (sum >> 16)
    });
    let sum = sum + file.len() as u32;
    file[CHECKSUM..CHECKSUM + 4].copy_from_slice(&sum.to_le_bytes());
}

pub struct Imports {
    /// Addresses of the functions' names, which Windows replaces with the functions' addresses.
    pub addresses: Vec<u8>,
    pub names: Vec<u8>,
}

impl Imports {
    /// The directory's size: one library, and a zero entry.
    pub const DIRECTORY: u64 = 2 * 20;

    pub fn new(library: &str, functions: &[&str], addresses: u64, names: u64) -> Imports {
        let library_at = (names + Imports::DIRECTORY) as u32;
        let descriptors = [0, 0, 0, library_at, addresses as u32, 0, 0, 0, 0, 0];
        let mut imports =
            Imports { addresses: Vec::new(), names: descriptors.map(u32::to_le_bytes).concat() };
        let bytes = &mut imports.names;
        bytes.extend(library.as_bytes());
        bytes.push(0);
        for name in functions {
            bytes.resize(bytes.len().next_multiple_of(2), 0);
            let address = names + bytes.len() as u64;
            imports.addresses.extend(address.to_le_bytes());
            // The hint, unused.
            bytes.extend([0, 0]);
            bytes.extend(name.as_bytes());
            bytes.push(0);
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        imports.addresses.extend([0; 8]);
        imports
    }
}
