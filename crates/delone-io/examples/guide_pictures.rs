//! Draws the pictures of the guide to the classical algorithms: a filmstrip for each, and an animation.
//!
//! `cargo run --release -p delone-io --example guide_pictures -- docs/algorithms/pictures` draws all; names of
//! algorithms behind the folder draw only theirs.
//!
//! A strip shows moments that tell how the algorithm works. They are named by events, as
//! `docs/algorithms/log-format.md` calls them: `2 edge-flipped` is the second flip after the moment before,
//! `1 circle-tested inside` the next circle test with that answer. If a run has no such moment any more, the
//! program fails.

use delone::classic::{Algorithm, Input};
use delone::{Angle, DomainRule, Event, Log, Pslg, Quality};
use delone_io::{AnimationOptions, Pace, Recording, ShownSteps, Target, write_animation};
use std::error::Error;
use std::path::Path;

/// An algorithm, what it works on, and the moments of its strip.
type Strip = (Algorithm, fn() -> Input<'static>, &'static str);

/// The strips, one for each algorithm.
const STRIPS: [Strip; 15] = [
    (
        Algorithm::Sweep,
        outline,
        "3 front-entered, 2 point-considered, 3 triangle-created, 1 stage-ended, 5 edge-flipped, \
         1 triangle-deleted, 1 stage-ended, 3 segment-considered",
    ),
    (
        Algorithm::PrintedSweep,
        pentagon,
        "3 front-entered, 1 print-failed, 1 point-considered, 2 triangle-created, 2 point-considered, \
         1 print-failed, 2 stage-ended, 2 print-failed",
    ),
    (
        Algorithm::EdgeFlip,
        outline,
        "1 popped, 1 circle-tested inside, 1 edge-flipped, 1 circle-tested on, 1 circle-tested inside, \
         1 edge-flipped, 2 pushed",
    ),
    (
        Algorithm::Thesis,
        outline,
        "1 segment-split, 2 stage-ended, 1 triangle-considered, 1 segment-split, 1 triangle-considered, \
         1 circumcenter-rejected, 1 segment-split",
    ),
    (
        Algorithm::SegmentWalk,
        scattered,
        "5 point-considered, 6 point-considered, 3 walk-stepped, 1 circle-tested inside, 1 edge-deleted, \
         2 edge-created, 1 edge-deleted",
    ),
    (
        Algorithm::GreedyFlips,
        scattered,
        "1 pushed, 1 circle-tested inside, 1 conflicts-counted, 1 circle-tested inside, \
         1 conflicts-counted, 3 conflicts-counted, 3 conflicts-counted",
    ),
    (
        Algorithm::FlipList,
        scattered,
        "1 popped, 1 circle-tested inside, 1 edge-flipped, 1 pushed, 1 circle-tested inside, \
         3 edge-flipped, 2 pushed",
    ),
    (
        Algorithm::Incremental,
        scattered,
        "1 edge-flipped, 9 point-considered, 1 point-located, 3 triangle-created, 1 circle-tested inside, \
         1 edge-flipped, 1 edge-flipped",
    ),
    (
        Algorithm::RandomIncremental,
        scattered,
        "1 point-considered, 2 point-considered, 2 point-considered, 1 circle-tested inside, \
         1 edge-flipped, 1 point-considered, 2 point-considered",
    ),
    (
        Algorithm::ConvexHull,
        scattered,
        "2 point-considered, 4 orientation-tested left, 13 edge-created, 1 orientation-tested right, \
         1 edge-created, 2 edge-created, 2 edge-created",
    ),
    (
        Algorithm::ClineRenka,
        scattered,
        "1 edge-flipped, 9 point-considered, 1 orientation-tested right, 2 walk-stepped, \
         3 triangle-created, 1 circle-tested inside, 1 edge-flipped",
    ),
    (
        Algorithm::BowyerWatson,
        scattered,
        "6 point-considered, 2 pushed, 3 triangle-created, 5 point-considered, 1 circle-tested inside, \
         2 pushed, 2 edge-deleted",
    ),
    (
        Algorithm::SweepCircle,
        scattered,
        "3 swept-to, 1 triangle-created, 1 swept-to, 1 circle-tested inside, 1 edge-flipped, 5 swept-to, \
         3 triangle-created",
    ),
    (
        Algorithm::Fortune,
        scattered,
        "3 point-considered, 1 point-considered, 1 edge-created, 1 triangle-considered, \
         1 triangle-created, 4 point-considered, 5 triangle-considered",
    ),
    (
        Algorithm::DivideAndConquer,
        scattered,
        "1 set-divided, 1 tangent-found, 2 triangle-created, 2 tangent-found, 2 edge-deleted, \
         1 triangle-created, 4 triangle-created",
    ),
];

/// Points that come from all sides, and one into their middle.
fn scattered() -> Input<'static> {
    let border = [(12, 18), (46, 6), (88, 14), (30, 40), (72, 30), (97, 52)];
    let others = [(8, 62), (40, 70), (76, 74), (22, 92), (58, 96), (92, 90)];
    let all = border.into_iter().chain(others).chain([(48, 50)]);
    Input::from_points(all.map(|(x, y)| (f64::from(x), f64::from(y))))
}

/// The domain of the thesis' examples, and what it asks of a mesh there.
fn outline() -> Input<'static> {
    let border = [
        (1.0, 0.0),
        (3.0, 1.0),
        (2.5, 3.0),
        (3.0, 4.0),
        (0.0, 3.0),
        (0.0, 1.0),
    ];
    let hole = [(2.0, 1.0), (2.0, 2.0), (1.0, 2.0)];
    let mut pslg = Pslg::from_points(border.into_iter().chain(hole));
    pslg.add_ring(0..6);
    pslg.add_ring(6..9);
    Input {
        domain: DomainRule::EvenOdd,
        quality: Quality {
            min_angle: Some(Angle::degrees(20.0)),
            max_edge: Some(3.0),
            ..Quality::default()
        },
        ..Input::from_pslg(pslg)
    }
}

/// The pentagon on which the printed sweep fails.
fn pentagon() -> Input<'static> {
    let corners = [
        (40.0, 20.0),
        (18.0, 11.0),
        (37.0, 36.0),
        (40.0, 29.0),
        (31.0, 19.0),
    ];
    let mut pslg = Pslg::from_points(corners);
    pslg.add_ring(0..5);
    Input {
        domain: DomainRule::EvenOdd,
        ..Input::from_pslg(pslg)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("which folder?")?;
    let wanted: Vec<_> = arguments.collect();
    for (algorithm, input, moments) in STRIPS {
        let name = algorithm.about().name;
        if wanted.is_empty() || wanted.iter().any(|wanted| wanted == name) {
            draw(Path::new(&folder), algorithm, &input(), moments)?;
        }
    }
    Ok(())
}

/// Runs an algorithm, and draws its strip; of the one that the README shows, the animation, too.
fn draw(
    folder: &Path,
    algorithm: Algorithm,
    input: &Input,
    moments: &str,
) -> Result<(), Box<dyn Error>> {
    let name = algorithm.about().name;
    let mut log = Log::new(name, input.pslg.points.clone());
    algorithm.observe(input, &mut log)?;
    let moments = find(&log, moments).map_err(|missing| format!("{name}: no {missing}"))?;
    let recording = Recording::new(algorithm.about(), log);
    let options = AnimationOptions {
        size: 1500,
        moments,
        ..AnimationOptions::default()
    };
    let to = |ending: &str| Target::from_arg(folder.join(format!("{name}.{ending}")), None);
    write_animation(&[to("png")], &recording, &options, &())?;
    if algorithm == Algorithm::Incremental {
        let options = AnimationOptions {
            size: 1000,
            shown: ShownSteps::Changes,
            pace: Pace::InSeconds(30.0),
            ..options
        };
        write_animation(&[to("svg")], &recording, &options, &())?;
    }
    Ok(())
}

/// Finds moments in a log: how many steps there are up to each, or the name of one that is missing.
fn find<'m>(log: &Log, moments: &'m str) -> Result<Vec<usize>, &'m str> {
    let mut played = 0;
    let one = |moment: &'m str| {
        let (times, event) = moment.split_once(' ').ok_or(moment)?;
        let times: usize = times.parse().map_err(|_| moment)?;
        let steps = log.steps.iter().enumerate().skip(played);
        let mut alike = steps.filter(|(_, step)| step.line != 0 && is_called(step.event, event));
        let (at, _) = alike.nth(times - 1).ok_or(moment)?;
        played = at + 1;
        Ok(played)
    };
    moments.split(", ").map(one).collect()
}

/// Tells whether an event has this name; behind a blank there may be the answer of a test.
fn is_called(event: Event, wanted: &str) -> bool {
    let event = serde_json::to_value(event).expect("events are numbers and words");
    let (name, answer) = wanted
        .split_once(' ')
        .map_or((wanted, None), |(name, answer)| (name, Some(answer)));
    let fields = event.get(name);
    fields.is_some_and(|fields| answer.is_none() || fields["answer"].as_str() == answer)
}
