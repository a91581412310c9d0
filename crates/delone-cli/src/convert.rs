//! `delone convert`: the same points, domain or mesh in another format.

use crate::exit::Failure;
use crate::files::{Content, Input, Outputs, Reading, Writing};
use crate::progress::Progress;
use crate::words::{self, counted, list};
use delone_io::{Format, MeshView};
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  delone convert points.csv points.npy             points
  delone convert map.geojson map.poly              points and segments
  delone convert mesh.ele mesh.vtu                 mesh.node and mesh.ele, for ParaView
  delone convert mesh.ele mesh.png --size 3000     a picture, 3000 pixels wide or high
  delone convert mesh.vtu mesh.ele --one-based     numbered from 1
  delone convert - points.node --from csv          from standard input";

/// Convert points, a domain or a mesh from one format to another
///
/// If the input holds triangles (.ele, .vtu, .npy with .points.npy beside it) and the output can,
/// they come along; so do the segments of a domain (.poly, GeoJSON, WKT). Otherwise points are
/// converted. Nothing is triangulated and nothing is checked.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{}", crate::exit::HELP))]
pub struct Convert {
    /// File to read, or `-` for standard input
    input: PathBuf,
    /// File to write, or `-` for standard output (with --to)
    output: PathBuf,
    /// Convert the points alone, even if there are triangles or segments
    #[arg(long)]
    points: bool,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
}

impl Convert {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        // A name that will not do is refused before anything is read.
        self.outputs(Content::Any)?;
        let input = self.reading.open(&self.input)?;
        let progress = Progress::new(quiet);
        let takes = |can: fn(Format) -> bool| {
            !self.points && self.writing.format(&self.output).is_none_or(can)
        };
        let (written, what) = if input.brings_triangles() && takes(Format::writes_mesh) {
            self.convert_mesh(&input, &progress)?
        } else if input.brings_segments() && takes(Format::writes_segments) {
            self.convert_domain(&input, &progress)?
        } else {
            self.convert_points(&input, &progress)?
        };
        progress.finish();
        if !quiet && !written.is_empty() {
            let names: Vec<String> = written.iter().map(|p| p.display().to_string()).collect();
            eprintln!("wrote {what} to {}", list(&names));
        }
        Ok(())
    }

    fn convert_mesh(
        &self,
        input: &Input,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, String), Failure> {
        let outputs = self.outputs(Content::Mesh)?;
        outputs.spare(&input.files())?;
        let mesh = input.mesh(progress)?;
        let written = self
            .writing
            .mesh(&outputs, &MeshView::from(&mesh), progress)?;
        let points = counted(mesh.vertices.points.len(), "point", "points");
        let triangles = counted(mesh.triangles.len(), "triangle", "triangles");
        Ok((written, format!("{points} and {triangles}")))
    }

    fn convert_domain(
        &self,
        input: &Input,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, String), Failure> {
        let outputs = self.outputs(Content::Domain)?;
        outputs.spare(&input.files())?;
        let (mut domain, unused) = input.domain(progress)?;
        progress.note(&unused);
        let written = self.writing.domain(&outputs, &domain, progress)?;
        Ok((written, words::domain(&domain.take_pslg())))
    }

    fn convert_points(
        &self,
        input: &Input,
        progress: &Progress,
    ) -> Result<(Vec<PathBuf>, String), Failure> {
        self.require_no_triangles()?;
        let outputs = self.outputs(Content::Points)?;
        outputs.spare(&input.files())?;
        let (points, unused) = input.points(progress)?;
        progress.note(&unused);
        let written = self.writing.points(&outputs, &points, progress)?;
        let what = counted(points.points.len(), "point", "points");
        Ok((written, what))
    }

    fn outputs(&self, content: Content) -> Result<Outputs, Failure> {
        self.writing.outputs([(self.output.clone(), content)])
    }

    fn require_no_triangles(&self) -> Result<(), Failure> {
        match self.writing.format(&self.output) {
            Some(format) if format.writes_mesh() && !format.writes_points() => {
                let [input, output] = [&self.input, &self.output].map(|p| p.display());
                Err(Failure::Usage(format!(
                    "{output}: {format} holds triangles, but {input} brings none; \
                     `delone triangulate {input} -o OUT.ele` makes them"
                )))
            }
            _ => Ok(()),
        }
    }
}
