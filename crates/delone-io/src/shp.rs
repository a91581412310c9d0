//! `.shp`: shapefiles, points, lines and polygons of geographic information systems, read only.
//!
//! *ESRI Shapefile Technical Description*, 1998. Z and M become the attributes `z` and `m`; numbers below −10³⁸
//! are none. All rings of a record are one polygon. Records are read one behind the other, so the index `.shx` is
//! not needed. The table `.dbf` beside the file is read if it is there, see [`dbf`]; its deleted rows and null
//! shapes are skipped. Multipatches, surfaces in space, are refused. The `.prj` is not read: coordinates are
//! taken as those of the plane.

mod dbf;
mod read;

pub(crate) use read::read_domain;

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(&[0, 0, 0x27, 0x0a])
}
