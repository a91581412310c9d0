//! `delone contour`: lines along which a surface has one value.

use crate::exit::Failure;
use crate::files::Content;
use crate::numbers;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::survey::{Survey, Surveying};
use crate::task::Task;
use crate::words::{counted, measure};
use delone::surface::{
    Contour as Line, Evaluation, Linear, Samples, contours, levels_every, round_levels,
};
use delone_io::Relief;
use serde::Serialize;

/// How many levels there are, about, if nothing is said.
const USUAL_COUNT: usize = 10;

const EXAMPLES: &str = "\
Examples:
  delone contour survey.xyz --interval 10 -o lines.geojson   lines at …, -10, 0, 10, 20 …
  delone contour survey.csv --value depth --levels 0,-5,-20 -o depths.geojson
  delone contour survey.csv --count 8 -o lines.svg --picture map.png   about eight round levels
  delone contour lake.poly --picture lake.png     only within the domain, breaklines respected
  delone contour survey.xyz --json | jq .levels";

const JSON: &str = "\
The JSON object of --json:
  vertices, triangles  of the triangulation under the surface
  value            the column of the values
  range            least and largest value
  levels           the levels
  lines, rings     lines that were found; those of them that are closed
  points           their points
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, triangulate, contour, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Draw contour lines of the surface over points with values
///
/// The surface is linear in each triangle of the (constrained) Delaunay triangulation, and there is none
/// where a domain has been carved away. Lines have the higher side to their left; where they end on the
/// border they are open, elsewhere closed.
///
/// Outputs are .geojson (a line each, with the property `level`), .svg and .png; --picture shows the lines
/// upon the surface in colours, shaded.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Contour {
    #[command(flatten)]
    task: Task,
    /// The levels, set apart by commas
    #[arg(long, value_name = "L,L,…", help_heading = None, value_parser = levels,
          allow_hyphen_values = true, conflicts_with_all = ["interval", "count"])]
    levels: Option<Levels>,
    /// Levels at all multiples of this
    #[arg(long, value_name = "STEP", help_heading = None, value_parser = numbers::positive,
          allow_negative_numbers = true, conflicts_with = "count")]
    interval: Option<f64>,
    /// About so many levels, at round numbers [default: 10]
    #[arg(long, value_name = "N", help_heading = None)]
    count: Option<usize>,
    #[command(flatten)]
    surveying: Surveying,
}

/// Levels, ascending, each once.
#[derive(Clone)]
struct Levels(Vec<f64>);

fn levels(text: &str) -> Result<Levels, String> {
    let mut levels = numbers::several(text)?;
    levels.sort_unstable_by(f64::total_cmp);
    levels.dedup();
    Ok(Levels(levels))
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures<'a> {
    vertices: usize,
    triangles: usize,
    value: &'a str,
    range: [f64; 2],
    levels: &'a [f64],
    lines: usize,
    rings: usize,
    points: usize,
}

impl Contour {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let outputs = task.outputs(|_| Content::Contours, Content::Relief, None)?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let survey = self
            .surveying
            .survey(task, &outputs, &mut phases, &progress)?;
        let samples = survey.samples()?;
        let range = samples.range().unwrap_or_default();
        let levels = self.levels(range, &survey)?;
        let lines = phases.time("contour", || {
            contours(&samples, &levels, &progress).map_err(|error| survey.refused(error))
        })?;

        let figures = Figures {
            vertices: survey.triangulation().num_vertices(),
            triangles: survey.triangulation().num_triangles(),
            value: &survey.name,
            range,
            levels: &levels,
            lines: lines.len(),
            rings: lines.iter().filter(|line| line.is_closed).count(),
            points: lines.iter().map(|line| line.points.len()).sum(),
        };
        let written = phases.write(|| {
            let relief = Relief {
                raster: None,
                contours: &lines,
            };
            let mut written = task.writing.relief(&outputs, relief, &progress)?;
            if outputs.has_aside(Content::Relief) {
                let raster = self.raster(&survey, &samples, &progress)?;
                let relief = shown(&raster, &lines);
                written.extend(task.writing.reliefs(&outputs, relief, &progress)?);
            }
            Ok(written)
        })?;
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }

    /// Settles the levels.
    fn levels(&self, range: [f64; 2], survey: &Survey) -> Result<Vec<f64>, Failure> {
        if let Some(Levels(levels)) = &self.levels {
            return Ok(levels.clone());
        }
        let levels = match self.interval {
            Some(interval) => levels_every(interval, 0.0, range),
            None => round_levels(self.count.unwrap_or(USUAL_COUNT), range),
        };
        levels.map_err(|error| survey.refused(error))
    }

    /// Evaluates the surface to be shown under the lines.
    fn raster(
        &self,
        survey: &Survey,
        samples: &Samples<'_>,
        progress: &Progress,
    ) -> Result<delone::surface::Raster, Failure> {
        let evaluation = Evaluation::new()
            .threads(self.task.threads())
            .watch(progress);
        let raster = evaluation.raster(&Linear::new(samples), survey.grid_to_show()?);
        raster.map_err(|error| survey.refused(error))
    }
}

fn shown<'a>(raster: &'a delone::surface::Raster, contours: &'a [Line]) -> Relief<'a> {
    Relief {
        raster: Some(raster),
        contours,
    }
}

impl Figures<'_> {
    fn lines(&self) -> Vec<String> {
        let triangles = counted(self.triangles, "triangle", "triangles");
        let [low, high] = self.range.map(measure);
        let levels = counted(self.levels.len(), "level", "levels");
        let lines = counted(self.lines, "line", "lines");
        vec![
            format!("{triangles}, {} from {low} to {high}", self.value),
            format!("{lines} at {levels}, {} of them closed", self.rings),
        ]
    }
}
