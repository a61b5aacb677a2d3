//! Orders functions by similarity: the packer's model adapts, so a random order costs 600 bytes
//! more. Similarity is the cosine of tf-idf vectors of three-byte sequences, in correctly rounded
//! arithmetic, for the same order on every machine.

use std::{cmp::Reverse, collections::BTreeMap};

use object::{Object, ObjectSection, ObjectSymbol, SymbolKind};

use crate::Error;

const LENGTH: usize = 3;

/// The number of orders to try; packing them all takes six seconds.
const ORDERS: usize = 12;

/// Returns orders of a program's functions. Each begins with one of the largest.
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

/// The divisor of a function's weight per later function: 2 costs 40 bytes more, 1.02 costs 90.
const DECAY: f64 = 1.4;

/// Returns the order from `start` that continues with the function most similar to the previous
/// ones.
fn chain(likeness: &[Vec<f64>], start: usize) -> Vec<usize> {
    let mut to_last = vec![0.0; likeness.len()];
    let mut left: Vec<_> = (0..likeness.len()).filter(|&i| i != start).collect();
    let mut order = vec![start];
    while !left.is_empty() {
        let last = order[order.len() - 1];
        let mut best = 0;
        for place in 0..left.len() {
            let i = left[place];
            to_last[i] = to_last[i] / DECAY + likeness[last][i];
            if to_last[i] > to_last[left[best]] {
                best = place;
            }
        }
        order.push(left.remove(best));
    }
    order
}

fn likeness(codes: &[&[u8]]) -> Vec<Vec<f64>> {
    let mut counts: BTreeMap<&[u8], BTreeMap<usize, u32>> = BTreeMap::new();
    for (i, code) in codes.iter().enumerate() {
        for term in code.windows(LENGTH) {
            *counts.entry(term).or_default().entry(i).or_default() += 1;
        }
    }
    let all = codes.len() as u128;
    let shared = counts.into_values().filter(|functions| functions.len() > 1);
    let weights = shared.map(|functions| {
        // Four times the binary logarithm.
        let rarity = (all.pow(4) / (functions.len() as u128).pow(4)).ilog2();
        let weight = |(i, count): (usize, u32)| (i, f64::from((1 + count.ilog2()) * rarity));
        functions.into_iter().map(weight).collect()
    });
    let mut weights: Vec<Vec<(usize, f64)>> = weights.collect();
    let mut squares = vec![0.0; codes.len()];
    for &(i, weight) in weights.iter().flatten() {
        squares[i] += weight * weight;
    }
    let mut likeness = vec![vec![0.0; codes.len()]; codes.len()];
    for functions in &mut weights {
        for (i, weight) in functions.iter_mut() {
            *weight /= squares[*i].sqrt().max(1.0);
        }
        for &(i, a) in functions.iter() {
            for &(j, b) in functions.iter() {
                likeness[i][j] += a * b;
            }
        }
    }
    likeness
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
