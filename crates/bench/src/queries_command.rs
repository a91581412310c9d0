//! The subcommand `queries`.

use crate::peers_option::{PythonOption, reachable};
use clap::Args;
use delone_bench::effort::Effort;
use delone_bench::heading::Heading;
use delone_bench::machine::Machine;
use delone_bench::peer::Peer;
use delone_bench::process::Launcher;
use delone_bench::python::{Python, Script};
use delone_bench::queries::engine::Engine;
use delone_bench::queries::plan::Plan;
use delone_bench::queries::question::Question;
use delone_bench::queries::report::Report;
use delone_bench::stats::parse_size;
use delone_bench::workshop::Workshop;
use delone_samples::Distribution;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Options of the subcommand.
#[derive(Args)]
pub struct Options {
    /// Questions [default: all]
    #[arg(long, value_delimiter = ',')]
    questions: Vec<Question>,
    /// Kinds of points
    #[arg(long, value_delimiter = ',', default_value = "uniform")]
    distributions: Vec<Distribution>,
    /// Number of points, and of queries
    #[arg(long, value_parser = parse_size, default_value = "1M")]
    size: usize,
    /// Peers [default: all that can be reached]
    #[arg(long, value_delimiter = ',')]
    peers: Option<Vec<Engine>>,
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

/// Measures, and prints the tables, each as soon as it can be.
///
/// # Errors
/// If this program cannot be found, or a file not be written.
pub fn print_tables(options: Options, command: String) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let json = options.json.clone();
    let peers = options.peers.clone().unwrap_or(Engine::PEERS.to_vec());
    let workshop = Workshop {
        launcher: Launcher::this_program()?,
        python: options.python.find(&peers, Script::QUERIES),
    };
    let python = workshop.python.as_ref();
    let plan = plan(options, peers, python);
    let contenders = plan.engines.iter().map(|engine| engine.contender(python));
    let heading = Heading {
        command,
        machine,
        contenders: contenders.collect(),
    };
    let report = Report { plan, heading };
    println!("{}", report.beginning());
    let cells = report.plan.run(
        &workshop,
        &mut |group| eprintln!("{group}"),
        &mut |room, cells| print!("{}", report.room(room, cells)),
    );
    if let Some(path) = json {
        let json = report.to_json(&cells);
        std::fs::write(path, serde_json::to_string_pretty(&json)?)?;
    }
    Ok(())
}

fn plan(options: Options, peers: Vec<Engine>, python: Option<&Python>) -> Plan {
    let threads = options.threads.into_iter().map(NonZeroUsize::get);
    let ours = threads.map(|threads| Engine::Delone { threads });
    let peers = reachable(peers, python);
    Plan {
        engines: ours.chain([Engine::Singly]).chain(peers).collect(),
        questions: match options.questions.is_empty() {
            true => Question::ALL.to_vec(),
            false => options.questions,
        },
        distributions: options.distributions,
        size: options.size,
        effort: options.effort,
    }
}
