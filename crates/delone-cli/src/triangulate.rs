//! `delone triangulate`: points and segments in, mesh, picture and figures out.

mod build;
mod report;

use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Reading, Writing};
use crate::numbering::Numbering;
use crate::progress::Progress;
use crate::sample::Scene;
use crate::timing::timed;
use build::{Building, Built};
use delone_io::{DomainData, Inherited, MeshView};
use report::{Figures, Report, Seconds};
use std::path::PathBuf;

/// What is triangulated if nothing is named.
const SAMPLE: Scene = Scene::Lake;

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
  steiner          vertices added for better triangles: 0, there is nothing to refine here
  threads          threads used; the result is the same for any number
  hash             names the set of triangles: 32 hexadecimal digits, the same on every machine
  seconds          wall time of the phases read, triangulate (from the array of points to triangles
                   and neighbours in the order of the input, but for constrain and carve), constrain
                   (inserting segments), carve (finding domain, holes, regions), write (files, pictures)
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Triangulate points and segments: from a file to mesh, picture and figures
///
/// Reads points (.node, .npy, CSV, XYZ and other text tables, VTU) or domains of points, segments,
/// holes and regions (.poly, GeoJSON, WKT), merges equal points and computes the constrained
/// Delaunay triangulation: exactly, and with ties broken by position alone, so that the result does
/// not depend on the order of anything. Segments may repeat, overlap and run through points.
///
/// Without INPUT a sample is triangulated: a lake with islands. Without -o only what --picture and
/// --json ask for is written.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Triangulate {
    /// File of points or of a domain, or `-` for standard input
    input: Option<PathBuf>,
    /// Mesh to write: .node/.ele (a family of files), .npy, .vtu, .geojson, .svg, .png, or `-`;
    /// repeatable
    #[arg(short, long, value_name = "OUT")]
    output: Vec<PathBuf>,
    /// Picture to write, .svg or .png, coloured by the quality of the triangles, with segments and regions
    #[arg(short, long, value_name = "PIC")]
    picture: Option<PathBuf>,
    /// Print one JSON object with counts, hash, seconds and memory
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    building: Building,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
}

impl Triangulate {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let outputs = self.outputs()?;
        let progress = Progress::new(quiet);

        let ((mut domain, numbering), read) = timed(|| self.read(&outputs, &progress))?;
        let (built, laps) = self.building.build(&mut domain, &numbering, &progress)?;
        progress.note(&built.notes(&numbering));
        // Hashed before the files get their names, for after that nothing should take long.
        let threads = self.building.threads();
        let figures = (self.json || !quiet).then(|| Figures::of(&built, threads));
        let (written, write) = timed(|| self.write(&outputs, &built, domain, &progress))?;
        progress.finish();

        if let Some(figures) = figures {
            let report = Report::new(figures, Seconds::new(read, laps, write));
            if self.json {
                files::print(&report.json())?;
            } else {
                report.summarise(self.demonstrates(), &written);
            }
        }
        Ok(())
    }

    fn read(
        &self,
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(DomainData, Numbering), Failure> {
        let Some(input) = self.open()? else {
            let domain = SAMPLE.draw();
            let numbering = Numbering::of(SAMPLE.name(), &domain);
            return Ok((domain, numbering));
        };
        outputs.spare(&input)?;
        let (domain, unused) = input.domain(progress)?;
        progress.note(&unused);
        let numbering = Numbering::of(&input.name(), &domain);
        Ok((domain, numbering))
    }

    /// Opens the input, if one is named.
    fn open(&self) -> Result<Option<Input>, Failure> {
        match &self.input {
            Some(path) => self.reading.open(path).map(Some),
            None if self.reading.is_given() => {
                let lacking = "--from and --columns are about INPUT, and none is named";
                Err(Failure::Usage(lacking.to_owned()))
            }
            None => Ok(None),
        }
    }

    /// Writes the mesh with what it has inherited from `domain`.
    fn write(
        &self,
        outputs: &Outputs,
        built: &Built,
        domain: DomainData,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        match built {
            _ if outputs.is_empty() => Ok(Vec::new()),
            Built::Points(triangulation) => {
                let mesh = MeshView::from(triangulation).with_data(&domain.vertices);
                self.writing.mesh(outputs, &mesh, progress)
            }
            Built::Domain(result) => {
                let inherited = Inherited::new(result, domain, progress);
                let inherited = inherited.map_err(files::unwritable)?;
                let mesh = MeshView::constrained(result, &inherited);
                self.writing.mesh(outputs, &mesh, progress)
            }
        }
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        let meshes = self.output.iter().map(|o| (o.clone(), Content::Mesh));
        let pictures = self.picture.iter().map(|p| (p.clone(), Content::Picture));
        let asked = self.writing.outputs(meshes.chain(pictures))?;
        if asked.use_stdout() && self.json {
            let clash = "--json and the output `-` both want standard output; name a file for one";
            return Err(Failure::Usage(clash.to_owned()));
        }
        if self.demonstrates() {
            return self.demonstration();
        }
        Ok(asked)
    }

    /// Tells whether nothing at all was asked for: somebody tries the program.
    fn demonstrates(&self) -> bool {
        let asks = self.json || self.picture.is_some() || !self.output.is_empty();
        self.input.is_none() && !asks
    }

    /// What is left in the current folder then.
    fn demonstration(&self) -> Result<Outputs, Failure> {
        let [mesh, picture] = ["ele", "png"].map(|e| format!("{}.{e}", SAMPLE.name()).into());
        self.writing
            .outputs([(mesh, Content::Mesh), (picture, Content::Picture)])
    }
}
