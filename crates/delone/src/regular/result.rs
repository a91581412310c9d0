//! The result: the triangulation of the sites that are not hidden, and its dual points.

use crate::predicates::{Weighted, power_center};
use crate::{Mesh, Point, TriangleId, Triangulation, VertexId};

/// The regular triangulation of points with weights: vertex `i` is point `i` of the input.
#[derive(Clone, Debug)]
pub struct Regular {
    triangulation: Triangulation,
    weights: Vec<f64>,
    /// Sorted.
    hidden: Vec<VertexId>,
}

impl Regular {
    /// Puts a result together from a mesh, triangles first; `only` is the vertex of a mesh without faces.
    pub(super) fn new(
        points: Vec<Point>,
        weights: Vec<f64>,
        mesh: Mesh,
        num_triangles: usize,
        only: Option<VertexId>,
    ) -> Self {
        let mut is_hidden = vec![true; points.len()];
        let corners = mesh.faces().as_flattened().iter().chain(&only);
        for v in corners.filter(|v| !v.is_infinite()) {
            is_hidden[v.index()] = false;
        }
        let names = (0..points.len()).map(VertexId::new);
        let hidden: Vec<_> = names.filter(|v| is_hidden[v.index()]).collect();
        let triangulation = Triangulation::from_parts(points, mesh, num_triangles, Vec::new());
        Self {
            triangulation: triangulation.with_hidden(hidden.len()),
            weights,
            hidden,
        }
    }

    /// Returns the triangles, neighbours, hull, mesh and hash.
    ///
    /// Its vertices are the points that are not hidden. It lists no duplicates: of several points in one
    /// place, all but one are hidden.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// Returns the weights as the caller gave them.
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// Returns a point with its weight.
    ///
    /// # Panics
    /// If `v` is the infinite vertex or no point of the input.
    #[inline]
    pub fn site(&self, v: VertexId) -> Weighted {
        Weighted {
            point: self.triangulation.point(v),
            weight: self.weights[v.index()],
        }
    }

    /// Returns the points that are no vertices, in order: their cells of the power diagram are empty.
    pub fn hidden(&self) -> &[VertexId] {
        &self.hidden
    }

    /// Tells whether point `v` is hidden.
    ///
    /// *Cost*: O(log h) for h hidden points.
    pub fn is_hidden(&self, v: VertexId) -> bool {
        self.hidden.binary_search(&v).is_ok()
    }

    /// Returns the power center of triangle `t`, where the cells of its corners meet, correctly
    /// [rounded](power_center).
    ///
    /// Centres are distinct or equal as exact places round; triangles that only the symbolic perturbation
    /// tells apart have one exact center, and get the same one.
    ///
    /// # Panics
    /// If `t` is no triangle.
    pub fn power_center(&self, t: TriangleId) -> Point {
        let [a, b, c] = self.triangulation.triangles()[t.index()].map(|v| self.site(v));
        power_center(a, b, c).expect("bug: a triangle that is flat")
    }
}
