//! What every surface can be asked, and what remembers where the last question was answered.

use super::ground::{Place, Spot};
use super::natural::Scratch;
use super::number::{Vector, cross, share_along, shares};
use super::{Ground, Samples};
use crate::{Point, TriangleId, VertexId};

/// A value and how it changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jet {
    /// The value.
    pub value: f64,
    /// Its change along x and along y, in values per unit of the coordinates.
    pub gradient: [f64; 2],
}

/// Where the last question was answered, and room to work in.
///
/// Questions asked one after the other with one cursor are answered fast if they lie near each other.
/// The answers do not depend on it, and any cursor will do for any surface.
#[derive(Clone, Debug)]
pub struct Cursor {
    pub(super) near: TriangleId,
    pub(super) scratch: Scratch,
}

impl Default for Cursor {
    fn default() -> Self {
        Self {
            near: TriangleId::new(0),
            scratch: Scratch::default(),
        }
    }
}

/// A surface that can be asked anywhere.
///
/// It goes through values at the vertices of a triangulation: there the value is that vertex's, to the last bit, and
/// on the border of the triangles only the two ends of the edge count. [`LocalFits`](super::LocalFits) alone, asked in
/// the same way, only comes near to its values. Outside there is none. Values are rounded, yet depend on nothing but
/// triangulation, values and point: not on the order of questions, nor on threads.
pub trait Interpolant: Sync {
    /// Returns the value at a point; `None` outside, and for coordinates that are not finite.
    ///
    /// *Cost*: a walk from where the cursor is, about √n triangles from afar, a few from nearby.
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64>;

    /// As [`value_near`](Self::value_near), with the gradient. Where a surface has an edge or a tip, it is
    /// that on one side, always the same one.
    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet>;

    /// Returns the value at a point; `None` outside.
    ///
    /// *Cost*: that of a walk from far away; a [`Cursor`], or [`Evaluation`](super::Evaluation) for many
    /// points, is faster.
    fn value(&self, p: Point) -> Option<f64> {
        self.value_near(p, &mut Cursor::default())
    }

    /// Returns the value and the gradient at a point; `None` outside.
    fn value_and_gradient(&self, p: Point) -> Option<Jet> {
        self.jet_near(p, &mut Cursor::default())
    }
}

/// The surface that is flat over every triangle: continuous, with edges.
///
/// ```
/// use delone::surface::{Interpolant, Linear, Samples};
/// let t = delone::triangulate([(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)])?;
/// let samples = Samples::new(&t, [1.0, 3.0, 5.0])?;
/// let surface = Linear::new(&samples);
/// assert_eq!(surface.value((1.0, 2.0).into()), Some(3.5));
/// assert_eq!(surface.value((3.0, 3.0).into()), None);
/// let jet = surface.value_and_gradient((1.0, 1.0).into()).expect("inside");
/// assert_eq!(jet.gradient, [0.5, 1.0]);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Linear<'a> {
    samples: &'a Samples<'a>,
}

impl<'a> Linear<'a> {
    /// Makes the surface.
    pub fn new(samples: &'a Samples<'a>) -> Self {
        Self { samples }
    }
}

impl Interpolant for Linear<'_> {
    fn value_near(&self, p: Point, cursor: &mut Cursor) -> Option<f64> {
        let place = self.samples.ground().place(p, &mut cursor.near)?;
        Some(value_at(self.samples, place, p))
    }

    fn jet_near(&self, p: Point, cursor: &mut Cursor) -> Option<Jet> {
        let place = self.samples.ground().place(p, &mut cursor.near)?;
        Some(Jet {
            value: value_at(self.samples, place, p),
            gradient: slope(self.samples, place.triangle),
        })
    }
}

/// Returns the value of the linear surface.
pub(super) fn value_at(samples: &Samples<'_>, place: Place, p: Point) -> f64 {
    match place.spot {
        Spot::Vertex(v) => samples.value(v),
        _ => super::number::blend(
            linear_shares(&samples.ground(), place, p)
                .into_iter()
                .filter(|(_, share)| *share > 0.0)
                .map(|(v, share)| (share, samples.value(v))),
        ),
    }
}

/// Returns the corners of the place's triangle with their shares in the point; on an edge, exactly
/// nothing belongs to the corner beyond, and on a vertex all to that.
pub(super) fn linear_shares(ground: &Ground<'_>, place: Place, p: Point) -> [(VertexId, f64); 3] {
    let corners = ground.mesh().corners(place.triangle);
    let shares = match place.spot {
        Spot::Face => shares(ground.corners(place.triangle), p),
        Spot::Vertex(v) => corners.map(|c| f64::from(u8::from(c == v))),
        Spot::Edge(h) => {
            let points = ground.corners(place.triangle);
            let [k, i, j] = [0, 1, 2].map(|step| (h.slot() + step) % 3);
            let share = share_along([points[i], points[j]], p);
            let mut shares = [0.0; 3];
            (shares[k], shares[i], shares[j]) = (0.0, 1.0 - share, share);
            shares
        }
    };
    [0, 1, 2].map(|k| (corners[k], shares[k]))
}

/// Returns the gradient of the plane over triangle `t`; infinite or NaN where `f64` cannot hold it.
pub(super) fn slope(samples: &Samples<'_>, t: TriangleId) -> [f64; 2] {
    let ground = samples.ground();
    let values = ground.mesh().corners(t).map(|v| samples.value(v));
    let gradients = share_gradients(ground.corners(t));
    // The first value times the sum of the gradients, which is zero, is left out.
    let rise = [1, 2].map(|k| values[k] - values[0]);
    [0, 1].map(|axis| rise[0] * gradients[1][axis] + rise[1] * gradients[2][axis])
}

/// Returns how the shares of the three corners change along x and y.
pub(super) fn share_gradients(corners: [Point; 3]) -> [[f64; 2]; 3] {
    use super::number::Frame;
    let frame = Frame::by_axis(corners[0], corners.into_iter());
    let vectors: [Vector<f64>; 3] = corners.map(|c| frame.vector(c));
    let mut area = cross(vectors[1], vectors[2]);
    if area < 0.03 {
        let [u, v] = [1, 2].map(|k| frame.vector::<crate::predicates::Double>(corners[k]));
        area = super::number::Number::value(cross(u, v));
    }
    [0, 1, 2].map(|k| {
        let [a, b] = [vectors[(k + 1) % 3], vectors[(k + 2) % 3]];
        // Perpendicular to the edge opposite the corner, one over the height long.
        [
            (a[1] - b[1]) / area * frame.scale[0],
            (b[0] - a[0]) / area * frame.scale[1],
        ]
    })
}
