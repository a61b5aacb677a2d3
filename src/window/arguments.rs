pub use crate::backend::arguments::Arguments;
#[cfg(feature = "windows")]
#[doc(hidden)]
pub use crate::backend::{
    arguments::end,
    functions::{GetProcAddress, LoadLibrary},
};

/// Defines the C `main`, which calls a `fn(Arguments) -> i32` for the exit code, in a crate with `#![no_main]`.
///
/// Rust's own start adds 9,564 bytes to the packed intro, most of them to explain a stack overflow; std's arguments add 432.
#[macro_export]
#[cfg(not(feature = "windows"))]
macro_rules! main {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn main(
            count: core::ffi::c_int,
            values: *const *const core::ffi::c_char,
        ) -> core::ffi::c_int {
            // SAFETY: these are the arguments of the C `main`, which has just started.
            let arguments = unsafe { $crate::arguments::Arguments::start(count, values) };
            let run: fn($crate::arguments::Arguments) -> i32 = $run;
            run(arguments)
        }
    };
}

/// Defines the entry point of a Windows program, which calls a `fn(Arguments) -> i32` for the exit code, in a crate with
/// `#![no_main]`.
#[macro_export]
#[cfg(feature = "windows")]
macro_rules! main {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn eightfold_main(
            load_library: $crate::arguments::LoadLibrary,
            get_function: $crate::arguments::GetProcAddress,
        ) -> ! {
            // SAFETY: this is the first call, with these functions.
            let arguments =
                unsafe { $crate::arguments::Arguments::start(load_library, get_function) };
            let run: fn($crate::arguments::Arguments) -> i32 = $run;
            $crate::arguments::end(run(arguments))
        }
    };
}
