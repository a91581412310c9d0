//! Refinement: from a domain to a mesh of good triangles.
//!
//! ```text
//! Prepared ── sow, handing ──> Canvas ─┬─> Refiner::step ─┬── smooth, handing ──> mesh ── reasons ──> Report
//!                                      └── until nothing ─┘
//!                                       waits, or the budget is used up
//! ```
//!
//! # What lives where
//!
//! | room | what it is about |
//! |---|---|
//! | [`run`], [`handing`] | from a carved domain to the canvas and back: scaling, the hull, lineage, budget and watch |
//! | [`sow`](mod@sow) | a head start where sizes are uniform: a hexagonal lattice |
//! | [`refiner`] | the loop: what is looked at, and what waits |
//! | [`insertion`], [`splitting`] | how bad triangles vanish, and where subsegments are split |
//! | [`canvas`], [`cavity`] | the mesh while it grows; what a vertex tears out of it |
//! | [`bounds`], [`queue`] | what is bad, and what comes next |
//! | [`candidates`] | where a vertex could help |
//! | [`lines`] | segments: where they are cut, and the chains they become |
//! | [`refined`], [`reasons`], [`longest`], [`report`], [`budget`] | what was reached, what not and why, and how far to go |
//! | [`relocate`] | vertices of the lattice moved instead of others added |
//! | [`smooth`](mod@smooth) | vertices moved to better places afterwards |
//! | [`patch`], [`worth`] | what a move changes, and whether that is worth it |
//! | [`telling`], [`picture`], [`code`] | what is done, for who watches |
//! | [`sizing`] | how large triangles may be, place by place |
//! | [`thesis`] | the other strategy, which shares only the first and the last steps |
//!
//! # The loop
//!
//! Where one size is asked for everywhere, or in a whole region, and nothing is locked, a lattice is sown
//! first: halving triangles until they are small enough leaves a third of the area unused, equilateral ones
//! are as large as allowed. The loop then mends what lies along segments, and begins at once for all else.
//!
//! ```text
//! an encroached subsegment waits, the first of them    split it
//! an oversized triangle waits, the worst of them       if its longest edge is a subsegment that is too long,
//!                                                      split that; else try its circumcenter
//! a skinny triangle waits, that of the shortest edge   if its angle is the input's, or it is too small
//!                                                        for the coordinates, leave it alone;
//!                                                      else move a corner that was sown, if that helps;
//!                                                      else try five candidates
//! to try candidates, dig the cavity of each            the first encroaches upon a subsegment: split that
//!                                                      some fit: insert the one that leaves the fewest
//!                                                        skinny triangles, and of those the roomiest
//!                                                      none does: leave the triangle alone
//! whatever is new is looked at, and waits if it is bad
//! ```
//!
//! There is no point location. A candidate must lie in the circle of the bad triangle, so its cavity is dug
//! from there; a vertex that cannot be seen from within does not lie to the left of all edges of the rim,
//! and the edge that hides it is the segment to be split.
//!
//! # Why it ends, for every input and every angle
//!
//! A floor keeps vertices apart: 2¹⁰ units in the last place of the new vertex' larger coordinate, and
//! 2⁻²⁵⁰ in [scaled](handing::scale) coordinates. A free vertex keeps it from every vertex that it sees:
//! the nearest of those is on the rim of its cavity. A vertex on a segment keeps it from the ends of its
//! subsegment. So a segment has room for finitely many; and infinitely many free ones would crowd somewhere
//! between the finitely many segments, where some would see each other. Nothing is ever deleted; vertices
//! of the lattice move only where they keep the same distances, and a move leaves fewer bad triangles, so
//! there are finitely many between two insertions; and every
//! vertex adds finitely many elements to those that wait. Whatever is refused no longer waits, and returns
//! only in a new triangle, or behind a vertex that was added for it. That is all: no bound on any angle
//! enters. (There are finitely many `f64`, of course, so that any algorithm ends which never repeats
//! itself; but not within a lifetime.)
//!
//! That end would still be late: with vertices as dense as coordinates are. What ends it early is
//! *gradation*. Each vertex has a base. That of the vertices before the loop is their local feature size,
//! that of one forced by the input its distance to its neighbours, that of one asked for by a size at most
//! that; all others inherit it from those that called for them. What an angle asks for is inserted only if
//! it keeps a sixteenth of its base from the others; a 256th where something is locked, for vertices have
//! to crowd before a long edge that must not be split. So nothing can cascade to much below the features,
//! or the sizes, of where it began. The first floor alone holds for sizes, which are to be had at any
//! place, and for splits on account of a vertex of a neighbouring segment, which shells keep apart.
//! Triangles whose shortest edge is below four times the first floor are left alone: coordinates have no
//! room to make them better.
//!
//! # Theory, and how far it goes
//!
//! - Ruppert (1995): circumcenters and diametral circles reach 20.7° with a mesh that is graded and whose
//!   size is optimal up to a constant factor, if no two segments meet at less than 60°. Shewchuk (2002) has
//!   the proof for constrained triangulations, and what to do about small angles.
//! - Miller, Pav and Walkington (2003): with concentric shells, and triangles across a small angle of the
//!   input left alone, 26.45° for every domain. Such triangles are [excused](Reason::SmallInputAngle); no
//!   others need to stay.
//! - Chew (1993) splits a segment only for a vertex in its lens, and deletes the free vertices in its
//!   circle first. Rand (2011) proves 28.6° for that, with off-centers.
//! - Üngör (2004): off-centers instead of circumcenters keep Ruppert's guarantee with fewer vertices. Erten
//!   and Üngör (2007): still fewer with the locally best of many places, at no loss that anybody has seen.
//!
//! *None of these proofs holds word for word here.* By default lenses are used, but no free vertex is ever
//! deleted: those too close to a new vertex on a segment stay, within the gradation. And candidates are
//! scored, where the proofs know circumcenters and off-centers; so with [`Encroachment::Circle`], too,
//! which else is the algorithm of the second and fourth. Proven of this code is that it ends, and that its
//! report is true: what falls short is listed. The rest is measured: asked for alone, 33° and all below are
//! reached on every domain of the samples, save for what the input excuses.
//!
//! # What is new
//!
//! - *Channels.* Where two segments run side by side, closer than their lengths, each vertex on one would
//!   force one opposite on the other, and so on. Here a subsegment in the way is cut opposite the middle of
//!   the one beyond, so that vertices on the two sides take turns, and a channel needs about half of them
//!   (see [`lines`]); one with a vertex beside it is cut into as many equal pieces as the lens permits, not
//!   into halves of halves.
//! - *Acute corners.* Their lines are cut at distances that are round binary numbers, all along and not
//!   only next to the corner, or as far out as the vertex that is in the way: then neither encroaches upon
//!   the other.
//! - *Fans.* Hundreds of thousands of slivers from one vertex to a finely cut line would be torn up one by
//!   one, each time all that are left. A cavity that large is begun anew in its middle.
//!
//! # Numbers
//!
//! What decides topology is exact: who lies in which circle, and on which side of what. What decides need
//! and taste is rounded: who is skinny, who lies in a lens (inside the circle, which is exact), which
//! candidate is best. It uses nothing but the four operations and roots, and constants of `libm`, which is
//! written in Rust: every machine makes the same mesh. A vertex on a segment is rounded, too, and may lie
//! beside it. Then the subsegments bend, and are the constraints from there on: of nine neighbouring places
//! the first is taken at which no triangle is inverted. So the mesh is at every moment the canonical
//! constrained Delaunay triangulation of its points and subsegments, and whoever builds that anew can check
//! it by its hash.
//!
//! *Cost*: about 1 µs a point of the input, and 1 to 4 µs a vertex added, less than ½ µs if it was sown.
//! Memory: about 100 bytes a triangle, the result included. The loop runs on one thread; what comes before
//! and after it may use more.

mod bounds;
mod budget;
mod candidates;
mod canvas;
mod cavity;
mod code;
mod corners;
mod handing;
mod insertion;
mod lines;
mod longest;
mod patch;
mod picture;
mod queue;
mod reasons;
mod refined;
mod refiner;
mod relocate;
mod report;
mod run;
pub mod sizing;
mod smooth;
mod sow;
mod splitting;
mod telling;
mod thesis;
mod worth;

pub use budget::Budget;
pub(crate) use code::CODE as DELAUNAY_CODE;
pub use refined::RefinedMesh;
pub use report::{Outcome, Reason, Report, Unmet};
pub use sizing::SizingField;
pub(crate) use thesis::CODE as THESIS_CODE;

use crate::constrained::{Options, prepare};
use crate::parallel;
use crate::{DomainRule, Error, Locked, Observer, Pslg, Quality, SegmentPolicy, Watch};

/// When a segment has to be split because a vertex is too close to it, a vertex that sees it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Encroachment {
    /// A vertex lies in its diametral lens: it sees the segment under at least 180 degrees less twice
    /// the smallest angle asked for (Chew 1993), or under 90 if that is more. Fewest triangles.
    #[default]
    Lens,
    /// A vertex lies in its diametral circle (Ruppert 1995). Then the mesh is *conforming*: all its
    /// triangles are Delaunay, segments or not. Only what is [locked](Refinement::locked) stays as it is,
    /// and a segment that a vertex is nearer to than 2¹² units in the last place of their largest
    /// coordinate.
    Circle,
}

/// Which algorithm refines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Strategy {
    /// Ruppert's and Chew's family with everything learnt since: ends for every input and angle.
    #[default]
    Delaunay,
    /// The algorithm of the thesis that this project goes back to: segments are divided, longest edges
    /// bisected, then skinny triangles opened. If that does not end well, the mesh before the opening is
    /// the result, with [`Outcome::FellBack`].
    ///
    /// It knows a smallest angle and a longest edge, and promises the latter only; for work,
    /// [`Strategy::Delaunay`] is better.
    Thesis,
}

/// How to refine the triangulation of a domain.
///
/// ```
/// use delone::{Angle, DomainRule, Outcome, Pslg, Quality, Refinement, check};
///
/// // A square with a slit: the result is a mesh of its inside.
/// let corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
/// let mut plate = Pslg::from_points(corners.into_iter().chain([(1.0, 1.0), (3.0, 2.0)]));
/// plate.add_ring([0, 1, 2, 3]);
/// plate.add_segment(4, 5);
/// let quality = Quality { min_angle: Some(Angle::degrees(30.0)), max_edge: Some(0.5), ..Quality::default() };
/// let refined = Refinement::new(quality).domain(DomainRule::Carve).mesh(plate.clone())?;
///
/// assert_eq!(refined.report.outcome, Outcome::Complete);
/// assert!(refined.report.unmet.is_empty());
/// assert!(refined.statistics().min_angle >= 30.0);
/// assert!(refined.mesh.chain(4).len() > 4); // vertices along the slit
///
/// // Whoever does not trust the report may have it proven from the triangles alone.
/// let t = refined.mesh.triangulation();
/// let subsegments: Vec<_> = refined.mesh.constrained_edges().collect();
/// let mesh = check::DomainMesh::new(t.points(), t.triangles(), &subsegments).refined();
/// let asked = check::Asked::new(quality);
/// let verdict = check::verify_quality(&plate, DomainRule::Carve, &mesh, &asked, &())??;
/// assert!(verdict.is_met());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # What is guaranteed
///
/// - It *ends*, for every input and every angle: vertices keep a distance from each other that coordinates,
///   and the features and sizes of the input, set.
/// - The mesh is valid at any stop, and is *the* constrained Delaunay triangulation of its vertices and
///   subsegments; for the same input it is the same on every machine and for any number of threads, unless
///   [`Budget::time`] or the watch ends the work.
/// - Whatever misses a bound is [reported](Report::unmet) with its [`Reason`]; whatever is not reported
///   meets them all, up to a part in 10¹² of rounding.
///
/// Up to 26.45 degrees a variant of this algorithm is proven to leave nothing but triangles at small angles
/// of the input (Miller, Pav and Walkington 2003). The default is not exactly that variant; in practice up to
/// 33 degrees are reached. Beyond that the mesh may become very large, and triangles be left for
/// [`Reason::Gradation`]: set a [`Budget`].
#[derive(Clone, Copy)]
pub struct Refinement<'a> {
    quality: Quality,
    sizing: Option<&'a dyn SizingField>,
    budget: Budget,
    locked: Locked,
    encroachment: Encroachment,
    smoothing: usize,
    strategy: Strategy,
    options: Options,
    threads: Option<usize>,
    watch: &'a dyn Watch,
}

impl<'a> Refinement<'a> {
    /// Asks for `quality`, keeps the convex hull, refuses crossings, and uses every thread of the
    /// machine, without limit and unwatched.
    pub fn new(quality: Quality) -> Self {
        Self {
            quality,
            sizing: None,
            budget: Budget::default(),
            locked: Locked::default(),
            encroachment: Encroachment::default(),
            smoothing: 0,
            strategy: Strategy::default(),
            options: Options::default(),
            threads: None,
            watch: &(),
        }
    }

    /// Asks for sizes that depend on the place, too: a closure, or one of the fields in
    /// [`sizing`](mod@crate::sizing).
    ///
    /// *Cost*: one question for each triangle that is made, about ten for each vertex.
    pub fn sizing(self, field: &'a dyn SizingField) -> Self {
        Self {
            sizing: Some(field),
            ..self
        }
    }

    /// Limits the work. A mesh that is stopped is valid, but its report may be long.
    pub fn budget(self, budget: Budget) -> Self {
        Self { budget, ..self }
    }

    /// Chooses which edges must stay as they are. What they make impossible is excused, see
    /// [`Reason::LockedBoundary`].
    pub fn locked(self, locked: Locked) -> Self {
        Self { locked, ..self }
    }

    /// Chooses when a segment has to be split on account of a vertex beside it.
    pub fn encroachment(self, encroachment: Encroachment) -> Self {
        Self {
            encroachment,
            ..self
        }
    }

    /// Moves free vertices to better places afterwards, in so many passes, or fewer if nothing gets
    /// better any more. No bound is broken for it that was not broken before; vertices of the input and
    /// on segments stay where they are. A watch that cancels, or a [`Budget::time`] that is over, ends it.
    ///
    /// *Cost*: about 2 µs a vertex and pass. The first pass does most of the good.
    pub fn smoothing(self, passes: usize) -> Self {
        Self {
            smoothing: passes,
            ..self
        }
    }

    /// Chooses the algorithm.
    pub fn strategy(self, strategy: Strategy) -> Self {
        Self { strategy, ..self }
    }

    /// Chooses what to do where segments of the input cross.
    pub fn crossings(mut self, policy: SegmentPolicy) -> Self {
        self.options.crossings = policy;
        self
    }

    /// Chooses which triangles belong to the domain.
    pub fn domain(mut self, rule: DomainRule) -> Self {
        self.options.domain = rule;
        self
    }

    /// Uses `threads` threads (0 means 1, and at most 1024); the result is the same for any number.
    ///
    /// They share the triangulation of the input and the handing out of the result; refinement itself runs
    /// on one.
    pub fn threads(self, threads: usize) -> Self {
        Self {
            threads: Some(threads),
            ..self
        }
    }

    /// Reports progress to `watch`, which may cancel.
    pub fn watch(self, watch: &'a dyn Watch) -> Self {
        Self { watch, ..self }
    }

    /// Triangulates and refines a domain.
    ///
    /// # Errors
    /// Those of [`ConstrainedDelaunay::triangulate`](crate::ConstrainedDelaunay::triangulate), and
    /// [`Error::BadQuality`] if a bound makes no sense; [`Error::NotInThesis`] if [`Strategy::Thesis`] is
    /// asked for more than a smallest angle and a longest edge. If the watch cancels while the input is
    /// triangulated, [`Error::Cancelled`]; later, the mesh so far with [`Outcome::Cancelled`].
    ///
    /// *Cost*: that of the triangulation, about 1 µs a point of the input, and 1 to 4 µs a vertex added,
    /// less where one size is asked for everywhere; memory about 100 bytes a triangle.
    pub fn mesh(self, pslg: Pslg) -> Result<RefinedMesh, Error> {
        self.observe(pslg, &mut ())
    }

    /// Does the same, and tells `observer` of each step. Vertices have the numbers of the result.
    ///
    /// Why a vertex is added is told right before it [appears](crate::Event::VertexCreated):
    ///
    /// - [`CircumcenterProposed`](crate::Event::CircumcenterProposed), for a triangle that is skinny; where that is
    ///   too large, [`TriangleConsidered`](crate::Event::TriangleConsidered) comes before it;
    /// - [`CircumcenterRejected`](crate::Event::CircumcenterRejected) after these and
    ///   [`SegmentSplit`](crate::Event::SegmentSplit), if a subsegment is in the way;
    /// - [`Encroached`](crate::Event::Encroached) and `SegmentSplit`, if a vertex is too close to a subsegment;
    /// - `TriangleConsidered` and `SegmentSplit`, if a subsegment is too long;
    /// - nothing for the vertices of a lattice: they appear between two
    ///   [`StageEnded`](crate::Event::StageEnded), that of the domain and that of the lattice.
    ///
    /// [`Strategy::Thesis`] tells of `SegmentSplit` right behind the vertex.
    ///
    /// # Errors
    /// Those of [`mesh`](Self::mesh).
    pub fn observe(
        self,
        pslg: Pslg,
        observer: &mut (impl Observer + Send),
    ) -> Result<RefinedMesh, Error> {
        self.require()?;
        parallel::with_workers(self.threads, |workers| {
            let prepared = prepare(pslg, self.options, workers, self.watch)?;
            match self.strategy {
                Strategy::Delaunay => run::refine(prepared, &self, workers, observer),
                Strategy::Thesis => thesis::refine(prepared, &self, workers, observer),
            }
        })?
    }

    /// Refuses bounds that make no sense, or that the strategy does not know.
    fn require(&self) -> Result<(), Error> {
        self.quality.require()?;
        match self.strategy {
            Strategy::Delaunay => Ok(()),
            Strategy::Thesis => thesis::require_known(self),
        }
    }
}
