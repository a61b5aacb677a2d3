use clap::{Parser, Subcommand, error::ErrorKind};
use eightfold_lab::arguments::{BAD_INPUT, Exit};
use eightfold_lab::{bench, capture, figures, missed, render, report, size, trade, truth, view};
use std::error::Error;
use std::process::ExitCode;

/// Draws Eightfold's frames, and measures their speed and error
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
    error
        .downcast_ref::<Exit>()
        .map_or(ExitCode::FAILURE, |exit| exit.code.into())
}

fn explain(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        error.exit();
    }
    // Begin with the place in the scene file, where editors look for it.
    let mistake = error.source().and_then(|source| source.downcast_ref());
    if let Some(Exit { message, code }) = mistake {
        eprintln!("{message}");
        return (*code).into();
    }
    let text = error.to_string();
    let line = text.split("\n\nUsage:").next().unwrap_or(&text);
    let line = line.split("\n\nFor more").next().unwrap_or(line);
    let words: Vec<&str> = line.split_whitespace().collect();
    eprintln!("{}", words.join(" "));
    BAD_INPUT.into()
}
