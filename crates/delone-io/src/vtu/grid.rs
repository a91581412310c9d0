//! The arrays of a grid, put together to a mesh.

use super::array::ArrayHead;
use super::{Stop, TRIANGLE, other, poll};
use crate::{Attribute, MeshData, PointSet, Problem, node};
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
        let triangles = self.triangles(num_points, watch)?;
        check_lengths(&self.point_data, num_points)?;
        check_lengths(&self.cell_data, triangles.len())?;
        if let Some(markers) = &self.markers {
            check_length("marker", markers.len(), num_points)?;
        }
        let mut attributes = self.point_data;
        attributes.splice(0..0, heights(&self.points, &attributes));
        Ok(MeshData {
            vertices: PointSet {
                points: plane(&self.points, watch)?,
                attributes,
                markers: self.markers,
                ..PointSet::default()
            },
            triangles,
            triangle_attributes: self.cell_data,
        })
    }

    fn triangles(
        &self,
        num_vertices: usize,
        watch: &dyn Watch,
    ) -> Result<Vec<[VertexId; 3]>, Stop> {
        self.check_types(watch)?;
        self.check_offsets(watch)?;
        let [types, ends, corners] = [&self.types, &self.offsets, &self.connectivity].map(Vec::len);
        if types != ends || Some(corners) != types.checked_mul(3) {
            let text =
                format!("{types} types, {ends} offsets and {corners} corners do not fit together");
            return Err(other(text).into());
        }
        let (rows, _) = self.connectivity.as_chunks::<3>();
        let mut triangles = Vec::with_capacity(rows.len());
        for (row, &corners) in rows.iter().enumerate() {
            poll(watch, row)?;
            triangles.push(triangle(row, corners, num_vertices)?);
        }
        Ok(triangles)
    }

    fn check_types(&self, watch: &dyn Watch) -> Result<(), Stop> {
        for (cell, &kind) in self.types.iter().enumerate() {
            poll(watch, cell)?;
            if kind != f64::from(TRIANGLE) {
                let text =
                    format!("cell {cell} has VTK type {kind}: only triangles (5) are understood");
                return Err(other(text).into());
            }
        }
        Ok(())
    }

    fn check_offsets(&self, watch: &dyn Watch) -> Result<(), Stop> {
        for (cell, &end) in self.offsets.iter().enumerate() {
            poll(watch, cell)?;
            let expected = 3 * (cell + 1);
            if end != expected as f64 {
                let text = format!("cell {cell} ends at offset {end}, expected {expected}");
                return Err(other(text).into());
            }
        }
        Ok(())
    }
}

/// Tells whether numbers named as markers can be kept as such, to the last digit.
fn are_markers(head: &ArrayHead, values: &[f64]) -> bool {
    head.is_integer() && values.iter().all(|&v| f64::from(v as i32) == v)
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

fn triangle(row: usize, corners: [f64; 3], num_vertices: usize) -> Result<[VertexId; 3], Problem> {
    let is_vertex = |v: f64| (0.0..num_vertices as f64).contains(&v) && v.fract() == 0.0;
    match corners.into_iter().find(|&v| !is_vertex(v)) {
        None => Ok(corners.map(|v| VertexId::new(v as usize))),
        Some(index) => Err(Problem::BadIndex {
            item: "triangle",
            row: row as u64,
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
