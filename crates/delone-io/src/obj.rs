//! `.obj`: Wavefront's points, lines and faces, as programs for modelling exchange them.
//!
//! *Object files*, appendix B1 of the manual of the Advanced Visualizer, version 4. Read are `v` with z, or with z
//! and a colour; `f`, `l` and `p` with any form of index (`v`, `v/vt`, `v//vn`, `v/vt/vn`), counted from the first
//! vertex or back from the last; lines that go on behind a backslash. Faces have three corners. A file whose only
//! face has more is an outline: its sides are constrained edges; beside other faces such a polygon is refused, for to
//! cut it into triangles is another program's business, or that of `delone triangulate`.
//!
//! Names become numbers, see [`groups`]: the triangle attribute `region`, and the markers of lines. Texture
//! coordinates, normals, materials, smoothing and display attributes are skipped; curves and surfaces of free form are
//! refused.
//!
//! Written are `v` with z (0 where there is none), triangles in a group `region_2` for each region, constrained edges
//! as `l` in a group `marker_7` for each marker, points that neither has as `p`.

mod groups;
mod read;
mod write;

pub(crate) use read::{read_mesh, sniff};
pub(crate) use write::write;

/// What stands before the number of a region in the name of a group, and before that of a marker.
const REGION: &str = "region_";
const MARKER: &str = "marker_";

/// The groups of triangles without region, of segments without markers, and of points.
const TRIANGLES: &str = "triangles";
const SEGMENTS: &str = "segments";
const POINTS: &str = "points";
