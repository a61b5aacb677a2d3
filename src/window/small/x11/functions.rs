#![allow(non_snake_case, reason = "Xlib's own names")]

use core::ffi::{c_char, c_int, c_long, c_uchar, c_uint, c_ulong, c_void};

use x11_dl::{xinerama::XineramaScreenInfo, xlib::*, xshm::XShmSegmentInfo};

use crate::loading::loaded;

loaded! {
    static XLIB: Loaded = c"libX11.so.6";
    fn XChangeProperty(*mut Display, Window, Atom, Atom, c_int, c_int, *const c_uchar, c_int) -> c_int;
    fn XCreateBitmapFromData(*mut Display, Drawable, *const c_char, c_uint, c_uint) -> Pixmap;
    fn XCreateImage(*mut Display, *mut Visual, c_uint, c_int, c_int, *mut c_char, c_uint, c_uint, c_int, c_int) -> *mut XImage;
    fn XCreatePixmapCursor(*mut Display, Pixmap, Pixmap, *mut XColor, *mut XColor, c_uint, c_uint) -> Cursor;
    fn XCreateSimpleWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint, c_uint, c_ulong, c_ulong) -> Window;
    fn XDefaultScreenOfDisplay(*mut Display) -> *mut Screen;
    fn XDefineCursor(*mut Display, Window, Cursor) -> c_int;
    fn XFree(*mut c_void) -> c_int;
    fn XGetWindowAttributes(*mut Display, Window, *mut XWindowAttributes) -> Status;
    fn XInitImage(*mut XImage) -> Status;
    fn XInternAtom(*mut Display, *const c_char, Bool) -> Atom;
    fn XListProperties(*mut Display, Window, *mut c_int) -> *mut Atom;
    fn XMapRaised(*mut Display, Window) -> c_int;
    fn XMoveResizeWindow(*mut Display, Window, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XNextEvent(*mut Display, *mut XEvent) -> c_int;
    fn XOpenDisplay(*const c_char) -> *mut Display;
    fn XPending(*mut Display) -> c_int;
    fn XPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint) -> c_int;
    fn XResetScreenSaver(*mut Display) -> c_int;
    fn XSelectInput(*mut Display, Window, c_long) -> c_int;
    fn XSendEvent(*mut Display, Window, Bool, c_long, *mut XEvent) -> Status;
    fn XSetErrorHandler(unsafe extern "C" fn(*mut Display, *mut XErrorEvent) -> c_int) -> *mut c_void;
    fn XSetIOErrorHandler(unsafe extern "C" fn(*mut Display) -> c_int) -> *mut c_void;
    fn XSetInputFocus(*mut Display, Window, c_int, Time) -> c_int;
    fn XSetWMProtocols(*mut Display, Window, *mut Atom, c_int) -> Status;
    fn XSetWMProperties(*mut Display, Window, *const c_void, *const c_void, *const c_void, c_int, *const c_void, *const c_void, *mut XClassHint) -> ();
    fn XStoreName(*mut Display, Window, *const c_char) -> c_int;
    fn XSync(*mut Display, Bool) -> c_int;
    fn XTranslateCoordinates(*mut Display, Window, Window, c_int, c_int, *mut c_int, *mut c_int, *mut Window) -> Bool;
    fn XkbKeycodeToKeysym(*mut Display, KeyCode, c_int, c_int) -> KeySym;
}

pub type Xlib = &'static Loaded;

loaded! {
    static XEXT: Xext = c"libXext.so.6";
    fn XShmAttach(*mut Display, *mut XShmSegmentInfo) -> Status;
    fn XShmQueryExtension(*mut Display) -> Bool;
    fn XShmPutImage(*mut Display, Drawable, GC, *mut XImage, c_int, c_int, c_int, c_int, c_uint, c_uint, Bool) -> Status;
}

loaded! {
    static XINERAMA: Xinerama = c"libXinerama.so.1";
    fn XineramaIsActive(*mut Display) -> Bool;
    fn XineramaQueryScreens(*mut Display, *mut c_int) -> *mut XineramaScreenInfo;
}
