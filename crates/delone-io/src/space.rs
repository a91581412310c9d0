//! The third coordinate, and other columns, of formats whose points lie in space.
//!
//! A z that is not zero everywhere is the attribute `z`, the first of all; one that is missing is written as 0.

use crate::{Attribute, MeshView};

/// Returns z of the vertices, if there is one.
pub(crate) fn heights<'a>(mesh: &MeshView<'a>) -> Option<&'a [f64]> {
    let z = mesh.attributes.iter().find(|a| is_height(a));
    z.map(|a| a.values.as_slice())
}

/// Visits the attributes of the vertices that are no coordinate.
pub(crate) fn others<'a>(mesh: &MeshView<'a>) -> impl Iterator<Item = &'a Attribute> + Clone {
    mesh.attributes.iter().filter(|a| !is_height(a))
}

/// Returns the number of the region of each triangle, if that is known: from the constraints, or from an attribute
/// `region` as it is read, where negative numbers mean none.
pub(crate) fn regions(mesh: &MeshView<'_>) -> Option<Vec<Option<i32>>> {
    if let Some(of) = mesh.constraints.and_then(|c| c.region_of.as_ref()) {
        return Some(of.iter().map(|r| r.map(|r| r as i32)).collect());
    }
    let read = mesh
        .triangle_attributes
        .iter()
        .find(|a| a.name == "region")?;
    let is_number = |&v: &f64| v.is_nan() || f64::from(v as i32) == v;
    let region = |&v: &f64| (v >= 0.0).then_some(v as i32);
    let all = read.values.iter();
    all.clone()
        .all(is_number)
        .then(|| all.map(region).collect())
}

fn is_height(attribute: &Attribute) -> bool {
    attribute.name == "z"
}

/// Columns of numbers that grow by rows, of which some may be shorter than others.
#[derive(Default)]
pub(crate) struct Columns {
    columns: Vec<Vec<f64>>,
    rows: usize,
}

impl Columns {
    /// Adds a row; what it lacks, and what the rows before it lacked, is NaN.
    ///
    /// The caller sees to it that no row is wide without reason: a column costs a number for each row.
    pub fn push(&mut self, values: impl IntoIterator<Item = f64>) {
        let mut filled = 0;
        for value in values {
            if filled == self.columns.len() {
                self.columns.push(vec![f64::NAN; self.rows]);
            }
            self.columns[filled].push(value);
            filled += 1;
        }
        for column in &mut self.columns[filled..] {
            column.push(f64::NAN);
        }
        self.rows += 1;
    }

    /// Makes attributes of them, with these names; a first column named `z` is left out if it is zero everywhere.
    pub fn into_attributes<'n>(self, names: impl IntoIterator<Item = &'n str>) -> Vec<Attribute> {
        let named = names.into_iter().zip(self.columns);
        let all = named.map(|(name, values)| Attribute {
            name: name.to_owned(),
            values,
        });
        all.filter(|a| !is_height(a) || a.values.iter().any(|&z| z != 0.0))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Columns;

    #[test]
    fn rows_of_different_width_leave_gaps() {
        let mut columns = Columns::default();
        columns.push([0.0]);
        columns.push([0.0, 5.0, 6.0]);
        columns.push([0.0, 7.0]);
        let made = columns.into_attributes(["z", "red", "green"]);
        let shown: Vec<_> = made
            .iter()
            .map(|a| (&*a.name, format!("{:?}", a.values)))
            .collect();
        assert_eq!(
            shown,
            [
                ("red", "[NaN, 5.0, 7.0]".to_owned()),
                ("green", "[NaN, 6.0, NaN]".to_owned())
            ]
        );
    }
}
