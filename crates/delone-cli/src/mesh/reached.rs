//! What refinement has reached, for people and for programs.

use crate::numbering::Numbering;
use crate::unmet::{explain, reason_name};
use crate::words::{counted, measure};
use delone::{Angle, Outcome, Quality, RefinedMesh, Report, Unmet};
use serde::Serialize;
use std::collections::BTreeMap;

/// Bars of a histogram, by height.
const BARS: [char; 9] = ['·', '▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];

/// Degrees that share a bar.
const DEGREES: usize = 2;

/// What was asked for and reached; the fields are keys of `--json`.
#[derive(Serialize)]
pub struct Reached {
    steiner_on_segments: usize,
    #[serde(flatten)]
    bounds: Bounds,
    asked: Asked,
    outcome: &'static str,
    unmet: usize,
    unexcused: usize,
    unmet_by_reason: BTreeMap<&'static str, usize>,
}

/// Extremes of triangles.
#[derive(Serialize)]
struct Bounds {
    min_angle_degrees: Option<f64>,
    max_edge: Option<f64>,
    max_area: Option<f64>,
}

#[derive(Serialize)]
struct Asked {
    #[serde(flatten)]
    bounds: Bounds,
    area_per_region: bool,
    sizing: bool,
}

impl Asked {
    fn new(quality: &Quality, sizing: bool) -> Self {
        Self {
            bounds: Bounds {
                min_angle_degrees: quality.min_angle.map(Angle::to_degrees),
                max_edge: quality.max_edge,
                max_area: quality.max_area,
            },
            area_per_region: quality.region_areas,
            sizing,
        }
    }
}

impl Reached {
    /// Takes the figures of a mesh; `sizing` tells whether sizes depended on the place.
    pub fn new(refined: &RefinedMesh, sizing: bool) -> Self {
        let (report, statistics) = (&refined.report, refined.statistics());
        let if_any = |value| (statistics.triangles > 0).then_some(value);
        let mut unmet_by_reason = BTreeMap::from(KNOWN_REASONS.map(|name| (name, 0)));
        for unmet in &report.unmet {
            *unmet_by_reason
                .entry(reason_name(unmet.reason))
                .or_default() += 1;
        }
        Self {
            steiner_on_segments: report.on_segments,
            bounds: Bounds {
                min_angle_degrees: if_any(statistics.min_angle),
                max_edge: if_any(statistics.longest_edge),
                max_area: if_any(statistics.largest_area),
            },
            asked: Asked::new(&report.asked, sizing),
            outcome: outcome_name(report.outcome),
            unmet: report.unmet.len(),
            unexcused: report.num_unexcused(),
            unmet_by_reason,
        }
    }

    /// Says it in lines for people.
    pub fn lines(&self, refined: &RefinedMesh, numbering: &Numbering) -> Vec<String> {
        let (report, statistics) = (&refined.report, refined.statistics());
        let mut lines = vec![steiner(report)];
        if statistics.triangles > 0 {
            lines.push(self.extremes());
            lines.push(histogram(&statistics.min_angles));
        }
        lines.extend(stop(report.outcome).map(str::to_owned));
        if statistics.triangles == 0 {
            lines.push("there is no triangle".to_owned());
        } else if report.unmet.is_empty() {
            lines.push("every triangle is as asked".to_owned());
        } else {
            lines.extend(excused(refined, numbering));
        }
        lines
    }

    fn extremes(&self) -> String {
        let asked = &self.asked.bounds;
        let say = |what: &str, reached: Option<f64>, asked: Option<f64>, unit: &str| {
            let reached = measure(reached.unwrap_or_default());
            let asked = asked.map(|asked| format!(" (asked: {}{unit})", as_written(asked)));
            format!("{what} {reached}{unit}{}", asked.unwrap_or_default())
        };
        let Bounds {
            min_angle_degrees,
            max_edge,
            max_area,
        } = self.bounds;
        let angle = say(
            "smallest angle",
            min_angle_degrees,
            asked.min_angle_degrees,
            "°",
        );
        let edge = say("longest edge", max_edge, asked.max_edge, "");
        let area = say("largest area", max_area, asked.max_area, "");
        format!("{angle}, {edge}, {area}")
    }
}

/// The reasons that are counted even if there is none of them.
const KNOWN_REASONS: [&str; 5] = [
    "small_input_angle",
    "locked_boundary",
    "precision",
    "gradation",
    "stopped",
];

fn outcome_name(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Complete => "complete",
        Outcome::BudgetExhausted => "budget_exhausted",
        Outcome::PrecisionLimit => "precision_limit",
        Outcome::FellBack => "fell_back",
        _ => "stopped",
    }
}

/// Says why refinement stopped, if it had not come to its end.
fn stop(outcome: Outcome) -> Option<&'static str> {
    match outcome {
        Outcome::BudgetExhausted => Some("stopped early: --max-vertices or --max-time was reached"),
        Outcome::PrecisionLimit => {
            Some("stopped where better triangles would need vertices too close together")
        }
        Outcome::FellBack => {
            Some("fell back to the mesh from before skinny triangles were opened, for that failed")
        }
        _ => None,
    }
}

fn steiner(report: &Report) -> String {
    let all = report.on_segments + report.free;
    let all = counted(all, "Steiner point", "Steiner points");
    format!(
        "{all}, {} of them on segments",
        crate::words::count(report.on_segments)
    )
}

/// Writes a number as people write it: `25`, `0.05`, `1e-6`.
fn as_written(number: f64) -> String {
    match number {
        n if (1e-4..1e9).contains(&n) => n.to_string(),
        n => format!("{n:e}"),
    }
}

/// Draws how many triangles have which smallest angle, in one line.
fn histogram(min_angles: &[usize; 60]) -> String {
    let counts: Vec<usize> = min_angles.chunks(DEGREES).map(|c| c.iter().sum()).collect();
    let most = counts.iter().copied().max().unwrap_or(0).max(1);
    let bar = |&n: &usize| BARS[(n * (BARS.len() - 1)).div_ceil(most)];
    let bars: String = counts.iter().map(bar).collect();
    format!("smallest angles of triangles: 0° {bars} 60°")
}

/// Says for each excuse how many triangles have it, and which is the worst.
fn excused(refined: &RefinedMesh, numbering: &Numbering) -> Vec<String> {
    let mut worst: BTreeMap<&str, (usize, &Unmet)> = BTreeMap::new();
    let unmet = refined.report.unmet.iter();
    for unmet in unmet.filter(|unmet| unmet.reason.is_excused()) {
        let (n, worst) = worst.entry(reason_name(unmet.reason)).or_insert((0, unmet));
        *n += 1;
        if unmet.min_angle < worst.min_angle {
            *worst = unmet;
        }
    }
    let line = |&(n, worst): &(usize, &Unmet)| {
        let triangles = counted(n, "triangle is", "triangles are");
        let worst = explain(worst, refined, numbering);
        format!("{triangles} not as asked, but excused; the worst lies {worst}")
    };
    worst.values().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_shown_as_they_were_written() {
        let shown = [25.0, 0.05, 1e-6, 3e12].map(as_written);
        assert_eq!(shown, ["25", "0.05", "1e-6", "3e12"].map(String::from));
    }

    #[test]
    fn a_bar_stands_for_two_degrees_and_few_are_more_than_none() {
        let mut min_angles = [0; 60];
        (
            min_angles[0],
            min_angles[40],
            min_angles[41],
            min_angles[59],
        ) = (1, 500, 500, 500);
        let line = histogram(&min_angles);
        let bars: Vec<char> = line.split(' ').nth(5).expect("bars").chars().collect();
        assert_eq!(bars.len(), 30);
        assert_eq!([bars[0], bars[1], bars[20], bars[29]], ['▁', '·', '█', '▄']);
    }
}
