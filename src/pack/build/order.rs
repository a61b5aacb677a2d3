//! Puts functions into orders in which each is like those before it, since the packer's model learns as it goes.
//!
//! What that saves is in docs/size.md; in an order by chance there would be 600 bytes more. Which function the best order begins with
//! shows when all are packed. Functions are compared by the rows of three
//! bytes that they have in common, as texts are by their words: a row counts more if few functions have it, and the more often one has
//! it (the weights are known as tf-idf, the measure as the cosine). All is computed from whole numbers by exact steps, so the order is
//! the same on every machine.

use std::{
    cmp::{Ordering, Reverse},
    collections::{BTreeMap, HashMap},
};

use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};

use crate::Error;

/// Bytes of a row.
const ROW: usize = 3;

/// How many orders are tried: all that are packed take three seconds.
const ORDERS: usize = 6;

/// Rows of a function, in order, and how much each counts.
type Rows<'a> = Vec<(&'a [u8], f64)>;

/// Returns the names of a program's functions in better orders, each of which begins with one of the largest.
pub fn by_likeness(program: &[u8]) -> Result<Vec<Vec<String>>, Error> {
    let file = object::File::parse(program)?;
    let section = file.section_by_name(".text").ok_or("there is no code")?;
    let code = section.data()?;
    let mut functions = Vec::new();
    for symbol in file.symbols() {
        let start = symbol.address().wrapping_sub(section.address()) as usize;
        let bytes = code.get(start..start.saturating_add(symbol.size() as usize));
        if symbol.kind() == SymbolKind::Text
            && let Some(bytes) = bytes.filter(|bytes| !bytes.is_empty())
        {
            functions.push((start, symbol.name()?, bytes));
        }
    }
    functions.sort_unstable();
    // One function may have several names.
    functions.dedup_by_key(|&mut (start, ..)| start);
    let codes: Vec<_> = functions.iter().map(|&(_, _, bytes)| bytes).collect();
    let mut starts: Vec<_> = (0..codes.len()).collect();
    starts.sort_by_key(|&i| Reverse(codes[i].len()));
    starts.truncate(ORDERS);
    let likeness = likeness(&codes);
    let names = |order: Vec<usize>| order.into_iter().map(|i| functions[i].1.into()).collect();
    Ok(starts
        .into_iter()
        .map(|start| names(chain(&likeness, start)))
        .collect())
}

/// Returns the order of functions that begins with one of them, and goes on with the one that is most like the last ones: each counts
/// half of what the next one does.
fn chain(likeness: &[Vec<f64>], start: usize) -> Vec<usize> {
    let mut to_last = vec![0.0; likeness.len()];
    let mut left: Vec<_> = (0..likeness.len()).filter(|&i| i != start).collect();
    let mut order = vec![start];
    while !left.is_empty() {
        let last = order[order.len() - 1];
        let mut best = 0;
        for place in 0..left.len() {
            let i = left[place];
            to_last[i] = to_last[i] / 2.0 + likeness[last][i];
            if to_last[i] > to_last[left[best]] {
                best = place;
            }
        }
        order.push(left.remove(best));
    }
    order
}

/// Returns how much each function is like each other.
fn likeness(codes: &[&[u8]]) -> Vec<Vec<f64>> {
    let rows = rows(codes);
    let to_all = |a| rows.iter().map(|b| product(a, b)).collect();
    rows.iter().map(to_all).collect()
}

/// The rows of each function that others have, too, with weights whose squares add up to 1.
fn rows<'a>(codes: &[&'a [u8]]) -> Vec<Rows<'a>> {
    let counts = codes.iter().map(|code| {
        let mut counts = BTreeMap::new();
        for row in code.windows(ROW) {
            *counts.entry(row).or_insert(0_u32) += 1;
        }
        counts
    });
    let counts: Vec<_> = counts.collect();
    let mut functions = HashMap::new();
    for &row in counts.iter().flat_map(BTreeMap::keys) {
        *functions.entry(row).or_insert(0_u128) += 1;
    }
    let all = codes.len() as u128;
    let weighed = counts.into_iter().map(|counts| {
        let weight = |(row, count): (&'a [u8], u32)| {
            // Four times the binary logarithm.
            let rarity = (all.pow(4) / functions[row].pow(4)).ilog2();
            (row, f64::from((1 + count.ilog2()) * rarity))
        };
        let shared = counts.into_iter().filter(|(row, _)| functions[row] > 1);
        let mut rows: Rows<'_> = shared.map(weight).collect();
        let length = product(&rows, &rows).sqrt();
        for (_, weight) in &mut rows {
            *weight /= length.max(1.0);
        }
        rows
    });
    weighed.collect()
}

/// The sum of products of the weights that two have for the same rows.
fn product(a: &Rows<'_>, b: &Rows<'_>) -> f64 {
    let (mut a, mut b) = (a.iter().peekable(), b.iter().peekable());
    let mut sum = 0.0;
    while let (Some((first, x)), Some((second, y))) = (a.peek(), b.peek()) {
        match first.cmp(second) {
            Ordering::Less => drop(a.next()),
            Ordering::Greater => drop(b.next()),
            Ordering::Equal => {
                sum += x * y;
                a.next();
                b.next();
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{chain, likeness};

    #[test]
    fn what_is_alike_comes_together() {
        let codes = [
            &b"abcdefgh"[..],
            b"rstuvw",
            b"xabcdef",
            b"nothing",
            b"pqrstuv",
            b"cdefghi",
        ];
        assert_eq!(chain(&likeness(&codes), 0), [0, 2, 5, 1, 4, 3]);
        assert_eq!(chain(&likeness(&codes[..1]), 0), [0]);
    }
}
