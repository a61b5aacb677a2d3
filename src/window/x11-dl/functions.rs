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

use crate::{OpenError, types::*};

/// A structure of functions that are looked up in a library, in the order of a block of names.
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

/// `Xlib`: functions that `minifb` calls but the intro needs nothing from. Each answers in place, and
/// the calls vanish when they are compiled.
macro_rules! left_out {
    ($( fn $name:ident($($argument:ty),* $(,)?) -> $result:ty = $answer:expr; )*) => {
        /// libX11, opened: [`Loaded`], and beside it what is left out.
        ///
        /// Left out are input methods (the intro takes keys, not text), Xlib's thread locks (one
        /// thread talks to the server), the mouse, and visuals with transparency.
        #[derive(Clone, Copy)]
        pub struct Xlib {
            $( pub $name: answer::$name, )*
        }

        const XLIB: Xlib = Xlib { $( $name: answer::$name, )* };

        mod answer {
            use super::*;
            $(
                #[derive(Clone, Copy)]
                pub struct $name;

                impl Deref for $name {
                    type Target = unsafe extern "C" fn($($argument),*) -> $result;

                    #[inline(always)]
                    fn deref(&self) -> &Self::Target {
                        #[inline]
                        unsafe extern "C" fn answer($(_: $argument),*) -> $result {
                            $answer
                        }
                        &(answer as Self::Target)
                    }
                }
            )*
        }
    };
}

loaded! {
    /// The functions that are looked up in libX11.
    Loaded, XLIB_NAMES:
    fn XBlackPixel(*mut Display, c_int) -> c_ulong;
    fn XChangeProperty(*mut Display, Window, Atom, Atom, c_int, c_int, *const c_uchar, c_int) -> c_int;
    fn XChangeWindowAttributes(*mut Display, Window, c_ulong, *mut XSetWindowAttributes) -> c_int;
    fn XClearWindow(*mut Display, Window) -> c_int;
    fn XCloseDisplay(*mut Display) -> c_int;
    fn XCreateBitmapFromData(*mut Display, Drawable, *const c_char, c_uint, c_uint) -> Pixmap;
    fn XCreateGC(*mut Display, Drawable, c_ulong, *mut XGCValues) -> GC;
    fn XCreateImage(*mut Display, *mut Visual, c_uint, c_int, c_int, *mut c_char, c_uint, c_uint, c_int, c_int) -> *mut XImage;
    fn XCreatePixmapCursor(*mut Display, Pixmap, Pixmap, *mut XColor, *mut XColor, c_uint, c_uint) -> Cursor;
    fn XCreateWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint, c_uint, c_int, c_uint, *mut Visual, c_ulong, *mut XSetWindowAttributes) -> Window;
    fn XDefaultDepth(*mut Display, c_int) -> c_int;
    fn XDefaultGC(*mut Display, c_int) -> GC;
    fn XDefaultRootWindow(*mut Display) -> Window;
    fn XDefaultScreen(*mut Display) -> c_int;
    fn XDefaultVisual(*mut Display, c_int) -> *mut Visual;
    fn XDefineCursor(*mut Display, Window, Cursor) -> c_int;
    fn XDestroyImage(*mut XImage) -> c_int;
    fn XDestroyWindow(*mut Display, Window) -> c_int;
    fn XDisplayHeight(*mut Display, c_int) -> c_int;
    fn XDisplayWidth(*mut Display, c_int) -> c_int;
    fn XFlush(*mut Display) -> c_int;
    fn XFree(*mut c_void) -> c_int;
    fn XFreeGC(*mut Display, GC) -> c_int;
    fn XGetWindowAttributes(*mut Display, Window, *mut XWindowAttributes) -> Status;
    fn XGetWindowProperty(*mut Display, Window, Atom, c_long, c_long, Bool, Atom, *mut Atom, *mut c_int, *mut c_ulong, *mut c_ulong, *mut *mut c_uchar) -> c_int;
    fn XInternAtom(*mut Display, *const c_char, Bool) -> Atom;
    fn XListPixmapFormats(*mut Display, *mut c_int) -> *mut XPixmapFormatValues;
    fn XLookupKeysym(*mut XKeyEvent, c_int) -> KeySym;
    fn XMapRaised(*mut Display, Window) -> c_int;
    fn XMoveResizeWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XMoveWindow(*mut Display, Window, c_int, c_int) -> c_int;
    fn XNextEvent(*mut Display, *mut XEvent) -> c_int;
    fn XOpenDisplay(*const c_char) -> *mut Display;
    fn XPending(*mut Display) -> c_int;
    fn XPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XSelectInput(*mut Display, Window, c_long) -> c_int;
    fn XSendEvent(*mut Display, Window, Bool, c_long, *mut XEvent) -> Status;
    fn XSetErrorHandler(unsafe extern "C" fn(*mut Display, *mut XErrorEvent) -> c_int) -> *mut c_void;
    fn XSetIOErrorHandler(unsafe extern "C" fn(*mut Display) -> c_int) -> *mut c_void;
    fn XSetInputFocus(*mut Display, Window, c_int, Time) -> c_int;
    fn XSetWMNormalHints(*mut Display, Window, *mut XSizeHints) -> ();
    fn XSetWMProtocols(*mut Display, Window, *mut Atom, c_int) -> Status;
    fn XStoreName(*mut Display, Window, *const c_char) -> c_int;
    fn XSync(*mut Display, Bool) -> c_int;
    fn XTranslateCoordinates(*mut Display, Window, Window, c_int, c_int, *mut c_int, *mut c_int, *mut Window) -> Bool;
    fn XUnmapWindow(*mut Display, Window) -> c_int;
    fn XkbKeycodeToKeysym(*mut Display, KeyCode, c_int, c_int) -> KeySym;
    fn XkbQueryExtension(*mut Display, *mut c_int, *mut c_int, *mut c_int, *mut c_int, *mut c_int) -> Bool;
    fn XkbSetDetectableAutoRepeat(*mut Display, Bool, *mut Bool) -> Bool;
}

left_out! {
    fn XInitThreads() -> Status = 1;
    fn XSetLocaleModifiers(*const c_char) -> *mut c_char = core::ptr::null_mut();
    fn XOpenIM(*mut Display, XrmDatabase, *mut c_char, *mut c_char) -> XIM = core::ptr::dangling_mut();
    fn XCloseIM(XIM) -> Status = 1;
    // Variadic in Xlib; these are the arguments that `minifb` gives it.
    fn XCreateIC(XIM, *const c_char, c_int, *const c_char, c_ulong, *const c_char, c_ulong, *mut c_void) -> XIC = core::ptr::dangling_mut();
    fn XDestroyIC(XIC) -> () = ();
    fn XSetICFocus(XIC) -> () = ();
    fn XFilterEvent(*mut XEvent, Window) -> Bool = False;
    fn Xutf8LookupString(XIC, *mut XKeyEvent, *mut c_char, c_int, *mut KeySym, *mut Status) -> c_int = 0;
    fn XQueryPointer(*mut Display, Window, *mut Window, *mut Window, *mut c_int, *mut c_int, *mut c_int, *mut c_int, *mut c_uint) -> Bool = False;
    fn XMatchVisualInfo(*mut Display, c_int, c_int, c_int, *mut XVisualInfo) -> Status = 0;
    fn XCreateColormap(*mut Display, Window, *mut Visual, c_int) -> Colormap = 0;
    fn XrmUniqueQuark() -> c_int = 0;
}

loaded! {
    /// The functions that are looked up in libXext: pictures in memory that the server shares.
    Xext, XEXT_NAMES:
    fn XShmAttach(*mut Display, *mut XShmSegmentInfo) -> Status;
    fn XShmQueryExtension(*mut Display) -> Bool;
    fn XShmPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint, Bool) -> Status;
}

/// A table of functions, filled once, read ever after.
struct Table<T> {
    functions: UnsafeCell<MaybeUninit<T>>,
    ready: AtomicBool,
}

// SAFETY: it is written by `open` alone, before `ready` is set, and only read after that.
unsafe impl<T> Sync for Table<T> {}

static XLIB_TABLE: Table<Loaded> = Table::new();
static XEXT_TABLE: Table<Xext> = Table::new();

impl Xlib {
    /// Opens libX11 the first time it is called, from any one thread at a time.
    pub fn open() -> Result<Xlib, OpenError> {
        XLIB_TABLE
            .open(c"libX11.so.6", XLIB_NAMES)
            .ok_or(OpenError)?;
        Ok(XLIB)
    }
}

impl Deref for Xlib {
    type Target = Loaded;

    #[inline(always)]
    fn deref(&self) -> &Loaded {
        // SAFETY: there is an `Xlib` only after `open`, and so a whole table.
        unsafe { (*XLIB_TABLE.functions.get()).assume_init_ref() }
    }
}

impl Xext {
    /// Opens libXext the first time it is called, from any one thread at a time.
    pub fn open() -> Result<&'static Xext, OpenError> {
        XEXT_TABLE
            .open(c"libXext.so.6", XEXT_NAMES)
            .ok_or(OpenError)
    }
}

impl<T> Table<T> {
    const fn new() -> Table<T> {
        Table {
            functions: UnsafeCell::new(MaybeUninit::uninit()),
            ready: AtomicBool::new(false),
        }
    }

    /// Fills the table, unless it is, with the functions of a library. `names` has one for each.
    #[inline]
    fn open(&'static self, library: &CStr, names: &str) -> Option<&'static T> {
        if !self.ready.load(Acquire) {
            // SAFETY: nothing reads the table before `ready` is set; it is made of pointers, and
            // `loaded!` gives it as many as names.
            if !unsafe { load(library, names, self.functions.get().cast()) } {
                return None;
            }
            self.ready.store(true, Release);
        }
        // SAFETY: it has been filled.
        Some(unsafe { (*self.functions.get()).assume_init_ref() })
    }
}

/// Looks functions up in a library. False if the library or one of the functions is not there.
///
/// # Safety
/// There has to be room for as many pointers as `names` has NULs.
#[cold]
unsafe fn load(library: &CStr, names: &str, mut slot: *mut *mut c_void) -> bool {
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
    true
}
