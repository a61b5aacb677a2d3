//! Functions as `minifb` finds them: those that the intro needs nothing from answer in place.
//!
//! `minifb` opens the display and makes the window, which is not shown by that: its picture, its place on the screen and its
//! keys are the business of `eightfold-window`.

use core::{
    ffi::{c_char, c_int, c_uint, c_ulong, c_void},
    ops::Deref,
    ptr::{dangling_mut, null_mut},
};

use crate::{
    OpenError,
    functions::{Functions, Loaded, loaded},
    types::*,
};

/// Functions that answer in place; the calls vanish when they are compiled.
macro_rules! left_out {
    ($( $(#[$doc:meta])* fn $name:ident($($argument:tt: $type:ty),* $(,)?) -> $result:ty = $answer:expr; )*) => {
        /// libX11 for `minifb`: [`Loaded`], and in front of it what is left out.
        ///
        /// Left out are input methods (the intro takes keys, not text), Xlib's thread locks (one
        /// thread talks to the server), the mouse, visuals with transparency, and pictures: the window takes its
        /// parent's depth and visual, for which zero stands.
        #[derive(Clone, Copy)]
        pub struct Xlib {
            $( pub $name: answer::$name, )*
        }

        impl Xlib {
            /// What `minifb` calls when it makes a window, after [`Functions::load`] found all that it needs.
            ///
            /// # Panics
            /// If that did not succeed.
            #[inline]
            pub fn open() -> Result<Xlib, OpenError> {
                Functions::load().expect("libX11 is loaded");
                Ok(Xlib { $( $name: answer::$name, )* })
            }
        }

        mod answer {
            use super::*;
            $(
                #[derive(Clone, Copy)]
                pub struct $name;

                impl Deref for $name {
                    type Target = unsafe extern "C" fn($($type),*) -> $result;

                    #[inline(always)]
                    fn deref(&self) -> &Self::Target {
                        #[inline]
                        unsafe extern "C" fn answer($($argument: $type),*) -> $result {
                            $answer
                        }
                        &(answer as Self::Target)
                    }
                }
            )*
        }
    };
}

impl Deref for Xlib {
    type Target = Loaded;

    #[inline(always)]
    fn deref(&self) -> &Loaded {
        // SAFETY: there is an `Xlib` only after `load`.
        unsafe { loaded() }
    }
}

left_out! {
    fn XInitThreads() -> Status = 1;
    // SAFETY: the display is open.
    fn XDefaultRootWindow(display: *mut Display) -> Window = unsafe { (*(*display).screen()).root };
    fn XMapRaised(_: *mut Display, _: Window) -> c_int = 0;
    fn XFlush(_: *mut Display) -> c_int = 0;
    // SAFETY: it points to where the number of formats goes.
    fn XListPixmapFormats(_: *mut Display, count: *mut c_int) -> *mut XPixmapFormatValues = unsafe {
        // (A constant, since what is in a static of this crate is not known where `minifb` is compiled.)
        const FORMAT: &XPixmapFormatValues = &XPixmapFormatValues {
            depth: 0,
            bits_per_pixel: 32,
            scanline_pad: 32,
        };
        count.write(1);
        core::ptr::from_ref(FORMAT).cast_mut()
    };
    fn XSetLocaleModifiers(_: *const c_char) -> *mut c_char = null_mut();
    fn XOpenIM(_: *mut Display, _: XrmDatabase, _: *mut c_char, _: *mut c_char) -> XIM = dangling_mut();
    fn XCloseIM(_: XIM) -> Status = 1;
    // Variadic in Xlib; these are the arguments that `minifb` gives it.
    fn XCreateIC(_: XIM, _: *const c_char, _: c_int, _: *const c_char, _: c_ulong, _: *const c_char, _: c_ulong, _: *mut c_void) -> XIC = dangling_mut();
    fn XDestroyIC(_: XIC) -> () = ();
    fn XSetICFocus(_: XIC) -> () = ();
    fn XFilterEvent(_: *mut XEvent, _: Window) -> Bool = False;
    fn Xutf8LookupString(_: XIC, _: *mut XKeyEvent, _: *mut c_char, _: c_int, _: *mut KeySym, _: *mut Status) -> c_int = 0;
    fn XQueryPointer(_: *mut Display, _: Window, _: *mut Window, _: *mut Window, _: *mut c_int, _: *mut c_int, _: *mut c_int, _: *mut c_int, _: *mut c_uint) -> Bool = False;
    fn XMatchVisualInfo(_: *mut Display, _: c_int, _: c_int, _: c_int, _: *mut XVisualInfo) -> Status = 0;
    fn XCreateColormap(_: *mut Display, _: Window, _: *mut Visual, _: c_int) -> Colormap = 0;
    fn XrmUniqueQuark() -> c_int = 0;
    fn XBlackPixel(_: *mut Display, _: c_int) -> c_ulong = 0;
    fn XClearWindow(_: *mut Display, _: Window) -> c_int = 0;
    fn XCreateGC(_: *mut Display, _: Drawable, _: c_ulong, _: *mut XGCValues) -> GC = null_mut();
    fn XFreeGC(_: *mut Display, _: GC) -> c_int = 0;
    fn XCloseDisplay(_: *mut Display) -> c_int = 0;
    fn XFree(_: *mut c_void) -> c_int = 0;
    fn XDestroyWindow(_: *mut Display, _: Window) -> c_int = 0;
    fn XDestroyImage(_: *mut XImage) -> c_int = 0;
    fn XDisplayWidth(_: *mut Display, _: c_int) -> c_int = 0;
    fn XDisplayHeight(_: *mut Display, _: c_int) -> c_int = 0;
    fn XkbQueryExtension(_: *mut Display, _: *mut c_int, _: *mut c_int, _: *mut c_int, _: *mut c_int, _: *mut c_int) -> Bool = False;
    fn XkbSetDetectableAutoRepeat(_: *mut Display, _: Bool, _: *mut Bool) -> Bool = False;
    fn XDefaultDepth(_: *mut Display, _: c_int) -> c_int = 0;
    fn XDefaultGC(_: *mut Display, _: c_int) -> GC = null_mut();
    fn XDefaultScreen(_: *mut Display) -> c_int = 0;
    fn XDefaultVisual(_: *mut Display, _: c_int) -> *mut Visual = null_mut();
    fn XCreateImage(_: *mut Display, _: *mut Visual, _: c_uint, _: c_int, _: c_int, _: *mut c_char, _: c_uint, _: c_uint, _: c_int, _: c_int) -> *mut XImage = dangling_mut();
    fn XSetWMNormalHints(_: *mut Display, _: Window, _: *mut XSizeHints) -> () = ();
    fn XMoveWindow(_: *mut Display, _: Window, _: c_int, _: c_int) -> c_int = 0;
    fn XTranslateCoordinates(_: *mut Display, _: Window, _: Window, _: c_int, _: c_int, _: *mut c_int, _: *mut c_int, _: *mut Window) -> Bool = False;
    fn XkbKeycodeToKeysym(_: *mut Display, _: KeyCode, _: c_int, _: c_int) -> KeySym = 0;
    fn XLookupKeysym(_: *mut XKeyEvent, _: c_int) -> KeySym = 0;
}
