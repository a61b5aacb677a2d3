//! Functions of libraries that are looked up when the program runs, so that it starts where they are not.

use core::{
    cell::UnsafeCell,
    ffi::{CStr, c_void},
    mem::MaybeUninit,
    sync::atomic::{
        AtomicBool,
        Ordering::{Acquire, Release},
    },
};

use crate::line::ascii;

/// A structure of functions that are looked up in a library, in the order of a block of names. A
/// [`Table`] holds it.
macro_rules! loaded {
    ($(#[$doc:meta])* $table:ident, $names:ident: $( fn $name:ident($($argument:ty),* $(,)?) -> $result:ty; )*) => {
        $(#[$doc])*
        #[repr(C)]
        pub struct $table {
            $( pub $name: unsafe extern "C" fn($($argument),*) -> $result, )*
        }

        /// The names of its functions, each with its NUL.
        static $names: &str = concat!($( stringify!($name), "\0" ),*);
    };
}

pub(crate) use loaded;

/// A table of functions, made by [`loaded!`], filled once, read ever after.
pub struct Table<T> {
    functions: UnsafeCell<MaybeUninit<T>>,
    ready: AtomicBool,
}

// SAFETY: it is written by `open` alone, before `ready` is set, and only read after that.
unsafe impl<T> Sync for Table<T> {}

impl<T> Table<T> {
    pub const fn new() -> Table<T> {
        Table {
            functions: UnsafeCell::new(MaybeUninit::uninit()),
            ready: AtomicBool::new(false),
        }
    }

    /// Fills the table, unless it is, with the functions of a library, from any one thread at a time.
    /// `names` has one for each.
    #[inline]
    pub fn open(&'static self, library: &CStr, names: &str) -> Option<&'static T> {
        // SAFETY: nothing reads the table before `ready` is set; it is made of pointers, and `loaded!` gives it as many as
        // names.
        if !unsafe { load(&self.ready, library, names, self.functions.get().cast()) } {
            return None;
        }
        // SAFETY: it has been filled.
        Some(unsafe { self.loaded() })
    }

    /// The functions.
    ///
    /// # Safety
    /// `open` has to have found them.
    #[inline(always)]
    pub unsafe fn loaded(&'static self) -> &'static T {
        // SAFETY: the caller vouches for it.
        unsafe { (*self.functions.get()).assume_init_ref() }
    }
}

/// Looks functions up in a library, unless they are ready. False if the library or one of the functions is not there.
///
/// # Safety
/// There has to be room for as many pointers as `names` has NULs.
#[cold]
unsafe fn load(
    ready: &AtomicBool,
    library: &CStr,
    names: &str,
    mut slot: *mut *mut c_void,
) -> bool {
    if ready.load(Acquire) {
        return true;
    }
    let mut start = 0;
    // SAFETY: each name has its NUL, and the caller vouches for the room.
    unsafe {
        let library = libc::dlopen(library.as_ptr(), libc::RTLD_LAZY);
        if library.is_null() {
            return false;
        }
        for (end, byte) in names.bytes().enumerate() {
            if byte == 0 {
                let function = libc::dlsym(library, names.as_ptr().add(start).cast());
                if function.is_null() {
                    return false;
                }
                slot.write(function);
                slot = slot.add(1);
                start = end + 1;
            }
        }
    }
    ready.store(true, Release);
    true
}

/// Why the last library that was asked for by this thread could not be loaded, in the system's words: it is not there, or there
/// is no memory left for it, or it lacks a function.
#[must_use]
pub fn why_not_loaded() -> &'static str {
    // SAFETY: it is null or a string, which stays until this thread asks for another library.
    let why = unsafe {
        let why = libc::dlerror();
        (!why.is_null()).then(|| CStr::from_ptr(why))
    };
    why.and_then(|why| ascii(why.to_bytes()))
        .unwrap_or("a library can't be loaded")
}
