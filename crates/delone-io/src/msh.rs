//! `.msh`: Gmsh's meshes, versions 2.2, 4.0 and 4.1, as text or bytes.
//!
//! C. Geuzaine, J.-F. Remacle, *Gmsh Reference Manual*, "Gmsh file formats", <https://gmsh.info/doc/texinfo/gmsh.html>.
//! Read are nodes, whatever their tags, and points, lines and triangles of three or six nodes; other elements
//! are refused. Vertices, triangles and lines come in the order of their tags. Physical groups of curves become
//! markers of constrained edges, those of points markers of vertices, and those of surfaces the attribute `region` of
//! triangles (−1 for none). A group that is named `marker 7` or `region 2`, as ours are, has that number, others their
//! tag. `$NodeData` and `$ElementData` become attributes, as do heights that are not zero everywhere. What is not kept
//! is [noted](crate::PointSet::notes): further names and groups, partitions, data of lines.
//!
//! Written is text: version 4.1, or 2.2 as `.msh2`; a curve for each marker, and one for the edges without; a surface
//! for each region, or else for each value of a whole-numbered attribute `region`; element *t* + 1 is triangle *t*, and
//! constrained edges come behind. Attributes go into `$NodeData` and `$ElementData`.
//!
//! *Cost*: O(n) for n nodes and elements; O(n log n) if tags are out of order.

mod assemble;
mod data;
mod elements;
mod entities;
mod groups;
mod nodes;
mod read;
mod write;

pub(crate) use read::read_mesh;
pub(crate) use write::{write_2, write_4};

/// Gmsh's numbers of elements.
const LINE: i64 = 1;
const TRIANGLE: i64 = 2;
const QUADRATIC_LINE: i64 = 8;
const QUADRATIC_TRIANGLE: i64 = 9;
const POINT: i64 = 15;

/// How names of groups begin that say a number, of curves and of surfaces.
const MARKER: &str = "marker ";
const REGION: &str = "region ";

/// The attribute that holds the regions of triangles, and its value for none.
const REGIONS: &str = "region";
const NO_REGION: f64 = -1.0;

/// The data of nodes that are markers of vertices.
const MARKERS: &str = "marker";

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    let head = head.trim_ascii_start();
    [&b"$MeshFormat"[..], b"$NOD", b"$Comments"]
        .iter()
        .any(|start| head.starts_with(start))
}
