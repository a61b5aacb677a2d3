//! The lab's program: parses the command line and runs one command.

// Rust's own `main` replaces a closed standard output by /dev/null, where results would be lost without an error.
#![no_main]

use clap::{Parser, Subcommand, error::ErrorKind};
use eightfold_lab::{
    arguments, bench, capture, figures, interrupt, missed, output, render, report, scene, scenes,
    size, sound, trade, truth, view,
};
use std::error::Error;
use std::io::{self, IsTerminal};
use std::path::Path;
use std::time::Instant;

/// Draws Eightfold's frames and measures what speed costs.
#[derive(Parser)]
#[command(name = "lab", bin_name = "cargo lab", version)]
struct Lab {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Bench(bench::Arguments),
    Capture(capture::Arguments),
    Figures(figures::Arguments),
    Missed(missed::Arguments),
    Render(render::Arguments),
    Report(report::Arguments),
    Scene(scene::Arguments),
    Size(size::Arguments),
    Sound(sound::Arguments),
    Trade(trade::Arguments),
    Truth(truth::Arguments),
    View(view::Arguments),
}

/// The exit code for an invalid command line, the same as in most programs.
const BAD_INPUT: i32 = 2;

eightfold_window::main!(run);

/// Runs the program. Returns its exit code.
fn run(_: eightfold_window::arguments::Arguments) -> i32 {
    let start = Instant::now();
    let lab = match Lab::try_parse() {
        Ok(lab) => lab,
        Err(error) => return explain(&error),
    };
    if let Err(error) = interrupt::watch() {
        return fail(&error.into());
    }
    let done = match lab.command {
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Capture(arguments) => capture::run(&arguments),
        Command::Figures(arguments) => figures::run(&arguments),
        Command::Missed(arguments) => missed::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Scene(arguments) => scene::run(&arguments),
        Command::Size(arguments) => size::run(&arguments),
        Command::Sound(arguments) => sound::run(&arguments),
        Command::Trade(arguments) => trade::run(&arguments),
        Command::Truth(arguments) => truth::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
    };
    match done {
        Ok(()) => {
            if let Some(written) = output::written().filter(|_| !output::is_quiet()) {
                eprintln!("wrote {written}, in {:.1} s", start.elapsed().as_secs_f64());
            }
            0
        }
        Err(error) => fail(&error),
    }
}

/// Prints an error. Returns its exit code.
fn fail(error: &anyhow::Error) -> i32 {
    let is_stopped = error.is::<interrupt::Stopped>();
    // One that runs inside of another leaves that line to it.
    if !(is_stopped && output::is_quiet()) {
        eprintln!("error: {error:#}");
    }
    if is_stopped {
        interrupt::exit_code()
    } else if error.is::<arguments::BadInput>() {
        BAD_INPUT
    } else {
        1
    }
}

/// Prints the help, or one line that says what is wrong.
fn explain(error: &clap::Error) -> i32 {
    let text = error.render();
    if !error.use_stderr() {
        let text = if io::stdout().is_terminal() {
            text.ansi().to_string()
        } else {
            text.to_string()
        };
        let printed = output::write(Path::new("-"), text.as_bytes());
        return printed.map_or_else(|error| fail(&error), |()| 0);
    }
    // Editors find a mistake by the place that its line begins with.
    let mistake = error
        .source()
        .and_then(|source| source.downcast_ref::<scenes::Mistake>());
    if let Some(mistake) = mistake {
        eprintln!("{mistake}");
        return BAD_INPUT;
    }
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        let _ = error.print();
    } else {
        let text = text.to_string();
        // The usage and a pointer to the help follow.
        let wrong = text.split("\n\nUsage:").next().unwrap_or(&text);
        let wrong = wrong.split("\n\nFor more").next().unwrap_or(wrong);
        let words: Vec<&str> = wrong.split_whitespace().collect();
        eprintln!("{}", words.join(" "));
    }
    BAD_INPUT
}
