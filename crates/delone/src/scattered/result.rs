//! What comes out: triangles, and who holds which datum.

use super::field::Field;
use crate::check::{CoverVerdict, verify_cover};
use crate::{Duplicate, Error, Observer, Point, TriangleId, VertexId, Watch};

/// A triangulation each of whose triangles holds at least d of the data, and, but for
/// [exceptions](Self::exceptions) that are named, at most 3d − 1.
#[derive(Clone, Debug, PartialEq)]
pub struct DataTriangulation {
    pub(super) data: Vec<Point>,
    pub(super) duplicates: Vec<Duplicate>,
    pub(super) points: Vec<Point>,
    pub(super) triangles: Vec<[VertexId; 3]>,
    pub(super) holders: Vec<TriangleId>,
    pub(super) least: usize,
    pub(super) exceptions: Vec<Exception>,
}

/// A triangle that holds more than 3d − 1 data, and why.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Exception {
    /// The triangle.
    pub triangle: TriangleId,
    /// How many data it holds.
    pub data: usize,
    /// Why no vertex opens it.
    pub cause: Cause,
}

/// Why a triangle that holds 3d data or more cannot be opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Cause {
    /// Without the data on one of its open edges it holds fewer than 2d.
    Edge {
        /// The ends of the edge.
        edge: [VertexId; 2],
        /// How many of its data lie on it.
        data: usize,
    },
    /// Without the data on two of its edges (their common end included, the other ends not) it holds fewer than d.
    TwoEdges {
        /// The common end.
        corner: VertexId,
        /// How many of its data lie on them.
        data: usize,
    },
    /// There is such a place, but no point with double-precision coordinates was found in it.
    Resolution,
    /// Nobody tried: Algorithm C did not run, or the triangulation was [brought](DataTriangulation::from_parts) as it
    /// is.
    Untried,
}

impl DataTriangulation {
    /// Returns the data, as they were given, but for −0.0, which has become 0.0.
    pub fn data(&self) -> &[Point] {
        &self.data
    }

    /// Returns the data that equal an earlier one. They count no more, and their holder is that of the earlier one.
    pub fn duplicates(&self) -> &[Duplicate] {
        &self.duplicates
    }

    /// Counts the data, equal ones once.
    pub fn num_data(&self) -> usize {
        self.data.len() - self.duplicates.len()
    }

    /// Returns the vertices.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Returns the triangles, corners counter-clockwise.
    pub fn triangles(&self) -> &[[VertexId; 3]] {
        &self.triangles
    }

    /// Returns the triangle that holds each datum.
    pub fn holders(&self) -> &[TriangleId] {
        &self.holders
    }

    /// Returns d: how many data each triangle holds at least.
    pub fn least(&self) -> usize {
        self.least
    }

    /// Returns how many data a triangle may hold: 3d − 1.
    pub fn most(&self) -> usize {
        3 * self.least - 1
    }

    /// Returns the triangles that hold more, ascending, each with its cause.
    pub fn exceptions(&self) -> &[Exception] {
        &self.exceptions
    }

    /// Lets the independent [verifier](crate::check::verify_cover) decide whether this is what it says: a polygon covered
    /// without overlap, every datum in the triangle that holds it, in each at least d, and where more than 3d − 1,
    /// whether data on edges excuse that.
    ///
    /// ```
    /// let data = (0..100).map(|i| (f64::from(i * 37 % 101), f64::from(i * 59 % 97)));
    /// let cover = delone::scattered::cover(data, 5)?;
    /// let certificate = cover.verify(&())?.into_result()?;
    /// assert!(certificate.fewest >= 5 && certificate.most < 15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Cancelled`]; that something is wrong is no error but a verdict.
    ///
    /// *Cost*: O(n log n), about that of the cover itself.
    pub fn verify(&self, watch: &dyn Watch) -> Result<CoverVerdict, Error> {
        let Self {
            points,
            triangles,
            data,
            holders,
            ..
        } = self;
        verify_cover(points, triangles, data, holders, self.least, watch)
    }

    /// Counts the data that each triangle holds, equal ones once. *Cost*: linear.
    pub fn counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.triangles.len()];
        self.holders.iter().for_each(|t| counts[t.index()] += 1);
        for duplicate in &self.duplicates {
            counts[self.holders[duplicate.dropped.index()].index()] -= 1;
        }
        counts
    }
}

/// Hands out what a field has come to.
pub(super) fn hand_out(
    field: &Field<impl Observer>,
    least: usize,
    exceptions: Vec<Exception>,
) -> DataTriangulation {
    let mesh = &field.draft.mesh;
    let data = field.data;
    // Ghosts are among the faces.
    let ids: Vec<_> = mesh.triangles().collect();
    let mut new_ids = vec![TriangleId::new(0); mesh.num_faces()];
    let mut holders = vec![TriangleId::new(0); data.given.len()];
    for (i, &t) in ids.iter().enumerate() {
        new_ids[t.index()] = TriangleId::new(i);
        for held in field.stock.held(t) {
            holders[data.names[held.datum()].index()] = TriangleId::new(i);
        }
    }
    for duplicate in &data.duplicates {
        holders[duplicate.dropped.index()] = holders[duplicate.kept.index()];
    }
    let exceptions = exceptions.into_iter().map(|exception| Exception {
        triangle: new_ids[exception.triangle.index()],
        ..exception
    });
    DataTriangulation {
        data: data.given.clone(),
        duplicates: data.duplicates.clone(),
        points: field.draft.points.clone(),
        triangles: ids.iter().map(|&t| mesh.corners(t)).collect(),
        holders,
        least,
        exceptions: exceptions.collect(),
    }
}
