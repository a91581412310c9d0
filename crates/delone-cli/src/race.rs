//! `delone race`: classical algorithms beside each other, on more and more points.

mod lap;
mod table;

use crate::algorithms::named;
use crate::exit::Failure;
use crate::files::{self, Content, Outputs, Reading, Writing};
use crate::numbers::positive;
use crate::phases::Phases;
use crate::progress::Progress;
use crate::words::counted;
use delone::classic::{Algorithm, Takes};
use delone::{Error, Point};
use delone_samples::Distribution;
use lap::{Lap, Track};
use serde::Serialize;
use std::path::PathBuf;
use std::time::Duration;

const EXAMPLES: &str = "\
Examples:
  delone race                                  all that make a Delaunay triangulation of points
  delone race incremental random-incremental bowyer-watson --distribution circle
  delone race sweep-circle fortune divide-and-conquer --sizes 1000,10000,100000 -p race.png
  delone race cline-renka segment-walk --input survey.csv --json | jq '.laps[].predicates'";

const JSON: &str = "\
The JSON object of --json:
  input            the file, or the kind of points
  laps             for each algorithm and size an object: algorithm, points, orientation_tests,
                   circle_tests, predicates (both), flips, walk_steps, edges_deleted, steps, seconds
                   (not observed; the median of the runs), runs, hash
  skipped          for each algorithm what it was too slow for: algorithm, points
  peak_rss_bytes   largest memory of the process so far (null where the system does not tell)";

/// Most points: how counts grow shows long before.
const MOST: i64 = 10_000_000;

/// Let classical algorithms run beside each other, and count: predicates, flips, walk steps, time
///
/// Each runs on more and more points: of a kind that `delone sample` knows, or the first of a file, shuffled.
/// Work is counted in a run that is observed, time in runs that are not. All that claim a Delaunay triangulation
/// must come to the same one.
#[derive(clap::Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{JSON}\n\n{}", crate::exit::HELP))]
pub struct Race {
    /// Who runs; `delone algorithms` lists them [default: all that take points and claim Delaunay]
    #[arg(value_name = "NAME", value_parser = named(), hide_possible_values = true)]
    algorithms: Vec<Algorithm>,
    /// File of points to take the first of; they are shuffled
    #[arg(short, long, value_name = "FILE", conflicts_with = "distribution")]
    input: Option<PathBuf>,
    /// Kind of points; `delone sample` lists them
    #[arg(short, long, value_name = "KIND", default_value = "uniform")]
    distribution: Distribution,
    /// Numbers of points
    #[arg(short = 'n', long, value_name = "N,N,…", value_delimiter = ',',
          default_value = "100,1000,10000", value_parser = clap::value_parser!(u32).range(1..=MOST))]
    sizes: Vec<u32>,
    /// Seed of points and orders
    #[arg(long, value_name = "SEED", default_value_t = 1)]
    seed: u64,
    /// Seconds that an algorithm may take for one size: what would take longer is skipped
    #[arg(long, value_name = "S", default_value_t = 10.0, value_parser = positive)]
    seconds: f64,
    /// Plot to write, .svg or .png: predicates, flips and time against the number of points
    #[arg(short, long, value_name = "PIC")]
    picture: Vec<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    reading: Reading,
    #[command(flatten)]
    writing: Writing,
}

/// What a race has come to; the fields are the keys of `--json`.
#[derive(Serialize)]
struct Results {
    input: String,
    laps: Vec<Lap>,
    skipped: Vec<Skipped>,
    peak_rss_bytes: Option<u64>,
}

/// Who was too slow for what.
#[derive(Serialize)]
struct Skipped {
    algorithm: &'static str,
    points: usize,
}

impl Skipped {
    fn in_words(&self) -> String {
        let Self { algorithm, points } = self;
        let points = counted(*points, "point", "points");
        format!("{algorithm}: too slow for {points}; --seconds gives it more time")
    }
}

impl Race {
    /// Runs the command.
    pub fn run(&self, quiet: bool) -> Result<(), Failure> {
        let pictures = self.picture.iter().map(|p| (p.clone(), Content::Picture));
        let outputs = self.writing.outputs(pictures)?;
        if outputs.use_stdout() {
            let clash = "the results and the picture `-` both want standard output; name a file";
            return Err(Failure::Usage(clash.to_owned()));
        }
        if self.input.is_none() && self.reading.is_given() {
            let lacking = "--from and --columns are about --input, and none is named";
            return Err(Failure::Usage(lacking.to_owned()));
        }
        let algorithms = self.entrants()?;
        let progress = Progress::new(quiet);
        let mut phases = Phases::default();
        let sizes = self.sizes();
        let (input, points) = phases.time("read", || self.points(&sizes, &outputs, &progress))?;

        let mut results = Results {
            input,
            laps: Vec::new(),
            skipped: Vec::new(),
            peak_rss_bytes: None,
        };
        phases.time("race", || {
            self.race(&algorithms, &sizes, &points, &progress, &mut results)
        })?;
        let written = phases.write(|| {
            let targets = outputs.pictures();
            let panels = table::panels(&results.laps);
            delone_io::write_plot(&targets, &panels, "points", &progress).map_err(files::unwritable)
        })?;
        progress.finish();
        require_agreement(&results.laps)?;
        results.peak_rss_bytes = crate::memory::peak_rss_bytes();
        if self.json {
            return files::print_json(&results);
        }
        files::print(&table::table(&results.laps))?;
        if !quiet {
            let skipped: Vec<String> = results.skipped.iter().map(Skipped::in_words).collect();
            phases.summarise(&skipped, &written);
        }
        Ok(())
    }

    /// Who runs, each once.
    fn entrants(&self) -> Result<Vec<Algorithm>, Failure> {
        let mut all = self.algorithms.clone();
        if all.is_empty() {
            let claims = |a: &Algorithm| a.about().is_delaunay && a.about().takes != Takes::Domain;
            all.extend(Algorithm::ALL.iter().copied().filter(claims));
        }
        if let Some(refines) = all.iter().find(|a| a.refines()) {
            let name = refines.about().name;
            let other = format!("`{name}` refines a domain, and cannot race on points");
            return Err(Failure::Usage(other));
        }
        let mut entrants: Vec<Algorithm> = Vec::new();
        for algorithm in all {
            if !entrants.contains(&algorithm) {
                entrants.push(algorithm);
            }
        }
        Ok(entrants)
    }

    /// The numbers of points, ascending.
    fn sizes(&self) -> Vec<usize> {
        let mut sizes: Vec<usize> = self.sizes.iter().map(|&n| n as usize).collect();
        sizes.sort_unstable();
        sizes.dedup();
        sizes
    }

    /// The points of the largest size, in random order, and what they are called.
    fn points(
        &self,
        sizes: &[usize],
        outputs: &Outputs,
        progress: &Progress,
    ) -> Result<(String, Vec<Point>), Failure> {
        let most = sizes.last().copied().unwrap_or(0);
        let (name, mut points): (_, Vec<Point>) = match &self.input {
            Some(path) => {
                let file = self.reading.open(path)?;
                outputs.spare(&file.files())?;
                let (set, unused) = file.points(progress)?;
                progress.note(&unused);
                (file.name(), set.points)
            }
            None => {
                let points = self.distribution.points(most, self.seed);
                (
                    self.distribution.name().to_owned(),
                    points.into_iter().map(Point::from).collect(),
                )
            }
        };
        delone_samples::Random::new(self.seed).shuffle(&mut points);
        if points.len() < most {
            let has = counted(points.len(), "point", "points");
            if sizes.iter().all(|&n| n > points.len()) {
                let few = format!("{name} has {has}, fewer than all sizes: --sizes takes others");
                return Err(Failure::Usage(few));
            }
            progress.note(&[format!("{name} has {has}, so larger sizes are left out")]);
        }
        Ok((name, points))
    }

    /// Lets everybody run on every size that is not too much for them.
    fn race(
        &self,
        algorithms: &[Algorithm],
        sizes: &[usize],
        points: &[Point],
        progress: &Progress,
        results: &mut Results,
    ) -> Result<(), Failure> {
        let budget = Duration::from_secs_f64(self.seconds.min(1e9));
        for &algorithm in algorithms {
            let mut track = Track::new(algorithm, self.seed, budget);
            for &n in sizes.iter().filter(|&&n| n <= points.len()) {
                let lap = track
                    .run(&points[..n], progress)
                    .map_err(|error| match error {
                        Error::Cancelled => Failure::Cancelled,
                        other => Failure::BadInput(other.to_string()),
                    })?;
                match lap {
                    Some(lap) => results.laps.push(lap),
                    None => results.skipped.push(Skipped {
                        algorithm: algorithm.about().name,
                        points: n,
                    }),
                }
            }
        }
        Ok(())
    }
}

/// Requires that all who claim the Delaunay triangulation of so many points have found the same.
fn require_agreement(laps: &[Lap]) -> Result<(), Failure> {
    let claims: Vec<&Lap> = laps.iter().filter(|lap| lap.is_delaunay()).collect();
    for (i, lap) in claims.iter().enumerate() {
        let differs = |other: &&&Lap| other.points == lap.points && other.hash != lap.hash;
        if let Some(other) = claims[i + 1..].iter().find(differs) {
            let (a, b, n) = (lap.algorithm, other.algorithm, lap.points);
            let bug =
                format!("bug: {a} and {b} do not agree on {n} points; please report the input");
            return Err(Failure::NotReached(bug));
        }
    }
    Ok(())
}
