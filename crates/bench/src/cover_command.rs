//! The subcommand `cover`.

use clap::Args;
use delone_bench::cover::plan::Plan;
use delone_bench::cover::report::Report;
use delone_bench::cover::subject::{Made, Subject};
use delone_bench::effort::Effort;
use delone_bench::heading::{Contender, Heading};
use delone_bench::machine::{Machine, version_of};
use delone_bench::process::Launcher;
use delone_bench::stats::parse_size;
use delone_bench::workshop::Workshop;
use delone_io::{Target, write_plot};
use std::error::Error;
use std::num::NonZeroUsize;
use std::path::PathBuf;

/// Options of the subcommand.
#[derive(Args)]
pub struct Options {
    /// Numbers of data
    #[arg(long, value_delimiter = ',', value_parser = parse_size, default_value = "1k,10k,100k,1M")]
    sizes: Vec<usize>,
    /// Kinds of data: uniform, clusters, tracks, flights, lattice, circle, line [default: the usual four]
    #[arg(long, value_delimiter = ',')]
    data: Vec<Made>,
    /// Also covers the points in these files
    #[arg(long, value_delimiter = ',', value_name = "FILE")]
    files: Vec<String>,
    /// How many data each triangle shall hold at least: d
    #[arg(long, default_value = "10")]
    least: NonZeroUsize,
    /// By how much the hull of the data is blown up
    #[arg(long, default_value_t = 1.1)]
    factor: f64,
    #[command(flatten)]
    effort: Effort,
    /// Also writes every single run to this file
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Also draws nanoseconds a datum over the number of data: .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// Measures, and prints the tables.
///
/// # Errors
/// If this program cannot be found, or a file not be written.
pub fn print_tables(options: Options, command: String) -> Result<(), Box<dyn Error>> {
    let machine = Machine::inspect();
    let [json, plot] = [options.json.clone(), options.plot.clone()];
    let workshop = Workshop {
        launcher: Launcher::this_program()?,
        python: None,
    };
    let plan = plan(options);
    let cells = plan.run(&workshop, &mut |subject| eprintln!("{subject}"));
    let heading = Heading {
        command,
        machine,
        contenders: vec![contender()],
    };
    let report = Report {
        plan,
        heading,
        cells,
    };
    if let Some(path) = json {
        std::fs::write(path, serde_json::to_string_pretty(&report.to_json())?)?;
    }
    if let Some(path) = plot {
        let target = Target::from_arg(path, None);
        write_plot(&[target], &report.panels(), "data", &())?;
    }
    print!("{}", report.to_markdown());
    Ok(())
}

fn plan(options: Options) -> Plan {
    let kinds = match options.data.is_empty() {
        true => Made::USUAL.to_vec(),
        false => options.data,
    };
    let sizes = options.sizes;
    let made = kinds
        .into_iter()
        .flat_map(|kind| sizes.iter().map(move |&size| Subject::Made(kind, size)));
    let files = options.files.into_iter().map(Subject::File);
    Plan {
        subjects: made.chain(files).collect(),
        least: options.least.get(),
        factor: options.factor,
        effort: options.effort,
    }
}

fn contender() -> Contender {
    Contender {
        name: "delone".to_owned(),
        version: version_of("delone").to_owned(),
        timed: "`scattered::Cover`, on one thread, from a list of points to triangles and holders"
            .to_owned(),
    }
}
