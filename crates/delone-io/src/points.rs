//! Point sets as files hold them, and how they are read.

#[cfg(feature = "las")]
use crate::las;
use crate::{Error, Format, Lines, Problem, Source, domain, mesh, node, npy, table};
use delone::{Point, Watch};
use std::fmt;
use std::str::FromStr;

/// Most columns that a file of points may have: far more than any has, and few enough that a broken
/// header cannot exhaust the memory.
pub(crate) const MAX_COLUMNS: usize = 4096;

/// Checks a number of columns, before anything is made for each of them.
pub(crate) fn check_columns(given: u64) -> Result<usize, Problem> {
    if given <= MAX_COLUMNS as u64 {
        return Ok(given as usize);
    }
    Err(Problem::TooMany {
        items: "columns",
        given,
        limit: MAX_COLUMNS as u64,
    })
}

/// A column of numbers that came with the points.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    /// Its name: from the file if it has names, otherwise `z`, `column4`, `attribute1` …
    pub name: String,
    /// One value for each point; NaN where the file has none.
    pub values: Vec<f64>,
}

/// Points with what the file says about each.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointSet {
    /// The points, in the order of the file; all coordinates are finite.
    pub points: Vec<Point>,
    /// Further columns of numbers.
    pub attributes: Vec<Attribute>,
    /// Boundary markers, if the file has them.
    pub markers: Option<Vec<i32>>,
    /// Number of the first point in the file, 0 or 1.
    pub base: u32,
    /// Columns that were left out because they hold something else than numbers.
    pub left_out: Vec<LeftOut>,
    /// What else there is to say about the file: what the reader left out, or had to decide.
    pub notes: Vec<String>,
    /// Where the points stand, if the file is a text with a line for each.
    pub lines: Lines,
}

/// A column that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LeftOut {
    /// Its name.
    pub name: String,
    /// The first point for which it holds no number.
    pub point: usize,
    /// What stands there, the beginning of it.
    pub text: String,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Column {
    /// By place, from 0.
    Index(usize),
    /// By name in the header; case does not matter.
    Name(String),
}

impl fmt::Display for Column {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Index(i) => write!(f, "{}", i + 1),
            Self::Name(name) => write!(f, "{name:?}"),
        }
    }
}

impl FromStr for Column {
    type Err = std::convert::Infallible;

    /// Takes a positive number as a place counted from 1, as `cut` and `awk` do, anything else as
    /// a name.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(match text.parse::<usize>() {
            Ok(place) if place > 0 => Self::Index(place - 1),
            _ => Self::Name(text.to_owned()),
        })
    }
}

/// Which returns of a laser's pulse are read.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Returns {
    /// Every one.
    #[default]
    All,
    /// The first of each pulse: tops of trees and roofs.
    First,
    /// The last of each pulse: the ground, mostly.
    Last,
    /// The only one of its pulse: open ground and roofs.
    Single,
}

/// How to read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadOptions {
    /// The format; `None` means by extension, then by content.
    pub format: Option<Format>,
    /// The columns of x and y in tables and arrays; `None` means by name (x and y, longitude and
    /// latitude, easting and northing), then the first two that hold numbers.
    pub columns: Option<[Column; 2]>,
    /// The classes of points that are read from point clouds; empty means all. 2 is ground. Points that are
    /// marked as withheld are never read.
    pub classes: Vec<u8>,
    /// The returns that are read from point clouds.
    pub returns: Returns,
    /// How far a curve may be from the lines that replace it, in the unit of the drawing; `None` means a
    /// thousandth of the larger side of the curve's box.
    pub flatness: Option<f64>,
    /// The layers that are read from drawings; empty means all.
    pub layers: Vec<String>,
}

/// Returns third coordinates as an attribute, unless all are zero; its name is not that of another.
pub(crate) fn heights(values: Vec<f64>, others: &[Attribute]) -> Option<Attribute> {
    let taken = others.iter().any(|a| a.name == "z");
    let name = if taken { "Points_2" } else { "z" }.to_owned();
    let is_flat = values.iter().all(|&z| z == 0.0);
    (!is_flat).then_some(Attribute { name, values })
}

/// Reads points with attributes and markers.
///
/// An `.ele` file stands for the `.node` file of the same stem.
///
/// # Errors
/// If the file cannot be read, is malformed (message with file and line), or the watch cancels.
///
/// *Cost*: time and memory proportional to the file.
pub fn read_points(
    source: &Source,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    #[cfg(feature = "las")]
    if las::is_one(source, options) {
        // Clouds may be larger than memory; what is read of them is not.
        return las::read_points(source, options, watch);
    }
    let bytes = source.load(watch)?;
    let format = resolve(source, &bytes, options, Format::reads_points)?;
    read_loaded(source, &bytes, format, options, watch)
}

/// Reads points from the content of a source, whose format is known.
pub(crate) fn read_loaded(
    source: &Source,
    bytes: &[u8],
    format: Format,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    let file = source.to_string();
    match format {
        Format::Node => node::read_points(&file, bytes, watch),
        Format::Ele => read_sibling(source, Format::Ele, "node", options, watch),
        Format::Npy => npy::read_points(&file, bytes, options.columns.as_ref(), watch),
        Format::Vtu | Format::Off => {
            mesh::read_loaded(source, bytes, format, options, watch).map(|mesh| mesh.vertices)
        }
        #[cfg(feature = "las")]
        Format::Las => las::read_loaded(&file, bytes, options, watch),
        Format::Table => table::read_points(&file, bytes, options.columns.as_ref(), watch),
        format if format.reads_segments() => {
            domain::read_loaded(source, bytes, format, options, watch).map(|d| d.vertices)
        }
        format => Err(unsupported(source, format, "be read", Format::reads_points)),
    }
}

/// Decides on the format: as asked for, by extension, by content.
pub(crate) fn resolve(
    source: &Source,
    bytes: &[u8],
    options: &ReadOptions,
    wanted: fn(Format) -> bool,
) -> Result<Format, Error> {
    options
        .format
        .or_else(|| Format::detect(source.path(), bytes))
        .ok_or_else(|| Error::UnknownFormat {
            file: source.to_string(),
            known: Format::names(wanted),
        })
}

pub(crate) fn unsupported(
    file: impl ToString,
    format: Format,
    action: &'static str,
    wanted: fn(Format) -> bool,
) -> Error {
    if let Some(feature) = format.feature()
        && !format.is_built()
    {
        return Error::NotBuilt {
            file: file.to_string(),
            format,
            feature,
        };
    }
    Error::Unsupported {
        file: file.to_string(),
        format,
        action,
        instead: Format::names(wanted),
    }
}

/// Reads the points that stand beside `source` in the file of the same stem with another
/// `extension`.
pub(crate) fn read_sibling(
    source: &Source,
    format: Format,
    extension: &str,
    options: &ReadOptions,
    watch: &dyn Watch,
) -> Result<PointSet, Error> {
    // Standard input and a single file in memory have no neighbours.
    let alone = || {
        let action = "be read without the files beside it";
        let wanted = |f| matches!(f, Format::Vtu | Format::Node);
        unsupported(source, format, action, wanted)
    };
    let sibling = source.beside(extension, alone)?;
    let options = ReadOptions {
        format: None,
        ..options.clone()
    };
    let points = read_points(&sibling, &options, watch)?;
    // Lines of another file.
    let lines = Lines::default();
    Ok(PointSet { lines, ..points })
}
