//! Markers that vertices take over from what they lie on, as in Triangle: the first marker that is not
//! 0 among those of their segments or, if there is none, 1 on the boundary.

use delone::{ConstrainedTriangulation, TriangleId};

/// Marks the vertices from `first` on that have marker 0.
///
/// *Cost*: proportional to chains and triangles.
pub(super) fn take_over(
    markers: &mut [i32],
    first: usize,
    result: &ConstrainedTriangulation,
    marker_of: impl Fn(usize) -> i32,
) {
    let mut mark = |v: usize, marker: i32| {
        if v >= first && markers[v] == 0 {
            markers[v] = marker;
        }
    };
    for segment in 0..result.segments().len() {
        let marker = marker_of(segment);
        let chain = result.chain(segment).iter();
        chain.for_each(|v| mark(v.index(), marker));
    }
    on_boundary(result).for_each(|v| mark(v, 1));
}

/// Visits the vertices on the boundary of the triangles, some of them twice.
fn on_boundary(result: &ConstrainedTriangulation) -> impl Iterator<Item = usize> + '_ {
    let triangulation = result.triangulation();
    let triangles = (0..triangulation.num_triangles()).map(TriangleId::new);
    let edges = triangles.flat_map(TriangleId::half_edges).filter(|&h| {
        let beyond = triangulation.mesh().twin(h).triangle();
        beyond.index() >= triangulation.num_triangles()
    });
    // The next boundary edge begins where one ends, so origins are all there are.
    edges.map(|h| triangulation.mesh().origin(h).index())
}
