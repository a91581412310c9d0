//! `delone graph`: trees, tours and other graphs of whoever is near whom.

mod kind;

use crate::exit::Failure;
use crate::files::Content;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use crate::words::{counted, measure};
use delone::Delaunay;
use delone::predicates::length_up;
use delone::proximity::Proximity;
use delone_io::{Link, Links};
use kind::{Drawn, Kind};
use serde::Serialize;

const EXAMPLES: &str = "\
Examples:
  delone graph towns.csv --kind tour -o tour.geojson   a short round trip: its legs in order
  delone graph towns.csv --kind mst -o tree.csv        the shortest net: from,to,length
  delone graph towns.csv --kind alpha=2.5 --picture shape.png   where discs of radius 2.5 do not fit
  delone graph towns.csv --kind tour --json | jq .ratio   at most so many times the shortest";

const JSON: &str = "\
The JSON object of --json:
  kind             the graph
  points, distinct_points
                   what was read; of equal points the first counts
  edges, length    of the graph; the length is rounded
  lower_bound, ratio, moves
                   of a tour: no tour is shorter, up to rounding; length by bound; improvements tried
  radius, triangles, loose_points
                   of an alpha shape: its radius, rounded up if it was not given; its triangles; points
                   that no edge reaches
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, triangulate, graph, bound, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Find graphs in points: a short tour, the shortest tree, neighbourhoods, the shape of a cloud
///
/// Reads points and writes edges, `from,to,length`, with the numbers that the file gives to its points.
/// Membership is decided exactly, equal lengths are told apart by the numbers of the points; lengths that
/// are written are rounded up.
///
/// Outputs are .csv (.tsv …), .npy (float64, three columns), .geojson (lines), .svg and .png.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Graph {
    #[command(flatten)]
    task: Task,
    /// Which graph: mst (the minimum spanning tree), gabriel, rng (relative neighbours), nearest (each with
    /// the nearest other), tour (a short closed one), or alpha, alpha=R (the boundary of the alpha
    /// shape; by default of the smallest radius that makes it one piece)
    #[arg(long, value_name = "KIND", help_heading = None)]
    kind: Kind,
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures {
    kind: &'static str,
    points: usize,
    distinct_points: usize,
    edges: usize,
    length: f64,
    #[serde(flatten)]
    more: kind::Figures,
}

impl Graph {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let outputs = task.outputs(|_| Content::Links, Content::Picture, None)?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let (points, numbering) = phases.time("read", || task.points(&outputs, &progress))?;
        let refused = |error| numbering.failure(error);
        let builder = Delaunay::new().threads(task.threads()).watch(&progress);
        let triangulation = phases.time("triangulate", || {
            let points = points.points.iter().copied();
            builder.triangulate(points).map_err(refused)
        })?;
        let (proximity, mut drawn) = phases.time("graph", || {
            let draw = || {
                let proximity = Proximity::new(&triangulation, &progress)?;
                let drawn = self.kind.draw(&proximity)?;
                Ok((proximity, drawn))
            };
            task.on_threads(draw).map_err(refused)
        })?;
        if drawn.tour.is_some() {
            let mut bound = || task.on_threads(|| drawn.find_bound(&proximity));
            phases.time("bound", || bound().map_err(refused))?;
        }

        let Drawn { edges, more, .. } = drawn;
        let link = |[a, b]: [delone::VertexId; 2]| Link {
            from: a.index(),
            to: b.index(),
            length: length_up([a, b].map(|v| triangulation.point(v))),
        };
        let links: Vec<Link> = edges.into_iter().map(link).collect();
        let figures = Figures {
            kind: self.kind.name(),
            points: points.points.len(),
            distinct_points: triangulation.num_vertices(),
            edges: links.len(),
            length: links.iter().fold(0.0, |sum, link| sum + link.length),
            more,
        };
        let written = phases.write(|| {
            let links = Links {
                from: &points.points,
                to: None,
                links: &links,
                names: ["from", "to", "length"],
                bases: [numbering.base(); 2],
            };
            task.writing.links(&outputs, &links, &progress)
        })?;
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }
}

impl Figures {
    fn lines(&self) -> Vec<String> {
        let points = counted(self.points, "point", "points");
        let edges = counted(self.edges, "edge", "edges");
        let length = measure(self.length);
        let mut lines = vec![format!(
            "{points}, {}: {edges} of length {length}",
            self.kind
        )];
        lines.extend(self.more.line());
        lines
    }
}
