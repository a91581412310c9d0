//! The tables as the thesis prints them, for worked examples and whoever shows them.

use super::{Side, Tables, numbered};
use crate::{Error, VertexId};

/// The edge tables of a mesh as the thesis (Ulm, 2012) prints them in its examples 2.13 to 2.20: all
/// numbers count from 1, and 0 is none.
///
/// ```
/// use delone::VertexId;
/// use delone::classic::EdgeTables;
///
/// let triangles = [[0, 1, 2], [1, 3, 2]].map(|t| t.map(VertexId::new));
/// let tables = EdgeTables::new(4, &triangles)?;
/// assert_eq!(tables.edges_with_triangles[2], [3, 2, 1, 2, 2, 3]); // edge 3–2: 2nd of triangle 1, 3rd of 2
/// assert_eq!(tables.triangles_with_edges, [[1, 3, 2], [4, 5, 3]]);
/// # Ok::<(), delone::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct EdgeTables {
    /// `triangles`: the corners of each triangle, counter-clockwise.
    pub triangles: Vec<[u32; 3]>,
    /// `edges_with_triangles`: the larger and the smaller end of each edge, its first triangle and its
    /// position in that, its second triangle and its position in that. Position 1, 2 and 3 are the edges
    /// from first to second corner, from second to third, from third to first. Edges are numbered
    /// by the smaller end, then by the larger, until flips write others into their rows.
    pub edges_with_triangles: Vec<[u32; 6]>,
    /// `triangles_with_edges`: the numbers of the edges of each triangle, by position.
    pub triangles_with_edges: Vec<[u32; 3]>,
}

impl EdgeTables {
    /// Makes the tables of triangles, counter-clockwise, among so many points.
    ///
    /// # Errors
    /// [`Error::BadTriangle`] if a corner does not exist; [`Error::SameSide`] if two triangles have the same
    /// directed edge: then these are no mesh.
    ///
    /// *Cost*: O(n log n).
    pub fn new(points: usize, triangles: &[[VertexId; 3]]) -> Result<Self, Error> {
        for (triangle, corners) in triangles.iter().enumerate() {
            if let Some(&vertex) = corners.iter().find(|v| v.index() >= points) {
                return Err(Error::BadTriangle {
                    triangle,
                    vertex,
                    points,
                });
            }
        }
        let corners = triangles.iter().map(|t| t.map(VertexId::raw));
        let corners: Vec<_> = corners.collect();
        let mut rows = Vec::new();
        let mut edges_of = vec![[0; 3]; triangles.len()];
        for run in numbered(&corners).chunk_by(|a, b| a.0 == b.0) {
            require_opposite(&corners, run)?;
            let second = run.get(1).map(|&(_, side)| side);
            rows.push(printed_row(run[0].0, run[0].1, second));
            for (_, side) in run {
                edges_of[side.triangle as usize][side.position] = rows.len() as u32 - 1;
            }
        }
        Ok(Self {
            triangles: from_one(&corners),
            edges_with_triangles: rows,
            triangles_with_edges: from_one(&edges_of),
        })
    }

    /// Lists the entries of the matrix `edges` that are not 0, by rows: row, column, and the triangle that
    /// stands there. Below the diagonal stands the first triangle of an edge, above it the second.
    pub fn edges(&self) -> Vec<[u32; 3]> {
        let rows = self.edges_with_triangles.iter();
        let entries = rows.flat_map(|&[high, low, t, _, u, _]| [[high, low, t], [low, high, u]]);
        let mut entries: Vec<_> = entries.filter(|&[_, _, t]| t != 0).collect();
        entries.sort_unstable();
        entries
    }
}

/// Prints tables as they stand.
impl From<&Tables> for EdgeTables {
    fn from(tables: &Tables) -> Self {
        let rows = tables.rows.iter().map(|row| {
            let [high, low] = row.ends;
            printed_row([low, high], row.first, row.second)
        });
        Self {
            triangles: from_one(&tables.triangles),
            edges_with_triangles: rows.collect(),
            triangles_with_edges: from_one(&tables.edges_of),
        }
    }
}

fn printed_row([low, high]: [u32; 2], first: Side, second: Option<Side>) -> [u32; 6] {
    let printed = |side: Side| [side.triangle + 1, side.position as u32 + 1];
    let ([t, position], [u, other]) = (printed(first), second.map_or([0, 0], printed));
    [high + 1, low + 1, t, position, u, other]
}

fn from_one(rows: &[[u32; 3]]) -> Vec<[u32; 3]> {
    rows.iter().map(|row| row.map(|n| n + 1)).collect()
}

/// Refuses an edge that does not join two corners, or has two triangles on one side.
fn require_opposite(triangles: &[[u32; 3]], run: &[([u32; 2], Side)]) -> Result<(), Error> {
    let [low, high] = run[0].0;
    let side = |from: u32| {
        let starts = move |side: &&Side| triangles[side.triangle as usize][side.position] == from;
        let mut sides = run.iter().map(|(_, side)| side).filter(starts);
        Some([sides.next()?, sides.next()?].map(|side| side.triangle as usize))
    };
    let edge = |from: u32, to: u32| [from, to].map(|v| VertexId::new(v as usize));
    let refuse = |triangles, edge| Err(Error::SameSide { triangles, edge });
    if low == high {
        return refuse([run[0].1.triangle as usize; 2], edge(low, high));
    }
    match (side(low), side(high)) {
        (Some(triangles), _) => refuse(triangles, edge(low, high)),
        (_, Some(triangles)) => refuse(triangles, edge(high, low)),
        (None, None) => Ok(()),
    }
}
