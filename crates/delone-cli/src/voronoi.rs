//! `delone voronoi`: what is nearest to each point, as cells.

mod clip;

use crate::column;
use crate::exit::Failure;
use crate::files::{Content, Outputs};
use crate::numbering::Numbering;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use crate::words::{counted, measure};
use clip::Clipping;
use delone::regular::WeightedDelaunay;
use delone::voronoi::{Clipped, Domain, Lloyd, Relaxed, Voronoi as Diagram};
use delone::{Delaunay, Triangulation};
use delone_io::{CellsView, Column, MeshView, PointSet};
use serde::Serialize;
use std::path::{Path, PathBuf};

const EXAMPLES: &str = "\
Examples:
  delone voronoi towns.csv --clip land.geojson -o cells.geojson --picture cells.png
  delone voronoi points.npy --clip 0,0,1,1 -o cells.vtu   clipped to a box
  delone voronoi points.csv --lloyd 50 --sites even.csv --picture even.png   spread evenly
  delone voronoi discs.csv --weights 1 -o power.geojson   power cells; weights are squared radii
  delone voronoi points.node -o points.v.node     Triangle's files, .v.node and .v.edge: not clipped
  delone voronoi towns.csv --json | jq .area";

const JSON: &str = "\
The JSON object of --json:
  sites, duplicates, hidden
                   what was read; those equal to one before them; those of no cell for want of weight
  cells, unbounded cells; those of them that have no end, before clipping
  vertices, edges  of the diagram, before clipping
  clip_area        area that cells are clipped to
  area             sum of the areas of the cells: the same, but for rounding
  empty            sites whose cells lie outside
  smallest, largest  area of a cell that does not; null if there is none
  lloyd            of --lloyd: steps taken, energy before and after, largest movement in the last step
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, relax, triangulate, voronoi, clip, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Cut the plane into Voronoi cells: what is nearest to each point
///
/// The structure of the diagram is exact, corners are rounded. Cells are clipped, to the box around the
/// points, a tenth larger on each side, if nothing else is said; in a polygon that is not convex a cell may
/// have several parts.
///
/// Outputs are .geojson (a feature each, with site, area and the columns of the input), .vtu, .svg and .png;
/// and Triangle's .v.node with .v.edge.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Voronoi {
    #[command(flatten)]
    task: Task,
    #[command(flatten)]
    clipping: Clipping,
    /// Move each site to the centroid of its clipped cell, so many times
    #[arg(long, value_name = "STEPS", help_heading = None)]
    lloyd: Option<u32>,
    /// Where to write the sites that --lloyd has moved: .csv, .node, .npy …
    #[arg(long, value_name = "FILE", requires = "lloyd", help_heading = None)]
    sites: Option<PathBuf>,
    /// Column of weights, in squared units of the coordinates: power cells instead of Voronoi cells. Its
    /// name, or its number among those that are not coordinates
    #[arg(long, value_name = "COLUMN", conflicts_with = "lloyd", help_heading = None)]
    weights: Option<Column>,
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures {
    sites: usize,
    duplicates: usize,
    hidden: usize,
    cells: usize,
    unbounded: usize,
    vertices: usize,
    edges: usize,
    clip_area: f64,
    area: f64,
    empty: usize,
    smallest: Option<f64>,
    largest: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    lloyd: Option<LloydFigures>,
}

#[derive(Serialize)]
struct LloydFigures {
    steps: usize,
    energy_before: Option<f64>,
    energy_after: Option<f64>,
    movement: f64,
}

/// Cells, and what they were made of.
struct Made {
    diagram: Diagram,
    /// Of sites without weights.
    triangulation: Option<Triangulation>,
    duplicates: usize,
    hidden: usize,
}

impl Voronoi {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let outputs = self.outputs()?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let ((mut points, numbering), domain) = phases.time("read", || {
            let points = task.points(&outputs, &progress)?;
            let domain = self.clipping.domain(task, &points.0, &outputs, &progress)?;
            Ok((points, domain))
        })?;
        let relaxed = self.relax(&mut points, &domain, &numbering, &mut phases, &progress)?;
        let made = self.make(&points, &numbering, &mut phases, &progress)?;
        let clipped = phases.time("clip", || {
            let clip = || made.diagram.clip(&domain, &progress);
            task.on_threads(clip)
                .map_err(|error| numbering.failure(error))
        })?;

        let figures = Figures::of(&made, &clipped, &domain, relaxed.as_ref());
        let written = phases.write(|| self.write(&outputs, &made, &clipped, &points, &progress))?;
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }

    fn outputs(&self) -> Result<Outputs, Failure> {
        if let Some(file) = self.clipping.file() {
            self.task.require_apart(file)?;
        }
        let sites = self.sites.clone().map(|path| (path, Content::Sites));
        let content = |path: &Path| match is_diagram(path) {
            true => Content::Diagram,
            false => Content::Cells,
        };
        if self.weights.is_some() && self.task.output.iter().any(|o| is_diagram(o)) {
            let clash = "--weights makes power cells, which .v.node does not hold; write .geojson";
            return Err(Failure::Usage(clash.to_owned()));
        }
        self.task.outputs(content, Content::Picture, sites)
    }

    /// Moves the points, if that was asked for.
    fn relax(
        &self,
        points: &mut PointSet,
        domain: &Domain,
        numbering: &Numbering,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<Option<Relaxed>, Failure> {
        let Some(steps) = self.lloyd else {
            return Ok(None);
        };
        let mut relaxed = phases.time("relax", || {
            let lloyd = Lloyd::new(steps as usize).watch(progress);
            let relax = || lloyd.relax(points.points.iter().copied(), domain);
            self.task
                .on_threads(relax)
                .map_err(|error| numbering.failure(error))
        })?;
        points.points = std::mem::take(&mut relaxed.points);
        Ok(Some(relaxed))
    }

    /// Makes the diagram.
    fn make(
        &self,
        points: &PointSet,
        numbering: &Numbering,
        phases: &mut Phases,
        progress: &Progress,
    ) -> Result<Made, Failure> {
        let refused = |error| numbering.failure(error);
        let sites = points.points.iter().copied();
        if self.weights.is_some() {
            let weights = column::take(points, self.weights.as_ref(), "--weights", numbering)?;
            let regular = phases.time("triangulate", || {
                let builder = WeightedDelaunay::new().watch(progress);
                let regular = builder.triangulate(sites.zip(weights.values));
                regular.map_err(refused)
            })?;
            let weighted = || Diagram::weighted(&regular, progress);
            let weighted = || self.task.on_threads(weighted).map_err(refused);
            return Ok(Made {
                diagram: phases.time("voronoi", weighted)?,
                triangulation: None,
                duplicates: 0,
                hidden: regular.hidden().len(),
            });
        }
        let triangulation = phases.time("triangulate", || {
            let builder = Delaunay::new().threads(self.task.threads()).watch(progress);
            builder.triangulate(sites).map_err(refused)
        })?;
        let dual = || Diagram::new(&triangulation, progress);
        let dual = || self.task.on_threads(dual).map_err(refused);
        Ok(Made {
            diagram: phases.time("voronoi", dual)?,
            duplicates: triangulation.duplicates().len(),
            triangulation: Some(triangulation),
            hidden: 0,
        })
    }

    fn write(
        &self,
        outputs: &Outputs,
        made: &Made,
        clipped: &Clipped<'_>,
        points: &PointSet,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let writing = &self.task.writing;
        let cells = CellsView::new(clipped).with_data(points);
        let mut written = writing.cells(outputs, &cells, progress)?;
        if let Some(triangulation) = &made.triangulation {
            let mesh = MeshView::from(triangulation).with_data(points);
            written.extend(writing.diagrams(outputs, &mesh, progress)?);
        }
        written.extend(writing.sites(outputs, points, progress)?);
        Ok(written)
    }
}

/// Tells whether a name is that of one of Triangle's files of a diagram.
fn is_diagram(path: &Path) -> bool {
    let name = path.to_string_lossy().to_ascii_lowercase();
    [".v.node", ".v.edge"].iter().any(|end| name.ends_with(end))
}

impl Figures {
    fn of(made: &Made, clipped: &Clipped<'_>, domain: &Domain, relaxed: Option<&Relaxed>) -> Self {
        let diagram = &made.diagram;
        let areas: Vec<f64> = diagram
            .cells()
            .filter(|cell| clipped.parts(cell.site()).len() > 0)
            .map(|cell| clipped.measure(cell.site()).area)
            .collect();
        let cells = diagram.cells().count();
        Self {
            sites: diagram.sites().len(),
            duplicates: made.duplicates,
            hidden: made.hidden,
            cells,
            unbounded: diagram.cells().filter(|cell| !cell.is_bounded()).count(),
            vertices: diagram.vertices().len(),
            edges: diagram.edges().len(),
            clip_area: domain.measure().area,
            area: areas.iter().fold(0.0, |sum, area| sum + area),
            empty: cells - areas.len(),
            smallest: areas.iter().copied().reduce(f64::min),
            largest: areas.iter().copied().reduce(f64::max),
            lloyd: relaxed.map(|relaxed| LloydFigures {
                steps: relaxed.energies.len().saturating_sub(1),
                energy_before: relaxed.energies.first().copied(),
                energy_after: relaxed.energies.last().copied(),
                movement: relaxed.movement,
            }),
        }
    }

    fn lines(&self) -> Vec<String> {
        let cells = counted(self.cells, "cell", "cells");
        let mut line = format!("{cells}, {} of them without end", self.unbounded);
        let mut add = |n: usize, what: &str| {
            if n > 0 {
                line.push_str(&format!("; {n} {what}"));
            }
        };
        add(self.duplicates, "duplicates merged");
        add(self.hidden, "hidden for want of weight");
        add(self.empty, "outside of what they are clipped to");
        let mut lines = vec![line];
        let area = measure(self.area);
        lines.push(
            match [self.smallest, self.largest].map(|a| a.map(measure)) {
                [Some(least), Some(most)] => {
                    format!("area {area}, of a cell from {least} to {most}")
                }
                _ => format!("area {area}"),
            },
        );
        if let Some(lloyd) = &self.lloyd {
            let [before, after] = [lloyd.energy_before, lloyd.energy_after];
            let [before, after] = [before, after].map(|e| measure(e.unwrap_or_default()));
            let steps = counted(lloyd.steps, "step", "steps");
            lines.push(format!("energy from {before} to {after} in {steps}"));
        }
        lines
    }
}
