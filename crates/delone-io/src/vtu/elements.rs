//! The cells of a grid, taken apart to triangles and lines.

use super::{LINE, POLYGON, QUADRATIC_LINE, QUADRATIC_TRIANGLE, TRIANGLE, other};
use crate::Problem;
use delone::VertexId;

/// VTK's numbers for what has no sides, for lines in a row, and for triangles in a row.
const EMPTY: u8 = 0;
const VERTEX: u8 = 1;
const POLY_VERTEX: u8 = 2;
const POLY_LINE: u8 = 4;
const TRIANGLE_STRIP: u8 = 6;

/// Triangles and lines, each with the cell that it comes from.
#[derive(Default)]
pub(super) struct Elements {
    pub triangles: Vec<[VertexId; 3]>,
    pub lines: Vec<[VertexId; 2]>,
    /// The midpoints of triangles and lines that have them, and how many triangles do.
    pub middles: Vec<VertexId>,
    pub num_quadratic: usize,
    cells_of_triangles: Vec<u32>,
    cells_of_lines: Vec<u32>,
    num_cells: usize,
    /// The corners of the cell taken last, to be used again.
    corners: Vec<VertexId>,
}

impl Elements {
    /// Takes a cell.
    pub fn push(
        &mut self,
        (cell, kind): (usize, f64),
        nodes: &[f64],
        num_vertices: usize,
    ) -> Result<(), Problem> {
        let known = (kind as u8, f64::from(kind as u8) == kind);
        let (kind_of_cell, item) = match known {
            (LINE | QUADRATIC_LINE | POLY_LINE, true) => (known.0, "line"),
            (kind, true) => (kind, "triangle"),
            (_, false) => return Err(not_understood(cell, kind)),
        };
        let need = |fits: bool| match fits {
            true => Ok(()),
            false => Err(other(format!(
                "cell {cell} of VTK type {kind} has {} corners",
                nodes.len()
            ))),
        };
        let mut vertices = std::mem::take(&mut self.corners);
        take_vertices(&mut vertices, (item, cell), nodes, num_vertices)?;
        self.num_cells = cell + 1;
        match kind_of_cell {
            EMPTY | VERTEX | POLY_VERTEX => {}
            LINE => {
                need(nodes.len() == 2)?;
                self.add_lines(cell, &vertices);
            }
            POLY_LINE => {
                need(nodes.len() >= 2)?;
                self.add_lines(cell, &vertices);
            }
            QUADRATIC_LINE => {
                need(nodes.len() == 3)?;
                self.add_lines(cell, &vertices[..2]);
                self.middles.push(vertices[2]);
            }
            TRIANGLE => {
                need(nodes.len() == 3)?;
                self.add_triangle(cell, [vertices[0], vertices[1], vertices[2]]);
            }
            POLYGON if nodes.len() == 3 => {
                self.add_triangle(cell, [vertices[0], vertices[1], vertices[2]]);
            }
            QUADRATIC_TRIANGLE => {
                need(nodes.len() == 6)?;
                self.add_triangle(cell, [vertices[0], vertices[1], vertices[2]]);
                self.middles.extend(&vertices[3..]);
                self.num_quadratic += 1;
            }
            TRIANGLE_STRIP => {
                need(nodes.len() >= 3)?;
                for (i, row) in vertices.windows(3).enumerate() {
                    // Every other one is the other way round.
                    let (a, b) = if i % 2 == 0 { (0, 1) } else { (1, 0) };
                    self.add_triangle(cell, [row[a], row[b], row[2]]);
                }
            }
            POLYGON => {
                let sides = nodes.len();
                return Err(other(format!(
                    "cell {cell} is a polygon of {sides} corners: only triangles are understood; \
                     triangulate it"
                )));
            }
            _ => return Err(not_understood(cell, kind)),
        }
        self.corners = vertices;
        Ok(())
    }

    fn add_lines(&mut self, cell: usize, vertices: &[VertexId]) {
        for ends in vertices.windows(2) {
            self.lines.push([ends[0], ends[1]]);
            self.cells_of_lines.push(cell as u32);
        }
    }

    fn add_triangle(&mut self, cell: usize, corners: [VertexId; 3]) {
        self.triangles.push(corners);
        self.cells_of_triangles.push(cell as u32);
    }

    /// Tells whether every cell is one triangle.
    pub fn are_all_triangles(&self) -> bool {
        let cells = self.cells_of_triangles.iter();
        self.triangles.len() == self.num_cells && cells.zip(0..).all(|(&cell, t)| cell == t)
    }

    /// Picks the values of lines.
    pub fn of_lines(&self, values: &[f64]) -> Vec<f64> {
        let cells = self.cells_of_lines.iter();
        cells.map(|&cell| values[cell as usize]).collect()
    }

    /// Picks the values of triangles.
    pub fn of_triangles(&self, values: &[f64]) -> Vec<f64> {
        let cells = self.cells_of_triangles.iter();
        cells.map(|&cell| values[cell as usize]).collect()
    }
}

fn not_understood(cell: usize, kind: f64) -> Problem {
    other(format!(
        "cell {cell} has VTK type {kind}: only triangles (5, quadratic 22) and lines (3, \
         quadratic 21) are understood"
    ))
}

/// Takes the corners of a cell as vertices, which must exist.
fn take_vertices(
    vertices: &mut Vec<VertexId>,
    (item, cell): (&'static str, usize),
    corners: &[f64],
    num_vertices: usize,
) -> Result<(), Problem> {
    vertices.clear();
    let is_vertex = |v: f64| (0.0..num_vertices as f64).contains(&v) && v.fract() == 0.0;
    match corners.iter().copied().find(|&v| !is_vertex(v)) {
        None => {
            vertices.extend(corners.iter().map(|&v| VertexId::new(v as usize)));
            Ok(())
        }
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
