//! Running an algorithm on a drawing, and what there is to say of it.

use super::Description;
use crate::Trouble;
use crate::drawing::{Drawing, Rule};
use delone::classic::{About, Algorithm, Input, Takes};
use delone::{Angle, Log, Observer, Quality, Step, Tally, Watch};
use delone_io::Recording;
use serde::{Deserialize, Serialize};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Steps that fit into the memory of a page: some 70 bytes each.
const MOST_STEPS: usize = 5_000_000;

/// Points beyond which conflicts are not counted: each count takes linear time.
const MOST_CONFLICTS: usize = 500;

/// What the thesis' own example asks for.
const USUAL_ANGLE: f64 = 20.0;
const USUAL_EDGE: f64 = 3.0;

/// What some algorithms want to know.
#[derive(Default, Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields, default)]
pub(super) struct Options {
    seed: u64,
    min_angle: Option<f64>,
    max_edge: Option<f64>,
    data_per_triangle: Option<usize>,
    domain: Option<Rule>,
}

/// Runs an algorithm and keeps every step.
pub(super) fn record(
    name: &str,
    drawing: &Drawing,
    options: &Options,
) -> Result<Recording, Trouble> {
    let Some(algorithm) = Algorithm::named(name) else {
        let names = Algorithm::ALL.iter().map(|a| a.about().name);
        let names = names.collect::<Vec<_>>().join(", ");
        let message = format!("no algorithm is called {name:?}; there are {names}");
        return Err(Trouble::asked(message));
    };
    let about = algorithm.about();
    let counter = Counter::default();
    let input = Input {
        watch: &counter,
        ..input(about, drawing, options)
    };
    let mut keeper = Keeper {
        log: Log::new(name, input.pslg.points.clone()),
        counter: &counter,
        counts_conflicts: input.pslg.points.len() <= MOST_CONFLICTS,
    };
    let run = algorithm.observe(&input, &mut keeper);
    if counter.is_full() {
        let message = format!("more than {MOST_STEPS} steps: take fewer points");
        return Err(Trouble::asked(message));
    }
    run?;
    Ok(Recording::new(about, keeper.log))
}

/// Gives an algorithm what it takes.
fn input(about: &About, drawing: &Drawing, options: &Options) -> Input<'static> {
    let mut data = drawing.data.clone();
    let rule = options.domain.map_or(data.usual_rule, Into::into);
    let is_bare = matches!(about.takes, Takes::Points | Takes::Data);
    let mut input = match is_bare {
        true => Input::from_points(data.vertices.points),
        false => Input::from_pslg(data.take_pslg()),
    };
    if about.takes == Takes::Triangulation {
        input.start.clone_from(&drawing.start);
    }
    if !is_bare {
        input.domain = rule;
    }
    input.seed = options.seed;
    input.least = options.data_per_triangle.unwrap_or(input.least);
    let is_bounded = options.min_angle.is_some() || options.max_edge.is_some();
    let bound = |given: Option<f64>, usual| if is_bounded { given } else { Some(usual) };
    input.quality = Quality {
        min_angle: bound(options.min_angle, USUAL_ANGLE).map(Angle::degrees),
        max_edge: match about == Algorithm::Thesis.about() {
            true => bound(options.max_edge, USUAL_EDGE),
            false => options.max_edge,
        },
        ..Quality::default()
    };
    input
}

/// Counts steps, and stops a run that has too many.
#[derive(Default)]
struct Counter(AtomicUsize);

impl Counter {
    fn is_full(&self) -> bool {
        self.0.load(Relaxed) >= MOST_STEPS
    }
}

impl Watch for Counter {
    fn is_cancelled(&self) -> bool {
        self.is_full()
    }
}

/// Keeps steps as long as there is room.
struct Keeper<'c> {
    log: Log,
    counter: &'c Counter,
    counts_conflicts: bool,
}

impl Observer for Keeper<'_> {
    fn observe(&mut self, step: Step) {
        if self.log.steps.len() < MOST_STEPS {
            self.log.observe(step);
        }
        self.counter.0.fetch_add(1, Relaxed);
    }

    fn wants_conflicts(&self) -> bool {
        self.counts_conflicts
    }
}

/// Says what there is to say of an algorithm.
pub(super) fn describe(about: &'static About) -> Description {
    Description {
        name: about.name,
        title: about.title,
        source: about.source,
        idea: about.idea,
        cost: about.cost,
        guarantees: about.guarantees,
        takes: match about.takes {
            Takes::Points => "points",
            Takes::Triangulation => "triangulation",
            Takes::Domain => "domain",
            Takes::Data => "data",
        },
        delaunay: about.is_delaunay,
        code: about.code,
    }
}

/// Counts what a run does.
pub(super) fn count(log: &Log) -> Tally {
    let mut tally = Tally::default();
    log.steps.iter().for_each(|&step| tally.observe(step));
    tally
}

/// Counts, with keys in camel case as everywhere here.
#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Counts {
    steps: u64,
    orientation_tests: u64,
    circle_tests: u64,
    ties: u64,
    walk_steps: u64,
    flips: u64,
    edges_created: u64,
    edges_deleted: u64,
    triangles_created: u64,
    triangles_deleted: u64,
    vertices_created: u64,
    pushed: u64,
    first_conflicts: Option<u64>,
    last_conflicts: Option<u64>,
}

/// Writes counts.
pub(super) fn counts(tally: &Tally) -> Counts {
    Counts {
        steps: tally.steps,
        orientation_tests: tally.orientation_tests,
        circle_tests: tally.circle_tests,
        ties: tally.ties,
        walk_steps: tally.walk_steps,
        flips: tally.flips,
        edges_created: tally.edges_created,
        edges_deleted: tally.edges_deleted,
        triangles_created: tally.triangles_created,
        triangles_deleted: tally.triangles_deleted,
        vertices_created: tally.vertices_created,
        pushed: tally.pushed,
        first_conflicts: tally.first_conflicts,
        last_conflicts: tally.last_conflicts,
    }
}
