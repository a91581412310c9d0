//! The tables in Markdown, and everything in JSON.
//!
//! *Ratio* is the time of ours on one thread over that of the fastest exact peer whose result was
//! right, on the same input in the same run. A number in brackets after a time is how many
//! triangles that result has too many or too few.

use crate::engines::Engine;
use crate::machine::{Machine, version_of};
use crate::measure::Memory;
use crate::plan::{Cell, Plan, Verdict};
use crate::process::Fault;
use crate::stats::{median, size_name};
use crate::subject::Task;
use crate::table::{Table, dash};
use serde_json::{Value, json};
use std::fmt::Write;

/// A finished measurement: what was done, where, and what came out.
#[derive(Clone, Debug)]
pub struct Report {
    /// What was asked for.
    pub plan: Plan,
    /// Under which conditions.
    pub machine: Machine,
    /// How the program was called.
    pub command: String,
    /// What came out, grouped by subject and size, engines in the plan's order.
    pub cells: Vec<Cell>,
}

/// What a table of times is about.
#[derive(Clone, Copy)]
enum Figure {
    /// Wall time in fresh processes.
    Fresh,
    /// Wall time of repeats in one process.
    Repeated,
    /// Processor time in fresh processes, all threads: what a busy machine disturbs least.
    Processor,
}

impl Figure {
    /// Returns the median time a point or segment, nanoseconds.
    fn nanoseconds(self, cell: &Cell) -> Option<f64> {
        let seconds = match self {
            Self::Fresh => median(cell.fresh.iter().map(|run| run.cost.seconds)),
            Self::Repeated => median(cell.repeated.iter().map(|run| run.cost.seconds)),
            Self::Processor => median(cell.fresh.iter().map(|run| run.cost.user + run.cost.system)),
        };
        Some(seconds? * 1e9 / cell.size as f64)
    }

    fn text(self, cell: &Cell) -> Option<String> {
        let nanoseconds = self.nanoseconds(cell)?;
        Some(match self {
            Self::Fresh | Self::Repeated => format!("{nanoseconds:.0}"),
            Self::Processor => split_text(cell, nanoseconds),
        })
    }
}

/// Writes a processor time as user + system, in the mean proportion of all runs: the kernel tells
/// the sum exactly, but the parts of a short run only by sampling.
fn split_text(cell: &Cell, nanoseconds: f64) -> String {
    let system: f64 = cell.fresh.iter().map(|run| run.cost.system).sum();
    let both: f64 = cell
        .fresh
        .iter()
        .map(|run| run.cost.user + run.cost.system)
        .sum();
    let system = if both > 0.0 {
        nanoseconds * system / both
    } else {
        0.0
    };
    format!("{:.0} + {system:.0}", nanoseconds - system)
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
        writeln!(out, "`{}`\n", self.command)?;
        for (label, value) in self.machine.entries() {
            writeln!(out, "- {label}: {value}")?;
        }
        writeln!(out, "\n{}", self.engine_table())?;
        let Plan {
            warmups,
            runs,
            repeats,
            ..
        } = self.plan;
        let unit = self.plan.task.unit();
        let fresh = format!("each in a fresh process (median of {runs} after {warmups} warm-ups)");
        self.write_times(out, &format!("ns a {unit}, {fresh}"), Figure::Fresh)?;
        if repeats > 0 {
            let repeated = format!("repeated in one process on new {unit}s (median of {repeats})");
            self.write_times(out, &format!("ns a {unit}, {repeated}"), Figure::Repeated)?;
        }
        let title = format!("Processor time in the fresh processes, user + system, ns a {unit}");
        self.write_times(out, &title, Figure::Processor)?;
        let title = format!("Peak memory beyond the input in the fresh processes, bytes a {unit}");
        writeln!(out, "**{title}**\n\n{}", self.memory_table())?;
        self.write_failures(out)
    }

    fn write_times(&self, out: &mut String, title: &str, figure: Figure) -> std::fmt::Result {
        writeln!(out, "**{title}**\n\n{}", self.time_table(figure))?;
        let ratios = self
            .groups()
            .filter_map(|group| Some((self.ratio(group, figure)?, &group[0])));
        let largest = ratios.max_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((ratio, Cell { subject, size, .. })) = largest {
            let size = size_name(*size);
            writeln!(out, "Largest ratio: {ratio:.2} ({subject} {size}).\n")?;
        }
        Ok(())
    }

    fn engine_table(&self) -> Table {
        let mut table =
            Table::new(["engine", "version", "predicates", "timed"]).with_text_columns(4);
        for engine in &self.plan.engines {
            let Some(facts) = engine.facts(self.plan.task) else {
                continue;
            };
            table.push(vec![
                engine.to_string(),
                version_of(engine.package()).to_owned(),
                if facts.exact { "exact" } else { "rounded" }.to_owned(),
                facts.timed.to_owned(),
            ]);
        }
        table
    }

    fn time_table(&self, figure: Figure) -> Table {
        // Threads do not save processor time.
        let parallel = match figure {
            Figure::Processor => Vec::new(),
            Figure::Fresh | Figure::Repeated => self.parallel_engines(),
        };
        let speedups = parallel.iter().map(|e| format!("{e} speed-up"));
        let extra = ["ratio".to_owned(), "to".to_owned()];
        self.table(extra.into_iter().chain(speedups), |group| {
            let cells = self.row(group, |cell| figure.text(cell));
            let ratio = self.ratio(group, figure).map(|ratio| format!("{ratio:.2}"));
            let rival = self
                .fastest_exact_peer(group, figure)
                .map(|(engine, _)| engine.to_string());
            let ours = time_of(group, ONE_THREAD, figure);
            let speedups = parallel.iter().map(|&engine| {
                let speedup = ours.zip(time_of(group, engine, figure));
                dash(speedup.map(|(one, many)| format!("{:.2}", one / many)))
            });
            cells
                .into_iter()
                .chain([dash(ratio), dash(rival)])
                .chain(speedups)
                .collect()
        })
    }

    fn memory_table(&self) -> Table {
        let extra = ["delone:1 beyond output too", "delone:1 process MB"];
        self.table(extra.map(str::to_owned), |group| {
            let cells = self.row(group, |cell| per_unit(cell, Memory::beyond_input));
            let ours = find(group, ONE_THREAD);
            let working = ours.and_then(|cell| per_unit(cell, Memory::beyond_output));
            let total = ours.and_then(|cell| memory(cell, |memory| memory.peak));
            let total = total.map(|bytes| format!("{:.0}", bytes / 1e6));
            let ours = [dash(working), dash(total)];
            cells.into_iter().chain(ours).collect()
        })
    }

    /// Returns a field for each engine, a dash for those that do not take the subject.
    fn row(&self, group: &[Cell], figure: impl Fn(&Cell) -> Option<String>) -> Vec<String> {
        let cells = self.plan.engines.iter().map(|&engine| find(group, engine));
        cells
            .map(|cell| dash(cell.map(|cell| marked(cell, figure(cell)))))
            .collect()
    }

    /// Makes a table of a row a group: its subject and size, and what `columns` says of it.
    fn table(
        &self,
        extra: impl IntoIterator<Item = String>,
        columns: impl Fn(&[Cell]) -> Vec<String>,
    ) -> Table {
        let engines = self.plan.engines.iter().map(Engine::to_string);
        let subject = match self.plan.task {
            Task::Points => "points",
            Task::Domain | Task::Crossings => "domain",
        };
        let names = [subject.to_owned(), "n".to_owned()];
        let mut table = Table::new(names.into_iter().chain(engines).chain(extra));
        for group in self.groups() {
            let Cell { subject, size, .. } = group[0];
            let mut row = vec![subject.to_string(), size_name(size)];
            row.extend(columns(group));
            table.push(row);
        }
        table
    }

    fn groups(&self) -> impl Iterator<Item = &[Cell]> {
        self.cells
            .chunk_by(|a, b| (a.subject, a.size) == (b.subject, b.size))
    }

    fn ratio(&self, group: &[Cell], figure: Figure) -> Option<f64> {
        let (_, theirs) = self.fastest_exact_peer(group, figure)?;
        Some(time_of(group, ONE_THREAD, figure)? / theirs)
    }

    fn fastest_exact_peer(&self, group: &[Cell], figure: Figure) -> Option<(Engine, f64)> {
        let is_exact = |engine: Engine| engine.facts(self.plan.task).is_some_and(|f| f.exact);
        group
            .iter()
            .filter(|cell| !cell.engine.is_ours() && is_exact(cell.engine))
            .filter(|cell| cell.verdict == Verdict::Right)
            .filter_map(|cell| Some((cell.engine, figure.nanoseconds(cell)?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
    }

    fn parallel_engines(&self) -> Vec<Engine> {
        let engines = self.plan.engines.iter().copied();
        engines
            .filter(|e| e.is_ours() && *e != ONE_THREAD)
            .collect()
    }

    fn write_failures(&self, out: &mut String) -> std::fmt::Result {
        for cell in &self.cells {
            if let Verdict::Faulty(Fault::Failed { how, message }) = &cell.verdict {
                let Cell {
                    engine, subject, ..
                } = cell;
                let size = size_name(cell.size);
                writeln!(out, "- {engine} on {subject} {size}: {how}: {message}")?;
            }
        }
        Ok(())
    }

    /// Returns everything that was found, every single run included. Times are in seconds, memory
    /// in bytes.
    pub fn to_json(&self) -> Value {
        json!({
            "command": self.command,
            "machine": self.machine,
            "seed": self.plan.seed,
            "warmups": self.plan.warmups,
            "engines": self.plan.engines.iter().map(|e| self.engine_json(*e)).collect::<Vec<_>>(),
            "cells": self.cells.iter().map(cell_json).collect::<Vec<_>>(),
        })
    }

    fn engine_json(&self, engine: Engine) -> Value {
        let facts = engine.facts(self.plan.task);
        json!({
            "engine": engine.to_string(),
            "package": engine.package(),
            "version": version_of(engine.package()),
            "exact": facts.map(|facts| facts.exact),
            "timed": facts.map(|facts| facts.timed),
        })
    }
}

const ONE_THREAD: Engine = Engine::Delone { threads: 1 };

fn find(group: &[Cell], engine: Engine) -> Option<&Cell> {
    group.iter().find(|cell| cell.engine == engine)
}

fn time_of(group: &[Cell], engine: Engine, figure: Figure) -> Option<f64> {
    figure.nanoseconds(find(group, engine)?)
}

/// Returns the median of something about the memory of the fresh runs.
fn memory(cell: &Cell, bytes: impl Fn(&Memory) -> u64) -> Option<f64> {
    let known = cell.fresh.iter().filter_map(|run| run.cost.memory.as_ref());
    median(known.map(|memory| bytes(memory) as f64))
}

fn per_unit(cell: &Cell, bytes: impl Fn(&Memory) -> u64) -> Option<String> {
    let bytes = memory(cell, bytes)?;
    Some(format!("{:.0}", bytes / cell.size as f64))
}

/// Adds to a figure what the check had to say, or says why there is none.
fn marked(cell: &Cell, figure: Option<String>) -> String {
    match &cell.verdict {
        Verdict::Right => dash(figure),
        Verdict::Wrong {
            triangles,
            expected,
        } => {
            let surplus = *triangles as i128 - *expected as i128;
            format!("{} ({surplus:+})", dash(figure))
        }
        Verdict::Faulty(fault) => fault.in_short(),
    }
}

fn cell_json(cell: &Cell) -> Value {
    json!({
        "subject": cell.subject,
        "size": cell.size,
        "engine": cell.engine.to_string(),
        "verdict": verdict_json(&cell.verdict),
        "fresh": cell.fresh,
        "repeated": cell.repeated,
    })
}

fn verdict_json(verdict: &Verdict) -> Value {
    match verdict {
        Verdict::Right => json!("right"),
        Verdict::Wrong {
            triangles,
            expected,
        } => json!({ "wrong": { "triangles": triangles, "expected": expected } }),
        Verdict::Faulty(fault) => json!(fault),
    }
}

#[cfg(test)]
mod tests {
    use super::{ONE_THREAD, Report};
    use crate::engines::Engine;
    use crate::machine::Machine;
    use crate::measure::{Cost, Memory, Run};
    use crate::plan::{Cell, Plan, Verdict};
    use crate::process::Fault;
    use crate::subject::{Subject, Task};
    use delone_samples::{Distribution, Domain};
    use std::time::Duration;

    const TWO_THREADS: Engine = Engine::Delone { threads: 2 };

    fn cell(engine: Engine, nanoseconds: f64, verdict: Verdict) -> Cell {
        let run = |factor: f64| Run {
            cost: Cost {
                seconds: factor * nanoseconds * 1e-9 * 1000.0,
                user: 0.002,
                system: 0.0005,
                memory: Some(Memory {
                    before: 1_000_000,
                    peak: 1_120_000,
                    after: 1_070_000,
                }),
            },
            triangles: 1990,
            constrained: None,
            hash: None,
        };
        Cell {
            subject: Distribution::Gauss.into(),
            size: 1000,
            engine,
            verdict,
            fresh: [2.0, 1.0, 0.9].map(run).to_vec(),
            repeated: vec![run(0.5)],
        }
    }

    fn report() -> Report {
        let wrong = Verdict::Wrong {
            triangles: 1987,
            expected: 1990,
        };
        let failed = Verdict::Faulty(Fault::failed("panic", "index out of bounds"));
        let dead = |engine, verdict| Cell {
            fresh: Vec::new(),
            repeated: Vec::new(),
            ..cell(engine, 0.0, verdict)
        };
        let cells = vec![
            cell(ONE_THREAD, 110.0, Verdict::Right),
            cell(TWO_THREADS, 55.0, Verdict::Right),
            cell(Engine::Spade, 400.0, Verdict::Right),
            cell(Engine::Delaunator, 200.0, Verdict::Right),
            cell(Engine::Cdt, 100.0, wrong),
            dead(Engine::SpadeStable, failed),
            dead(
                Engine::SimpleDelaunay,
                Verdict::Faulty(Fault::TimedOut(Duration::from_secs(60))),
            ),
        ];
        Report {
            plan: Plan {
                engines: cells.iter().map(|cell| cell.engine).collect(),
                task: Task::Points,
                subjects: vec![Distribution::Gauss.into()],
                sizes: vec![1000],
                seed: 1,
                warmups: 2,
                runs: 3,
                repeats: 1,
                timeout: Duration::from_secs(60),
            },
            machine: Machine::inspect(),
            command: "delone-bench --quick".to_owned(),
            cells,
        }
    }

    /// Returns the trimmed fields of the first row for gauss in the section of `title`.
    fn row(markdown: &str, title: &str) -> Vec<String> {
        let section = &markdown[markdown.find(title).expect(title)..];
        let row = section.lines().find(|line| line.starts_with("| gauss"));
        let fields = row.expect("a row").trim_matches('|').split('|');
        fields.map(|field| field.trim().to_owned()).collect()
    }

    #[test]
    fn times_are_medians_and_the_ratio_is_to_the_fastest_exact_right_peer() {
        let markdown = report().to_markdown();
        assert_eq!(
            row(&markdown, "ns a point, each in a fresh"),
            [
                "gauss", "1k", "110", "55", "400", "200", "100 (-3)", "panic", "> 60 s", "0.28",
                "spade", "2.00"
            ]
        );
        assert_eq!(row(&markdown, "repeated in one")[2..5], ["55", "28", "200"]);
        assert!(markdown.contains("Largest ratio: 0.28 (gauss 1k)."));
    }

    #[test]
    fn memory_and_processor_time() {
        let markdown = report().to_markdown();
        let memory = row(&markdown, "Peak memory");
        assert_eq!(memory[2], "120");
        assert_eq!(memory[memory.len() - 2..], ["50", "1"]);
        assert_eq!(row(&markdown, "Processor time")[2], "2000 + 500");
        assert_eq!(row(&markdown, "Processor time")[9..], ["1.00", "spade"]);
    }

    #[test]
    fn failures_are_told_in_full() {
        let markdown = report().to_markdown();
        assert!(markdown.contains("- spade-stable on gauss 1k: panic: index out of bounds"));
        let rounded = markdown.lines().filter(|line| line.contains("| rounded "));
        assert!(
            rounded
                .map(|line| line.starts_with("| delaunator "))
                .eq([true])
        );
    }

    #[test]
    fn json_keeps_every_run() {
        let json = report().to_json();
        assert_eq!(json["cells"][0]["fresh"].as_array().map(Vec::len), Some(3));
        assert_eq!(json["cells"][4]["verdict"]["wrong"]["expected"], 1990);
        assert_eq!(json["engines"][3]["exact"], false);
    }
    #[test]
    fn domains_count_segments_and_dash_out_who_does_not_take_them() {
        let mut report = report();
        report.plan.task = Task::Domain;
        report.plan.engines = vec![ONE_THREAD, Engine::Spade, Engine::Cdt];
        report.plan.subjects = vec![Subject::from(Domain::Segments)];
        report.cells = [(ONE_THREAD, 100.0), (Engine::Spade, 400.0)]
            .map(|(engine, time)| Cell {
                subject: Domain::Segments.into(),
                ..cell(engine, time, Verdict::Right)
            })
            .to_vec();
        let markdown = report.to_markdown();
        let row = markdown.lines().find(|line| line.starts_with("| segments"));
        let fields: Vec<_> = row.unwrap().split('|').map(str::trim).collect();
        assert_eq!(fields[3..8], ["100", "400", "–", "0.25", "spade"]);
        assert!(markdown.contains("ns a segment, each in") && markdown.contains("| domain "));
        assert!(markdown.contains("bulk_load_cdt"));
    }
}
