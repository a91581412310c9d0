//! The subcommand `refine`.

use crate::peers_option::{PythonOption, reachable};
use clap::Args;
use delone_bench::effort::Effort;
use delone_bench::heading::Heading;
use delone_bench::machine::Machine;
use delone_bench::peer::Peer;
use delone_bench::process::Launcher;
use delone_bench::python::{Python, Script};
use delone_bench::refine::goal::{Load, Outline};
use delone_bench::refine::mesher::Mesher;
use delone_bench::refine::plan::Plan;
use delone_bench::refine::report::Report;
use delone_bench::workshop::Workshop;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Options of the subcommand.
#[derive(Args)]
pub struct Options {
    /// Outlines, as NAME or NAME:SEGMENTS [default: all]
    #[arg(long, value_delimiter = ',')]
    outlines: Vec<Outline>,
    /// Smallest angles, degrees
    #[arg(long, value_delimiter = ',', default_value = "20,25,30,33", value_parser = angle)]
    angles: Vec<f64>,
    /// Numbers of triangles that bounds on areas are made for; `none` leaves areas free
    #[arg(long, value_delimiter = ',', default_value = "none,100k,1M")]
    areas: Vec<Load>,
    /// Peers [default: all that can be reached]
    #[arg(long, value_delimiter = ',')]
    peers: Option<Vec<Mesher>>,
    #[command(flatten)]
    python: PythonOption,
    /// Numbers of threads for Delone
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<NonZeroUsize>,
    #[command(flatten)]
    effort: Effort,
    /// Also writes every single run to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

fn angle(text: &str) -> Result<f64, String> {
    let angle: Option<f64> = text.parse().ok();
    let angle = angle.filter(|angle| (0.0..60.0).contains(angle));
    angle.ok_or_else(|| format!("`{text}` is no angle from 0 to less than 60 degrees"))
}

/// Measures, and prints the tables.
///
/// # Errors
/// If this program cannot be found, or a file not be written.
pub fn print_tables(options: Options, command: String) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let json = options.json.clone();
    let peers = options.peers.clone().unwrap_or(Mesher::PEERS.to_vec());
    let workshop = Workshop {
        launcher: Launcher::this_program()?,
        python: options.python.find(&peers, Script::REFINE),
    };
    let python = workshop.python.as_ref();
    let plan = plan(options, peers, python);
    let contenders = plan.meshers.iter().map(|mesher| mesher.contender(python));
    let heading = Heading {
        command,
        machine,
        contenders: contenders.collect(),
    };
    let cells = plan.run(&workshop, &mut |group| eprintln!("{group}"));
    let report = Report {
        plan,
        heading,
        cells,
    };
    if let Some(path) = json {
        std::fs::write(path, serde_json::to_string_pretty(&report.to_json())?)?;
    }
    print!("{}", report.to_markdown());
    Ok(())
}

fn plan(options: Options, peers: Vec<Mesher>, python: Option<&Python>) -> Plan {
    let threads = options.threads.into_iter().map(NonZeroUsize::get);
    let ours = threads.map(|threads| Mesher::Delone { threads });
    let all = |outlines: Vec<Outline>| match outlines.is_empty() {
        true => Outline::ALL.to_vec(),
        false => outlines,
    };
    Plan {
        meshers: ours.chain(reachable(peers, python)).collect(),
        outlines: all(options.outlines),
        loads: options.areas,
        angles: options.angles,
        effort: options.effort,
    }
}
