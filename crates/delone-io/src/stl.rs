//! `.stl`: stereolithography, triangles for printers; written only.
//!
//! 3D Systems, *StereoLithography Interface Specification* (1988), as everybody has it: 80 bytes that do not begin
//! with `solid`, the number of triangles, and for each its normal and its corners in single precision; or, as
//! [text](crate::WriteOptions::ascii), all of it in words, with doubles in full.
//!
//! z is the attribute of that name, or else 0. Bytes hold **single precision**: seven digits, so that metres beyond
//! a hundred kilometres keep no centimetres; take the text, or shift the mesh, if that matters. Vertices are not
//! shared, and markers, segments and other attributes have no place.

use crate::target::Output;
use crate::{Error, MeshView, WriteOptions};

/// Length of the header of bytes.
const HEADER: usize = 80;

/// Writes triangles.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    _markers: &[i32],
    options: &WriteOptions,
) -> Result<(), Error> {
    let solid = Solid::new(mesh)?;
    match options.ascii {
        true => write_text(out, &solid),
        false => write_bytes(out, &solid),
    }
}

/// Triangles in space.
struct Solid<'a> {
    mesh: &'a MeshView<'a>,
    z: Option<&'a [f64]>,
}

impl<'a> Solid<'a> {
    /// Looks for heights.
    ///
    /// # Errors
    /// If a height is missing.
    fn new(mesh: &'a MeshView<'a>) -> Result<Self, Error> {
        let z = mesh.attributes.iter().find(|a| a.name == "z");
        let z = z.map(|attribute| &attribute.values[..]);
        if let Some(v) = z.and_then(|z| z.iter().position(|z| !z.is_finite())) {
            let (p, z) = (mesh.points[v], z.map_or(0.0, |z| z[v]));
            return Err(Error::BadMesh(format!(
                "point {v} (numbered from 0) at ({}, {}) has z {z}: STL needs finite heights; remove it, or the attribute z",
                p.x, p.y
            )));
        }
        Ok(Self { mesh, z })
    }

    /// Visits the triangles as corners.
    fn triangles(&self) -> impl Iterator<Item = [[f64; 3]; 3]> + '_ {
        let corner = |v: delone::VertexId| {
            let p = self.mesh.points[v.index()];
            [p.x, p.y, self.z.map_or(0.0, |z| z[v.index()])]
        };
        self.mesh.triangles.iter().map(move |t| t.map(corner))
    }
}

/// Returns the normal of length 1, or 0 where there is none.
fn normal([a, b, c]: [[f64; 3]; 3]) -> [f64; 3] {
    // The direction alone counts: sides are brought to length 1, halved before, lest differences overflow.
    let along = |end: [f64; 3]| {
        let side = [0, 1, 2].map(|k| 0.5 * end[k] - 0.5 * a[k]);
        let largest = side.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
        side.map(|x| x / largest)
    };
    let ([ux, uy, uz], [vx, vy, vz]) = (along(b), along(c));
    let cross = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    match length > 0.0 {
        true => cross.map(|x| x / length),
        false => [0.0; 3],
    }
}

fn write_text(out: &mut Output<'_>, solid: &Solid<'_>) -> Result<(), Error> {
    out.text(format_args!("solid delone\n"))?;
    let vector = |out: &mut Output<'_>, name: &str, vector: [f64; 3]| {
        out.text(format_args!("{name}"))?;
        for x in vector {
            out.blank();
            // No zero needs a sign.
            out.number(x + 0.0);
        }
        out.text(format_args!("\n"))
    };
    for corners in solid.triangles() {
        vector(out, "facet normal", normal(corners))?;
        out.text(format_args!("outer loop\n"))?;
        for corner in corners {
            vector(out, "vertex", corner)?;
        }
        out.text(format_args!("endloop\nendfacet"))?;
        out.end_line()?;
    }
    out.text(format_args!("endsolid delone\n"))
}

fn write_bytes(out: &mut Output<'_>, solid: &Solid<'_>) -> Result<(), Error> {
    let count = solid.mesh.triangles.len();
    let Ok(count) = u32::try_from(count) else {
        return Err(Error::BadMesh(format!(
            "{count} triangles: STL counts in 32 bits; split the mesh"
        )));
    };
    let mut header = [b' '; HEADER];
    let title = b"binary STL of a triangulation, by Delone";
    header[..title.len()].copy_from_slice(title);
    out.bytes(&header)?;
    out.bytes(&count.to_le_bytes())?;
    for (t, corners) in solid.triangles().enumerate() {
        let single = |x: f64| x as f32 + 0.0;
        for vector in [normal(corners)].iter().chain(&corners) {
            let vector = vector.map(single);
            if !vector.iter().all(|x| x.is_finite()) {
                return Err(Error::BadMesh(format!(
                    "triangle {t} (numbered from 0) has a corner beyond single precision; write STL as text"
                )));
            }
            for x in vector {
                out.bytes(&x.to_le_bytes())?;
            }
        }
        out.bytes(&[0; 2])?;
        out.end_row()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::normal;

    #[test]
    fn normals_have_length_one_at_any_size() {
        for size in [1.0, 1e-300, 1e300, 3.5e154] {
            let flat = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]];
            assert_eq!(normal(flat), [0.0, 0.0, 1.0], "{size}");
            let slope = [[0.0; 3], [size, 0.0, size], [0.0, size, 0.0]];
            let [x, y, z] = normal(slope);
            assert!((x + 0.5f64.sqrt()).abs() < 1e-15 && y == 0.0 && (z + x).abs() < 1e-15);
        }
        assert_eq!(normal([[1.0; 3], [2.0; 3], [3.0; 3]]), [0.0; 3]);
    }
}
