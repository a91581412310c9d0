//! `.ele`: triangles of Triangle.
//!
//! Header `m 3 attributes`, then a row `number a b c [attributes]` for each triangle; corners are
//! numbered as the rows of the `.node` file are. With 6 instead of 3, the midpoints of the edges
//! opposite the corners follow these.

use crate::scan::Scanner;
use crate::target::Output;
use crate::triangle_files::{self, Block, Header};
use crate::{Error, MeshData, MeshView, Place, PointSet, Problem, node, points, six_nodes};
use delone::{VertexId, Watch};

/// Reads a whole `.ele` file over the vertices of its `.node` file.
pub(crate) fn read_mesh(
    file: &str,
    bytes: &[u8],
    vertices: PointSet,
    watch: &dyn Watch,
) -> Result<MeshData, Error> {
    let mut scanner = Scanner::new(file, bytes, watch);
    let header = Header::read(&mut scanner)?;
    let declared = header.count(&scanner, 0, "triangles")?;
    let nodes = match header.get(1, 3) {
        n @ (3 | 6) => n as usize,
        n => {
            let problem = format!("{n} nodes a triangle: only 3 and 6 are understood");
            return Err(header.problem(&scanner, Problem::Other(problem)));
        }
    };
    let attributes = header.count(&scanner, 2, "attributes")?;
    let attributes = points::check_columns(attributes).map_err(|p| header.problem(&scanner, p))?;
    let block = Block {
        items: "triangles",
        declared,
        columns: attributes + 1 + nodes,
        base: (!vertices.points.is_empty()).then_some(vertices.base),
    };
    let mut mesh = MeshData {
        vertices,
        triangle_attributes: (1..=attributes).map(node::unnamed).collect(),
        quadratic: nodes == 6,
        ..MeshData::default()
    };
    scanner.reserve(&mut mesh.triangles, 2 * block.columns, declared);
    let mut middles = Vec::new();
    block.read(&mut scanner, |number, cells| {
        let (nodes, attributes) = cells.split_at(nodes);
        push(&mut mesh, &mut middles, number, nodes)?;
        for (attribute, cell) in mesh.triangle_attributes.iter_mut().zip(attributes) {
            attribute
                .values
                .push(triangle_files::number(cell, "attribute")?);
        }
        Ok(())
    })?;
    triangle_files::expect_end(&mut scanner, "triangles", declared)?;
    six_nodes::drop_midpoints(&mut mesh.vertices, &mesh.triangles, &middles)
        .map_err(|problem| scanner.malformed(Place::File, problem))?;
    Ok(mesh)
}

/// Adds a triangle from the cells `a b c`, and perhaps its midpoints.
fn push(
    mesh: &mut MeshData,
    middles: &mut Vec<VertexId>,
    number: u64,
    cells: &[&[u8]],
) -> Result<(), Problem> {
    let (base, num_vertices) = (mesh.vertices.base, mesh.vertices.points.len());
    let node = |cell| triangle_files::vertex(cell, ("triangle", number), base, num_vertices);
    let triangle = [node(cells[0])?, node(cells[1])?, node(cells[2])?];
    mesh.triangles.push(triangle.map(VertexId::from));
    for cell in &cells[3..] {
        middles.push(node(cell)?.into());
    }
    Ok(())
}

/// Writes the triangles, everything numbered from `base`.
pub(crate) fn write(out: &mut Output<'_>, mesh: &MeshView<'_>, base: usize) -> Result<(), Error> {
    let attributes = mesh.triangle_attributes;
    let nodes = if mesh.middles.is_some() { 6 } else { 3 };
    out.text(format_args!(
        "{} {nodes} {}\n",
        mesh.triangles.len(),
        attributes.len()
    ))?;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        out.integer((t + base) as i64);
        let middles = mesh.middles.map(|middles| &middles.of_triangles[t]);
        for v in corners.iter().chain(middles.into_iter().flatten()) {
            out.blank();
            out.integer((v.index() + base) as i64);
        }
        for attribute in attributes {
            out.blank();
            out.number(attribute.values[t]);
        }
        out.end_line()?;
    }
    Ok(())
}
