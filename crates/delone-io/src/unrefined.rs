//! What was there before refinement: the vertices that are no Steiner points, and the pieces of segments between them.
//!
//! Refinement adds its vertices behind all others, so a number tells whether a vertex is one of them. Without these the
//! chains of segments are what noding has left: they meet at vertices only, and their constrained triangulation is the
//! one that refinement began with.

use delone::{Point, Pslg, VertexId};

/// Draws the vertices that are no Steiner points, which `points` lists, with the pieces of chains between them.
pub(crate) fn drawing<'c>(points: &[Point], chains: impl Iterator<Item = &'c [VertexId]>) -> Pslg {
    let pieces = chains.flat_map(|chain| pieces(chain, points.len()));
    let ends = pieces.filter_map(|piece| Some([*piece.first()?, *piece.last()?]));
    Pslg {
        segments: ends.collect(),
        ..Pslg::from_points(points.iter().copied())
    }
}

/// Cuts a chain at the vertices below `first`; neighbouring pieces share one.
pub(crate) fn pieces(chain: &[VertexId], first: usize) -> impl Iterator<Item = &[VertexId]> {
    let mut rest = chain;
    std::iter::from_fn(move || {
        let next = rest.iter().skip(1).position(|v| v.index() < first)? + 1;
        let piece = &rest[..=next];
        rest = &rest[next..];
        Some(piece)
    })
}

#[cfg(test)]
mod tests {
    use super::{drawing, pieces};
    use delone::{Point, VertexId};

    #[test]
    fn chains_are_cut_where_the_input_has_a_vertex() {
        let chain = [0, 9, 8, 3, 1, 7, 2].map(VertexId::new);
        let cut: Vec<Vec<usize>> = pieces(&chain, 5)
            .map(|piece| piece.iter().map(|v| v.index()).collect())
            .collect();
        assert_eq!(cut, [vec![0, 9, 8, 3], vec![3, 1], vec![1, 7, 2]]);
        assert_eq!(pieces(&chain[..1], 5).count(), 0, "a segment of no length");
        let drawn = drawing(&[Point::default(); 5], [&chain[..]].into_iter());
        assert_eq!(
            drawn.segments,
            [[0, 3], [3, 1], [1, 2]].map(|e| e.map(VertexId::new))
        );
    }
}
