//! Writing: the header, then rows of numbers, as bytes or text.

use crate::target::Output;
use crate::{Attribute, Error, MeshView, WriteOptions, space};
use std::collections::BTreeSet;

/// Writes a mesh, a domain (no triangles) or points (no constraints either); `markers` are those of the
/// constrained edges.
pub(crate) fn write(
    out: &mut Output<'_>,
    mesh: &MeshView<'_>,
    markers: &[i32],
    options: &WriteOptions,
) -> Result<(), Error> {
    let regions = region_of(mesh);
    let edges = mesh.constraints.map_or(&[][..], |c| &c.edges);
    let corner = match i32::try_from(mesh.points.len()) {
        Ok(_) => "int",
        Err(_) => "uint",
    };
    let format = if options.ascii {
        "ascii"
    } else {
        "binary_little_endian"
    };
    out.text(format_args!(
        "ply\nformat {format} 1.0\ncomment made by Delone\n"
    ))?;
    out.text(format_args!("element vertex {}\n", mesh.points.len()))?;
    let taken: &[&str] = if mesh.markers.is_some() {
        &["marker"]
    } else {
        &[]
    };
    doubles(out, ["x", "y", "z"], space::others(mesh), taken)?;
    if mesh.markers.is_some() {
        out.bytes(b"property int marker\n")?;
    }
    if !mesh.triangles.is_empty() {
        out.text(format_args!("element face {}\n", mesh.triangles.len()))?;
        out.text(format_args!(
            "property list uchar {corner} vertex_indices\n"
        ))?;
        let taken: &[&str] = if regions.is_some() {
            &["region", LIST]
        } else {
            &[LIST]
        };
        doubles(out, [], mesh.triangle_attributes.iter(), taken)?;
        if regions.is_some() {
            out.bytes(b"property int region\n")?;
        }
    }
    if !edges.is_empty() {
        out.text(format_args!("element edge {}\n", edges.len()))?;
        out.text(format_args!(
            "property {corner} vertex1\nproperty {corner} vertex2\n"
        ))?;
    }
    // A mesh marks its border by rule.
    let told = mesh.constraints.is_some_and(|c| c.markers.is_some()) || !mesh.triangles.is_empty();
    let markers = if told && !edges.is_empty() {
        markers
    } else {
        &[]
    };
    if !markers.is_empty() {
        let name = super::EDGE_MARKER;
        out.text(format_args!(
            "element {name} {}\nproperty int marker\n",
            markers.len()
        ))?;
    }
    out.bytes(b"end_header\n")?;

    let mut rows = Rows {
        out,
        is_text: options.ascii,
    };
    write_vertices(&mut rows, mesh)?;
    for (t, corners) in mesh.triangles.iter().enumerate() {
        rows.length(3)?;
        corners
            .iter()
            .try_for_each(|v| rows.integer(v.raw().into()))?;
        for attribute in mesh.triangle_attributes {
            rows.double(attribute.values[t])?;
        }
        if let Some(regions) = &regions {
            rows.integer(regions[t].into())?;
        }
        rows.end()?;
    }
    for ends in edges {
        ends.iter().try_for_each(|v| rows.integer(v.raw().into()))?;
        rows.end()?;
    }
    for &marker in markers {
        rows.integer(marker.into())?;
        rows.end()?;
    }
    Ok(())
}

/// The name of the list of corners.
const LIST: &str = "vertex_indices";

/// Returns the regions of triangles that no attribute tells, −1 where there is none.
fn region_of(mesh: &MeshView<'_>) -> Option<Vec<i32>> {
    let regions = mesh.constraints?.region_of.as_ref()?;
    Some(regions.iter().map(|r| r.map_or(-1, |r| r as i32)).collect())
}

fn write_vertices(rows: &mut Rows<'_, '_>, mesh: &MeshView<'_>) -> Result<(), Error> {
    let heights = space::heights(mesh);
    for (v, p) in mesh.points.iter().enumerate() {
        rows.double(p.x)?;
        rows.double(p.y)?;
        rows.double(heights.map_or(0.0, |z| z[v]))?;
        for attribute in space::others(mesh) {
            rows.double(attribute.values[v])?;
        }
        if let Some(markers) = mesh.markers {
            rows.integer(markers[v].into())?;
        }
        rows.end()?;
    }
    Ok(())
}

/// Declares doubles: first some of our own, then attributes, whose names become words of which none is there twice.
fn doubles<'a, const N: usize>(
    out: &mut Output<'_>,
    first: [&str; N],
    attributes: impl Iterator<Item = &'a Attribute>,
    taken: &[&str],
) -> Result<(), Error> {
    let mut names: BTreeSet<String> = first.iter().chain(taken).map(|&n| n.to_owned()).collect();
    for name in first {
        out.text(format_args!("property double {name}\n"))?;
    }
    for Attribute { name, .. } in attributes {
        let is_apart = |c: char| c.is_whitespace() || c.is_control() || c == '#';
        let mut word = name.replace(is_apart, "_");
        while word.is_empty() || names.contains(&word) {
            word.push('_');
        }
        out.text(format_args!("property double {word}\n"))?;
        names.insert(word);
    }
    Ok(())
}

/// Where rows go, and how.
struct Rows<'o, 'w> {
    out: &'o mut Output<'w>,
    is_text: bool,
}

impl Rows<'_, '_> {
    fn double(&mut self, value: f64) -> Result<(), Error> {
        if self.is_text {
            self.out.number(value);
            self.out.blank();
            return Ok(());
        }
        self.out.bytes(&value.to_le_bytes())
    }

    /// Writes an integer of 32 bits, signed or not.
    fn integer(&mut self, value: i64) -> Result<(), Error> {
        if self.is_text {
            self.out.integer(value);
            self.out.blank();
            return Ok(());
        }
        self.out.bytes(&(value as u32).to_le_bytes())
    }

    fn length(&mut self, length: u8) -> Result<(), Error> {
        if self.is_text {
            self.out.integer(length.into());
            self.out.blank();
            return Ok(());
        }
        self.out.bytes(&[length])
    }

    fn end(&mut self) -> Result<(), Error> {
        match self.is_text {
            true => self.out.end_line(),
            false => self.out.end_row(),
        }
    }
}
