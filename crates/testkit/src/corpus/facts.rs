//! What the corpus' README states of its files, in exact numbers.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// How the segments of a file meet, after merging equal points and equal segments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Facts {
    /// Pairs of segments that cross in the interior of both.
    pub crossings: usize,
    /// Pairs of segments that share more than a point.
    pub overlaps: usize,
    /// Vertices in the interior of a segment, once for each such segment.
    pub on_segments: usize,
}

impl Facts {
    /// Tells that segments meet at shared ends only.
    pub fn is_clean(&self) -> bool {
        *self == Self::default()
    }
}

/// Reads the facts of every file that has some, by name.
///
/// # Panics
/// If there is no README.
pub fn facts(root: &Path) -> BTreeMap<String, Facts> {
    let readme = fs::read_to_string(root.join("README.md")).expect("a README");
    let (files, nasty) = readme.split_once("## nasty/").expect("a second table");
    let of = |table: &str, folder: &str, column: usize| {
        let rows = table.lines().filter_map(move |line| {
            let cells: Vec<_> = line.split('|').map(str::trim).collect();
            Some((cells.get(1)?.to_string(), parse(cells.get(column)?)?))
        });
        rows.map(|(name, facts)| (format!("{folder}{name}"), facts))
            .collect::<Vec<_>>()
    };
    let all = [of(files, "", 4), of(nasty, "nasty/", 3)];
    all.into_iter().flatten().collect()
}

/// Reads `clean`, `X6 O1 V3`, or a list like `1 repeated segs, 3 crossings`.
fn parse(cell: &str) -> Option<Facts> {
    let words: Vec<_> = cell.split(' ').collect();
    if let [x, o, v] = words[..]
        && let Some(crossings) = x.strip_prefix('X')
    {
        return Some(Facts {
            crossings: crossings.parse().ok()?,
            overlaps: o.strip_prefix('O')?.parse().ok()?,
            on_segments: v.strip_prefix('V')?.parse().ok()?,
        });
    }
    let crossings = match words[..] {
        [.., count, "crossings"] => count.parse().ok()?,
        ["clean"] | [.., "duplicate", "points"] | ["all", "collinear"] => 0,
        _ => return None,
    };
    Some(Facts {
        crossings,
        ..Facts::default()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn facts_are_read_in_both_notations() {
        let facts = |crossings, overlaps, on_segments| {
            Some(Facts {
                crossings,
                overlaps,
                on_segments,
            })
        };
        assert_eq!(parse("X6 O1 V3"), facts(6, 1, 3));
        assert_eq!(parse("clean"), facts(0, 0, 0));
        assert_eq!(parse("1 repeated segs, 4 crossings"), facts(4, 0, 0));
        assert_eq!(parse("1 duplicate points"), facts(0, 0, 0));
        assert_eq!(parse("29 pts, 29 segs"), None);
        assert_eq!(parse(""), None);
    }
}
