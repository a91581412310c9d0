//! Writing: triangles as faces, constrained edges as lines, whatever neither shows as points.
//!
//! Layers are `TRIANGLES`, `TRIANGLES_2` and so on by region (the first has number 1), `SEGMENTS_7` by the
//! marker of the edge, and `POINTS`. The attribute `z`, if there is one, is the third coordinate; others, and
//! holes, have no place.

use crate::target::Output;
use crate::{Error, MeshView, WriteOptions};
use delone::VertexId;
use std::collections::BTreeSet;

/// Writes a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    _options: &WriteOptions,
) -> Result<(), Error> {
    let z = mesh
        .attributes
        .iter()
        .find(|a| a.name.eq_ignore_ascii_case("z"));
    let mut sheet = Sheet {
        out,
        mesh,
        markers,
        z: z.map(|attribute| &attribute.values[..]),
    };
    sheet.tables()?;
    sheet.out.text(format_args!("0\nSECTION\n2\nENTITIES\n"))?;
    for t in 0..mesh.triangles.len() {
        sheet.triangle(t)?;
    }
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    for (e, &ends) in edges.iter().enumerate() {
        sheet.line(e, ends)?;
    }
    sheet.loose_points()?;
    sheet.out.text(format_args!("0\nENDSEC\n0\nEOF\n"))
}

struct Sheet<'o, 'w, 'm> {
    out: &'o mut Output<'w>,
    mesh: &'m MeshView<'m>,
    markers: &'m [i32],
    z: Option<&'m [f64]>,
}

impl Sheet<'_, '_, '_> {
    /// Writes the header and the layers.
    fn tables(&mut self) -> Result<(), Error> {
        let mesh = self.mesh;
        let regions: BTreeSet<_> = (0..mesh.triangles.len()).map(|t| self.region(t)).collect();
        let markers: BTreeSet<_> = self.markers.iter().copied().collect();
        let faces = regions
            .into_iter()
            .map(|region| of_region(region).to_string());
        let lines = markers
            .into_iter()
            .map(|marker| format!("SEGMENTS_{marker}"));
        let layers: Vec<_> = faces.chain(lines).chain(["POINTS".to_owned()]).collect();
        self.out.text(format_args!(
            "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n0\nENDSEC\n\
             0\nSECTION\n2\nTABLES\n\
             0\nTABLE\n2\nLTYPE\n70\n1\n\
             0\nLTYPE\n2\nCONTINUOUS\n70\n0\n3\nSolid line\n72\n65\n73\n0\n40\n0.0\n\
             0\nENDTAB\n0\nTABLE\n2\nLAYER\n70\n{}\n",
            layers.len()
        ))?;
        for (i, layer) in layers.iter().enumerate() {
            // The first colours differ well; 7 is black or white.
            let color = i % 7 + 1;
            self.out.text(format_args!(
                "0\nLAYER\n2\n{layer}\n70\n0\n62\n{color}\n6\nCONTINUOUS\n"
            ))?;
        }
        self.out.text(format_args!("0\nENDTAB\n0\nENDSEC\n"))
    }

    /// Returns the number of the region of a triangle, from 1; those of none are in the first.
    fn region(&self, t: usize) -> u32 {
        let regions = self.mesh.constraints.and_then(|c| c.region_of.as_ref());
        regions
            .and_then(|regions| regions[t])
            .map_or(1, |region| region + 1)
    }

    fn triangle(&mut self, t: usize) -> Result<(), Error> {
        let [a, b, c] = self.mesh.triangles[t];
        let region = self.region(t);
        self.out
            .text(format_args!("0\n3DFACE\n8\n{}\n", of_region(region)))?;
        // The fourth corner of a triangle is the third.
        for (k, v) in [a, b, c, c].into_iter().enumerate() {
            self.place(10 + k, v);
        }
        self.out.end_row()
    }

    fn line(&mut self, e: usize, ends: [VertexId; 2]) -> Result<(), Error> {
        let marker = self.markers.get(e).copied().unwrap_or(0);
        self.out
            .text(format_args!("0\nLINE\n8\nSEGMENTS_{marker}\n"))?;
        for (k, v) in ends.into_iter().enumerate() {
            self.place(10 + k, v);
        }
        self.out.end_row()
    }

    /// Writes the points that no face or line shows.
    fn loose_points(&mut self) -> Result<(), Error> {
        let mesh = self.mesh;
        let mut is_shown = vec![false; mesh.points.len()];
        let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
        let ends = edges.iter().flatten();
        for v in mesh.triangles.iter().flatten().chain(ends) {
            is_shown[v.index()] = true;
        }
        for v in (0..mesh.points.len()).filter(|&v| !is_shown[v]) {
            self.out.text(format_args!("0\nPOINT\n8\nPOINTS\n"))?;
            self.place(10, VertexId::new(v));
            self.out.end_row()?;
        }
        Ok(())
    }

    /// Writes a place, of groups `code`, `code + 10` and `code + 20`.
    fn place(&mut self, code: usize, v: VertexId) {
        let point = self.mesh.points[v.index()];
        let z = self.z.map_or(0.0, |z| z[v.index()]);
        let z = if z.is_finite() { z } else { 0.0 };
        for (k, value) in [point.x, point.y, z].into_iter().enumerate() {
            self.out.integer((code + 10 * k) as i64);
            self.out.separator(b'\n');
            self.out.number(value);
            self.out.separator(b'\n');
        }
    }
}

/// Names the layer of a region.
fn of_region(region: u32) -> impl std::fmt::Display {
    std::fmt::from_fn(move |f| match region {
        1 => f.write_str("TRIANGLES"),
        region => write!(f, "TRIANGLES_{region}"),
    })
}
