//! `.ele`: triangles of Triangle.
//!
//! Header `m 3 attributes`, then a row `number a b c [attributes]` for each triangle; corners are
//! numbered as the rows of the `.node` file are. Triangles of six nodes are not read.

use crate::scan::Scanner;
use crate::target::Output;
use crate::triangle_files::{self, Block, Header};
use crate::{Error, MeshData, MeshView, PointSet, Problem, node, points};
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
    let corners = header.get(1, 3);
    if corners != 3 {
        let problem = Problem::Other(format!("{corners} nodes a triangle: only 3 are understood"));
        return Err(header.problem(&scanner, problem));
    }
    let attributes = header.count(&scanner, 2, "attributes")?;
    let attributes = points::check_columns(attributes).map_err(|p| header.problem(&scanner, p))?;
    let block = Block {
        items: "triangles",
        declared,
        columns: attributes + 4,
        base: (!vertices.points.is_empty()).then_some(vertices.base),
    };
    let mut mesh = MeshData {
        vertices,
        triangle_attributes: (1..=attributes).map(node::unnamed).collect(),
        ..MeshData::default()
    };
    scanner.reserve(&mut mesh.triangles, 2 * block.columns, declared);
    block.read(&mut scanner, |number, cells| push(&mut mesh, number, cells))?;
    triangle_files::expect_end(&mut scanner, "triangles", declared)?;
    Ok(mesh)
}

/// Adds a triangle from the cells `a b c [attributes]`.
fn push(mesh: &mut MeshData, number: u64, cells: &[&[u8]]) -> Result<(), Problem> {
    let (base, num_vertices) = (mesh.vertices.base, mesh.vertices.points.len());
    let corner = |cell| triangle_files::vertex(cell, ("triangle", number), base, num_vertices);
    let triangle = [corner(cells[0])?, corner(cells[1])?, corner(cells[2])?];
    for (attribute, cell) in mesh.triangle_attributes.iter_mut().zip(&cells[3..]) {
        attribute
            .values
            .push(triangle_files::number(cell, "attribute")?);
    }
    mesh.triangles.push(triangle.map(VertexId::from));
    Ok(())
}

/// Writes the triangles, everything numbered from `base`.
pub(crate) fn write(out: &mut Output<'_>, mesh: &MeshView<'_>, base: usize) -> Result<(), Error> {
    let attributes = mesh.triangle_attributes;
    out.text(format_args!(
        "{} 3 {}\n",
        mesh.triangles.len(),
        attributes.len()
    ))?;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        out.integer((t + base) as i64);
        for v in corners {
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
