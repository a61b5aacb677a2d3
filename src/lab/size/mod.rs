//! `lab size`: what the intro's bytes are.

mod packed;
mod program;

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
    /// Functions to list
    #[arg(long, value_name = "N", default_value = "30", value_parser = arguments::frames, allow_negative_numbers = true)]
    functions: usize,
}

/// The share of the file from which on a section is listed by itself.
const LISTED: f64 = 0.005;

/// Bytes before and after packing, and how many there are of what has them.
#[derive(Clone, Copy, Default)]
struct Sum {
    bytes: u64,
    packed: f64,
    count: usize,
}

impl Sum {
    fn add(&mut self, bytes: u64, packed: f64) {
        self.bytes += bytes;
        self.packed += packed;
        self.count += 1;
    }

    /// The cells of a table that all have.
    fn cells(self) -> String {
        format!("{} | {:.0}", self.bytes, self.packed)
    }
}

/// Builds the intro, and prints the tables.
pub fn run(arguments: &Arguments) -> Result<()> {
    let build = Build::release("eightfold")?;
    let shipped = read(&build.program("eightfold")?)?;
    let linked = read(&build.script_folder("eightfold")?.join("eightfold.unpacked"))?;
    let program = Program::parse(&linked)?;
    let packed = Packed::new(&linked)?;
    let mut text = String::new();
    tell_sections(&mut text, &program, &packed, shipped.len())?;
    let functions = by_name(&program, &packed);
    tell_crates(&mut text, &functions)?;
    tell_functions(&mut text, &functions, arguments.functions)?;
    output::write(Path::new("-"), text.as_bytes())
}

fn read(path: &Path) -> Result<Vec<u8>> {
    fs::read(path).with_context(|| format!("cannot read {}", path.display()))
}

/// A function's or constant's readable name, and its crate.
type Named<'a> = (&'a str, &'a str);

/// What symbols name, a crate's instances of one together, the largest first.
fn by_name<'a>(program: &'a Program, packed: &Packed) -> Vec<(Named<'a>, Sum)> {
    let mut sums: BTreeMap<Named<'_>, Sum> = BTreeMap::new();
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

/// Equally large ones by name.
fn largest_first<K: Ord>(sums: BTreeMap<K, Sum>) -> Vec<(K, Sum)> {
    let mut sums: Vec<(K, Sum)> = sums.into_iter().collect();
    sums.sort_by(|(_, a), (_, b)| b.packed.total_cmp(&a.packed));
    sums
}

fn tell_sections(
    text: &mut String,
    program: &Program,
    packed: &Packed,
    shipped: usize,
) -> Result<()> {
    writeln!(text, "| section | bytes | packed | share |")?;
    writeln!(text, "| --- | ---: | ---: | ---: |")?;
    let mut row = |name: &str, sum: Sum| {
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
        let mut sum = Sum::default();
        sum.add(bytes, cost);
        row(&part.name, sum)?;
    }
    row(
        &format!("headers, {} smaller sections", others.count),
        others,
    )?;
    let size = shipped as f64 - packed.all().packed;
    let unpacker = Sum {
        bytes: size.round() as u64,
        packed: size,
        count: 1,
    };
    row("unpacker", unpacker)?;
    writeln!(text, "| **the file** | | **{shipped}** | |\n")?;
    Ok(())
}

fn tell_crates(text: &mut String, named: &[(Named<'_>, Sum)]) -> Result<()> {
    let mut crates: BTreeMap<&str, Sum> = BTreeMap::new();
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

fn tell_functions(text: &mut String, named: &[(Named<'_>, Sum)], most: usize) -> Result<()> {
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
        let mut rest = Sum::default();
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
