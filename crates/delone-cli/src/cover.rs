//! `delone cover`: triangles that each hold about as many data, for who fits something in each.

mod choices;
mod domain;
mod found;
mod histogram;

use crate::batch::{self, Batching, Many, Naming};
use crate::exit::Failure;
use crate::files::{Content, Outputs};
use crate::numbering::Numbering;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use choices::Choices;
use delone::Error;
use delone::scattered::DataTriangulation;
use delone_io::{Attribute, Counts, MeshView, PointSet};
use found::Found;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone cover survey.csv -d 6 -o cover.vtu --picture cover.png   6 to 17 data in each triangle
  delone cover survey.csv --degree 3 -o cover.ele --data-out held.csv   enough data for cubics
  delone cover survey.csv --domain lake.geojson -o cover.geojson   the triangles of a polygon
  delone cover survey.csv --no-edges --no-interior --picture a.svg   Algorithm A alone
  delone cover surveys/*.csv -d 6 --out-dir covers --to vtu   each of them, several at once
  delone sample gauss -n 150 | delone cover - --json | jq .data_per_triangle";

const JSON: &str = "\
The JSON object of --json:
  data, duplicates different data; those that equal one before them, and count no more
  vertices, triangles
                   of the triangulation
  least, most      how many data a triangle is to hold: d and 3d - 1
  data_per_triangle
                   min, max and mean
  histogram        pairs: so many data, so many triangles that hold as many
  data_covered     data that have been proven, exactly, to lie in the triangle that holds them: all
  too_full         triangles that hold more than 3d - 1
  special_cases    those of them that no vertex can open: triangle, corners with places, data, and the
                   cause: edge (without the data on it fewer than 2d are left), two-edges (that meet in
                   corner; fewer than d are left) or resolution (no number lies where the vertex must)
  min_angle_degrees, area
                   smallest angle of a triangle; area of all
  outline          corners of the outer polygon, with what was put on its edges, counter-clockwise
  hash             names the set of triangles: 32 hexadecimal digits, the same on every machine
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, cover, check, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Cover scattered data with triangles that hold between d and 3d - 1 of them each
///
/// Enough data in each triangle to fit a polynomial there, few enough to keep detail. Vertices are not data:
/// Algorithm A lays a polygon around the data and adds centers of clusters, as many as leave every triangle d
/// data; B puts vertices on edges; C puts vertices into triangles that still hold 3d or more. Every datum is
/// held by one triangle, equal data count once. A triangle that holds more than 3d - 1 data, because too many
/// of them lie on its edges, is named as a special case. The result is proven right before it is written.
///
/// Outputs are meshes: .vtu, .ele (.node …) and .geojson with `data`, how many each triangle holds, and
/// `special`, 1 for special cases, and .npy; .svg and .png show how many data each triangle holds.
/// --data-out writes the data with all columns of numbers that the input has, and the triangle of each.
/// Of several files each is covered for itself, several at once.
#[derive(clap::Args, Clone)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}\n\n{}", batch::HELP, crate::exit::HELP))]
pub struct Cover {
    #[command(flatten)]
    task: Task,
    /// More files of points, or patterns as in 'surveys/*.csv'
    #[arg(value_name = "POINTS", help_heading = None)]
    more: Vec<PathBuf>,
    #[command(flatten)]
    choices: Choices,
    /// Polygon to cover, one ring (GeoJSON, WKT, .poly), in place of one laid around the data; it need not be
    /// convex
    #[arg(long, value_name = "FILE", conflicts_with = "factor", help_heading = None)]
    domain: Option<PathBuf>,
    /// File to write the data to, with one more column: the number of the triangle that holds each
    #[arg(long, value_name = "FILE", help_heading = None)]
    data_out: Option<PathBuf>,
    #[command(flatten)]
    batching: Batching,
}

impl Many for Cover {
    fn batching(&self) -> &Batching {
        &self.batching
    }

    fn inputs(&self) -> Vec<PathBuf> {
        let first = self.task.input().to_owned();
        std::iter::once(first).chain(self.more.clone()).collect()
    }

    fn also_reads(&self) -> Vec<PathBuf> {
        self.domain.clone().into_iter().collect()
    }

    fn asks_json(&self) -> bool {
        self.task.json
    }

    fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure> {
        let data_out = self.data_out.as_deref();
        let data_out = data_out.map(|file| naming.name(file, input, "--data-out"));
        let data_out = data_out.transpose()?;
        Ok(Self {
            task: self.task.for_one(input, naming, data_out.is_some())?,
            more: Vec::new(),
            data_out,
            ..self.clone()
        })
    }

    fn settle(&self) -> Result<Outputs, Failure> {
        if self.domain.as_deref() == Some(Path::new("-")) {
            let once =
                "--domain: standard input can be read but once; name a file to cover for several";
            return Err(Failure::Usage(once.to_owned()));
        }
        self.outputs()
    }

    fn in_a_batch(&mut self, threads: usize) {
        self.task.in_a_batch(threads);
    }

    fn run_alone(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let outputs = self.outputs()?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let ((mut points, numbering), domain) = phases.time("read", || {
            let points = task.points(&outputs, &progress)?;
            let domain = self.domain.as_ref();
            let domain = domain.map(|file| domain::read(file, task, &outputs, &progress));
            Ok((points, domain.transpose()?))
        })?;
        let corners = domain.as_ref().map(|domain| domain.corners.clone());
        let cover = phases.time("cover", || {
            let builder = self.choices.builder(corners).watch(&progress);
            let data = points.points.iter().copied();
            let cover = task.on_threads(|| builder.cover(data));
            cover.map_err(|error| match (&error, &domain) {
                (Error::BadDomain { .. } | Error::DomainTooEmpty { .. }, Some(domain)) => {
                    domain.numbering.failure(error)
                }
                _ => refused(error, &numbering),
            })
        })?;

        let base = task.writing.base();
        let found = phases.time("check", || Found::of(&cover, base, &progress))?;
        let written =
            phases.write(|| self.write(&outputs, &cover, &found, &mut points, &progress))?;
        progress.finish();
        task.report(&found, &found.lines(), &phases, &written, quiet)
    }
}

impl Cover {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        batch::run(self, quiet)
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        if let Some(file) = &self.domain {
            self.task.require_apart(file)?;
        }
        let data = self.data_out.clone().map(|path| (path, Content::Sites));
        let mesh = |_: &Path| Content::Mesh;
        self.task.outputs(mesh, Content::Picture, data)
    }

    fn write(
        &self,
        outputs: &Outputs,
        cover: &DataTriangulation,
        found: &Found,
        points: &mut PointSet,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        if outputs.is_empty() {
            return Ok(Vec::new());
        }
        let writing = &self.task.writing;
        let held = cover.counts();
        let counts = Counts {
            held: &held,
            range: [cover.least(), cover.most()],
            data: cover.data(),
        };
        let attributes = attributes(cover, &held);
        let mut mesh = MeshView::new(cover.points(), cover.triangles()).with_counts(&counts);
        mesh.triangle_attributes = &attributes;
        let mut written = writing.mesh(outputs, &mesh, progress)?;
        points.attributes.push(holders(cover, found, points));
        written.extend(writing.sites(outputs, points, progress)?);
        Ok(written)
    }
}

/// What goes with the triangles: how many data each holds, and whether it is a special case.
fn attributes(cover: &DataTriangulation, held: &[usize]) -> [Attribute; 2] {
    let mut special = vec![0.0; held.len()];
    for exception in cover.exceptions() {
        special[exception.triangle.index()] = 1.0;
    }
    let attribute = |name: &str, values| Attribute {
        name: name.to_owned(),
        values,
    };
    let held = held.iter().map(|&held| held as f64);
    [
        attribute("data", held.collect()),
        attribute("special", special),
    ]
}

/// The column that says which triangle holds each datum; its name is not one that is there already.
fn holders(cover: &DataTriangulation, found: &Found, points: &PointSet) -> Attribute {
    let mut name = "triangle".to_owned();
    while points.attributes.iter().any(|a| a.name == name) {
        name.push_str("_cover");
    }
    let number = |t: &delone::TriangleId| (t.index() + found.base) as f64;
    let values = cover.holders().iter().map(number).collect();
    Attribute { name, values }
}

/// Says why data cannot be covered, and with which option they can, if one is known.
fn refused(error: Error, numbering: &Numbering) -> Failure {
    let hint = match error {
        Error::TooFewData { distinct, .. } if distinct > 2 => {
            format!(": -d {distinct} at most, or --degree of less")
        }
        _ => String::new(),
    };
    match numbering.failure(error) {
        Failure::BadInput(text) => Failure::BadInput(text + &hint),
        other => other,
    }
}
