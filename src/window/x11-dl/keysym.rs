//! Keys, as in `X11/keysymdef.h`.
//!
//! `minifb` tells a hundred of them apart in a function that nobody calls; those that nobody listens to have names, so
//! that it compiles, and the value of no key.

use core::ffi::c_uint;

/// Gives names to keys.
macro_rules! keys {
    ($($name:ident = $value:literal)*) => { $( pub const $name: c_uint = $value; )* };
}

keys! {
    XK_space = 0x20 XK_slash = 0x2f XK_1 = 0x31 XK_2 = 0x32 XK_3 = 0x33 XK_4 = 0x34 XK_5 = 0x35
    XK_6 = 0x36 XK_7 = 0x37 XK_8 = 0x38 XK_9 = 0x39 XK_e = 0x65 XK_f = 0x66 XK_h = 0x68 XK_p = 0x70
    XK_s = 0x73 XK_w = 0x77 XK_Escape = 0xff1b XK_Home = 0xff50 XK_Left = 0xff51 XK_Right = 0xff53
    XK_F1 = 0xffbe
}

/// Gives names the value of no key.
macro_rules! unheard {
    ($($name:ident)*) => { $( pub const $name: c_uint = XK_VoidSymbol; )* };
}

/// No key has it.
pub const XK_VoidSymbol: c_uint = 0xff_ffff;

unheard! {
    XK_apostrophe XK_comma XK_minus XK_period XK_0 XK_semicolon XK_equal XK_bracketleft
    XK_backslash XK_bracketright XK_grave XK_a XK_b XK_c XK_d XK_g XK_i XK_j XK_k XK_l XK_m XK_n
    XK_o XK_q XK_r XK_t XK_u XK_v XK_x XK_y XK_z XK_BackSpace XK_Tab XK_Return XK_Pause
    XK_Scroll_Lock XK_Up XK_Down XK_Page_Up XK_Page_Down XK_End XK_Insert XK_Menu XK_Num_Lock
    XK_KP_Enter XK_KP_Multiply XK_KP_Add XK_KP_Separator XK_KP_Subtract XK_KP_Decimal XK_KP_Divide
    XK_KP_0 XK_KP_1 XK_KP_2 XK_KP_3 XK_KP_4 XK_KP_5 XK_KP_6 XK_KP_7 XK_KP_8 XK_KP_9 XK_KP_Equal
    XK_F2 XK_F3 XK_F4 XK_F5 XK_F6 XK_F7 XK_F8 XK_F9 XK_F10 XK_F11 XK_F12 XK_Shift_L XK_Shift_R
    XK_Control_L XK_Control_R XK_Caps_Lock XK_Alt_L XK_Alt_R XK_Super_L XK_Super_R XK_Delete
}
