//! Writing: points, cells, their types, and fields of data.

use crate::target::Output;
use crate::vtu::{Cell, cell, regions};
use crate::{Attribute, Error, MeshView, WriteOptions};
use std::fmt;

/// Writes a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    options: &WriteOptions,
) -> Result<(), Error> {
    let (n, m) = (mesh.points.len(), mesh.triangles.len());
    let k = mesh.constraints.map_or(0, |c| c.edges.len());
    let corners: usize = (0..m + k).map(|i| cell(mesh, i).len + 1).sum();
    if n.max(corners) > i32::MAX as usize {
        let text = format!("{n} points and {corners} corners, too many for .vtk; write .vtu");
        return Err(Error::BadMesh(text));
    }
    let kind = if options.ascii { "ASCII" } else { "BINARY" };
    out.text(format_args!(
        "# vtk DataFile Version 3.0\ndelone\n{kind}\nDATASET UNSTRUCTURED_GRID\nPOINTS {n} double\n"
    ))?;
    let mut numbers = Numbers {
        out,
        is_text: options.ascii,
        is_first: true,
    };
    for p in mesh.points {
        [p.x, p.y, 0.0].into_iter().for_each(|c| numbers.double(c));
        numbers.end_row()?;
    }
    numbers.end(format_args!("CELLS {} {corners}\n", m + k))?;
    for i in 0..m + k {
        let Cell { len, nodes, .. } = cell(mesh, i);
        numbers.int(len as i32);
        nodes[..len]
            .iter()
            .for_each(|v| numbers.int(v.raw() as i32));
        numbers.end_row()?;
    }
    numbers.end(format_args!("CELL_TYPES {}\n", m + k))?;
    for i in 0..m + k {
        numbers.int(cell(mesh, i).kind.into());
        numbers.end_row()?;
    }
    numbers.end(format_args!(""))?;
    write_point_data(&mut numbers, mesh)?;
    write_cell_data(&mut numbers, mesh, markers)
}

fn write_point_data(numbers: &mut Numbers<'_, '_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let n = mesh.points.len();
    let arrays = mesh.attributes.len() + usize::from(mesh.markers.is_some());
    if arrays == 0 {
        return Ok(());
    }
    let head = format_args!("POINT_DATA {n}\nFIELD FieldData {arrays}\n");
    numbers.out.text(head)?;
    for attribute in mesh.attributes {
        numbers.attribute(attribute, 0)?;
    }
    match mesh.markers {
        Some(markers) => numbers.integers("marker", n, markers.iter().copied()),
        None => Ok(()),
    }
}

fn write_cell_data(
    numbers: &mut Numbers<'_, '_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
) -> Result<(), Error> {
    let (m, k) = (mesh.triangles.len(), markers.len());
    let regions = regions(mesh);
    let has_edges = mesh.constraints.is_some();
    let arrays =
        mesh.triangle_attributes.len() + usize::from(regions.is_some()) + usize::from(has_edges);
    if arrays == 0 || m + k == 0 {
        return Ok(());
    }
    let cells = m + k;
    let head = format_args!("CELL_DATA {cells}\nFIELD FieldData {arrays}\n");
    numbers.out.text(head)?;
    for attribute in mesh.triangle_attributes {
        numbers.attribute(attribute, k)?;
    }
    if let Some(regions) = regions {
        let all = regions.chain(std::iter::repeat_n(-1, k));
        numbers.integers("region", cells, all)?;
    }
    if has_edges {
        let all = std::iter::repeat_n(0, m).chain(markers.iter().copied());
        numbers.integers("marker", cells, all)?;
    }
    Ok(())
}

/// Writes numbers as text, or as bytes of which the highest comes first.
struct Numbers<'o, 'a> {
    out: &'o mut Output<'a>,
    is_text: bool,
    /// Whether the next number begins a row.
    is_first: bool,
}

impl Numbers<'_, '_> {
    fn int(&mut self, value: i32) {
        if self.is_text {
            self.set_apart();
            self.out.integer(value.into());
        } else {
            value
                .to_be_bytes()
                .into_iter()
                .for_each(|b| self.out.separator(b));
        }
    }

    fn double(&mut self, value: f64) {
        if self.is_text {
            self.set_apart();
            // VTK reads `nan`, not `NaN`.
            match value.is_nan() {
                true => b"nan".iter().for_each(|&b| self.out.separator(b)),
                false => self.out.number(value),
            }
        } else {
            value
                .to_be_bytes()
                .into_iter()
                .for_each(|b| self.out.separator(b));
        }
    }

    fn set_apart(&mut self) {
        if !std::mem::take(&mut self.is_first) {
            self.out.blank();
        }
    }

    fn end_row(&mut self) -> Result<(), Error> {
        self.is_first = true;
        match self.is_text {
            true => self.out.end_line(),
            false => self.out.end_row(),
        }
    }

    /// Ends an array, and writes what stands before the next.
    fn end(&mut self, next: fmt::Arguments<'_>) -> Result<(), Error> {
        if !self.is_text {
            self.out.separator(b'\n');
        }
        self.out.text(next)
    }

    /// Writes an array of doubles, with `further` values that are none.
    fn attribute(&mut self, attribute: &Attribute, further: usize) -> Result<(), Error> {
        let (name, len) = (Coded(&attribute.name), attribute.values.len() + further);
        self.out.text(format_args!("{name} 1 {len} double\n"))?;
        let values = attribute.values.iter().copied();
        for value in values.chain(std::iter::repeat_n(f64::NAN, further)) {
            self.double(value);
            self.end_row()?;
        }
        self.end(format_args!(""))
    }

    fn integers(
        &mut self,
        name: &str,
        len: usize,
        values: impl Iterator<Item = i32>,
    ) -> Result<(), Error> {
        self.out.text(format_args!("{name} 1 {len} int\n"))?;
        for value in values {
            self.int(value);
            self.end_row()?;
        }
        self.end(format_args!(""))
    }
}

/// A name in which blanks and the like are coded, as VTK does it.
struct Coded<'a>(&'a str);

impl fmt::Display for Coded<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            return f.write_str("data");
        }
        self.0.bytes().try_for_each(|b| match b {
            b'!'..=b'~' if b != b'%' && b != b'"' => write!(f, "{}", char::from(b)),
            b => write!(f, "%{b:02X}"),
        })
    }
}
