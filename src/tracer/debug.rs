//! `Debug` for types whose contents are too large to print.

use crate::picture::{Band, Frame};
use crate::refine::{Kernels, Worker};
use crate::render::{Memory, Renderer};
use core::fmt::{Debug, Formatter, Result};

macro_rules! debug {
    ($($name:ident [$($generic:tt)*] { $($field:ident),* })*) => {$(
        impl<$($generic)*> Debug for $name<$($generic)*> {
            fn fmt(&self, f: &mut Formatter<'_>) -> Result {
                let mut output = f.debug_struct(stringify!($name));
                $(output.field(stringify!($field), &self.$field);)*
                output.finish_non_exhaustive()
            }
        }
    )*};
}

debug! {
    Band ['a] { top, width, stride, counts }
    Frame ['a] { width, height, stride, offset, probing }
    Memory [] {}
    Kernels [] { level }
    Renderer [M] { kernels }
    Worker [] {}
}

#[cfg(all(test, feature = "std"))]
mod tests {
    extern crate std;

    use crate::{AccuracyGovernor, Frame, Renderer, ScopedThreads};
    use std::format;

    #[test]
    fn debug_output_of_large_types_is_short() {
        let mut pixels = [0; 64 * 48];
        let frame = format!("{:?}", Frame::new(64, 48, &mut pixels));
        assert!(frame.starts_with("Frame { width: 64, height: 48, stride: 64, "));
        let renderer = format!("{:?}", Renderer::detect());
        assert!(renderer.starts_with("Renderer { kernels: Kernels { level: "), "{renderer}");
        let governor = format!("{:?}", AccuracyGovernor::new(42.0));
        assert!(governor.contains("target: 42.0, rung: 0"), "{governor}");
        let threads = format!("{:?}", ScopedThreads::of(2));
        assert_eq!(threads, "ScopedThreads { workers: [Worker { .. }, Worker { .. }] }");
        assert!([frame, renderer, governor].iter().all(|text| text.len() < 400));
    }
}
