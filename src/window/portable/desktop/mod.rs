//! Functions that `minifb` lacks, by the system's own functions.

#[cfg(target_os = "linux")]
mod linux;
#[cfg(not(any(target_os = "linux", windows)))]
mod other;
#[cfg(target_os = "linux")]
mod wayland;
#[cfg(windows)]
mod windows;

#[cfg(target_os = "linux")]
pub use linux::{Desktop, Display};
#[cfg(not(any(target_os = "linux", windows)))]
pub use other::{Desktop, Display};
#[cfg(windows)]
pub use windows::{Desktop, Display};
