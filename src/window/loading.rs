//! Loads functions of libraries at run time, so that the program starts without them.

use core::cell::UnsafeCell;
use core::ffi::{CStr, c_void};
use core::mem::MaybeUninit;
use core::sync::atomic::{AtomicBool, Ordering::*};

use crate::line::ascii;

macro_rules! loaded {
    (static $table:ident: $functions:ident = $library:literal; $( fn $name:ident($($argument:ty),* $(,)?) -> $result:ty; )*) => {
        #[repr(C)]
        pub struct $functions {
            $( pub $name: unsafe extern "C" fn($($argument),*) -> $result, )*
        }

        pub static $table: $crate::loading::Table<$functions> =
            $crate::loading::Table::new($library, concat!($( stringify!($name), "\0" ),*));
    };
}

pub(crate) use loaded;

pub struct Table<T> {
    library: &'static CStr,
    names: &'static str,
    functions: UnsafeCell<MaybeUninit<T>>,
    ready: AtomicBool,
}

// SAFETY: only `open` writes it, before `ready` is set; afterwards it is only read.
unsafe impl<T> Sync for Table<T> {}

impl<T> Table<T> {
    pub const fn new(library: &'static CStr, names: &'static str) -> Table<T> {
        Table {
            library,
            names,
            functions: UnsafeCell::new(MaybeUninit::uninit()),
            ready: AtomicBool::new(false),
        }
    }

    /// Fills the table, if no function is missing. Call it from one thread at a time.
    #[inline]
    pub fn open(&'static self) -> Option<&'static T> {
        let slot = self.functions.get().cast();
        // SAFETY: nothing reads the table before `ready` is set. It consists of pointers, one for
        // each name.
        let is_filled = unsafe { load(&self.ready, self.library, self.names, slot) };
        // SAFETY: it has been filled.
        is_filled.then(|| unsafe { (*self.functions.get()).assume_init_ref() })
    }
}

/// Looks up a library's functions, unless they are ready. Returns false if any is missing.
///
/// # Safety
/// `slot` has to have space for a pointer for each NUL in `names`.
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
    // SAFETY: each name has its NUL, and the caller guarantees the space.
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

/// Returns the system's message for this thread's last failure to load a library.
#[must_use]
pub fn why_not_loaded() -> &'static str {
    // SAFETY: this is null or a string, which is valid until the thread's next call.
    let why = unsafe {
        let why = libc::dlerror();
        (!why.is_null()).then(|| CStr::from_ptr(why))
    };
    why.and_then(|why| ascii(why.to_bytes())).unwrap_or("library cannot be loaded")
}
