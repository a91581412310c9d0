//! `delone convert`: the same points, domain or mesh in another format.

use crate::batch::{self, Batching, Many, Naming};
use crate::exit::Failure;
use crate::files::{self, Content, Input, Outputs, Reading, Writing};
use crate::memory::peak_rss_bytes;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::words::{self, counted};
use delone_io::{Format, MeshView};
use serde::Serialize;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone convert points.csv points.npy             points
  delone convert map.geojson map.poly              points and segments
  delone convert mesh.ele mesh.vtu                 mesh.node and mesh.ele, for ParaView
  delone convert mesh.ele mesh.png --size 3000     a picture, 3000 pixels wide or high
  delone convert mesh.vtu mesh.ele --one-based     numbered from 1
  delone convert - points.node --from csv          from standard input
  delone convert 'maps/*.geojson' --out-dir polys --to poly   each of them; also: {}.poly instead";

const JSON: &str = "\
The JSON object of --json:
  holds            what was converted: points, domain or mesh
  points, triangles, segments, polygons, holes, regions
                   counts of what was read; null where the kind has none
  seconds          wall time of the phases read, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Convert points, a domain or a mesh from one format to another
///
/// If the input holds triangles (.ele, .vtu, .msh, .npy with .points.npy beside it) and the output can,
/// they come along; so do the segments of a domain (.poly, GeoJSON, WKT, .msh of lines). Otherwise points are
/// converted. Nothing is triangulated and nothing is checked.
#[derive(clap::Args, Clone)]
#[command(
    override_usage = "delone convert [OPTIONS] INPUT OUTPUT\n       delone convert [OPTIONS] --out-dir DIR --to FORMAT INPUT…"
)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}\n\n{}", batch::HELP, crate::exit::HELP))]
pub struct Convert {
    /// File to read and file to write, or `-` for standard input and (with --to) output; with --out-dir files to read
    #[arg(required = true, value_name = "INPUT OUTPUT")]
    files: Vec<PathBuf>,
    /// Convert the points alone, even if there are triangles or segments
    #[arg(long)]
    points: bool,
    /// Print one JSON object with counts, seconds and memory
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
    #[command(flatten)]
    batching: Batching,
}

/// What has been converted; the fields are the keys of `--json`.
#[derive(Default, Serialize)]
struct Figures {
    holds: &'static str,
    points: usize,
    triangles: Option<usize>,
    segments: Option<usize>,
    polygons: Option<usize>,
    holes: Option<usize>,
    regions: Option<usize>,
    #[serde(skip)]
    in_words: String,
}

#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    figures: Figures,
    seconds: Phases,
    peak_rss_bytes: Option<u64>,
}

impl Many for Convert {
    fn batching(&self) -> &Batching {
        &self.batching
    }

    /// All but the output.
    fn inputs(&self) -> Vec<PathBuf> {
        let inputs = match self.output() {
            Some(_) => &self.files[..self.files.len() - 1],
            None => &self.files,
        };
        inputs.to_owned()
    }

    fn asks_json(&self) -> bool {
        self.json
    }

    fn for_one(&self, input: &Path, naming: &Naming<'_>) -> Result<Self, Failure> {
        let output = match self.output() {
            Some(output) => naming.name(output, input, "output")?,
            None => naming
                .usual(input, self.writing.to())?
                .ok_or_else(|| Failure::Usage("an output is needed, or --out-dir".to_owned()))?,
        };
        Ok(Self {
            files: vec![input.to_owned(), output],
            batching: Batching::default(),
            ..self.clone()
        })
    }

    fn settle(&self) -> Result<Outputs, Failure> {
        self.outputs(Content::Any)
    }

    fn in_a_batch(&mut self, _: usize) {
        self.json = true;
    }

    fn run_alone(&self, quiet: bool) -> Result<(), Failure> {
        // A name that will not do is refused before anything is read.
        let outputs = self.outputs(Content::Any)?;
        outputs.leave_stdout_to(self.json)?;
        let input = self.reading.open(self.input())?;
        let progress = Progress::new(quiet);
        let takes = |can: fn(Format) -> bool| {
            !self.points && self.writing.format(self.to()).is_none_or(can)
        };
        let mut phases = Phases::default();
        let (written, figures) =
            if takes(Format::writes_mesh) && input.brings_triangles(&progress)? {
                self.convert_mesh(&input, &mut phases, &progress)?
            } else if takes(Format::writes_segments) && input.brings_segments(&progress)? {
                self.convert_domain(&input, &mut phases, &progress)?
            } else {
                self.convert_points(&input, &mut phases, &progress)?
            };
        progress.finish();
        if self.json {
            return files::print_json(&Report {
                figures,
                seconds: phases,
                peak_rss_bytes: peak_rss_bytes(),
            });
        }
        if !quiet && !written.is_empty() {
            words::wrote_what(&figures.in_words, &written);
        }
        Ok(())
    }
}

impl Convert {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let is_lone = self.batching.out_dir.is_none() && self.files.len() < 2;
        if is_lone {
            let lacking = "an output is needed: delone convert INPUT OUTPUT, or --out-dir DIR --to FORMAT\n\n\
                           Usage: delone convert [OPTIONS] INPUT OUTPUT";
            return Err(Failure::Usage(lacking.to_owned()));
        }
        batch::run(self, quiet)
    }

    /// Returns the output, if one is named: with a folder for all of them only a name with `{}` is one.
    fn output(&self) -> Option<&Path> {
        let last = self.files.last()?;
        let is_pattern = last.to_string_lossy().contains("{}");
        (is_pattern || self.batching.out_dir.is_none()).then_some(last)
    }

    /// Returns the input of a command that has one.
    fn input(&self) -> &Path {
        &self.files[0]
    }

    /// Returns the output of a command that has one.
    fn to(&self) -> &Path {
        &self.files[1]
    }

    fn convert_mesh(
        &self,
        input: &Input,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, Figures), Failure> {
        let outputs = self.outputs(Content::Mesh)?;
        outputs.spare(&input.files())?;
        let mesh = phases.time("read", || input.mesh(progress))?;
        progress.note(&input.named(files::notes(&mesh.vertices)));
        let view = MeshView::from(&mesh);
        let written = phases.write(|| self.writing.mesh(&outputs, &view, progress))?;
        let points = counted(mesh.vertices.points.len(), "point", "points");
        let triangles = counted(mesh.triangles.len(), "triangle", "triangles");
        let figures = Figures {
            holds: "mesh",
            points: mesh.vertices.points.len(),
            triangles: Some(mesh.triangles.len()),
            in_words: format!("{points} and {triangles}"),
            ..Figures::default()
        };
        Ok((written, figures))
    }

    fn convert_domain(
        &self,
        input: &Input,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, Figures), Failure> {
        let outputs = self.outputs(Content::Domain)?;
        outputs.spare(&input.files())?;
        let (mut domain, unused) = phases.time("read", || input.domain(progress))?;
        progress.note(&unused);
        let written = phases.write(|| self.writing.domain(&outputs, &domain, progress))?;
        let pslg = domain.take_pslg();
        let figures = Figures {
            holds: "domain",
            points: pslg.points.len(),
            triangles: None,
            segments: Some(pslg.segments.len()),
            polygons: Some(pslg.polygons.len()),
            holes: Some(pslg.holes.len()),
            regions: Some(pslg.regions.len()),
            in_words: words::domain(&pslg),
        };
        Ok((written, figures))
    }

    fn convert_points(
        &self,
        input: &Input,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, Figures), Failure> {
        self.require_no_triangles()?;
        let outputs = self.outputs(Content::Points)?;
        outputs.spare(&input.files())?;
        let (points, unused) = phases.time("read", || input.points(progress))?;
        progress.note(&unused);
        let written = phases.write(|| self.writing.points(&outputs, &points, progress))?;
        let figures = Figures {
            holds: "points",
            points: points.points.len(),
            in_words: counted(points.points.len(), "point", "points"),
            ..Figures::default()
        };
        Ok((written, figures))
    }

    fn outputs(&self, content: Content) -> Result<Outputs, Failure> {
        self.writing.outputs([(self.to().to_owned(), content)])
    }

    fn require_no_triangles(&self) -> Result<(), Failure> {
        match self.writing.format(self.to()) {
            Some(format) if format.writes_mesh() && !format.writes_points() => {
                let [input, output] = [self.input(), self.to()].map(Path::display);
                Err(Failure::Usage(format!(
                    "{output}: {format} holds triangles, but {input} brings none; \
                     `delone triangulate {input} -o OUT.ele` makes them"
                )))
            }
            _ => Ok(()),
        }
    }
}
