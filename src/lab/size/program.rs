use super::Bytes;
use anyhow::{Context, Result, anyhow, ensure};
use eightfold_pack::{costs, strip};
use object::{Object, ObjectSection, ObjectSegment, ObjectSymbol, SectionKind, SymbolKind};
use std::collections::BTreeMap;
use std::ops::Range;

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Demangled, without a hash.
    pub name: String,
    /// The crate that compiled it; empty for sections and foreign code.
    pub of: String,
    pub addresses: Range<u64>,
}

pub struct Program {
    pub sections: Vec<Part>,
    pub symbols: Vec<Part>,
}

impl Program {
    pub fn parse(elf: &[u8]) -> Result<Self> {
        let file = object::File::parse(elf)?;
        let mut sections: Vec<Part> = file
            .sections()
            .filter(is_loaded)
            .map(|section| Part {
                name: section.name().unwrap_or_default().to_owned(),
                of: String::new(),
                addresses: section.address()..section.address() + section.size(),
            })
            .collect();
        sections.sort_by_key(|section| section.addresses.start);
        let symbols = symbols(&file, &sections);
        ensure!(!symbols.is_empty(), "symbols of the program are missing");
        Ok(Self { sections, symbols })
    }
}

fn is_loaded<'data>(section: &impl ObjectSection<'data>) -> bool {
    let is_zero =
        matches!(section.kind(), SectionKind::UninitializedData | SectionKind::UninitializedTls);
    section.address() != 0 && section.size() > 0 && !is_zero
}

/// Lists functions and constants by address; a function with several symbols appears once.
fn symbols(file: &object::File<'_>, sections: &[Part]) -> Vec<Part> {
    let mut symbols: BTreeMap<u64, Part> = BTreeMap::new();
    let mut unit = None;
    for symbol in file.symbols() {
        let name = symbol.name().unwrap_or_default();
        if symbol.kind() == SymbolKind::File {
            unit = crate_of_unit(name);
            continue;
        }
        let addresses = symbol.address()..symbol.address() + symbol.size();
        let is_inside = |section: &Part| section.addresses.contains(&addresses.start);
        if symbol.size() == 0 || !sections.iter().any(is_inside) {
            continue;
        }
        symbols.entry(addresses.start).or_insert_with(|| {
            let name = format!("{:#}", rustc_demangle::demangle(name));
            let of = unit.unwrap_or_else(|| crate_of_path(&name)).to_owned();
            Part { name, of, addresses }
        });
    }
    symbols.into_values().collect()
}

/// Returns the crate of a codegen unit, such as `eightfold.0123456789abcdef-cgu.0`, whose name
/// precedes its private symbols; shared symbols may follow another name.
fn crate_of_unit(file: &str) -> Option<&str> {
    let (name, _) = file.split_once('.')?;
    (file.contains("-cgu.") && name != LAST).then_some(name)
}

/// This crate is linked last; its symbols are assigned by their paths.
const LAST: &str = "compiler_builtins";

/// Returns the first crate of a name such as `<eightfold::Intro as core::fmt::Debug>::fmt`.
fn crate_of_path(name: &str) -> &str {
    let name = name.trim_start_matches(['<', '&', '*', '(', '[']);
    let name = name.strip_prefix("mut ").unwrap_or(name);
    name.split_once("::").map_or("", |(first, _)| first)
}

pub struct Packed {
    /// Addresses, and the offset in the image.
    segments: Vec<(Range<u64>, usize)>,
    /// Prefix sums of packed bytes, and the total.
    before: Vec<f64>,
}

impl Packed {
    pub fn new(linked: &[u8]) -> Result<Self> {
        let image = strip(linked).map_err(|error| anyhow!("{error}"))?;
        let file = object::File::parse(&*image).context("stripped program")?;
        let segments = file.segments().map(|segment| {
            let (offset, size) = segment.file_range();
            (segment.address()..segment.address() + size, offset as usize)
        });
        let mut before = vec![0.0];
        let mut sum = 0.0;
        for bits in costs(&image) {
            sum += f64::from(bits) / 8.0;
            before.push(sum);
        }
        Ok(Self { segments: segments.collect(), before })
    }

    pub fn of(&self, addresses: &Range<u64>) -> Bytes {
        let mut bytes = Bytes { parts: 1, ..Bytes::default() };
        for (segment, offset) in &self.segments {
            let start = addresses.start.max(segment.start);
            let end = addresses.end.min(segment.end);
            if start < end {
                let index = |address: u64| offset + (address - segment.start) as usize;
                bytes.linked += end - start;
                bytes.packed += self.before[index(end)] - self.before[index(start)];
            }
        }
        bytes
    }

    pub fn all(&self) -> Bytes {
        Bytes {
            parts: 1,
            linked: self.before.len() as u64 - 1,
            packed: self.before.last().copied().unwrap_or_default(),
        }
    }
}
