use super::memory::Memory;
use core::borrow::{Borrow, BorrowMut};
use std::boxed::Box;
use std::vec;

/// A [`Memory`] on the heap, initialised in place: no part of it is ever on the stack, even in
/// unoptimised programs.
#[derive(Debug)]
pub struct BoxedMemory(Box<[Memory]>);

impl BoxedMemory {
    /// Allocates empty memory.
    #[must_use]
    pub fn new() -> Self {
        Self(vec![const { Memory::new() }].into_boxed_slice())
    }
}

default!(BoxedMemory = Self::new());

impl Borrow<Memory> for BoxedMemory {
    fn borrow(&self) -> &Memory {
        &self.0[0]
    }
}

impl BorrowMut<Memory> for BoxedMemory {
    fn borrow_mut(&mut self) -> &mut Memory {
        &mut self.0[0]
    }
}
