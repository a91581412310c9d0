//! The subcommand `files`.

use crate::peers_option::{PythonOption, reachable};
use clap::Args;
use delone_bench::effort::Effort;
use delone_bench::files::engine::Engine;
use delone_bench::files::plan::Plan;
use delone_bench::files::report::Report;
use delone_bench::heading::Heading;
use delone_bench::machine::Machine;
use delone_bench::peer::Peer;
use delone_bench::process::Launcher;
use delone_bench::python::{Files, Script};
use delone_bench::stats::parse_size;
use delone_bench::workshop::Workshop;
use std::error::Error;
use std::path::PathBuf;

/// Options of the subcommand.
#[derive(Args)]
pub struct Options {
    /// Formats of meshes, by their endings; an empty one for none
    #[arg(
        long,
        value_delimiter = ',',
        default_value = "npy,parquet,ele,vtu,vtk,msh,msh2,mesh,obj,off,ply"
    )]
    formats: Vec<String>,
    /// Number of points of the mesh
    #[arg(long, value_parser = parse_size, default_value = "1M")]
    size: usize,
    /// Also reads the points of these .las and .laz files
    #[arg(long, value_delimiter = ',', value_name = "FILE")]
    clouds: Vec<PathBuf>,
    #[command(flatten)]
    python: PythonOption,
    #[command(flatten)]
    effort: Effort,
}

/// Measures, and prints the tables.
///
/// # Errors
/// If this program cannot be found, or there is no place for files.
pub fn print_tables(options: Options, command: String) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let workshop = Workshop {
        launcher: Launcher::this_program()?,
        python: options.python.find(&Engine::ALL, Script::FILES),
    };
    let python = workshop.python.as_ref();
    let plan = Plan {
        engines: reachable(Engine::ALL.to_vec(), python),
        endings: options
            .formats
            .into_iter()
            .filter(|e| !e.is_empty())
            .collect(),
        size: options.size,
        clouds: options.clouds,
        effort: options.effort,
    };
    let contenders = plan.engines.iter().map(|engine| engine.contender(python));
    let heading = Heading {
        command,
        machine,
        contenders: contenders.collect(),
    };
    let folder = Files::new()?;
    let cells = plan.run(&workshop, &folder, &mut |file| eprintln!("{file}"));
    let report = Report {
        plan,
        heading,
        cells,
    };
    print!("{}", report.to_markdown());
    Ok(())
}
