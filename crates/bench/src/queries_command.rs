//! The subcommand `queries`.

use clap::Args;
use delone_bench::machine::Machine;
use delone_bench::process::Launcher;
use delone_bench::queries::engine::Engine;
use delone_bench::queries::plan::Plan;
use delone_bench::queries::question::Question;
use delone_bench::queries::report::Report;
use delone_bench::stats::parse_size;
use delone_samples::Distribution;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;

/// Options of the subcommand.
#[derive(Args)]
pub struct Options {
    /// Questions [default: all]
    #[arg(long, value_delimiter = ',')]
    questions: Vec<Question>,
    /// Kinds of points
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "uniform,kuzmin,lonlat,grid"
    )]
    distributions: Vec<Distribution>,
    /// Number of points, and of queries
    #[arg(long, value_parser = parse_size, default_value = "1M")]
    size: usize,
    /// Peers [default: all that can be asked]
    #[arg(long, value_delimiter = ',')]
    peers: Option<Vec<Engine>>,
    /// Numbers of threads for Delone
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<NonZeroUsize>,
    /// Processes that count for each cell
    #[arg(long, default_value_t = 5)]
    runs: usize,
    /// Processes discarded before them
    #[arg(long, default_value_t = 1)]
    warmups: usize,
    /// Seed of the points
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Seconds that one process may take
    #[arg(long, default_value_t = 60)]
    timeout: u64,
    /// Also writes every single run to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
}

/// Measures, and prints the tables.
///
/// # Errors
/// If this program cannot be found, or a file not be written.
pub fn print_tables(options: Options, command: String) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let json = options.json.clone();
    let plan = plan(options);
    let cells = plan.run(&Launcher::this_program()?, &mut |group| {
        eprintln!("{group}")
    });
    let report = Report {
        plan,
        machine,
        command,
        cells,
    };
    if let Some(path) = json {
        std::fs::write(path, serde_json::to_string_pretty(&report.to_json())?)?;
    }
    print!("{}", report.to_markdown());
    Ok(())
}

fn plan(options: Options) -> Plan {
    let threads = options.threads.into_iter().map(NonZeroUsize::get);
    let ours = threads.map(|threads| Engine::Delone { threads });
    let peers = options.peers.unwrap_or(Engine::PEERS.to_vec());
    Plan {
        engines: ours.chain([Engine::Singly]).chain(peers).collect(),
        questions: match options.questions.is_empty() {
            true => Question::ALL.to_vec(),
            false => options.questions,
        },
        distributions: options.distributions,
        size: options.size,
        seed: options.seed,
        warmups: options.warmups,
        runs: options.runs,
        timeout: Duration::from_secs(options.timeout),
    }
}
