//! JIGSAW's `.msh`: points, edges and triangles.
//!
//! D. Engwirda, *JIGSAW: an unstructured mesh generator*, <https://github.com/dengwirda/jigsaw>, file `readme.md` and
//! the scripts that load and save `.msh`. Rows of `a;b;tag` follow lines `KEYWORD=count`; numbers of points begin at 0.
//! Read are meshes of two dimensions (`EUCLIDEAN-MESH`): `POINT`, `EDGE2`, `TRIA3`, `BOUND`, `VALUE`. Tags become
//! markers of points and edges, and the attribute `region` of triangles; values attributes of points. Weights (`POWER`)
//! are [noted](crate::PointSet::notes) and left; other elements are refused.
//!
//! Without triangles it is a domain. Each part of `BOUND` is then a polygon, by parity, as in JIGSAW; if there is none,
//! rings decide, as for all bare lines.

mod rows;

use crate::{
    Attribute, Constraints, DomainData, Error, MeshData, Place, PointSet, Problem, ReadOptions,
    scan,
};
use delone::{DomainRule, Watch};
use rows::Rows;
use scan::Scanner;

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let mut scanner = Scanner::new("", head, &());
    let first = scanner.next_row().ok().flatten();
    first.is_some_and(|row| {
        let start = row.text.get(..5);
        start.is_some_and(|start| start.eq_ignore_ascii_case(b"MSHID"))
    })
}

/// Reads a mesh; triangles there may be none.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    _options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut rows = read(file, bytes, watch)?;
    let regions = std::mem::take(&mut rows.triangle_tags);
    let has_regions = regions.iter().any(|&r| r != 0);
    Ok(MeshData {
        triangle_attributes: Vec::from_iter(has_regions.then(|| Attribute {
            name: "region".to_owned(),
            values: regions.into_iter().map(f64::from).collect(),
        })),
        triangles: std::mem::take(&mut rows.triangles),
        constraints: (!rows.edges.is_empty()).then(|| Constraints {
            markers: marking(std::mem::take(&mut rows.edge_tags)),
            edges: std::mem::take(&mut rows.edges),
            ..Constraints::default()
        }),
        vertices: point_set(rows),
        quadratic: false,
    })
}

/// Reads a domain: what bounds its parts, if there are no triangles.
pub(crate) fn read_domain(
    file: &str,
    bytes: &[u8],
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<DomainData, Error> {
    let mut rows = read(file, bytes, watch)?;
    if !rows.triangles.is_empty() || rows.bounds.is_empty() {
        return read_mesh(file, bytes, options, watch).map(DomainData::from);
    }
    // Parts that share edges have them both; edges of no part come last.
    rows.bounds.sort_by_key(|bound| bound.part);
    let mut is_used = vec![false; rows.edges.len()];
    let mut order = Vec::new();
    let mut polygons = Vec::new();
    for part in rows.bounds.chunk_by(|a, b| a.part == b.part) {
        let first = order.len();
        order.extend(part.iter().map(|bound| bound.edge));
        part.iter().for_each(|bound| is_used[bound.edge] = true);
        polygons.push(first..order.len());
    }
    order.extend((0..is_used.len()).filter(|&e| !is_used[e]));
    let tags = order.iter().map(|&e| rows.edge_tags[e]).collect();
    if polygons.len() > 1 {
        let count = polygons.len();
        rows.notes.push(format!(
            "which of its {count} parts an area belongs to is not kept"
        ));
    }
    Ok(DomainData {
        segments: order.iter().map(|&e| rows.edges[e]).collect(),
        segment_markers: marking(tags),
        polygons,
        usual_rule: DomainRule::EvenOdd,
        ..DomainData::from(point_set(rows))
    })
}

fn read(file: &str, bytes: &[u8], watch: &dyn Watch) -> Result<Rows, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let rows = Rows::read(&mut scanner)?;
    match rows.has_points {
        true => Ok(rows),
        false => Err(scanner.malformed(Place::File, Problem::Other("no POINT=".to_owned()))),
    }
}

/// Takes tags as markers, unless all are 0.
fn marking(tags: Vec<i32>) -> Option<Vec<i32>> {
    tags.iter().any(|&tag| tag != 0).then_some(tags)
}

fn point_set(rows: Rows) -> PointSet {
    PointSet {
        points: rows.points,
        markers: marking(rows.point_tags),
        attributes: rows.values,
        lines: rows.lines,
        notes: rows.notes,
        ..PointSet::default()
    }
}
