//! Draws the pictures of the guide to the classical algorithms: a filmstrip for each, a few more, and an animation.
//!
//! `cargo run --release -p delone-io --example guide_pictures -- docs/algorithms/pictures` draws all; names of
//! pictures behind the folder, without their ending, draw only these.
//!
//! A strip shows moments that tell how the algorithm works. They are named by events, as
//! `docs/algorithms/log-format.md` calls them: `2 edge-flipped` is the second flip after the moment before,
//! `1 circle-tested inside` the next circle test with that answer. If a run has no such moment any more, the
//! program fails.

mod opening;
mod panels;
mod stages;

use delone::classic::{Algorithm, Input};
use delone::{Angle, DomainRule, Event, Log, Pslg, Quality};
use delone_io::{AnimationOptions, Pace, Recording, ShownSteps, Target, write_animation};
use std::error::Error;
use std::path::Path;

/// An algorithm, what it works on, and the moments of its strip.
type Strip = (Algorithm, fn() -> Input<'static>, &'static str);

/// The strips, one for each algorithm.
const STRIPS: [Strip; 20] = [
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
        Algorithm::AlgorithmA,
        few_soundings,
        "1 cover-rejected, 2 cover-rejected, 1 outer-reduced, 1 cover-accepted, 1 cluster-split, \
         1 cover-accepted, 3 cover-rejected",
    ),
    (
        Algorithm::AlgorithmB,
        soundings,
        "1 triangle-considered, 1 place-tried, 1 vertex-created, 1 edge-flipped, 3 triangle-considered, \
         3 place-tried, 1 vertex-created",
    ),
    (
        Algorithm::AlgorithmC,
        soundings,
        "1 vertex-created, 3 triangle-created, 1 edge-flipped, 1 vertex-created, 3 triangle-created, \
         1 edge-flipped, 1 vertex-created",
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
    (
        Algorithm::Constrained,
        bay,
        "1 segment-considered, 3 walk-stepped, 1 edge-created, 3 triangle-created, 1 edge-locked, \
         1 edge-flipped, 3 triangle-visited",
    ),
    (
        Algorithm::Refinement,
        plate,
        "1 circumcenter-proposed, 1 circumcenter-rejected, 3 triangle-created, 1 circumcenter-proposed, \
         1 edge-deleted, 4 triangle-created, 1 circumcenter-rejected",
    ),
];

/// Strips that show one part of an algorithm, with the names of their pictures.
const PARTS: [(&str, Strip); 2] = [
    (
        "outer-polygon",
        (
            Algorithm::AlgorithmA,
            wedge,
            "1 cover-rejected, 1 outer-reduced, 2 cover-rejected, 1 outer-reduced, 1 outer-reduced",
        ),
    ),
    (
        "bisection",
        (
            Algorithm::AlgorithmB,
            soundings,
            "5 triangle-considered, 1 place-tried, 1 place-tried, 1 place-tried, 1 place-tried, \
             1 vertex-created, 1 edge-flipped",
        ),
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

/// An outline with a bay, and a segment that crosses much.
fn bay() -> Input<'static> {
    let corners = [
        (0, 0),
        (90, 5),
        (100, 70),
        (64, 60),
        (50, 44),
        (36, 62),
        (4, 68),
    ];
    let inner = [
        (14, 30),
        (24, 12),
        (40, 10),
        (62, 16),
        (78, 24),
        (88, 40),
        (30, 40),
        (74, 48),
    ];
    let all = corners.into_iter().chain(inner);
    let mut pslg = Pslg::from_points(all.map(|(x, y)| (f64::from(x), f64::from(y))));
    pslg.add_ring(0..7);
    pslg.add_segment(7, 12);
    Input {
        domain: DomainRule::Carve,
        ..Input::from_pslg(pslg)
    }
}

/// The same outline, to be meshed.
fn plate() -> Input<'static> {
    let mut pslg = bay().pslg;
    pslg.points.truncate(7);
    pslg.segments.truncate(7);
    Input {
        domain: DomainRule::Carve,
        quality: Quality {
            min_angle: Some(Angle::degrees(30.0)),
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

/// Data that are denser towards a corner, as a ship takes them near a harbour.
fn soundings() -> Input<'static> {
    towards_a_corner(60)
}

/// Half as many.
fn few_soundings() -> Input<'static> {
    towards_a_corner(30)
}

fn towards_a_corner(n: u32) -> Input<'static> {
    let data = spread(n).map(|[x, y]| (100.0 * x * x.sqrt(), 80.0 * y * y.sqrt()));
    Input {
        least: 3,
        ..Input::from_points(data.map(|(x, y)| (x.round(), y.round())))
    }
}

/// Data in a triangle, all of which are to be in one.
fn wedge() -> Input<'static> {
    let data = spread(28).map(|[a, b]| {
        let is_beyond = a + b > 1.0;
        let [a, b] = [a, b].map(|share| if is_beyond { 1.0 - share } else { share });
        ((100.0 * a + 30.0 * b).round(), (85.0 * b).round())
    });
    Input {
        least: 28,
        ..Input::from_points(data)
    }
}

/// Points that fill the unit square evenly, though not on a lattice: multiples of two shares of the golden kind.
fn spread(n: u32) -> impl Iterator<Item = [f64; 2]> {
    let along = [0.754_877_666_246_693, 0.569_840_290_998_053];
    (1..=n).map(move |i| along.map(|share| (f64::from(i) * share).fract()))
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = arguments.next().ok_or("which folder?")?;
    let folder = Path::new(&folder);
    let wanted: Vec<_> = arguments.collect();
    let is_wanted = |name: &str| wanted.is_empty() || wanted.iter().any(|wanted| wanted == name);
    let strips = STRIPS.map(|strip| (strip.0.about().name, strip));
    for (name, strip) in strips.into_iter().chain(PARTS) {
        if is_wanted(name) {
            draw(folder, name, strip)?;
        }
    }
    if is_wanted("opening") {
        opening::draw(&folder.join("opening.svg"))?;
    }
    if is_wanted("stages") {
        stages::draw(&soundings(), &folder.join("stages.svg"))?;
    }
    Ok(())
}

/// Runs an algorithm, and draws its strip; of the one that the README shows, the animation, too.
fn draw(
    folder: &Path,
    name: &str,
    (algorithm, input, moments): Strip,
) -> Result<(), Box<dyn Error>> {
    let input = input();
    let mut log = Log::new(algorithm.about().name, input.pslg.points.clone());
    algorithm.observe(&input, &mut log)?;
    let moments = find(&log, moments).map_err(|missing| format!("{name}: no {missing}"))?;
    let recording = Recording::new(algorithm.about(), log);
    let options = AnimationOptions {
        size: 1500,
        moments,
        ..AnimationOptions::default()
    };
    let to = |ending: &str| Target::from_arg(folder.join(format!("{name}.{ending}")), None);
    write_animation(&[to("png")], &recording, &options, &())?;
    if name == "incremental" {
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
