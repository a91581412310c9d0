//! Graphs and figures that a Delaunay triangulation holds: spanning tree, tour, Gabriel graph, alpha shape.
