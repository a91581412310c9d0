//! The classical algorithms, faithful to their texts, one file each, and every step observable.
//!
//! They are here to be studied, watched and compared; [`triangulate`](crate::triangulate) is faster than any
//! of them. All work on one half-edge mesh, all decisions are exact, and ties are broken by the
//! canonical perturbation: so all that claim a Delaunay triangulation end in the same one.
//!
//! - [`Algorithm`]: their list; [`About`]: source, idea, cost, guarantees, pseudocode.
//! - [`Input`]: points, or a domain, or a triangulation to begin with, and what they may be told.
//! - [`Output`]: triangles, and their hash.
//! - [`EdgeTables`]: triangles and edges as a thesis numbers and prints them.
//!
//! ```
//! use delone::classic::{Algorithm, Input};
//! use delone::Log;
//!
//! let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)];
//! let input = Input::from_points(points);
//! let mut log = Log::new("incremental", input.pslg.points.clone());
//! let output = Algorithm::Incremental.observe(&input, &mut log)?;
//! assert_eq!(output.hash(), delone::triangulate(points)?.hash());
//! assert_eq!(log.last_scene()?.hash(), output.hash());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod about;
mod adopting;
mod board;
mod bounding;
mod bowyer_watson;
mod cline_renka;
mod conflicts;
mod constrained;
mod convex_hull;
mod covering;
mod divide;
mod edge_flip;
mod flip_list;
mod fortune;
mod greedy_flips;
mod incremental;
mod input;
mod inside;
mod joining;
mod opening;
mod output;
mod printed_sweep;
mod random_incremental;
mod refinement;
mod restoring;
mod searching;
mod segment_walk;
mod segments;
mod start;
mod sweep;
mod sweep_circle;
mod swept;
mod thesis;

pub use crate::tables::EdgeTables;
pub use about::{About, Takes};
use board::Board;
pub use bounding::{bounding_triangle, printed_bounding_triangle};
pub use input::Input;
use input::Sites;
pub use output::Output;

use crate::observe::{ascending, sides, smallest_first};
use crate::{Error, Observer};

/// The algorithms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Algorithm {
    /// The thesis' plane sweep, corrected: segments inserted, what lies outside of the domain removed.
    Sweep,
    /// The thesis' sweep as it is printed, which says where it fails.
    PrintedSweep,
    /// The thesis' flips: the marked edge of lowest number first.
    EdgeFlip,
    /// The thesis' refinement: longest edges, then skinniest triangles.
    Thesis,
    /// The slides' insertion: a walk along the segment from the vertex before, and a stack.
    SegmentWalk,
    /// The lecture's greedy flips, as stated: a search for every flip.
    GreedyFlips,
    /// The lecture's greedy flips with a list of suspects.
    FlipList,
    /// The lecture's incremental construction, points in the given order.
    Incremental,
    /// The lecture's incremental construction, points in random order.
    RandomIncremental,
    /// The chapter's convex hull.
    ConvexHull,
    /// The chapter's triangulation, after Cline and Renka.
    ClineRenka,
    /// The chapter's Algorithm A: clusters in an outer polygon, enough data in every triangle.
    AlgorithmA,
    /// The chapter's Algorithm B: vertices on edges.
    AlgorithmB,
    /// The chapter's Algorithm C: vertices in triangles that hold too many data.
    AlgorithmC,
    /// For comparison: Bowyer and Watson's.
    BowyerWatson,
    /// For comparison: Sinclair's sweep circle, points by their distance from the middle.
    SweepCircle,
    /// For comparison: Fortune's sweep, whose front is made of parabolas.
    Fortune,
    /// For comparison: the divide and conquer that this library builds with.
    DivideAndConquer,
    /// This library's insertion of segments, and its carving.
    Constrained,
    /// This library's refinement.
    Refinement,
}

impl Algorithm {
    /// All of them, by source.
    pub const ALL: &[Self] = &[
        Self::Sweep,
        Self::PrintedSweep,
        Self::EdgeFlip,
        Self::Thesis,
        Self::SegmentWalk,
        Self::GreedyFlips,
        Self::FlipList,
        Self::Incremental,
        Self::RandomIncremental,
        Self::ConvexHull,
        Self::ClineRenka,
        Self::AlgorithmA,
        Self::AlgorithmB,
        Self::AlgorithmC,
        Self::BowyerWatson,
        Self::SweepCircle,
        Self::Fortune,
        Self::DivideAndConquer,
        Self::Constrained,
        Self::Refinement,
    ];

    /// Finds an algorithm by its [name](About::name).
    pub fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter().copied();
        all.find(|algorithm| algorithm.about().name == name)
    }

    /// Describes it.
    pub fn about(self) -> &'static About {
        match self {
            Self::Sweep => &sweep::ABOUT,
            Self::PrintedSweep => &printed_sweep::ABOUT,
            Self::EdgeFlip => &edge_flip::ABOUT,
            Self::Thesis => &thesis::ABOUT,
            Self::SegmentWalk => &segment_walk::ABOUT,
            Self::GreedyFlips => &greedy_flips::ABOUT,
            Self::FlipList => &flip_list::ABOUT,
            Self::Incremental => &incremental::ABOUT,
            Self::RandomIncremental => &random_incremental::ABOUT,
            Self::ConvexHull => &convex_hull::ABOUT,
            Self::ClineRenka => &cline_renka::ABOUT,
            Self::AlgorithmA => &covering::A,
            Self::AlgorithmB => &covering::B,
            Self::AlgorithmC => &covering::C,
            Self::BowyerWatson => &bowyer_watson::ABOUT,
            Self::SweepCircle => &sweep_circle::ABOUT,
            Self::Fortune => &fortune::ABOUT,
            Self::DivideAndConquer => &divide::ABOUT,
            Self::Constrained => &constrained::ABOUT,
            Self::Refinement => &refinement::ABOUT,
        }
    }

    /// Tells whether it refines a domain: adds vertices until the mesh is as good as [`Input::quality`] asks.
    pub fn refines(self) -> bool {
        matches!(self, Self::Thesis | Self::Refinement)
    }

    /// Runs it, without being observed.
    ///
    /// # Errors
    /// As [`observe`](Self::observe).
    pub fn run(self, input: &Input) -> Result<Output, Error> {
        self.observe(input, &mut ())
    }

    /// Runs it, and tells `observer` of each step.
    ///
    /// # Errors
    /// [`Error::NotFinite`], [`Error::TooManyPoints`]: what every builder refuses; [`Error::NotTaken`] if the
    /// input has what this algorithm does not [take](About::takes); of a domain what
    /// [`ConstrainedDelaunay`](crate::ConstrainedDelaunay::triangulate) refuses, crossings included;
    /// [`Error::BadTriangle`], [`Error::BadStart`] name a triangle that is wrong; [`Error::TooManyVertices`] if
    /// refinement does not end soon; for data what [`Cover`](crate::scattered::Cover::cover) refuses;
    /// [`Error::Cancelled`].
    pub fn observe(
        self,
        input: &Input,
        observer: &mut (impl Observer + Send),
    ) -> Result<Output, Error> {
        self.about().require_taken(input)?;
        match self {
            Self::Sweep => sweep::run(input, observer),
            Self::PrintedSweep => printed_sweep::run(input, observer),
            Self::EdgeFlip => edge_flip::run(input, observer),
            Self::Thesis => thesis::run(input, observer),
            Self::SegmentWalk => segment_walk::run(input, observer),
            Self::GreedyFlips => greedy_flips::run(input, observer),
            Self::FlipList => flip_list::run(input, observer),
            Self::Incremental => incremental::run(input, observer),
            Self::RandomIncremental => random_incremental::run(input, observer),
            Self::ConvexHull => convex_hull::run(input, observer),
            Self::ClineRenka => cline_renka::run(input, observer),
            Self::AlgorithmA => covering::run_a(input, observer),
            Self::AlgorithmB => covering::run_b(input, observer),
            Self::AlgorithmC => covering::run_c(input, observer),
            Self::BowyerWatson => bowyer_watson::run(input, observer),
            Self::SweepCircle => sweep_circle::run(input, observer),
            Self::Fortune => fortune::run(input, observer),
            Self::DivideAndConquer => divide::run(input, observer),
            Self::Constrained => constrained::run(input, observer),
            Self::Refinement => refinement::run(input, observer),
        }
    }
}
