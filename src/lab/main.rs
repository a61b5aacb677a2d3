use clap::error::ErrorKind;
use clap::{Parser, Subcommand};
use eightfold_lab::arguments::{BAD_INPUT, Exit};
use eightfold_lab::resources::{self, Heap, complain};
#[cfg(target_arch = "x86_64")]
use eightfold_lab::size;
use eightfold_lab::{bench, capture, figures, render, trade, truth, view};
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
    Render(render::Arguments),
    #[cfg(target_arch = "x86_64")]
    Size(size::Arguments),
    Trade(trade::Arguments),
    Truth(truth::Arguments),
    View(view::Arguments),
}

#[global_allocator]
static HEAP: Heap = Heap;

fn main() -> ExitCode {
    resources::start();
    let lab = match Lab::try_parse() {
        Ok(lab) => lab,
        Err(error) => return explain(&error),
    };
    let done = match lab.command {
        Command::Bench(arguments) => bench::run(&arguments),
        Command::Capture(arguments) => capture::run(&arguments),
        Command::Figures(arguments) => figures::run(&arguments),
        Command::Render(arguments) => render::run(&arguments),
        #[cfg(target_arch = "x86_64")]
        Command::Size(arguments) => size::run(&arguments),
        Command::Trade(arguments) => trade::run(&arguments),
        Command::Truth(arguments) => truth::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
    };
    let Err(error) = done else { return ExitCode::SUCCESS };
    complain(&format!("{error:#}"));
    error.downcast_ref::<Exit>().map_or(ExitCode::FAILURE, |exit| exit.code.into())
}

fn explain(error: &clap::Error) -> ExitCode {
    if !error.use_stderr() || error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return match error.print() {
            Ok(()) => u8::try_from(error.exit_code()).unwrap_or(BAD_INPUT).into(),
            Err(why) => {
                complain(&format!("standard output: cannot write: {why}"));
                ExitCode::FAILURE
            }
        };
    }
    let mistake = error.source().and_then(|source| source.downcast_ref());
    if let Some(Exit { message, code }) = mistake {
        complain(message);
        return (*code).into();
    }
    let text = error.to_string();
    let ends = ["\n\nUsage:", "\n\nFor more information"].iter().filter_map(|end| text.find(end));
    let words = text[..ends.min().unwrap_or(text.len())].split_whitespace();
    let words: Vec<&str> = words.collect();
    complain(words.join(" ").trim_start_matches("error: "));
    BAD_INPUT.into()
}
