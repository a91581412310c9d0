//! Figures as people read them.

pub use delone_io::words::{count, counted, duration, list, measure};

use crate::voice;
use delone::Pslg;
use delone_io::{DomainData, PointSet};
use std::ffi::OsString;
use std::path::PathBuf;

/// Writes what a domain consists of: `9 points, 9 segments and 1 hole`.
pub fn domain(pslg: &Pslg) -> String {
    let mut parts = vec![counted(pslg.points.len(), "point", "points")];
    for (n, one, many) in [
        (pslg.segments.len(), "segment", "segments"),
        (pslg.polygons.len(), "polygon", "polygons"),
        (pslg.holes.len(), "hole", "holes"),
        (pslg.regions.len(), "region", "regions"),
    ] {
        if n > 0 {
            parts.push(counted(n, one, many));
        }
    }
    list(&parts)
}

/// Writes what was read: `628 points from (0, 0) to (12, 8), columns depth`.
pub fn points(set: &PointSet) -> String {
    let count = counted(set.points.len(), "point", "points");
    let corner = |take: fn(f64, f64) -> f64| {
        let x = set.points.iter().map(|p| p.x).reduce(take);
        x.zip(set.points.iter().map(|p| p.y).reduce(take))
    };
    let bounds = match (corner(f64::min), corner(f64::max)) {
        (Some((left, low)), Some((right, high))) => {
            format!(" from ({left}, {low}) to ({right}, {high})")
        }
        _ => String::new(),
    };
    let names: Vec<String> = set.attributes.iter().map(|a| a.name.clone()).collect();
    let columns = match names.is_empty() {
        true => String::new(),
        false => format!(", with {}", list(&names)),
    };
    format!("{count}{bounds}{columns}")
}

/// Writes what was read of a domain.
pub fn read(domain: &DomainData) -> String {
    let more = [
        (domain.segments.len(), "segment", "segments"),
        (domain.polygons.len(), "polygon", "polygons"),
        (domain.holes.len(), "hole", "holes"),
        (domain.regions.len(), "region", "regions"),
    ];
    let more = more.into_iter().filter(|(n, ..)| *n > 0);
    let more = more.map(|(n, one, many)| format!("; {}", counted(n, one, many)));
    points(&domain.vertices) + &more.collect::<String>()
}

/// Writes a number of bytes with three digits: `812 B`, `31.2 kB`, `3.41 GB`.
pub fn bytes(n: u64) -> String {
    let (value, unit) = match n as f64 {
        n if n >= 1e9 => (n / 1e9, "GB"),
        n if n >= 1e6 => (n / 1e6, "MB"),
        n if n >= 1e3 => (n / 1e3, "kB"),
        n => return format!("{n} B"),
    };
    let decimals = match value {
        v if v >= 100.0 => 0,
        v if v >= 10.0 => 1,
        _ => 2,
    };
    format!("{value:.decimals$} {unit}")
}

/// Says which files have been written, if any have been; with their sizes if that is wanted.
pub fn wrote(files: &[PathBuf]) -> Option<String> {
    (!files.is_empty()).then(|| format!("wrote {}", names(files)))
}

/// Tells people what was written to which files.
pub fn wrote_what(what: &str, files: &[PathBuf]) {
    voice::say(&format!("wrote {what} to {}", names(files)));
}

fn names(files: &[PathBuf]) -> String {
    let name = |path: &PathBuf| match path.metadata() {
        Ok(known) if voice::is_verbose() => format!("{} ({})", path.display(), bytes(known.len())),
        _ => path.display().to_string(),
    };
    list(&files.iter().map(name).collect::<Vec<_>>())
}

/// Returns the command that runs, as a shell would take it.
pub fn command_line() -> String {
    let arguments = std::env::args_os().skip(1);
    shell_line(&Vec::from_iter(
        std::iter::once("delone".into()).chain(arguments),
    ))
}

/// Returns a command as a shell would take it; the first argument is the program.
pub fn shell_line(arguments: &[OsString]) -> String {
    let words = arguments.iter().map(|a| quoted(&a.to_string_lossy()));
    words.collect::<Vec<_>>().join(" ")
}

/// Quotes a word if a shell would change it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "_-./=:,+%@".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::{bytes, quoted};

    #[test]
    fn sizes_have_three_digits() {
        let shown = [0, 812, 31_249, 3_410_000, 712_000_000, 9_990_000_000].map(bytes);
        let expected = ["0 B", "812 B", "31.2 kB", "3.41 MB", "712 MB", "9.99 GB"];
        assert_eq!(shown, expected.map(String::from));
    }

    #[test]
    fn words_are_quoted_where_a_shell_would_change_them() {
        let shown = ["a/ü.poly", "--max-edge=1e-3", "", "x*y", "it's"].map(quoted);
        let expected = ["a/ü.poly", "--max-edge=1e-3", "''", "'x*y'", "'it'\\''s'"];
        assert_eq!(shown, expected.map(String::from));
    }
}
