//! `delone triangulate`: points in, mesh, picture and figures out.

mod report;

use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Reading, Writing};
use crate::progress::Progress;
use crate::sample;
use crate::timing::timed;
use delone::Delaunay;
use delone_io::MeshView;
use report::{Figures, Report, Seconds};
use std::path::PathBuf;
use std::thread::available_parallelism;

const EXAMPLES: &str = "\
Examples:
  delone triangulate                              the embedded cities: mesh and picture appear here
  delone triangulate points.csv -o mesh.ele       writes mesh.node, mesh.ele, mesh.edge, mesh.neigh
  delone triangulate points.xyz --picture map.svg only the picture
  delone triangulate cities.csv --columns lon,lat -o cities.vtu --picture cities.png
  delone triangulate points.npy --json --threads 1 | jq .seconds.triangulate
  cat points.txt | delone triangulate - -o - --to ele > mesh.ele";

const JSON: &str = "\
The JSON object of --json:
  vertices, triangles, edges, hull_edges   counts; equal points make one vertex
  duplicates       points merged into an equal one
  steiner          vertices added by the program: 0, there is nothing to refine here
  threads          threads used; the result is the same for any number
  hash             names the set of triangles: 32 hexadecimal digits, the same on every machine
  seconds          wall time of the phases read, triangulate (from the array of points to triangles
                   and neighbours in the order of the input) and write (files and pictures)
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Triangulate points: from a file to mesh, picture and figures
///
/// Reads points (.node, .npy, CSV, XYZ and other text tables, VTU), merges equal ones and
/// computes their Delaunay triangulation: exactly, and with ties broken by position alone, so that
/// the result does not depend on the order of the points.
///
/// Without INPUT an embedded sample is triangulated: 1249 places of the world. Without -o only what
/// --picture and --json ask for is written.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Triangulate {
    /// File of points, or `-` for standard input
    input: Option<PathBuf>,
    /// Mesh to write: .node/.ele (a family of files), .npy, .vtu, .svg, .png, or `-`; repeatable
    #[arg(short, long, value_name = "OUT")]
    output: Vec<PathBuf>,
    /// Picture to write, .svg or .png, coloured by the quality of the triangles
    #[arg(short, long, value_name = "PIC")]
    picture: Option<PathBuf>,
    /// Print one JSON object with counts, hash, seconds and memory
    #[arg(long)]
    json: bool,
    /// Number of threads; by default as many as the machine runs at once
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
}

impl Triangulate {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let outputs = self.outputs()?;
        let threads = self.threads();
        let progress = Progress::new(quiet);

        let (input, open) = timed(|| self.open())?;
        outputs.spare(&input)?;
        let name = input.name();
        let ((mut set, unused), read) = timed(|| input.points(&progress))?;
        // What came from a stream lies in memory until here.
        drop(input);
        if self.input.is_some() {
            progress.note(&unused);
        }
        let points = std::mem::take(&mut set.points);
        let (result, triangulate) = timed(|| {
            let delaunay = Delaunay::new().threads(threads).watch(&progress);
            delaunay.triangulate(points).map_err(|e| failure(&name, e))
        })?;
        // Hashed before the files get their names, for after that nothing should take long.
        let figures = (self.json || !quiet).then(|| Figures::of(&result, threads));
        let (written, write) = timed(|| {
            let mesh = MeshView::from(&result).with_data(&set);
            self.writing.mesh(&outputs, &mesh, &progress)
        })?;
        progress.finish();

        if let Some(figures) = figures {
            let report = Report::new(figures, Seconds::new(open + read, triangulate, write));
            if self.json {
                files::print(&report.json())?;
            } else {
                report.summarise(self.demonstrates(), &written);
            }
        }
        Ok(())
    }

    fn open(&self) -> Result<Input, Failure> {
        match &self.input {
            Some(path) => self.reading.open(path),
            None if self.reading.is_given() => {
                let lacking = "--from and --columns are about INPUT, and none is named";
                Err(Failure::Usage(lacking.to_owned()))
            }
            None => Ok(sample::embedded()),
        }
    }

    fn threads(&self) -> usize {
        match self.threads {
            Some(n) => n.into(),
            None => available_parallelism().map_or(1, usize::from),
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
        let [mesh, picture] = ["ele", "png"].map(|e| format!("{}.{e}", sample::EMBEDDED).into());
        self.writing
            .outputs([(mesh, Content::Mesh), (picture, Content::Picture)])
    }
}

fn failure(name: &str, error: delone::Error) -> Failure {
    match error {
        delone::Error::Cancelled => Failure::Cancelled,
        delone::Error::NotFinite { .. } => Failure::BadInput(format!("{name}: {error}")),
        _ => Failure::NotReached(format!("{name}: {error}")),
    }
}
