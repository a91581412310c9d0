//! Checks that a mesh is a closed triangulated sphere; knows nothing of where its vertices lie.
//!
//! Linear but for one sort. A mesh that passes may still overlap itself in the plane: that is for
//! the [verifier](crate::check) to find.

use super::{HalfEdgeId, Mesh, TriangleId, VertexId};

/// How a mesh fails to be a closed triangulated sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum TopologyError {
    /// A twin is no half-edge of the mesh.
    #[error("the twin of half-edge {half_edge:?} is {twin:?}, which does not exist")]
    NoSuchTwin {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// What is stored as its twin.
        twin: HalfEdgeId,
    },
    /// A half-edge is not the twin of its twin, or is its own.
    #[error("half-edge {half_edge:?} is not the twin of its twin {twin:?}")]
    NotInvolutive {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// Its twin.
        twin: HalfEdgeId,
    },
    /// A face has more than one corner at infinity.
    #[error("face {face:?} has more than one corner at infinity")]
    InfiniteTwice {
        /// The face.
        face: TriangleId,
    },
    /// A half-edge starts and ends at the same vertex.
    #[error("half-edge {half_edge:?} is a loop at vertex {vertex:?}")]
    Loop {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// Its only vertex.
        vertex: VertexId,
    },
    /// A half-edge does not run against its twin.
    #[error("half-edge {half_edge:?} and its twin {twin:?} do not join the same vertices")]
    TwinElsewhere {
        /// The half-edge.
        half_edge: HalfEdgeId,
        /// Its twin.
        twin: HalfEdgeId,
    },
    /// The half-edges that start at a vertex form more than one cycle.
    #[error("vertex {vertex:?} has two stars, one with half-edge {one:?}, one with {other:?}")]
    SplitStar {
        /// The vertex.
        vertex: VertexId,
        /// A half-edge that starts there.
        one: HalfEdgeId,
        /// A half-edge of another star.
        other: HalfEdgeId,
    },
    /// A face cannot be reached from the first one.
    #[error("face {face:?} is not connected to the first one")]
    Disconnected {
        /// The face.
        face: TriangleId,
    },
    /// Vertices − edges + faces is not 2: the surface has handles.
    #[error("{vertices} vertices and {faces} faces do not make a sphere, which has V = F/2 + 2")]
    NotASphere {
        /// Number of vertices, the one at infinity included.
        vertices: usize,
        /// Number of faces, ghosts included.
        faces: usize,
    },
}

impl Mesh {
    /// Checks that this is a closed triangulated sphere in which every ghost has one corner at
    /// infinity. The empty mesh is accepted.
    ///
    /// # Errors
    /// The first flaw found, naming a culprit.
    ///
    /// *Cost*: O(F + V log V).
    pub fn validate(&self) -> Result<(), TopologyError> {
        self.half_edges().try_for_each(|h| self.check_twin(h))?;
        self.half_edges().try_for_each(|h| self.check_loop(h))?;
        self.half_edges().try_for_each(|h| self.check_ends(h))?;
        let stars = self.stars();
        check_one_star_each(&stars)?;
        self.check_connected()?;
        self.check_euler(stars.len())
    }

    fn check_twin(&self, half_edge: HalfEdgeId) -> Result<(), TopologyError> {
        let twin = self.twin(half_edge);
        if twin.index() >= 3 * self.num_faces() {
            Err(TopologyError::NoSuchTwin { half_edge, twin })
        } else if self.twin(twin) != half_edge || twin == half_edge {
            Err(TopologyError::NotInvolutive { half_edge, twin })
        } else {
            Ok(())
        }
    }

    fn check_loop(&self, half_edge: HalfEdgeId) -> Result<(), TopologyError> {
        let vertex = self.origin(half_edge);
        if vertex != self.dest(half_edge) {
            Ok(())
        } else if vertex.is_infinite() {
            let face = half_edge.triangle();
            Err(TopologyError::InfiniteTwice { face })
        } else {
            Err(TopologyError::Loop { half_edge, vertex })
        }
    }

    fn check_ends(&self, half_edge: HalfEdgeId) -> Result<(), TopologyError> {
        let twin = self.twin(half_edge);
        let ends = [self.origin(half_edge), self.dest(half_edge)];
        if ends == [self.dest(twin), self.origin(twin)] {
            Ok(())
        } else {
            Err(TopologyError::TwinElsewhere { half_edge, twin })
        }
    }

    /// Lists one half-edge of every star, with its origin, sorted.
    ///
    /// Turning about an origin is a permutation of the half-edges as soon as twins are involutive,
    /// so every half-edge lies in exactly one cycle and this ends.
    fn stars(&self) -> Vec<(VertexId, HalfEdgeId)> {
        let mut seen = vec![false; 3 * self.num_faces()];
        let mut stars = Vec::with_capacity(self.num_faces() / 2 + 2);
        for first in self.half_edges() {
            if !seen[first.index()] {
                stars.push((self.origin(first), first));
                self.star(first).for_each(|h| seen[h.index()] = true);
            }
        }
        stars.sort_unstable();
        stars
    }

    fn check_connected(&self) -> Result<(), TopologyError> {
        let mut seen = vec![false; self.num_faces()];
        let mut open = Vec::new();
        let mut reach = |t: TriangleId, open: &mut Vec<_>| {
            if !std::mem::replace(&mut seen[t.index()], true) {
                open.push(t);
            }
        };
        if self.num_faces() > 0 {
            reach(TriangleId::new(0), &mut open);
        }
        while let Some(t) = open.pop() {
            for h in t.half_edges() {
                reach(self.twin(h).triangle(), &mut open);
            }
        }
        match seen.iter().position(|&seen| !seen) {
            Some(t) => Err(TopologyError::Disconnected {
                face: TriangleId::new(t),
            }),
            None => Ok(()),
        }
    }

    /// With E = 3F/2, Euler's V − E + F = 2 reads 2V = F + 4.
    fn check_euler(&self, vertices: usize) -> Result<(), TopologyError> {
        let faces = self.num_faces();
        if faces > 0 && 2 * vertices != faces + 4 {
            return Err(TopologyError::NotASphere { vertices, faces });
        }
        Ok(())
    }
}

fn check_one_star_each(stars: &[(VertexId, HalfEdgeId)]) -> Result<(), TopologyError> {
    for pair in stars.windows(2) {
        let [(vertex, one), (next, other)] = [pair[0], pair[1]];
        if vertex == next {
            return Err(TopologyError::SplitStar { vertex, one, other });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const INF: u32 = u32::MAX;

    /// Glues faces along half-edges that run against each other, in the order they are found.
    fn glue(faces: &[[u32; 3]]) -> Mesh {
        let corners: Vec<_> = faces.iter().map(|f| f.map(VertexId::from)).collect();
        let flat = corners.as_flattened();
        let ends = |h: HalfEdgeId| (flat[h.next().index()], flat[h.prev().index()]);
        let all = || (0..flat.len()).map(HalfEdgeId::new);
        let mut twins: Vec<_> = all().collect();
        for h in all() {
            let (a, b) = ends(h);
            let free = |g: &HalfEdgeId| twins[g.index()] == *g && *g != h && ends(*g) == (b, a);
            if twins[h.index()] == h
                && let Some(g) = all().find(free)
            {
                (twins[h.index()], twins[g.index()]) = (g, h);
            }
        }
        let rows = twins.chunks_exact(3).map(|t| [t[0], t[1], t[2]]);
        Mesh::from_rows(corners.clone(), rows.collect())
    }

    fn tetrahedron(a: u32, b: u32, c: u32, d: u32) -> [[u32; 3]; 4] {
        [[a, b, c], [b, a, d], [c, b, d], [a, c, d]]
    }

    /// The seven-vertex torus of Möbius.
    fn torus() -> Vec<[u32; 3]> {
        (0..7)
            .flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]])
            .collect()
    }

    #[test]
    fn accepts_spheres_and_nothing() {
        Mesh::default().validate().expect("the empty mesh");
        glue(&tetrahedron(0, 1, 2, INF))
            .validate()
            .expect("a triangle and three ghosts");
    }

    #[test]
    fn names_an_open_edge() {
        let mesh = glue(&tetrahedron(0, 1, 2, INF)[..3]);
        let error = mesh.validate().expect_err("a hole");
        assert!(matches!(error, TopologyError::NotInvolutive { .. }));
    }

    #[test]
    fn names_a_twin_out_of_range() {
        let mut mesh = glue(&tetrahedron(0, 1, 2, INF));
        mesh.twins[1][0] = HalfEdgeId::new(12);
        let error = mesh.validate().expect_err("a dangling twin");
        assert_eq!(
            error.to_string(),
            "the twin of half-edge h3 is h12, which does not exist"
        );
    }

    #[test]
    fn names_swapped_twins() {
        let mut mesh = glue(&tetrahedron(0, 1, 2, INF));
        let [a, b] = [mesh.twins[0][0], mesh.twins[0][1]];
        let (s, t) = (a.triangle().index(), b.triangle().index());
        mesh.twins[0] = [b, a, mesh.twins[0][2]];
        mesh.twins[s][a.slot()] = HalfEdgeId::new(1);
        mesh.twins[t][b.slot()] = HalfEdgeId::new(0);
        let error = mesh.validate().expect_err("crossed twins");
        let culprit = HalfEdgeId::new(0);
        assert!(
            matches!(error, TopologyError::TwinElsewhere { half_edge, .. } if half_edge == culprit)
        );
    }

    #[test]
    fn names_loops_and_double_infinity() {
        let looped = glue(&[[0, 0, 1], [0, 0, 1]]).validate();
        assert!(looped.is_err());
        let mut mesh = glue(&tetrahedron(0, 1, 2, INF));
        mesh.corners[0][0] = VertexId::INFINITE;
        mesh.corners[0][1] = VertexId::INFINITE;
        let face = TriangleId::new(0);
        assert_eq!(mesh.validate(), Err(TopologyError::InfiniteTwice { face }));
        let mut mesh = glue(&tetrahedron(0, 1, 2, INF));
        mesh.corners[0][0] = VertexId::from(1);
        assert!(matches!(mesh.validate(), Err(TopologyError::Loop { .. })));
    }

    #[test]
    fn names_a_pinched_vertex() {
        let mut faces = tetrahedron(0, 1, 2, INF).to_vec();
        faces.extend(tetrahedron(0, 3, 4, 5));
        let error = glue(&faces)
            .validate()
            .expect_err("two spheres on one vertex");
        let pinched = VertexId::from(0);
        assert!(matches!(error, TopologyError::SplitStar { vertex, .. } if vertex == pinched));
    }

    #[test]
    fn names_a_second_component() {
        let mut faces = tetrahedron(0, 1, 2, INF).to_vec();
        faces.extend(torus().iter().map(|f| f.map(|v| v + 10)));
        // The torus hides the second sphere from Euler's formula.
        let face = TriangleId::new(4);
        assert_eq!(
            glue(&faces).validate(),
            Err(TopologyError::Disconnected { face })
        );
    }

    #[test]
    fn names_a_torus() {
        let error = glue(&torus()).validate().expect_err("a handle");
        let (vertices, faces) = (7, 14);
        assert_eq!(error, TopologyError::NotASphere { vertices, faces });
    }
}
