//! `delone info`: what a file of points, segments or triangles holds.

mod columns;
mod report;

use crate::batch;
use crate::exit::Failure;
use crate::files::{self, Reading};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::timing::timed;
use delone_io::{DomainData, MeshData};
use report::Report;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone info map.poly                       counts, bounds, rings, markers, regions
  delone info survey.csv                     columns, and from where to where their values go
  delone info mesh.vtu                       triangles, and what goes with them
  delone info a.poly b.wkt --json            one JSON object a line
What is wrong with a file says `delone doctor`.";

const JSON: &str = "\
The JSON object of --json (numbers of points and segments are those of the file, which begin at base):
  file, base       the file, and the number of its first point
  points, segments, polygons, holes, triangles
                   counts of what the file holds
  bounds           corners of the bounding box as [[x, y], [x, y]]; null without points
  collinear        whether all points lie on one line
  usual_rule       hull, carve or evenodd: what `delone triangulate` keeps by default
  columns, triangle_columns
                   for each column of numbers: name, count of numbers, least, largest
  point_markers, segment_markers
                   for each marker how often it is there, as [marker, count]; null without markers
  regions          the seed of each: at, attribute, max_area
  rings            closed rings, named by their first segment: segments, depth, the ring around it;
                   if rings meet (not apart), none is taken to be inside another
  seconds          wall time of the phases read and examine
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)
Of markers, regions and rings there is a total, and a list of the first few.";

/// Say what a file of points, segments or triangles holds
///
/// Counts, bounds, columns with their ranges, markers, regions, and which ring lies in which. What is wrong
/// with it says `delone doctor`.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Info {
    /// Files of points, domains or meshes, or `-` for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// How many markers, regions and rings are listed
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
        for file in &batch::expand(&self.files)? {
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
                files::print_json(&report)?;
            } else {
                files::print(&report.to_string())?;
            }
        }
        outcome
    }

    fn examine(&self, file: &Path, quiet: bool) -> Result<Report, Failure> {
        let progress = Progress::new(quiet);
        let ((name, mesh, mut domain), read) = timed(|| {
            let input = self.reading.open(file)?;
            let name = input.name();
            if input.brings_triangles(&progress)? {
                let mesh = input.mesh(&progress)?;
                let domain = DomainData::from(MeshData {
                    triangles: Vec::new(),
                    ..mesh.clone()
                });
                return Ok((name, Some(mesh), domain));
            }
            let (domain, unused) = input.domain(&progress)?;
            progress.note(&unused);
            Ok((name, None, domain))
        })?;
        let numbering = Numbering::of(&name, &domain);
        let pslg = domain.take_pslg();
        let (facts, examine) = timed(|| {
            let facts = pslg.facts(0, &progress);
            facts.map_err(|error| numbering.failure(error))
        })?;
        progress.finish();
        let report = Report::new(name, &domain, mesh.as_ref(), &pslg, &facts, self.limit);
        Ok(report.took([read, examine]))
    }
}
