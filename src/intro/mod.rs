//! The intro, a program around the library.
//!
//! | part | module |
//! | --- | --- |
//! | the command line | [`options`], [`flags`] |
//! | the named qualities | [`qualities`] |
//! | drawing a frame on all threads | [`renderer`] |
//! | playing the show, and its statistics | [`playing`], [`tally`] |
//! | writing one frame as a file | [`still`] |

mod flags;
mod options;
mod playing;
mod qualities;
mod renderer;
mod still;
mod tally;

use core::fmt::{self, Write};

use eightfold::show;
use eightfold_window::{
    arguments::Arguments,
    clock::SECOND,
    line::{self, Text, Writer},
};
use options::{Options, Task};

/// The length of the show in nanoseconds.
const SHOW_NANOSECONDS: u64 = (show::LENGTH as f64 * SECOND as f64) as u64;

/// The exit code after losing the screen or failing to write the output.
const FAILURE: i32 = 1;

/// The exit code for an invalid command line.
const MISUSE: i32 = 2;

/// Runs the program. Returns its exit code, 0 for success.
pub fn run(arguments: Arguments) -> i32 {
    let options = match Options::parse(arguments) {
        Ok(options) => options,
        Err(misuse) => {
            line::complain(format_args!("{misuse}"));
            return MISUSE;
        }
    };
    match options.task {
        Task::Play => playing::play(&options),
        Task::Still(time) => still::write(time, &options),
        Task::Help => print(flags::write_help),
        Task::Version => print(|output| writeln!(output, "{}", Text(flags::VERSION))),
    }
}

/// Writes text to standard output. Returns the exit code.
fn print(write: impl FnOnce(&mut Writer) -> fmt::Result) -> i32 {
    let mut output = Writer::new(line::OUTPUT);
    exit_code(write(&mut output).and_then(|()| output.flush()))
}

/// Returns the exit code after writing to standard output, and reports an error on standard error.
fn exit_code(written: fmt::Result) -> i32 {
    if written.is_ok() {
        return 0;
    }
    line::complain(format_args!("can't write to standard output"));
    FAILURE
}
