//! What can be done with each format.

use super::Format;

/// Readers: points; points with segments between them; points with triangles.
pub(super) const POINTS_IN: u32 = 1;
pub(super) const SEGMENTS_IN: u32 = 1 << 1;
pub(super) const MESH_IN: u32 = 1 << 2;

/// Writers of the same.
pub(super) const POINTS_OUT: u32 = 1 << 3;
pub(super) const SEGMENTS_OUT: u32 = 1 << 4;
pub(super) const MESH_OUT: u32 = 1 << 5;
/// Triangles of six nodes as such, or, in pictures and files of edges, as triangles.
pub(super) const QUADRATIC_OUT: u32 = 1 << 6;

/// Writers of results of queries, surfaces and runs.
pub(super) const CELLS_OUT: u32 = 1 << 7;
pub(super) const LINKS_OUT: u32 = 1 << 8;
pub(super) const RASTER_OUT: u32 = 1 << 9;
pub(super) const CONTOURS_OUT: u32 = 1 << 10;
pub(super) const REPORT_OUT: u32 = 1 << 11;
pub(super) const ANIMATION_OUT: u32 = 1 << 12;

const ALL_IN: u32 = POINTS_IN | SEGMENTS_IN | MESH_IN;
const ALL_OUT: u32 = POINTS_OUT | SEGMENTS_OUT | MESH_OUT;
const PICTURE: u32 = ALL_OUT
    | QUADRATIC_OUT
    | CELLS_OUT
    | LINKS_OUT
    | RASTER_OUT
    | CONTOURS_OUT
    | REPORT_OUT
    | ANIMATION_OUT;

/// Lists what can be done with a format, if this build has it.
pub(super) const fn of(format: Format) -> u32 {
    match format {
        Format::Node => POINTS_IN | MESH_IN | POINTS_OUT | MESH_OUT | QUADRATIC_OUT,
        Format::Ele => POINTS_IN | MESH_IN | MESH_OUT | QUADRATIC_OUT,
        Format::Edge | Format::Neigh => MESH_OUT | QUADRATIC_OUT,
        Format::Poly => POINTS_IN | SEGMENTS_IN | ALL_OUT | QUADRATIC_OUT,
        Format::Npy => POINTS_IN | MESH_IN | POINTS_OUT | MESH_OUT | LINKS_OUT | RASTER_OUT,
        Format::Table => POINTS_IN | POINTS_OUT | LINKS_OUT | RASTER_OUT,
        Format::Parquet => POINTS_IN | SEGMENTS_IN | MESH_IN | POINTS_OUT | MESH_OUT,
        Format::GeoJson => POINTS_IN | SEGMENTS_IN | ALL_OUT | CELLS_OUT | LINKS_OUT | CONTOURS_OUT,
        Format::Wkt | Format::Shp => POINTS_IN | SEGMENTS_IN,
        Format::Las => POINTS_IN,
        Format::Vtu => ALL_IN | ALL_OUT | QUADRATIC_OUT | CELLS_OUT,
        Format::Vtk | Format::Msh | Format::Msh2 => ALL_IN | ALL_OUT | QUADRATIC_OUT,
        Format::Jigsaw => ALL_IN,
        Format::Airfoil => POINTS_IN | SEGMENTS_IN,
        Format::Medit => ALL_IN | ALL_OUT | QUADRATIC_OUT,
        Format::Obj | Format::Ply => ALL_IN | ALL_OUT,
        Format::Off => POINTS_IN | MESH_IN | POINTS_OUT | MESH_OUT,
        Format::Stl => MESH_OUT,
        Format::Dxf => POINTS_IN | SEGMENTS_IN | ALL_OUT,
        Format::Tikz => ALL_OUT | QUADRATIC_OUT,
        Format::Svg => POINTS_IN | SEGMENTS_IN | PICTURE,
        Format::Png => PICTURE,
        Format::Gif => ANIMATION_OUT,
        Format::Html => REPORT_OUT,
    }
}
