//! The examination: facts first, then everything else, each in its file.

use super::graph::Graph;
use super::trouble::{Diagnosis, Kind, Trouble};
use super::{Doctor, corners, lines, near, rings, scale, seeds};
use crate::parallel::{Workers, with_workers};
use crate::{Error, Facts, Listed, Point, Pslg, VertexId};

/// As many times as there are segments may they meet, if the domain is to be triangulated.
const MOST_MEETINGS: u64 = 10;

/// Finds everything.
pub(super) fn examine(doctor: &Doctor, pslg: &Pslg) -> Result<Diagnosis, Error> {
    let facts = pslg.facts(doctor.limit, doctor.watch)?;
    crate::pslg::input::check(pslg)?;
    let graph = Graph::new(pslg);
    let meetings = facts.crossings.count + facts.overlaps.count + facts.on_segments.count;
    let mut found = Diagnosis {
        is_domain_known: meetings / MOST_MEETINGS <= pslg.segments.len() as u64,
        ..Diagnosis::default()
    };
    with_workers(None, |workers| {
        add_the_rest(doctor, pslg, &graph, &mut found, workers)
    })??;
    let has_segments = !pslg.segments.is_empty();
    of_facts(facts, pslg, has_segments, &mut found);
    found
        .troubles
        .sort_by_key(|&(kind, _)| (kind.severity(), kind));
    Ok(found)
}

fn add_the_rest(
    doctor: &Doctor,
    pslg: &Pslg,
    graph: &Graph,
    found: &mut Diagnosis,
    workers: Workers,
) -> Result<(), Error> {
    let &Doctor {
        tolerance,
        limit,
        watch,
        rule,
    } = doctor;
    let cancelled = || Error::Cancelled;
    let [pairs, beside] =
        near::misses(graph, tolerance, limit, workers, watch).ok_or_else(cancelled)?;
    found.add(Kind::NearVertices, pairs);
    found.add(Kind::NearSegment, beside);
    let lines = lines::examine(graph, tolerance, workers, watch).ok_or_else(cancelled)?;
    found.suggestion = lines.suggestion().filter(|&gap| gap > tolerance);
    found.add_all(Kind::UnclosedRing, lines.unclosed, limit);
    for (kind, troubles) in rings::examine(pslg, graph, watch)? {
        found.add_all(kind, troubles, limit);
    }
    let asks = found.is_domain_known;
    for (kind, troubles) in seeds::examine(pslg, graph, rule, asks, workers, watch)? {
        found.add_all(kind, troubles, limit);
    }
    corners::examine(graph, limit, found, watch).ok_or_else(cancelled)?;
    scale::examine(&pslg.points, found, limit);
    Ok(())
}

/// Translates facts.
fn of_facts(facts: Facts, pslg: &Pslg, has_segments: bool, found: &mut Diagnosis) {
    let at = |v: VertexId| pslg.points[v.index()];
    let point = |v: VertexId| Trouble {
        points: vec![v],
        at: Some(at(v)),
        ..Trouble::default()
    };
    let ends = |s: usize| pslg.segments[s].map(at);
    let whole = |s: usize| Trouble {
        segments: vec![s],
        at: Some(ends(s)[0]),
        to: Some(ends(s)[1]),
        ..Trouble::default()
    };
    found.add(
        Kind::Crossing,
        each(facts.crossings, |crossing| Trouble {
            segments: crossing.segments.into(),
            at: Some(crossing.at),
            ..Trouble::default()
        }),
    );
    found.add(
        Kind::Overlap,
        each(facts.overlaps, |segments| {
            let [from, to] = common(segments.map(ends));
            Trouble {
                segments: segments.into(),
                at: Some(from),
                to: Some(to),
                ..Trouble::default()
            }
        }),
    );
    found.add(
        Kind::VertexOnSegment,
        each(facts.on_segments, |on| Trouble {
            segments: vec![on.segment],
            ..point(on.vertex)
        }),
    );
    let zero_length = |s| Trouble {
        to: None,
        ..whole(s)
    };
    found.add(Kind::ZeroLength, each(facts.zero_length, zero_length));
    found.add(
        Kind::Duplicate,
        each(facts.duplicates, |pair| Trouble {
            points: pair.into(),
            ..point(pair[0])
        }),
    );
    found.add(
        Kind::Repeated,
        each(facts.repeated, |pair| Trouble {
            segments: pair.into(),
            ..whole(pair[0])
        }),
    );
    if has_segments {
        found.add(Kind::OpenEnd, each(facts.open_ends, point));
        found.add(Kind::LoosePoint, each(facts.loose_points, point));
    }
}

fn each<T>(found: Listed<T>, describe: impl FnMut(T) -> Trouble) -> Listed<Trouble> {
    Listed {
        count: found.count,
        first: found.first.into_iter().map(describe).collect(),
    }
}

/// Of the four ends of segments on one line, the middle ones are those of the common part.
fn common(segments: [[Point; 2]; 2]) -> [Point; 2] {
    let mut ends = segments.concat();
    ends.sort_by(Point::lex_cmp);
    [ends[1], ends[2]]
}
