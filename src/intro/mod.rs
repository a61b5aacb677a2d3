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

/// The exit code if the display is lost, a write fails, or the processor lacks an instruction set.
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
    match (options.task, options.isa) {
        (Task::Help, _) => print(flags::write_help),
        (Task::Version, _) => print(|output| _ = output.text(flags::VERSION).text("\n")),
        (Task::Play, Some(isa)) => playing::play(&options, isa),
        (Task::Still(time), Some(isa)) => still::write(time, &options, isa),
        (_, None) => {
            line::complaint()
                .text("this processor lacks AVX2; build with: cargo build --release -p eightfold --features sse2\n")
                .flush();
            FAILURE
        }
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
