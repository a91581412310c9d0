//! The independent verifier: is this set of triangles *the* Delaunay triangulation of these points?
//!
//! [`verify`] needs what a file holds, points and corners, and trusts nothing else: it finds the
//! neighbours itself and shares the predicates, and only them, with the builders. All signs are
//! exact. [`statistics`](statistics()) measures shapes in rounded numbers, for reports and pictures.
//!
//! # What is tested
//! 1. Every corner names a point, and the three corners of a triangle differ.
//! 2. Every triangle turns strictly counter-clockwise.
//! 3. An edge has one triangle, or two that run through it in opposite directions.
//! 4. Edges with one triangle form one closed cycle that never turns right, never turns back, and
//!    has one lexicographically smallest vertex, hence goes round once.
//! 5. Every point is a corner, or equal to one that is.
//! 6. Every edge with two triangles is locally Delaunay under the symbolic perturbation.
//!
//! # Why that is enough
//! *Cover.* Let p lie on no edge. A counter-clockwise triangle winds once around p if it contains
//! p, else not at all; so the number of triangles that contain p is the sum of their winding
//! numbers. By 3 interior edges cancel in the sum, and what is left is the winding number of the
//! boundary around p. By 4 the boundary is a convex polygon, run through once: the number is one
//! inside and zero outside. So the triangles fill a convex polygon without overlap; its corners are
//! points and by 5 all points are in it, hence it is the convex hull. No vertex lies inside a
//! triangle, inside an edge or upon another vertex: its own triangles would overlap those around
//! it. In particular all stars are single fans or cycles, and of equal points only one is used.
//!
//! *Delaunay.* Over a convex domain a lifted surface that is convex across every edge is convex
//! (Delaunay's lemma), so by 6 it is the lower hull of the points lifted to x² + y² + ε; under the
//! perturbation no four lifted points share a plane, and that hull is unique.
//!
//! *Cost*: linear, without sorting by coordinates; memory about 40 bytes a triangle. Once something
//! is wrong, further linear passes look for what a reader would name as the reason.
//!
//! [`verify_domain`] does the same for constrained triangulations of domains, refined or not, and
//! [`verify_quality`] finds the triangles that break bounds, and whether something excuses them.
//! [`verify_cover`] tests triangulations that are made for data. Neighbour tables read from a file are not
//! checked.

mod adjacency;
mod angles;
mod boundary;
mod certificate;
mod cover;
mod defect;
mod domain;
mod histogram;
mod once;
mod positions;
mod shape;
mod stages;
mod stars;
mod statistics;

pub use angles::{Below, count_below};
pub use certificate::{Certificate, DomainNumbers, Verdict};
pub use cover::{CoverCertificate, CoverVerdict, SpecialCase, SpecialCause, verify_cover};
pub use defect::{Corner, Defect, Defects};
pub use domain::{
    Asked, CROSSING_DRIFT, Counts, DomainMesh, Encroached, Excuse, QualityVerdict, STEINER_DRIFT,
    Unmet, verify_domain, verify_quality, verify_regions,
};
pub use histogram::LogHistogram;
pub use shape::Shape;
pub use stages::{LocalTests, StageCounts, count_stages};
pub use statistics::{Statistics, statistics};

use crate::pace::Pace;
use crate::predicates::{Orientation, in_circle_perturbed, orient2d};
use crate::{
    Error, HalfEdgeId, Phase, Point, TriangleId, TriangulationHash, VertexId, Watch, hash_triangles,
};
use adjacency::Adjacency;

/// Most triangles whose half-edges 32-bit ids can number.
const MOST_TRIANGLES: usize = u32::MAX as usize / 3;

/// Decides whether `triangles` is the canonical Delaunay triangulation of `points`.
///
/// Triangles may come in any order and rotation. Of several equal points any one may be the corner,
/// but only one. If all points lie on one line, no triangles is the right answer.
///
/// ```
/// use delone::{Point, VertexId, check};
///
/// let points = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
/// let triangles = [[0, 1, 2].map(VertexId::from)];
/// let certificate = check::verify(&points, &triangles, &())?.into_result()?;
/// assert_eq!(certificate.hull_edges, 3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotFinite`] names the first point that is none; [`Error::TooManyPoints`] if there are
/// more than 32-bit ids can name; [`Error::Cancelled`] if `watch` asks for it. A wrong triangulation
/// is no error but [`Verdict::Wrong`].
///
/// *Cost*: linear; under a second for a million triangles on one thread.
pub fn verify(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    watch: &dyn Watch,
) -> Result<Verdict, Error> {
    let mut pace = Pace::new(watch, Phase::Check, work(points, triangles));
    require_points(points, &mut pace)?;
    let verifier = Verifier {
        points,
        triangles,
        pace,
        defects: Defects::default(),
    };
    if triangles.is_empty() {
        verifier.nothing()
    } else {
        verifier.everything()
    }
}

/// Estimates the steps of a verification without defects.
fn work(points: &[Point], triangles: &[[VertexId; 3]]) -> u64 {
    // Corners, orientations, points and hash; edges and boundary go by half-edges.
    let per_triangle = 4 + 3 * 2 + adjacency::STEPS_PER_TRIANGLE;
    2 * points.len() as u64 + per_triangle * triangles.len() as u64
}

fn require_points(points: &[Point], pace: &mut Pace) -> Result<(), Error> {
    // The last id is the infinite vertex.
    let limit = VertexId::INFINITE.index();
    if points.len() > limit {
        return Err(Error::TooManyPoints {
            given: points.len(),
            limit,
        });
    }
    for (index, p) in points.iter().enumerate() {
        pace.step()?;
        if !p.is_finite() {
            let Point { x, y } = *p;
            return Err(Error::NotFinite { index, x, y });
        }
    }
    Ok(())
}

/// One verification under way.
struct Verifier<'a> {
    points: &'a [Point],
    triangles: &'a [[VertexId; 3]],
    pace: Pace<'a>,
    defects: Defects,
}

impl Verifier<'_> {
    /// Verifies a set without triangles.
    fn nothing(mut self) -> Result<Verdict, Error> {
        if let Some(witnesses) = positions::find_turn(self.points, &mut self.pace)? {
            let corners = witnesses.map(|v| self.corner(v));
            self.defects.push(Defect::NoTriangles { corners });
            return Ok(Verdict::Wrong(self.defects));
        }
        let vertices = positions::count_distinct(self.points, &mut self.pace)?;
        let edges = vertices.saturating_sub(1);
        Ok(Verdict::Right(self.certificate(vertices, edges, edges)?))
    }

    /// Verifies a set with triangles.
    fn everything(mut self) -> Result<Verdict, Error> {
        self.check_corners()?;
        if !self.defects.is_empty() {
            // Without corners there are no edges to speak of.
            return Ok(Verdict::Wrong(self.defects));
        }
        let upright = self.check_orientations()?;
        let used = self.check_points()?;
        let (points, triangles) = (self.points, self.triangles);
        let adjacency = Adjacency::find(points, triangles, &mut self.pace, &mut self.defects)?;
        self.check_edges(&adjacency, &upright, |_| false)?;
        let hull_edges = boundary::check(points, &adjacency, &mut self.pace, &mut self.defects)?;
        if self.defects.is_empty() {
            let vertices = used.iter().filter(|&&u| u).count();
            let edges = (3 * triangles.len() + hull_edges) / 2;
            let certificate = self.certificate(vertices, edges, hull_edges)?;
            return Ok(Verdict::Right(certificate));
        }
        self.explain(&adjacency, &used)?;
        Ok(Verdict::Wrong(self.defects))
    }

    fn check_corners(&mut self) -> Result<(), Error> {
        if self.triangles.len() > MOST_TRIANGLES {
            self.defects.push(Defect::TooManyTriangles {
                given: self.triangles.len(),
                limit: MOST_TRIANGLES,
            });
            return Ok(());
        }
        for (t, &corners) in self.triangles.iter().enumerate() {
            self.pace.step()?;
            let triangle = TriangleId::new(t);
            let points = self.points.len();
            if let Some(&corner) = corners.iter().find(|v| v.index() >= points) {
                self.defects.push(Defect::OutOfRange {
                    triangle,
                    corner,
                    points,
                });
            } else if let Some(v) = repeated(corners) {
                let corner = self.corner(v);
                self.defects
                    .push(Defect::RepeatedCorner { triangle, corner });
            }
        }
        Ok(())
    }

    /// Tells for every triangle whether it turns counter-clockwise.
    fn check_orientations(&mut self) -> Result<Vec<bool>, Error> {
        let mut upright = Vec::with_capacity(self.triangles.len());
        for (t, &vertices) in self.triangles.iter().enumerate() {
            self.pace.step()?;
            let [a, b, c] = vertices.map(|v| self.points[v.index()]);
            let orientation = orient2d(a, b, c);
            upright.push(orientation == Orientation::Left);
            let triangle = TriangleId::new(t);
            let corners = || vertices.map(|v| self.corner(v));
            let defect = match orientation {
                Orientation::Left => continue,
                Orientation::Right => Defect::Clockwise {
                    triangle,
                    corners: corners(),
                },
                Orientation::Collinear => Defect::Degenerate {
                    triangle,
                    corners: corners(),
                },
            };
            self.defects.push(defect);
        }
        Ok(upright)
    }

    /// Tells for every point whether it is a corner.
    fn check_points(&mut self) -> Result<Vec<bool>, Error> {
        let mut used = vec![false; self.points.len()];
        for corners in self.triangles {
            self.pace.step()?;
            for v in corners {
                used[v.index()] = true;
            }
        }
        for v in positions::find_missing(self.points, &used, &mut self.pace)? {
            let corner = self.corner(v);
            self.defects.push(Defect::MissingPoint { corner });
        }
        Ok(used)
    }

    /// Tests the edges between two counter-clockwise triangles, where the predicate has a meaning,
    /// unless they are constrained.
    fn check_edges(
        &mut self,
        adjacency: &Adjacency,
        upright: &[bool],
        is_constrained: impl Fn(HalfEdgeId) -> bool,
    ) -> Result<(), Error> {
        for h in adjacency.half_edges() {
            self.pace.step()?;
            let twin = adjacency.twin(h).filter(|&twin| h < twin);
            let Some(twin) = twin.filter(|_| !is_constrained(h)) else {
                continue;
            };
            let triangles = [h, twin].map(HalfEdgeId::triangle);
            if triangles.iter().all(|t| upright[t.index()]) {
                self.check_edge(adjacency, h, twin);
            }
        }
        Ok(())
    }

    fn check_edge(&mut self, adjacency: &Adjacency, h: HalfEdgeId, twin: HalfEdgeId) {
        let quadrilateral = [
            adjacency.origin(h),
            adjacency.dest(h),
            adjacency.apex(h),
            adjacency.apex(twin),
        ];
        let [a, b, c, d] = quadrilateral.map(|v| self.points[v.index()]);
        if in_circle_perturbed(a, b, c, d) {
            let [a, b, apex, inside] = quadrilateral.map(|v| self.corner(v));
            self.defects.push(Defect::NotLocallyDelaunay {
                edge: [a, b],
                triangles: [h, twin].map(HalfEdgeId::triangle),
                apex,
                inside,
            });
        }
    }

    /// Looks for what the proof does not need but a reader wants to know.
    fn explain(&mut self, adjacency: &Adjacency, used: &[bool]) -> Result<(), Error> {
        for [first, second] in positions::find_shared(self.points, used, &mut self.pace)? {
            let corners = [first, second].map(|v| self.corner(v));
            self.defects.push(Defect::SharedPosition { corners });
        }
        stars::check(self.points, adjacency, &mut self.pace, &mut self.defects)
    }

    /// Sums up what has been proven right.
    fn certificate(
        mut self,
        vertices: usize,
        edges: usize,
        hull_edges: usize,
    ) -> Result<Certificate, Error> {
        let hash = self.hash()?;
        self.pace.finish();
        Ok(Certificate {
            points: self.points.len(),
            vertices,
            duplicates: self.points.len() - vertices,
            triangles: self.triangles.len(),
            edges,
            hull_edges,
            domain: None,
            hash,
        })
    }

    /// Hashes triangle by triangle, so that it can be cancelled.
    fn hash(&mut self) -> Result<TriangulationHash, Error> {
        let mut sum = 0u128;
        for corners in self.triangles {
            self.pace.step()?;
            let triangle = corners.map(|v| self.points[v.index()]);
            sum = sum.wrapping_add(hash_triangles([triangle]).0);
        }
        Ok(TriangulationHash(sum))
    }

    fn corner(&self, vertex: VertexId) -> Corner {
        Corner::new(self.points, vertex)
    }
}

fn repeated([a, b, c]: [VertexId; 3]) -> Option<VertexId> {
    if a == b || a == c {
        Some(a)
    } else {
        (b == c).then_some(b)
    }
}
