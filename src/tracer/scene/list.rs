use crate::zero::Zero;
use core::fmt;
use core::ops::{Deref, DerefMut};

/// A list of up to `N` items, stored in place. It dereferences to a slice.
///
/// ```
/// use eightfold_tracer::scene::List;
///
/// let mut list: List<i32, 4> = List::of(&[1, 2, 3]);
/// list.push(4);
/// assert_eq!(list, vec![1, 2, 3, 4].into_iter().collect());
/// let result = List::<i32, 4>::try_from(&[1, 2, 3, 4, 5][..]);
/// assert_eq!(result.unwrap_err().to_string(), "list length is 5; must be at most 4");
/// ```
///
/// Longer arrays do not compile:
///
/// ```compile_fail,E0080
/// # use eightfold_tracer::scene::List;
/// let list: List<i32, 4> = List::of(&[1, 2, 3, 4, 5]);
/// ```
#[derive(Clone, Copy)]
pub struct List<T, const N: usize> {
    items: [T; N],
    len: usize,
}

impl<T: Copy + Default, const N: usize> List<T, N> {
    /// Returns a list of an array's items, at most `N`.
    #[must_use]
    pub fn of<const K: usize>(items: &[T; K]) -> Self {
        const { assert!(K <= N, "the array has more items than the list's capacity") }
        items.iter().copied().collect()
    }

    pub(crate) const fn full(items: [T; N]) -> Self {
        Self { items, len: N }
    }

    /// Removes all items.
    pub fn clear(&mut self) {
        self.len = 0;
    }

    /// Appends an item.
    ///
    /// # Panics
    /// If the list is full.
    pub fn push(&mut self, item: T) {
        self.items[self.len] = item;
        self.len += 1;
    }

    /// Appends an item.
    ///
    /// # Errors
    /// If the list is full; it stays unchanged.
    pub fn try_push(&mut self, item: T) -> Result<(), CapacityError> {
        let len = self.len + 1;
        if len > N {
            return Err(CapacityError { len, capacity: N });
        }
        self.push(item);
        Ok(())
    }
}

impl<T: Copy + Default + Zero, const N: usize> Zero for List<T, N> {
    const ZERO: Self = Self { items: [T::ZERO; N], len: 0 };
}

impl<T: Copy + Default, const N: usize> Default for List<T, N> {
    fn default() -> Self {
        Self { items: [T::default(); N], len: 0 }
    }
}

/// # Panics
/// If there are more than `N` items.
impl<T: Copy + Default, const N: usize> Extend<T> for List<T, N> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, items: I) {
        items.into_iter().for_each(|item| self.push(item));
    }
}

/// # Panics
/// If there are more than `N` items.
impl<T: Copy + Default, const N: usize> FromIterator<T> for List<T, N> {
    fn from_iter<I: IntoIterator<Item = T>>(items: I) -> Self {
        let mut list = Self::default();
        list.extend(items);
        list
    }
}

impl<T: Copy + Default, const N: usize> TryFrom<&[T]> for List<T, N> {
    type Error = CapacityError;

    fn try_from(items: &[T]) -> Result<Self, CapacityError> {
        let (len, capacity) = (items.len(), N);
        if len > capacity {
            return Err(CapacityError { len, capacity });
        }
        Ok(items.iter().copied().collect())
    }
}

/// Too many items for a [`List`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CapacityError {
    /// The number of items.
    pub len: usize,
    /// The largest number of items.
    pub capacity: usize,
}

impl fmt::Display for CapacityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { len, capacity } = self;
        write!(f, "list length is {len}; must be at most {capacity}")
    }
}

impl core::error::Error for CapacityError {}

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
