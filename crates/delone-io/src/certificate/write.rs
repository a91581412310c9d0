//! A mesh and its papers, written together.

use super::{Lineage, MeshCertificate};
#[cfg(feature = "parquet")]
use crate::parquet;
use crate::points::unsupported;
use crate::write::stage_mesh;
use crate::{Error, Format, MeshView, Target, WriteOptions};
use delone::Watch;
use std::path::{Path, PathBuf};

/// What is written besides a mesh.
#[derive(Clone, Copy, Default)]
pub struct Papers<'a> {
    /// The table of lineage: `.csv` or another extension of tables, or `.parquet`.
    pub lineage: Option<(&'a Path, &'a Lineage)>,
    /// The certificate, to which the hashes of all other files are added.
    pub certificate: Option<(&'a Path, &'a MeshCertificate)>,
}

/// Does what [`write_mesh`](crate::write_mesh()) does, and writes lineage and certificate with it: all files
/// appear, or none. The names of these are the last of those returned.
///
/// # Errors
/// Those of [`write_mesh`](crate::write_mesh()), and if lineage cannot be written in the format that is named.
///
/// *Cost*: hashing takes some 2 to 5 ns a byte on top of writing.
pub fn write_certified(
    targets: &[Target],
    mesh: &MeshView<'_>,
    options: &WriteOptions,
    papers: &Papers<'_>,
    watch: &dyn Watch,
) -> Result<Vec<PathBuf>, Error> {
    let extra = papers.lineage.map_or(0, |(_, lineage)| lineage.num_rows());
    let mut staging = stage_mesh(targets, mesh, options, extra as u64, true, watch)?;
    let output = staging.take_digests();
    if let Some((path, lineage)) = papers.lineage {
        let target = Target::from_arg(path, None);
        staging.write(Some(path), |out| match target.format()? {
            Format::Table => lineage.write(out, watch),
            #[cfg(feature = "parquet")]
            Format::Parquet => parquet::write_lineage(out, lineage),
            format => {
                let is_table = |format| matches!(format, Format::Table | Format::Parquet);
                Err(unsupported(&target, format, "hold lineage", is_table))
            }
        })?;
    }
    let lineage = staging.take_digests().pop();
    if let Some((path, certificate)) = papers.certificate {
        let sealed = certificate.clone().sealed(output, lineage);
        let text = serde_json::to_string_pretty(&sealed)
            .map_err(|error| Error::BadMesh(format!("the certificate: {error}")))?;
        staging.write(Some(path), |out| {
            out.many_bytes(text.as_bytes())?;
            out.end_line()
        })?;
    }
    staging.commit()
}
