//! Who takes part, as far as reports and the search for Python must know.

use crate::heading::Contender;
use crate::python::Python;
use std::fmt::Display;

/// Someone who takes part; its name is what it displays.
pub trait Peer: Copy + Display {
    /// Returns the name of the Python package that it comes in, if it does.
    fn python_package(self) -> Option<&'static str>;

    /// Returns the version in `Cargo.lock`, if it is not from Python.
    fn crate_version(self) -> Option<&'static str>;

    /// Says what is called, and what it is asked for.
    fn timed(self) -> String;

    /// Describes it for the heading of a report.
    fn contender(self, python: Option<&Python>) -> Contender {
        let theirs = || python?.version(self.python_package()?);
        let version = self.crate_version().or_else(theirs);
        Contender {
            name: self.to_string(),
            version: version.unwrap_or("unknown").to_owned(),
            timed: self.timed(),
        }
    }
}
