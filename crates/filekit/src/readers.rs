//! What must hold of everything that is read.

use delone_io::{
    Attribute, Constraints, DomainData, Format, Lineage, MemoryFile, MeshCertificate, MeshData,
    PointSet, ReadOptions, Source, read_domain, read_mesh, read_points,
};
use std::sync::Arc;

/// Reads bytes as a file of this name, as everything that the format can be.
pub fn read(name: &str, bytes: &[u8]) {
    read_source(&memory(name, bytes), bytes);
}

/// Reads bytes that tell nothing but themselves what they are.
pub fn read_unnamed(bytes: &[u8]) {
    read_source(&memory("f", bytes), bytes);
}

/// Reads two files beside each other; the first two bytes tell where the second begins.
pub fn read_pair(first: &str, second: &str, bytes: &[u8]) {
    let Some((source, head)) = pair(first, second, bytes) else {
        return;
    };
    read_source(&source, head);
}

/// Puts two files into one input, as [`read_pair`] takes them apart.
pub fn joined(first: &[u8], second: &[u8]) -> Vec<u8> {
    let length = u16::try_from(first.len()).unwrap_or(u16::MAX);
    let (first, _) = first.split_at(usize::from(length));
    [&length.to_le_bytes(), first, second].concat()
}

fn pair<'b>(first: &str, second: &str, bytes: &'b [u8]) -> Option<(Source, &'b [u8])> {
    let (length, rest) = bytes.split_first_chunk::<2>()?;
    let length = usize::from(u16::from_le_bytes(*length)).min(rest.len());
    let (head, tail) = rest.split_at(length);
    let file = |extension: &str, bytes: &[u8]| MemoryFile {
        name: format!("f.{extension}").into(),
        bytes: bytes.to_vec(),
    };
    let files = Arc::new([file(first, head), file(second, tail)]);
    Some((Source::Together { files, opened: 0 }, head))
}

/// Makes a file in memory.
pub fn memory(name: &str, bytes: &[u8]) -> Source {
    Source::Memory {
        name: name.to_owned(),
        bytes: bytes.to_vec(),
    }
}

fn read_source(source: &Source, head: &[u8]) {
    let options = ReadOptions::default();
    let name = source.to_string();
    if let Ok(points) = read_points(source, &options, &()) {
        check_points(&points);
    }
    if let Ok(domain) = read_domain(source, &options, &()) {
        check_domain(&domain);
    }
    let format = Format::detect(Some(name.as_ref()), head);
    if format.is_some_and(Format::reads_mesh)
        && let Ok(mesh) = read_mesh(source, &options, &())
    {
        check_mesh(&mesh);
    }
}

/// Checks points: coordinates are finite, columns as long as they should be.
pub fn check_points(set: &PointSet) {
    let n = set.points.len();
    assert!(set.points.iter().all(delone::Point::is_finite));
    check_columns(&set.attributes, n);
    assert!(set.markers.as_ref().is_none_or(|m| m.len() == n));
}

fn check_columns(columns: &[Attribute], rows: usize) {
    assert!(columns.iter().all(|a| a.values.len() == rows));
}

/// Checks a domain: segments join points, polygons are ranges of segments, seeds are finite.
pub fn check_domain(domain: &DomainData) {
    check_points(&domain.vertices);
    let (n, s) = (domain.vertices.points.len(), domain.segments.len());
    let ends = domain.segments.as_flattened();
    assert!(ends.iter().all(|v| v.index() < n));
    assert!(domain.segment_markers.as_ref().is_none_or(|m| m.len() == s));
    let mut polygons = domain.polygons.iter();
    assert!(polygons.all(|range| range.start < range.end && range.end <= s));
    let regions = domain.regions.iter().map(|region| region.at);
    let mut seeds = domain.holes.iter().copied().chain(regions);
    assert!(seeds.all(|p| p.is_finite()));
}

/// Checks a mesh: corners are vertices, constrained edges too, and all tables have the right length.
pub fn check_mesh(mesh: &MeshData) {
    check_points(&mesh.vertices);
    let (n, m) = (mesh.vertices.points.len(), mesh.triangles.len());
    let corners = mesh.triangles.as_flattened();
    assert!(corners.iter().all(|v| v.index() < n));
    check_columns(&mesh.triangle_attributes, m);
    if let Some(constraints) = &mesh.constraints {
        check_constraints(constraints, n, m);
    }
}

fn check_constraints(constraints: &Constraints, n: usize, m: usize) {
    let ends = constraints.edges.as_flattened();
    assert!(ends.iter().all(|v| v.index() < n));
    let edges = constraints.edges.len();
    let is_one_each = |markers: &Vec<i32>| markers.len() == edges;
    assert!(constraints.markers.as_ref().is_none_or(is_one_each));
    let regions = constraints.regions.len();
    if let Some(region_of) = &constraints.region_of {
        assert_eq!(region_of.len(), m);
        assert!(region_of.iter().flatten().all(|&r| (r as usize) < regions));
    }
    let seeds = constraints.regions.iter().map(|region| region.at);
    let mut seeds = constraints.holes.iter().copied().chain(seeds);
    assert!(seeds.all(|p| p.is_finite()));
}

/// Reads bounds on areas, for as many triangles as the file may mean.
pub fn read_area(bytes: &[u8]) {
    for triangles in [0, 1, 2, 3, 5] {
        if let Ok(areas) = delone_io::read_areas(&memory("f.area", bytes), triangles, &()) {
            assert_eq!(areas.len(), triangles);
            assert!(areas.iter().flatten().all(|&area| area > 0.0));
        }
    }
}

/// Reads the log of a run, and plays all of it.
pub fn read_log(bytes: &[u8]) {
    let _ = delone_io::read_log(&memory("f", bytes), &());
}

/// Reads a certificate, and compares it with itself.
pub fn read_certificate(bytes: &[u8]) {
    if let Ok(certificate) = MeshCertificate::read(&memory("f.json", bytes), &()) {
        let _ = certificate.rule();
        let _ = certificate.disagreements(&certificate.clone());
    }
}

/// Reads where vertices and edges come from.
pub fn read_lineage(bytes: &[u8]) {
    for segments in [0, 1, 4, 100] {
        if let Ok(lineage) = Lineage::read(&memory("f.csv", bytes), segments, &()) {
            let _ = lineage.constrained_edges();
            let _ = lineage.num_rows();
        }
    }
}
