//! What the readers' targets share: any bytes give a result or an error, and nothing else.

use delone_io::{
    Format, MeshData, PointSet, ReadOptions, Source, read_domain, read_mesh, read_points,
};

/// Reads bytes as points; checks that they are finite and that the attributes are as many.
pub fn check_points(format: Format, bytes: &[u8]) {
    let (source, options) = input(format, bytes);
    if let Ok(PointSet {
        points, attributes, ..
    }) = read_points(&source, &options, &())
    {
        assert!(points.iter().all(delone::Point::is_finite));
        assert!(attributes.iter().all(|a| a.values.len() == points.len()));
    }
}

/// Reads bytes as a domain; checks that segments join points, that polygons are ranges of them, and
/// that every coordinate is finite.
pub fn check_domain(format: Format, bytes: &[u8]) {
    let (source, options) = input(format, bytes);
    if let Ok(domain) = read_domain(&source, &options, &()) {
        let (n, s) = (domain.vertices.points.len(), domain.segments.len());
        let ends = domain.segments.as_flattened();
        assert!(ends.iter().all(|v| v.index() < n));
        assert!(domain.segment_markers.is_none_or(|m| m.len() == s));
        let mut polygons = domain.polygons.iter();
        assert!(polygons.all(|range| range.start < range.end && range.end <= s));
        let regions = domain.regions.iter().map(|region| region.at);
        let seeds = domain.holes.iter().copied().chain(regions);
        let points = domain.vertices.points.iter().copied();
        assert!(points.chain(seeds).all(|p| p.is_finite()));
    }
}

/// Reads bytes as a mesh; checks that its corners are vertices.
pub fn check_mesh(format: Format, bytes: &[u8]) {
    let (source, options) = input(format, bytes);
    if let Ok(MeshData {
        vertices,
        triangles,
        ..
    }) = read_mesh(&source, &options, &())
    {
        let n = vertices.points.len();
        assert!(triangles.as_flattened().iter().all(|v| v.index() < n));
    }
}

fn input(format: Format, bytes: &[u8]) -> (Source, ReadOptions) {
    let source = Source::Memory {
        name: "fuzz".to_owned(),
        bytes: bytes.to_vec(),
    };
    let options = ReadOptions {
        format: Some(format),
        ..ReadOptions::default()
    };
    (source, options)
}
