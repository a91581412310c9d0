//! The program `delone`: points and segments in, a checked triangulation and its picture out.

mod algorithms;
mod batch;
mod check;
mod cli;
mod cluster;
mod column;
mod completions;
mod config;
mod contour;
mod convert;
mod cover;
mod doctor;
mod domain;
mod exit;
mod files;
mod formats;
mod graph;
mod info;
mod interpolate;
mod interrupt;
mod job;
mod memory;
mod mesh;
mod nearest;
mod numbering;
mod numbers;
mod phases;
mod progress;
mod race;
mod refinable;
mod sample;
mod sizing;
mod stopwatch;
mod survey;
mod task;
mod theatre;
mod timing;
mod triangle;
mod triangulate;
mod unmet;
mod voice;
mod voronoi;
mod words;

use clap::Parser;
use exit::Failure;
use std::ffi::OsString;
use std::process::ExitCode;

fn main() -> ExitCode {
    keep_panics_of_others_quiet();
    let arguments = triangle::set_off(std::env::args_os().collect());
    let wants_json = wants_json(&arguments);
    let cli = match cli::Cli::try_parse_from(arguments) {
        Ok(cli) => cli,
        Err(error) if wants_json && error.use_stderr() => {
            voice::settle(false, true);
            return Failure::Usage(config::in_words(&error)).report();
        }
        Err(error) => error.exit(),
    };
    voice::settle(cli.is_verbose(), wants_json);
    interrupt::listen();
    match cli.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// Lets panics be told as usual, but for those in readers of others, which end as errors.
fn keep_panics_of_others_quiet() {
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        if !delone_io::is_reading_with_others() {
            usual(panic);
        }
    }));
}

/// Tells whether results are to be JSON, whatever else is wrong with the arguments.
fn wants_json(arguments: &[OsString]) -> bool {
    let options = arguments.iter().take_while(|a| *a != "--");
    options.into_iter().any(|a| a == "--json")
}
