//! `.las` and `.laz`: point clouds of laser scanners, read only.
//!
//! ASPRS, *LAS Specification 1.4 – R15* (2019), with all versions from 1.0 on and point formats 0 to 10; LAZ as
//! M. Isenburg, *LASzip: lossless compression of LiDAR data* (2013), decompressed by the crate `laz`. Headers and
//! records are read here, so that no number that a file declares is trusted.
//!
//! A file is read in blocks, never as a whole: of a cloud beyond memory, the ground may well fit. Points can be
//! chosen by [class](crate::ReadOptions::classes) and [return](crate::ReadOptions::returns); those that are marked
//! as *withheld*, which the specification has as deleted, are always dropped.
//!
//! A file holds integers, and for each axis a scale and an offset; a coordinate is the double nearest to
//! `integer · scale + offset`, where scale and offset are the shortest decimals that name them, see [`decimal`](crate::decimal). So
//! a cloud has the points that its export as text has.
//!
//! Attributes are `z` and `classification`, and, unless they are the same for all points, `intensity`,
//! `return_number` and `number_of_returns`. Times, colours, angles, sources, waveforms, extra bytes and the
//! reference system are not read.
//!
//! *Cost*: some 40 ns a point of LAS, 250 of LAZ; memory is proportional to the points that are kept.

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(b"LASF")
}

#[cfg(feature = "las")]
mod cloud;
#[cfg(feature = "las")]
mod header;
#[cfg(feature = "las")]
mod laz;
#[cfg(feature = "las")]
mod read;
#[cfg(feature = "las")]
pub(crate) use read::{is_one, read_loaded, read_points};
