//! Writing: header and counts, vertices, triangles.

use crate::target::Output;
use crate::{Error, MeshView, WriteOptions, space};

/// Writes a mesh, or points.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    _markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let (n, m) = (mesh.points.len(), mesh.triangles.len());
    out.text(format_args!("OFF\n{n} {m} 0\n"))?;
    let heights = space::heights(mesh);
    for (v, p) in mesh.points.iter().enumerate() {
        out.number(p.x);
        out.blank();
        out.number(p.y);
        out.blank();
        out.number(heights.map_or(0.0, |z| z[v]));
        out.end_line()?;
    }
    for corners in mesh.triangles {
        out.bytes(b"3")?;
        for v in corners {
            out.blank();
            out.integer(v.raw().into());
        }
        out.end_line()?;
    }
    Ok(())
}
