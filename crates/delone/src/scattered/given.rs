//! Triangulations that a caller brings, with data and who holds them.
//!
//! What is checked is what others rely on: everything is finite and in range, triangles turn counter-clockwise, no
//! two lie on the same side of an edge, each datum lies in the triangle that holds it, and each triangle holds
//! enough. That triangles do not overlap otherwise and leave no holes is not.
//!
//! *Cost*: O(n log n), for finding equal data and common edges.

use super::{Cause, DataTriangulation, Exception};
use crate::predicates::{Orientation, orient2d};
use crate::{Duplicate, Error, Point, TriangleId, VertexId};

impl DataTriangulation {
    /// Makes one of the caller's own triangulation: vertices and triangles, corners counter-clockwise, the data, for
    /// each the triangle that holds it, and how many each triangle is to hold at least.
    ///
    /// Of equal data the first counts, and all must have the same holder. A triangle may hold more than
    /// 3 `least` − 1; it is then an exception, of the cause [`Cause::Untried`].
    ///
    /// Assumes that triangles which share no edge do not overlap, and share no more than a corner.
    ///
    /// ```
    /// use delone::scattered::DataTriangulation;
    /// use delone::{Point, TriangleId, VertexId};
    /// let corners = [(0.0, 0.0), (4.0, 0.0), (0.0, 4.0)].map(Point::from);
    /// let data = [(1.0, 1.0), (2.0, 2.0)].map(Point::from); // the second on an edge
    /// let triangle = [0, 1, 2].map(VertexId::new);
    /// let holders = vec![TriangleId::new(0); 2];
    /// let t = DataTriangulation::from_parts(data.into(), corners.into(), vec![triangle], holders, 1)?;
    /// assert_eq!(t.counts(), [2]);
    /// # Ok::<(), delone::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::BadChoice`] if `least` is 0; [`Error::NotFinite`] names a datum or a vertex, and
    /// [`Error::TooManyPoints`] says that 32 bits cannot number them; [`Error::BadTriangle`] names a triangle with a
    /// corner that does not exist, [`Error::BadStart`] one that does not turn counter-clockwise, [`Error::SameSide`]
    /// two on the same side of an edge; [`Error::ValuesMissing`] if not every datum has a holder;
    /// [`Error::BadHolder`] names a datum whose holder does not exist or does not contain it, or is not that of an
    /// equal datum; [`Error::DomainTooEmpty`] a triangle that holds fewer than `least`.
    pub fn from_parts(
        mut data: Vec<Point>,
        mut points: Vec<Point>,
        triangles: Vec<[VertexId; 3]>,
        holders: Vec<TriangleId>,
        least: usize,
    ) -> Result<Self, Error> {
        if least == 0 {
            return Err(Error::BadChoice {
                what: "the number of data that each triangle is to hold",
                given: 0.0,
                must: "it must be at least 1",
            });
        }
        normalize(&mut data)?;
        normalize(&mut points)?;
        check_triangles(&points, &triangles)?;
        let duplicates = equal_points(&data);
        let mut made = Self {
            data,
            duplicates,
            points,
            triangles,
            holders,
            least,
            exceptions: Vec::new(),
        };
        made.check_holders()?;
        made.exceptions = made.check_counts()?;
        Ok(made)
    }

    /// Fails unless every datum lies in its holder, and equal ones in the same.
    fn check_holders(&self) -> Result<(), Error> {
        let (given, expected) = (self.holders.len(), self.data.len());
        if given != expected {
            return Err(Error::ValuesMissing {
                given,
                expected,
                what: "holders",
            });
        }
        for (datum, (&p, &triangle)) in self.data.iter().zip(&self.holders).enumerate() {
            let why = match self.triangles.get(triangle.index()) {
                None => "which does not exist",
                Some(corners) if !contains(corners.map(|v| self.points[v.index()]), p) => {
                    "in which it does not lie"
                }
                Some(_) => continue,
            };
            return Err(Error::BadHolder {
                datum,
                triangle,
                why,
            });
        }
        let holder = |v: VertexId| self.holders[v.index()];
        let mut duplicates = self.duplicates.iter();
        match duplicates.find(|d| holder(d.dropped) != holder(d.kept)) {
            None => Ok(()),
            Some(d) => Err(Error::BadHolder {
                datum: d.dropped.index(),
                triangle: holder(d.dropped),
                why: "an equal one before it by another",
            }),
        }
    }

    /// Fails if a triangle holds too few; returns those that hold too many.
    fn check_counts(&self) -> Result<Vec<Exception>, Error> {
        let counts = self.counts();
        if let Some(poor) = counts.iter().position(|&data| data < self.least) {
            return Err(Error::DomainTooEmpty {
                triangle: self.triangles[poor].map(|v| self.points[v.index()]),
                data: counts[poor],
                least: self.least,
            });
        }
        let most = self.most();
        let rich = counts.iter().enumerate().filter(|(_, data)| **data > most);
        let exception = |(t, &data)| Exception {
            triangle: TriangleId::new(t),
            data,
            cause: Cause::Untried,
        };
        Ok(rich.map(exception).collect())
    }
}

/// Refuses what is not finite or too much, and makes 0.0 of −0.0.
fn normalize(points: &mut [Point]) -> Result<(), Error> {
    let (given, limit) = (points.len(), u32::MAX as usize);
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    crate::locate::check_finite(points)?;
    for p in points {
        *p = Point::new(p.x + 0.0, p.y + 0.0);
    }
    Ok(())
}

fn check_triangles(points: &[Point], triangles: &[[VertexId; 3]]) -> Result<(), Error> {
    let (given, limit) = (triangles.len(), u32::MAX as usize / 3);
    if given > limit {
        return Err(Error::TooManyPoints { given, limit });
    }
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&vertex) = corners.iter().find(|v| v.index() >= points.len()) {
            return Err(Error::BadTriangle {
                triangle,
                vertex,
                points: points.len(),
            });
        }
        let [a, b, c] = corners.map(|v| points[v.index()]);
        if orient2d(a, b, c) != Orientation::Left {
            let why = "its corners do not turn counter-clockwise";
            return Err(Error::BadStart { triangle, why });
        }
    }
    check_sides(triangles)
}

/// Fails if two triangles lie on the same side of an edge.
fn check_sides(triangles: &[[VertexId; 3]]) -> Result<(), Error> {
    let sides = triangles.iter().enumerate().flat_map(|(t, &[a, b, c])| {
        let side = move |edge: [VertexId; 2]| (edge, t);
        [[a, b], [b, c], [c, a]].map(side)
    });
    let mut sides: Vec<_> = sides.collect();
    sides.sort_unstable();
    match sides.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        None => Ok(()),
        Some(pair) => Err(Error::SameSide {
            triangles: [pair[0].1, pair[1].1],
            edge: pair[0].0,
        }),
    }
}

/// Lists the points that equal an earlier one, sorted by index.
fn equal_points(points: &[Point]) -> Vec<Duplicate> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_unstable_by(|&i, &j| points[i].lex_cmp(&points[j]).then(i.cmp(&j)));
    let groups = order.chunk_by(|&i, &j| points[i] == points[j]);
    let mut duplicates: Vec<_> = groups
        .flat_map(|group| {
            let kept = VertexId::new(group[0]);
            group[1..].iter().map(move |&i| Duplicate {
                dropped: VertexId::new(i),
                kept,
            })
        })
        .collect();
    duplicates.sort_unstable_by_key(|d| d.dropped);
    duplicates
}

/// Tells whether a point lies in a closed triangle whose corners turn counter-clockwise.
fn contains([a, b, c]: [Point; 3], p: Point) -> bool {
    [[a, b], [b, c], [c, a]]
        .iter()
        .all(|&[from, to]| orient2d(from, to, p) != Orientation::Right)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles that make a square, and five data, one of them on the diagonal, two of them equal.
    struct Parts {
        data: Vec<Point>,
        points: Vec<Point>,
        triangles: Vec<[VertexId; 3]>,
        holders: Vec<TriangleId>,
        least: usize,
    }

    fn square() -> Parts {
        let list = |points: &[(f64, f64)]| points.iter().map(|&p| p.into()).collect();
        Parts {
            data: list(&[(3., 1.), (2., 2.), (1., 3.), (4., -0.), (3., 1.)]),
            points: list(&[(0., 0.), (4., 0.), (4., 4.), (0., 4.)]),
            triangles: [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::new)).into(),
            holders: [0, 1, 1, 0, 0].map(TriangleId::new).into(),
            least: 2,
        }
    }

    fn make(change: impl FnOnce(&mut Parts)) -> Result<DataTriangulation, Error> {
        let mut parts = square();
        change(&mut parts);
        let Parts {
            data,
            points,
            triangles,
            holders,
            least,
        } = parts;
        DataTriangulation::from_parts(data, points, triangles, holders, least)
    }

    #[test]
    fn equal_data_count_once() {
        let made = make(|_| {}).expect("a data triangulation");
        let [kept, dropped] = [0, 4].map(VertexId::new);
        assert_eq!(made.duplicates(), [Duplicate { dropped, kept }]);
        assert_eq!((made.counts(), made.num_data()), (vec![2, 2], 4));
        assert!(made.exceptions().is_empty());
        assert!(made.data()[3].y.is_sign_positive());
    }

    #[test]
    fn a_triangle_that_holds_much_is_an_exception() {
        let made = make(|parts| {
            parts.least = 1;
            parts.data.push(Point::new(3.0, 2.0));
            parts.holders.push(TriangleId::new(0));
        });
        let exception = Exception {
            triangle: TriangleId::new(0),
            data: 3,
            cause: Cause::Untried,
        };
        assert_eq!(made.expect("given").exceptions(), [exception]);
    }

    #[test]
    fn what_is_wrong_is_named() {
        type Change = fn(&mut Parts);
        let cases: [(Change, &str); 12] = [
            (|p| p.least = 0, "at least 1"),
            (|p| p.least = 3, "holds 2 data"),
            (|p| p.data[2].x = f64::NAN, "point 2 is (NaN, 3)"),
            (|p| p.points[1].y = f64::INFINITY, "point 1 is (4, inf)"),
            (
                |p| p.triangles[1][0] = VertexId::INFINITE,
                "triangle 1 names point",
            ),
            (|p| p.triangles[1].swap(0, 1), "counter-clockwise"),
            (|p| p.points[1] = Point::new(2., 2.), "counter-clockwise"),
            (
                |p| p.triangles.push(p.triangles[0]),
                "triangles 0 and 2 lie on the same side",
            ),
            (
                |p| p.holders.truncate(4),
                "4 holders given for 5 points; each needs one",
            ),
            (
                |p| p.holders[1] = TriangleId::new(2),
                "datum 1 is said to be held by triangle 2, which does not exist",
            ),
            (
                |p| p.holders[0] = TriangleId::new(1),
                "datum 0 is said to be held by triangle 1, in which it does not lie",
            ),
            (
                |p| {
                    p.data[4] = p.data[1];
                    p.holders[4] = TriangleId::new(0);
                },
                "datum 4 is said to be held by triangle 0, an equal one before it by another",
            ),
        ];
        for (change, expected) in cases {
            let error = make(change).expect_err(expected).to_string();
            assert!(error.contains(expected), "{error}");
        }
    }
}
