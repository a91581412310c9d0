//! The program `delone`: points and segments in, a checked triangulation and its picture out.

mod check;
mod cli;
mod convert;
mod domain;
mod exit;
mod files;
mod info;
mod interrupt;
mod memory;
mod numbering;
mod progress;
mod sample;
mod stopwatch;
mod timing;
mod triangulate;
mod words;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = cli::Cli::parse();
    interrupt::listen();
    match cli.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
