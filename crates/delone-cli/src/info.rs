//! `delone info`: what is in a file of points and segments, and what is wrong with it, exactly.

mod report;
mod trouble;

use crate::exit::Failure;
use crate::files::{self, Reading};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::timing::timed;
use report::Report;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone info map.poly                       counts, rings, and what is wrong, as far as ten of each
  delone info map.geojson --limit 1000       a thousand of each
  delone info a.poly b.wkt --json            one JSON object a line
  delone info map.poly --json | jq .crossings.total";

const JSON: &str = "\
The JSON object of --json (numbers of points and segments are those of the file, which begin at base):
  file, base       the file, and the number of its first point
  points, segments, polygons, holes, regions
                   counts of what the file holds
  bounds           corners of the bounding box as [[x, y], [x, y]]; null without points
  usual_rule       hull, carve or evenodd: what `delone triangulate` keeps by default
  clean            whether segments meet at common ends only, equal ones merged
  collinear        whether all points lie on one line
  duplicates       points equal to an earlier one
  loose_points, open_ends
                   distinct points that end no segment, or one
  zero_length      segments whose ends are equal points
  repeated         segments equal to an earlier one
  on_segments      distinct points inside a segment
  overlaps         pairs of segments that have more than a point in common, and the ends of that
  crossings        pairs of segments that cross inside both, and where, rounded
  rings            closed rings, named by their first segment: segments, depth, the ring around it;
                   if rings meet (not apart), none is taken to be inside another
  seconds          wall time of the phases read and examine
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)
Each kind from duplicates on has a total, and of the first few cases a list.";

/// Say what a file of points and segments holds, and what is wrong with it
///
/// The facts are exact: duplicates, segments of no length, repeated, overlapping and crossing ones,
/// points on segments, the nesting of rings. None of it keeps `delone triangulate` from a result,
/// but crossings must be split. The exit code is 0 whatever is found.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Info {
    /// Files of points or domains, or `-` for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// How many of each kind of trouble are listed
    #[arg(short, long, value_name = "N", default_value_t = 10)]
    limit: usize,
    /// Print one JSON object for each file, each on its own line
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
}

impl Info {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let mut outcome = Ok(());
        for file in &self.files {
            let report = match self.examine(file, quiet) {
                Ok(report) => report,
                Err(failure @ Failure::BadInput(_)) => {
                    failure.report();
                    outcome = Err(Failure::NotAllRead);
                    continue;
                }
                Err(failure) => return Err(failure),
            };
            if self.json {
                files::print(&report.json())?;
            } else {
                files::print(&report.to_string())?;
            }
        }
        outcome
    }

    fn examine(&self, file: &Path, quiet: bool) -> Result<Report, Failure> {
        let progress = Progress::new(quiet);
        let ((name, mut domain), read) = timed(|| {
            let input = self.reading.open(file)?;
            let (domain, unused) = input.domain(&progress)?;
            progress.note(&unused);
            Ok((input.name(), domain))
        })?;
        let numbering = Numbering::of(&name, &domain);
        let pslg = domain.take_pslg();
        let (facts, examine) = timed(|| {
            let facts = pslg.facts(self.limit, &progress);
            facts.map_err(|error| numbering.failure(error))
        })?;
        progress.finish();
        let report = Report::new(name, &domain, &pslg, &facts, self.limit);
        Ok(report.took([read, examine]))
    }
}
