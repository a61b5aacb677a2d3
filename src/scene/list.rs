//! A list of fixed capacity: the library never allocates.

use core::ops::{Deref, DerefMut};

/// Up to `N` items in place; behaves as the slice of those pushed.
#[derive(Clone, Copy, Debug)]
pub struct List<T, const N: usize> {
    items: [T; N],
    len: usize,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// A list of a slice's items; those beyond the capacity are left out.
    #[must_use]
    pub fn of(items: &[T]) -> Self {
        let mut list = Self::default();
        for &item in items {
            list.push(item);
        }
        list
    }

    /// An empty list over some item.
    pub(crate) const fn over(item: T) -> Self {
        Self {
            items: [item; N],
            len: 0,
        }
    }

    /// Leaves no item.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Appends an item and says whether there was room for it.
    pub fn push(&mut self, item: T) -> bool {
        let Some(place) = self.items.get_mut(self.len) else {
            return false;
        };
        *place = item;
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
