//! The arrays of a grid, put together to a mesh.

use super::array::ArrayHead;
use super::{LINE, QUADRATIC_LINE, QUADRATIC_TRIANGLE, Stop, TRIANGLE, other, poll};
use crate::{Attribute, Constraints, MeshData, PointSet, Problem, node, six_nodes};
use delone::{Point, VertexId, Watch};

/// The arrays of a file as they come.
#[derive(Default)]
pub(super) struct Grid {
    /// What the piece says about itself.
    pub declared_points: Option<u64>,
    pub declared_cells: Option<u64>,
    points: Vec<f64>,
    connectivity: Vec<f64>,
    offsets: Vec<f64>,
    types: Vec<f64>,
    point_data: Vec<Attribute>,
    markers: Option<Vec<i32>>,
    cell_data: Vec<Attribute>,
}

impl Grid {
    /// Keeps an array of a section, if it is one that a mesh needs.
    pub fn keep(
        &mut self,
        section: &[u8],
        head: ArrayHead,
        values: Vec<f64>,
    ) -> Result<(), Problem> {
        match (section, head.name.as_str()) {
            (b"Points", _) if head.components == 3 => self.points = values,
            (b"Points", _) => return Err(other("points must have 3 components")),
            (b"Cells", "connectivity") => self.connectivity = values,
            (b"Cells", "offsets") => self.offsets = values,
            (b"Cells", "types") => self.types = values,
            (b"PointData", "marker") if head.components == 1 && are_markers(&head, &values) => {
                self.markers = Some(values.into_iter().map(|v| v as i32).collect());
            }
            (b"PointData", _) => split(head, values, &mut self.point_data)?,
            (b"CellData", _) => split(head, values, &mut self.cell_data)?,
            _ => {}
        }
        Ok(())
    }

    /// Makes the mesh; nothing in the arrays is trusted.
    pub fn into_mesh(self, watch: &dyn Watch) -> Result<MeshData, Stop> {
        if !self.points.len().is_multiple_of(3) {
            let found = self.points.len();
            return Err(other(format!("{found} coordinates: not a multiple of 3")).into());
        }
        let num_points = self.points.len() / 3;
        check_declared("points", self.declared_points, num_points)?;
        check_declared("cells", self.declared_cells, self.types.len())?;
        let cells = self.cells(num_points, watch)?;
        check_lengths(&self.point_data, num_points)?;
        check_lengths(&self.cell_data, self.types.len())?;
        if let Some(markers) = &self.markers {
            check_length("marker", markers.len(), num_points)?;
        }
        let mut attributes = self.point_data;
        attributes.splice(0..0, heights(&self.points, &attributes));
        let (triangle_attributes, markers) = part(self.cell_data, &cells);
        let mut vertices = PointSet {
            points: plane(&self.points, watch)?,
            attributes,
            markers: self.markers,
            ..PointSet::default()
        };
        six_nodes::drop_midpoints(&mut vertices, &cells.triangles, &cells.middles)?;
        Ok(MeshData {
            vertices,
            quadratic: !cells.triangles.is_empty() && cells.num_quadratic == cells.triangles.len(),
            triangles: cells.triangles,
            triangle_attributes,
            constraints: (!cells.lines.is_empty()).then(|| Constraints {
                edges: cells.lines,
                markers,
                ..Constraints::default()
            }),
        })
    }

    /// Takes the cells apart by their types.
    fn cells(&self, num_vertices: usize, watch: &dyn Watch) -> Result<Cells, Stop> {
        let [types, ends] = [&self.types, &self.offsets].map(Vec::len);
        if types != ends {
            return Err(other(format!(
                "{types} types and {ends} offsets do not fit together"
            ))
            .into());
        }
        let mut cells = Cells::default();
        let mut rest = self.connectivity.as_slice();
        let mut expected = 0;
        for (cell, (&kind, &end)) in self.types.iter().zip(&self.offsets).enumerate() {
            poll(watch, cell)?;
            let size = size_of_cell(cell, kind)?;
            expected += size;
            if end != expected as f64 {
                let text = format!("cell {cell} ends at offset {end}, expected {expected}");
                return Err(other(text).into());
            }
            let Some((corners, others)) = rest.split_at_checked(size) else {
                let found = self.connectivity.len();
                let text = format!("{found} corners of cells, {expected} or more expected");
                return Err(other(text).into());
            };
            rest = others;
            cells.push((cell, kind), corners, num_vertices)?;
        }
        if !rest.is_empty() {
            let found = self.connectivity.len();
            return Err(other(format!("{found} corners of cells, {expected} expected")).into());
        }
        Ok(cells)
    }
}

/// The cells of a grid by type, each with its place among all.
#[derive(Default)]
struct Cells {
    triangles: Vec<[VertexId; 3]>,
    lines: Vec<[VertexId; 2]>,
    /// The midpoints of triangles and lines that have them, and how many triangles do.
    middles: Vec<VertexId>,
    num_quadratic: usize,
    /// Whether each cell is a line; empty if none is.
    is_line: Vec<bool>,
}

impl Cells {
    fn push(
        &mut self,
        (cell, kind): (usize, f64),
        nodes: &[f64],
        num_vertices: usize,
    ) -> Result<(), Problem> {
        let is_line = [LINE, QUADRATIC_LINE].map(f64::from).contains(&kind);
        let middles = match *nodes {
            [a, b, ref middles @ ..] if is_line => {
                self.is_line.resize(cell, false);
                self.is_line.push(true);
                self.lines
                    .push(vertices(("line", cell), [a, b], num_vertices)?);
                middles
            }
            [a, b, c, ref middles @ ..] => {
                let corners = vertices(("triangle", cell), [a, b, c], num_vertices)?;
                self.triangles.push(corners);
                self.num_quadratic += usize::from(!middles.is_empty());
                middles
            }
            _ => unreachable!("bug: a cell of another size"),
        };
        for &middle in middles {
            let [middle] = vertices(("cell", cell), [middle], num_vertices)?;
            self.middles.push(middle);
        }
        Ok(())
    }

    /// Picks the values of lines, or those of triangles.
    fn pick(&self, values: &[f64], of_lines: bool) -> Vec<f64> {
        let is_line = |i: usize| self.is_line.get(i).copied().unwrap_or(false);
        let all = values.iter().enumerate();
        let picked = all.filter(|&(i, _)| is_line(i) == of_lines);
        picked.map(|(_, &value)| value).collect()
    }
}

/// Returns the number of nodes of a cell.
fn size_of_cell(cell: usize, kind: f64) -> Result<usize, Problem> {
    match kind {
        _ if kind == f64::from(TRIANGLE) => Ok(3),
        _ if kind == f64::from(LINE) => Ok(2),
        _ if kind == f64::from(QUADRATIC_TRIANGLE) => Ok(6),
        _ if kind == f64::from(QUADRATIC_LINE) => Ok(3),
        _ => Err(other(format!(
            "cell {cell} has VTK type {kind}: only triangles (5, quadratic 22) and lines (3, \
             quadratic 21) are understood"
        ))),
    }
}

/// Parts the data of cells into attributes of triangles and markers of lines.
fn part(data: Vec<Attribute>, cells: &Cells) -> (Vec<Attribute>, Option<Vec<i32>>) {
    if cells.lines.is_empty() {
        return (data, None);
    }
    let mut markers = None;
    let mut of_triangles = Vec::new();
    for Attribute { name, values } in data {
        let of_lines = cells.pick(&values, true);
        if name == "marker" && of_lines.iter().all(|&v| is_marker(v)) {
            markers = Some(of_lines.into_iter().map(|v| v as i32).collect());
        } else {
            let values = cells.pick(&values, false);
            of_triangles.push(Attribute { name, values });
        }
    }
    (of_triangles, markers)
}

/// Tells whether numbers named as markers can be kept as such, to the last digit.
fn are_markers(head: &ArrayHead, values: &[f64]) -> bool {
    head.is_integer() && values.iter().all(|&v| is_marker(v))
}

fn is_marker(value: f64) -> bool {
    f64::from(value as i32) == value
}

/// Adds an array to `data`: as it is, or each of its components.
fn split(head: ArrayHead, values: Vec<f64>, data: &mut Vec<Attribute>) -> Result<(), Problem> {
    let ArrayHead {
        name, components, ..
    } = head;
    if components == 1 {
        data.push(Attribute { name, values });
        return Ok(());
    }
    if !values.len().is_multiple_of(components) {
        let found = values.len();
        return Err(other(format!(
            "array {name:?} has {found} values: not a multiple of {components}"
        )));
    }
    for k in 0..components {
        data.push(Attribute {
            name: format!("{name}_{k}"),
            values: values.iter().copied().skip(k).step_by(components).collect(),
        });
    }
    Ok(())
}

/// Returns the third coordinates as an attribute, unless all are zero.
fn heights(coordinates: &[f64], attributes: &[Attribute]) -> Option<Attribute> {
    let (rows, _) = coordinates.as_chunks::<3>();
    if rows.iter().all(|row| row[2] == 0.0) {
        return None;
    }
    let taken = attributes.iter().any(|a| a.name == "z");
    Some(Attribute {
        name: if taken { "Points_2" } else { "z" }.to_owned(),
        values: rows.iter().map(|row| row[2]).collect(),
    })
}

/// Returns the points of the plane, which must be finite.
fn plane(coordinates: &[f64], watch: &dyn Watch) -> Result<Vec<Point>, Stop> {
    let (rows, _) = coordinates.as_chunks::<3>();
    if rows.len() as u64 > node::MAX_POINTS {
        return Err(node::too_many(rows.len() as u64).into());
    }
    let mut points = Vec::with_capacity(rows.len());
    for (index, &[x, y, _]) in rows.iter().enumerate() {
        poll(watch, index)?;
        if let Some((axis, value)) = [('x', x), ('y', y)].into_iter().find(|c| !c.1.is_finite()) {
            let (index, text) = (index as u64, value.to_string());
            return Err(Problem::NotFinite { index, axis, text }.into());
        }
        points.push(Point::new(x, y));
    }
    Ok(points)
}

/// Takes the corners of a cell as vertices, which must exist.
fn vertices<const N: usize>(
    (item, cell): (&'static str, usize),
    corners: [f64; N],
    num_vertices: usize,
) -> Result<[VertexId; N], Problem> {
    let is_vertex = |v: f64| (0.0..num_vertices as f64).contains(&v) && v.fract() == 0.0;
    match corners.into_iter().find(|&v| !is_vertex(v)) {
        None => Ok(corners.map(|v| VertexId::new(v as usize))),
        Some(index) => Err(Problem::BadIndex {
            item,
            row: cell as u64,
            target: "vertex",
            index: index as i64,
            limit: num_vertices as u64,
            base: 0,
        }),
    }
}

fn check_declared(items: &str, declared: Option<u64>, found: usize) -> Result<(), Problem> {
    match declared {
        Some(declared) if declared != found as u64 => Err(other(format!(
            "the piece declares {declared} {items}, its arrays hold {found}"
        ))),
        _ => Ok(()),
    }
}

fn check_lengths(data: &[Attribute], expected: usize) -> Result<(), Problem> {
    data.iter()
        .try_for_each(|a| check_length(&a.name, a.values.len(), expected))
}

fn check_length(name: &str, found: usize, expected: usize) -> Result<(), Problem> {
    if found == expected {
        return Ok(());
    }
    Err(other(format!(
        "array {name:?} has {found} values, expected {expected}"
    )))
}
