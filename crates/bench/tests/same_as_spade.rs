//! Ours and spade's constrained Delaunay triangulations of the benchmark's domains, compared
//! triangle by triangle. These domains are in general position, so there is only one.

use delone::{ConstrainedDelaunay, Pslg, VertexId};
use delone_samples::{Domain, Drawing};
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Turns each triangle so that its least vertex comes first, and sorts them.
fn sorted(triangles: impl Iterator<Item = [usize; 3]>) -> Vec<[usize; 3]> {
    let mut sorted: Vec<_> = triangles
        .map(|[a, b, c]| [[a, b, c], [b, c, a], [c, a, b]].into_iter().min().unwrap())
        .collect();
    sorted.sort_unstable();
    sorted
}

fn ours(drawing: &Drawing) -> Vec<[usize; 3]> {
    let segments = drawing.segments.iter().map(|ends| ends.map(VertexId::from));
    let pslg = Pslg {
        segments: segments.collect(),
        ..Pslg::from_points(drawing.points.iter().copied())
    };
    let result = ConstrainedDelaunay::new().triangulate(pslg).unwrap();
    let triangles = result.triangulation().triangles();
    sorted(triangles.iter().map(|corners| corners.map(VertexId::index)))
}

fn spades(drawing: &Drawing) -> Vec<[usize; 3]> {
    let points = drawing.points.iter().map(|&[x, y]| Point2::new(x, y));
    let segments = drawing.segments.iter();
    let result: ConstrainedDelaunayTriangulation<Point2<f64>> =
        ConstrainedDelaunayTriangulation::bulk_load_cdt(
            points.collect(),
            segments.map(|ends| ends.map(|v| v as usize)).collect(),
        )
        .unwrap();
    let corners = result.inner_faces().map(|face| face.vertices());
    sorted(corners.map(|corners| corners.map(|vertex| vertex.fix().index())))
}

#[test]
fn clean_domains_have_one_triangulation() {
    for domain in [Domain::Segments, Domain::Coast, Domain::Spiral] {
        for (count, seed) in [(30, 1), (700, 2), (20_000, 3)] {
            let drawing = domain.draw(count, seed);
            assert!(ours(&drawing) == spades(&drawing), "{domain} {count}");
        }
    }
}
