//! Who is told each step of divide and conquer.
//!
//! The builder is generic over its witness, and nobody is one: `()` is not told anything, and the
//! compiler leaves nothing of it in the code.

use super::sheet::Sheet;
use crate::VertexId;
use crate::order::Axis;

/// A step; vertices have the numbers of the caller.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Deed {
    /// A set of points is cut across an axis; `first` is the vertex behind the cut that is closest to it.
    Cut {
        axis: Axis,
        first: VertexId,
    },
    /// Up to four points are triangulated at once.
    Leaf,
    /// The lower tangent of two triangulations is looked for.
    Tangent,
    /// It runs between these.
    Base([VertexId; 2]),
    /// Next up is what lies above this base.
    Raise([VertexId; 2]),
    /// A line and a point: on which side is it?
    Turn([VertexId; 3]),
    /// A triangle and a vertex: is that in its circle?
    Circle([VertexId; 4]),
    /// An edge is in the way.
    Delete,
    /// The candidate has been chosen.
    Join,
    EdgeCreated([VertexId; 2]),
    EdgeDeleted([VertexId; 2]),
    TriangleCreated([VertexId; 3]),
    TriangleDeleted([VertexId; 3]),
}

/// Someone who is told.
pub(crate) trait Witness: Copy + Send + Sync {
    /// Whether it is worth telling.
    const IS_WATCHING: bool;

    /// Told of a step.
    fn tell(self, deed: Deed);
}

impl Witness for () {
    const IS_WATCHING: bool = false;

    #[inline(always)]
    fn tell(self, _: Deed) {}
}

/// Names vertices of the sheet as the caller does.
#[inline(always)]
pub(super) fn names<const N: usize>(sheet: Sheet, vertices: [u32; N]) -> [VertexId; N] {
    vertices.map(|v| sheet.name(v))
}

/// Tells of a turn that is asked for.
#[inline(always)]
pub(super) fn tell_turn(witness: impl Witness, sheet: Sheet, corners: [u32; 3]) {
    if is_watching(witness) {
        witness.tell(Deed::Turn(names(sheet, corners)));
    }
}

/// Tells of a circle that is asked for, unless the fourth vertex is the one at infinity.
#[inline(always)]
pub(super) fn tell_circle(witness: impl Witness, sheet: Sheet, vertices: [u32; 4]) {
    if is_watching(witness) && vertices[3] != sheet.infinite() {
        witness.tell(Deed::Circle(names(sheet, vertices)));
    }
}

#[inline(always)]
pub(super) fn is_watching<W: Witness>(_: W) -> bool {
    W::IS_WATCHING
}

/// Tells of the finite faces, and their edges, in the slots from handle `base` on, which a template has
/// written.
pub(super) fn tell_leaf(witness: impl Witness, sheet: Sheet, base: u32, faces: u32) {
    let corners = |face: u32| [0, 1, 2].map(|k| sheet.corner(base + 3 * face + k));
    let is_finite = |vertices: &[u32]| !vertices.contains(&sheet.infinite());
    let faces: Vec<_> = (0..faces).map(corners).collect();
    witness.tell(Deed::Leaf);
    let edges = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    for [a, b] in edges.filter(|edge| is_finite(edge) && edge[0] < edge[1]) {
        witness.tell(Deed::EdgeCreated(names(sheet, [a, b])));
    }
    for corners in faces.into_iter().filter(|corners| is_finite(corners)) {
        witness.tell(Deed::TriangleCreated(names(sheet, corners)));
    }
}
