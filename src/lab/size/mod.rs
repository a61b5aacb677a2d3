//! `cargo lab size`: the parts of the packed intro.

mod program;

use crate::arguments::{self, within};
use crate::output;
use anyhow::Result;
use clap::Args;
use eightfold_harness::cargo::Build;
use program::{Packed, Part, Program};
use std::collections::BTreeMap;
use std::fmt::{self, Write};
use std::path::Path;

/// Builds the intro and prints the sizes of its sections, crates and largest functions as Markdown
/// tables
///
/// `bytes` is the linked size, `packed` the sum of the packer's costs. Instances of a generic
/// function share a row, and count for the crate that instantiates them, if recorded. Inlined code
/// counts for its caller.
#[derive(Args)]
pub struct Arguments {
    /// Measures the intro for Windows
    #[arg(long)]
    windows: bool,
    /// Functions to list
    #[arg(long, value_name = "N", default_value = "30", value_parser = within(arguments::FRAMES), allow_negative_numbers = true)]
    functions: usize,
}

/// Sections with smaller shares of the file have one row.
const LISTED: f64 = 0.005;

#[derive(Clone, Copy, Default)]
struct Bytes {
    parts: usize,
    linked: u64,
    packed: f64,
}

impl Bytes {
    fn add(&mut self, other: Self) {
        self.parts += other.parts;
        self.linked += other.linked;
        self.packed += other.packed;
    }
}

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} | {:.0}", self.linked, self.packed)
    }
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let build = if arguments.windows { Build::windows()? } else { Build::release("eightfold")? };
    let file = output::read(&build.program("eightfold")?)?.len() as f64;
    let linked = output::read(&build.linked("eightfold")?)?;
    let (program, packed) = (Program::parse(&linked)?, Packed::new(&linked)?);
    let mut text = String::new();

    writeln!(text, "| section | bytes | packed | share |")?;
    writeln!(text, "| --- | ---: | ---: | ---: |")?;
    let sections = sums(&program.sections, &packed, |part| part.name.clone());
    let (mut rows, smaller): (Vec<_>, Vec<_>) =
        sections.into_iter().partition(|(_, bytes)| bytes.packed >= LISTED * file);
    let (all, listed) = (packed.all(), total(&rows));
    let others = Bytes {
        parts: smaller.len(),
        linked: all.linked - listed.linked,
        packed: all.packed - listed.packed,
    };
    rows.push((format!("headers, {} smaller sections", others.parts), others));
    let unpacker = file - all.packed;
    let unpacker = Bytes { parts: 1, linked: unpacker.round() as u64, packed: unpacker };
    rows.push(("unpacker".to_owned(), unpacker));
    for (name, bytes) in rows {
        writeln!(text, "| {name} | {bytes} | {:.1} % |", 100.0 * bytes.packed / file)?;
    }
    writeln!(text, "| **the file** | | **{file}** | |\n")?;

    writeln!(text, "| crate | functions, constants | bytes | packed |")?;
    writeln!(text, "| --- | ---: | ---: | ---: |")?;
    for (name, bytes) in sums(&program.symbols, &packed, |part| &*part.of) {
        let name = if name.is_empty() { "others" } else { name };
        writeln!(text, "| {name} | {} | {bytes} |", bytes.parts)?;
    }

    writeln!(text, "\n| function | crate | instances | bytes | packed |")?;
    writeln!(text, "| --- | --- | ---: | ---: | ---: |")?;
    let functions = sums(&program.symbols, &packed, |part| (&*part.name, &*part.of));
    let (listed, others) = functions.split_at(arguments.functions.min(functions.len()));
    for ((name, of), bytes) in listed {
        let name = name.replace('|', "\\|");
        writeln!(text, "| `{name}` | {of} | {} | {bytes} |", bytes.parts)?;
    }
    let rest = total(others);
    writeln!(text, "| {} smaller ones | | | {rest} |", rest.parts)?;
    output::write(Path::new("-"), text.as_bytes())
}

fn total<K>(rows: &[(K, Bytes)]) -> Bytes {
    let mut sum = Bytes::default();
    rows.iter().for_each(|(_, bytes)| sum.add(*bytes));
    sum
}

/// Sums sizes by key, the largest first.
fn sums<'a, K: Ord>(
    parts: &'a [Part],
    packed: &Packed,
    key: impl Fn(&'a Part) -> K,
) -> Vec<(K, Bytes)> {
    let mut sums: BTreeMap<K, Bytes> = BTreeMap::new();
    for part in parts {
        let bytes = packed.of(&part.addresses);
        sums.entry(key(part)).or_default().add(bytes);
    }
    let mut sums: Vec<(K, Bytes)> = sums.into_iter().collect();
    sums.sort_by(|(_, a), (_, b)| b.packed.total_cmp(&a.packed));
    sums
}
