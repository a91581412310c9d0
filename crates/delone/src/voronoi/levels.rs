//! The level of each vertex of the diagram: how often the domain lies around it.
//!
//! Between the ends of an edge the level rises by what crosses it; at infinity it is 0. So each edge says
//! how two vertices differ, and that they are all connected says the rest: a forest in which each vertex
//! knows how far it is above its parent is joined edge by edge, with paths halved, after R. E. Tarjan and
//! J. van Leeuwen, *Worst-case analysis of set union algorithms* (1984).
//!
//! *Cost*: O(m log n) for m edges and n vertices, in practice linear; edges come in the order of the mesh, so
//! what is near is in the cache. Of two roots the one with the smaller number stays, which lets a single
//! sweep settle the levels in the end.

use super::diagram::AT_INFINITY;

/// The levels of vertices.
pub(super) struct Levels {
    /// That of infinity, then those of the vertices.
    nodes: Vec<Node>,
}

/// A vertex in a forest, later at its root.
#[derive(Clone, Copy)]
struct Node {
    /// Itself if it is a root, else a node before it.
    parent: u32,
    /// How far it is above that.
    rise: i32,
}

impl Levels {
    /// Begins with nothing known about so many vertices.
    pub fn of(num_vertices: usize) -> Self {
        let nodes = 0..=num_vertices as u32;
        Self {
            nodes: nodes.map(|parent| Node { parent, rise: 0 }).collect(),
        }
    }

    /// Says that the level rises so much from one end of an edge to the other.
    #[inline]
    pub fn join(&mut self, ends: [u32; 2], rise: i32) {
        let [from, to] = ends.map(|v| self.root(node(v)));
        // How far the root of `to` is above that of `from`.
        let rise = rise + from.rise - to.rise;
        let [from, to] = [from, to].map(|node| node.parent);
        if from < to {
            self.nodes[to as usize] = Node { parent: from, rise };
        } else if to < from {
            let rise = -rise;
            self.nodes[from as usize] = Node { parent: to, rise };
        }
    }

    /// Returns the root of a node, and how far it is above that.
    #[inline]
    fn root(&mut self, mut at: usize) -> Node {
        let mut rise = 0;
        loop {
            let Node { parent, rise: step } = self.nodes[at];
            if parent as usize == at {
                return Node { parent, rise };
            }
            let above = self.nodes[parent as usize];
            self.nodes[at] = Node {
                parent: above.parent,
                rise: step + above.rise,
            };
            rise += step + above.rise;
            at = above.parent as usize;
        }
    }

    /// Finds the levels, once all edges have been joined.
    pub fn settle(&mut self) {
        for i in 1..self.nodes.len() {
            let Node { parent, rise } = self.nodes[i];
            if parent as usize != i {
                self.nodes[i].rise = rise + self.nodes[parent as usize].rise;
            }
        }
    }

    /// Returns the level of a vertex, or of infinity.
    #[inline]
    pub fn at(&self, vertex: u32) -> i32 {
        self.nodes[node(vertex)].rise
    }
}

#[inline]
fn node(vertex: u32) -> usize {
    // Infinity, the largest number, comes to be 0.
    const { assert!(AT_INFINITY == u32::MAX) };
    vertex.wrapping_add(1) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Vertices in a row whose edges are joined in an order that makes trees of many shapes.
    fn row(step: u32) -> Levels {
        const NUM: u32 = 97;
        let mut levels = Levels::of(NUM as usize);
        // Edge i leads from vertex i − 1, or from infinity, to vertex i, and rises by one if i is even.
        for i in (0..NUM).map(|k| k * step % NUM) {
            let rise = i32::from(i % 2 == 0);
            let ends = [i.wrapping_sub(1), i];
            match i % 3 {
                0 => levels.join(ends, rise),
                _ => levels.join([ends[1], ends[0]], -rise),
            }
        }
        levels.settle();
        levels
    }

    #[test]
    fn levels_add_up_along_any_order_of_edges() {
        for step in 1..97 {
            let levels = row(step);
            assert_eq!(levels.at(AT_INFINITY), 0);
            let found = (0..97).map(|v| levels.at(v));
            assert!(found.eq((0..97).map(|v| v / 2 + 1)), "{step}");
        }
    }

    #[test]
    fn edges_that_close_a_circle_change_nothing() {
        let mut levels = Levels::of(3);
        let edges = [
            ([0, 1], 1),
            ([1, 2], -1),
            ([2, 0], 0),
            ([2, AT_INFINITY], -2),
        ];
        for (ends, rise) in edges.into_iter().chain(edges) {
            levels.join(ends, rise);
        }
        levels.settle();
        assert_eq!([0, 1, 2].map(|v| levels.at(v)), [2, 3, 2]);
    }
}
