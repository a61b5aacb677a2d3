//! `lab size`: lists what the intro's bytes are spent on.

mod packed;
pub mod program;

use crate::cargo::Build;
use crate::{arguments, output};
use anyhow::{Context, Result};
use clap::Args;
use packed::Packed;
use program::{Part, Program};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Builds the intro and prints what its bytes are: sections, crates, and the largest functions, as Markdown tables
///
/// `bytes` are those of the program as it is linked and loaded, `packed` what is left of them in the file that ships: the
/// packer's cost of each byte, summed up. A generic function counts for the crate that it was compiled with, where the linker
/// tells; the instances of a crate count together. What was inlined is in the function that it was inlined into.
#[derive(Args)]
pub struct Arguments {
    /// Of the intro for Windows
    #[arg(long)]
    windows: bool,
    /// Functions to list
    #[arg(long, value_name = "N", default_value = "30", value_parser = arguments::frames, allow_negative_numbers = true)]
    functions: usize,
}

/// The smallest share of the file with which a section is listed by itself.
const LISTED: f64 = 0.005;

/// The bytes of some parts of the program.
#[derive(Clone, Copy, Default)]
struct ByteCount {
    /// Before packing.
    bytes: u64,
    /// After packing.
    packed: f64,
    /// The number of parts.
    count: usize,
}

impl ByteCount {
    fn add(&mut self, bytes: u64, packed: f64) {
        self.bytes += bytes;
        self.packed += packed;
        self.count += 1;
    }

    /// The cells that all tables have in common.
    fn cells(self) -> String {
        format!("{} | {:.0}", self.bytes, self.packed)
    }
}

/// Runs the command.
pub fn run(arguments: &Arguments) -> Result<()> {
    let build = if arguments.windows {
        Build::windows()?
    } else {
        Build::release("eightfold")?
    };
    let shipped = read(&build.program("eightfold")?)?;
    let linked = read(&build.linked("eightfold")?)?;
    let program = Program::parse(&linked)?;
    let packed = Packed::new(&linked)?;
    let mut text = String::new();
    write_sections(&mut text, &program, &packed, shipped.len())?;
    let functions = by_name(&program, &packed);
    write_crates(&mut text, &functions)?;
    write_functions(&mut text, &functions, arguments.functions)?;
    output::write(Path::new("-"), text.as_bytes())
}

fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

/// The demangled name of a function or constant, and its crate.
type Named<'a> = (&'a str, &'a str);

/// Functions and constants, the largest first. The instances of a generic function in one crate count together.
fn by_name<'a>(program: &'a Program, packed: &Packed) -> Vec<(Named<'a>, ByteCount)> {
    let mut sums: BTreeMap<Named<'_>, ByteCount> = BTreeMap::new();
    for Part {
        name,
        of,
        addresses,
    } in &program.symbols
    {
        let sum = sums.entry((name, of)).or_default();
        let (bytes, cost) = packed.of(addresses);
        sum.add(bytes, cost);
    }
    largest_first(sums)
}

/// Sorts by size, then by name.
fn largest_first<K: Ord>(sums: BTreeMap<K, ByteCount>) -> Vec<(K, ByteCount)> {
    let mut sums: Vec<(K, ByteCount)> = sums.into_iter().collect();
    sums.sort_by(|(_, a), (_, b)| b.packed.total_cmp(&a.packed));
    sums
}

fn write_sections(
    text: &mut String,
    program: &Program,
    packed: &Packed,
    shipped: usize,
) -> Result<()> {
    writeln!(text, "| section | bytes | packed | share |")?;
    writeln!(text, "| --- | ---: | ---: | ---: |")?;
    let mut row = |name: &str, sum: ByteCount| {
        let share = 100.0 * sum.packed / shipped as f64;
        writeln!(text, "| {name} | {} | {share:.1} % |", sum.cells())
    };
    let mut others = packed.all();
    others.count = 0;
    for part in &program.sections {
        let (bytes, cost) = packed.of(&part.addresses);
        if cost < LISTED * shipped as f64 {
            others.count += 1;
            continue;
        }
        others.bytes -= bytes;
        others.packed -= cost;
        let mut sum = ByteCount::default();
        sum.add(bytes, cost);
        row(&part.name, sum)?;
    }
    row(
        &format!("headers, {} smaller sections", others.count),
        others,
    )?;
    let size = shipped as f64 - packed.all().packed;
    let unpacker = ByteCount {
        bytes: size.round() as u64,
        packed: size,
        count: 1,
    };
    row("unpacker", unpacker)?;
    writeln!(text, "| **the file** | | **{shipped}** | |\n")?;
    Ok(())
}

fn write_crates(text: &mut String, named: &[(Named<'_>, ByteCount)]) -> Result<()> {
    let mut crates: BTreeMap<&str, ByteCount> = BTreeMap::new();
    for ((_, of), sum) in named {
        let all = crates.entry(of).or_default();
        all.bytes += sum.bytes;
        all.packed += sum.packed;
        all.count += sum.count;
    }
    writeln!(text, "| crate | functions, constants | bytes | packed |")?;
    writeln!(text, "| --- | ---: | ---: | ---: |")?;
    for (name, sum) in largest_first(crates) {
        let name = if name.is_empty() { "others" } else { name };
        writeln!(text, "| {name} | {} | {} |", sum.count, sum.cells())?;
    }
    writeln!(text)?;
    Ok(())
}

fn write_functions(text: &mut String, named: &[(Named<'_>, ByteCount)], most: usize) -> Result<()> {
    writeln!(text, "| function | crate | instances | bytes | packed |")?;
    writeln!(text, "| --- | --- | ---: | ---: | ---: |")?;
    let (listed, others) = named.split_at(most.min(named.len()));
    for ((name, of), sum) in listed {
        let cell = name.replace('|', "\\|");
        writeln!(
            text,
            "| `{cell}` | {of} | {} | {} |",
            sum.count,
            sum.cells()
        )?;
    }
    if !others.is_empty() {
        let mut rest = ByteCount::default();
        for (_, sum) in others {
            rest.add(sum.bytes, sum.packed);
        }
        writeln!(
            text,
            "| {} smaller ones | | | {} |",
            rest.count,
            rest.cells()
        )?;
    }
    Ok(())
}
