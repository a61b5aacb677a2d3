//! `lab size`: what the intro's bytes are.

mod map;
mod name;

use crate::cargo::Build;
use crate::{arguments, output};
use anyhow::{Context, Result};
use clap::Args;
use map::{Map, Part};
use name::readable;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Builds the intro and prints what its bytes are: sections, crates, and the largest functions, as Markdown tables
///
/// The intro itself has neither symbols nor headers of sections; what is in it is read from the linker's map. A function
/// counts for the crate that was compiled to it, a generic one for the crate that made the instance; the instances of a
/// crate count together. What was inlined is in the function that it was inlined into.
#[derive(Args)]
pub struct Arguments {
    /// Functions to list
    #[arg(long, value_name = "N", default_value = "30", value_parser = arguments::frames, allow_negative_numbers = true)]
    functions: usize,
}

/// Bytes, and how many there are of what has them.
#[derive(Clone, Copy, Default)]
struct Sum {
    bytes: u64,
    count: usize,
}

/// Builds the intro, and prints the tables.
pub fn run(arguments: &Arguments) -> Result<()> {
    let build = Build::release("eightfold")?;
    let program = build.program("eightfold")?;
    let file =
        fs::metadata(&program).with_context(|| format!("cannot read {}", program.display()))?;
    let map = build.script_folder("eightfold")?.join("eightfold.map");
    let map = fs::read_to_string(&map)
        .with_context(|| format!("cannot read the linker's map, {}", map.display()))?;
    let map = Map::parse(&map);
    let mut text = String::new();
    tell_sections(&mut text, &map, file.len())?;
    let functions = functions(&map);
    tell_crates(&mut text, &functions)?;
    tell_functions(&mut text, &functions, arguments.functions)?;
    output::write(Path::new("-"), text.as_bytes())
}

/// A function's readable name, and its crate.
type Function<'a> = (String, &'a str);

/// The functions of the program, a crate's instances of one together, the largest first.
fn functions(map: &Map) -> Vec<(Function<'_>, Sum)> {
    let mut functions: BTreeMap<Function<'_>, Sum> = BTreeMap::new();
    for Part { name, of, bytes } in &map.functions {
        let sum = functions.entry((readable(name), of)).or_default();
        sum.bytes += bytes;
        sum.count += 1;
    }
    largest_first(functions)
}

/// Equally large ones by name.
fn largest_first<K: Ord>(sums: BTreeMap<K, Sum>) -> Vec<(K, Sum)> {
    let mut sums: Vec<(K, Sum)> = sums.into_iter().collect();
    sums.sort_by_key(|(_, sum)| std::cmp::Reverse(sum.bytes));
    sums
}

fn tell_sections(text: &mut String, map: &Map, file: u64) -> Result<()> {
    writeln!(text, "| section | bytes | share |\n| --- | ---: | ---: |")?;
    let share = |bytes: u64| 100.0 * bytes as f64 / file as f64;
    let mut rest = file;
    for Part { name, bytes, .. } in &map.sections {
        writeln!(text, "| {name} | {bytes} | {:.1} % |", share(*bytes))?;
        rest = rest
            .checked_sub(*bytes)
            .context("the linker's map is of another program")?;
    }
    writeln!(text, "| between them | {rest} | {:.1} % |", share(rest))?;
    writeln!(text, "| **the file** | **{file}** | |\n")?;
    Ok(())
}

fn tell_crates(text: &mut String, functions: &[(Function<'_>, Sum)]) -> Result<()> {
    let mut crates: BTreeMap<&str, Sum> = BTreeMap::new();
    for ((_, of), sum) in functions {
        let all = crates.entry(of).or_default();
        all.bytes += sum.bytes;
        all.count += sum.count;
    }
    writeln!(text, "| crate | functions | bytes |\n| --- | ---: | ---: |")?;
    for (name, Sum { bytes, count }) in largest_first(crates) {
        writeln!(text, "| {name} | {count} | {bytes} |")?;
    }
    writeln!(text)?;
    Ok(())
}

fn tell_functions(text: &mut String, functions: &[(Function<'_>, Sum)], most: usize) -> Result<()> {
    writeln!(
        text,
        "| function | crate | instances | bytes |\n| --- | --- | ---: | ---: |"
    )?;
    for ((name, of), Sum { bytes, count }) in functions.iter().take(most) {
        let cell = name.replace('|', "\\|");
        writeln!(text, "| `{cell}` | {of} | {count} | {bytes} |")?;
    }
    let rest: u64 = functions.iter().skip(most).map(|(_, sum)| sum.bytes).sum();
    let count = functions.len().saturating_sub(most);
    if count > 0 {
        writeln!(text, "| {count} smaller ones | | | {rest} |")?;
    }
    Ok(())
}
