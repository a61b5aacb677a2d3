use std::collections::HashMap;

use object::elf::{R_X86_64_32, R_X86_64_32S, R_X86_64_64, R_X86_64_PC32, R_X86_64_PLT32};
use object::{
    Object, ObjectSection, ObjectSymbol, RelocationFlags, RelocationTarget, SectionIndex,
};

use crate::{Error, elf};

/// Verifies the file. Other stages call its functions.
pub const FIRST: &str = ".text.first";
/// The second stage, which [`FIRST`] unpacks.
pub const STAGE: &str = ".text.stage";
pub const LOADER: &str = ".text.loader";

pub struct Stub<'a> {
    file: object::File<'a>,
    sections: Vec<(SectionIndex, usize)>,
    size: usize,
}

impl<'a> Stub<'a> {
    /// Lays out the section `first` and all sections that it refers to, except [`FIRST`].
    pub fn read(object: &'a [u8], first: &str) -> Result<Stub<'a>, Error> {
        let file = object::File::parse(object)?;
        let missing = || format!("stub section {first} is missing");
        let first = file.section_by_name(first).ok_or_else(missing)?;
        let mut found = vec![first.index()];
        let mut sections = Vec::new();
        let mut size = 0;
        while let Some(&index) = found.get(sections.len()) {
            let section = file.section_by_index(index)?;
            size = usize::next_multiple_of(size, section.align().max(1) as usize);
            sections.push((index, size));
            size += section.size() as usize;
            for (_, relocation) in section.relocations() {
                if let Some(next) = section_of(&file, relocation.target())?
                    && !found.contains(&next)
                    && file.section_by_index(next)?.name()? != FIRST
                {
                    found.push(next);
                }
            }
        }
        Ok(Stub { file, sections, size })
    }

    pub fn size(&self) -> usize {
        self.size
    }

    pub fn first_size(&self) -> usize {
        self.sections.get(1).map_or(self.size, |&(_, start)| start)
    }

    /// Returns a function's place in the first section, or its start.
    pub fn place(&self, name: &str) -> u64 {
        self.file.symbol_by_name(name).map_or(0, |symbol| symbol.address())
    }

    /// Returns position-independent bytes.
    ///
    /// # Errors
    /// If they depend on their address.
    pub fn link_anywhere(&self) -> Result<Vec<u8>, Error> {
        let names = HashMap::new();
        let bytes = self.link(0, &names)?;
        if self.link(elf::PAGE, &names)? == bytes {
            Ok(bytes)
        } else {
            Err("loader depends on its address".into())
        }
    }

    /// Returns the bytes for `address`, with values for the undefined symbols.
    pub fn link(&self, address: u64, names: &HashMap<&str, u64>) -> Result<Vec<u8>, Error> {
        let places: HashMap<_, _> = self.sections.iter().copied().collect();
        let mut bytes = vec![0; self.size];
        for &(index, start) in &self.sections {
            let section = self.file.section_by_index(index)?;
            let data = section.data()?;
            bytes[start..start + data.len()].copy_from_slice(data);
            for (place, relocation) in section.relocations() {
                let target = self.address_of(relocation.target(), &places, names, address)?;
                let place = start + place as usize;
                let value = target.wrapping_add_signed(relocation.addend());
                let relative = value.wrapping_sub(address + place as u64);
                let RelocationFlags::Elf { r_type } = relocation.flags() else {
                    return Err("stub is in another format; must be ELF".into());
                };
                let (value, width) = match r_type {
                    R_X86_64_64 => (value, 8),
                    R_X86_64_32 | R_X86_64_32S => (value, 4),
                    R_X86_64_PC32 | R_X86_64_PLT32 => (relative, 4),
                    _ => {
                        return Err(format!(
                            "stub relocation is {r_type:?}; must be absolute or relative"
                        )
                        .into());
                    }
                };
                let field = bytes
                    .get_mut(place..place + width)
                    .ok_or("stub relocation is outside its section")?;
                field.copy_from_slice(&value.to_le_bytes()[..width]);
            }
        }
        Ok(bytes)
    }

    fn address_of(
        &self,
        target: RelocationTarget,
        places: &HashMap<SectionIndex, usize>,
        names: &HashMap<&str, u64>,
        address: u64,
    ) -> Result<u64, Error> {
        let RelocationTarget::Symbol(index) = target else {
            return Err("stub relocation has no symbol".into());
        };
        let symbol = self.file.symbol_by_index(index)?;
        let section = symbol.section_index().and_then(|section| places.get(&section));
        if let Some(&start) = section {
            return Ok(address + start as u64 + symbol.address());
        }
        let name = symbol.name()?;
        // The stub's panic handler calls an undefined function: this error also means that the stub
        // can panic.
        names.get(name).copied().ok_or_else(|| format!("stub symbol {name} is undefined").into())
    }
}

fn section_of(
    file: &object::File,
    target: RelocationTarget,
) -> Result<Option<SectionIndex>, Error> {
    match target {
        RelocationTarget::Symbol(index) => Ok(file.symbol_by_index(index)?.section_index()),
        _ => Ok(None),
    }
}
