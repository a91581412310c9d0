//! `.parquet`: tables of columns, as pandas, Polars and DuckDB exchange them; also GeoParquet.
//!
//! *Apache Parquet format* 2, by the crate `parquet`; *GeoParquet* 1.1. Of a table of points, x and y are found as
//! in text tables; further columns of numbers and truth values become attributes, integers named `marker` markers.
//! Texts, dates, times and nested columns are left out, and named. A null is no number, which a coordinate must be.
//!
//! GeoParquet is recognised by its metadata, or by Parquet's own type of geometries. Points, lines, polygons and
//! collections are read as [well-known binary](crate::wkb), points also as columns x and y of a struct.
//!
//! A mesh is three tables: `m.parquet` with the corners `a`, `b`, `c` of triangles from 0, their `region` and
//! attributes; `m.points.parquet` with x, y, attributes and marker; `m.segments.parquet` with the ends `a`, `b` and
//! the `marker` of constrained edges. Numbers that are none are null. Written is Zstandard, in groups of a million
//! rows. A table of [lineage](crate::Lineage) has the same columns as in text.
//!
//! A small file may declare much: what the pages would take in memory is added up [before](guard) they are read.
//! Only gzip and the older LZ4 may still give more than a page declares, a thousand times their bytes at most.
//! Encrypted files, and data compressed with Brotli or LZO, are not read.

/// Tells whether the bytes begin like one.
pub(crate) fn sniff(head: &[u8]) -> bool {
    head.starts_with(b"PAR1")
}

#[cfg(feature = "parquet")]
mod columns;
#[cfg(feature = "parquet")]
mod file;
#[cfg(feature = "parquet")]
mod geo;
#[cfg(feature = "parquet")]
mod guard;
#[cfg(feature = "parquet")]
mod lineage;
#[cfg(feature = "parquet")]
mod read;
#[cfg(feature = "parquet")]
mod thrift;
#[cfg(feature = "parquet")]
mod write;
#[cfg(feature = "parquet")]
pub(crate) use lineage::{read_lineage, write_lineage};
#[cfg(feature = "parquet")]
pub(crate) use read::{read_domain, read_mesh};
#[cfg(feature = "parquet")]
pub(crate) use write::{write_points, write_segments, write_triangles};
