//! The lab's program: parses the command line and runs one command.

use clap::{Parser, Subcommand, error::ErrorKind};
use eightfold_lab::{
    arguments, bench, capture, figures, interrupt, missed, render, report, scenes, size, trade,
    truth, view,
};
use std::error::Error;
use std::process::ExitCode;

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
    Size(size::Arguments),
    Trade(trade::Arguments),
    Truth(truth::Arguments),
    View(view::Arguments),
}

/// The exit code for an invalid command line, the same as in most programs.
const BAD_INPUT: u8 = 2;

fn main() -> ExitCode {
    let lab = match Lab::try_parse() {
        Ok(lab) => lab,
        Err(error) => return explain(&error),
    };
    let done = match lab.command {
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Capture(arguments) => capture::run(&arguments),
        Command::Figures(arguments) => figures::run(&arguments),
        Command::Missed(arguments) => missed::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        Command::Report(arguments) => report::run(&arguments),
        Command::Size(arguments) => size::run(&arguments),
        Command::Trade(arguments) => trade::run(&arguments),
        Command::Truth(arguments) => truth::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
    };
    let Err(error) = done else {
        return ExitCode::SUCCESS;
    };
    eprintln!("error: {error:#}");
    if error.is::<interrupt::Stopped>() {
        interrupt::EXIT_CODE.into()
    } else if error.is::<arguments::BadInput>() {
        BAD_INPUT.into()
    } else {
        ExitCode::FAILURE
    }
}

/// Prints the help, or the error in one line.
fn explain(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        error.exit();
    }
    // Editors find a mistake by the place that its line begins with.
    let mistake = error
        .source()
        .and_then(|source| source.downcast_ref::<scenes::Mistake>());
    if let Some(mistake) = mistake {
        eprintln!("{mistake}");
        return BAD_INPUT.into();
    }
    let text = error.to_string();
    // The usage and a pointer to the help follow.
    let wrong = text.split("\n\nUsage:").next().unwrap_or(&text);
    let wrong = wrong.split("\n\nFor more").next().unwrap_or(wrong);
    let words: Vec<&str> = wrong.split_whitespace().collect();
    eprintln!("{}", words.join(" "));
    BAD_INPUT.into()
}
