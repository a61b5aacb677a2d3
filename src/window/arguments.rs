pub use crate::backend::arguments::Arguments;
#[doc(hidden)]
pub use crate::backend::arguments::{First, Second, end};

/// Defines the entry point of a crate with `#![no_main]`, which calls a `fn(Arguments) -> i32` for
/// the exit code.
///
/// Rust's own start adds 9,564 bytes to the packed intro, most of them to explain a stack overflow;
/// std's arguments add 432.
#[macro_export]
macro_rules! main {
    ($run:path) => {
        #[unsafe(no_mangle)]
        extern "C" fn main(
            first: $crate::arguments::First,
            second: $crate::arguments::Second,
        ) -> core::ffi::c_int {
            // SAFETY: these are the parameters of the entry point, and this is the first call.
            let arguments = unsafe { $crate::arguments::Arguments::start(first, second) };
            let run: fn($crate::arguments::Arguments) -> i32 = $run;
            $crate::arguments::end(run(arguments))
        }
    };
}
