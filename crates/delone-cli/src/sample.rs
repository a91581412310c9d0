//! `delone sample`: points to try things on, embedded or generated.

use crate::exit::Failure;
use crate::files::{self, Content, Input, Writing};
use crate::progress::Progress;
use crate::words::{self, counted, list};
use delone::Point;
use delone_io::{Format, PointSet, ReadOptions, Source};
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

/// The most points that a triangulation takes: 32 bits number its half-edges, six for a point.
const MAX_POINTS: usize = (u32::MAX / 6) as usize;

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
pub fn embedded() -> Input {
    let source = Source::Memory {
        name: format!("{EMBEDDED}.csv"),
        bytes: CSV.to_vec(),
    };
    Input::new(source, Some(Format::Table), ReadOptions::default())
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
            outputs = self.writing.stdout(Content::Points, Format::Table)?;
        }
        let progress = Progress::new(quiet);
        let points = match name {
            Name::Embedded => {
                let (points, unused) = embedded().points(&progress)?;
                progress.note(&unused);
                points
            }
            Name::Generated(distribution) => self.generate(distribution)?,
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
    fn generate(&self, distribution: Distribution) -> Result<PointSet, Failure> {
        let count = self.count as usize;
        require_room(count)?;
        let points = distribution.points(count, self.seed);
        Ok(PointSet {
            points: points.into_iter().map(Point::from).collect(),
            ..PointSet::default()
        })
    }
}

/// Requires that so many points can be triangulated, and fit into memory.
fn require_room(count: usize) -> Result<(), Failure> {
    let given = words::count(count);
    if count > MAX_POINTS {
        let limit = words::count(MAX_POINTS);
        return Err(Failure::NotReached(format!(
            "{given} points: more than {limit} cannot be triangulated; ask for fewer"
        )));
    }
    // Given back at once: generating needs as much, and would abort for want of it.
    Vec::<Point>::new().try_reserve_exact(count).map_err(|_| {
        Failure::NotReached(format!(
            "{given} points do not fit into memory; ask for fewer"
        ))
    })
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
