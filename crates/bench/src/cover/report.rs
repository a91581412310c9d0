//! The tables of covers in Markdown, everything in JSON, and a plot.

use super::job::Answer;
use super::plan::{Cell, Plan};
use super::subject::Subject;
use crate::heading::{self, Heading};
use crate::measure::Memory;
use crate::process::Fault;
use crate::stats::{median, size_name};
use crate::table::{Table, dash};
use delone_io::{Curve, Panel};
use serde_json::{Value, json};
use std::fmt::Write;

/// A finished measurement: what was done, where, and what came out.
#[derive(Clone, Debug)]
pub struct Report {
    /// What was asked for.
    pub plan: Plan,
    /// Under which conditions.
    pub heading: Heading,
    /// What came out, in the plan's order.
    pub cells: Vec<Cell>,
}

/// The name of a part of the work, and the seconds that it takes.
type Part = (&'static str, fn(&Answer) -> f64);

/// The algorithms and all together, as tables and plots call them.
const STAGES: [Part; 4] = [
    ("A", |answer| answer.stages.a),
    ("B", |answer| answer.stages.b),
    ("C", |answer| answer.stages.c),
    ("all", |answer| answer.cost.seconds),
];

impl Report {
    /// Writes conditions and tables, ready for `BENCHMARKS.md`.
    pub fn to_markdown(&self) -> String {
        let mut text = String::new();
        self.write_markdown(&mut text)
            .expect("writing into a string cannot fail");
        text
    }

    fn write_markdown(&self, out: &mut String) -> std::fmt::Result {
        let Plan {
            least,
            factor,
            effort,
            ..
        } = &self.plan;
        writeln!(out, "{}", self.heading)?;
        let contenders = self.heading.contenders.iter().cloned();
        writeln!(out, "{}", heading::table(contenders))?;
        writeln!(
            out,
            "d = {least}, the hull blown up by {factor}; each cover checked by `verify_cover` first, then {}. \
             A includes putting the data in order, C handing out the result. There is no peer: no other program is known \
             that makes such triangulations.\n",
            effort.in_words()
        )?;
        writeln!(out, "**Nanoseconds a datum**\n\n{}", self.times())?;
        writeln!(out, "**What comes out**\n\n{}", self.outcomes())?;
        for cell in &self.cells {
            if let Err(Fault::Failed { how, message }) = &cell.facts {
                writeln!(out, "- {}: {how}: {message}", cell.subject)?;
            }
        }
        Ok(())
    }

    fn times(&self) -> Table {
        let stages = STAGES.map(|(name, _)| name);
        let header = ["data", "given"].into_iter().chain(stages);
        let mut table = Table::new(header.chain(["all, ms", "bytes a datum"]));
        for cell in &self.cells {
            let figure = |value: Option<f64>| match &cell.facts {
                Ok(_) => dash(value.map(|v| format!("{v:.0}"))),
                Err(fault) => fault.in_short(),
            };
            let mut row = vec![cell.subject.kind().to_owned(), dash(given(cell))];
            row.extend(STAGES.map(|(_, of)| figure(nanoseconds(cell, of))));
            let all = median(cell.runs.iter().map(|run| 1e3 * run.cost.seconds));
            row.push(match &cell.facts {
                Ok(_) => dash(all.map(|ms| format!("{ms:.1}"))),
                Err(fault) => fault.in_short(),
            });
            row.push(figure(memory(cell)));
            table.push(row);
        }
        table
    }

    fn outcomes(&self) -> Table {
        let header = [
            "data",
            "given",
            "distinct",
            "triangles",
            "fewest",
            "mean",
            "most",
            "special",
        ];
        let mut table = Table::new(header);
        for cell in &self.cells {
            let Ok(facts) = &cell.facts else { continue };
            table.push(vec![
                cell.subject.kind().to_owned(),
                dash(given(cell)),
                facts.data.to_string(),
                facts.triangles.to_string(),
                facts.fewest.to_string(),
                format!("{:.1}", facts.mean),
                facts.most.to_string(),
                facts.special.to_string(),
            ]);
        }
        table
    }

    /// Returns nanoseconds a datum over the number of data, a line for each kind, a panel for all and one for each
    /// stage.
    pub fn panels(&self) -> Vec<Panel> {
        let panel = |(name, of): Part| Panel {
            title: match name {
                "all" => "Nanoseconds a datum".to_owned(),
                stage => format!("Algorithm {stage}"),
            },
            curves: self.curves(of),
        };
        let [a, b, c, all] = STAGES;
        [all, a, b, c].map(panel).to_vec()
    }

    fn curves(&self, of: fn(&Answer) -> f64) -> Vec<Curve> {
        let mut curves: Vec<Curve> = Vec::new();
        for cell in &self.cells {
            let (Some(size), Some(value)) = (number(cell), nanoseconds(cell, of)) else {
                continue;
            };
            let name = cell.subject.kind();
            let known = curves.iter().position(|curve| curve.name == name);
            let place = known.unwrap_or_else(|| {
                curves.push(Curve {
                    name: name.to_owned(),
                    ..Curve::default()
                });
                curves.len() - 1
            });
            curves[place].points.push([size as f64, value]);
        }
        for curve in &mut curves {
            curve.points.sort_by(|p, q| p[0].total_cmp(&q[0]));
        }
        curves
    }

    /// Returns everything that was found, every single run included. Times are in seconds, memory in bytes.
    pub fn to_json(&self) -> Value {
        let cells = self.cells.iter().map(|cell| {
            json!({
                "subject": cell.subject.to_string(),
                "facts": cell.facts.as_ref().ok(),
                "fault": cell.facts.as_ref().err(),
                "runs": cell.runs,
            })
        });
        json!({
            "heading": self.heading,
            "least": self.plan.least,
            "factor": self.plan.factor,
            "seed": self.plan.effort.seed,
            "warmups": self.plan.effort.warmups,
            "cells": cells.collect::<Vec<_>>(),
        })
    }
}

/// How many data were given, if it is known.
fn number(cell: &Cell) -> Option<usize> {
    match cell.subject {
        Subject::Made(_, size) => Some(size),
        Subject::File(_) => cell.runs.first().map(|run| run.given),
    }
}

fn given(cell: &Cell) -> Option<String> {
    number(cell).map(size_name)
}

fn nanoseconds(cell: &Cell, of: fn(&Answer) -> f64) -> Option<f64> {
    cell.facts.as_ref().ok()?;
    median(
        cell.runs
            .iter()
            .map(|run| 1e9 * of(run) / run.given.max(1) as f64),
    )
}

fn memory(cell: &Cell) -> Option<f64> {
    let known = cell.runs.iter().filter_map(|run| {
        let memory = run.cost.memory.as_ref()?;
        Some(Memory::beyond_input(memory) as f64 / run.given.max(1) as f64)
    });
    median(known)
}

#[cfg(test)]
pub mod tests {
    //! Also what others make tests with.

    use super::super::facts::Facts;
    use super::super::laps::Stages;
    use super::{Answer, Cell, Fault, Plan, Report};
    use crate::effort::Effort;
    use crate::heading::{Contender, Heading};
    use crate::machine::Machine;
    use crate::measure::{Cost, Memory};
    use std::time::Duration;

    /// Three subjects, two runs each.
    pub fn plan() -> Plan {
        let subjects = ["uniform:10k", "uniform:1k", "lattice:1k"];
        Plan {
            subjects: subjects.map(|name| name.parse().unwrap()).to_vec(),
            least: 10,
            factor: 1.1,
            effort: Effort {
                runs: 2,
                warmups: 1,
                seed: 1,
                timeout: Duration::from_secs(60),
            },
        }
    }

    /// An answer that took `seconds`, of which A took half and B three eighths.
    pub fn answer(seconds: f64, check: bool) -> Answer {
        let facts = Facts {
            data: 990,
            triangles: 66,
            fewest: 10,
            mean: 15.0,
            most: 28,
            special: 0,
        };
        Answer {
            cost: Cost {
                seconds,
                user: seconds,
                system: 0.0,
                memory: Some(Memory {
                    before: 1000,
                    peak: 91_000,
                    after: 51_000,
                }),
            },
            stages: Stages {
                a: seconds / 2.0,
                b: seconds * 0.375,
                c: seconds * 0.125,
            },
            given: 1000,
            facts: check.then_some(facts),
        }
    }

    fn report() -> Report {
        let plan = plan();
        let cells = plan.subjects.iter().map(|subject| Cell {
            subject: subject.clone(),
            facts: Ok(answer(0.0, true).facts.unwrap()),
            runs: [0.002, 0.001, 0.004].map(|s| answer(s, false)).to_vec(),
        });
        let cells: Vec<_> = cells.collect();
        Report {
            heading: Heading {
                command: "delone-bench cover".to_owned(),
                machine: Machine::inspect(),
                contenders: vec![Contender {
                    name: "delone".to_owned(),
                    version: "0".to_owned(),
                    timed: "`Cover`".to_owned(),
                }],
            },
            plan,
            cells,
        }
    }

    #[test]
    fn tables_have_medians_and_what_the_check_found() {
        let text = report().to_markdown();
        for row in [
            "| lattice |    1k | 1000 | 750 | 250 | 2000 |     2.0 |            90 |",
            "| uniform |    1k |      990 |        66 |     10 | 15.0 |   28 |       0 |",
            "no peer",
            "median of 2 after 1 warm-ups",
        ] {
            assert!(text.contains(row), "{row}\n{text}");
        }
    }

    #[test]
    fn faults_are_named() {
        let mut report = report();
        report.cells[0].facts = Err(Fault::TimedOut(Duration::from_secs(60)));
        report.cells[1].facts = Err(Fault::failed("error", "a datum lies outside"));
        let text = report.to_markdown();
        assert!(text.contains("> 60 s"), "{text}");
        assert!(
            text.contains("- uniform:1k: error: a datum lies outside"),
            "{text}"
        );
        assert_eq!(report.panels()[0].curves.len(), 1);
        let json = report.to_json();
        assert_eq!(json["cells"][0]["fault"]["timed_out"], 60.0);
    }

    #[test]
    fn curves_are_by_kind_and_ascend() {
        let panels = report().panels();
        assert_eq!(panels.len(), 4);
        let curves = &panels[0].curves;
        assert_eq!(
            curves.iter().map(|c| &*c.name).collect::<Vec<_>>(),
            ["uniform", "lattice"]
        );
        assert_eq!(curves[0].points, [[1000.0, 2000.0], [10_000.0, 2000.0]]);
        assert_eq!(panels[3].curves[0].points[0], [1000.0, 250.0]);
        let json = report().to_json();
        assert_eq!(json["cells"][2]["runs"].as_array().map(Vec::len), Some(3));
    }
}
