//! `.geojson`: GeoJSON, points, lines and polygons of geography.
//!
//! RFC 7946. Any of its objects may be the whole file. Heights become the attribute `z`; of the
//! properties only `marker` is read, an integer for the segments of the feature. Empty and missing
//! geometries are skipped. Coordinates are taken as those of the plane. A polygon that is written keeps
//! the direction of its rings; a point has no properties. Arrays that are no objects are read as [coordinates](bare).

mod bare;
mod cells;
mod contours;
mod links;
mod marks;
mod object;
mod read;
mod tree;
mod write;

pub(crate) use cells::write_cells;
pub(crate) use contours::write_contours;
pub(crate) use links::write_links;
pub(crate) use marks::write_marks;
pub(crate) use read::{read_domain, sniff};
pub(crate) use write::{write_domain, write_mesh, write_points};
