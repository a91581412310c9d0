//! The chapter's Algorithms A, B and C, which make triangulations for data: here they are told of and shown, what they
//! do stands in [`scattered`](crate::scattered).

use super::{About, Input, Output, Takes};
use crate::scattered::{Cover, DataTriangulation};
use crate::{Error, Observer, VertexId};

/// What there is to say of Algorithm A.
pub(super) const A: About = About {
    name: "algorithm-a",
    title: "Algorithm A: clusters in an outer polygon",
    source: "Diploma thesis, Duisburg, about 1998, algorithms 3.25, 3.27, 3.30, 3.31; Schreiber 1991",
    idea: "Lay a polygon around the data, and add centers of clusters one by one, as long as every triangle of the \
           Delaunay triangulation holds enough data; if none does, take a polygon with a corner less.",
    cost: "O(n log n) in practice",
    guarantees: "every datum in a triangle, at least d in each; no bound above",
    takes: Takes::Data,
    is_delaunay: false,
    code: crate::scattered::CODE_A,
};

/// What there is to say of Algorithm B.
pub(super) const B: About = About {
    name: "algorithm-b",
    title: "Algorithm B: vertices on edges",
    source: "Diploma thesis, Duisburg, about 1998, algorithms 3.34 to 3.37",
    idea: "Go through the triangles, the fullest first: bisect for a point on an edge, or on the other diagonal, that \
           makes triangles with enough data each; then flip edges around it for larger angles.",
    cost: "O(n log n) in practice",
    guarantees: "at least d data in each triangle, as before; in practice rarely 3d or more",
    takes: Takes::Data,
    is_delaunay: false,
    code: crate::scattered::CODE_B,
};

/// What there is to say of Algorithm C.
pub(super) const C: About = About {
    name: "algorithm-c",
    title: "Algorithm C: vertices in triangles",
    source: "Diploma thesis, Duisburg, about 1998, algorithms 3.43, 3.44, theorem 3.39",
    idea: "Open each triangle that holds 3d data or more by a point inside that leaves d in each of the three parts.",
    cost: "O(n log n) in practice",
    guarantees: "d to 3d − 1 data in each triangle, but where many lie on one or two of its edges",
    takes: Takes::Data,
    is_delaunay: false,
    code: crate::scattered::CODE_C,
};

/// Algorithm A.
pub(super) fn run_a(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let options = options(input).divides_edges(false).divides_triangles(false);
    options.observe(data(input), observer).map(output)
}

/// Algorithm B, on what A makes.
pub(super) fn run_b(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let options = options(input).divides_triangles(false);
    let start = options.clone().divides_edges(false).cover(data(input))?;
    options.refine(&start, observer).map(output)
}

/// Algorithm C, as the text searches, on what A makes: B leaves it little to do.
pub(super) fn run_c(input: &Input, observer: &mut impl Observer) -> Result<Output, Error> {
    let options = options(input).divides_edges(false).stepwise(true);
    let start = options
        .clone()
        .divides_triangles(false)
        .cover(data(input))?;
    options.refine(&start, observer).map(output)
}

fn options<'w>(input: &Input<'w>) -> Cover<'w> {
    Cover::new(input.least).watch(input.watch)
}

fn data(input: &Input) -> impl Iterator<Item = crate::Point> {
    input.pslg.points.iter().copied()
}

/// Vertices come after the data, as observers have been told.
fn output(cover: DataTriangulation) -> Output {
    let first = cover.data().len();
    let name = |v: &VertexId| VertexId::new(first + v.index());
    let triangles = cover.triangles().iter();
    Output {
        points: [cover.data(), cover.points()].concat(),
        triangles: triangles
            .map(|corners| corners.each_ref().map(name))
            .collect(),
        duplicates: cover.duplicates().to_vec(),
        ..Output::default()
    }
}
