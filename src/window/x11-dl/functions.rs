//! The libraries' functions: lists, from which come the tables and the names to fill them by.

use core::{
    cell::UnsafeCell,
    ffi::{CStr, c_char, c_int, c_long, c_uchar, c_uint, c_ulong, c_void},
    mem::MaybeUninit,
    ops::Deref,
    sync::atomic::{
        AtomicBool,
        Ordering::{Acquire, Release},
    },
};

use crate::types::*;

/// A structure of functions that are looked up in a library, in the order of a block of names. A
/// [`Table`] holds it.
#[macro_export]
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

loaded! {
    /// The functions that are looked up in libX11.
    Loaded, XLIB_NAMES:
    fn XChangeProperty(*mut Display, Window, Atom, Atom, c_int, c_int, *const c_uchar, c_int) -> c_int;
    fn XCreateBitmapFromData(*mut Display, Drawable, *const c_char, c_uint, c_uint) -> Pixmap;
    fn XCreateImage(*mut Display, *mut Visual, c_uint, c_int, c_int, *mut c_char, c_uint, c_uint, c_int, c_int) -> *mut XImage;
    fn XCreatePixmapCursor(*mut Display, Pixmap, Pixmap, *mut XColor, *mut XColor, c_uint, c_uint) -> Cursor;
    fn XCreateWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint, c_uint, c_int, c_uint, *mut Visual, c_ulong, *mut XSetWindowAttributes) -> Window;
    fn XDefineCursor(*mut Display, Window, Cursor) -> c_int;
    fn XGetWindowAttributes(*mut Display, Window, *mut XWindowAttributes) -> Status;
    fn XInternAtom(*mut Display, *const c_char, Bool) -> Atom;
    fn XMapRaised(*mut Display, Window) -> c_int;
    fn XMoveResizeWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XNextEvent(*mut Display, *mut XEvent) -> c_int;
    fn XOpenDisplay(*const c_char) -> *mut Display;
    fn XPending(*mut Display) -> c_int;
    fn XPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XSelectInput(*mut Display, Window, c_long) -> c_int;
    fn XSendEvent(*mut Display, Window, Bool, c_long, *mut XEvent) -> Status;
    fn XSetErrorHandler(unsafe extern "C" fn(*mut Display, *mut XErrorEvent) -> c_int) -> *mut c_void;
    fn XSetIOErrorHandler(unsafe extern "C" fn(*mut Display) -> c_int) -> *mut c_void;
    fn XSetInputFocus(*mut Display, Window, c_int, Time) -> c_int;
    fn XSetWMProtocols(*mut Display, Window, *mut Atom, c_int) -> Status;
    fn XStoreName(*mut Display, Window, *const c_char) -> c_int;
    fn XSync(*mut Display, Bool) -> c_int;
    fn XkbKeycodeToKeysym(*mut Display, KeyCode, c_int, c_int) -> KeySym;
}

loaded! {
    /// The functions that are looked up in libXext: pictures in memory that the server shares.
    Xext, XEXT_NAMES:
    fn XShmAttach(*mut Display, *mut XShmSegmentInfo) -> Status;
    fn XShmQueryExtension(*mut Display) -> Bool;
    fn XShmPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint, Bool) -> Status;
}

/// A table of functions, made by [`loaded!`], filled once, read ever after.
pub struct Table<T> {
    functions: UnsafeCell<MaybeUninit<T>>,
    ready: AtomicBool,
}

// SAFETY: it is written by `open` alone, before `ready` is set, and only read after that.
unsafe impl<T> Sync for Table<T> {}

static XLIB_TABLE: Table<Loaded> = Table::new();
static XEXT_TABLE: Table<Xext> = Table::new();

/// The functions of libX11.
///
/// # Safety
/// They have to be loaded.
#[inline(always)]
pub(crate) unsafe fn loaded() -> &'static Loaded {
    // SAFETY: the caller vouches for it.
    unsafe { (*XLIB_TABLE.functions.get()).assume_init_ref() }
}

/// libX11, opened: its functions. It has nothing in it, so that it costs nothing to hand it on.
#[derive(Clone, Copy)]
pub struct Functions(());

impl Functions {
    /// Opens libX11 the first time it is called, from any one thread at a time; `None` if it is not there, or lacks a
    /// function.
    pub fn load() -> Option<Functions> {
        XLIB_TABLE.open(c"libX11.so.6", XLIB_NAMES)?;
        Some(Functions(()))
    }
}

impl Deref for Functions {
    type Target = Loaded;

    #[inline(always)]
    fn deref(&self) -> &Loaded {
        // SAFETY: there are `Functions` only after `load`.
        unsafe { loaded() }
    }
}

impl Xext {
    /// Opens libXext the first time it is called, from any one thread at a time.
    pub fn load() -> Option<&'static Xext> {
        XEXT_TABLE.open(c"libXext.so.6", XEXT_NAMES)
    }
}

impl<T> Default for Table<T> {
    fn default() -> Table<T> {
        Table::new()
    }
}

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
        Some(unsafe { (*self.functions.get()).assume_init_ref() })
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
    unsafe {
        let why = libc::dlerror();
        if why.is_null() {
            return "a library can't be loaded";
        }
        CStr::from_ptr(why).to_str().unwrap_or_default()
    }
}
