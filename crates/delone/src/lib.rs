//! Exact, canonical, fast Delaunay triangulation of points and segments in the plane.
//!
//! ```
//! let points = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0), (1.0, 1.0)];
//! let t = delone::triangulate(points)?;
//!
//! assert_eq!(t.num_triangles(), 4);
//! for corners in t.triangles() {
//!     let [a, b, c] = corners.map(|v| t.point(v)); // counter-clockwise
//!     assert!(delone::predicates::orient2d(a, b, c) == delone::predicates::Orientation::Left);
//! }
//! // Whoever does not trust this library may have a proof.
//! delone::check::verify(t.points(), t.triangles(), &())?.into_result()?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Segments, holes and regions make a domain of the points. They may be as dirty as drawings are:
//!
//! ```
//! use delone::{ConstrainedDelaunay, DomainRule, Pslg, SegmentPolicy};
//!
//! let mut drawing = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (2.0, 1.0), (0.0, 4.0)]);
//! drawing.add_ring([0, 1, 2, 3, 4]); // an outline with a notch
//! drawing.add_segment(0, 3); // and a line in it
//! let builder = ConstrainedDelaunay::new()
//!     .domain(DomainRule::Carve) // without the notch
//!     .crossings(SegmentPolicy::Split); // the default is an error that names both segments
//! let t = builder.triangulate(drawing)?;
//! assert_eq!(t.triangulation().num_triangles(), 3);
//! assert_eq!(t.chain(5).len(), 2); // the vertices along the line
//! # Ok::<(), delone::Error>(())
//! ```
//!
//! Refinement adds vertices to a domain until its triangles are good, and reports what it has reached:
//!
//! ```
//! use delone::{Angle, DomainRule, Outcome, Pslg, Quality, Refinement};
//!
//! let mut outline = Pslg::from_points([(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 4.0), (0.0, 3.0)]);
//! outline.add_ring([0, 1, 2, 3, 4]);
//! let quality = Quality {
//!     min_angle: Some(Angle::degrees(30.0)),
//!     max_edge: Some(0.5), // in units of the coordinates
//!     ..Quality::default()
//! };
//! let refined = Refinement::new(quality).domain(DomainRule::Carve).mesh(outline)?;
//! assert_eq!(refined.report.outcome, Outcome::Complete);
//! assert!(refined.report.unmet.is_empty()); // else each with its reason
//! assert!(refined.statistics().longest_edge <= 0.5);
//! # Ok::<(), delone::Error>(())
//! ```
//!
//! # Guarantees
//!
//! - **Exact**: every decision is the true sign, for all finite `f64`, subnormals included. There is
//!   no tolerance.
//! - **Canonical**: a point set, and a set of segments with it, has exactly *one* triangulation. Equal
//!   points are merged, and points on a common circle are told apart by a symbolic perturbation that
//!   depends on coordinates alone. Order of the input, number of threads, builder and machine do not
//!   change the set of triangles, so a [hash](Triangulation::hash) names it.
//! - **Total**: no points, one, two, all equal, all on one line: every finite input has a result.
//!   Refused are coordinates that are not finite, segments that cross unless they are to be split,
//!   seeds of holes and regions on segments, and more points than 32-bit ids can number; the
//!   [`Error`] names the culprit. Nothing panics on input.
//! - **Ends**: refinement does, for every input and every angle, and names each triangle that is not as
//!   asked, with the reason. The mesh is canonical, too: *the* constrained Delaunay triangulation of its
//!   vertices and subsegments.
//!
//! Conventions: y points up, counter-clockwise is positive, vertices keep the caller's numbers, and
//! −0.0 is 0.0.
//!
//! # What is where
//!
//! - [`triangulate`], [`Delaunay`]: a whole point set, on several threads, watched if you like;
//!   [`delaunay::Incremental`]: point by point.
//! - [`edit::LiveTriangulation`]: vertices and constraints that come, go and move, with transactions.
//! - [`Pslg`], [`ConstrainedDelaunay`]: a domain; [`ConstrainedTriangulation`]: its triangles and
//!   constrained edges, the regions, and the lineage of vertices and segments.
//! - [`doctor`]: what is wrong with a drawing, and its repair within a stated tolerance.
//! - [`Triangulation`]: the result, with triangles, neighbours, edges, hull and merged points;
//!   [`mesh`]: its half-edges.
//! - [`Refinement`]: from a domain to a [`RefinedMesh`] of the [`Quality`] asked for, and its [`Report`];
//!   [`sizing`](mod@sizing): how large triangles may be, place by place; [`Observer`]: algorithms at work, step
//!   by step.
//! - [`regular`]: points with weights, their triangulation, and hidden points.
//! - [`check`]: the verifier, which shares nothing with the builders, and measures of quality.
//! - [`locate`]: the triangle of a point. [`nearest`]: the nearest vertices, the k nearest, those within a
//!   radius. [`proximity`]: closest pair, spanning tree, clusters, neighbourhood graphs, alpha shapes, empty
//!   circles, tours.
//! - [`voronoi`]: cells, clipped and measured, and points relaxed in them. [`surface`]: values between
//!   vertices, gradients, rasters, contour lines.
//! - [`scattered`]: triangulations made for data, with enough of them in every triangle and not too many.
//! - [`classic`]: the classical algorithms, faithful to their texts; [`Log`], [`Scene`], [`Tally`]: their steps,
//!   played and counted.
//! - [`predicates`]: the exact signs. [`on_threads`]: how many threads work, where no setting says so.
//!
//! # Features
//!
//! - `rayon` (default): several threads. Without it everything runs on the caller's thread, with
//!   the identical result.
//! - `serde`: events, steps and logs can be serialised.

pub mod check;
pub mod classic;
mod clock;
mod constrained;
pub mod delaunay;
pub mod doctor;
pub mod edit;
mod error;
mod hash;
pub mod locate;
mod memory;
pub mod mesh;
pub mod nearest;
mod observe;
mod order;
mod pace;
mod parallel;
mod point;
pub mod predicates;
pub mod proximity;
mod pslg;
mod quality;
mod refine;
pub mod regular;
pub mod scattered;
pub mod surface;
mod tables;
mod triangulation;
pub mod voronoi;
mod watch;

pub use constrained::{ConstrainedDelaunay, ConstrainedTriangulation, Origin, Warning};
pub use delaunay::{Delaunay, triangulate};
pub use error::{Error, Seed};
pub use hash::{TriangulationHash, hash_triangles};
pub use mesh::{HalfEdgeId, Mesh, TriangleId, VertexId};
pub use observe::{
    Cut, Event, Failure, Item, Log, NoSuchStep, Observer, Queue, Scene, Stage, Step, Sweep, Tally,
};
pub use parallel::on_threads;
pub use point::Point;
pub use pslg::{
    DomainRule, Facts, Listed, Pslg, PslgHash, Region, Ring, SegmentCrossing, SegmentPolicy,
    VertexOnSegment,
};
pub use quality::{Angle, Broken, Locked, Quality};
pub use refine::{
    Budget, Encroachment, Outcome, Reason, RefinedMesh, Refinement, Report, SizingField, Strategy,
    Unmet, sizing,
};
pub use triangulation::{Duplicate, Triangulation};
pub use watch::{Phase, Watch};
