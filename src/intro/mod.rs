//! The intro, a program around the library.

mod flags;
mod options;
mod playing;
mod qualities;
mod renderer;
mod still;
mod tally;

use eightfold::show;
use eightfold_window::{
    arguments::Arguments,
    clock::SECOND,
    line::{self, Writer},
};
use options::{Options, Task};

const SHOW_NANOSECONDS: u64 = (show::LENGTH as f64 * SECOND as f64) as u64;

/// The exit code if the display is lost or a write fails.
const FAILURE: i32 = 1;

const MISUSE: i32 = 2;

/// Runs the program. Returns its exit code, 0 for success.
pub fn run(arguments: Arguments) -> i32 {
    let options = match Options::parse(arguments) {
        Ok(options) => options,
        Err(misuse) => {
            misuse.write(&mut line::complaint());
            return MISUSE;
        }
    };
    match options.task {
        Task::Play => playing::play(&options),
        Task::Still(time) => still::write(time, &options),
        Task::Help => print(flags::write_help),
        Task::Version => print(|output| _ = output.text(flags::VERSION).text("\n")),
    }
}

fn print(write: impl FnOnce(&mut Writer)) -> i32 {
    let mut output = Writer::new(line::OUTPUT);
    write(&mut output);
    exit_code(output.flush())
}

/// Returns the exit code, and reports an error on standard error.
fn exit_code(is_written: bool) -> i32 {
    if is_written {
        return 0;
    }
    line::complaint()
        .text("standard output: cannot write\n")
        .flush();
    FAILURE
}
