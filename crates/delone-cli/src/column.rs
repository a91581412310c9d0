//! Columns of numbers that come with points: which one is meant, and whether it is whole.

use crate::exit::Failure;
use crate::numbering::Numbering;
use delone_io::{Attribute, Column, PointSet};

/// Takes the column that the option `--name` asks for out of the data of some points: by name, or by its
/// number among those that are not coordinates. If none was asked for, that is the only one, or `z`.
pub fn take(
    points: &PointSet,
    asked: Option<&Column>,
    option: &str,
    numbering: &Numbering,
) -> Result<Attribute, Failure> {
    let attribute = find(points, asked, option, numbering.file())?;
    if let Some(i) = attribute.values.iter().position(|v| !v.is_finite()) {
        let [file, name, hint] = [numbering.file(), &attribute.name, numbering.hint()];
        let number = i + numbering.base();
        return Err(Failure::BadInput(format!(
            "{file}: point {number} has no number in column {name:?}; add it, or remove the point{hint}"
        )));
    }
    Ok(attribute.clone())
}

fn find<'a>(
    points: &'a PointSet,
    asked: Option<&Column>,
    option: &str,
    file: &str,
) -> Result<&'a Attribute, Failure> {
    let all = &points.attributes;
    if all.is_empty() {
        let left_out = match &points.left_out[..] {
            [] => String::new(),
            names => format!("; these hold no numbers: {}", names.join(", ")),
        };
        return Err(Failure::BadInput(format!(
            "{file}: there is no column of numbers besides the coordinates; add one{left_out}"
        )));
    }
    let found = match (asked, &all[..]) {
        (Some(Column::Index(place)), _) => all.get(*place),
        (Some(Column::Name(name)), _) => named(all, name),
        (None, [only]) => Some(only),
        (None, _) => named(all, "z"),
    };
    found.ok_or_else(|| {
        let problem = match asked {
            Some(column) => format!("there is no column {column} of numbers"),
            None => "several columns may be meant".to_owned(),
        };
        let names: Vec<&str> = all.iter().map(|a| a.name.as_str()).collect();
        let names = names.join(", ");
        Failure::Usage(format!(
            "{file}: {problem}; choose one of these with {option}: {names}"
        ))
    })
}

/// Finds a column of this name; if there is none, one of which only the case differs.
fn named<'a>(all: &'a [Attribute], name: &str) -> Option<&'a Attribute> {
    let exact = all.iter().find(|a| a.name == name);
    exact.or_else(|| all.iter().find(|a| a.name.eq_ignore_ascii_case(name)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use delone::Point;

    fn points(names: &[&str]) -> PointSet {
        PointSet {
            points: vec![Point::new(0.0, 0.0); 2],
            attributes: names
                .iter()
                .map(|name| Attribute {
                    name: (*name).to_owned(),
                    values: vec![1.0, f64::NAN],
                })
                .collect(),
            ..PointSet::default()
        }
    }

    #[test]
    fn columns_are_found_by_name_number_or_for_want_of_others() {
        let found = |names: &[&str], asked: Option<&str>| {
            let column = asked.map(|text| text.parse().expect("infallible"));
            let set = points(names);
            let found = find(&set, column.as_ref(), "--value", "f.csv");
            found.map(|a| a.name.clone()).ok()
        };
        assert_eq!(found(&["h"], None).as_deref(), Some("h"));
        assert_eq!(found(&["h", "Z"], None).as_deref(), Some("Z"));
        assert_eq!(found(&["h", "k"], None), None);
        assert_eq!(found(&["h", "H"], Some("H")).as_deref(), Some("H"));
        assert_eq!(found(&["h", "k"], Some("K")).as_deref(), Some("k"));
        assert_eq!(found(&["h", "k"], Some("2")).as_deref(), Some("k"));
        assert_eq!(found(&["h", "k"], Some("3")), None);
        assert_eq!(found(&[], None), None);
    }

    #[test]
    fn what_is_missing_is_named() {
        let numbering = Numbering::from_base("f.csv", 1);
        let said = take(&points(&["h"]), None, "--value", &numbering).expect_err("NaN");
        let said = said.to_string();
        assert!(
            said.contains("point 2 has no number in column \"h\""),
            "{said}"
        );
    }
}
