//! `delone sample`: points to try things on, embedded or generated.

use crate::exit::Failure;
use crate::files::{self, Content, Reading, Writing};
use crate::progress::Progress;
use crate::words::{counted, list};
use delone::Point;
use delone_io::{Format, PointSet, Source};
use delone_samples::Distribution;
use std::path::PathBuf;

/// The name of the embedded sample.
pub const EMBEDDED: &str = "populated-places";

/// What the embedded sample is.
pub const ABOUT: &str = "\
populated-places: 1249 places of the world by longitude and latitude, embedded in this program
(made with Natural Earth, public domain, naturalearthdata.com)";

/// What to do after the first try.
pub const NEXT: &str = "\
Next: open populated-places.png, or let the result be verified from its files alone:
  delone check populated-places.ele
Your own points: delone triangulate points.csv -o mesh.ele --picture mesh.png";

const CSV: &[u8] = include_bytes!("../samples/populated-places.csv");

const EXAMPLES: &str = "\
Examples:
  delone sample                                    list them
  delone sample populated-places -o cities.csv     longitude, latitude, population
  delone sample uniform -n 1000000 --seed 7 -o points.npy
  delone sample tilted-grid -n 3600 | delone triangulate - --json";

/// List and write samples: embedded ones, and generated ones for tests and benchmarks
///
/// The same name, count and seed give the same points, bit for bit, on every machine.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{}", crate::exit::HELP))]
pub struct Sample {
    /// Name of the sample; without it the samples are listed
    #[arg(value_parser = name)]
    name: Option<Name>,
    /// File to write (.csv, .xyz, .npy, .node, .vtu, .svg, .png); by default CSV on standard output
    #[arg(short, long, value_name = "OUT", requires = "name")]
    output: Vec<PathBuf>,
    /// Number of points to generate
    #[arg(short = 'n', long, default_value_t = 1000, value_parser = clap::value_parser!(u32))]
    count: u32,
    /// Seed of the random numbers
    #[arg(short, long, default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    writing: Writing,
}

/// A sample that can be had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Name {
    Embedded,
    Generated(Distribution),
}

fn name(text: &str) -> Result<Name, String> {
    if text == EMBEDDED {
        return Ok(Name::Embedded);
    }
    text.parse()
        .map(Name::Generated)
        .map_err(|_| "no such sample; `delone sample` lists them".to_owned())
}

/// Returns the embedded sample as an input.
pub fn embedded() -> Source {
    Source::Memory {
        name: format!("{EMBEDDED}.csv"),
        bytes: CSV.to_vec(),
    }
}

impl Sample {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        match self.name {
            Some(name) => self.write(name, quiet),
            None => files::print(&listing()),
        }
    }

    fn write(&self, name: Name, quiet: bool) -> Result<(), Failure> {
        let wanted = self.output.iter().map(|o| (o.clone(), Content::Points));
        let mut outputs = self.writing.outputs(wanted)?;
        if outputs.is_empty() {
            outputs = self.writing.stdout(Format::Table);
        }
        let progress = Progress::new(quiet);
        let points = match name {
            Name::Embedded => Reading::default().points(&embedded(), &progress)?,
            Name::Generated(distribution) => self.generate(distribution),
        };
        let written = self.writing.points(&outputs, &points, &progress)?;
        progress.finish();
        if !quiet && !written.is_empty() {
            let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
            let count = counted(points.points.len(), "point", "points");
            eprintln!("wrote {count} to {}", list(&names));
        }
        Ok(())
    }

    /// Generates points; Ctrl-C ends the process, for there is nothing to clean up yet.
    fn generate(&self, distribution: Distribution) -> PointSet {
        let points = distribution.points(self.count as usize, self.seed);
        PointSet {
            points: points.into_iter().map(Point::from).collect(),
            ..PointSet::default()
        }
    }
}

fn listing() -> String {
    let mut text = format!(
        "Embedded:\n  {EMBEDDED:16} 1249 places of the world: longitude, latitude, population\n  \
         {:16} (made with Natural Earth, public domain)\n\n\
         Generated, of any size (--count) and seed (--seed):",
        ""
    );
    for distribution in Distribution::ALL {
        text.push_str(&format!("\n  {distribution:16} {}", distribution.about()));
    }
    text
}
