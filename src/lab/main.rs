use clap::error::{ContextKind, ErrorKind};
use clap::{CommandFactory, Parser, Subcommand};
use eightfold_lab::arguments::{BAD_INPUT, Exit};
use eightfold_lab::resources::{self, Heap, complain};
use eightfold_lab::{bench, capture, figures, render, size, trade, truth, view};
use std::error::Error;
use std::process::ExitCode;

const MAX_VALUE: usize = 60;

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
        Command::Size(arguments) => size::run(&arguments),
        Command::Trade(arguments) => trade::run(&arguments),
        Command::Truth(arguments) => truth::run(&arguments),
        Command::View(arguments) => view::run(&arguments),
    };
    let Err(error) = done else {
        return ExitCode::SUCCESS;
    };
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
    let text = message(error).unwrap_or_else(|| error.to_string());
    let words: Vec<&str> = text.split_whitespace().collect();
    complain(&words.join(" "));
    BAD_INPUT.into()
}

fn message(error: &clap::Error) -> Option<String> {
    let text = |kind| error.get(kind).map(ToString::to_string);
    let short = |kind| {
        let text = text(kind)?;
        Some(match text.char_indices().nth(MAX_VALUE) {
            Some((end, _)) => format!("'{}...'", &text[..end]),
            None => format!("'{text}'"),
        })
    };
    let flags = |kind| {
        let text = text(kind)?;
        let words = text.split(['<', '|', ' ', ',']);
        let flags: Vec<&str> = words.filter(|word| word.starts_with("--")).collect();
        Some(flags.join(" or "))
    };
    let [flag, other] = [ContextKind::InvalidArg, ContextKind::PriorArg].map(flags);
    let value = short(ContextKind::InvalidValue);
    Some(match error.kind() {
        ErrorKind::ValueValidation => format!("{} is {}; {}", flag?, value?, error.source()?),
        ErrorKind::InvalidValue => format!("{} has no value", flag?),
        ErrorKind::TooManyValues => format!("{} is {}; must be without a value", flag?, value?),
        ErrorKind::UnknownArgument => {
            let argument = short(ContextKind::InvalidArg)?;
            format!("argument is {argument}; must be one that --help lists")
        }
        ErrorKind::InvalidSubcommand => {
            let given = short(ContextKind::InvalidSubcommand)?;
            let lab = Lab::command();
            let names: Vec<&str> = lab.get_subcommands().map(clap::Command::get_name).collect();
            format!("command is {given}; must be one of {}", names.join(", "))
        }
        ErrorKind::MissingRequiredArgument => format!("{} is missing", flag?),
        ErrorKind::ArgumentConflict if flag == other => format!("{} is set twice", flag?),
        ErrorKind::ArgumentConflict => format!("{} conflicts with {}", flag?, other?),
        _ => return None,
    })
}
