//! Columns of numbers that come with points: which one is meant, and whether it is whole.

use crate::exit::Failure;
use crate::numbering::Numbering;
use delone_io::{Attribute, Column, LeftOut, PointSet};

/// Takes the column that the option `--name` asks for out of the data of some points: by name, or by its
/// number among those that are not coordinates. If none was asked for, that is the only one, or `z`.
pub fn take(
    points: &PointSet,
    asked: Option<&Column>,
    option: &str,
    numbering: &Numbering,
) -> Result<Attribute, Failure> {
    let attribute = find(points, asked, option, numbering)?;
    if let Some(i) = attribute.values.iter().position(|v| !v.is_finite()) {
        let what = match attribute.values[i] {
            v if v.is_nan() => "has no number",
            _ => "has an infinite value",
        };
        return Err(refused(i, what, &attribute.name, numbering));
    }
    Ok(attribute.clone())
}

/// Says what is wrong with a value, where, and what to do.
fn refused(point: usize, what: &str, column: &str, numbering: &Numbering) -> Failure {
    let [place, hint] = [&numbering.place(point), numbering.hint()];
    let number = point + numbering.base();
    Failure::BadInput(format!(
        "{place}: point {number} {what} in column {column:?}; repair it, or remove the point{hint}"
    ))
}

fn find<'a>(
    points: &'a PointSet,
    asked: Option<&Column>,
    option: &str,
    numbering: &Numbering,
) -> Result<&'a Attribute, Failure> {
    let (all, file) = (&points.attributes, numbering.file());
    if let Some(LeftOut { name, point, text }) = left_out(points, asked) {
        let what = format!("has {text:?}, which is no number,");
        return Err(refused(*point, &what, name, numbering));
    }
    if all.is_empty() {
        let left_out = match &points.left_out[..] {
            [] => String::new(),
            all => format!("; these hold no numbers: {}", places(all, numbering)),
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

/// Names columns that were left out, with what stands there instead of a number.
fn places(left_out: &[LeftOut], numbering: &Numbering) -> String {
    let place = |c: &LeftOut| match numbering.line(c.point) {
        Some(line) => format!("{} (line {line}: {:?})", c.name, c.text),
        None => c.name.clone(),
    };
    left_out.iter().map(place).collect::<Vec<_>>().join(", ")
}

/// Finds the column that was meant but holds something else than numbers: that of the name asked for; or,
/// without a name and without columns of numbers, the first that begins with numbers.
fn left_out<'a>(points: &'a PointSet, asked: Option<&Column>) -> Option<&'a LeftOut> {
    let mut all = points.left_out.iter();
    let Some(Column::Name(name)) = asked else {
        let is_bare = points.attributes.is_empty();
        return all.find(|c| is_bare && c.point > 0);
    };
    let is_number = named(&points.attributes, name).is_some();
    all.find(|c| !is_number && c.name.eq_ignore_ascii_case(name))
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
            let numbering = Numbering::of_points("f.csv", &set);
            let found = find(&set, column.as_ref(), "--value", &numbering);
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
        let points = PointSet {
            base: 1,
            ..points(&["h"])
        };
        let numbering = Numbering::of_points("f.csv", &points);
        let said = take(&points, None, "--value", &numbering).expect_err("NaN");
        let said = said.to_string();
        assert!(
            said.contains("point 2 has no number in column \"h\""),
            "{said}"
        );
    }
}
