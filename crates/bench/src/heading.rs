//! What stands above the tables of a report: the command, the machine, who takes part.

use crate::machine::Machine;
use crate::table::Table;
use serde::Serialize;
use std::fmt;

/// Under which conditions something was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Heading {
    /// How the program was called.
    pub command: String,
    /// On which machine.
    pub machine: Machine,
    /// Who takes part, in the order of the tables.
    pub contenders: Vec<Contender>,
}

/// Someone who takes part.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Contender {
    /// Its name in the tables.
    pub name: String,
    /// Which version it is.
    pub version: String,
    /// What is called.
    pub timed: &'static str,
}

impl Heading {
    fn table(&self) -> Table {
        let mut table = Table::new(["engine", "version", "timed"]).with_text_columns(3);
        for Contender {
            name,
            version,
            timed,
        } in &self.contenders
        {
            table.push(vec![name.clone(), version.clone(), (*timed).to_owned()]);
        }
        table
    }
}

impl fmt::Display for Heading {
    /// Writes Markdown.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "`{}`\n", self.command)?;
        for (label, value) in self.machine.entries() {
            writeln!(f, "- {label}: {value}")?;
        }
        writeln!(f, "\n{}", self.table())
    }
}
