use super::super::tile::points::corners;
use crate::grid::Bits;
use proptest::prelude::*;
use std::collections::BTreeSet;
use std::prelude::v1::*;

extern crate std;

proptest! {
    #[test]
    fn level_points_are_the_corners_of_its_squares(
        level in 0_usize..=5,
        squares in proptest::collection::vec(any::<u64>(), 1..5),
    ) {
        let rows: Vec<Bits> = squares.iter().map(|&row| Bits([row, 0, row >> 32, 0, 0, 0, 0, 0])).collect();
        let mut expected = BTreeSet::new();
        for (y, row) in rows.iter().enumerate() {
            row.for_each(|x| {
                let others: &[_] = if level == 0 { &[] } else { &[(1, 0), (0, 1), (1, 1)] };
                expected.insert((x, y));
                expected.extend(others.iter().map(|(i, j)| (x + i, y + j)));
            });
        }
        let mut found = BTreeSet::new();
        for y in 0..rows.len() + usize::from(level > 0) {
            corners(&rows, level, y, rows.len()).for_each(|x| {
                found.insert((x, y));
            });
        }
        prop_assert_eq!(found, expected);
    }
}
