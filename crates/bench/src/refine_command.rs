//! The subcommand `refine`.

use clap::Args;
use delone_bench::machine::Machine;
use delone_bench::process::Launcher;
use delone_bench::refine::goal::{Load, Outline};
use delone_bench::refine::mesher::Mesher;
use delone_bench::refine::plan::{Plan, Workshop};
use delone_bench::refine::python::Python;
use delone_bench::refine::report::Report;
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::time::Duration;

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
    /// Python with the packages triangle, cgal, gmsh and numpy, or some of them
    #[arg(long, value_name = "PATH", default_value = "python3")]
    python: PathBuf,
    /// Numbers of threads for Delone
    #[arg(long, value_delimiter = ',', default_value = "1,2")]
    threads: Vec<NonZeroUsize>,
    /// Processes that count for each cell
    #[arg(long, default_value_t = 5)]
    runs: usize,
    /// Processes discarded before them
    #[arg(long, default_value_t = 1)]
    warmups: usize,
    /// Seed of the outlines
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Seconds that one mesh may take
    #[arg(long, default_value_t = 60)]
    timeout: u64,
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
    let workshop = Workshop {
        launcher: Launcher::this_program()?,
        python: find_python(&options),
    };
    let plan = plan(options, workshop.python.as_ref());
    let cells = plan.run(&workshop, &mut |group| eprintln!("{group}"));
    let report = Report {
        versions: versions(&plan, workshop.python.as_ref()),
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

fn wanted(options: &Options) -> Vec<Mesher> {
    options.peers.clone().unwrap_or(Mesher::PEERS.to_vec())
}

/// Looks for Python if a peer needs it; says so if it is not there.
fn find_python(options: &Options) -> Option<Python> {
    let peers = wanted(options);
    peers.iter().find_map(|peer| peer.python_package())?;
    let found = Python::find(&options.python);
    let tell = |error| eprintln!("{}: {error}", options.python.display());
    found.map_err(tell).ok()
}

/// Leaves out the peers that cannot be reached, and says so.
fn plan(options: Options, python: Option<&Python>) -> Plan {
    let is_here = |peer: &Mesher| {
        let Some(package) = peer.python_package() else {
            return true;
        };
        let version = python.and_then(|python| python.version(*peer));
        if version.is_none() {
            eprintln!("{peer} is left out: `pip install {package} numpy`, and name that Python");
        }
        version.is_some()
    };
    let peers = wanted(&options).into_iter().filter(is_here);
    let threads = options.threads.into_iter().map(NonZeroUsize::get);
    let ours = threads.map(|threads| Mesher::Delone { threads });
    let all = |outlines: Vec<Outline>| match outlines.is_empty() {
        true => Outline::ALL.to_vec(),
        false => outlines,
    };
    Plan {
        meshers: ours.chain(peers).collect(),
        outlines: all(options.outlines),
        loads: options.areas,
        angles: options.angles,
        seed: options.seed,
        warmups: options.warmups,
        runs: options.runs,
        timeout: Duration::from_secs(options.timeout),
    }
}

fn versions(plan: &Plan, python: Option<&Python>) -> Vec<String> {
    let version = |mesher: &Mesher| {
        let ours = mesher.crate_version();
        let theirs = || python.and_then(|python| python.version(*mesher));
        ours.or_else(theirs).unwrap_or("unknown").to_owned()
    };
    plan.meshers.iter().map(version).collect()
}
