//! Writing: the extension of the file says what sets cells apart.

use crate::target::Output;
use crate::{Error, Links, PointSet};
use std::borrow::Cow;
use std::path::Path;

/// What sets the cells apart that are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Separator {
    Comma,
    Tab,
    /// Names stand in a comment: readers of such files expect nothing but numbers.
    Blank,
}

impl Separator {
    /// Returns what readers of files with this extension expect.
    fn of(path: Option<&Path>) -> Self {
        let extension = path.and_then(Path::extension).unwrap_or_default();
        match extension.to_ascii_lowercase().to_str() {
            Some("tsv" | "tab") => Self::Tab,
            Some("xyz" | "xy" | "pts" | "txt" | "dat" | "asc") => Self::Blank,
            _ => Self::Comma,
        }
    }

    fn byte(self) -> u8 {
        match self {
            Self::Comma => b',',
            Self::Tab => b'\t',
            Self::Blank => b' ',
        }
    }

    /// Returns what stands before the names.
    fn begin(self) -> &'static str {
        match self {
            Self::Comma | Self::Tab => "",
            Self::Blank => "# ",
        }
    }
}

/// Writes points behind a header.
pub(crate) fn write_points(
    out: &mut Output<'_>,
    path: Option<&Path>,
    set: &PointSet,
) -> Result<(), Error> {
    let separator = Separator::of(path);
    write_names(out, separator, set)?;
    for (i, p) in set.points.iter().enumerate() {
        out.number(p.x);
        out.separator(separator.byte());
        out.number(p.y);
        for attribute in &set.attributes {
            out.separator(separator.byte());
            write_value(out, separator, attribute.values[i]);
        }
        if let Some(markers) = &set.markers {
            out.separator(separator.byte());
            out.integer(markers[i].into());
        }
        out.end_line()?;
    }
    Ok(())
}

/// Writes a number; where there is none, the cell is empty, unless blanks set cells apart.
fn write_value(out: &mut Output<'_>, separator: Separator, value: f64) {
    if !value.is_nan() || separator == Separator::Blank {
        out.number(value);
    }
}

/// Writes links behind a header.
pub(crate) fn write_links(
    out: &mut Output<'_>,
    path: Option<&Path>,
    links: &Links<'_>,
) -> Result<(), Error> {
    let separator = Separator::of(path);
    let [from, to, length] = links.names.map(quoted);
    let (begin, between) = (separator.begin(), char::from(separator.byte()));
    out.text(format_args!("{begin}{from}{between}{to}{between}{length}"))?;
    out.end_line()?;
    for link in links.links {
        for number in links.numbers(link) {
            out.integer(number as i64);
            out.separator(separator.byte());
        }
        out.number(link.length);
        out.end_line()?;
    }
    Ok(())
}

fn write_names(out: &mut Output<'_>, separator: Separator, set: &PointSet) -> Result<(), Error> {
    let between = char::from(separator.byte());
    let begin = separator.begin();
    out.text(format_args!("{begin}x{between}y"))?;
    let names = set.attributes.iter().map(|a| a.name.as_str());
    for name in names.chain(set.markers.as_ref().map(|_| "marker")) {
        out.text(format_args!("{between}{}", quoted(name)))?;
    }
    out.end_line()
}

fn quoted(name: &str) -> Cow<'_, str> {
    // A line end within quotes would not be read back.
    let name = name.replace(['\n', '\r'], " ");
    if name.contains([',', '"', ';', '\t', '#']) {
        return Cow::Owned(format!("\"{}\"", name.replace('"', "\"\"")));
    }
    Cow::Owned(name)
}
