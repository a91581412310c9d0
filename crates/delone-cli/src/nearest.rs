//! `delone nearest`: which points are nearest to others.

use crate::exit::Failure;
use crate::files::Content;
use crate::numbers;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use crate::words::{counted, measure};
use delone::nearest::Nearest as Index;
use delone::predicates::{CircleSide, in_disc, length_up};
use delone::{Delaunay, Point, VertexId};
use delone_io::{Link, Links};
use serde::Serialize;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  delone nearest towns.csv sites.csv -o nearest.csv   one row a site: its number, the town's, distance
  delone nearest towns.csv sites.csv -k 3 -o three.geojson   lines to the three nearest
  delone nearest wells.node farms.csv --radius 500 -o wells.csv   all within 500 units
  delone nearest towns.csv sites.csv --picture map.png   points, queries in rings, and lines
  delone nearest towns.csv sites.csv --json | jq .longest";

const JSON: &str = "\
The JSON object of --json:
  points, distinct_points, queries
                   what was read; of equal points the first counts
  links            pairs of a query and a point near it: the rows that are written
  unanswered       queries without a point near them
  longest, mean    of the distances; null without links
  threads          threads used; the result is the same for any number
  seconds          wall time of the phases read, index, query, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Find the points nearest to others: the nearest, the k nearest, all within a radius
///
/// For each of QUERIES the nearest of POINTS is found, exactly: distances are compared as they are, not as
/// they round, and of equally near points the one of lowest number is taken. Distances that are written are
/// rounded up. Rows are `query,vertex,distance`, with the numbers that the files give to their points.
///
/// Outputs are .csv (.tsv …), .npy (float64, three columns), .geojson (lines), .svg and .png.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Nearest {
    #[command(flatten)]
    task: Task,
    /// File of the points that are asked about
    #[arg(value_name = "QUERIES", help_heading = None)]
    queries: PathBuf,
    /// How many points for each query, nearest first [default: 1, with --radius all]
    #[arg(short, value_name = "N", help_heading = None, value_parser = clap::value_parser!(u32).range(1..))]
    k: Option<u32>,
    /// Only points at most this far away; without -k by number, not by distance
    #[arg(long, value_name = "R", help_heading = None, value_parser = numbers::radius,
          allow_negative_numbers = true)]
    radius: Option<f64>,
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures {
    points: usize,
    distinct_points: usize,
    queries: usize,
    links: usize,
    unanswered: usize,
    longest: Option<f64>,
    mean: Option<f64>,
}

impl Nearest {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        task.require_apart(&self.queries)?;
        let outputs = task.outputs(|_| Content::Links, Content::Picture, None)?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let ((points, numbering), (queries, asked)) = phases.time("read", || {
            let points = task.points(&outputs, &progress)?;
            let queries = task.more_points(&self.queries, &outputs, &progress)?;
            Ok((points, queries))
        })?;
        let refused = |error| numbering.failure(error);
        let index = phases.time("index", || {
            let builder = Delaunay::new().threads(task.threads()).watch(&progress);
            let t = builder.triangulate(points.points.iter().copied());
            let t = t.map_err(refused)?;
            let index = Index::new(&t, &progress).map_err(refused)?;
            Ok((index.threads(task.threads()), t.num_vertices()))
        })?;
        let (index, distinct_points) = index;
        let answers = phases.time("query", || {
            let answers = self.ask(&index, &points.points, &queries.points, &progress);
            answers.map_err(|error| asked.failure(error))
        })?;

        let links = links(&answers, &queries.points, &points.points);
        let figures = Figures {
            points: points.points.len(),
            distinct_points,
            queries: queries.points.len(),
            links: links.len(),
            unanswered: answers.iter().filter(|near| near.is_empty()).count(),
            longest: links.iter().map(|link| link.length).reduce(f64::max),
            mean: mean(&links),
        };
        let written = phases.write(|| {
            let links = Links {
                from: &queries.points,
                to: Some(&points.points),
                links: &links,
                names: ["query", "vertex", "distance"],
                bases: [asked.base(), numbering.base()],
            };
            task.writing.links(&outputs, &links, &progress)
        })?;
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }

    /// Lists the points near each query.
    fn ask(
        &self,
        index: &Index,
        points: &[Point],
        queries: &[Point],
        progress: &Progress,
    ) -> Result<Vec<Vec<VertexId>>, delone::Error> {
        let k = self.k.map(|k| k as usize);
        match (k, self.radius) {
            (None | Some(1), None) => {
                let nearest = index.nearest_all(queries, progress)?;
                Ok(nearest.into_iter().map(Vec::from_iter).collect())
            }
            (Some(k), None) => index.k_nearest_all(queries, k, progress),
            (None, Some(radius)) => index.within_all(queries, radius, progress),
            (Some(k), Some(radius)) => {
                let mut answers = index.k_nearest_all(queries, k, progress)?;
                for (near, &query) in answers.iter_mut().zip(queries) {
                    let is_within = |v: &VertexId| {
                        in_disc(query, radius, points[v.index()]) != CircleSide::Outside
                    };
                    near.retain(is_within);
                }
                Ok(answers)
            }
        }
    }
}

/// Measures how far it is from each query to the points near it.
fn links(answers: &[Vec<VertexId>], queries: &[Point], points: &[Point]) -> Vec<Link> {
    let of_query = |(from, near): (usize, &Vec<VertexId>)| {
        let link = |v: &VertexId| Link {
            from,
            to: v.index(),
            length: length_up([queries[from], points[v.index()]]),
        };
        near.iter().map(link).collect::<Vec<_>>()
    };
    answers.iter().enumerate().flat_map(of_query).collect()
}

/// Returns the mean of the lengths, divided first, so that no sum overflows.
fn mean(links: &[Link]) -> Option<f64> {
    let count = links.len() as f64;
    let shares = links.iter().map(|link| link.length / count);
    shares.reduce(|sum, share| sum + share)
}

impl Figures {
    fn lines(&self) -> Vec<String> {
        let queries = counted(self.queries, "query", "queries");
        let points = counted(self.points, "point", "points");
        let links = counted(self.links, "link", "links");
        let mut lines = vec![format!("{queries} among {points}: {links}")];
        if let [Some(longest), Some(mean)] = [self.longest, self.mean] {
            let [longest, mean] = [longest, mean].map(measure);
            lines.push(format!("distance: mean {mean}, largest {longest}"));
        }
        if self.unanswered > 0 {
            let unanswered = counted(self.unanswered, "query has", "queries have");
            lines.push(format!("{unanswered} no point near"));
        }
        lines
    }
}
