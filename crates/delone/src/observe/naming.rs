//! One name for an edge or a triangle, whichever way it runs and wherever it begins: for who keeps them in sets.

use crate::VertexId;

/// Names an edge by its ends, the smaller one first.
pub(crate) fn ascending([a, b]: [VertexId; 2]) -> [VertexId; 2] {
    [a.min(b), a.max(b)]
}

/// Names a triangle by its corners, counter-clockwise as before, the smallest one first.
pub(crate) fn smallest_first([a, b, c]: [VertexId; 3]) -> [VertexId; 3] {
    if a <= b && a <= c {
        [a, b, c]
    } else if b <= c {
        [b, c, a]
    } else {
        [c, a, b]
    }
}

/// Returns the sides of a triangle as it runs through them, each beginning at its corner.
pub(crate) fn sides([a, b, c]: [VertexId; 3]) -> [[VertexId; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}
