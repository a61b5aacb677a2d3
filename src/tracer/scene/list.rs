//! A list of fixed capacity, since the library cannot allocate.

use core::fmt;
use core::ops::{Deref, DerefMut};

/// Up to `N` items, stored in place. It dereferences to the slice of the items pushed, is displayed as that, and two lists are equal
/// if those are.
#[derive(Clone, Copy)]
pub struct List<T, const N: usize> {
    items: [T; N],
    len: usize,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// A list of the first `N` items of a slice; the others are left out. `try_from` takes all of them or none.
    #[must_use]
    pub fn of(items: &[T]) -> Self {
        let mut list = Self::default();
        for &item in items {
            list.push(item);
        }
        list
    }

    /// An empty list whose unused memory holds copies of an item.
    pub(crate) const fn over(item: T) -> Self {
        Self {
            items: [item; N],
            len: 0,
        }
    }

    /// Removes all items.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Appends an item. Returns false, and leaves the list as it is, if the list is full.
    pub fn push(&mut self, item: T) -> bool {
        let Some(slot) = self.items.get_mut(self.len) else {
            return false;
        };
        *slot = item;
        self.len += 1;
        true
    }
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self {
            items: [T::default(); N],
            len: 0,
        }
    }
}

/// All items of a slice, or none if they are too many.
impl<T: Copy + Default, const N: usize> TryFrom<&[T]> for List<T, N> {
    type Error = TooMany;

    fn try_from(items: &[T]) -> Result<Self, TooMany> {
        if items.len() > N {
            return Err(TooMany {
                takes: N,
                given: items.len(),
            });
        }
        Ok(Self::of(items))
    }
}

/// Why a slice does not become a [`List`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct TooMany {
    /// The most items that the list takes.
    pub takes: usize,
    /// How many there are.
    pub given: usize,
}

impl fmt::Display for TooMany {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { takes, given } = self;
        write!(f, "a list takes {takes} items, and not {given}")
    }
}

impl core::error::Error for TooMany {}

impl<T: fmt::Debug, const N: usize> fmt::Debug for List<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        (**self).fmt(f)
    }
}

impl<T: PartialEq, const N: usize> PartialEq for List<T, N> {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<T, const N: usize> Deref for List<T, N> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        &self.items[..self.len]
    }
}

impl<T, const N: usize> DerefMut for List<T, N> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.items[..self.len]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slice_becomes_a_list_unless_it_is_longer() {
        let list: Result<List<u8, 3>, _> = [1, 2, 3][..].try_into();
        assert_eq!(list, Ok(List::of(&[1, 2, 3])));
        let list: Result<List<u8, 3>, _> = [1, 2, 3, 4][..].try_into();
        assert_eq!(list, Err(TooMany { takes: 3, given: 4 }));
        assert_eq!(*List::<u8, 3>::of(&[1, 2, 3, 4]), [1, 2, 3]);
    }
}
