//! Every file of the corpus, refined at 20° and at 30°, with and without a bound on edges, and judged.
//!
//! All of it takes half a minute on two cores. A table with file, triangles, smallest angle, unmet
//! triangles by reason, outcome, seconds, comes with
//!
//! ```text
//! cargo test --release -p delone --test refine_corpus -- --nocapture
//! ```

use delone::{
    Angle, DomainRule, Outcome, Point, Quality, Reason, RefinedMesh, Report, SegmentPolicy, Unmet,
    Watch,
};
use delone_testkit::corpus::{self, Entry};
use delone_testkit::domains::Domain;
use delone_testkit::refined::{Job, judge};
use std::collections::BTreeSet;
use std::path::Path;
use std::time::{Duration, Instant};

/// The few files of the corpus that are part of the repository.
const FIXTURES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");

/// Files with more points than this have tests of their own, to run beside the others.
const SMALL: usize = 600;

/// Cancels after some time: a hang becomes a failure with a name.
struct Deadline(Instant);

impl Deadline {
    fn after(seconds: u64) -> Self {
        Self(Instant::now() + Duration::from_secs(seconds))
    }
}

impl Watch for Deadline {
    fn is_cancelled(&self) -> bool {
        Instant::now() > self.0
    }
}

/// What is asked of a whole corpus.
#[derive(Clone, Copy)]
struct Ask {
    degrees: f64,
    /// Edges to a diameter of the file, or no bound.
    edges_across: Option<f64>,
}

/// One file, refined.
struct Row {
    name: String,
    is_clean: bool,
    triangles: usize,
    min_angle: f64,
    report: Report,
    /// A few triangles that break a bound without an excuse.
    unexcused: Vec<(Unmet, [Point; 3])>,
    seconds: f64,
}

impl Row {
    fn print(&self) {
        let count = |is: fn(&Reason) -> bool| {
            let unmet = self.report.unmet.iter();
            unmet.filter(|u| is(&u.reason)).count()
        };
        println!(
            "{:52} {:8} {:7.3}° angle {:5} precision {:4} gradation {:4} stopped {:5} {:?} {:.2} s",
            self.name,
            self.triangles,
            self.min_angle,
            count(|r| matches!(r, Reason::SmallInputAngle { .. })),
            count(|r| matches!(r, Reason::Precision)),
            count(|r| matches!(r, Reason::Gradation)),
            count(|r| matches!(r, Reason::Stopped)),
            self.report.outcome,
            self.seconds
        );
        for (unmet, corners) in &self.unexcused {
            println!("    {:?}: {corners:?}", unmet);
        }
    }
}

/// Reads the fixtures, and the shared corpus if it is there: files whose number of points `is_meant`.
fn files(is_meant: fn(usize) -> bool) -> Vec<Entry> {
    let mut roots = vec![Path::new(FIXTURES).to_owned()];
    match corpus::root() {
        Some(shared) => roots.push(shared),
        None => {
            eprintln!("fixtures only: set DELONE_SHARED to the folder that holds the shared data/")
        }
    }
    let all = roots.iter().flat_map(|root| corpus::read_all(root));
    let mut entries: Vec<_> = all
        .filter(|entry| is_meant(entry.pslg.points.len()))
        .collect();
    entries.sort_by(|a, b| a.name.cmp(&b.name));
    entries.dedup_by(|a, b| a.name == b.name);
    entries
}

/// The files whose segments do not meet at shared ends only, as the corpus states.
fn unclean_files() -> BTreeSet<String> {
    let facts = corpus::root().map(|root| corpus::facts(&root));
    let unclean = facts
        .into_iter()
        .flatten()
        .filter(|(_, facts)| !facts.is_clean());
    unclean.map(|(name, _)| name).collect()
}

/// The rule that files of this sort get from the program: outlines are carved, polygons as drawn, and
/// what encloses nothing keeps its hull.
fn rule_for(entry: &Entry) -> DomainRule {
    let rule = if entry.pslg.segments.is_empty() {
        return DomainRule::Hull;
    } else if entry.pslg.polygons.is_empty() {
        DomainRule::Carve
    } else {
        DomainRule::EvenOdd
    };
    let domain = Domain {
        pslg: entry.pslg.clone(),
        crossings: SegmentPolicy::Split,
        rule,
    };
    let t = domain.triangulate(2).expect("a result");
    if t.triangulation().num_triangles() == 0 {
        DomainRule::Hull
    } else {
        rule
    }
}

fn diameter(points: &[Point]) -> f64 {
    let side = |of: fn(&Point) -> f64| {
        let (low, high) = points
            .iter()
            .map(of)
            .fold((f64::MAX, f64::MIN), |(l, h), c| (l.min(c), h.max(c)));
        high - low
    };
    side(|p| p.x).hypot(side(|p| p.y))
}

fn job(entry: &Entry, ask: Ask, vertices: usize) -> Job {
    let longest = ask.edges_across.map(|n| diameter(&entry.pslg.points) / n);
    Job {
        domain: Domain {
            pslg: entry.pslg.clone(),
            crossings: SegmentPolicy::Split,
            rule: rule_for(entry),
        },
        quality: Quality {
            min_angle: Some(Angle::degrees(ask.degrees)),
            max_edge: longest.filter(|&edge| edge > 0.0 && edge.is_finite()),
            ..Quality::default()
        },
        vertices: Some(vertices),
        ..Job::default()
    }
}

/// Refines and judges; what is wrong is told after all files had their turn.
fn refine(entry: &Entry, job: &Job, seconds: u64) -> Result<(RefinedMesh, f64), String> {
    let name = &entry.name;
    let start = Instant::now();
    let refined = job.mesh(2, &Deadline::after(seconds));
    let elapsed = start.elapsed().as_secs_f64();
    let refined = refined.map_err(|e| format!("{name}: {e}"))?;
    judge(job, &refined).map_err(|why| format!("{name}: {why}"))?;
    Ok((refined, elapsed))
}

/// Visits the triangles that break a bound without an excuse, with their corners.
fn unexcused(refined: &RefinedMesh) -> impl Iterator<Item = (Unmet, [Point; 3])> + '_ {
    let unmet = refined.report.unmet.iter();
    let unexcused = unmet.filter(|u| !u.reason.is_excused());
    let t = refined.mesh.triangulation();
    unexcused.map(|&u| (u, t.triangles()[u.triangle.index()].map(|v| t.point(v))))
}

fn refine_all(entries: &[Entry], ask: Ask) -> Vec<Row> {
    let unclean = unclean_files();
    let mut wrong = Vec::new();
    let mut rows = Vec::new();
    for entry in entries {
        let vertices = 200_000 + 20 * entry.pslg.points.len();
        match refine(entry, &job(entry, ask, vertices), 60) {
            Ok((refined, seconds)) => {
                let row = Row {
                    name: entry.name.clone(),
                    is_clean: !unclean.contains(&entry.name),
                    triangles: refined.mesh.triangulation().num_triangles(),
                    min_angle: refined.statistics().min_angle,
                    unexcused: unexcused(&refined).take(3).collect(),
                    report: refined.report,
                    seconds,
                };
                row.print();
                rows.push(row);
            }
            Err(why) => {
                println!("WRONG {why}");
                wrong.push(why);
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{} are wrong:\n{}",
        wrong.len(),
        wrong.join("\n")
    );
    rows
}

/// Clean files end, and `share` of them without an unmet triangle that nothing excuses; nothing is
/// cancelled.
fn assert_reached(rows: &[Row], share: f64) {
    let clean: Vec<_> = rows.iter().filter(|row| row.is_clean).collect();
    let missed = |row: &&&Row| row.report.num_unexcused() > 0;
    let missed: Vec<_> = clean.iter().filter(missed).map(|row| &row.name).collect();
    let most = (1.0 - share) * clean.len() as f64;
    assert!(
        missed.len() as f64 <= most,
        "{} of {} clean files have unmet triangles without an excuse: {missed:#?}",
        missed.len(),
        clean.len()
    );
    let stopped = |row: &&Row| {
        let unmet = row.report.unmet.iter();
        row.report.outcome == Outcome::Cancelled
            || unmet.clone().any(|u| u.reason == Reason::Stopped) && row.is_clean
    };
    let stopped: Vec<_> = rows.iter().filter(stopped).map(|row| &row.name).collect();
    assert!(stopped.is_empty(), "did not end: {stopped:#?}");
}

const ANGLE_20: Ask = Ask {
    degrees: 20.0,
    edges_across: None,
};

const ANGLE_30: Ask = Ask {
    degrees: 30.0,
    edges_across: None,
};

/// With a size bound, too.
fn sized(ask: Ask) -> Ask {
    Ask {
        edges_across: Some(50.0),
        ..ask
    }
}

fn is_small(points: usize) -> bool {
    points <= SMALL
}

fn is_large(points: usize) -> bool {
    !is_small(points)
}

#[test]
fn small_files_reach_20_degrees() {
    assert_reached(&refine_all(&files(is_small), ANGLE_20), 1.0);
}

#[test]
fn small_files_reach_30_degrees_or_tell_why_not() {
    assert_reached(&refine_all(&files(is_small), ANGLE_30), 0.98);
}

#[test]
fn small_files_have_bounded_edges() {
    for (ask, share) in [(ANGLE_20, 1.0), (ANGLE_30, 0.98)] {
        assert_reached(&refine_all(&files(is_small), sized(ask)), share);
    }
}

/// The provinces have a test of their own.
fn large_files() -> Vec<Entry> {
    let mut entries = files(is_large);
    entries.retain(|entry| entry.name != PROVINCES);
    entries
}

#[test]
fn large_files_reach_20_degrees() {
    assert_reached(&refine_all(&large_files(), ANGLE_20), 1.0);
}

#[test]
fn large_files_reach_30_degrees_or_tell_why_not() {
    assert_reached(&refine_all(&large_files(), ANGLE_30), 0.98);
}

#[test]
fn large_files_have_bounded_edges() {
    for (ask, share) in [(ANGLE_20, 1.0), (ANGLE_30, 0.98)] {
        assert_reached(&refine_all(&large_files(), sized(ask)), share);
    }
}

const PROVINCES: &str = "natural-earth/ne_110m_admin_1_states_provinces.geojson";

/// A channel 0.29 long and below 8e-7 wide makes Triangle add points for 2.1 million triangles.
#[test]
fn provinces_take_at_most_three_fifths_of_what_triangle_makes() {
    let Some(root) = corpus::root() else { return };
    let entry = corpus::read(&root, PROVINCES).expect("the provinces");
    let job = job(&entry, ANGLE_20, 2_000_000);
    let (refined, seconds) = refine(&entry, &job, 600).unwrap_or_else(|why| panic!("{why}"));
    let triangles = refined.mesh.triangulation().num_triangles();
    println!("{triangles} triangles in {seconds:.1} s");
    assert_eq!(refined.report.outcome, Outcome::Complete);
    assert!(triangles <= 1_260_000, "{triangles} triangles");
}

/// An outline whose trailing edge closes with an edge of 2e-16, at a wedge of 1°: it exhausted the
/// memory of others.
#[test]
fn an_airfoil_that_closes_with_an_edge_of_2e_16_stays_small() {
    let mut pslg = delone::Pslg::default();
    let n = 200;
    let surface = |i: i32, side: f64| {
        // Cosine spacing; a half thickness that leaves the trailing edge with half a degree.
        let x = 0.5 + 0.5 * (std::f64::consts::PI * f64::from(i) / f64::from(n)).cos();
        let wedge = 0.5f64.to_radians().tan() * (1.0 - x);
        Point::new(x, side * (wedge + 0.12 * (1.0 - x) * x.sqrt() * (1.0 - x)))
    };
    let upper = (1..n).map(|i| surface(i, 1.0));
    let lower = (1..n).rev().map(|i| surface(i, -1.0));
    pslg.points.push(Point::new(1.0, 1e-16));
    pslg.points.extend(upper);
    pslg.points.push(Point::new(0.0, 0.0));
    pslg.points.extend(lower);
    pslg.points.push(Point::new(1.0, -1e-16));
    pslg.add_ring(0..pslg.points.len() as u32);
    let entry = Entry {
        name: "airfoil".to_owned(),
        pslg,
    };
    for degrees in [20.0, 30.0] {
        let ask = Ask {
            degrees,
            ..ANGLE_20
        };
        let job = job(&entry, ask, 100_000);
        let (refined, _) = refine(&entry, &job, 60).unwrap_or_else(|why| panic!("{why}"));
        let triangles = refined.mesh.triangulation().num_triangles();
        println!(
            "{degrees}°: {triangles} triangles, {:?}",
            refined.report.outcome
        );
        assert!(triangles < 10_000, "{triangles} triangles");
        assert_ne!(refined.report.outcome, Outcome::BudgetExhausted);
    }
}
