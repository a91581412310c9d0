//! The contenders: one small file each, behind one trait.
//!
//! Each gets its points and segments in the types that it wants before the clock starts, and the
//! clock stops when it hands out triangles and, where it has them, neighbours. A further peer is a
//! further file, a further variant of [`Engine`], and a row of [`Engine::facts`] for each task.

mod cdt;
mod delaunator;
mod facts;
mod ghx;
mod i_triangle;
mod ours;
mod poly2tri;
mod simple_delaunay;
mod spade;

pub use facts::{Extent, Facts};

use crate::measure::{Run, measure};
use crate::subject::{Subject, Task};
use delone::SegmentPolicy;
use delone_samples::Drawing;
use std::fmt;
use std::str::FromStr;

/// Something that triangulates.
pub trait Contender {
    /// The caller's arrays, as this engine wants them.
    type Input;
    /// What the engine hands out.
    type Output;

    /// Converts points and segments; not timed. In place where layouts agree, so that no freed
    /// memory is left over for the engine.
    fn prepare(&self, drawing: Drawing) -> Self::Input;

    /// Triangulates; this is what is timed. Dropping what is left of `input` is not.
    ///
    /// # Errors
    /// Whatever the engine says, as text.
    fn triangulate(&self, input: &mut Self::Input) -> Result<Self::Output, String>;

    /// Counts the finite triangles.
    fn num_triangles(&self, output: &Self::Output) -> usize;

    /// Counts the constrained edges, if the engine knows them; not timed.
    fn num_constrained(&self, output: &Self::Output) -> Option<usize> {
        let _ = output;
        None
    }

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
    /// `i_triangle`, which snaps rings to an integer lattice.
    ITriangle,
    /// `poly2tri-rs`, for rings, with tolerances.
    Poly2Tri,
    /// `ghx_constrained_delaunay`, with tolerances.
    Ghx,
}

impl Engine {
    /// The peers, in the order of the table.
    pub const PEERS: [Self; 8] = [
        Self::Spade,
        Self::SpadeStable,
        Self::Delaunator,
        Self::Cdt,
        Self::SimpleDelaunay,
        Self::ITriangle,
        Self::Poly2Tri,
        Self::Ghx,
    ];

    /// Returns the name of the engine's crate.
    pub const fn package(self) -> &'static str {
        match self {
            Self::Delone { .. } => "delone",
            Self::Spade | Self::SpadeStable => "spade",
            Self::Delaunator => "delaunator",
            Self::Cdt => "cdt",
            Self::SimpleDelaunay => "simple_delaunay_lib",
            Self::ITriangle => "i_triangle",
            Self::Poly2Tri => "poly2tri-rs",
            Self::Ghx => "ghx_constrained_delaunay",
        }
    }

    /// Tells whether the engine can triangulate `subject`.
    pub fn takes(self, subject: Subject) -> bool {
        let facts = self.facts(subject.task());
        facts.is_some_and(|facts| facts.extent != Extent::OnlyRings || subject.is_ring())
    }

    /// Tells whether this is the project itself.
    pub const fn is_ours(self) -> bool {
        matches!(self, Self::Delone { .. })
    }

    /// Does `task` on `drawing` once under the clock; checks the result afterwards if `verify`.
    ///
    /// # Errors
    /// What the engine, or its verification, says; or that it cannot do this.
    pub fn run(self, task: Task, drawing: Drawing, verify: bool) -> Result<Run, String> {
        match task {
            Task::Points => self.run_on_points(drawing, verify),
            Task::Domain => self.run_on_domain(drawing, verify),
            Task::Crossings => self.run_on_crossings(drawing, verify),
        }
    }

    fn run_on_points(self, points: Drawing, verify: bool) -> Result<Run, String> {
        match self {
            Self::Delone { threads } => measure(&ours::Points { threads }, points, verify),
            Self::Spade => measure(&spade::Spade::Bulk, points, verify),
            Self::SpadeStable => measure(&spade::Spade::Stable, points, verify),
            Self::Delaunator => measure(&delaunator::Delaunator, points, verify),
            Self::Cdt => measure(&cdt::Cdt::Points, points, verify),
            Self::SimpleDelaunay => measure(&simple_delaunay::SimpleDelaunay, points, verify),
            other => Err(format!("{other} needs segments")),
        }
    }

    fn run_on_domain(self, domain: Drawing, verify: bool) -> Result<Run, String> {
        match self {
            Self::Delone { threads } => {
                let crossings = SegmentPolicy::Error;
                measure(&ours::Segments { threads, crossings }, domain, verify)
            }
            Self::Spade => measure(&spade::Constrained::Bulk, domain, verify),
            Self::Cdt => measure(&cdt::Cdt::Inside, domain, verify),
            Self::ITriangle => measure(&i_triangle::ITriangle, domain, verify),
            Self::Poly2Tri => measure(&poly2tri::Poly2Tri, domain, verify),
            Self::Ghx => measure(&ghx::Ghx, domain, verify),
            other => Err(format!("{other} takes no segments")),
        }
    }

    fn run_on_crossings(self, domain: Drawing, verify: bool) -> Result<Run, String> {
        match self {
            Self::Delone { threads } => {
                let crossings = SegmentPolicy::Split;
                measure(&ours::Segments { threads, crossings }, domain, verify)
            }
            Self::Spade => measure(&spade::Constrained::Split, domain, verify),
            other => Err(format!("{other} does not split segments")),
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Delone { threads } => write!(f, "delone:{threads}"),
            Self::SpadeStable => f.write_str("spade-stable"),
            peer => f.write_str(peer.package()),
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
    use crate::expected::Expected;
    use crate::subject::{Subject, Task};
    use delone_samples::{Distribution, Domain};

    fn everyone() -> impl Iterator<Item = Engine> {
        let ours = [1, 2].map(|threads| Engine::Delone { threads });
        ours.into_iter().chain(Engine::PEERS)
    }

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
    fn exact_engines_find_the_triangles_and_edges_that_there_must_be() {
        let subjects = [
            Subject::from(Distribution::Uniform),
            Domain::Segments.into(),
            Domain::Coast.into(),
            Domain::Spiral.into(),
        ];
        for subject in subjects {
            let drawing = subject.make(500, 11);
            let task = subject.task();
            let exact = |engine: &Engine| engine.facts(task).is_some_and(|facts| facts.exact);
            // Whoever has tolerances may lose a triangle even here: ghx does.
            let exact = everyone().filter(exact);
            for engine in exact.filter(|engine| engine.takes(subject)) {
                let run = engine.run(task, drawing.clone(), true).unwrap();
                let expected = Expected::of(engine, subject, &drawing).unwrap();
                assert_eq!(run.triangles, expected.triangles, "{engine} on {subject}");
                assert!(
                    run.constrained.is_none_or(|n| n == expected.constrained),
                    "{engine} on {subject}"
                );
                assert_eq!(run.hash.is_some(), engine.is_ours(), "{engine}");
            }
        }
    }

    #[test]
    fn crossings_become_vertices() {
        let subject = Subject::from(Domain::Tangle);
        let drawing = subject.make(100, 11);
        for engine in everyone().filter(|engine| engine.takes(subject)) {
            let run = engine.run(subject.task(), drawing.clone(), true).unwrap();
            assert!(run.constrained.is_some_and(|n| n > 500), "{engine}");
        }
    }

    #[test]
    fn whoever_has_no_facts_refuses() {
        for task in Task::ALL {
            for engine in everyone().filter(|engine| engine.facts(task).is_none()) {
                let drawing = Subject::from(Domain::Coast).make(10, 1);
                assert!(engine.run(task, drawing, false).is_err(), "{engine}");
            }
        }
        assert!(!Engine::Cdt.takes(Domain::Segments.into()));
        assert!(Engine::Cdt.takes(Domain::Coast.into()));
    }
}
