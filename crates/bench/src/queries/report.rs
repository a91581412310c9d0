//! Tables of queries, ready for `BENCHMARKS.md`, and everything in JSON.

use super::engine::Engine;
use super::job::Answer;
use super::plan::{Cell, Plan, SLOW};
use super::question::{Question, Room};
use crate::heading::{self, Heading};
use crate::measure::Memory;
use crate::process::Fault;
use crate::stats::{median, size_name};
use crate::table::{Table, dash};
use delone_samples::Distribution;
use serde_json::{Value, json};
use std::fmt::Write;

/// What is to be measured, and where: everything but the figures.
#[derive(Clone, Debug)]
pub struct Report {
    /// What is to be measured.
    pub plan: Plan,
    /// Under which conditions.
    pub heading: Heading,
}

/// What a table is about.
struct Figure {
    title: fn(Room) -> String,
    value: fn(&Answer, usize) -> Option<f64>,
}

/// The figures, in the order of the tables.
const FIGURES: [Figure; 3] = [
    Figure {
        title: |room| format!("Nanoseconds {}", room.unit()),
        value: |answer, _| Some(1e9 * answer.work.seconds / answer.number as f64),
    },
    Figure {
        title: |_| "Nanoseconds a point to build".to_owned(),
        value: |answer, size| Some(1e9 * answer.build.as_ref()?.seconds / size as f64),
    },
    Figure {
        title: |_| "Bytes a point when built, points included".to_owned(),
        value: |answer, size| {
            let cost = answer.build.as_ref().unwrap_or(&answer.work);
            Some(growth(cost.memory.as_ref()?) / size as f64)
        },
    },
];

fn growth(memory: &Memory) -> f64 {
    memory.after.saturating_sub(memory.before) as f64
}

impl Report {
    /// Writes what stands above all tables.
    pub fn beginning(&self) -> String {
        let Plan { size, effort, .. } = &self.plan;
        let size = size_name(*size);
        format!(
            "{}\n{size} points; as many queries of the same kind in random order, or a tenth as many edits. \
             Each figure {}; whoever needs more than {SLOW} s is timed once.\n",
            self.heading,
            effort.in_words()
        )
    }

    /// Writes the tables of a room.
    pub fn room(&self, room: Room, cells: &[Cell]) -> String {
        let mut text = String::new();
        self.write_room(&mut text, room, cells)
            .expect("writing into a string cannot fail");
        text
    }

    fn write_room(&self, out: &mut String, room: Room, cells: &[Cell]) -> std::fmt::Result {
        writeln!(out, "### {}\n", room.title())?;
        let contenders = self.plan.engines.iter().zip(&self.heading.contenders);
        let present = contenders.filter_map(|(engine, contender)| {
            let mut contender = contender.clone();
            contender.timed = engine.called(room)?.to_owned();
            Some(contender)
        });
        writeln!(out, "{}", heading::table(present))?;
        for figure in &FIGURES {
            if let Some(table) = self.figure_table(figure, room, cells) {
                writeln!(out, "**{}**\n\n{table}", (figure.title)(room))?;
            }
        }
        for cell in cells {
            if let Err(Fault::Failed { how, message }) = &cell.runs {
                let Cell {
                    engine,
                    question,
                    distribution,
                    ..
                } = cell;
                writeln!(
                    out,
                    "- {engine} at {question}, {distribution}: {how}: {message}\n"
                )?;
            }
        }
        Ok(())
    }

    /// Makes the table of a figure; `None` if nobody has it.
    fn figure_table(&self, figure: &Figure, room: Room, cells: &[Cell]) -> Option<Table> {
        let engines = self.plan.engines.iter().copied();
        let engines: Vec<Engine> = engines.filter(|e| e.called(room).is_some()).collect();
        let names = engines.iter().map(Engine::to_string);
        let header = ["question", "points"].map(str::to_owned).into_iter();
        let mut table = Table::new(header.chain(names)).with_text_columns(2);
        let has_figure = |cell: &Cell| self.value(cell, figure).is_some();
        cells.iter().find(|cell| has_figure(cell))?;
        for group in cells.chunk_by(|a, b| key(a) == key(b)) {
            let (question, distribution) = key(&group[0]);
            let mut row = vec![question.to_string(), distribution.to_string()];
            row.extend(engines.iter().map(|&engine| {
                let cell = group.iter().find(|cell| cell.engine == engine);
                dash(cell.and_then(|cell| self.text(cell, figure)))
            }));
            table.push(row);
        }
        Some(table)
    }

    fn text(&self, cell: &Cell, figure: &Figure) -> Option<String> {
        match &cell.runs {
            Ok(_) => Some(format!("{:.0}", self.value(cell, figure)?)),
            Err(fault) => Some(fault.in_short()),
        }
    }

    fn value(&self, cell: &Cell, figure: &Figure) -> Option<f64> {
        let runs = cell.runs.as_ref().ok()?.iter();
        median(runs.filter_map(|answer| (figure.value)(answer, self.plan.size)))
    }

    /// Returns everything that was found, every single run included. Times are in seconds, memory in bytes.
    pub fn to_json(&self, cells: &[Cell]) -> Value {
        let cells = cells.iter().map(|cell| {
            json!({
                "question": cell.question.name(),
                "distribution": cell.distribution.name(),
                "engine": cell.engine.to_string(),
                "runs": cell.runs.as_ref().ok(),
                "fault": cell.runs.as_ref().err(),
            })
        });
        json!({
            "heading": self.heading,
            "size": self.plan.size,
            "seed": self.plan.effort.seed,
            "warmups": self.plan.effort.warmups,
            "cells": cells.collect::<Vec<_>>(),
        })
    }
}

fn key(cell: &Cell) -> (Question, Distribution) {
    (cell.question, cell.distribution)
}

#[cfg(test)]
mod tests {
    use super::{Answer, Cell, Distribution, Engine, Fault, Heading, Plan, Question, Report, Room};
    use crate::effort::Effort;
    use crate::machine::Machine;
    use crate::measure::{Cost, Memory};
    use crate::peer::Peer;
    use std::time::Duration;

    const ONE: Engine = Engine::Delone { threads: 1 };

    fn report() -> Report {
        let engines = vec![ONE, Engine::Spade, Engine::Kiddo, Engine::Voronoice];
        Report {
            heading: Heading {
                command: "delone-bench queries".to_owned(),
                machine: Machine::inspect(),
                contenders: engines
                    .iter()
                    .map(|engine| engine.contender(None))
                    .collect(),
            },
            plan: Plan {
                engines,
                questions: Question::ALL.to_vec(),
                distributions: vec![Distribution::Uniform],
                size: 1000,
                effort: Effort {
                    runs: 3,
                    warmups: 1,
                    seed: 1,
                    timeout: Duration::from_secs(60),
                },
            },
        }
    }

    fn cost(microseconds: f64) -> Cost {
        Cost {
            seconds: microseconds * 1e-6,
            user: 0.0,
            system: 0.0,
            memory: Some(Memory {
                before: 1000,
                peak: 90_000,
                after: 51_000,
            }),
        }
    }

    fn cell(question: Question, engine: Engine, factor: f64) -> Cell {
        let answer = |times: f64| Answer {
            build: (question != Question::Voronoi).then(|| cost(100.0)),
            work: cost(times * factor),
            number: 500,
            sum: None,
        };
        Cell {
            question,
            distribution: Distribution::Uniform,
            engine,
            is_slow: false,
            runs: Ok([9.0, 1.0, 2.0].map(answer).to_vec()),
        }
    }

    #[test]
    fn a_room_has_its_engines_and_figures() {
        let mut cells = vec![
            cell(Question::Nearest, ONE, 50.0),
            cell(Question::Nearest, Engine::Spade, 500.0),
            cell(Question::Nearest, Engine::Kiddo, 1.0),
            cell(Question::TenNearest, ONE, 100.0),
        ];
        cells[1].runs = Err(Fault::failed("wrong", "answers come to 1, not 2"));
        cells[2].runs = Err(Fault::TimedOut(Duration::from_secs(60)));
        let text = report().room(Room::Places, &cells);
        assert!(!text.contains("voronoice"), "{text}");
        for row in [
            "| nearest     | uniform |      200 | wrong | > 60 s |",
            "| ten-nearest | uniform |      400 |     – |      – |",
            "| nearest     | uniform |      100 | wrong | > 60 s |",
            "| nearest     | uniform |       50 | wrong | > 60 s |",
            "- spade at nearest, uniform: wrong: answers come to 1, not 2",
        ] {
            assert!(text.contains(row), "{row}\n{text}");
        }
    }

    #[test]
    fn what_is_not_built_has_no_table_for_it() {
        let cells = [cell(Question::Voronoi, ONE, 5.0)];
        let text = report().room(Room::Cells, &cells);
        assert!(text.contains("**Nanoseconds a site**"), "{text}");
        assert!(
            !text.contains("to build") && text.contains("**Bytes a point"),
            "{text}"
        );
        assert!(text.contains("| voronoi  | uniform |       20 |"), "{text}");
    }

    #[test]
    fn json_keeps_every_run() {
        let report = report();
        let mut cells = [
            cell(Question::Move, Engine::Spade, 5.0),
            cell(Question::Move, ONE, 1.0),
        ];
        cells[1].runs = Err(Fault::TimedOut(Duration::from_secs(60)));
        let json = report.to_json(&cells);
        assert_eq!(json["cells"][0]["runs"].as_array().map(Vec::len), Some(3));
        assert_eq!(json["cells"][1]["fault"]["timed_out"], 60.0);
        assert!(report.beginning().contains("median of 3 after 1 warm-ups"));
    }
}
