//! The contenders: one small file each, behind one trait.
//!
//! Each gets its points in the type that it wants before the clock starts, and the clock stops
//! when it hands out triangles and, where it has them, neighbours. A further peer is a further
//! file and a further arm in [`Engine`].

mod cdt;
mod delaunator;
mod ours;
mod simple_delaunay;
mod spade;

use crate::measure::{Run, measure};
use std::fmt;
use std::str::FromStr;

/// Something that triangulates.
pub trait Contender {
    /// The caller's array, as this engine wants it.
    type Input;
    /// What the engine hands out.
    type Output;

    /// Converts the points; not timed. In place where layouts agree, so that no freed memory is
    /// left over for the engine.
    fn prepare(&self, points: Vec<[f64; 2]>) -> Self::Input;

    /// Triangulates; this is what is timed. Dropping what is left of `input` is not.
    ///
    /// # Errors
    /// Whatever the engine says, as text.
    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String>;

    /// Counts the finite triangles.
    fn num_triangles(&self, output: &Self::Output) -> usize;

    /// Names the set of triangles, if the engine can; not timed.
    fn hash(&self, output: &Self::Output) -> Option<String> {
        let _ = output;
        None
    }

    /// Checks the output as thoroughly as the engine can check itself; not timed.
    ///
    /// # Errors
    /// What is wrong.
    fn verify(&self, output: &Self::Output) -> Result<(), String> {
        let _ = output;
        Ok(())
    }
}

/// Which contender, with its settings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Engine {
    /// This project, on so many threads.
    Delone {
        /// Number of threads.
        threads: usize,
    },
    /// `spade`'s bulk load, which may reorder the vertices.
    Spade,
    /// `spade`'s bulk load that keeps the caller's numbering.
    SpadeStable,
    /// `delaunator`, whose in-circle test is rounded.
    Delaunator,
    /// `cdt` of the Foxtrot project; hands out triangles without neighbours.
    Cdt,
    /// `simple_delaunay_lib`, incremental along a Hilbert curve.
    SimpleDelaunay,
}

/// What a table must say of an engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facts {
    /// The crate's name.
    pub package: &'static str,
    /// Are both predicates exact?
    pub exact: bool,
    /// What is called, and what it hands out.
    pub timed: &'static str,
}

impl Engine {
    /// The peers, in the order of the table.
    pub const PEERS: [Self; 5] = [
        Self::Spade,
        Self::SpadeStable,
        Self::Delaunator,
        Self::Cdt,
        Self::SimpleDelaunay,
    ];

    /// Returns what a table must say of the engine.
    pub const fn facts(self) -> Facts {
        let (package, exact, timed) = match self {
            Self::Delone { .. } => (
                "delone",
                true,
                "`Delaunay::triangulate`: triangles and neighbours, caller's numbering",
            ),
            Self::Spade => (
                "spade",
                true,
                "`bulk_load`: half-edges, own vertex numbering; takes the points over",
            ),
            Self::SpadeStable => (
                "spade",
                true,
                "`bulk_load_stable`: half-edges, caller's numbering; takes the points over",
            ),
            Self::Delaunator => (
                "delaunator",
                false,
                "`triangulate`: triangles and half-edges, caller's numbering",
            ),
            Self::Cdt => (
                "cdt",
                true,
                "`triangulate_points`: triangles only, caller's numbering",
            ),
            Self::SimpleDelaunay => (
                "simple_delaunay_lib",
                true,
                "`insert_vertices` along a Hilbert curve: half-edges, caller's numbering",
            ),
        };
        Facts {
            package,
            exact,
            timed,
        }
    }

    /// Tells whether this is the project itself.
    pub const fn is_ours(self) -> bool {
        matches!(self, Self::Delone { .. })
    }

    /// Triangulates `points` once under the clock; checks the result afterwards if `verify`.
    ///
    /// # Errors
    /// What the engine, or its verification, says.
    pub fn run(self, points: Vec<[f64; 2]>, verify: bool) -> Result<Run, String> {
        match self {
            Self::Delone { threads } => measure(&ours::Ours { threads }, points, verify),
            Self::Spade => measure(&spade::Spade::Bulk, points, verify),
            Self::SpadeStable => measure(&spade::Spade::Stable, points, verify),
            Self::Delaunator => measure(&delaunator::Delaunator, points, verify),
            Self::Cdt => measure(&cdt::Cdt, points, verify),
            Self::SimpleDelaunay => measure(&simple_delaunay::SimpleDelaunay, points, verify),
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Delone { threads } => write!(f, "delone:{threads}"),
            Self::SpadeStable => f.write_str("spade-stable"),
            peer => f.write_str(peer.facts().package),
        }
    }
}

/// A name that no engine has.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("no engine is called `{given}`; there are delone:THREADS, {}", names())]
pub struct UnknownEngine {
    given: String,
}

fn names() -> String {
    Engine::PEERS.map(|engine| engine.to_string()).join(", ")
}

impl FromStr for Engine {
    type Err = UnknownEngine;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let ours = || {
            let threads = name.strip_prefix("delone:")?.parse().ok()?;
            (threads > 0).then_some(Self::Delone { threads })
        };
        let peer = || Self::PEERS.into_iter().find(|e| e.to_string() == name);
        ours().or_else(peer).ok_or_else(|| UnknownEngine {
            given: name.to_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::Engine;
    use crate::distributions::Distribution;
    use crate::expected;

    #[test]
    fn names_parse_back() {
        let ours = [1, 2, 16].map(|threads| Engine::Delone { threads });
        for engine in ours.into_iter().chain(Engine::PEERS) {
            assert_eq!(engine.to_string().parse(), Ok(engine));
        }
        for wrong in ["delone", "delone:0", "delone:x", "qhull"] {
            assert!(wrong.parse::<Engine>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn everyone_counts_the_triangles_that_euler_demands() {
        let points = Distribution::Uniform.points(500, 11);
        let ours = [1, 2].map(|threads| Engine::Delone { threads });
        for engine in ours.into_iter().chain(Engine::PEERS) {
            let run = engine.run(points.clone(), true).unwrap();
            assert_eq!(run.triangles, expected::num_triangles(&points), "{engine}");
            assert_eq!(run.hash.is_some(), engine.is_ours(), "{engine}");
        }
    }
}
