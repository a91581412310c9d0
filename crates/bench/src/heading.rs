//! What stands above the tables of a report: the command, the machine, who takes part.

use crate::machine::Machine;
use crate::table::Table;
use serde::Serialize;
use std::fmt;

/// Under which conditions, and by whom, something was measured.
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
    pub timed: String,
}

/// Lists contenders.
pub fn table(contenders: impl IntoIterator<Item = Contender>) -> Table {
    let mut table = Table::new(["engine", "version", "timed"]).with_text_columns(3);
    for contender in contenders {
        table.push(vec![contender.name, contender.version, contender.timed]);
    }
    table
}

impl fmt::Display for Heading {
    /// Writes command and machine in Markdown.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "`{}`\n", self.command)?;
        for (label, value) in self.machine.entries() {
            writeln!(f, "- {label}: {value}")?;
        }
        Ok(())
    }
}
