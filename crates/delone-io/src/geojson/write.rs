//! Writing: a collection of features, one a line.
//!
//! A vertex attribute named `z` becomes the third coordinate; others have no place in the format.

use crate::target::Output;
use crate::{Attribute, Constraints, DomainData, Error, MeshView, PointSet};
use delone::{Point, VertexId};

/// Writes triangles as polygons with their regions and attributes as properties, and constrained
/// edges as lines with their markers.
pub(crate) fn write_mesh(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
) -> Result<(), Error> {
    let vertices = Vertices::new(mesh.points, mesh.attributes);
    let none = Constraints::default();
    let constraints = mesh.constraints.unwrap_or(&none);
    let mut list = List::begin(out)?;
    for (t, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        list.next(|out| {
            write_properties(out, mesh, t)?;
            vertices.write_geometry(out, "Polygon", |out| {
                out.bytes(b"[")?;
                vertices.write_line(out, &[a, b, c, a])?;
                out.bytes(b"]")
            })
        })?;
    }
    for (ends, &marker) in constraints.edges.iter().zip(markers) {
        list.next(|out| vertices.write_line_string(out, ends, Some(marker)))?;
    }
    list.end()
}

/// Writes the region and the attributes of a triangle.
fn write_properties(out: &mut Output<'_>, mesh: &MeshView<'_>, t: usize) -> Result<(), Error> {
    let regions = mesh.constraints.and_then(|c| c.region_of.as_ref());
    let region = regions.map(|regions| ("region", regions[t].map(f64::from)));
    let attributes = mesh.triangle_attributes.iter();
    let attributes = attributes.map(|Attribute { name, values }| (name.as_str(), Some(values[t])));
    out.bytes(b"{")?;
    for (i, (name, value)) in region.into_iter().chain(attributes).enumerate() {
        out.bytes(if i == 0 { b"" } else { b"," })?;
        out.bytes(serde_json::Value::from(name).to_string().as_bytes())?;
        out.bytes(b":")?;
        match value.filter(|value| value.is_finite()) {
            Some(value) => out.number(value),
            None => out.bytes(b"null")?,
        }
    }
    out.bytes(b"}")
}

/// Writes polygons, other segments as lines, and points that are in no segment.
pub(crate) fn write_domain(out: &mut Output<'_>, domain: &DomainData) -> Result<(), Error> {
    let vertices = Vertices::new(&domain.vertices.points, &domain.vertices.attributes);
    let marker = |segment: usize| domain.segment_markers.as_ref().map(|m| m[segment]);
    let mut in_polygon = vec![false; domain.segments.len()];
    let mut list = List::begin(out)?;
    for range in &domain.polygons {
        let rings = rings(domain.segments.get(range.clone()).unwrap_or_default())?;
        // A ring of one or two segments encloses nothing, and readers of GeoJSON refuse it: they become lines.
        if rings.iter().any(|ring| ring.len() < 4) {
            continue;
        }
        in_polygon[range.clone()].fill(true);
        list.next(|out| vertices.write_polygon(out, &rings, marker(range.start)))?;
    }
    let mut line = Vec::new();
    for (s, &[a, b]) in domain.segments.iter().enumerate() {
        if in_polygon[s] {
            continue;
        }
        if line.is_empty() {
            line.push(a);
        }
        line.push(b);
        let goes_on = domain.segments.get(s + 1).is_some_and(|next| next[0] == b);
        if !goes_on || in_polygon[s + 1] || marker(s) != marker(s + 1) {
            list.next(|out| vertices.write_line_string(out, &line, marker(s)))?;
            line.clear();
        }
    }
    for v in loose_points(domain) {
        list.next(|out| vertices.write_point(out, v))?;
    }
    list.end()
}

/// Writes points.
pub(crate) fn write_points(out: &mut Output<'_>, points: &PointSet) -> Result<(), Error> {
    let vertices = Vertices::new(&points.points, &points.attributes);
    let mut list = List::begin(out)?;
    for v in 0..points.points.len() {
        list.next(|out| vertices.write_point(out, VertexId::new(v)))?;
    }
    list.end()
}

/// Takes the segments of a polygon apart into rings, each back at its first vertex.
fn rings(segments: &[[VertexId; 2]]) -> Result<Vec<Vec<VertexId>>, Error> {
    let mut rings: Vec<Vec<VertexId>> = Vec::new();
    let mut is_open = false;
    for &[a, b] in segments {
        match rings.last_mut().filter(|_| is_open) {
            None => rings.push(vec![a, b]),
            Some(ring) if ring.last() == Some(&a) => ring.push(b),
            Some(_) => return Err(not_rings()),
        }
        is_open = rings.last().is_some_and(|ring| ring[0] != b);
    }
    match is_open {
        true => Err(not_rings()),
        false => Ok(rings),
    }
}

fn not_rings() -> Error {
    let text = "the segments of a polygon do not follow each other along closed rings";
    Error::BadMesh(text.to_owned())
}

/// Visits the points that no segment joins.
fn loose_points(domain: &DomainData) -> impl Iterator<Item = VertexId> {
    let mut is_loose = vec![true; domain.vertices.points.len()];
    for v in domain.segments.as_flattened() {
        is_loose[v.index()] = false;
    }
    let all = is_loose.into_iter().enumerate();
    all.filter(|(_, is_loose)| *is_loose)
        .map(|(v, _)| VertexId::new(v))
}

/// The features of a collection.
pub(super) struct List<'o, 'w> {
    out: &'o mut Output<'w>,
    separator: &'static [u8],
}

impl<'o, 'w> List<'o, 'w> {
    pub fn begin(out: &'o mut Output<'w>) -> Result<Self, Error> {
        out.bytes(b"{\"type\":\"FeatureCollection\",\"features\":[")?;
        let separator = b"\n";
        Ok(Self { out, separator })
    }

    /// Writes a feature; `fill` writes properties and geometry.
    pub fn next(
        &mut self,
        fill: impl FnOnce(&mut Output<'w>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        self.out.bytes(self.separator)?;
        self.separator = b",\n";
        self.out.bytes(b"{\"type\":\"Feature\",\"properties\":")?;
        fill(self.out)?;
        self.out.bytes(b"}")?;
        self.out.end_row()
    }

    pub fn end(self) -> Result<(), Error> {
        self.out.bytes(b"\n]}\n")
    }
}

/// Where vertices lie.
struct Vertices<'a> {
    points: &'a [Point],
    heights: Option<&'a [f64]>,
}

impl<'a> Vertices<'a> {
    fn new(points: &'a [Point], attributes: &'a [Attribute]) -> Self {
        let heights = attributes.iter().find(|a| a.name == "z");
        Self {
            points,
            heights: heights.map(|a| a.values.as_slice()),
        }
    }

    fn write_polygon(
        &self,
        out: &mut Output<'_>,
        rings: &[Vec<VertexId>],
        marker: Option<i32>,
    ) -> Result<(), Error> {
        write_marker(out, marker)?;
        self.write_geometry(out, "Polygon", |out| {
            for (i, ring) in rings.iter().enumerate() {
                out.bytes(if i == 0 { b"[" } else { b"," })?;
                self.write_line(out, ring)?;
            }
            out.bytes(b"]")
        })
    }

    fn write_line_string(
        &self,
        out: &mut Output<'_>,
        line: &[VertexId],
        marker: Option<i32>,
    ) -> Result<(), Error> {
        write_marker(out, marker)?;
        self.write_geometry(out, "LineString", |out| self.write_line(out, line))
    }

    fn write_point(&self, out: &mut Output<'_>, v: VertexId) -> Result<(), Error> {
        write_marker(out, None)?;
        self.write_geometry(out, "Point", |out| self.write_position(out, v))
    }

    fn write_geometry<'w>(
        &self,
        out: &mut Output<'w>,
        kind: &str,
        coordinates: impl FnOnce(&mut Output<'w>) -> Result<(), Error>,
    ) -> Result<(), Error> {
        out.text(format_args!(
            ",\"geometry\":{{\"type\":\"{kind}\",\"coordinates\":"
        ))?;
        coordinates(out)?;
        out.bytes(b"}")
    }

    fn write_line(&self, out: &mut Output<'_>, line: &[VertexId]) -> Result<(), Error> {
        out.bytes(b"[")?;
        for (i, &v) in line.iter().enumerate() {
            out.bytes(if i == 0 { b"" } else { b"," })?;
            self.write_position(out, v)?;
        }
        out.bytes(b"]")
    }

    fn write_position(&self, out: &mut Output<'_>, v: VertexId) -> Result<(), Error> {
        let Point { x, y } = self.points[v.index()];
        let height = self.heights.map(|heights| heights[v.index()]);
        out.bytes(b"[")?;
        out.number(x);
        for number in [Some(y), height.filter(|z| z.is_finite())]
            .into_iter()
            .flatten()
        {
            out.separator(b',');
            out.number(number);
        }
        out.bytes(b"]")
    }
}

fn write_marker(out: &mut Output<'_>, marker: Option<i32>) -> Result<(), Error> {
    match marker {
        Some(marker) => out.text(format_args!("{{\"marker\":{marker}}}")),
        None => out.bytes(b"{}"),
    }
}
