//! What a race has come to, for people: a table, and lines in panels.

use super::Lap;
use crate::words::{count, duration};
use delone_io::{Curve, Panel};
use std::time::Duration;

const HEAD: [&str; 7] = [
    "algorithm",
    "points",
    "orientation",
    "circle",
    "flips",
    "walk steps",
    "time",
];

/// One line for each lap.
pub fn table(laps: &[Lap]) -> String {
    let mut rows = vec![HEAD.map(str::to_owned)];
    rows.extend(laps.iter().map(row));
    let widths: [usize; 7] = std::array::from_fn(|k| {
        let widths = rows.iter().map(|row| row[k].chars().count());
        widths.max().unwrap_or(0)
    });
    let line = |row: &[String; 7]| {
        let cells = row.iter().zip(widths).enumerate();
        let cells = cells.map(|(k, (cell, width))| match k {
            0 => format!("{cell:width$}"),
            _ => format!("{cell:>width$}"),
        });
        cells.collect::<Vec<_>>().join("  ")
    };
    rows.iter().map(line).collect::<Vec<_>>().join("\n")
}

fn row(lap: &Lap) -> [String; 7] {
    let counts = [
        lap.points as u64,
        lap.orientation_tests,
        lap.circle_tests,
        lap.flips,
        lap.walk_steps,
    ];
    let [points, orientation, circle, flips, steps] = counts.map(|n| count(n as usize));
    let time = duration(Duration::from_secs_f64(lap.seconds));
    [
        lap.algorithm.to_owned(),
        points,
        orientation,
        circle,
        flips,
        steps,
        time,
    ]
}

/// Predicates, flips and time against the number of points.
pub fn panels(laps: &[Lap]) -> Vec<Panel> {
    let panel = |title: &str, value: &dyn Fn(&Lap) -> f64| Panel {
        title: title.to_owned(),
        curves: laps
            .chunk_by(|a, b| a.algorithm == b.algorithm)
            .map(|of| curve(of, value))
            .collect(),
    };
    vec![
        panel("predicates", &|lap| lap.predicates as f64),
        panel("flips", &|lap| lap.flips as f64),
        panel("milliseconds, not observed", &|lap| 1e3 * lap.seconds),
    ]
}

fn curve(laps: &[Lap], value: &dyn Fn(&Lap) -> f64) -> Curve {
    Curve {
        name: laps[0].algorithm.to_owned(),
        points: laps
            .iter()
            .map(|lap| [lap.points as f64, value(lap)])
            .collect(),
        half_widths: Vec::new(),
    }
}
