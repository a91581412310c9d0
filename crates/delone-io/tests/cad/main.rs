//! Drawings, pictures and airfoils: what is read of them, what they say when they are broken, round trips.

mod airfoils;
mod damage;
mod drawings;
mod pictures;

use delone::{ConstrainedDelaunay, SegmentPolicy, VertexId};
use delone_io::{DomainData, Error, ReadOptions, Source, read_domain};
use std::path::{Path, PathBuf};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/data/cad")
        .join(name)
}

fn read(name: &str, bytes: &[u8], options: &ReadOptions) -> Result<DomainData, Error> {
    let source = Source::Memory {
        name: name.to_owned(),
        bytes: bytes.to_vec(),
    };
    read_domain(&source, options, &())
}

fn domain(name: &str, text: &str) -> DomainData {
    read(name, text.as_bytes(), &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn file(name: &str, options: &ReadOptions) -> DomainData {
    let source = Source::Path(data(name));
    read_domain(&source, options, &()).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refuses(name: &str, text: &str, expected: &str) {
    let error = read(name, text.as_bytes(), &ReadOptions::default());
    let message = error.expect_err(expected).to_string();
    assert!(message.contains(expected), "{message:?} lacks {expected:?}");
}

/// The area of the domain under its usual rule, triangulated.
#[track_caller]
fn area(mut domain: DomainData) -> f64 {
    let rule = domain.usual_rule;
    let graph = domain.take_pslg();
    let result = ConstrainedDelaunay::new()
        .domain(rule)
        .crossings(SegmentPolicy::Split)
        .triangulate(graph)
        .expect("a triangulation");
    let triangulation = result.triangulation();
    let area_of = |corners: [VertexId; 3]| {
        let [a, b, c] = corners.map(|v| triangulation.point(v));
        0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x))
    };
    triangulation.triangles().iter().copied().map(area_of).sum()
}

/// The places of a domain, in order.
fn places(domain: &DomainData) -> Vec<[f64; 2]> {
    domain.vertices.points.iter().map(|p| [p.x, p.y]).collect()
}
