//! The arrays of a grid, put together to a mesh: those of `.vtu`, and of `.vtk`.

use super::elements::Elements;
use super::{Stop, other, poll};
use crate::{Attribute, Constraints, MeshData, PointSet, Problem, node, points, six_nodes};
use delone::{Point, Watch};

/// The arrays of a file as they come.
#[derive(Default)]
pub(crate) struct Grid {
    /// What the piece says about itself.
    pub declared_points: Option<u64>,
    pub declared_cells: Option<u64>,
    /// Three coordinates a point.
    pub points: Vec<f64>,
    pub connectivity: Vec<f64>,
    /// Where each cell ends in `connectivity`.
    pub offsets: Vec<f64>,
    pub types: Vec<f64>,
    point_data: Vec<Attribute>,
    markers: Option<Vec<i32>>,
    cell_data: Vec<Attribute>,
    /// What is not kept, in words.
    pub notes: Vec<String>,
}

/// Numbers that go with points or cells.
pub(crate) struct Data {
    pub name: String,
    pub components: usize,
    /// Whether they are integers by their type.
    pub are_integers: bool,
    pub values: Vec<f64>,
}

impl Grid {
    /// Keeps data of points.
    pub fn add_point_data(&mut self, data: Data) -> Result<(), Problem> {
        let is_marker = data.name == MARKER && data.components == 1 && are_markers(&data);
        if !is_marker {
            return split(data, &mut self.point_data);
        }
        self.markers = Some(data.values.into_iter().map(|v| v as i32).collect());
        Ok(())
    }

    /// Keeps data of cells.
    pub fn add_cell_data(&mut self, data: Data) -> Result<(), Problem> {
        split(data, &mut self.cell_data)
    }

    /// Makes the mesh; nothing in the arrays is trusted.
    pub fn into_mesh(mut self, watch: &dyn Watch) -> Result<MeshData, Stop> {
        if !self.points.len().is_multiple_of(3) {
            let found = self.points.len();
            return Err(other(format!("{found} coordinates: not a multiple of 3")).into());
        }
        let num_points = self.points.len() / 3;
        check_declared("points", self.declared_points, num_points)?;
        check_declared("cells", self.declared_cells, self.types.len())?;
        let cells = self.elements(num_points, watch)?;
        check_lengths(&self.point_data, num_points)?;
        check_lengths(&self.cell_data, self.types.len())?;
        if let Some(markers) = &self.markers {
            check_length(MARKER, markers.len(), num_points)?;
        }
        let mut attributes = self.point_data;
        let heights = self.points.iter().copied().skip(2).step_by(3).collect();
        attributes.splice(0..0, points::heights(heights, &attributes));
        let (triangle_attributes, markers) = part(self.cell_data, &cells, &mut self.notes);
        let mut vertices = PointSet {
            points: plane(&self.points, watch)?,
            attributes,
            markers: self.markers,
            notes: self.notes,
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
    fn elements(&self, num_vertices: usize, watch: &dyn Watch) -> Result<Elements, Stop> {
        let [types, ends] = [&self.types, &self.offsets].map(Vec::len);
        if types != ends {
            return Err(other(format!(
                "{types} types and {ends} offsets do not fit together"
            ))
            .into());
        }
        let mut cells = Elements::default();
        let mut begin = 0;
        for (cell, (&kind, &end)) in self.types.iter().zip(&self.offsets).enumerate() {
            poll(watch, cell)?;
            let most = self.connectivity.len();
            if !(end >= begin as f64 && end.fract() == 0.0) {
                let text = format!("cell {cell} ends at offset {end}, expected {begin} or more");
                return Err(other(text).into());
            }
            let Some(nodes) = self.connectivity.get(begin..end as usize) else {
                let text = format!("{most} corners of cells, {end} or more expected");
                return Err(other(text).into());
            };
            begin = end as usize;
            cells.push((cell, kind), nodes, num_vertices)?;
        }
        if begin < self.connectivity.len() {
            let found = self.connectivity.len();
            return Err(other(format!("{found} corners of cells, {begin} expected")).into());
        }
        Ok(cells)
    }
}

/// The data that are markers: of points, and of lines among the cells.
const MARKER: &str = "marker";

/// Data of cells in which others keep what for lines are markers.
const FOREIGN_MARKERS: [&str; 2] = ["gmsh:physical", "CellEntityIds"];

/// Parts the data of cells into attributes of triangles and markers of lines.
fn part(
    data: Vec<Attribute>,
    cells: &Elements,
    notes: &mut Vec<String>,
) -> (Vec<Attribute>, Option<Vec<i32>>) {
    if cells.are_all_triangles() {
        return (data, None);
    }
    let named = |wanted: &str| data.iter().any(|a| a.name == wanted);
    let known = std::iter::once(MARKER).chain(FOREIGN_MARKERS);
    let markers_name = known.into_iter().find(|name| named(name));
    let mut markers = None;
    let mut of_triangles = Vec::new();
    for Attribute { name, values } in data {
        let of_lines = cells.of_lines(&values);
        let are_markers = !of_lines.is_empty()
            && markers_name == Some(&*name)
            && of_lines.iter().all(|&v| is_marker(v));
        // What our own files have there means nothing.
        let says_nothing = |&v: &f64| v.is_nan() || v == 0.0 || v == -1.0;
        if are_markers {
            markers = Some(of_lines.into_iter().map(|v| v as i32).collect());
        } else if !of_lines.iter().all(says_nothing) {
            notes.push(format!("what {name:?} says about lines is not kept"));
        }
        let is_of_lines = are_markers && name == MARKER;
        if !is_of_lines && !cells.triangles.is_empty() {
            let values = cells.of_triangles(&values);
            of_triangles.push(Attribute { name, values });
        }
    }
    (of_triangles, markers)
}

/// Tells whether numbers named as markers can be kept as such, to the last digit.
fn are_markers(data: &Data) -> bool {
    data.are_integers && data.values.iter().all(|&v| is_marker(v))
}

fn is_marker(value: f64) -> bool {
    f64::from(value as i32) == value
}

/// Adds an array to `data`: as it is, or each of its components.
fn split(given: Data, data: &mut Vec<Attribute>) -> Result<(), Problem> {
    let Data {
        name,
        components,
        values,
        ..
    } = given;
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
