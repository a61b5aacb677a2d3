//! Writes 64-bit PE files.

use std::ops::Range;

use object::pe::{
    self, IMAGE_SCN_CNT_CODE, IMAGE_SCN_CNT_UNINITIALIZED_DATA, IMAGE_SCN_MEM_EXECUTE,
    IMAGE_SCN_MEM_READ, IMAGE_SCN_MEM_WRITE, SectionFlags,
};
use object::write::pe::{NtHeaders, Writer};

use crate::Error;
use crate::elf::{PAGE, number};

pub const BASE_ALIGNMENT: u64 = 1 << 16;
const FILE_ALIGNMENT: u32 = 512;

const CODE: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_CODE.0 | IMAGE_SCN_MEM_EXECUTE.0 | IMAGE_SCN_MEM_READ.0);
const MEMORY: SectionFlags =
    SectionFlags(IMAGE_SCN_CNT_UNINITIALIZED_DATA.0 | IMAGE_SCN_MEM_READ.0 | IMAGE_SCN_MEM_WRITE.0);

/// The first section's address in the image.
pub const START: u64 = PAGE;

/// An executable with the sections `.text` and `.bss`. Addresses are relative to `base`.
pub struct Executable {
    pub base: u64,
    pub end: u64,
    pub entry: u64,
    pub text: Vec<u8>,
    pub directories: [(usize, Range<u64>); 2],
}

const SUBSYSTEM: pe::Subsystem = pe::IMAGE_SUBSYSTEM_WINDOWS_GUI;

/// The stack's size, and the committed part, larger than any function's frame.
const STACK: u64 = 1 << 20;
const STACK_AT_ONCE: u64 = 1 << 17;

const DIRECTORIES: usize = 16;

/// The checksum's file offset, in the optional header.
const CHECKSUM: usize = 64 + 4 + 20 + 64;

impl Executable {
    /// Returns the file. `record` becomes the last bytes of its headers.
    pub fn to_bytes(&self, record: &[u8]) -> Result<Vec<u8>, Error> {
        let mut file = Vec::new();
        let mut writer = Writer::new(true, PAGE as u32, FILE_ALIGNMENT, &mut file);
        writer.reserve_dos_header();
        writer.reserve_nt_headers(DIRECTORIES);
        writer.reserve_section_headers(2);
        let head = writer.reserved_len() as usize;
        let length = self.text.len() as u64;
        let size = length.next_multiple_of(PAGE);
        let zeros = (self.end - START - size) as u32;
        let text = writer.reserve_section(*b".text\0\0\0", CODE, size as u32, length as u32);
        writer.reserve_section(*b".bss\0\0\0\0", MEMORY, zeros, 0);
        for (directory, range) in &self.directories {
            let size = range.end - range.start;
            writer.set_data_directory(*directory, range.start as u32, size as u32);
        }
        writer.write_empty_dos_header()?;
        writer.write_nt_headers(self.headers());
        writer.write_section_headers();
        writer.write_section(text.file_offset, &self.text);
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
            // Windows 6.0 (Vista), although the intro needs a newer one: an old Windows then starts
            // the intro, which reports the missing function.
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
    /// The addresses of the functions' names. Windows overwrites each with its function's address.
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
