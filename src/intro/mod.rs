//! The program of the intro: arguments, clock, keys.

mod flags;
mod options;
mod playing;
mod renderer;
mod still;
mod tally;

use eightfold::show;
use eightfold_window::arguments::Arguments;
use eightfold_window::clock::SECOND;
use eightfold_window::line::{self, Writer};
use options::{Options, Task};

const SHOW_NANOSECONDS: u64 = (show::LENGTH as f64 * SECOND as f64) as u64;

/// The exit code if the display is lost, a write fails, or the processor lacks an instruction set.
const FAILURE: i32 = 1;

const MISUSE: i32 = 2;

pub fn run(arguments: Arguments) -> i32 {
    let options = match Options::parse(arguments) {
        Ok(options) => options,
        Err(misuse) => {
            misuse.write(&mut line::complaint());
            return MISUSE;
        }
    };
    let mut output = Writer::new(line::OUTPUT);
    let mut code = 0;
    match (options.task, options.isa) {
        (Task::Help, _) => flags::write_help(&mut output),
        (Task::Version, _) => _ = output.text(flags::VERSION).text("\n"),
        (Task::Play, Some(isa)) => code = playing::play(&options, isa, &mut output),
        (Task::Still(time), Some(isa)) => code = still::write(time, &options, isa, &mut output),
        (_, None) => {
            line::complain(
                "this processor lacks AVX2; build with: cargo build --release -p eightfold --features sse2",
                "",
            );
            code = FAILURE;
        }
    }
    if output.flush() {
        return code;
    }
    line::complain("standard output: cannot write", "");
    if code == 0 { FAILURE } else { code }
}
