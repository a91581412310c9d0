//! Tables of queries, ready for `BENCHMARKS.md`, and everything in JSON.

use super::job::Answer;
use super::plan::{Cell, Plan};
use crate::machine::Machine;
use crate::stats::{median, size_name};
use crate::table::Table;
use serde_json::{Value, json};
use std::fmt::Write;

/// Everything that was measured, and how.
#[derive(Clone, Debug)]
pub struct Report {
    /// What was to be measured.
    pub plan: Plan,
    /// On what.
    pub machine: Machine,
    /// By which command.
    pub command: String,
    /// The figures.
    pub cells: Vec<Cell>,
}

type Figure = fn(&Answer) -> f64;

/// The figures, in the order of the tables.
const FIGURES: [(&str, Figure); 3] = [
    ("Nanoseconds a query", |answer| 1e9 * answer.queries.seconds),
    ("Nanoseconds a point to build", |answer| {
        1e9 * answer.build.seconds
    }),
    ("Bytes a point when built, points included", |answer| {
        let memory = answer.build.memory;
        memory.map_or(f64::NAN, |m| m.after.saturating_sub(m.before) as f64)
    }),
];

impl Report {
    /// Writes conditions and tables.
    pub fn to_markdown(&self) -> String {
        let mut text = String::new();
        self.write_markdown(&mut text)
            .expect("writing into a string cannot fail");
        text
    }

    fn write_markdown(&self, out: &mut String) -> std::fmt::Result {
        writeln!(out, "`{}`\n", self.command)?;
        for (label, value) in self.machine.entries() {
            writeln!(out, "- {label}: {value}")?;
        }
        let Plan {
            size,
            warmups,
            runs,
            ..
        } = self.plan;
        writeln!(out, "\n{}", self.engine_table())?;
        let size = size_name(size);
        writeln!(
            out,
            "{size} points, {size} queries of the same kind, in random order. Each figure from fresh \
             processes, median of {runs} after {warmups} warm-ups.\n"
        )?;
        for (title, figure) in FIGURES {
            writeln!(out, "**{title}**\n\n{}", self.figure_table(figure))?;
        }
        for cell in &self.cells {
            if let Err(why) = &cell.runs {
                writeln!(
                    out,
                    "- {} at {}, {}: {why}",
                    cell.engine, cell.question, cell.distribution
                )?;
            }
        }
        Ok(())
    }

    fn engine_table(&self) -> Table {
        let mut table = Table::new(["engine", "version", "timed"]).with_text_columns(3);
        for engine in &self.plan.engines {
            let words = [
                engine.to_string(),
                engine.version().to_owned(),
                engine.timed().to_owned(),
            ];
            table.push(words.to_vec());
        }
        table
    }

    fn figure_table(&self, figure: Figure) -> Table {
        let engines = self.plan.engines.iter().map(ToString::to_string);
        let header = ["question", "points"]
            .map(str::to_owned)
            .into_iter()
            .chain(engines);
        let mut table = Table::new(header).with_text_columns(2);
        for group in self.cells.chunk_by(|a, b| key(a) == key(b)) {
            let mut row = vec![
                group[0].question.to_string(),
                group[0].distribution.to_string(),
            ];
            row.extend(self.plan.engines.iter().map(|&engine| {
                let cell = group.iter().find(|cell| cell.engine == engine);
                cell.map_or("–".to_owned(), |cell| self.text(cell, figure))
            }));
            table.push(row);
        }
        table
    }

    fn text(&self, cell: &Cell, figure: Figure) -> String {
        let Ok(runs) = &cell.runs else {
            return "failed".to_owned();
        };
        let each = runs.iter().map(|run| figure(run) / self.plan.size as f64);
        let value = median(each).filter(|value| value.is_finite());
        value.map_or("–".to_owned(), |value| format!("{value:.0}"))
    }

    /// Returns everything that was found, every single run included. Times are in seconds, memory in bytes.
    pub fn to_json(&self) -> Value {
        let cells = self.cells.iter().map(|cell| {
            json!({
                "question": cell.question.name(),
                "distribution": cell.distribution.name(),
                "engine": cell.engine.to_string(),
                "runs": cell.runs.as_ref().ok(),
                "fault": cell.runs.as_ref().err(),
            })
        });
        json!({
            "command": self.command,
            "machine": self.machine,
            "size": self.plan.size,
            "seed": self.plan.seed,
            "warmups": self.plan.warmups,
            "cells": cells.collect::<Vec<_>>(),
        })
    }
}

fn key(cell: &Cell) -> (&'static str, &'static str) {
    (cell.question.name(), cell.distribution.name())
}
