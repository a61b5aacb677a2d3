//! Orders functions by similarity, because the packer's model adapts as it goes: a random order costs 600 bytes more. Similarity is
//! the cosine of tf-idf vectors of three-byte sequences, in correctly rounded arithmetic: every machine finds the same order.

use std::{
    cmp::{Ordering, Reverse},
    collections::{BTreeMap, HashMap},
};

use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};

use crate::Error;

const LENGTH: usize = 3;

/// The number of orders to try; packing them all takes six seconds.
const ORDERS: usize = 12;

type Terms<'a> = Vec<(&'a [u8], f64)>;

/// Returns orders of a program's functions by similarity. Each begins with one of the largest functions.
pub fn by_likeness(program: &[u8]) -> Result<Vec<Vec<String>>, Error> {
    let file = object::File::parse(program)?;
    let section = file.section_by_name(".text").ok_or("section .text is missing")?;
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
    // A function may have several names.
    functions.dedup_by_key(|&mut (start, ..)| start);
    let codes: Vec<_> = functions.iter().map(|&(_, _, bytes)| bytes).collect();
    let mut starts: Vec<_> = (0..codes.len()).collect();
    starts.sort_by_key(|&i| Reverse(codes[i].len()));
    starts.truncate(ORDERS);
    let likeness = likeness(&codes);
    let names = |order: Vec<usize>| order.into_iter().map(|i| functions[i].1.into()).collect();
    Ok(starts.into_iter().map(|start| names(chain(&likeness, start))).collect())
}

/// Returns the order from `start` that continues with the function most similar to the previous ones, whose weights halve with each
/// step.
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

fn likeness(codes: &[&[u8]]) -> Vec<Vec<f64>> {
    let terms = terms(codes);
    let to_all = |a| terms.iter().map(|b| product(a, b)).collect();
    terms.iter().map(to_all).collect()
}

/// Returns the sequences that several functions have, with weights of norm 1.
fn terms<'a>(codes: &[&'a [u8]]) -> Vec<Terms<'a>> {
    let counts = codes.iter().map(|code| {
        let mut counts = BTreeMap::new();
        for term in code.windows(LENGTH) {
            *counts.entry(term).or_insert(0_u32) += 1;
        }
        counts
    });
    let counts: Vec<_> = counts.collect();
    let mut functions = HashMap::new();
    for &term in counts.iter().flat_map(BTreeMap::keys) {
        *functions.entry(term).or_insert(0_u128) += 1;
    }
    let all = codes.len() as u128;
    let weighed = counts.into_iter().map(|counts| {
        let weight = |(term, count): (&'a [u8], u32)| {
            // Four times the binary logarithm.
            let rarity = (all.pow(4) / functions[term].pow(4)).ilog2();
            (term, f64::from((1 + count.ilog2()) * rarity))
        };
        let shared = counts.into_iter().filter(|(term, _)| functions[term] > 1);
        let mut terms: Terms<'_> = shared.map(weight).collect();
        let length = product(&terms, &terms).sqrt();
        for (_, weight) in &mut terms {
            *weight /= length.max(1.0);
        }
        terms
    });
    weighed.collect()
}

fn product(a: &Terms<'_>, b: &Terms<'_>) -> f64 {
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
    fn similar_functions_are_adjacent() {
        let codes = [&b"abcdefgh"[..], b"rstuvw", b"xabcdef", b"nothing", b"pqrstuv", b"cdefghi"];
        assert_eq!(chain(&likeness(&codes), 0), [0, 2, 5, 1, 4, 3]);
        assert_eq!(chain(&likeness(&codes[..1]), 0), [0]);
    }
}
