//! `delone triangulate`: points and segments in, mesh, picture and figures out.

use crate::batch::{self, Batching, Many, Naming};
use crate::exit::Failure;
use crate::files::{self, Content, Outputs};
use crate::job::{Built, Figures, Job, Made, OfMesh, Report};
use crate::progress::Progress;
use crate::timing::timed;
use delone_io::{DomainData, Inherited, MeshView};
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone triangulate                              the embedded lake: mesh and picture appear here
  delone triangulate lake.poly -o mesh.ele        writes mesh.node, .ele, .edge, .neigh and .poly
  delone triangulate map.geojson --crossings split -o map.vtu --picture map.png
  delone triangulate rings.poly --domain evenodd  rings in rings are holes, islands in them are not
  delone triangulate cities.csv --columns lon,lat -o cities.vtu --picture cities.svg
  delone triangulate points.npy --json --threads 1 | jq .seconds.triangulate
  cat points.txt | delone triangulate - -o - --to ele > mesh.ele";

const JSON: &str = "\
The JSON object of --json:
  vertices         vertices of the triangles; if no three points make one, distinct points
  triangles, edges counts of what is kept
  hull_edges       edges on its border; of bare points, that is their convex hull
  duplicates       points merged into an equal one
  carved           distinct points that are in no triangle that is kept
  segments         segments of the input
  constrained_edges  edges that lie on segments
  crossings_split  vertices added where segments cross
  steiner          vertices added for better triangles: 0, for `delone mesh` is there for that
  threads          threads used; the result is the same for any number
  hash             names the set of triangles: 32 hexadecimal digits, the same on every machine
  seconds          wall time of the phases read, triangulate (from the array of points to triangles
                   and neighbours in the order of the input, but for constrain and carve), constrain
                   (inserting segments), carve (finding domain, holes, regions), write (files, pictures)
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// What to do after the first try.
const NEXT: &str = "\
Next: open lake.png, or let the result be verified from its files alone:
  delone sample lake -o drawing.poly
  delone check lake.ele --domain drawing.poly
Your own: delone triangulate map.poly -o mesh.ele --picture mesh.png (`delone doctor map.poly` first)";

/// Triangulate points and segments: from a file to mesh, picture and figures
///
/// Reads points (.node, .npy, CSV, XYZ and other text tables, VTU) or domains of points, segments,
/// holes and regions (.poly, GeoJSON, WKT), merges equal points and computes the constrained
/// Delaunay triangulation: exactly, and with ties broken by position alone, so that the result does
/// not depend on the order of anything. Segments may repeat, overlap and run through points.
///
/// Without INPUT a sample is triangulated: a lake with islands. Without -o only what --picture and
/// --json ask for is written.
#[derive(clap::Args, Clone)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}\n\n{}", batch::HELP, crate::exit::HELP))]
pub struct Triangulate {
    #[command(flatten)]
    job: Job,
}

impl Many for Triangulate {
    fn batching(&self) -> &Batching {
        &self.job.batching
    }

    fn inputs(&self) -> Vec<PathBuf> {
        self.job.inputs()
    }

    fn asks_json(&self) -> bool {
        self.job.json
    }

    fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure> {
        let job = self.job.for_one(input, naming, false)?;
        Ok(Self { job })
    }

    fn settle(&self) -> Result<Outputs, Failure> {
        self.job.outputs(Content::Mesh, None)
    }

    fn in_a_batch(&mut self, threads: usize) {
        self.job.in_a_batch(threads);
    }

    fn run_alone(&self, quiet: bool) -> Result<(), Failure> {
        let outputs = self.job.outputs(Content::Mesh, None)?;
        let progress = Progress::new(quiet);
        let threads = self.job.threads();

        let (input, read) = timed(|| self.job.read(&outputs, &progress))?;
        let (mut domain, numbering) = input;
        let building = &self.job.building;
        let (built, laps) = building.build(&mut domain, threads, &numbering, &progress)?;
        progress.note(&built.notes(&numbering));
        // Hashed before the files get their names, for after that nothing should take long.
        let figures = (self.job.json || !quiet).then(|| Figures::of(&built, threads));
        let (written, write) = timed(|| self.write(&outputs, &built, domain, &progress))?;
        progress.finish();

        if let Some(figures) = figures {
            let report = Report::new(figures, (), [read, write], &laps);
            if self.job.json {
                files::print(&report.json())?;
            } else {
                let next = self.job.demonstrates().then_some(NEXT);
                report.summarise(&[], next, &written);
            }
        }
        Ok(())
    }
}

impl Triangulate {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        batch::run(self, quiet)
    }

    /// Writes the mesh with what it has inherited from `domain`.
    fn write(
        &self,
        outputs: &Outputs,
        built: &Built,
        domain: DomainData,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let writing = &self.job.writing;
        match built {
            _ if outputs.is_empty() => Ok(Vec::new()),
            Built::Points(triangulation) => {
                let mesh = MeshView::from(triangulation).with_data(&domain.vertices);
                let made = Made::of("triangulate", OfMesh::Points(triangulation), &mesh);
                let papers = self.job.certify(outputs, &made, progress)?;
                writing.certified(outputs, &mesh, &papers.view(), progress)
            }
            Built::Domain(result) => {
                let inherited = Inherited::new(result, domain, progress);
                let inherited = inherited.map_err(files::unwritable)?;
                let mesh = MeshView::constrained(result, &inherited);
                let made = Made::of("triangulate", OfMesh::Domain(result), &mesh);
                let papers = self.job.certify(outputs, &made, progress)?;
                writing.certified(outputs, &mesh, &papers.view(), progress)
            }
        }
    }
}
