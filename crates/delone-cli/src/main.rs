//! The program `delone`: points and segments in, a checked triangulation and its picture out.

mod algorithms;
mod check;
mod cli;
mod cluster;
mod column;
mod contour;
mod convert;
mod cover;
mod domain;
mod exit;
mod files;
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
mod voronoi;
mod words;

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = cli::Cli::parse_from(triangle::set_off(std::env::args_os().collect()));
    interrupt::listen();
    match cli.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
