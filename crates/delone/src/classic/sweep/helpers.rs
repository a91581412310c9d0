//! The two helper points: where they are placed, and how they go again.

use crate::classic::Board;
use crate::predicates::Orientation;
use crate::{Error, HalfEdgeId, Observer, Point, VertexId};

/// Places the two helper points to the left of all vertices, the lower one first. There are none for fewer than
/// two vertices, and if nothing lies to their left.
pub(super) fn place<O: Observer>(
    board: &mut Board<O>,
    vertices: &[VertexId],
) -> Result<Vec<VertexId>, Error> {
    let points = vertices.iter().map(|&v| board.point(v));
    let helpers = if vertices.len() < 2 {
        None
    } else {
        places(points)
    };
    let places = helpers.into_iter().flatten();
    places.map(|at| board.create_vertex(at)).collect()
}

/// Computes where helper points lie: (x₀ − 1, 2y₀ − y₁) and (x₀ − 1, 2y₁ − y₀), if abscissas begin at x₀ and
/// ordinates lie between y₀ and y₁.
pub(in crate::classic) fn places(points: impl Iterator<Item = Point>) -> Option<[Point; 2]> {
    let all = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY];
    let [x, low, high] = points.fold(all, |[x, low, high], p| {
        [x.min(p.x), low.min(p.y), high.max(p.y)]
    });
    let x = (x - 1.0).min(x.next_down());
    let height = high - low;
    let [below, above] = if height > 0.0 {
        [low - height, high + height]
    } else {
        [
            (low - 1.0).min(low.next_down()),
            (high + 1.0).max(high.next_up()),
        ]
    };
    let within = |c: f64| c.clamp(-f64::MAX, f64::MAX);
    x.is_finite()
        .then(|| [below, above].map(|y| Point::new(x, within(y))))
}

/// Removes a helper point from the hull, and closes the dents that it leaves.
///
/// ```text
///        u2          Seen from v, u1 lies behind the line from u0 to u2: that is a dent, and the spoke
///       /  '-.       v–u1 is flipped, which closes it by the triangle u0 u1 u2. Where it has no dents
///     v ---- u1      any more, the chain of neighbours becomes part of the hull.
///       \   /
///        u0
/// ```
pub(super) fn strip<O: Observer>(board: &mut Board<O>, v: VertexId) {
    board.at(8);
    let mut spoke = first_spoke(board, v);
    while let [before, u, after] = around(board, spoke)
        && !u.is_infinite()
    {
        board.at(9);
        let is_end = before.is_infinite() || after.is_infinite();
        if !is_end && board.orient(before, u, after) == Orientation::Left {
            board.at(10);
            board.flip(spoke); // Now it leads to the neighbour before.
        } else {
            spoke = board.mesh().onext(spoke);
        }
    }
    board.at(11);
    board.uncover(spoke);
    board.delete_last_vertex();
}

/// Returns the vertices that a spoke lies between, and in the middle the one that it leads to.
fn around<O: Observer>(board: &Board<O>, spoke: HalfEdgeId) -> [VertexId; 3] {
    let mesh = board.mesh();
    [
        mesh.apex(mesh.twin(spoke)),
        mesh.dest(spoke),
        mesh.apex(spoke),
    ]
}

/// Finds the spoke of a hull vertex that follows the one to infinity counter-clockwise.
fn first_spoke<O: Observer>(board: &Board<O>, v: VertexId) -> HalfEdgeId {
    let mesh = board.mesh();
    let ghost = mesh.ghosts().find(|&t| mesh.corners(t).contains(&v));
    let ghost = ghost.expect("bug: the vertex is not on the hull");
    let of_ghost = ghost.half_edges().into_iter();
    let mut leading = of_ghost.flat_map(|h| [h, mesh.twin(h)]);
    let to_infinity = leading.find(|&h| mesh.origin(h) == v && mesh.dest(h).is_infinite());
    mesh.onext(to_infinity.expect("bug: a ghost has two spokes to infinity"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: &[(f64, f64)]) -> Option<[Point; 2]> {
        places(points.iter().map(|&p| p.into()))
    }

    fn at(points: [(f64, f64); 2]) -> Option<[Point; 2]> {
        Some(points.map(Point::from))
    }

    #[test]
    fn helpers_lie_where_the_thesis_puts_them() {
        assert_eq!(
            of(&[(0.0, 0.0), (3.0, 4.0)]),
            at([(-1.0, -4.0), (-1.0, 8.0)])
        );
        assert_eq!(
            of(&[(0.0, 2.0), (3.0, 2.0)]),
            at([(-1.0, 1.0), (-1.0, 3.0)])
        );
    }

    #[test]
    fn helpers_are_representable_left_of_all_and_apart() {
        let big = 1e20;
        assert_eq!(
            of(&[(big, big), (2.0 * big, big)]),
            at([
                (big.next_down(), big.next_down()),
                (big.next_down(), big.next_up())
            ])
        );
        let end = f64::MAX;
        let [low, high] = of(&[(0.0, end), (end, end)]).expect("room to the left");
        assert_eq!([low.y, high.y], [end.next_down(), end]);
        let [low, high] = of(&[(0.0, -end), (1.0, end)]).expect("room to the left");
        assert_eq!([low.y, high.y], [-end, end]);
        assert_eq!(of(&[(-end, 0.0), (1.0, 1.0)]), None);
    }
}
