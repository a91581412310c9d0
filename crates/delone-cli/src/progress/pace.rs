//! What phases are called, in which units they go, and how fast.

use crate::words::bytes;
use delone::Phase;
use indicatif::{ProgressState, ProgressStyle};
use std::fmt::Write;
use std::time::Duration;

/// A rate that is taken from less time than this is none.
const SETTLED: Duration = Duration::from_millis(200);

/// Returns what a phase does.
pub fn label(phase: Phase) -> &'static str {
    match phase {
        Phase::Read => "reading",
        Phase::Sort => "sorting",
        Phase::Triangulate => "triangulating",
        Phase::Node => "crossings",
        Phase::Constrain => "constraining",
        Phase::Carve => "carving",
        Phase::Refine => "refining",
        Phase::Smooth => "smoothing",
        Phase::Export => "renumbering",
        Phase::Voronoi => "cells",
        Phase::Relax => "relaxing",
        Phase::Proximity => "relating",
        Phase::Tour => "touring",
        Phase::Cluster => "clustering",
        Phase::Cover => "covering",
        Phase::Query => "querying",
        Phase::Interpolate => "evaluating",
        Phase::Contour => "contouring",
        Phase::Check => "checking",
        Phase::Draw => "drawing",
        Phase::Write => "writing",
        _ => "working",
    }
}

/// Returns the unit of a phase; none if it is no thing that people know.
fn unit(phase: Phase) -> Option<&'static str> {
    Some(match phase {
        Phase::Read => "B",
        Phase::Triangulate => "points",
        Phase::Constrain => "segments",
        Phase::Refine | Phase::Tour => "vertices",
        Phase::Relax => "steps",
        Phase::Proximity => "edges",
        Phase::Cluster => "clusters",
        Phase::Cover => "triangles",
        Phase::Query => "queries",
        Phase::Write => "rows",
        _ => return None,
    })
}

/// Tells whether nobody knows beforehand how much a phase will be.
fn is_open(phase: Phase) -> bool {
    matches!(phase, Phase::Refine | Phase::Tour | Phase::Cover)
}

/// Says how fast a phase is: `31.2 MB/s`, `3.41 M points/s`; nothing if that means nothing.
pub fn rate(phase: Phase, done: u64, took: Duration) -> Option<String> {
    let unit = unit(phase)?;
    let rate = done as f64 / took.as_secs_f64();
    if done == 0 || !rate.is_finite() {
        return None;
    }
    Some(match unit {
        "B" => format!("{}/s", bytes(rate as u64)),
        _ => format!("{}{unit}/s", scaled(rate)),
    })
}

/// Writes a number with three digits: `812 `, `31.2 k `, `3.41 M `.
fn scaled(number: f64) -> String {
    let (value, prefix) = match number {
        n if n >= 1e9 => (n / 1e9, "G "),
        n if n >= 1e6 => (n / 1e6, "M "),
        n if n >= 1e3 => (n / 1e3, "k "),
        n => (n, ""),
    };
    let decimals = match value {
        v if v >= 100.0 || prefix.is_empty() => 0,
        v if v >= 10.0 => 1,
        _ => 2,
    };
    format!("{value:.decimals$} {prefix}")
}

/// Returns the look of a bar for a phase.
pub fn style(phase: Phase) -> ProgressStyle {
    let rates = move |state: &ProgressState, w: &mut dyn Write| {
        let took = state.elapsed();
        let rate = rate(phase, state.pos(), took).filter(|_| took >= SETTLED);
        write_all(w, &rate.unwrap_or_default());
    };
    let left = |state: &ProgressState, w: &mut dyn Write| {
        let left = left(state.pos(), state.len(), state.elapsed());
        write_all(w, &left.unwrap_or_default());
    };
    let count = move |state: &ProgressState, w: &mut dyn Write| {
        let unit = unit(phase).unwrap_or_default();
        write_all(w, &format!("{}{unit}", scaled(state.pos() as f64)));
    };
    let template = match is_open(phase) {
        true => "{msg:13} {spinner:.cyan} {count}  {rate}",
        false => "{msg:13} {wide_bar:.cyan/dim} {percent:>3} %  {rate}  {left}",
    };
    ProgressStyle::with_template(template)
        .expect("bug: bad template")
        .with_key("rate", rates)
        .with_key("left", left)
        .with_key("count", count)
}

/// Returns the look of a bar for the files of a batch.
pub fn of_files() -> ProgressStyle {
    let left = |state: &ProgressState, w: &mut dyn Write| {
        let left = left(state.pos(), state.len(), state.elapsed());
        write_all(w, &left.unwrap_or_default());
    };
    let template = "{pos} of {len} files {wide_bar:.cyan/dim} {left}  {msg}";
    ProgressStyle::with_template(template)
        .expect("bug: bad template")
        .with_key("left", left)
}

/// A bar that cannot be written has nobody who looks at it.
fn write_all(w: &mut dyn Write, text: &str) {
    w.write_str(text).ok();
}

/// Says how long the rest will take, if that can be said: `4 s left`, `2 min left`.
fn left(done: u64, total: Option<u64>, took: Duration) -> Option<String> {
    let total = total.filter(|&total| done > 0 && done < total && took >= SETTLED)?;
    let seconds = took.as_secs_f64() * (total - done) as f64 / done as f64;
    Some(match seconds.ceil() {
        s if s <= 90.0 => format!("{s:.0} s left"),
        s if s <= 5400.0 => format!("{:.0} min left", (s / 60.0).ceil()),
        s => format!("{:.0} h left", (s / 3600.0).ceil()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates_have_three_digits_and_a_unit() {
        let second = Duration::from_secs(1);
        for (phase, done, expected) in [
            (Phase::Read, 31_200_000, Some("31.2 MB/s")),
            (Phase::Triangulate, 3_410_000, Some("3.41 M points/s")),
            (Phase::Refine, 81_249, Some("81.2 k vertices/s")),
            (Phase::Tour, 12, Some("12 vertices/s")),
            (Phase::Write, 0, None),
            (Phase::Check, 1000, None),
        ] {
            assert_eq!(rate(phase, done, second).as_deref(), expected);
        }
    }

    #[test]
    fn what_is_left_is_said_once_there_is_something_to_go_by() {
        let two = Duration::from_secs(2);
        assert_eq!(left(1, Some(3), two).as_deref(), Some("4 s left"));
        assert_eq!(left(1, Some(200), two).as_deref(), Some("7 min left"));
        assert_eq!(left(1, Some(20_000), two).as_deref(), Some("12 h left"));
        assert_eq!(left(0, Some(3), two), None);
        assert_eq!(left(3, Some(3), two), None);
        assert_eq!(left(1, Some(3), Duration::from_millis(1)), None);
        assert_eq!(left(1, None, two), None);
    }

    #[test]
    fn every_look_is_a_template() {
        for phase in [Phase::Read, Phase::Refine, Phase::Check] {
            drop(style(phase));
        }
        drop(of_files());
    }
}
