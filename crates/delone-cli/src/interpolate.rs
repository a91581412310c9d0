//! `delone interpolate`: values between points that have some, at other points or on a grid.

mod method;

use crate::exit::Failure;
use crate::files::{Content, Outputs};
use crate::numbers;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::survey::{Survey, Surveying};
use crate::task::Task;
use crate::words::{count, counted, measure};
use delone::surface::{Evaluation, Grid, Interpolant, Raster};
use delone_io::{Attribute, PointSet, Relief};
use method::Method;
use serde::Serialize;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone interpolate survey.xyz --cell 2.5 -o height.asc   a raster of square cells, for GIS
  delone interpolate survey.csv --value depth --grid 400x300 -o depth.npy --picture depth.png
  delone interpolate survey.xyz sites.csv -o heights.csv   the sites, with one more column
  delone interpolate survey.xyz --cell 5 --method natural -o smooth.asc
  delone interpolate lake.poly --cell 0.1 -o depth.asc     only within the domain";

const JSON: &str = "\
The JSON object of --json:
  vertices, triangles  of the triangulation under the surface
  value, method    the column of the values; how it was interpolated
  evaluated        points or cells
  outside          those of them without a value
  range            least and largest value found; null if there is none
  columns, rows, cell
                   of a raster; a cell is as wide and as high as this
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, triangulate, gradients, queries, evaluate, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Interpolate between points with values: at other points, or on a grid
///
/// The surface lies over the (constrained) Delaunay triangulation of the points and goes through their
/// values. Outside of it, and where a domain has been carved away, there is no value: an empty cell of a
/// table, NODATA_value of an .asc, NaN of an .npy.
///
/// At QUERIES, outputs are what holds points: .csv (.xyz …), .npy, .node, .vtu, with one more column. On a grid,
/// which covers the points, with cells whose values are those at their centres, they are .asc (ESRI's ASCII
/// grid), .npy (float64, rows from the top), .png and .svg. --picture shows the surface in colours, shaded.
#[derive(clap::Args)]
#[command(group = clap::ArgGroup::new("places").required(true).args(["queries", "cell", "grid"]))]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Interpolate {
    #[command(flatten)]
    task: Task,
    /// File of the points where values are wanted
    #[arg(value_name = "QUERIES", help_heading = None)]
    queries: Option<PathBuf>,
    /// Side of the cells of a grid, in units of the coordinates
    #[arg(long, value_name = "SIDE", help_heading = None, value_parser = numbers::positive,
          allow_negative_numbers = true)]
    cell: Option<f64>,
    /// Columns and rows of a grid, as in 400x300
    #[arg(long, value_name = "CxR", help_heading = None, value_parser = columns_and_rows)]
    grid: Option<[usize; 2]>,
    /// What the surface is like between the points
    #[arg(long, value_enum, value_name = "METHOD", default_value_t, help_heading = None)]
    method: Method,
    #[command(flatten)]
    surveying: Surveying,
}

fn columns_and_rows(text: &str) -> Result<[usize; 2], String> {
    let number = |word: &str| word.parse().ok().filter(|&n: &usize| n > 0);
    let sides = text.split_once('x');
    let sides = sides.and_then(|(columns, rows)| Some([number(columns)?, number(rows)?]));
    sides.ok_or_else(|| "columns and rows are needed, as in 400x300".to_owned())
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures<'a> {
    vertices: usize,
    triangles: usize,
    value: &'a str,
    method: &'static str,
    evaluated: usize,
    outside: usize,
    range: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    columns: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rows: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell: Option<[f64; 2]>,
}

/// What was evaluated.
enum Evaluated {
    Points(PointSet),
    Raster(Raster),
}

impl Interpolate {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let outputs = self.outputs()?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let surveying = &self.surveying;
        let survey = surveying.survey(task, &outputs, &mut phases, &progress)?;
        let refused = |error| survey.refused(error);

        let samples = survey.samples()?;
        let gradients = phases.time("gradients", || {
            let gradients = self.method.gradients(&samples, &progress);
            gradients.map_err(refused)
        })?;
        let surface = self.method.surface(&samples, &gradients);
        let surface = surface.map_err(refused)?;
        let evaluated = match &self.queries {
            Some(path) => {
                let read = || task.more_points(path, &outputs, &progress);
                let (points, _) = phases.time("queries", read)?;
                let evaluate = || self.at_points(&*surface, points, &survey, &progress);
                Evaluated::Points(phases.time("evaluate", evaluate)?)
            }
            None => {
                let grid = self.grid(&survey)?;
                let evaluate = || self.on_grid(&*surface, grid, &survey, &progress);
                Evaluated::Raster(phases.time("evaluate", evaluate)?)
            }
        };
        let figures = self.figures(&survey, &evaluated);
        let written =
            phases.write(|| self.write(&outputs, &evaluated, &*surface, &survey, &progress))?;
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        let content = match &self.queries {
            Some(queries) => {
                self.task.require_apart(queries)?;
                Content::Points
            }
            None => Content::Raster,
        };
        let outputs = self.task.outputs(|_| content, Content::Relief, None)?;
        if self.queries.is_none() {
            let files = self.task.output.iter();
            files.map(PathBuf::as_path).try_for_each(require_raster)?;
        }
        Ok(outputs)
    }

    /// Returns the grid that was asked for.
    fn grid(&self, survey: &Survey) -> Result<Grid, Failure> {
        let [low, high] = survey.corners();
        let grid = match (self.cell, self.grid) {
            (Some(cell), _) => Grid::with_cells(low, high, cell),
            (None, Some([columns, rows])) => Grid::with_size(low, high, columns, rows),
            (None, None) => return survey.grid_to_show(),
        };
        grid.map_err(|error| survey.refused(error))
    }

    /// Gives the points one more column.
    fn at_points(
        &self,
        surface: &dyn Interpolant,
        mut points: PointSet,
        survey: &Survey,
        progress: &Progress,
    ) -> Result<PointSet, Failure> {
        let values = self.evaluation(progress).values(surface, &points.points);
        let values = values.map_err(|error| survey.refused(error))?;
        let mut name = survey.name.clone();
        while points.attributes.iter().any(|a| a.name == name) {
            name.push_str("_interpolated");
        }
        let values = values.into_iter().map(|value| value.unwrap_or(f64::NAN));
        points.attributes.push(Attribute {
            name,
            values: values.collect(),
        });
        Ok(points)
    }

    fn on_grid(
        &self,
        surface: &dyn Interpolant,
        grid: Grid,
        survey: &Survey,
        progress: &Progress,
    ) -> Result<Raster, Failure> {
        let raster = self.evaluation(progress).raster(surface, grid);
        raster.map_err(|error| survey.refused(error))
    }

    fn evaluation<'p>(&self, progress: &'p Progress) -> Evaluation<'p> {
        Evaluation::new()
            .threads(self.task.threads())
            .watch(progress)
    }

    fn write(
        &self,
        outputs: &Outputs,
        evaluated: &Evaluated,
        surface: &dyn Interpolant,
        survey: &Survey,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let writing = &self.task.writing;
        let wants_picture = outputs.has_aside(Content::Relief);
        match evaluated {
            Evaluated::Points(points) => {
                let mut written = writing.points(outputs, points, progress)?;
                if wants_picture {
                    let raster = self.on_grid(surface, survey.grid_to_show()?, survey, progress)?;
                    written.extend(writing.reliefs(outputs, bare(&raster), progress)?);
                }
                Ok(written)
            }
            Evaluated::Raster(raster) => {
                let mut written = writing.relief(outputs, bare(raster), progress)?;
                written.extend(writing.reliefs(outputs, bare(raster), progress)?);
                Ok(written)
            }
        }
    }

    fn figures<'s>(&self, survey: &'s Survey, evaluated: &Evaluated) -> Figures<'s> {
        let (values, grid) = match evaluated {
            Evaluated::Points(points) => {
                let last = points.attributes.last();
                let values = last.map(|a| a.values.clone());
                (values.unwrap_or_default(), None)
            }
            Evaluated::Raster(raster) => {
                let values = raster.rows().flatten().copied();
                (values.collect(), Some(raster.grid()))
            }
        };
        let known = values.iter().copied().filter(|v| !v.is_nan());
        let range = known.map(|v| [v, v]);
        Figures {
            vertices: survey.triangulation().num_vertices(),
            triangles: survey.triangulation().num_triangles(),
            value: &survey.name,
            method: self.method.name(),
            evaluated: values.len(),
            outside: values.iter().filter(|v| v.is_nan()).count(),
            range: range.reduce(|[low, high], [v, _]| [low.min(v), high.max(v)]),
            columns: grid.map(Grid::columns),
            rows: grid.map(Grid::rows),
            cell: grid.map(Grid::cell),
        }
    }
}

/// Requires that a table is an ASCII grid.
fn require_raster(output: &Path) -> Result<(), Failure> {
    let extension = output.extension().unwrap_or_default();
    let is_other_table = delone_io::Format::from_path(output) == Some(delone_io::Format::Table)
        && !extension.eq_ignore_ascii_case("asc");
    if !is_other_table {
        return Ok(());
    }
    let output = output.display();
    Err(Failure::Usage(format!(
        "{output}: of tables, only .asc holds a raster; or name .npy, .png, .svg"
    )))
}

fn bare(raster: &Raster) -> Relief<'_> {
    Relief {
        raster: Some(raster),
        contours: &[],
    }
}

impl Figures<'_> {
    fn lines(&self) -> Vec<String> {
        let triangles = counted(self.triangles, "triangle", "triangles");
        let places = match [self.columns, self.rows] {
            [Some(columns), Some(rows)] => format!("{columns} by {rows} cells"),
            _ => counted(self.evaluated, "point", "points"),
        };
        let mut line = format!("{triangles}, {} at {places}", self.value);
        if let Some([low, high]) = self.range.map(|range| range.map(measure)) {
            line.push_str(&format!(": from {low} to {high}"));
        }
        if self.outside > 0 {
            line.push_str(&format!("; {} outside", count(self.outside)));
        }
        vec![line]
    }
}
