//! Geometries with a table of columns, a row for each: how shapefiles and GeoParquet become a domain.
//!
//! Columns of numbers become attributes of the points of their features, if there are points and lines only (the
//! heights of contour lines, the depths of soundings; of long lines the first 64 columns). Numbers of polygons are not those of points, so these
//! columns are left out, and named. Segments get the integers of the column `marker`; without it, those of `id`,
//! `fid`, `gid` or `objectid`, if every feature has one; otherwise the numbers of their features, from 1.

use crate::shapes::Shapes;
use crate::{Attribute, DomainData, Error, LeftOut, cancel};
use delone::Watch;

/// Columns that number features, in the order of preference.
const NUMBERINGS: [&str; 4] = ["id", "fid", "gid", "objectid"];

/// Most columns of numbers that are repeated for each point of a line: what a byte of the table becomes in memory
/// is bounded thereby.
const MAX_SPREAD: usize = 64;

/// What a column of markers is called.
pub(crate) const MARKER: &str = "marker";

/// The columns of the table.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    /// Those of numbers, one for each feature, NaN where there is none.
    pub numbers: Vec<Attribute>,
    /// The others; for each the first feature for which it holds no number, and what stands there.
    pub left_out: Vec<LeftOut>,
}

/// A domain in the making, feature by feature.
pub(crate) struct Features {
    pub shapes: Shapes,
    columns: Columns,
    /// Which column has the markers.
    marking: Option<usize>,
    /// For each feature the number of points up to its end.
    ends: Vec<usize>,
}

impl Features {
    /// Begins with the columns of all features.
    pub fn new(columns: Columns) -> Self {
        Self {
            marking: marking(&columns.numbers),
            shapes: Shapes::default(),
            columns,
            ends: Vec::new(),
        }
    }

    /// Ends a feature.
    pub fn end(&mut self) {
        let value = |column: usize| self.columns.numbers[column].values.get(self.ends.len());
        let marker = self.marking.and_then(value).and_then(|&v| as_marker(v));
        self.shapes.end_feature(marker);
        self.ends.push(self.shapes.num_points());
    }

    /// Makes the domain.
    ///
    /// *Errors*: if the watch cancels.
    pub fn finish(self, watch: &dyn Watch) -> Result<DomainData, Error> {
        let Self {
            shapes,
            columns,
            marking,
            ends,
        } = self;
        let mut domain = shapes.finish();
        let has_polygons = !domain.polygons.is_empty();
        let has_segments = !domain.segments.is_empty();
        let is_spread = domain.vertices.points.len() > 2 * ends.len();
        let set = &mut domain.vertices;
        set.left_out = columns.left_out;
        for left_out in &mut set.left_out {
            let before = left_out.point.checked_sub(1).and_then(|f| ends.get(f));
            left_out.point = before.copied().unwrap_or(0);
        }
        for (column, Attribute { name, values }) in columns.numbers.into_iter().enumerate() {
            let is_marker = marking == Some(column) && name.eq_ignore_ascii_case(MARKER);
            if is_marker && has_segments {
                continue;
            }
            if has_polygons || is_spread && column >= MAX_SPREAD {
                let text = values.first().map_or_else(String::new, f64::to_string);
                let point = 0;
                set.left_out.push(LeftOut { name, point, text });
                continue;
            }
            let values = spread(&values, &ends, watch)?;
            let whole = || values.iter().map(|&v| as_marker(v)).collect();
            match is_marker.then(whole).flatten() {
                Some(markers) => set.markers = Some(markers),
                None => set.attributes.push(Attribute { name, values }),
            }
        }
        Ok(domain)
    }
}

/// Gives the points of each feature its value.
fn spread(values: &[f64], ends: &[usize], watch: &dyn Watch) -> Result<Vec<f64>, Error> {
    let mut spread = Vec::with_capacity(ends.last().copied().unwrap_or(0));
    for (feature, &end) in ends.iter().enumerate() {
        cancel::check(watch, feature)?;
        spread.resize(end, values.get(feature).copied().unwrap_or(f64::NAN));
    }
    Ok(spread)
}

/// Finds the column of markers.
fn marking(numbers: &[Attribute]) -> Option<usize> {
    let find = |name: &str| {
        let is_it = |column: &Attribute| column.name.eq_ignore_ascii_case(name);
        numbers.iter().position(is_it)
    };
    let is_whole = |&column: &usize| {
        numbers[column]
            .values
            .iter()
            .all(|&v| as_marker(v).is_some())
    };
    let mut numberings = NUMBERINGS.iter().filter_map(|name| find(name));
    find(MARKER).or_else(|| numberings.find(is_whole))
}

/// Takes a number as a marker, if it is one.
pub(crate) fn as_marker(value: f64) -> Option<i32> {
    let marker = value as i32;
    (f64::from(marker) == value).then_some(marker)
}
