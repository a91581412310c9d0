//! `.mesh`: Medit's ASCII format, for FreeFem, Mmg and the library of Inria's meshers.
//!
//! P. Frey, *MEDIT: an interactive mesh visualization software*, INRIA RT-0253 (2001), and the keywords of
//! libMeshb 7 (L. Maréchal): `MeshVersionFormatted`, `Dimension`, `Vertices`, `Edges`, `Triangles`, `EdgesP2`,
//! `TrianglesP2`. Everything is numbered from 1 and has a reference, a number: the marker of a vertex or constrained
//! edge, or the region of a triangle, from 1; 0 is none.
//!
//! Attributes, holes, and what regions are named by have no place; a domain with such is refused. The binary
//! `.meshb` is neither read nor written.

mod read;
mod write;

pub(crate) use read::{read_mesh, sniff};
pub(crate) use write::write;
