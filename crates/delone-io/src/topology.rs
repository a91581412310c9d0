//! Neighbours, edges and boundary of a mesh that is to be written.
//!
//! A [`Triangulation`] knows them; for bare triangles, neighbours are found from their half-edges.
//! Where more than two triangles meet in an edge, or two with the same orientation, no pair is
//! made: such edges count as boundary, once for each triangle.

use crate::{Error, cancel};
use delone::{TriangleId, Triangulation, VertexId, Watch};

/// Most triangles whose half-edges 32 bits can number.
const MAX_TRIANGLES: usize = (u32::MAX / 3) as usize;

/// Checks a number of triangles.
pub(crate) fn check_num_triangles(given: usize) -> Result<(), Error> {
    if given <= MAX_TRIANGLES {
        return Ok(());
    }
    Err(Error::BadMesh(format!(
        "{given} triangles, at most {MAX_TRIANGLES} are possible; split the data into tiles"
    )))
}

/// Stands for "no neighbour".
pub(crate) const NO_NEIGHBOR: u32 = u32::MAX;

/// Neighbours, edges and boundary of a mesh.
pub(crate) struct Topology {
    /// Neighbour `k` of each triangle lies opposite its corner `k`.
    pub neighbors: Vec<[u32; 3]>,
    /// All edges: in the order of their first half-edges, then those without triangles.
    pub edges: Vec<Edge>,
}

/// An edge of a mesh.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Edge {
    /// The vertices it joins.
    pub ends: [u32; 2],
    /// Whether less than two triangles share it.
    pub on_boundary: bool,
}

impl Topology {
    /// Takes neighbours and edges from a triangulation.
    pub fn of_triangulation(
        triangulation: &Triangulation,
        watch: &dyn Watch,
    ) -> Result<Self, Error> {
        let row = |t| {
            triangulation
                .neighbors(TriangleId::new(t))
                .map(|n| n.map_or(NO_NEIGHBOR, TriangleId::raw))
        };
        let mut neighbors = Vec::with_capacity(triangulation.num_triangles());
        for t in 0..triangulation.num_triangles() {
            cancel::check(watch, t)?;
            neighbors.push(row(t));
        }
        let mut edges = edges_of(triangulation.triangles(), &neighbors, watch)?;
        if neighbors.is_empty() {
            // All points lie on one line: the edges along it have no triangles.
            edges.extend(triangulation.edges().map(|ends| Edge {
                ends: ends.map(VertexId::raw),
                on_boundary: true,
            }));
        }
        Ok(Self { neighbors, edges })
    }

    /// Finds the neighbours of bare triangles. *Cost*: linear, if few triangles meet in a vertex.
    pub fn of_triangles(triangles: &[[VertexId; 3]], watch: &dyn Watch) -> Result<Self, Error> {
        let neighbors = pair_up(triangles, watch)?;
        let edges = edges_of(triangles, &neighbors, watch)?;
        Ok(Self { neighbors, edges })
    }

    /// Finds for each triangle its edges, opposite its corners, as indices of [`edges`](Self::edges).
    pub fn sides(
        &self,
        triangles: &[[VertexId; 3]],
        watch: &dyn Watch,
    ) -> Result<Vec<[u32; 3]>, Error> {
        let mut sides: Vec<[u32; 3]> = Vec::with_capacity(triangles.len());
        let mut next = 0;
        for (t, &triangle) in triangles.iter().enumerate() {
            cancel::check(watch, t)?;
            let mut row = [0; 3];
            for (k, side) in row.iter_mut().enumerate() {
                let neighbor = self.neighbors[t][k];
                // Numbered as they were listed: by the smaller of two triangles.
                if (t as u32) < neighbor {
                    *side = next;
                    next += 1;
                    continue;
                }
                let neighbor = neighbor as usize;
                let [from, to] = ends(triangle, k);
                let is_same = |&j: &usize| ends(triangles[neighbor], j) == [to, from];
                let slot = (0..3)
                    .find(is_same)
                    .expect("bug: neighbours without an edge");
                *side = sides[neighbor][slot];
            }
            sides.push(row);
        }
        Ok(sides)
    }

    /// Marks each vertex: 1 on the boundary, 0 elsewhere.
    pub fn boundary_markers(&self, num_vertices: usize) -> Vec<i32> {
        let mut markers = vec![0; num_vertices];
        for edge in self.edges.iter().filter(|e| e.on_boundary) {
            for v in edge.ends {
                markers[v as usize] = 1;
            }
        }
        markers
    }
}

/// Returns the ends of the half-edge opposite corner `k`.
fn ends(triangle: [VertexId; 3], k: usize) -> [u32; 2] {
    [triangle[(k + 1) % 3].raw(), triangle[(k + 2) % 3].raw()]
}

fn edges_of(
    triangles: &[[VertexId; 3]],
    neighbors: &[[u32; 3]],
    watch: &dyn Watch,
) -> Result<Vec<Edge>, Error> {
    let mut edges = Vec::with_capacity(triangles.len() / 2 * 3 + 3);
    for (t, (&triangle, row)) in triangles.iter().zip(neighbors).enumerate() {
        cancel::check(watch, t)?;
        for (k, &neighbor) in row.iter().enumerate() {
            // Of an edge's two half-edges, the one of the smaller triangle speaks; NO_NEIGHBOR is
            // larger than every triangle.
            if (t as u32) < neighbor {
                edges.push(Edge {
                    ends: ends(triangle, k),
                    on_boundary: neighbor == NO_NEIGHBOR,
                });
            }
        }
    }
    Ok(edges)
}

/// Finds neighbours: half-edges are gathered at the smaller of their ends, where few meet.
fn pair_up(triangles: &[[VertexId; 3]], watch: &dyn Watch) -> Result<Vec<[u32; 3]>, Error> {
    let mut gathered = gather(triangles, watch)?;
    let mut neighbors = vec![[NO_NEIGHBOR; 3]; triangles.len()];
    for (v, range) in gathered.ranges.windows(2).enumerate() {
        cancel::check(watch, v)?;
        let at_vertex = &mut gathered.half_edges[range[0]..range[1]];
        at_vertex.sort_unstable();
        for same_edge in at_vertex.chunk_by(|a, b| a.0 == b.0) {
            if let &[(_, g), (_, h)] = same_edge {
                pair(triangles, &mut neighbors, [g, h].map(|h| h as usize));
            }
        }
    }
    Ok(neighbors)
}

/// Makes two half-edges of the same edge neighbours, if they run in opposite directions.
fn pair(triangles: &[[VertexId; 3]], neighbors: &mut [[u32; 3]], [g, h]: [usize; 2]) {
    let origin = |h: usize| ends(triangles[h / 3], h % 3)[0];
    if origin(g) != origin(h) && g / 3 != h / 3 {
        neighbors[g / 3][g % 3] = (h / 3) as u32;
        neighbors[h / 3][h % 3] = (g / 3) as u32;
    }
}

/// Half-edges by the smaller of their ends.
struct Gathered {
    /// For each vertex, where its half-edges begin; one more at the end.
    ranges: Vec<usize>,
    /// The larger end, and the half-edge.
    half_edges: Vec<(u32, u32)>,
}

fn gather(triangles: &[[VertexId; 3]], watch: &dyn Watch) -> Result<Gathered, Error> {
    let largest = triangles.as_flattened().iter().max();
    let num_vertices = largest.map_or(0, |v| v.index() + 1);
    // Counts stand two places further on, so that after summing, and filling, they are beginnings.
    let mut ranges = vec![0; num_vertices + 2];
    for (t, &triangle) in triangles.iter().enumerate() {
        cancel::check(watch, t)?;
        for [a, b] in [0, 1, 2].map(|k| ends(triangle, k)) {
            ranges[a.min(b) as usize + 2] += 1;
        }
    }
    for v in 1..ranges.len() {
        ranges[v] += ranges[v - 1];
    }
    let mut half_edges = vec![(0, 0); 3 * triangles.len()];
    for (t, &triangle) in triangles.iter().enumerate() {
        cancel::check(watch, t)?;
        for k in 0..3 {
            let [a, b] = ends(triangle, k);
            let place = &mut ranges[a.min(b) as usize + 1];
            half_edges[*place] = (a.max(b), (3 * t + k) as u32);
            *place += 1;
        }
    }
    ranges.pop();
    Ok(Gathered { ranges, half_edges })
}

#[cfg(test)]
mod tests {
    use super::{MAX_TRIANGLES, Topology, check_num_triangles};
    use delone::{Point, VertexId, triangulate};

    #[test]
    fn bare_triangles_have_the_neighbours_of_their_triangulation() {
        let points: Vec<Point> = (0..300u32)
            .map(|i| Point::new(f64::from(i * i % 101), f64::from(i * i * i % 97)))
            .collect();
        let t = triangulate(points).expect("finite points");
        let known = Topology::of_triangulation(&t, &()).expect("not cancelled");
        let found = Topology::of_triangles(t.triangles(), &()).expect("not cancelled");
        assert_eq!(known.neighbors, found.neighbors);
        assert_eq!(known.edges, found.edges);
        assert_eq!(known.edges.len(), t.num_edges());
        let sides = known.sides(t.triangles(), &()).expect("not cancelled");
        for (&triangle, row) in t.triangles().iter().zip(&sides) {
            for (k, &side) in row.iter().enumerate() {
                let mut found = known.edges[side as usize].ends;
                let mut own = super::ends(triangle, k);
                found.sort();
                own.sort();
                assert_eq!(found, own);
            }
        }
        let mut on_hull = vec![0; t.points().len()];
        t.hull().for_each(|v| on_hull[v.index()] = 1);
        assert_eq!(known.boundary_markers(on_hull.len()), on_hull);
    }

    #[test]
    fn more_triangles_than_half_edges_can_number_are_refused() {
        assert!(check_num_triangles(MAX_TRIANGLES).is_ok());
        let error = check_num_triangles(MAX_TRIANGLES + 1).expect_err("too many");
        assert!(
            error.to_string().contains("1431655766 triangles"),
            "{error}"
        );
    }

    #[test]
    fn collinear_points_have_edges_without_triangles() {
        let t = triangulate([(0.0, 0.0), (2.0, 0.0), (1.0, 0.0)]).expect("finite points");
        let topology = Topology::of_triangulation(&t, &()).expect("not cancelled");
        assert_eq!(topology.edges.len(), 2);
        assert_eq!(topology.boundary_markers(3), [1, 1, 1]);
    }

    #[test]
    fn three_triangles_at_an_edge_are_not_paired() {
        let triangles = [[0, 1, 2], [1, 0, 3], [0, 1, 4]].map(|t| t.map(VertexId::from));
        let topology = Topology::of_triangles(&triangles, &()).expect("not cancelled");
        assert!(
            topology
                .neighbors
                .as_flattened()
                .iter()
                .all(|&n| n == super::NO_NEIGHBOR)
        );
        assert_eq!(topology.edges.len(), 9);
    }
}
