//! Who could hold which datum: augmenting paths.

use delone::predicates::{Orientation, orient2d};
use delone::{Point, TriangleId, VertexId};

/// Finds a triangle for each datum, of those that contain it, so that each triangle holds at least `least`; equal
/// data go to the same and count once. `None` if that cannot be, or a datum lies in no triangle.
///
/// Triangles must be counter-clockwise. *Cost*: O(t d l t) for t triangles, l data and d = `least`.
pub fn naive_sharing(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    data: &[Point],
    least: usize,
) -> Option<Vec<TriangleId>> {
    let mut matching = Matching::new(points, triangles, data)?;
    for triangle in 0..triangles.len() {
        for _ in 0..least {
            if !matching.feed(triangle, &mut vec![false; triangles.len()]) {
                return None;
            }
        }
    }
    let holder = |datum: usize| {
        let first = data.iter().position(|&p| p == data[datum]);
        let first = first.expect("a datum equals itself");
        matching.holder[first].unwrap_or(matching.options[first][0])
    };
    Some(
        (0..data.len())
            .map(|d| TriangleId::new(holder(d)))
            .collect(),
    )
}

/// Returns the largest number that each triangle can hold at least; `None` if a datum lies in no triangle, or
/// there are no triangles.
pub fn naive_largest_least(
    points: &[Point],
    triangles: &[[VertexId; 3]],
    data: &[Point],
) -> Option<usize> {
    let can = |&least: &usize| naive_sharing(points, triangles, data, least).is_some();
    if triangles.is_empty() {
        return None;
    }
    // More data for one triangle cannot be had if fewer cannot.
    (0..=data.len() / triangles.len()).take_while(can).last()
}

/// Lists the triangles that contain a point, border included.
pub fn triangles_at(points: &[Point], triangles: &[[VertexId; 3]], p: Point) -> Vec<usize> {
    let is_inside = |&t: &usize| {
        let [a, b, c] = triangles[t].map(|v| points[v.index()]);
        let sides = [(a, b), (b, c), (c, a)];
        sides
            .iter()
            .all(|&(from, to)| orient2d(from, to, p) != Orientation::Right)
    };
    (0..triangles.len()).filter(is_inside).collect()
}

/// Some data, each in at most one triangle.
struct Matching {
    /// The triangles that contain each datum; none for one that equals an earlier one.
    options: Vec<Vec<usize>>,
    holder: Vec<Option<usize>>,
}

impl Matching {
    /// Starts with nothing held; `None` if a datum lies in no triangle.
    fn new(points: &[Point], triangles: &[[VertexId; 3]], data: &[Point]) -> Option<Self> {
        let options = (0..data.len()).map(|datum| {
            let options = triangles_at(points, triangles, data[datum]);
            let is_first = !data[..datum].contains(&data[datum]);
            let is_covered = !options.is_empty();
            is_covered.then(|| if is_first { options } else { Vec::new() })
        });
        Some(Self {
            options: options.collect::<Option<_>>()?,
            holder: vec![None; data.len()],
        })
    }

    /// Gives a triangle one more datum: a free one, or one of another triangle that can be given one in turn.
    fn feed(&mut self, triangle: usize, asked: &mut [bool]) -> bool {
        asked[triangle] = true;
        for datum in 0..self.options.len() {
            if !self.options[datum].contains(&triangle) {
                continue;
            }
            let can_have = match self.holder[datum] {
                None => true,
                Some(other) => !asked[other] && self.feed(other, asked),
            };
            if can_have {
                self.holder[datum] = Some(triangle);
                return true;
            }
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::generate::{Kind, Random};

    fn square() -> (Vec<Point>, Vec<[VertexId; 3]>) {
        let points = [(0, 0), (2, 0), (2, 2), (0, 2)];
        let points = points.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
        let triangles = [[0, 1, 2], [0, 2, 3]].map(|t| t.map(VertexId::new));
        (points.to_vec(), triangles.to_vec())
    }

    /// Tries all choices.
    fn by_trying(options: &[Vec<usize>], held: &mut [usize], least: usize) -> bool {
        match options.split_first() {
            None => held.iter().all(|&held| held >= least),
            Some((first, rest)) => first.iter().any(|&t| {
                held[t] += 1;
                let found = by_trying(rest, held, least);
                held[t] -= 1;
                found
            }),
        }
    }

    #[test]
    fn data_on_the_diagonal_go_where_they_are_needed() {
        let (points, triangles) = square();
        let data = [(1, 1), (1, 0), (2, 1), (0, 0), (1, 1), (2, 2)];
        let data = data.map(|(x, y)| Point::new(f64::from(x), f64::from(y)));
        // Two below the diagonal, three on it, one of them twice.
        assert_eq!(naive_largest_least(&points, &triangles, &data), Some(2));
        let holders = naive_sharing(&points, &triangles, &data, 2).expect("2 each");
        assert_eq!(holders[0], holders[4]);
        assert_eq!(naive_sharing(&points, &triangles, &data, 3), None);
        assert_eq!(
            naive_largest_least(&points, &triangles, &[Point::new(3.0, 0.0)]),
            None
        );
        assert_eq!(naive_largest_least(&points, &triangles, &[]), Some(0));
    }

    #[test]
    fn it_finds_what_trying_finds() {
        let points: Vec<Point> = [(0, 0), (2, 0), (4, 0), (0, 2), (2, 2), (4, 2)]
            .iter()
            .map(|&(x, y)| Point::new(f64::from(x), f64::from(y)))
            .collect();
        let triangles = [[0, 1, 4], [0, 4, 3], [1, 2, 4], [2, 5, 4]].map(|t| t.map(VertexId::new));
        let mut random = Random::new(7);
        for seed in 0..200 {
            let mut data = Kind::Lattice { side: 5 }.points(1 + random.below(9), seed);
            data.retain(|p| p.y <= 2.0);
            let distinct: Vec<_> = super::super::distinct(&data)
                .into_iter()
                .map(|datum| triangles_at(&points, &triangles, data[datum]))
                .collect();
            let expected = (0..9).take_while(|&least| by_trying(&distinct, &mut [0; 4], least));
            let found = naive_largest_least(&points, &triangles, &data);
            assert_eq!(found, expected.last(), "{data:?}");
        }
    }
}
