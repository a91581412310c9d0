//! Covers: does every triangle hold enough of the data, and none too many?
//!
//! [`verify_cover`] takes a triangulation that was made for data, and who holds which datum, and proves from these
//! arrays alone what such a cover promises. Like [`verify`](super::verify) it shares the predicates, and only
//! them, with the builders.
//!
//! # What is tested
//! 1. Every corner names a point, the three corners of a triangle differ, every point is a corner, and no two points
//!    are equal.
//! 2. Every triangle turns strictly counter-clockwise.
//! 3. An edge has one triangle, or two that run through it in opposite directions.
//! 4. The edges with one triangle, the *border*, form one cycle that runs through no vertex twice; they share
//!    ends only, and no vertex lies inside one ([`border`]).
//! 5. Every datum lies in the closed triangle that holds it, and equal data are held by the same ([`held`]).
//! 6. Every triangle holds at least d data, equal ones counted once.
//!
//! A triangle that holds more than 3d − 1 is no defect. It is listed, with what excuses it ([`special`]).
//!
//! # Why that is enough
//! *Side by side.* By 4 the border is a simple closed polygon, run through once: it winds once around each point
//! inside, always in the same direction, and not at all around those outside. Let p lie on no edge. By 2 the number
//! of triangles that contain p is the sum of their winding numbers around p; by 3 edges with two triangles cancel
//! in the sum, and what is left is the winding number of the border. A number of triangles is not
//! negative, and not always zero; so the border runs counter-clockwise, and the number is one inside and zero
//! outside: the triangles fill the polygon, without gap or overlap. The polygon need not be convex.
//!
//! *Edge to edge.* No vertex lies inside a triangle or inside an edge. If all edges at vertex v have two triangles,
//! those around v close up and fill a disc about v, and another triangle that reaches v would overlap them. Otherwise v
//! lies on the border, by 4 in no other edge of it. A triangle with v inside, or inside one of
//! its edges, would together with its neighbour there fill a disc about v, or half of one whose diameter is an edge
//! of the border; the first overlaps the triangles of v, the second is excluded.
//!
//! *Data.* By 5 every datum lies in the union, and the numbers in 6 are those of sets that together are the data,
//! no datum in two of them.
//!
//! *Cost*: O(n log n) for n vertices, to sort them; linear in triangles and data. Memory about 100 bytes a vertex, 40 a
//! triangle and 30 to 60 a datum.
//!
//! This module does not check which triangles could still be opened, nor shapes; angles are measured only.

mod border;
mod certificate;
mod held;
mod special;

pub use certificate::{CoverCertificate, CoverVerdict};
pub use special::{SpecialCase, SpecialCause};

use super::{
    Corner, Defect, Defects, Shape, Verifier, adjacency, positions, require_points, stars,
};
use crate::pace::Pace;
use crate::{Error, Phase, Point, TriangleId, VertexId, Watch};
use adjacency::Adjacency;
use held::Held;

/// Decides whether `triangles` on the vertices `points` lie side by side and hold the data as `holders` says, at
/// least `least` each.
///
/// Triangles may come in any order and rotation. `holders` names a triangle for each datum; equal data count
/// once. If `least` is 0, no number is too small, and none too large.
///
/// ```
/// use delone::{Point, TriangleId, VertexId, check};
///
/// let points = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(Point::from);
/// let triangles = [[0, 1, 2].map(VertexId::from)];
/// let data = [(1.0, 1.0), (2.0, 0.0), (2.0, 2.0), (1.0, 1.0)].map(Point::from);
/// let holders = [TriangleId::new(0); 4];
/// let verdict = check::verify_cover(&points, &triangles, &data, &holders, 3, &())?;
/// let certificate = verdict.into_result()?;
/// assert_eq!((certificate.data, certificate.duplicates), (3, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`Error::NotFinite`] names the first vertex that is no point; [`Error::TooManyPoints`] if there are more than
/// 32-bit ids can name; [`Error::Cancelled`] if `watch` asks for it. A wrong cover is no error but
/// [`CoverVerdict::Wrong`]; so is a datum that is not finite, since it lies in no triangle.
///
/// *Cost*: O(n log n) for n vertices, linear in triangles and data; one to two seconds for a million triangles
/// and as many data on one thread.
///
/// *Source*: the requirements (A1) to (A3) of chapter 3 of a diploma thesis, Duisburg, about 1998.
pub fn verify_cover(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    data: &[Point],
    holders: &[TriangleId],
    least: usize,
    watch: &dyn Watch,
) -> Result<CoverVerdict, Error> {
    let work = work(points, triangles, data);
    let mut pace = Pace::new(watch, Phase::Check, work);
    require_points(points, &mut pace)?;
    let verifier = CoverVerifier {
        data,
        holders,
        least,
        verifier: Verifier {
            points,
            triangles,
            pace,
            defects: Defects::default(),
        },
    };
    verifier.everything()
}

/// Estimates the steps of a verification without defects.
fn work(points: &[Point], triangles: &[[VertexId; 3]], data: &[Point]) -> u64 {
    let [points, triangles, data] = [points.len(), triangles.len(), data.len()].map(|n| n as u64);
    let sorting = points * u64::from(points.max(1).ilog2().saturating_sub(9));
    let per_triangle = 6 + 3 + adjacency::STEPS_PER_TRIANGLE;
    7 * points + sorting + per_triangle * triangles + 2 * data
}

/// One verification under way.
struct CoverVerifier<'a> {
    data: &'a [Point],
    holders: &'a [TriangleId],
    least: usize,
    verifier: Verifier<'a>,
}

impl CoverVerifier<'_> {
    fn everything(mut self) -> Result<CoverVerdict, Error> {
        self.verifier.check_corners()?;
        if self.is_wrong() {
            // Without corners there are neither edges nor places to lie in.
            return Ok(CoverVerdict::Wrong(self.verifier.defects));
        }
        let upright = self.verifier.check_orientations()?;
        let border_edges = self.check_plane()?;
        let held = self.check_data(&upright)?;
        if self.is_wrong() {
            return Ok(CoverVerdict::Wrong(self.verifier.defects));
        }
        let special = special::list(&mut self, &held)?;
        let certificate = self.certificate(border_edges, &held, special)?;
        Ok(CoverVerdict::Right(certificate))
    }

    fn is_wrong(&self) -> bool {
        !self.verifier.defects.is_empty()
    }

    /// Requires triangles side by side, inside one simple polygon, and counts its edges.
    fn check_plane(&mut self) -> Result<usize, Error> {
        let before = self.verifier.defects.total();
        let are_distinct = self.check_vertices()?;
        let Verifier {
            points,
            triangles,
            ref mut pace,
            ref mut defects,
        } = self.verifier;
        let adjacency = Adjacency::find(points, triangles, pace, defects)?;
        let mut edges = 0;
        if are_distinct && adjacency.is_manifold() {
            edges = border::check(points, &adjacency, pace, defects)?;
        }
        if defects.total() > before {
            stars::check(points, &adjacency, pace, defects)?;
        }
        Ok(edges)
    }

    /// Requires vertices that triangles have, at places of their own; tells whether no two are equal.
    fn check_vertices(&mut self) -> Result<bool, Error> {
        let Verifier {
            points,
            triangles,
            ref mut pace,
            ref mut defects,
        } = self.verifier;
        let mut used = vec![false; points.len()];
        for corners in triangles {
            pace.step()?;
            corners.iter().for_each(|v| used[v.index()] = true);
        }
        for v in (0..points.len()).filter(|&v| !used[v]).map(VertexId::new) {
            let corner = Corner::new(points, v);
            defects.push(Defect::IdleVertex { corner });
        }
        let shared = positions::find_shared(points, &vec![true; points.len()], pace)?;
        for &pair in &shared {
            let corners = pair.map(|v| Corner::new(points, v));
            defects.push(Defect::SharedPosition { corners });
        }
        Ok(shared.is_empty())
    }

    /// Requires data to lie in the triangles that hold them, and enough in each.
    fn check_data(&mut self, upright: &[bool]) -> Result<Held, Error> {
        let before = self.verifier.defects.total();
        let held = Held::find(self, upright)?;
        if self.verifier.defects.total() > before {
            // Numbers would blame the wrong triangles.
            return Ok(held);
        }
        for (t, &number) in held.counts.iter().enumerate() {
            self.verifier.pace.step()?;
            if number < self.least {
                self.verifier.defects.push(Defect::TooFewData {
                    triangle: TriangleId::new(t),
                    held: number,
                    least: self.least,
                });
            }
        }
        Ok(held)
    }

    /// Returns the positions of a triangle's corners.
    fn places(&self, triangle: TriangleId) -> [Point; 3] {
        let corners = self.verifier.triangles[triangle.index()];
        corners.map(|v| self.verifier.points[v.index()])
    }

    /// Sums up what has been proven right.
    fn certificate(
        mut self,
        border_edges: usize,
        held: &Held,
        special: Vec<SpecialCase>,
    ) -> Result<CoverCertificate, Error> {
        let hash = self.verifier.hash()?;
        let triangles = self.verifier.triangles.len();
        let (mut min_angle, mut max_angle, mut area) = (180.0f64, 0.0f64, 0.0);
        for t in (0..triangles).map(TriangleId::new) {
            self.verifier.pace.step()?;
            let shape = Shape::of(self.places(t));
            min_angle = min_angle.min(shape.min_angle());
            max_angle = max_angle.max(shape.max_angle());
            area += shape.area;
        }
        self.verifier.pace.finish();
        let data = self.data.len() - held.duplicates;
        Ok(CoverCertificate {
            vertices: self.verifier.points.len(),
            triangles,
            edges: (3 * triangles + border_edges) / 2,
            border_edges,
            data,
            duplicates: held.duplicates,
            least: self.least,
            fewest: held.counts.iter().copied().min().unwrap_or(0),
            most: held.counts.iter().copied().max().unwrap_or(0),
            mean: data as f64 / triangles as f64,
            histogram: held.histogram(),
            special,
            min_angle,
            max_angle,
            area,
            hash,
        })
    }
}
