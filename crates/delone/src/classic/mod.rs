//! The classical algorithms, faithful to their texts, one file each, and every step observable.
//!
//! They are here to be studied, watched and compared; [`triangulate`](crate::triangulate) is faster than any
//! of them. All work on one half-edge mesh, all decisions are exact, and ties are broken by the
//! canonical perturbation: so all that claim a Delaunay triangulation end in the same one.
//!
//! - [`Algorithm`]: their list; [`About`]: source, idea, cost, guarantees, pseudocode.
//! - [`Input`]: points, or a domain, or a triangulation to begin with, and what they may be told.
//! - [`Output`]: triangles, and their hash.
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
mod board;
mod bounding;
mod conflicts;
mod flip_list;
mod greedy_flips;
mod incremental;
mod input;
mod inside;
mod joining;
mod opening;
mod output;
mod random_incremental;
mod searching;
mod segment_walk;
mod segments;
mod start;
mod sweep;

pub use about::{About, Takes};
use board::Board;
pub use bounding::{bounding_triangle, printed_bounding_triangle};
pub use input::Input;
use input::Sites;
pub use output::Output;

use crate::{Error, Observer};

/// The algorithms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Algorithm {
    /// The thesis' plane sweep, corrected: segments inserted, what lies outside of the domain removed.
    Sweep,
    /// The slides' program: walk along the segment from the last point, open triangles with a stack.
    SegmentWalk,
    /// The lecture's incremental construction, points in the given order.
    Incremental,
    /// The same in a random order, which [`Input::seed`] names.
    RandomIncremental,
    /// The lecture's greedy flips: search for an edge that is not locally Delaunay, flip it, search anew.
    GreedyFlips,
    /// The same with a list of the edges in doubt.
    FlipList,
}

impl Algorithm {
    /// All of them, by source.
    pub const ALL: &[Self] = &[
        Self::Sweep,
        Self::SegmentWalk,
        Self::Incremental,
        Self::RandomIncremental,
        Self::GreedyFlips,
        Self::FlipList,
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
            Self::SegmentWalk => &segment_walk::ABOUT,
            Self::Incremental => &incremental::ABOUT,
            Self::RandomIncremental => &random_incremental::ABOUT,
            Self::GreedyFlips => &greedy_flips::ABOUT,
            Self::FlipList => &flip_list::ABOUT,
        }
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
    /// input has what this algorithm does not [take](About::takes); [`Error::Cancelled`].
    pub fn observe(self, input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
        self.about().require_taken(input)?;
        match self {
            Self::Sweep => sweep::run(input, observer),
            Self::SegmentWalk => segment_walk::run(input, observer),
            Self::Incremental => incremental::run(input, observer),
            Self::RandomIncremental => random_incremental::run(input, observer),
            Self::GreedyFlips => greedy_flips::run(input, observer),
            Self::FlipList => flip_list::run(input, observer),
        }
    }
}
