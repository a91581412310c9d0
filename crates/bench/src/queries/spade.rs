//! `spade` at queries.

use super::job::Answer;
use super::question::{Question, square};
use crate::measure::under_the_clock;
use spade::{
    DelaunayTriangulation, HierarchyHintGenerator, Point2, PositionInTriangulation, Triangulation,
};

type Mesh = DelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// Builds and asks, one query after the other.
///
/// # Errors
/// What spade says.
pub fn answer(
    points: Vec<[f64; 2]>,
    asked: &[[f64; 2]],
    question: Question,
    check: bool,
) -> Result<Answer, String> {
    let points = points.into_iter().map(|[x, y]| Point2::new(x, y)).collect();
    let asked: Vec<_> = asked.iter().map(|&[x, y]| Point2::new(x, y)).collect();
    let (mesh, build) = under_the_clock(|| Mesh::bulk_load(points));
    let mesh = mesh.map_err(|error| error.to_string())?;
    let (queries, sum) = if question == Question::Locate {
        let (found, queries) =
            under_the_clock(|| asked.iter().map(|&p| mesh.locate(p)).collect::<Vec<_>>());
        let is_inside = |place: &&PositionInTriangulation| {
            !matches!(place, PositionInTriangulation::OutsideOfConvexHull(_))
        };
        (
            queries,
            check.then(|| found.iter().filter(is_inside).count() as f64),
        )
    } else {
        let (found, queries) = under_the_clock(|| {
            let nearest = |&p| mesh.nearest_neighbor(p).map(|vertex| vertex.fix());
            asked.iter().map(nearest).collect::<Vec<_>>()
        });
        let squares = asked.iter().zip(found).filter_map(|(p, vertex)| {
            let q = mesh.vertex(vertex?).position();
            Some(square([p.x, p.y], [q.x, q.y]))
        });
        (queries, check.then(|| squares.sum()))
    };
    Ok(Answer {
        build,
        queries,
        sum,
    })
}
