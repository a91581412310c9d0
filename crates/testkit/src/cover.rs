//! Data triangulations made in the plainest way, for tests of what is done with them.

use delone::locate::Locator;
use delone::scattered::DataTriangulation;
use delone::{Error, Point, Triangulation};

/// Gives each datum to the triangle of lowest number that it lies in.
pub fn assigned(
    t: &Triangulation,
    data: &[Point],
    least: usize,
) -> Result<DataTriangulation, Error> {
    let locator = Locator::new(t);
    let holder = |(datum, &at): (usize, &Point)| {
        let triangle = locator.locate(at)?.triangle(t);
        triangle.ok_or(Error::DatumOutside { datum, at })
    };
    let holders: Result<_, Error> = data.iter().enumerate().map(holder).collect();
    let (points, triangles) = (t.points().to_vec(), t.triangles().to_vec());
    DataTriangulation::from_parts(data.to_vec(), points, triangles, holders?, least)
}

/// The Delaunay triangulation of a lattice of `side` × `side` cells over a box, every datum with the lowest triangle
/// that it lies in.
pub fn lattice(
    [low, high]: [Point; 2],
    side: usize,
    data: &[Point],
    least: usize,
) -> Result<DataTriangulation, Error> {
    // The last is the high end, to the last bit.
    let at = |low: f64, high: f64, i: usize| {
        let share = i as f64 / side as f64;
        low * (1.0 - share) + high * share
    };
    let rows = (0..=side).flat_map(|row| (0..=side).map(move |column| [column, row]));
    let points = rows.map(|[i, j]| [at(low.x, high.x, i), at(low.y, high.y, j)]);
    assigned(&delone::triangulate(points)?, data, least)
}

/// Halton's points with bases 2 and 3, from the first on.
pub fn halton(n: usize) -> Vec<Point> {
    let inverse = |mut i: usize, base: usize| {
        let (mut share, mut result) = (1.0, 0.0);
        while i > 0 {
            share /= base as f64;
            result += share * (i % base) as f64;
            i /= base;
        }
        result
    };
    (1..=n)
        .map(|i| Point::new(inverse(i, 2), inverse(i, 3)))
        .collect()
}
