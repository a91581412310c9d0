//! `delone cluster`: groups of points that lie together, and their centers.

use crate::column;
use crate::exit::Failure;
use crate::files::{Content, Outputs};
use crate::numbering::Numbering;
use crate::numbers;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::task::Task;
use crate::words::{count, counted, measure};
use delone::Point;
use delone::scattered::{Clustering, Clusters, Errors};
use delone_io::{Attribute, ClustersView, Column, PointSet};
use serde::Serialize;
use std::path::PathBuf;

const EXAMPLES: &str = "\
Examples:
  delone cluster towns.csv -n 12 -o groups.csv         the rows, with one more column: cluster
  delone cluster towns.csv -n 12 --weights people --centers centers.csv --picture groups.png
  delone cluster survey.xyz --max-error 25 -o c.csv    until points are 5 units from centers, in root mean square
  delone cluster stars.csv -n 40 --more z -o c.csv     in space
  delone cluster towns.csv -n 12 --json | jq .mean_error";

const JSON: &str = "\
The JSON object of --json:
  points, clusters what was read, and found
  dimension        number of coordinates
  weights          column of the weights, or null
  fewest, most     points of a cluster
  worst_error, mean_error
                   weighted mean of the squares of the distances from the centers: of the cluster where it
                   is largest; of all points. Null without points
  history          [worst_error, mean_error] with one cluster, with two, and so on
  threads          threads allowed; the result is the same for any number
  seconds          wall time of the phases read, cluster, write
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Find clusters: groups of points that lie together, and their centers
///
/// Beginning with all points in one, the cluster of largest error is cut in two, across the axis along which
/// its points deviate most; points go to the nearest center, centers to the mean of their points; and so on
/// (Schreiber 1991). The error is the weighted mean of the squares of the distances from the center.
/// It ends with the number of clusters that is asked for, or once no error is too large; with both, at
/// whatever comes first.
///
/// All coordinates count alike, so they should have the same unit. Clusters are numbered from 0. The column
/// `cluster` is added to those of the points; --centers writes the centers, with the points, weight and error
/// of each.
///
/// Outputs are what holds points: .csv (.xyz …), .npy, .node, .vtu; .svg and .png show the clusters in colours,
/// by x and y.
#[derive(clap::Args)]
#[command(group = clap::ArgGroup::new("end").required(true).multiple(true).args(["clusters", "max_error"]))]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Cluster {
    #[command(flatten)]
    task: Task,
    /// How many clusters; fewer if there are not as many different points
    #[arg(short = 'n', long, value_name = "N", help_heading = None,
          value_parser = clap::value_parser!(u32).range(1..))]
    clusters: Option<u32>,
    /// Largest error of a cluster, in squared units of the coordinates
    #[arg(long, value_name = "E", help_heading = None, value_parser = numbers::radius,
          allow_negative_numbers = true)]
    max_error: Option<f64>,
    /// Column of positive weights: its name, or its number among those that are not coordinates [default:
    /// each point weighs 1]
    #[arg(long, value_name = "COLUMN", help_heading = None)]
    weights: Option<Column>,
    /// Further columns that are coordinates, as in z,t: names, or numbers among those that are not x and y
    #[arg(long, value_name = "COLUMNS", value_delimiter = ',', help_heading = None)]
    more: Vec<Column>,
    /// Move points and centers up to so many times more after each cut: better clusters, slower
    #[arg(long, value_name = "ROUNDS", default_value_t = 0, help_heading = None)]
    relax: u16,
    /// File to write the centers to, in the format that its extension names
    #[arg(long, value_name = "FILE", help_heading = None)]
    centers: Option<PathBuf>,
}

/// What has been found; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Figures<'a> {
    points: usize,
    clusters: usize,
    dimension: usize,
    weights: Option<&'a str>,
    fewest: Option<usize>,
    most: Option<usize>,
    worst_error: Option<f64>,
    mean_error: Option<f64>,
    history: Vec<[f64; 2]>,
}

/// Points with their coordinates beyond x and y, and their weights.
struct Given {
    points: PointSet,
    more: Vec<Attribute>,
    weights: Option<Attribute>,
}

impl Cluster {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let task = &self.task;
        let centers = self.centers.clone().map(|file| (file, Content::Sites));
        let outputs = task.outputs(|_| Content::Points, Content::Picture, centers)?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let (mut given, numbering) = phases.time("read", || self.read(&outputs, &progress))?;
        let clusters = phases.time("cluster", || {
            let clusters = self.find(&given, &progress);
            clusters.map_err(|error| numbering.failure(error))
        })?;
        progress.note(&self.shortfall(&clusters, &numbering));
        let written = phases.write(|| self.write(&outputs, &mut given, &clusters, &progress))?;
        let figures = Figures::of(&given, &clusters);
        progress.finish();
        task.report(&figures, &figures.lines(), &phases, &written, quiet)
    }

    fn read(&self, outputs: &Outputs, progress: &Progress) -> Result<(Given, Numbering), Failure> {
        let (points, numbering) = self.task.points(outputs, progress)?;
        let take = |column, option| column::take(&points, Some(column), option, &numbering);
        let more = self.more.iter().map(|column| take(column, "--more"));
        let more = more.collect::<Result<Vec<_>, _>>()?;
        let weights = self.weights.as_ref();
        let weights = weights
            .map(|column| take(column, "--weights"))
            .transpose()?;
        let given = Given {
            points,
            more,
            weights,
        };
        Ok((given, numbering))
    }

    fn find(&self, given: &Given, progress: &Progress) -> Result<Clusters, delone::Error> {
        let mut clustering = Clustering::new().relax(self.relax.into()).watch(progress);
        if let Some(clusters) = self.clusters {
            clustering = clustering.clusters(clusters as usize);
        }
        if let Some(max_error) = self.max_error {
            clustering = clustering.max_error(max_error);
        }
        let weights = given.weights.as_ref().map(|column| &column.values[..]);
        clustering.run(&given.coordinates(), given.dim(), weights)
    }

    /// Says why there are fewer clusters than were asked for, if it is for want of points.
    fn shortfall(&self, clusters: &Clusters, numbering: &Numbering) -> Vec<String> {
        let is_split_up = clusters.history().last().is_none_or(|e| e.worst == 0.0);
        let asked = self.clusters.map_or(0, |n| n as usize);
        if clusters.len() >= asked || !is_split_up {
            return Vec::new();
        }
        let [file, found, asked] = [
            numbering.file().to_owned(),
            counted(clusters.len(), "cluster", "clusters"),
            count(asked),
        ];
        vec![format!(
            "{file}: {found} instead of {asked}: there are no more different points"
        )]
    }

    fn write(
        &self,
        outputs: &Outputs,
        given: &mut Given,
        clusters: &Clusters,
        progress: &Progress,
    ) -> Result<Vec<PathBuf>, Failure> {
        let centers = given.centers(clusters);
        let numbers = clusters.assignment().iter().map(|&c| f64::from(c));
        let points = &mut given.points;
        let mut name = "cluster".to_owned();
        while points.attributes.iter().any(|a| a.name == name) {
            name.push_str("_found");
        }
        points.attributes.push(Attribute {
            name,
            values: numbers.collect(),
        });
        let view = ClustersView {
            points: &points.points,
            assignment: clusters.assignment(),
            centers: &centers.points,
        };
        let writing = &self.task.writing;
        let mut written = writing.clusters(outputs, points, &view, progress)?;
        written.extend(writing.sites(outputs, &centers, progress)?);
        Ok(written)
    }
}

impl Given {
    fn dim(&self) -> usize {
        2 + self.more.len()
    }

    /// Returns the coordinates, point by point.
    fn coordinates(&self) -> Vec<f64> {
        let points = self.points.points.iter().enumerate();
        let row = |(i, p): (usize, &Point)| {
            let more = self.more.iter().map(move |column| column.values[i]);
            [p.x, p.y].into_iter().chain(more)
        };
        points.flat_map(row).collect()
    }

    /// Returns the centers, with what is known of their clusters.
    fn centers(&self, clusters: &Clusters) -> PointSet {
        let all = 0..clusters.len();
        let place = |cluster: usize| {
            let center = clusters.center(cluster);
            Point::new(center[0], center[1])
        };
        let column = |name: &str, value: &dyn Fn(usize) -> f64| Attribute {
            name: name.to_owned(),
            values: all.clone().map(value).collect(),
        };
        let more = self.more.iter().enumerate();
        let more = more.map(|(k, a)| column(&a.name, &|c| clusters.center(c)[2 + k]));
        let known = clusters.clusters();
        let figures = [
            column("cluster", &|c| c as f64),
            column("points", &|c| known[c].points as f64),
            column("weight", &|c| known[c].weight),
            column("error", &|c| known[c].error),
        ];
        PointSet {
            points: all.clone().map(place).collect(),
            attributes: more.chain(figures).collect(),
            ..PointSet::default()
        }
    }
}

impl<'a> Figures<'a> {
    fn of(given: &'a Given, clusters: &Clusters) -> Self {
        let points = || clusters.clusters().iter().map(|cluster| cluster.points);
        let last = clusters.history().last();
        let both = |errors: &Errors| [errors.worst, errors.mean];
        Self {
            points: given.points.points.len(),
            clusters: clusters.len(),
            dimension: given.dim(),
            weights: given.weights.as_ref().map(|column| &column.name[..]),
            fewest: points().min(),
            most: points().max(),
            worst_error: last.map(|errors| errors.worst),
            mean_error: last.map(|errors| errors.mean),
            history: clusters.history().iter().map(both).collect(),
        }
    }

    fn lines(&self) -> Vec<String> {
        let points = counted(self.points, "point", "points");
        let clusters = counted(self.clusters, "cluster", "clusters");
        let mut lines = vec![format!("{points}, {clusters}")];
        if let [Some(fewest), Some(most)] = [self.fewest, self.most] {
            let [fewest, most] = [count(fewest), counted(most, "point", "points")];
            lines[0].push_str(&format!(" of {fewest} to {most}"));
        }
        if let [Some(worst), Some(mean)] = [self.worst_error, self.mean_error] {
            let [worst, mean] = [worst, mean].map(measure);
            lines.push(format!(
                "mean square of distances: {mean}; in the worst cluster {worst}"
            ));
        }
        lines
    }
}
