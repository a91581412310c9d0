//! The tables of files in Markdown.

use super::engine::Engine;
use super::job::Deed;
use super::plan::{Cell, Plan};
use crate::heading::{self, Heading};
use crate::stats::{median, size_name};
use crate::table::{Table, dash};
use std::fmt::{self, Write};

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

impl Report {
    /// Writes conditions and tables, ready for `BENCHMARKS.md`.
    pub fn to_markdown(&self) -> String {
        let mut text = String::new();
        self.write(&mut text)
            .expect("writing into a string cannot fail");
        text
    }

    fn write(&self, out: &mut String) -> fmt::Result {
        writeln!(out, "{}", self.heading)?;
        let contenders = self.heading.contenders.iter().cloned();
        writeln!(out, "{}", heading::table(contenders))?;
        let words = self.plan.effort.in_words();
        writeln!(out, "Seconds; {words}. All read what Delone has written.\n")?;
        if !self.plan.endings.is_empty() {
            let size = size_name(self.plan.size);
            writeln!(out, "**A mesh of {size} points**\n\n{}", self.meshes())?;
        }
        if !self.plan.clouds.is_empty() {
            writeln!(out, "**Clouds of points**\n\n{}", self.clouds())?;
        }
        Ok(())
    }

    fn meshes(&self) -> Table {
        let header = [
            "format", "MB", "write", "meshio", "ratio", "read", "meshio", "ratio",
        ];
        let mut table = Table::new(header.map(String::from));
        for ending in &self.plan.endings {
            let mut row = vec![format!(".{ending}"), self.megabytes(ending)];
            row.extend(self.beside(ending, Deed::Write, Engine::Meshio));
            row.extend(self.beside(ending, Deed::Read, Engine::Meshio));
            table.push(row);
        }
        table
    }

    fn clouds(&self) -> Table {
        let header = ["file", "MB", "points", "read", "laspy", "ratio"];
        let mut table = Table::new(header.map(String::from));
        for cloud in &self.plan.clouds {
            let name = cloud.display().to_string();
            let points = self.cell(&name, Deed::Points, Engine::Delone);
            let points = points.and_then(|c| c.runs.as_ref().ok()?.first().map(|a| a.points));
            let short = cloud.file_name().unwrap_or_default().display().to_string();
            let mut row = vec![short, self.megabytes(&name), dash(points.map(size_name))];
            row.extend(self.beside(&name, Deed::Points, Engine::Laspy));
            table.push(row);
        }
        table
    }

    /// Ours, theirs, and their ratio.
    fn beside(&self, name: &str, deed: Deed, peer: Engine) -> [String; 3] {
        let of = |engine| self.cell(name, deed, engine);
        let said = |cell: Option<&Cell>| {
            dash(cell.map(|cell| match &cell.runs {
                Ok(_) => dash(seconds(cell).map(|s| format!("{s:.3}"))),
                Err(fault) => fault.in_short(),
            }))
        };
        let (ours, theirs) = (of(Engine::Delone), of(peer));
        let ratio = ours.and_then(seconds).zip(theirs.and_then(seconds));
        let ratio = ratio.map(|(ours, theirs)| format!("{:.2}", ours / theirs));
        [said(ours), said(theirs), dash(ratio)]
    }

    fn megabytes(&self, name: &str) -> String {
        let mut ours = self
            .cells
            .iter()
            .filter(|c| (&*c.name, c.engine) == (name, Engine::Delone));
        dash(
            ours.next()
                .map(|cell| format!("{:.1}", cell.bytes as f64 * 1e-6)),
        )
    }

    fn cell(&self, name: &str, deed: Deed, engine: Engine) -> Option<&Cell> {
        let is_it = |c: &&Cell| (&*c.name, c.deed, c.engine) == (name, deed, engine);
        self.cells.iter().find(is_it)
    }
}

fn seconds(cell: &Cell) -> Option<f64> {
    median(cell.runs.as_ref().ok()?.iter().map(|run| run.cost.seconds))
}

#[cfg(test)]
pub(super) mod tests {
    use super::super::job::Answer;
    use super::{Cell, Deed, Engine, Heading, Plan, Report};
    use crate::effort::Effort;
    use crate::machine::Machine;
    use crate::measure::Cost;
    use crate::process::Fault;
    use std::time::Duration;

    pub fn answer(points: usize, seconds: f64) -> Answer {
        Answer {
            cost: Cost {
                seconds,
                user: seconds,
                system: 0.0,
                memory: None,
            },
            points,
            triangles: 2 * points,
        }
    }

    pub fn plan() -> Plan {
        Plan {
            engines: Engine::ALL.to_vec(),
            endings: ["vtu", "npy"].map(String::from).to_vec(),
            size: 100,
            clouds: vec!["cloud.laz".into()],
            effort: Effort {
                runs: 2,
                warmups: 1,
                seed: 1,
                timeout: Duration::from_secs(60),
            },
        }
    }

    #[test]
    fn tables_have_medians_ratios_and_faults() {
        let cell = |name: &str, engine, deed, runs| Cell {
            name: name.to_owned(),
            engine,
            deed,
            bytes: 2_500_000,
            runs,
        };
        let took = |times: [f64; 3]| Ok(times.map(|s| answer(100, s)).to_vec());
        let [delone, meshio, laspy] = Engine::ALL;
        let cells = vec![
            cell("vtu", delone, Deed::Write, took([0.5, 0.25, 9.0])),
            cell("vtu", meshio, Deed::Write, took([1.0, 1.0, 1.0])),
            cell("vtu", delone, Deed::Read, took([1.0, 1.0, 1.0])),
            cell("vtu", meshio, Deed::Read, Err(Fault::failed("error", ""))),
            cell("npy", delone, Deed::Write, took([0.125, 0.125, 0.125])),
            cell("cloud.laz", delone, Deed::Points, took([1.0, 1.0, 1.0])),
            cell("cloud.laz", laspy, Deed::Points, took([4.0, 4.0, 4.0])),
        ];
        let heading = Heading {
            command: "delone-bench files".to_owned(),
            machine: Machine::inspect(),
            contenders: Vec::new(),
        };
        let report = Report {
            plan: plan(),
            heading,
            cells,
        };
        let text = report.to_markdown();
        for row in [
            "| .vtu   | 2.5 | 0.500 |  1.000 |  0.50 | 1.000 |  error |     – |",
            "| .npy   | 2.5 | 0.125 |      – |     – |     – |      – |     – |",
            "| cloud.laz | 2.5 |    100 | 1.000 | 4.000 |  0.25 |",
        ] {
            assert!(text.contains(row), "{row}\n{text}");
        }
    }
}
