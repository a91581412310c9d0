//! `.ply`: Stanford's points, edges and faces, as scanners and programs for clouds of points write them.
//!
//! G. Turk, *The PLY Polygon File Format*, 1994. Read are text and bytes of either order, elements and properties in
//! any order and of any type, those not known passed over. Of `vertex`, `x` and `y` are the point, a `z` that is not
//! zero everywhere and every other number, colours too, are attributes, and an integer `marker` is one; of `face`,
//! `vertex_indices` or `vertex_index` are three corners, and other numbers are attributes of triangles; of `edge`,
//! `vertex1` and `vertex2` are the ends of a constrained edge, and `marker`, or that of the element `edge_marker`, is
//! its marker. Lists, but for those of
//! corners, have no place and are passed over. Triangle strips are refused.
//!
//! Written are the same, coordinates and attributes as doubles, in bytes with the least first, or as text; of
//! triangles also their `region` (−1 where there is none). Markers of edges are an element of their own: trimesh takes
//! edges of two numbers only. meshio reads no file that has more than vertices and the corners of faces.

/// The element that has the markers of edges, in their order.
const EDGE_MARKER: &str = "edge_marker";

mod body;
mod header;
mod read;
mod write;

pub(crate) use header::sniff;
pub(crate) use read::read_mesh;
pub(crate) use write::write;
