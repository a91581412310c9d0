//! The tables in Markdown, and everything in JSON.
//!
//! A number in brackets after a number of triangles says how many of them miss a bound: at acute
//! corners of the input somebody must. Ratios are those of ours on one thread.

use super::goal::Load;
use super::mesher::Mesher;
use super::plan::{Cell, Plan};
use super::targets::{self, ratio};
use crate::heading::{self, Heading};
use crate::measure::Memory;
use crate::process::Fault;
use crate::stats::{median, size_name};
use crate::table::{Table, dash};
use serde_json::{Value, json};
use std::fmt::Write;

/// A finished measurement: what was done, where, and what came out.
#[derive(Clone, Debug)]
pub struct Report {
    /// What was asked for.
    pub plan: Plan,
    /// Under which conditions.
    pub heading: Heading,
    /// What came out, grouped by outline, load and angle, meshers in the plan's order.
    pub cells: Vec<Cell>,
}

/// What a table is about.
struct Figure {
    title: &'static str,
    value: fn(&Cell) -> Option<f64>,
    digits: usize,
    /// Do ratios to rivals mean something?
    has_ratios: bool,
    /// Do threads change it?
    has_speedups: bool,
    /// Does it say how many triangles miss a bound?
    has_missed: bool,
}

const FIGURES: [Figure; 5] = [
    Figure {
        title: "Triangles (in brackets: those that miss a bound)",
        value: triangles,
        digits: 0,
        has_ratios: true,
        has_speedups: false,
        has_missed: true,
    },
    Figure {
        title: "Milliseconds to the mesh",
        value: milliseconds,
        digits: 1,
        has_ratios: true,
        has_speedups: true,
        has_missed: false,
    },
    Figure {
        title: "Thousand triangles a second",
        value: |cell| Some(triangles(cell)? / milliseconds(cell)?),
        digits: 0,
        has_ratios: false,
        has_speedups: false,
        has_missed: false,
    },
    Figure {
        title: "Smallest angle, degrees",
        value: |cell| Some(cell.mesh.as_ref().ok()?.min_angle),
        digits: 2,
        has_ratios: false,
        has_speedups: false,
        has_missed: false,
    },
    Figure {
        title: "Peak memory beyond the input, bytes a triangle",
        value: |cell| Some(peak(cell)? / triangles(cell)?),
        digits: 0,
        has_ratios: false,
        has_speedups: false,
        has_missed: false,
    },
];

/// Those whose figures ours are divided by.
const RIVALS: [Mesher; 2] = [Mesher::Triangle, Mesher::Cgal];

/// Returns the number of triangles.
pub fn triangles(cell: &Cell) -> Option<f64> {
    Some(cell.mesh.as_ref().ok()?.triangles as f64)
}

/// Returns the median time to the mesh.
pub fn milliseconds(cell: &Cell) -> Option<f64> {
    cell.mesh.as_ref().ok()?;
    Some(1e3 * median(cell.runs.iter().map(|run| run.seconds))?)
}

/// Returns the cell of a mesher.
pub fn find(group: &[Cell], mesher: Mesher) -> Option<&Cell> {
    group.iter().find(|cell| cell.mesher == mesher)
}

fn peak(cell: &Cell) -> Option<f64> {
    let known = cell.runs.iter().filter_map(|run| run.memory.as_ref());
    median(known.map(|memory| Memory::beyond_input(memory) as f64))
}

impl Report {
    /// Writes conditions and tables, ready for `BENCHMARKS.md`.
    pub fn to_markdown(&self) -> String {
        let mut text = String::new();
        self.write_markdown(&mut text)
            .expect("writing into a string cannot fail");
        text
    }

    fn write_markdown(&self, out: &mut String) -> std::fmt::Result {
        writeln!(out, "{}", self.heading)?;
        let contenders = self.heading.contenders.iter().cloned();
        writeln!(out, "{}", heading::table(contenders))?;
        writeln!(out, "Each mesh {}.\n", self.plan.effort.in_words())?;
        for &load in &self.plan.loads {
            writeln!(out, "### {}\n", title(load))?;
            let groups: Vec<_> = self.groups().filter(|g| g[0].load == load).collect();
            for figure in &FIGURES {
                let table = self.figure_table(figure, &groups);
                writeln!(out, "**{}**\n\n{table}", figure.title)?;
            }
            let aims = targets::table(load, &groups);
            writeln!(out, "**Ratios and what was aimed at**\n\n{aims}")?;
        }
        self.write_failures(out)
    }

    fn figure_table(&self, figure: &Figure, groups: &[&[Cell]]) -> Table {
        let meshers = self.plan.meshers.iter().map(Mesher::to_string);
        let rivals = self.rivals(figure);
        let parallel = self.parallel(figure);
        let names = ["outline", "segments", "angle"].map(str::to_owned);
        let ratios = rivals.iter().map(|rival| format!("to {rival}"));
        let speedups = parallel.iter().map(|mesher| format!("{mesher} speed-up"));
        let header = names.into_iter().chain(meshers).chain(ratios);
        let mut table = Table::new(header.chain(speedups));
        for group in groups {
            let Cell { outline, goal, .. } = &group[0];
            let mut row = vec![
                outline.domain.to_string(),
                size_name(outline.size),
                format!("{}°", goal.angle),
            ];
            let meshers = self.plan.meshers.iter();
            row.extend(meshers.map(|&mesher| text(find(group, mesher), figure)));
            let two_digits = |ratio: Option<f64>| dash(ratio.map(|r| format!("{r:.2}")));
            row.extend(
                rivals
                    .iter()
                    .map(|&rival| two_digits(ratio(group, figure.value, rival))),
            );
            row.extend(
                parallel
                    .iter()
                    .map(|&mesher| two_digits(ratio(group, figure.value, mesher))),
            );
            table.push(row);
        }
        table
    }

    fn rivals(&self, figure: &Figure) -> Vec<Mesher> {
        let present = RIVALS.into_iter().filter(|r| self.plan.meshers.contains(r));
        present.filter(|_| figure.has_ratios).collect()
    }

    fn parallel(&self, figure: &Figure) -> Vec<Mesher> {
        let meshers = self.plan.meshers.iter().copied();
        let is_parallel = |mesher: &Mesher| matches!(mesher, Mesher::Delone { threads: 2.. });
        let parallel = meshers.filter(is_parallel);
        parallel.filter(|_| figure.has_speedups).collect()
    }

    fn groups(&self) -> impl Iterator<Item = &[Cell]> {
        let key = |cell: &Cell| (cell.outline, cell.load, cell.goal.angle);
        self.cells.chunk_by(move |a, b| key(a) == key(b))
    }

    fn write_failures(&self, out: &mut String) -> std::fmt::Result {
        for cell in &self.cells {
            if let Err(Fault::Failed { how, message }) = &cell.mesh {
                let place = format!(
                    "{} at {}°, area {}",
                    cell.outline, cell.goal.angle, cell.load
                );
                writeln!(out, "- {} on {place}: {how}: {message}", cell.mesher)?;
            }
        }
        Ok(())
    }

    /// Returns everything that was found, every single run included. Times are in seconds, memory
    /// in bytes.
    pub fn to_json(&self) -> Value {
        json!({
            "heading": self.heading,
            "seed": self.plan.effort.seed,
            "warmups": self.plan.effort.warmups,
            "cells": self.cells.iter().map(cell_json).collect::<Vec<_>>(),
        })
    }
}

fn title(load: Load) -> String {
    match load {
        Load::AngleOnly => "A smallest angle alone".to_owned(),
        Load::About(triangles) => format!(
            "A smallest angle, and a largest area that makes about {} triangles",
            size_name(triangles)
        ),
    }
}

/// Writes a figure, or says why there is none.
fn text(cell: Option<&Cell>, figure: &Figure) -> String {
    let Some(cell) = cell else { return dash(None) };
    match &cell.mesh {
        Err(fault) => fault.in_short(),
        Ok(quality) => {
            let value = (figure.value)(cell);
            let text = dash(value.map(|value| format!("{value:.*}", figure.digits)));
            let missed = quality.skinny + quality.oversized;
            if figure.has_missed && missed > 0 {
                format!("{text} ({missed})")
            } else {
                text
            }
        }
    }
}

fn cell_json(cell: &Cell) -> Value {
    json!({
        "outline": cell.outline.domain.name(),
        "segments": cell.outline.size,
        "load": cell.load.to_string(),
        "goal": cell.goal,
        "mesher": cell.mesher.to_string(),
        "quality": cell.mesh.as_ref().ok(),
        "fault": cell.mesh.as_ref().err(),
        "runs": cell.runs,
    })
}

#[cfg(test)]
mod tests;
