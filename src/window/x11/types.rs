//! Xlib's types and constants, as in `X11/X.h`, `X11/Xlib.h` and `X11/Xutil.h`, by their own names.

#![allow(dead_code, reason = "each backend uses a part of it")]
#![allow(non_camel_case_types, non_snake_case, reason = "Xlib's own names")]
#![allow(non_upper_case_globals, reason = "Xlib's own names")]
#![allow(clippy::upper_case_acronyms, reason = "Xlib's own names")]

use core::ffi::{c_char, c_int, c_long, c_uchar, c_uint, c_ulong, c_ushort};

pub type XID = c_ulong;
pub type Atom = XID;
pub type Bool = c_int;
pub type Colormap = XID;
pub type Cursor = XID;
pub type Drawable = XID;
pub type KeyCode = c_uchar;
pub type KeySym = XID;
pub type Pixmap = XID;
pub type Status = c_int;
pub type Time = c_ulong;
pub type Window = XID;

/// Something of Xlib's that is only pointed to.
macro_rules! opaque {
    ($($name:ident)*) => { $(
        #[repr(C)]
        pub struct $name([u8; 0]);
    )* };
}

opaque! { Display GraphicsContext }

/// The meaning of a pixel's bits.
#[repr(C)]
pub struct Visual {
    ext_data: *mut Visual,
    visualid: XID,
    pub class: c_int,
}

/// Whether pixels of a class of visuals are numbers in a table that can be changed (`GrayScale`, `PseudoColor`) or three in three
/// (`DirectColor`).
pub const fn is_changeable(class: c_int) -> bool {
    class & 1 != 0
}

pub type GC = *mut GraphicsContext;

/// The fields of a screen that the macros of `Xlib.h` read.
#[repr(C)]
pub struct Screen {
    ext_data: *mut Screen,
    display: *mut Display,
    pub root: Window,
    pub width: c_int,
    pub height: c_int,
    mwidth: c_int,
    mheight: c_int,
    ndepths: c_int,
    depths: *mut Screen,
    pub root_depth: c_int,
    pub root_visual: *mut Visual,
    pub default_gc: GC,
    cmap: XID,
    white_pixel: c_ulong,
    black_pixel: c_ulong,
    max_maps: c_int,
    min_maps: c_int,
    backing_store: c_int,
    save_unders: Bool,
    root_input_mask: c_long,
}

pub const AllocAll: c_int = 1;
pub const DoRed: c_char = 1 << 0;
pub const DoGreen: c_char = 1 << 1;
pub const DoBlue: c_char = 1 << 2;

pub const False: Bool = 0;
pub const True: Bool = 1;
pub const XA_STRING: Atom = 31;
pub const XA_WM_CLASS: Atom = 67;
pub const PropModeReplace: c_int = 0;
pub const RevertToPointerRoot: c_int = 1;
pub const LSBFirst: c_int = 0;
pub const ZPixmap: c_int = 2;

pub const KeyPress: c_int = 2;
pub const ButtonPress: c_int = 4;
pub const ButtonRelease: c_int = 5;
pub const MotionNotify: c_int = 6;
pub const ConfigureNotify: c_int = 22;
pub const ClientMessage: c_int = 33;

pub const KeyPressMask: c_long = 1 << 0;
pub const ButtonPressMask: c_long = 1 << 2;
pub const ButtonReleaseMask: c_long = 1 << 3;
pub const PointerMotionMask: c_long = 1 << 6;
pub const StructureNotifyMask: c_long = 1 << 17;
pub const SubstructureNotifyMask: c_long = 1 << 19;
pub const SubstructureRedirectMask: c_long = 1 << 20;

pub const ShiftMask: c_uint = 1 << 0;
pub const ControlMask: c_uint = 1 << 2;
pub const Mod1Mask: c_uint = 1 << 3;
pub const Mod4Mask: c_uint = 1 << 6;

pub const BadWindow: c_uchar = 3;
pub const BadDrawable: c_uchar = 9;

/// Events of the mouse have the same fields, up to the button, which stands in the place of the key, or the hint of a move.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct XKeyEvent {
    pub type_: c_int,
    pub serial: c_ulong,
    pub send_event: Bool,
    pub display: *mut Display,
    pub window: Window,
    pub root: Window,
    pub subwindow: Window,
    pub time: Time,
    pub x: c_int,
    pub y: c_int,
    pub x_root: c_int,
    pub y_root: c_int,
    pub state: c_uint,
    pub keycode: c_uint,
    pub same_screen: Bool,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XConfigureEvent {
    pub type_: c_int,
    pub serial: c_ulong,
    pub send_event: Bool,
    pub display: *mut Display,
    pub event: Window,
    pub window: Window,
    pub x: c_int,
    pub y: c_int,
    pub width: c_int,
    pub height: c_int,
    pub border_width: c_int,
    pub above: Window,
    pub override_redirect: Bool,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XClientMessageEvent {
    pub type_: c_int,
    pub serial: c_ulong,
    pub send_event: Bool,
    pub display: *mut Display,
    pub window: Window,
    pub message_type: Atom,
    pub format: c_int,
    pub data: ClientMessageData,
}

/// Twenty bytes of payload, which Xlib keeps as five longs when the format is 32.
#[derive(Clone, Copy)]
#[repr(C)]
pub struct ClientMessageData {
    pub longs: [c_long; 5],
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XErrorEvent {
    pub type_: c_int,
    pub display: *mut Display,
    pub resourceid: XID,
    pub serial: c_ulong,
    pub error_code: c_uchar,
    pub request_code: c_uchar,
    pub minor_code: c_uchar,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub union XEvent {
    pub type_: c_int,
    pub client_message: XClientMessageEvent,
    pub configure: XConfigureEvent,
    pub key: XKeyEvent,
    pub pad: [c_long; 24],
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XImage {
    pub width: c_int,
    pub height: c_int,
    pub xoffset: c_int,
    pub format: c_int,
    pub data: *mut c_char,
    pub byte_order: c_int,
    pub bitmap_unit: c_int,
    pub bitmap_bit_order: c_int,
    pub bitmap_pad: c_int,
    pub depth: c_int,
    pub bytes_per_line: c_int,
    pub bits_per_pixel: c_int,
    pub red_mask: c_ulong,
    pub green_mask: c_ulong,
    pub blue_mask: c_ulong,
    pub obdata: *mut c_char,
    pub functions: [Option<unsafe extern "C" fn()>; 6],
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XColor {
    pub pixel: c_ulong,
    pub red: c_ushort,
    pub green: c_ushort,
    pub blue: c_ushort,
    pub flags: c_char,
    pub pad: c_char,
}

#[derive(Clone, Copy)]
#[repr(C)]
pub struct XWindowAttributes {
    pub x: c_int,
    pub y: c_int,
    pub width: c_int,
    pub height: c_int,
    pub border_width: c_int,
    pub depth: c_int,
    pub visual: *mut Visual,
    pub root: Window,
    pub class: c_int,
    pub bit_gravity: c_int,
    pub win_gravity: c_int,
    pub backing_store: c_int,
    pub backing_planes: c_ulong,
    pub backing_pixel: c_ulong,
    pub save_under: Bool,
    pub colormap: XID,
    pub map_installed: Bool,
    pub map_state: c_int,
    pub all_event_masks: c_long,
    pub your_event_mask: c_long,
    pub do_not_propagate_mask: c_long,
    pub override_redirect: Bool,
    pub screen: *mut Screen,
}
