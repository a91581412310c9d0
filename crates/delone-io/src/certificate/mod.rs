//! Certificates: what was proven about a mesh, and where each part of it comes from, in files of their own.
//!
//! A [`MeshCertificate`] names input and output by SHA-256 and by hashes that do not depend on order, says what
//! was asked and what was reached, and what the verifier has proven, by which arithmetic. It holds no time, no
//! number of threads and no folder: the same input and options give the same bytes. [`prove`] finds what it
//! says from the arrays alone, after writing a mesh as well as after reading one, so whoever has the files can
//! [compare](MeshCertificate::disagreements).
//!
//! A [`Lineage`] is a table: of each vertex, constrained edge and triangle the feature of the input that it comes
//! from.
//!
//! [`write_certified`] writes them with the mesh, all or none. The format is documented in
//! `docs/certificates.md`. Signatures are not made: the checksum at the end finds damage, no forger.

mod compare;
mod digest;
mod lineage;
mod prove;
mod schema;
mod write;

pub use digest::digest_file;
pub(crate) use digest::{Hashing, hex};
pub use lineage::{Along, Lineage, OfEdge, OfVertex, Within};
#[cfg(feature = "parquet")]
pub(crate) use lineage::{COLUMNS, ELEMENTS, ORIGINS, Row};
pub use prove::{Claim, Proof, ProveError, prove};
pub use schema::{
    AskedFor, FileFact, InputFacts, Maker, MeshCertificate, MeshFacts, Reached, RegionFacts,
    Stages, Tests, UnmetFact,
};
pub use write::{Papers, write_certified};
